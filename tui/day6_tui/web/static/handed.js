/** A link or a file for the pupils, and who has opened what was handed out. */

import { isLink } from "./page_link.js";
import { line, names as listed } from "./rows.js";

const LARGEST = 1 << 20;
const LONGEST_LINK = 2000;

/** A link as the server takes it (`order.is_link`): without signs that nobody sees, and others as a browser sends them. */
function plainLink(text) {
  const seen = text.replace(/[\p{Cc}\p{Cf}]/gu, "");
  return seen.replace(/[\p{Z}<>"'`\\]/gu, (sign) => (sign === "'" ? "%27" : encodeURIComponent(sign)));
}

export class Handed {
  /** `place` is the box with the two forms, `list` the hand-outs; link(text) and file(id) give, `say(text)` tells the teacher. */
  constructor(place, list, { link, file, say }) {
    this._place = place;
    this._list = list;
    this._lines = new Map(); // number -> the line of a hand-out; it stays the same, so that only what is new in it is spoken
    this._closed = new Set();
    this._give = { link, file };
    this._say = say;
    this._awaited = new Set(); // ids of what was handed out here and has not arrived everywhere
    place.querySelector(".link").addEventListener("submit", (event) => {
      event.preventDefault();
      this._takeLink(place.querySelector(".link input"));
    });
    place.querySelector(".file").addEventListener("change", (event) => this._takeFile(event.target));
  }

  _takeLink(field) {
    const text = field.value.trim();
    const whole = plainLink(/^[a-z][a-z0-9+.-]*:/i.test(text) && !/^[\w.-]+:\d/.test(text) ? text : `https://${text}`);
    if (!text || !isLink(whole) || whole.length > LONGEST_LINK) this._say(this._texts.say("hand.no_link"));
    else if (this._give.link(whole)) this._done(field);
  }

  async _takeFile(field) {
    const [file] = field.files;
    if (!file) return;
    const texts = this._texts;
    if (file.size > LARGEST) {
      this._say(texts.say("hand.large"));
    } else {
      try {
        const answer = await fetch(`class/hand?${new URLSearchParams({ name: file.name })}`, { method: "POST", body: file });
        if (!answer.ok) throw new Error(String(answer.status));
        const { id, name } = await answer.json();
        if (this._give.file(id, line(name))) this._done(field);
      } catch (error) {
        this._say(texts.say("hand.failed", { why: error.message }));
      }
    }
    field.value = "";
  }

  _done(field) {
    field.value = "";
    this._place.open = false;
  }

  /** The server has begun: what becomes of it comes with the rows. */
  begun({ id }) {
    this._awaited.add(id);
  }

  show(handed, texts) {
    this._texts = texts;
    for (const { id, name, all, count, failed } of Array.isArray(handed) ? handed : []) {
      if (!this._awaited.has(id) || count + failed.length < all) continue;
      this._awaited.delete(id);
      const whys = failed.map(([who, why]) => `${listed([who], texts)} (${line(why)})`).join(texts.say("names.between"));
      const told = texts.say("hand.done", { name: line(name), count });
      this._say(failed.length ? `${told}${texts.say("sentences.between")}${texts.say("hand.not", { names: whys })}` : told);
    }
  }

  /** Who has opened which. All names are text from pupils. */
  showOpened(found, texts) {
    const handouts = (Array.isArray(found) ? found : []).filter(({ number }) => !this._closed.has(Number(number)));
    const known = new Set(handouts.map(({ number }) => Number(number)));
    for (const [number, { element }] of this._lines) {
      if (known.has(number)) continue;
      element.remove();
      this._lines.delete(number);
    }
    this._list.hidden = !handouts.length;
    for (const { number, text, given, opened } of handouts) {
      const { title, by, close } = this._lineOf(Number(number));
      const who = (Array.isArray(given) ? given : []).map(String);
      const late = who.filter((name) => !(Array.isArray(opened) && opened.includes(name)));
      put(title, line(text));
      const counts = { count: who.length - late.length, all: who.length };
      put(by, late.length ? texts.say("hand.opened.not", { ...counts, names: listed(late, texts) }) : texts.say("hand.opened", counts));
      close.title = texts.say("hand.close");
      close.setAttribute("aria-label", `${close.title}: ${title.textContent}`);
    }
  }

  _lineOf(number) {
    if (!this._lines.has(number)) {
      const [element, title, by, close] = ["p", "b", "span", "button"].map((kind) => document.createElement(kind));
      element.className = "handout";
      by.setAttribute("role", "status");
      close.type = "button";
      close.textContent = "✕";
      close.addEventListener("click", () => {
        this._closed.add(number);
        this._lines.delete(number);
        element.remove();
        this._list.hidden = !this._lines.size;
      });
      element.append(title, by, close);
      this._list.prepend(element);
      this._lines.set(number, { element, title, by, close });
    }
    return this._lines.get(number);
  }

  set texts(texts) {
    this._texts = texts;
  }
}

function put(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
