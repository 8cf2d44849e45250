/** The row of keys that a phone does not have and that browsers keep for themselves. Which ones, and in which order, the user chooses. */

import { bytesOf, control } from "./keys.js";

const REPEAT_AFTER_MS = 400;
const REPEAT_MS = 40;

const ARROWS = { left: "←", up: "↑", down: "↓", right: "→" };
const NAMED = {
  esc: "Esc", tab: "Tab", enter: "Enter", ...ARROWS, home: "Home", end: "End", pageup: "PgUp", pagedown: "PgDn", delete: "Del",
};
const CONTROLS = [..."cqwtndzlr"];
const SIGNS = [..."|/~-_\"'$&>"]; // far away on the keyboards of phones
const REPEATING = new Set(["tab", "delete", ...Object.keys(ARROWS), "pageup", "pagedown"]);

/** Every key there can be, by its name: what is written on it, and what a screen reader says, which has to begin with that. */
export const KEYS = new Map([
  ["ctrl", { label: "Ctrl", holds: true }],
  ["alt", { label: "Alt", holds: true }],
  ...Object.entries(NAMED).map(([name, label]) => [name, { label, text: name in ARROWS ? `keys.${name}` : "", named: true }]),
  ...Array.from({ length: 12 }, (_, at) => [`f${at + 1}`, { label: `F${at + 1}`, named: true }]),
  ...CONTROLS.map((letter) => [`^${letter}`, { label: `^${letter.toUpperCase()}`, spoken: `^${letter.toUpperCase()} Ctrl+${letter.toUpperCase()}`, sends: control(letter) }]),
  ...SIGNS.map((sign) => [sign, { label: sign, sends: sign }]),
]);

/** The row of who has chosen none: in two lines on a phone, one below the other by pairs. */
export const USUAL = "esc tab ctrl f5 up down left right enter ^c f3 f1 f2 f4 alt f6 f7 f8 f9 f10 ^q ^w ^t ^n ^d ^z f11 f12 home end pageup pagedown".split(" ");

/** The keys that a browser remembers, as far as there are such; the usual ones where it remembers none. */
export function chosenKeys(kept) {
  const known = [...new Set((kept || "").split(" "))].filter((name) => KEYS.has(name));
  return known.length ? known : USUAL;
}

/** What a screen reader says of a key. */
export function spokenKey(name, texts) {
  const { label, spoken, text } = KEYS.get(name);
  return text ? texts.say(text) : spoken || label;
}

export class KeyRow {
  /** Fills `row` with the keys of these `names`; `send(text)` gets the bytes, `mode()` says whether cursor keys are in application mode. */
  constructor(row, texts, names, send, mode) {
    this._send = send;
    this._mode = mode;
    this._held = { ctrl: false, alt: false };
    this._buttons = {};
    for (const name of names) this._add(row, name, spokenKey(name, texts));
  }

  /** Press a named key with the modifiers that are held. */
  press(name) {
    this._send(bytesOf(name, { ...this._held, applicationCursor: this._mode() }));
    this._release();
  }

  /** What typed text becomes while Ctrl or Alt is held on the row. */
  modified(text) {
    const { ctrl, alt } = this._held;
    if ((!ctrl && !alt) || [...text].length !== 1) return text;
    const char = ctrl ? control(text) : text;
    this._release();
    return alt ? `\x1b${char}` : char;
  }

  _act(name) {
    const { holds, named, sends } = KEYS.get(name);
    if (holds) this._hold(name, !this._held[name]);
    else if (named) this.press(name);
    else this._send(this.modified(sends));
  }

  _hold(name, held) {
    this._held[name] = held;
    this._buttons[name]?.setAttribute("aria-pressed", String(held));
  }

  _release() {
    for (const name of Object.keys(this._held)) this._hold(name, false);
  }

  /** A button that leaves the focus, and so a soft keyboard, where it is. */
  _add(row, name, title) {
    const { label, holds } = KEYS.get(name);
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.setAttribute("aria-label", title);
    keepsFocus(button);
    const act = () => this._act(name);
    button.addEventListener("click", act);
    if (REPEATING.has(name)) repeatWhileHeld(button, act);
    if (holds) button.setAttribute("aria-pressed", "false");
    this._buttons[name] = button;
    row.append(button);
  }
}

/** A press on the button does not take the focus from the terminal. */
export function keepsFocus(button) {
  button.addEventListener("mousedown", (event) => event.preventDefault());
}

/** A held arrow drives on, as on a keyboard. */
function repeatWhileHeld(button, act) {
  let timer = 0;
  const stop = () => clearTimeout(timer);
  const again = () => {
    act();
    timer = setTimeout(again, REPEAT_MS);
  };
  button.addEventListener("pointerdown", () => {
    stop();
    timer = setTimeout(again, REPEAT_AFTER_MS);
  });
  for (const end of ["pointerup", "pointercancel", "pointerleave"]) button.addEventListener(end, stop);
  button.addEventListener("contextmenu", (event) => event.preventDefault());
}
