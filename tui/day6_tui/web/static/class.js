/** The teacher's page: who is where, who needs help; and what is said or started for all. */

import { CLASS_TEXTS } from "./class_texts.js";
import { Connection } from "./connection.js";
import { Lobby } from "./lobby.js";
import { Notice } from "./notice.js";
import { PupilCard } from "./pupil_card.js";
import { PupilPane } from "./pupil_pane.js";
import { line, names, ordered, report, shownRow } from "./rows.js";
import { Strip } from "./strip.js";
import { Texts } from "./texts.js";

const WATCH_SECONDS = 10;
const WATCH_AGAIN_MS = 4000;
const NOTICE_MS = 8000;
const MISSED_MS = 30_000; // names take longer to read, and somebody has to go and see
const SILENT = new Set(["watch", "unwatch", "tell", "type"]); // the server answers every other order with {"t":"sent"}
const TOLD = new Set(["say", "freeze", "scene", "lesson"]); // of the others one sees what they did
const LONGEST_NEWS = 300;
const ALL = "*"; // which nobody is called
const SIDE_BY_SIDE = 2;

const at = (id) => document.getElementById(id);

class Class {
  constructor() {
    this._texts = new Texts(new URLSearchParams(location.search).get("lang") || navigator.language, CLASS_TEXTS);
    this._rows = [];
    this._cards = new Map();
    this._panes = [];
    this._lessons = [];
    this._scenes = [];
    this._isFrozen = false;
    this._unanswered = []; // to whom the orders went that the server has yet to answer
    this._notice = new Notice(at("notice"));
    this._lobby = new Lobby(at("lobby"), (order) => this._atDoor(order));
    this._waiting = [];
    this._strip = new Strip(at("strip"), () => this._connection.open());
    this._seen = new Set(); // names of cards that are scrolled into view
    this._sight = new IntersectionObserver((entries) => this._noteSight(entries));
    this._write();
    this._tools();
    this._connection = new Connection("class/ws", null, {
      hello: (message) => this._hello(message),
      message: (message) => this._hear(message),
      state: (name, count) => this._strip.show(name, count, this._texts),
    });
    setInterval(() => this._watch(), WATCH_AGAIN_MS);
    this._connection.open();
  }

  /** The first message may say the language and what lessons and scenes there are. */
  _hello(message) {
    this._unanswered = [];
    if (message.lang && new Texts(message.lang).language !== this._texts.language) {
      this._texts = new Texts(message.lang, CLASS_TEXTS);
      this._write();
      for (const card of this._cards.values()) card.close();
      this._cards.clear();
    }
    at("asking").hidden = message.word !== true;
    if (Array.isArray(message.lessons)) this._lessons = message.lessons;
    if (Array.isArray(message.scenes)) this._scenes = message.scenes;
    this._fillStart(at("start"), (order) => this._orderAll(order, true));
  }

  _hear(message) {
    if (message.t === "rows") this._take(message);
    else if (message.t === "sent") this._wasSent(message);
  }

  _take({ rows, frozen, asks, lobby, news }) {
    this._isFrozen = frozen === true;
    at("ask").checked = asks === true;
    this._waiting = lobby;
    const told = (Array.isArray(news) ? news : []).map((each) => line(each, LONGEST_NEWS));
    if (told.length) this._notice.show(told.join(this._texts.say("news.between")), MISSED_MS);
    this._rows = ordered(rows.map((row) => shownRow(row, this._texts.language)));
    this._show();
  }

  _show() {
    const rows = this._rows;
    this._showHeader(rows);
    at("empty").hidden = rows.length > 0;
    const known = new Set(rows.map((row) => row.name));
    for (const [name, card] of this._cards) {
      if (!known.has(name)) this._remove(name, card);
    }
    rows.forEach((row, place) => this._showCard(row, place));
    for (const pane of this._panes) {
      const row = rows.find((other) => other.name === pane.name);
      if (row) pane.show(row, rows);
      else this._close(pane); // removed from the class
    }
  }

