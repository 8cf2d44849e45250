/** What the teacher shows to the class: the own desktop, or a pupil's who lets it be shown. */

import { put } from "./pupil_card.js";
import { line } from "./rows.js";

const ALL = "*";
const MINE = "day6-mine"; // the name of the tab of the teacher's desktop: there is one

export class Show {
  /** `bar` says what is shown, `button` shows the own desktop; `tell(message)` returns whether there was a line, `chosen()` to whom. */
  constructor(bar, button, { tell, chosen }) {
    this._bar = bar;
    this._tell = tell;
    this._chosen = chosen;
    this._state = { on: null, wanted: null, mine: false };
    this._find = (name) => bar.querySelector(`.${name}`);
    button.addEventListener("click", () => this._mine());
    this._find("full").addEventListener("click", () => this._again(!this._state.on.full));
    this._find("stop").addEventListener("click", () => this.stop());
  }

  take(state, texts) {
    this._state = state ?? this._state;
    const { on, wanted } = this._state;
    this._bar.hidden = !on && !wanted;
    const told = [on && this._told(on, texts), wanted && this._waits(wanted, texts)].filter(Boolean).join(texts.say("sentences.between"));
    put(this._find("what"), told);
    this._find("full").hidden = !on;
    this._find("full").textContent = texts.say(on?.full ? "show.beside" : "show.full");
  }

  _told({ name, count }, texts) {
    const what = name ? "show.on" : "show.on.mine";
    const to = count === null ? "show.all" : count === 1 ? "show.some.one" : "show.some";
    return texts.say(what, { name: line(name), to: texts.say(to, { count }) });
  }

  _waits({ name }, texts) {
    return name ? texts.say("show.asked", { name: line(name) }) : texts.say("show.starts");
  }

  /** `on`, `wanted` or "": how it is with this pupil's screen. */
  of(name) {
    return ["on", "wanted"].find((what) => this._state[what]?.name === name) ?? "";
  }

  /** Show the screen of a pupil, or "" for the own one. */
  start(name, names = ALL) {
    return this._tell({ t: "show", do: "start", name, names, full: false });
  }

  stop() {
    return this._tell({ t: "show", do: "stop" });
  }

  _mine() {
    if (this.start("", this._chosen() ?? ALL) && !this._state.mine) window.open("mine", MINE);
  }

  /** The same for the same pupils, larger or smaller. */
  _again(full) {
    this._tell({ t: "show", do: "again", full });
  }
}
