/** One pupil opened large: his screen, and what can be done for him alone. */

import { Mirror } from "./mirror.js";
import { fromTemplate } from "./pupil_card.js";

export class PupilPane {
  /** `order(order)` sends to this pupil; `close()` and `beside(name)` are for the page. */
  constructor(name, texts, { order, close, beside, fillStart }) {
    this.name = name;
    this.element = fromTemplate("pane", texts);
    this._texts = texts;
    this._order = order;
    this._asked = false;
    this._typing = false;
    this._others = "";
    this._find = (what) => this.element.querySelector(`.${what}`);
    this._mirror = new Mirror(this._find("mirror"), (keys) => this._typing && order({ do: "type", text: keys }));
    const acts = {
      close,
      freeze: () => order({ do: "freeze", on: true }),
      unfreeze: () => order({ do: "freeze", on: false }),
      ask: () => {
        order({ do: "ask_to_type" });
        this._asked = true;
        this._hint();
      },
      stop: () => order({ do: "stop_typing" }),
      end: () => {
        if (confirm(texts.say("large.end.confirm", { name: this._shownName }))) order({ do: "end" });
      },
    };
    for (const [what, act] of Object.entries(acts)) this._find(what).addEventListener("click", act);
    this._find("say").addEventListener("submit", (event) => {
      event.preventDefault();
      const field = this._find("say").querySelector("input");
      if (field.value.trim()) order({ do: "say", text: field.value.trim() });
      field.value = "";
    });
    fillStart(this._find("start"), order);
    this._find("beside").addEventListener("change", (event) => {
      if (event.target.value) beside(event.target.value);
      event.target.value = "";
    });
  }

  show(row, rows) {
    this._shownName = row.shownName;
    this._find("name").textContent = row.shownName;
    const field = this._find("say").querySelector("input");
    field.placeholder = this._texts.say("large.say", { name: row.shownName });
    field.setAttribute("aria-label", field.placeholder);
    this._offerOthers(rows.filter((other) => other.name !== row.name));
    if (row.screen) this._mirror.show(row.screen);
    if (row.mayType || row.refused) this._asked = false;
    this._typing = row.mayType;
    this._refused = row.refused;
    this._find("ask").hidden = row.mayType;
    this._find("stop").hidden = !row.mayType;
    this._waits = !row.screen;
    this._hint();
  }

  _hint() {
    const key = this._typing ? "large.typing" : this._asked ? "large.asked" : this._waits ? "large.waiting" : "";
    this._find("hint").textContent = key ? this._texts.say(key, { name: this._shownName }) : this._refused || "";
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
