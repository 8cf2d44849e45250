/** The bytes of keys that a browser or a phone has no way to press, and which keys stay with the browser. */

const CURSOR = { up: "A", down: "B", right: "C", left: "D", home: "H", end: "F" };
const TILDE = { insert: 2, delete: 3, pageup: 5, pagedown: 6, f5: 15, f6: 17, f7: 18, f8: 19, f9: 20, f10: 21, f11: 23, f12: 24 };
const SS3 = { f1: "P", f2: "Q", f3: "R", f4: "S" };
const PLAIN = { esc: "\x1b", tab: "\t", enter: "\r", backspace: "\x7f" };

/** What an xterm sends for a named key or one character; `applicationCursor` is the mode DECCKM. */
export function bytesOf(name, { ctrl = false, alt = false, applicationCursor = false } = {}) {
  const modifier = 1 + (alt ? 2 : 0) + (ctrl ? 4 : 0);
  if (name in CURSOR) {
    if (modifier > 1) return `\x1b[1;${modifier}${CURSOR[name]}`;
    return (applicationCursor ? "\x1bO" : "\x1b[") + CURSOR[name];
  }
  if (name in SS3) return modifier > 1 ? `\x1b[1;${modifier}${SS3[name]}` : `\x1bO${SS3[name]}`;
  if (name in TILDE) return modifier > 1 ? `\x1b[${TILDE[name]};${modifier}~` : `\x1b[${TILDE[name]}~`;
  const text = name in PLAIN ? PLAIN[name] : ctrl ? control(name) : name;
  return alt ? `\x1b${text}` : text;
}

/** A character with Ctrl held; itself where there is no such control character. */
export function control(char) {
  if (char === " ") return "\0";
  if (char === "?") return "\x7f";
  const code = char.toUpperCase().charCodeAt(0);
  return char.length === 1 && code >= 64 && code < 96 ? String.fromCharCode(code & 31) : char;
}

/** What a press means to the page: "copy", "paste", "tools", "browser", text to send, or null: the terminal's own business. */
export function meaning(event) {
  const { key, ctrlKey, shiftKey, altKey, metaKey } = event;
  const letter = key.toLowerCase();
  const only = (ctrl, shift) => ctrlKey === ctrl && shiftKey === shift && !altKey && !metaKey;
  if (only(true, true) && letter === "c") return "copy";
  if (only(true, true) && letter === "k") return "tools";
  if (only(true, true) && letter === "f") return { text: "\x1b[102;6u" }; // find, which has no byte of its own
  if ((only(true, true) || only(true, false)) && letter === "v") return "paste";
  if (only(false, true) && key === "Insert") return "paste";
  if (only(true, false) && key === "Insert") return "copy";
  if (key === "F11" || key === "F12") return "browser";
  if (ctrlKey && !altKey && ["+", "-", "=", "0"].includes(key)) return "browser"; // zoom
  if (metaKey) return "browser"; // Cmd+C, Cmd+V, Cmd+T on a Mac
  return null;
}
