/** Which pupils the tools are for, here or not. Nobody is chosen: then they are for all. */

export class Chosen {
  /** `place` holds what says how many and a button that chooses nobody; `changed()` is called after every choice. */
  constructor(place, changed) {
    this._place = place;
    this._changed = changed;
    this._names = new Set();
    this._order = []; // all names, as they stand on the page
    this._last = null; // where a range begins
    place.querySelector("button").addEventListener("click", () => this.set([]));
  }

  /** The names, in the order of choosing; null for all. */
  get names() {
    return this._names.size ? [...this._names] : null;
  }

  has(name) {
    return this._names.has(name);
  }

  /** Whether just these are chosen. */
  is(names) {
    return names.length > 0 && names.length === this._names.size && names.every((name) => this._names.has(name));
  }

  /** `toHere`: all from the one that was clicked before to this one. */
  choose(name, on, toHere = false) {
    const [from, to] = [this._order.indexOf(this._last), this._order.indexOf(name)];
    const range = toHere && from >= 0 && to >= 0 ? this._order.slice(Math.min(from, to), Math.max(from, to) + 1) : [name];
    for (const each of range) this._names[on ? "add" : "delete"](each);
    this._last = name;
    this._changed();
  }

  set(names) {
    this._names = new Set(names);
    this._changed();
  }

  all() {
    this.set(this._order);
  }

  /** Those who are not chosen, instead. */
  invert() {
    this.set(this._order.filter((name) => !this._names.has(name)));
  }

  /** Whoever does not belong to the class any more is chosen no more. */
  show(rows, texts) {
    this._order = rows.map((row) => row.name);
    const there = new Set(this._order);
    this._names = new Set([...this._names].filter((name) => there.has(name)));
    const count = this._names.size;
    const absent = rows.filter((row) => !row.runs && this._names.has(row.name)).length;
    this._place.hidden = !count;
    const say = (key, values) => (count ? texts.say(key, values) : "");
    this._place.firstElementChild.textContent = say(absent ? "chosen.count.absent" : "chosen.count", { count, absent });
  }
}
