/** The teacher's page: who is where, who needs help; and what is said or started for all. */

import { Admin } from "./admin.js";
import { Answers, replyOf, shownQuestions } from "./answers.js";
import { Assignments } from "./assignments.js";
import { CLASS_TEXTS } from "./class_texts.js";
import { Connection } from "./connection.js";
import { Chosen } from "./chosen.js";
import { Groups } from "./groups.js";
import { Handed } from "./handed.js";
import { Hands } from "./hands.js";
import { Lobby } from "./lobby.js";
import { Machine } from "./machine.js";
import { memory } from "./memory.js";
import { Notice } from "./notice.js";
import { Preview } from "./preview.js";
import { PupilCard, put } from "./pupil_card.js";
import { PupilPane } from "./pupil_pane.js";
import { offerDays } from "./log_days.js";
import { ORDERS, line, names, ordered, shownRow } from "./rows.js";
import { Show } from "./show.js";
import { Sizes } from "./sizes.js";
import { Strip } from "./strip.js";
import { Texts } from "./texts.js";

const WATCH_SECONDS = 10;
const WATCH_AGAIN_MS = 4000;
const NOTICE_MS = 8000;
const MISSED_MS = 30_000; // names take longer to read, and somebody has to go and see
const SILENT = new Set(["watch", "unwatch", "tell", "type"]); // the server answers every other order with {"t":"sent"}
const TOLD = new Set(["say", "freeze", "scene", "lesson", "link"]); // of the others one sees what they did
const LONGEST_NEWS = 300;
const ALL = "*";
const SIDE_BY_SIDE = 2;

const at = (id) => document.getElementById(id);

class Class {
  constructor() {
    this._texts = new Texts(new URLSearchParams(location.search).get("lang") || navigator.language, CLASS_TEXTS);
    this._rows = this._all = [];
    this._cards = new Map();
    this._panes = [];
    this._lessons = [];
    this._scenes = [];
    this._isFrozen = false;
    this._unanswered = []; // to whom the orders went that the server has yet to answer: names, or ALL
    this._notice = new Notice(at("notice"));
    this._sizes = new Sizes(at("size"), at("grid"), memory);
    this._preview = new Preview(at("preview"));
    this._peeked = null; // whose small screen the mouse or the focus is on
    this._lobby = new Lobby(at("lobby"), (order) => this._atDoor(order));
    this._waiting = [];
    this._chosen = new Chosen(at("chosen"), () => this._show());
    this._shows = new Show(at("showing"), at("show"), { tell: (message) => this._tell(message), chosen: () => this._chosen.names });
    this._groups = new Groups(at("groups"), this._chosen, (message) => this._tell(message));
    this._hands = new Hands(at("queue"), {
      answer: (name) => {
        this._order([name], { do: "lower_hand" });
        this._open(name);
      },
      lower: (name) => this._order([name], { do: "lower_hand" }),
    });
    this._answers = new Answers(at("questions"), {
      choose: (names) => this._chosen.set(names),
      settle: (number) => this._tell({ t: "settle", number }),
    });
    this._handed = new Handed(at("hand"), at("handouts"), {
      link: (text) => this._orderThem({ do: "link", text, shown: text }, "hand.confirm"),
      file: (id, name) => this._handFile(id, name),
      say: (text) => this._notice.show(text, MISSED_MS),
    });
    this._admin = new Admin({ tell: (message) => this._tell(message), say: (text) => this._notice.show(text, MISSED_MS) });
    this._machine = new Machine(at("machine"), at("machine-open"), at("machine-warning"), (message) => this._connection.tell(message));
    this._state = {}; // what the last rows came with
    this._questions = [];
    this._strip = new Strip(at("strip"), () => this._connection.open());
    this._seen = new Set(); // names of cards that are scrolled into view
    this._sight = new IntersectionObserver((entries) => this._noteSight(entries));
    this._hears = {
      rows: (message) => this._take(message),
      sent: (message) => this._wasSent(message),
      handing: (message) => this._handed.begun(message),
      assign: (message) => this._assignments.hear(message),
    };
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
    this._admin.forget();
    if (message.lang && new Texts(message.lang).language !== this._texts.language) {
      this._texts = new Texts(message.lang, CLASS_TEXTS);
      this._write();
      for (const card of this._cards.values()) card.close();
      this._cards.clear();
      this._hands.forget();
    }
    at("asking").hidden = message.word !== true;
    offerDays(at("log-days"), message.days, this._texts);
    if (Array.isArray(message.lessons)) this._lessons = message.lessons;
    if (Array.isArray(message.scenes)) this._scenes = message.scenes;
    this._fillMenus();
  }

