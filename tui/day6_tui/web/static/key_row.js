/** The row of keys that a phone does not have and that browsers keep for themselves. */

import { bytesOf, control } from "./keys.js";

const REPEAT_AFTER_MS = 400;
const REPEAT_MS = 40;

const MODIFIERS = [["ctrl", "Ctrl"], ["alt", "Alt"]];
const NAMED = [["esc", "Esc"], ["tab", "Tab"], ["left", "←"], ["up", "↑"], ["down", "↓"], ["right", "→"]];
const CONTROLS = ["C", "Q", "W", "T", "N", "D", "Z"];
const OTHERS = [["home", "Home"], ["end", "End"], ["pageup", "PgUp"], ["pagedown", "PgDn"]];
const ARROWS = new Set(["left", "up", "down", "right"]);

export class KeyRow {
  /** Fills `row`; `send(text)` gets the bytes, `mode()` says whether cursor keys are in application mode. */
  constructor(row, texts, send, mode) {
    this._send = send;
    this._mode = mode;
    this._held = { ctrl: false, alt: false };
    this._buttons = {};
    for (const [name, label] of MODIFIERS) this._addModifier(row, name, label);
    for (const [name, label] of NAMED) {
      const title = ARROWS.has(name) ? texts.say(`keys.${name}`) : label;
      this._add(row, label, title, () => this.press(name), ARROWS.has(name) || name === "tab");
    }
    for (const letter of CONTROLS.slice(0, 2)) this._addControl(row, letter);
    for (let number = 1; number <= 12; number++) this._add(row, `F${number}`, `F${number}`, () => this.press(`f${number}`));
    for (const letter of CONTROLS.slice(2)) this._addControl(row, letter);
    for (const [name, label] of OTHERS) this._add(row, label, label, () => this.press(name), name.startsWith("page"));
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

  _addControl(row, letter) {
    this._add(row, `^${letter}`, `Ctrl+${letter}`, () => this._send(control(letter)));
  }

  _addModifier(row, name, label) {
    const button = this._add(row, label, label, () => this._hold(name, !this._held[name]));
    button.setAttribute("aria-pressed", "false");
    this._buttons[name] = button;
  }

  _hold(name, held) {
    this._held[name] = held;
    this._buttons[name].setAttribute("aria-pressed", String(held));
  }

  _release() {
    for (const [name] of MODIFIERS) this._hold(name, false);
  }

  /** A button that leaves the focus, and so a soft keyboard, where it is. */
  _add(row, label, title, act, repeats = false) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.setAttribute("aria-label", title);
    keepsFocus(button);
    button.addEventListener("click", act);
    if (repeats) repeatWhileHeld(button, act);
    row.append(button);
    return button;
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
