/** A link that was opened in the desktop: a new tab, or, where the browser lets none be opened without a click here, words to click. */

/** Whether a browser opens a page by this, and no script. */
export function isLink(text) {
  try {
    const url = new URL(text);
    return ["http:", "https:"].includes(url.protocol) && !url.username && !url.password;
  } catch {
    return false;
  }
}

export class PageLink {
  /** `place` has room for one line; `refocus()` gives the keys back to the terminal. */
  constructor(place, refocus) {
    this._place = place;
    this._link = place.querySelector("a");
    const done = () => {
      place.hidden = true;
      refocus();
    };
    this._link.addEventListener("click", () => setTimeout(done));
    place.querySelector("button").addEventListener("click", done);
  }

  /** Open it as the answer to the key or click that came just now. */
  open(text) {
    if (!isLink(text)) return;
    const opened = window.open(text, "_blank");
    if (opened) {
      opened.opener = null;
      this._place.hidden = true;
      return;
    }
    this._link.href = text;
    this._link.textContent = text;
    this._place.hidden = false;
    this._link.focus();
  }
}