  _hear(message) {
    this._hears[message.t]?.(message);
  }

  _take({ rows, ...state }) {
    this._shows.take(state.show, this._texts);
    const { frozen, asks, lobby, news, questions } = (this._state = state);
    this._questions = shownQuestions(questions);
    this._assignments.show(state.assignments);
    this._isFrozen = frozen === true;
    at("ask").checked = asks === true;
    this._waiting = lobby;
    const told = (Array.isArray(news) ? news : []).map((each) => line(each, LONGEST_NEWS));
    if (told.length) this._notice.show(told.join(this._texts.say("news.between")), MISSED_MS);
    const lessons = this._lessons.map(({ name }) => name);
    this._all = rows.map((row) => shownRow(row, this._texts.language, lessons));
    for (const row of this._all) row.reply = replyOf(this._questions, row.name, this._texts);
    this._sort();
  }

  _sort() {
    this._rows = ordered(this._all, at("order").value);
    this._show();
  }

  _show() {
    const rows = this._rows;
    this._chosen.show(rows, this._texts);
    this._groups.show(this._state.groups, rows, this._texts);
    this._hands.show(rows, this._texts);
    this._answers.show(this._questions, new Map(rows.map((row) => [row.name, row.shownName])), this._texts);
    this._handed.show(this._state.handed, this._texts);
    this._handed.showOpened(this._state.handouts, this._texts);
    this._admin.show(this._state.desks, rows.length, this._texts);
    this._admin.limit(at("desks"), this._chosen.names);
    this._machine.show(this._state.machine, this._texts);
    this._showHeader(rows);
    at("empty").hidden = rows.length > 0;
    const known = new Set(rows.map((row) => row.name));
    for (const [name, card] of this._cards) {
      if (!known.has(name)) this._remove(name, card);
    }
    this._sizes.show(rows.length, at("screens").checked);
    rows.forEach((row, place) => this._showCard(row, place));
    this._peek(this._peeked);
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
    put(at("here"), [...here, ...counted("class.away", count("away")), ...counted("class.full", count("full"))].join(" · "));
    const waiting = this._lobby.show(this._waiting, texts);
    const hands = rows.filter((row) => row.hand).length;
    const calls = [...counted("class.hands", hands), ...counted("class.waiting", waiting)];
    put(at("hands"), calls.join(" · "));
    document.title = calls.length ? [...calls, texts.say("class.title")].join(" · ") : `${texts.say("class.title")} · day6`;
    put(at("frozen"), this._isFrozen ? texts.say("class.frozen") : "");
    this._showTools();
  }

  /** The tools are for the chosen pupils, or for all. */
  _showTools() {
    const texts = this._texts;
    const kind = this._chosen.names ? "some" : "all";
    at("freeze").textContent = texts.say(`${kind}.${this._allFrozen() ? "unfreeze" : "freeze"}`);
    at("show").textContent = texts.say(`${kind}.show`);
    const field = at("say-text");
    field.placeholder = texts.say(`${kind}.say`);
    field.setAttribute("aria-label", field.placeholder);
    at("start").options[0].textContent = texts.say(`${kind}.start`);
    at("start").setAttribute("aria-label", texts.say(`${kind}.start`));
  }

  /** Whether those whom the tools are for are frozen, so that the button is for the opposite. */
  _allFrozen() {
    const chosen = this._chosen.names;
    if (!chosen) return this._isFrozen;
    const those = this._rows.filter((row) => row.runs && chosen.includes(row.name));
    return those.length > 0 && those.every((row) => row.frozen);
  }

