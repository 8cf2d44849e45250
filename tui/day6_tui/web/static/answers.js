/** What was asked of the pupils, and what they have answered. All of it is text from pupils: checked here, shown as text only. */

import { line } from "./rows.js";

const KINDS = ["yes", "no", "done", "words"];
const LONGEST_REPLY = 80;
const LONGEST_QUESTION = 120;

/** The questions made safe to show: {number, text, asked: [names], replies: Map(name -> {kind, text})}. */
export function shownQuestions(found) {
  return (Array.isArray(found) ? found : []).map(({ number, text, asked, replies }) => ({
    number: Number(number),
    text: line(text, LONGEST_QUESTION),
    asked: (Array.isArray(asked) ? asked : []).map(String),
    replies: new Map(Object.entries(replies ?? {}).filter(([, reply]) => KINDS.includes(reply?.kind))
      .map(([name, { kind, text: words }]) => [name, { kind, text: line(words, LONGEST_REPLY) }])),
  }));
}

/** What stands on a pupil's card: the answer to the last question that the pupil was asked; "" without one. */
export function replyOf(questions, name, texts) {
  const question = [...questions].reverse().find(({ asked }) => asked.includes(name));
  if (!question) return "";
  const reply = question.replies.get(name);
  if (!reply) return texts.say("answers.none");
  return texts.say("answers.reply", { answer: reply.text || texts.say(`answers.${reply.kind}`) });
}

export class Answers {
  /** `choose(names)` is for the tools, `settle(number)` for a question that is over. */
  constructor(place, { choose, settle }) {
    this._place = place;
    this._acts = { choose, settle };
    this._shown = "";
  }

  show(questions, shownNames, texts) {
    this._place.hidden = !questions.length;
    const state = JSON.stringify([texts.language, questions.map((each) => ({ ...each, replies: [...each.replies] })), [...shownNames]]);
    if (state === this._shown) return;
    this._shown = state;
    const focused = document.activeElement?.closest?.("#questions button")?.dataset.key; // it is made anew
    this._place.replaceChildren(...[...questions].reverse().map((each) => this._question(each, shownNames, texts)));
    if (focused) this._place.querySelector(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  _question({ number, text, asked, replies }, shownNames, texts) {
    const element = document.createElement("article");
    element.className = "question";
    const title = document.createElement("h2");
    title.textContent = text;
    const by = (kind) => asked.filter((name) => (replies.get(name)?.kind ?? "none") === kind);
    const counts = [...KINDS, "none"].flatMap((kind) => {
      const names = by(kind);
      if (!names.length && kind === "words") return [];
      const label = kind === "none" ? "answers.count.none" : `answers.${kind}`;
      return [this._button(`${number} ${kind}`, `${texts.say(label)} ${names.length}`, () => this._acts.choose(names), !names.length)];
    });
    const close = this._button(`${number} close`, "✕", () => this._acts.settle(number));
    close.title = texts.say("answers.close");
    close.setAttribute("aria-label", close.title);
    const words = document.createElement("ul");
    for (const name of by("words")) {
      const item = document.createElement("li");
      item.textContent = texts.say("answers.said", { name: shownNames.get(name) ?? line(name), text: replies.get(name).text });
      words.append(item);
    }
    element.append(title, ...counts, close, words);
    return element;
  }

  _button(key, text, act, disabled = false) {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.key = key;
    button.textContent = text;
    button.disabled = disabled;
    button.addEventListener("click", act);
    return button;
  }
}
