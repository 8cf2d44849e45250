/** What this browser remembers; nothing where it must not. */
export const memory = {
  get(name) {
    try { return localStorage.getItem(`day6.${name}`); } catch { return null; }
  },
  /** null is to forget it. */
  set(name, value) {
    try {
      if (value === null) localStorage.removeItem(`day6.${name}`);
      else localStorage.setItem(`day6.${name}`, value);
    } catch { /* private browsing: forgotten with the tab */ }
  },
};
