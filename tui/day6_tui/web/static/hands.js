/** The raised hands, in the order of asking. */

function minutes(seconds) {
  return Math.floor(seconds / 60);
}

export class Hands {
  /** `answer(name)` is for going to a pupil, `lower(name)` for taking the hand down only. */
  constructor(place, { answer, lower }) {
    this._place = place;
    this._acts = { answer, lower };
    this._items = new Map();
  }

  show(rows, texts) {
    const up = rows.filter((row) => row.hand).sort((a, b) => b.raised - a.raised);
    this._place.hidden = !up.length;
    const list = this._place.querySelector("ol");
    for (const [name, item] of this._items) {
      if (up.some((row) => row.name === name)) continue;
      item.remove();
      this._items.delete(name);
    }
    up.forEach((row, at) => {
      const item = this._item(row, texts);
      if (list.children[at] !== item) list.insertBefore(item, list.children[at] || null);
      item.querySelector(".answer").textContent = `${at + 1}. ${row.shownName}`;
      item.querySelector(".for").textContent = this._words(row, texts);
    });
  }

  /** Since when the hand is up, and how long the pupil has been at the step. */
  _words(row, texts) {
    const parts = [texts.say("hands.up", { minutes: minutes(row.raised) })];
    if (row.lesson) parts.push(texts.say("hands.step", { minutes: minutes(row.onStep), ...row.lesson }));
    return parts.join(" · ");
  }

  _item(row, texts) {
    const known = this._items.get(row.name);
    if (known) return known;
    const item = document.createElement("li");
    for (const kind of ["answer", "lower"]) {
      const button = document.createElement("button");
      button.type = "button";
      button.className = kind;
      button.textContent = texts.say("hands.lower");
      button.title = texts.say(`hands.${kind}.title`, { name: row.shownName });
      button.addEventListener("click", () => this._acts[kind](row.name));
      item.append(button);
    }
    const words = document.createElement("span");
    words.className = "for";
    item.insertBefore(words, item.lastElementChild);
    this._items.set(row.name, item);
    return item;
  }

  /** In another language everything is made anew. */
  forget() {
    for (const item of this._items.values()) item.remove();
    this._items.clear();
  }
}
