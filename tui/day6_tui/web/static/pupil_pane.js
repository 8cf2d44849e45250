/** One pupil opened large: his screen, and what can be done for him alone. */

import { Mirror } from "./mirror.js";
import { Notice } from "./notice.js";
import { fromTemplate, put } from "./pupil_card.js";

const FOR_DESKTOPS = ".say input, .say button, .start, .freeze, .ask, .stop, .show, .end"; // of no use while none runs
const LONGEST_KEYS = 256; // of one order

export class PupilPane {
  /** `order(order)` sends to this pupil and returns whether there was a line; `close()` and `beside(name)` are for the page. */
  constructor(name, texts, { order, close, beside, remove, fillStart, fillDesks, shows }) {
    this.name = name;
    this.element = fromTemplate("pane", texts);
    this._texts = texts;
    this._order = order;
    this._shows = shows;
    this._row = null;
    this._hasJustAsked = false;
    this._others = "";
    this._find = (what) => this.element.querySelector(`.${what}`);
    this.notice = new Notice(this._find("sent"));
    this._mirror = new Mirror(this._find("mirror"), (keys) => this._type(keys));
    const acts = {
      close,
      remove,
      freeze: () => order({ do: "freeze", on: !this._row.frozen }),
      ask: () => this._ask(),
      stop: () => order({ do: "stop_typing" }),
      show: () => (shows.of(name) ? shows.stop() : shows.start(name)),
      end: () => {
        if (confirm(texts.say("large.end.confirm", { name: this._row.shownName }))) order({ do: "end" });
      },
    };
    for (const [what, act] of Object.entries(acts)) this._find(what).addEventListener("click", act);
    this._find("say").addEventListener("submit", (event) => {
      event.preventDefault();
      const field = this._find("say").querySelector("input");
      if (field.value.trim() && order({ do: "say", text: field.value.trim() })) field.value = "";
    });
    fillStart(this._find("start"), order);
    fillDesks(this._find("desks"));
    this._find("beside").addEventListener("change", (event) => {
      if (event.target.value) beside(event.target.value);
      event.target.value = "";
    });
  }

  /** Keys go in pieces that an order can hold: a paste may be long. */
  _type(keys) {
    if (!this._row?.mayType) return;
    const signs = [...keys];
    for (let at = 0; at < signs.length; at += LONGEST_KEYS) this._order({ do: "type", text: signs.slice(at, at + LONGEST_KEYS).join("") });
  }

  show(row, rows) {
    this._row = row;
    this._hasJustAsked = false; // now the desktop has said what is true
    const texts = this._texts;
    this._find("name").textContent = row.shownName;
    this._find("state").textContent = texts.say(`state.${row.state}`);
    const field = this._find("say").querySelector("input");
    field.placeholder = texts.say("large.say", { name: row.shownName });
    field.setAttribute("aria-label", field.placeholder);
    this._offerOthers(rows.filter((other) => other.runs && other.name !== row.name));
    for (const tool of this.element.querySelectorAll(FOR_DESKTOPS)) tool.disabled = !row.runs;
    this._find("freeze").textContent = texts.say(row.frozen ? "large.unfreeze" : "large.freeze");
    this._find("ask").hidden = row.mayType;
    this._find("stop").hidden = !row.mayType;
    this._find("show").textContent = texts.say(this._shows.of(row.name) ? "large.show.stop" : "large.show");
    this._showScreen(row);
    this._hint();
  }

  /** The picture of a desktop that has ended is taken away: nobody shall take it for the present. */
  _showScreen({ runs, screen, state, shownName }) {
    if (!runs) this._mirror.clear();
    else if (screen) this._mirror.show(screen);
    this._find("mirror").hidden = !runs;
    this._find("nobody").hidden = runs;
    if (!runs) this._find("nobody").textContent = this._texts.say(`large.${state}`, { name: shownName });
  }

  _ask() {
    this._hasJustAsked = this._order({ do: "ask_to_type" });
    this._hint();
  }

  _hint() {
    const { runs, mayType, asked, refused, screen, shownName } = this._row;
    let text = "";
    if (!runs) text = "";
    else if (this._hasJustAsked) text = "…";
    else if (mayType) text = this._texts.say("large.typing", { name: shownName });
    else if (asked || this._shows.of(this._row.name) === "wanted") text = this._texts.say("large.asked", { name: shownName });
    else if (refused) text = refused;
    else if (!screen) text = this._texts.say("large.waiting");
    put(this._find("hint"), text);
  }

  /** The choice of a second pupil; made anew only when the class changed, so that it can be used. */
  _offerOthers(others) {
    const known = JSON.stringify(others.map(({ name }) => name));
    if (known === this._others) return;
    this._others = known;
    const options = others.map((other) => new Option(other.shownName, other.name));
    this._find("beside").replaceChildren(new Option(this._texts.say("large.beside"), ""), ...options);
  }

  close() {
    this._mirror.close();
    this.element.remove();
  }
}