  _showHeader(rows) {
    const texts = this._texts;
    const count = (state) => rows.filter((row) => row.state === state).length;
    const counted = (key, number) => (number ? [texts.say(number === 1 ? `${key}.one` : key, { count: number })] : []);
    const here = [texts.say("class.here", { here: count("here"), all: rows.length })];
    at("here").textContent = [...here, ...counted("class.away", count("away")), ...counted("class.full", count("full"))].join(" · ");
    const waiting = this._lobby.show(this._waiting, texts);
    const hands = rows.filter((row) => row.hand).length;
    at("hands").textContent = [...counted("class.hands", hands), ...counted("class.waiting", waiting)].join(" · ");
    const calls = [...(hands ? [`✋ ${hands}`] : []), ...(waiting ? [`🚪 ${waiting}`] : [])];
    document.title = calls.length ? [...calls, texts.say("class.title")].join(" · ") : `${texts.say("class.title")} · day6`;
    at("frozen").textContent = this._isFrozen ? texts.say("class.frozen") : "";
    at("freeze").textContent = texts.say(this._isFrozen ? "class.unfreeze" : "class.freeze");
  }

  _remove(name, card) {
    this._sight.unobserve(card.element);
    this._seen.delete(name);
    card.close();
    this._cards.delete(name);
  }

  _showCard(row, place) {
    let card = this._cards.get(row.name);
    if (!card) {
      card = new PupilCard(this._texts, {
        open: () => this._open(row.name),
        lower: () => this._order(row.name, { do: "lower_hand" }),
        remove: () => this._removeFromClass(row.name),
      });
      card.element.dataset.key = row.name;
      this._cards.set(row.name, card);
      this._sight.observe(card.element);
    }
    const grid = at("grid");
    if (grid.children[place] !== card.element) grid.insertBefore(card.element, grid.children[place] || null);
    card.show(row, at("screens").checked);
  }

