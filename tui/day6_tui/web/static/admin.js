/** Desktops and homes that begin anew: what is chosen is asked about, with the names, and what came of it is said. */

import { line, names as listed } from "./rows.js";

const MOST_NAMED = 6; // of more pupils the number is said
const DEEDS = ["restart", "clear", "home"]; // besides lessons

export class Admin {
  /** `tell(message)` sends to the server and returns whether it could; `say(text)` tells the teacher. */
  constructor({ tell, say }) {
    this._tell = tell;
    this._say = say;
    this._count = 0;
    this._seen = null; // the last order of which everything was told; null: the page has just come
    this._open = new Set(); // orders that go on
  }

  /** Offer the deeds in a menu; `chosen()` gives the names it is for, null for all. */
  fill(select, chosen, lessons, texts) {
    this._texts = texts;
    this._lessons = lessons;
    const group = document.createElement("optgroup");
    group.label = texts.say("desks.lesson");
    group.append(...lessons.map((lesson) => new Option(this._title(lesson.name), JSON.stringify({ do: "lesson", lesson: lesson.name }))));
    const deeds = DEEDS.map((deed) => new Option(texts.say(`desks.${deed}`), JSON.stringify({ do: deed })));
    select.replaceChildren(new Option(texts.say("desks.title"), ""), ...deeds, ...(lessons.length ? [group] : []));
    this.limit(select, chosen());
    select.onchange = () => {
      const order = JSON.parse(select.value || "null");
      select.value = "";
      if (order) this._ask(order, chosen());
    };
  }

  /** A home is reset for one pupil at a time. */
  limit(select, names) {
    for (const option of select.options) {
      if (option.value === JSON.stringify({ do: "home" })) option.disabled = names?.length !== 1;
    }
  }

  _title(name) {
    const title = this._lessons.find((lesson) => lesson.name === name)?.title;
    return line(title?.[this._texts.language] ?? title?.en ?? name);
  }

  _ask(order, names) {
    const texts = this._texts;
    const many = names ? texts.say("desks.many", { count: names.length }) : texts.say("desks.all", { count: this._count });
    const who = names && names.length <= MOST_NAMED ? texts.say("desks.named", { names: listed(names, texts) }) : many;
    const lesson = order.lesson ? this._title(order.lesson) : "";
    if (confirm(texts.say(`desks.${order.do}.confirm`, { who, lesson }))) this._tell({ t: "desk", names: names ?? "*", ...order });
  }

  /** The server is another one, perhaps: its orders are counted anew. */
  forget() {
    this._seen = null;
    this._open.clear();
  }

  /** Say what came of orders, once all of each is done; `count` is how many pupils there are. */
  show(desks, count, texts) {
    this._texts = texts;
    this._count = count;
    const all = Array.isArray(desks) ? desks : [];
    const isDone = (each) => each.count + each.failed.length >= each.all;
    if (this._seen === null) {
      this._seen = Math.max(0, ...all.map(({ id }) => id));
      for (const each of all) if (!isDone(each)) this._open.add(each.id);
    }
    const fresh = all.filter(({ id }) => id > this._seen || this._open.has(id));
    const done = fresh.filter(isDone);
    const begun = fresh.filter((each) => !isDone(each) && !this._open.has(each.id));
    for (const { id } of begun) this._open.add(id);
    for (const { id } of done) this._open.delete(id);
    this._seen = Math.max(this._seen, ...fresh.map(({ id }) => id));
    const running = begun.length ? [texts.say("desks.going_on")] : [];
    const told = [...done.map((each) => this._told(each)), ...running];
    if (told.length) this._say(told.join(texts.say("sentences.between")));
  }

  _told({ do: deed, lesson, name, count, kept, failed }) {
    const texts = this._texts;
    const who = name ? line(name) : texts.say("desks.many", { count });
    const shown = { who, lesson: lesson && this._lessons ? this._title(lesson) : "", kept: line(kept, 200) };
    const whys = failed.map(([other, why]) => `${listed([other], texts)} (${line(why)})`).join(texts.say("names.between"));
    return [
      ...(count ? [texts.say(`desks.${deed}.done`, shown)] : []),
      ...(count && name && kept ? [texts.say("desks.kept", shown)] : []),
      ...(failed.length ? [texts.say("desks.failed", { names: whys })] : []),
      ...(!count && !failed.length ? [texts.say("desks.nobody")] : []),
    ].join(texts.say("sentences.between"));
  }
}