  /** Show what is on a pupil's small screen so that it can be read; null: nobody's. */
  _peek(name) {
    this._peeked = name;
    const screen = this._rows.find((row) => row.name === name)?.screen;
    const small = this._cards.get(name)?.screen;
    if (screen && small && at("screens").checked && at("large").hidden) this._preview.show(screen, small);
    else this._preview.hide();
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
        peek: (on) => this._peek(on ? row.name : null),
        lower: () => this._order([row.name], { do: "lower_hand" }),
        remove: () => this._removeFromClass(row.name),
        choose: (on, toHere) => this._chosen.choose(row.name, on, toHere),
      });
      card.element.dataset.key = row.name;
      this._cards.set(row.name, card);
      this._sight.observe(card.element);
    }
    const grid = at("grid");
    if (grid.children[place] !== card.element) grid.insertBefore(card.element, grid.children[place] || null);
    card.show(row, { screens: at("screens").checked, zooms: at("zoom").checked, isChosen: this._chosen.has(row.name) });
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
    for (const name of this._watchedNames()) this._order([name], { do: "watch", seconds: WATCH_SECONDS });
  }

  _open(name) {
    if (this._panes.some((pane) => pane.name === name)) return;
    while (this._panes.length >= SIDE_BY_SIDE) this._close(this._panes[SIDE_BY_SIDE - 1]);
    const pane = new PupilPane(name, this._texts, {
      order: (order) => this._order([name], order),
      close: () => this._close(pane),
      beside: (other) => this._open(other),
      shows: this._shows,
      remove: () => this._removeFromClass(name),
      fillStart: (select, order) => this._fillStart(select, order),
      fillDesks: (select) => this._fillDesks(select, () => [name]),
    });
    this._panes.push(pane);
    at("panes").append(pane.element);
    at("large").hidden = false;
    this._peek(null);
    this._order([name], { do: "watch", seconds: WATCH_SECONDS });
    this._show();
    pane.element.querySelector(".close").focus();
  }

  _close(pane) {
    this._order([pane.name], { do: "unwatch" });
    this._panes = this._panes.filter((other) => other !== pane);
    pane.close();
    at("large").hidden = this._panes.length === 0;
    this._cards.get(pane.name)?.element.querySelector(".open").focus();
  }

  // -- orders --------------------------------------------------------------------------------------------------------

  /** Say something to the server; the teacher is told if it cannot hear it. Returns whether it can. */
  _tell(message, notice = this._notice) {
    const { isOpen } = this._connection;
    if (isOpen) this._connection.tell(message);
    else notice.show(this._texts.say("class.unsent"), NOTICE_MS);
    return isOpen;
  }

  /** Order something of these pupils, or of ALL. Returns whether there was a line to the server. */
  _order(names, order) {
    const message = { t: "order", names, order };
    if (SILENT.has(order.do)) {
      this._connection.tell(message);
      return this._connection.isOpen;
    }
    const isSent = this._tell(message, this._noticeFor(names));
    if (isSent) this._unanswered.push(names);
    return isSent;
  }

  /** About who comes in and who does not stay. */
  _atDoor(order) {
    this._tell({ t: "door", ...order });
  }

  _removeFromClass(name) {
    if (confirm(this._texts.say("pupil.remove.confirm", { name: line(name) }))) this._atDoor({ do: "remove", name });
  }

  /** Order something of the chosen pupils, or of all: then it is asked about, with the text `asks`. */
  _orderThem(order, asks = "") {
    const names = this._chosen.names;
    if (asks && !names && !confirm(this._texts.say(asks, { what: order.shown }))) return false;
    delete order.shown;
    return this._order(names ?? ALL, order);
  }

  /** Say something to them that they are to answer. */
  _ask(text) {
    const names = this._chosen.names ?? ALL;
    const isSent = this._tell({ t: "ask", names, text });
    if (isSent) this._unanswered.push(names);
    return isSent;
  }

  /** Hand out a file that the server has. */
  _handFile(id, name) {
    const names = this._chosen.names;
    if (!names && !confirm(this._texts.say("hand.confirm", { what: name }))) return false;
    return this._tell({ t: "hand", names: names ?? ALL, id });
  }

  /** Where one looks who has just ordered something: the large view covers the page. */
  _noticeFor(names) {
    const pane = names.length === 1 && this._panes.find((each) => each.name === names[0]);
    return pane ? pane.notice : this._notice;
  }

  /** The server says whom an order reached; it answers one after the other. */
  _wasSent({ do: what, count, missed }) {
    const texts = this._texts;
    const those = this._unanswered.shift() ?? ALL;
    const isOne = those !== ALL && those.length === 1;
    const parts = [];
    if (TOLD.has(what) && !isOne) parts.push(texts.say(count || missed.length ? "class.sent" : "class.sent.nobody", { count }));
    else if (TOLD.has(what) && count) parts.push(texts.say("class.sent.to", { name: line(those[0]) }));
    if (missed.length) parts.push(texts.say("class.missed", { names: names(missed, texts) }));
    if (parts.length) this._noticeFor(those).show(parts.join(texts.say("sentences.between")), missed.length ? MISSED_MS : NOTICE_MS);
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
    const first = new Option(texts.say(select.id ? "all.start" : "large.start"), "");
    select.replaceChildren(first, ...groups);
    select.onchange = () => {
      const order = JSON.parse(select.value || "null");
      const shown = select.selectedOptions[0].textContent;
      select.value = "";
      if (order) give(select.id ? { ...order, shown } : order);
    };
  }

  /** What is there for the chosen or for all. */
  _fillMenus() {
    this._fillStart(at("start"), (order) => this._orderThem(order, "class.confirm"));
    this._fillDesks(at("desks"), () => this._chosen.names);
    this._showTools();
  }

  _fillDesks(select, chosen) {
    this._admin.fill(select, chosen, this._lessons, this._texts);
  }

  _tools() {
    at("say").addEventListener("submit", (event) => {
      event.preventDefault();
      const text = at("say-text").value.trim();
      if (text && (at("say-asks").checked ? this._ask(text) : this._orderThem({ do: "say", text }))) at("say-text").value = "";
    });
    at("say-asks").checked = memory.get("class.asks") === "yes";
    at("say-asks").addEventListener("change", () => memory.set("class.asks", at("say-asks").checked ? "yes" : "no"));
    at("order").addEventListener("change", () => {
      memory.set("class.order", at("order").value);
      this._sort();
    });
    at("freeze").addEventListener("click", () => this._orderThem({ do: "freeze", on: !this._allFrozen() }));
    at("screens").addEventListener("change", () => {
      if (at("screens").checked) this._watch();
      else for (const name of this._seen) this._order([name], { do: "unwatch" });
      this._show();
    });
    at("zoom").checked = memory.get("zoom") !== "no";
    at("zoom").addEventListener("change", () => {
      memory.set("zoom", at("zoom").checked ? "yes" : "no");
      this._show();
    });
    at("ask").addEventListener("change", () => this._atDoor({ do: "ask", on: at("ask").checked }));
    document.addEventListener("keydown", (event) => {
      const last = this._panes.at(-1);
      if (event.key !== "Escape" || event.target.closest(".mirror") || this._machine.isOpen) return;
      if (last) this._close(last);
      else if (at("hand").open) at("hand").open = false;
      else if (!event.target.value || event.target.type === "checkbox") this._chosen.set([]);
    });
    document.addEventListener("visibilitychange", () => this._watch());
  }

  _write() {
    const texts = this._texts;
    texts.write(document);
    this._handed.texts = texts;
    this._fillMenus();
    const order = at("order").value || memory.get("class.order");
    at("order").replaceChildren(...Object.keys(ORDERS).map((name) => new Option(texts.say(`order.${name}`), name)));
    at("order").value = order in ORDERS ? order : "need";
    this._assignments?.close();
    this._assignments = new Assignments(at("assign"), texts, {
      tell: (message) => this._tell(message),
      chosen: () => this._chosen.names,
      lessons: () => this._lessons,
    });
  }
}

window.classPage = new Class(); // named for whoever looks with the browser's own tools, and for the tests
