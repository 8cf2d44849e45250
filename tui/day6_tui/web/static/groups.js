/** Named groups, which the server keeps: a click chooses one. And what else chooses many at once. */

import { line } from "./rows.js";

const LONGEST_NAME = 32;

export class Groups {
  /** `tell(message)` sends to the server and returns whether it could. */
  constructor(place, chosen, tell) {
    this._chosen = chosen;
    this._tell = tell;
    this._list = place.querySelector(".list");
    this._form = place.querySelector("form");
    this._shown = "";
    place.querySelector(".all").addEventListener("click", () => chosen.all());
    place.querySelector(".others").addEventListener("click", () => chosen.invert());
    this._form.addEventListener("submit", (event) => {
      event.preventDefault();
      const field = this._form.querySelector("input");
      const name = field.value.trim();
      if (name && tell({ t: "group", do: "keep", name, names: chosen.names ?? [] })) field.value = "";
    });
  }

  show(groups, rows, texts) {
    this._form.hidden = !this._chosen.names;
    const known = new Map(rows.map((row) => [row.name, row]));
    const found = (Array.isArray(groups) ? groups : []).map(({ name, names }) => {
      const members = (Array.isArray(names) ? names : []).filter((each) => known.has(each));
      return { name: String(name), members, here: members.filter((each) => known.get(each).runs).length };
    });
    const state = JSON.stringify([texts.language, found]);
    if (state !== this._shown) {
      this._shown = state;
      this._list.replaceChildren(...found.map((group) => this._chip(group, texts)));
    }
    found.forEach(({ members }, at) => {
      this._list.children[at].querySelector(".pick").setAttribute("aria-pressed", String(this._chosen.is(members)));
    });
  }

  _chip({ name, members, here }, texts) {
    const chip = document.createElement("span");
    chip.className = "group";
    const shown = line(name, LONGEST_NAME);
    chip.append(
      this._button("pick", texts.say("group.pick", { name: shown, here, all: members.length }), "", () => {
        this._chosen.set(this._chosen.is(members) ? [] : members);
      }),
      this._button("drop", "✕", texts.say("group.drop", { name: shown }), () => {
        if (confirm(texts.say("group.drop.confirm", { name: shown }))) this._tell({ t: "group", do: "drop", name });
      }),
    );
    return chip;
  }

  _button(kind, text, label, act) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = kind;
    button.textContent = text;
    if (label) button.title = label;
    if (label) button.setAttribute("aria-label", label);
    button.addEventListener("click", act);
    return button;
  }
}
