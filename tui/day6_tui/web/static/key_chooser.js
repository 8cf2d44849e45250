/** The dialog in which the user chooses which keys are in the key row, and in which order. */

import { KEYS, USUAL, spokenKey } from "./key_row.js";

export class KeyChooser {
  /** `dialog` has places for both lists and the tools; `changed(names)` is called after every change, `names` null for the usual row. */
  constructor(dialog, changed) {
    this._dialog = dialog;
    this._changed = changed;
    this._names = [];
    this._at = "";
    const tools = { earlier: () => this._move(-1), later: () => this._move(1), remove: () => this._remove(), reset: () => this._reset() };
    for (const [name, act] of Object.entries(tools)) this._tool(name).addEventListener("click", act);
  }

  open(names, texts) {
    this._texts = texts;
    this._names = [...names];
    this._at = "";
    this._show();
    this._dialog.showModal();
  }

  _tool(name) {
    return this._dialog.querySelector(`[data-do=${name}]`);
  }

  _show() {
    const others = [...KEYS.keys()].filter((name) => !this._names.includes(name));
    this._fill(".chosen", this._names, (name) => this._choose(name));
    this._fill(".others", others, (name) => this._insert(name));
    const place = this._names.indexOf(this._at);
    this._tool("earlier").disabled = place < 1;
    this._tool("later").disabled = place < 0 || place === this._names.length - 1;
    this._tool("remove").disabled = place < 0 || this._names.length === 1;
  }

  _fill(selector, names, act) {
    const buttons = names.map((name) => {
      const button = document.createElement("button");
      button.type = "button";
      button.dataset.key = name;
      button.textContent = KEYS.get(name).label;
      button.setAttribute("aria-label", spokenKey(name, this._texts));
      if (selector === ".chosen") button.setAttribute("aria-pressed", String(name === this._at));
      button.addEventListener("click", () => act(name));
      return button;
    });
    this._dialog.querySelector(selector).replaceChildren(...buttons);
  }

  _choose(name) {
    this._at = name;
    this._show();
    this._focus(name);
  }

  /** After the chosen key, or at the beginning, where it is seen. */
  _insert(name) {
    this._names.splice(this._names.indexOf(this._at) + 1, 0, name);
    this._take(name);
  }

  _move(step) {
    const place = this._names.indexOf(this._at);
    this._names.splice(place + step, 0, ...this._names.splice(place, 1));
    this._take(this._at);
  }

  _remove() {
    const place = this._names.indexOf(this._at);
    this._names.splice(place, 1);
    this._take(this._names[Math.min(place, this._names.length - 1)]);
  }

  _reset() {
    this._names = [...USUAL];
    this._at = "";
    this._changed(null);
    this._show();
  }

  _take(name) {
    this._at = name;
    this._changed(this._names);
    this._show();
    this._focus(name);
  }

  /** The buttons are new ones: the keyboard, and whoever hears the page, stays where it was. */
  _focus(name) {
    if (!this._dialog.querySelector(".tools").contains(document.activeElement)) {
      this._dialog.querySelector(`.chosen [data-key="${CSS.escape(name)}"]`)?.focus();
    }
  }
}