  _noteSight(entries) {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) this._seen.add(target.dataset.key);
      else this._seen.delete(target.dataset.key);
    }
    if (at("screens").checked) this._watch();
  }

  // -- watching ------------------------------------------------------------------------------------------------------

  /** Whose screens are looked at: the large ones, and the small ones in view. Nobody's while the page is hidden. */
  _watchedNames() {
    if (document.hidden) return [];
    const small = at("screens").checked && at("large").hidden ? [...this._seen] : [];
    const looked = new Set([...this._panes.map((pane) => pane.name), ...small]);
    return this._rows.filter((row) => row.runs && looked.has(row.name)).map((row) => row.name);
  }

  _watch() {
    for (const name of this._watchedNames()) this._order(name, { do: "watch", seconds: WATCH_SECONDS });
  }

  _open(name) {
    if (this._panes.some((pane) => pane.name === name)) return;
    while (this._panes.length >= SIDE_BY_SIDE) this._close(this._panes[SIDE_BY_SIDE - 1]);
    const pane = new PupilPane(name, this._texts, {
      order: (order) => this._order(name, order),
      close: () => this._close(pane),
      beside: (other) => this._open(other),
      remove: () => this._removeFromClass(name),
      fillStart: (select, order) => this._fillStart(select, order),
    });
    this._panes.push(pane);
    at("panes").append(pane.element);
    at("large").hidden = false;
    this._order(name, { do: "watch", seconds: WATCH_SECONDS });
    this._show();
    pane.element.querySelector(".close").focus();
  }

  _close(pane) {
    this._order(pane.name, { do: "unwatch" });
    this._panes = this._panes.filter((other) => other !== pane);
    pane.close();
    at("large").hidden = this._panes.length === 0;
    this._cards.get(pane.name)?.element.querySelector(".open").focus();
  }

  // -- orders --------------------------------------------------------------------------------------------------------

  /** Returns whether there was a line to the server. */
  _order(name, order) {
    const { isOpen } = this._connection;
    if (isOpen && !SILENT.has(order.do)) this._unanswered.push(name);
    this._connection.tell({ t: "order", name, order });
    if (!isOpen && !SILENT.has(order.do)) this._noticeFor(name).show(this._texts.say("class.unsent"), NOTICE_MS);
    return isOpen;
  }

  /** About who comes in and who does not stay. */
  _atDoor(order) {
    if (!this._connection.isOpen) this._notice.show(this._texts.say("class.unsent"), NOTICE_MS);
    this._connection.tell({ t: "door", ...order });
  }

  _removeFromClass(name) {
    if (confirm(this._texts.say("pupil.remove.confirm", { name: line(name) }))) this._atDoor({ do: "remove", name });
  }

  _orderAll(order, asks = false) {
    if (asks && !confirm(this._texts.say("class.confirm", { what: order.shown }))) return false;
    delete order.shown;
    return this._order(ALL, order);
  }

  /** Where one looks who has just ordered something: the large view covers the page. */
  _noticeFor(name) {
    return this._panes.find((pane) => pane.name === name)?.notice ?? this._notice;
  }

  /** The server says whom an order reached; it answers one after the other. */
  _wasSent({ do: what, count, missed }) {
    const texts = this._texts;
    const name = this._unanswered.shift() ?? ALL;
    const parts = [];
    if (TOLD.has(what) && name === ALL) parts.push(texts.say(count || missed.length ? "class.sent" : "class.sent.nobody", { count }));
    else if (TOLD.has(what) && count) parts.push(texts.say("class.sent.to", { name: line(name) }));
    if (missed.length) parts.push(texts.say("class.missed", { names: names(missed, texts) }));
    if (parts.length) this._noticeFor(name).show(parts.join(texts.say("sentences.between")), missed.length ? MISSED_MS : NOTICE_MS);
  }

  /** Scenes and lessons, where the server told which there are. */
  _fillStart(select, give) {
    const texts = this._texts;
    const group = (label, what, found) => {
      const made = document.createElement("optgroup");
      made.label = texts.say(label);
      for (const { name, title } of found) {
        const shown = line(title?.[texts.language] ?? title?.en ?? name);
        made.append(new Option(shown, JSON.stringify({ do: what, text: String(name) })));
      }
      return found.length ? [made] : [];
    };
    const groups = [
      ...group("class.start.scenes", "scene", this._scenes),
      ...group("class.start.lessons", "lesson", this._lessons),
    ];
    const first = new Option(select.id ? texts.say("class.start") : texts.say("large.start"), "");
    select.replaceChildren(first, ...groups);
    select.onchange = () => {
      const order = JSON.parse(select.value || "null");
      const shown = select.selectedOptions[0].textContent;
      select.value = "";
      if (order) give(select.id ? { ...order, shown } : order);
    };
  }

  _tools() {
    at("say").addEventListener("submit", (event) => {
      event.preventDefault();
      const text = at("say-text").value.trim();
      if (text && this._orderAll({ do: "say", text })) at("say-text").value = "";
    });
    at("freeze").addEventListener("click", () => this._orderAll({ do: "freeze", on: !this._isFrozen }));
    at("screens").addEventListener("change", () => {
      if (at("screens").checked) this._watch();
      else for (const name of this._seen) this._order(name, { do: "unwatch" });
      this._show();
    });
    at("ask").addEventListener("change", () => this._atDoor({ do: "ask", on: at("ask").checked }));
    at("report").addEventListener("click", () => this._export());
    document.addEventListener("keydown", (event) => {
      const last = this._panes.at(-1);
      if (event.key === "Escape" && last && !event.target.closest(".mirror")) this._close(last);
    });
    document.addEventListener("visibilitychange", () => this._watch());
  }

  _export() {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([report(this._rows, this._texts)], { type: "text/csv" }));
    link.download = `${this._texts.say("report.file")} ${new Date().toISOString().slice(0, 16).replace(/[T:]/g, "-")}.csv`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }

  _write() {
    this._texts.write(document);
    this._fillStart(at("start"), (order) => this._orderAll(order, true));
  }
}

window.classPage = new Class(); // named for whoever looks with the browser's own tools, and for the tests
