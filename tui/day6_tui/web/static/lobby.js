/** Who has the class word and waits to be let in, by where they come from. */

import { fromTemplate } from "./pupil_card.js";
import { places } from "./rows.js";

export class Lobby {
  /** `decide(order)` tells the server: {do: "admit", ids, trust} or {do: "turn_away", ids}. */
  constructor(section, decide) {
    this._section = section;
    this._decide = decide;
    this._shown = "";
  }

  /** Made anew only when somebody has come or gone, so that the buttons can be used. Returns how many wait. */
  show(waiting, texts) {
    const shown = JSON.stringify([waiting, texts.language]);
    const found = places(waiting);
    if (shown !== this._shown) {
      this._shown = shown;
      const hadFocus = this._section.contains(document.activeElement);
      this._section.replaceChildren(...found.map((place) => this._place(place, texts)));
      this._section.hidden = !found.length;
      if (hadFocus) this._section.querySelector("li button")?.focus();
    }
    return found.reduce((sum, { newcomers }) => sum + newcomers.length, 0);
  }

  _place({ address, newcomers }, texts) {
    const element = fromTemplate("place", texts);
    const ids = newcomers.map(({ id }) => id);
    const strangers = newcomers.filter(({ isClaim }) => !isClaim).map(({ id }) => id); // nobody gets another's desk among many
    element.querySelector(".all").hidden = !strangers.length;
    element.querySelector(".from").textContent = texts.say("lobby.from", { count: ids.length, address });
    this._on(element, ".all", { do: "admit", ids: strangers, trust: true });
    this._on(element, ".none", { do: "turn_away", ids });
    element.querySelector("ul").replaceChildren(...newcomers.map((newcomer) => this._newcomer(newcomer, texts)));
    return element;
  }

  _newcomer({ id, name, why, was }, texts) {
    const element = fromTemplate("newcomer", texts);
    element.querySelector(".name").textContent = name;
    element.querySelector(".why").textContent = texts.say(`lobby.why.${why}`, { name, was });
    for (const [button, order] of [
      [".in", { do: "admit", ids: [id], trust: false }],
      [".away", { do: "turn_away", ids: [id] }],
    ]) {
      this._on(element, button, order);
      const label = element.querySelector(button);
      label.setAttribute("aria-label", `${label.textContent}: ${name}`);
    }
    return element;
  }

  _on(element, button, order) {
    element.querySelector(button).addEventListener("click", () => this._decide(order));
  }
}
