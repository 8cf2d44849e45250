/** The teacher's assignments: handed out, collected, graded, marked and given back, in a dialog over the class. */

import { HandOut } from "./hand_out.js";
import { fromTemplate, put } from "./pupil_card.js";
import { line } from "./rows.js";

const LONGEST = 200;
const STATES = new Set(["returned", "graded", "collected", "missing", "working", "given", "waiting"]);
const DOES = ["collect", "grade", "return"];

const whole = (value) => (Number.isFinite(value) ? Math.max(0, value) : 0);

/** A time as one reads it: today's without the date. */
function clock(seconds, language) {
  if (!whole(seconds)) return "";
  const date = new Date(seconds * 1000);
  const isToday = date.toDateString() === new Date().toDateString();
  const time = { hour: "2-digit", minute: "2-digit" };
  return date.toLocaleString(language === "zh" ? "zh-CN" : "en-GB", isToday ? time : { ...time, month: "short", day: "numeric" });
}

export class Assignments {
  /**
   * `tell(message)` speaks to the server and returns whether it can; `chosen()` gives the names of the chosen pupils or null;
   * `lessons()` what there is to hand out.
   */
  constructor(button, texts, { tell, chosen, lessons }) {
    this._texts = texts;
    this._tell = tell;
    this._list = [];
    this._id = "";
    this._version = 0;
    this._rows = new Map(); // name -> its line of the table
    this._dialog = fromTemplate("assignments", texts);
    this._dialog.setAttribute("aria-label", texts.say("assign.title"));
    this._find = (name) => this._dialog.querySelector(`.${name}`);
    this._out = new HandOut(this._find("hand-out"), texts, { give: (order) => this._ask({ do: "new", ...order }), chosen, lessons });
    document.body.append(this._dialog);
    button.onclick = () => this._open(); // one dialog, also after another language was chosen
    this._find("close").addEventListener("click", () => this._dialog.close());
    this._find("new").addEventListener("click", () => this._out.open());
    for (const what of DOES) this._find(what).addEventListener("click", () => this._ask({ do: what, id: this._id, names: "*" }));
    this._find("end").addEventListener("click", () => this._ask({ do: "close", id: this._id, on: !this._chosen?.closed }));
    this._dialog.addEventListener("keydown", (event) => event.stopPropagation()); // Esc closes the dialog only
  }

  get _chosen() {
    return this._list.find((each) => each.id === this._id);
  }

  _ask(message) {
    if (!this._tell({ t: "assign", ...message })) put(this._find("notice"), this._texts.say("class.unsent"));
  }

  _open() {
    this._dialog.showModal();
    put(this._find("notice"), "");
    this._choose(this._chosen?.id ?? this._list.at(-1)?.id ?? "");
    if (!this._list.length) this._find("new").focus();
  }

  close() {
    this._dialog.remove();
  }

  /** What the rows say: which assignments there are, and whether something has changed. */
  show(told) {
    if (!told || !Array.isArray(told.list)) return;
    this._list = told.list.map((each) => this._shown(each)).reverse();
    const isNew = told.version !== this._version;
    this._version = told.version;
    if (!this._dialog.open) return;
    this._showList();
    if (isNew && this._id) this._ask({ do: "show", id: this._id });
  }

  _shown(each) {
    const { language } = this._texts;
    return {
      id: String(each.id),
      title: line(each.title?.[language] || each.title?.en || each.id, LONGEST),
      closed: each.closed === true,
      working: DOES.includes(each.working) ? each.working : "",
      due: clock(each.due, language),
      ...Object.fromEntries(["all", "given", "collected", "done", "of"].map((name) => [name, whole(each[name])])),
    };
  }

  /** An answer of the server. */
  hear(message) {
    const notice = this._find("notice");
    if (message.wrong) put(notice, this._texts.say(`assign.wrong.${message.wrong}`, { why: line(message.why, LONGEST) }));
    else if (message.do === "new") {
      this._out.close();
      this._choose(String(message.id));
    } else if (message.do === "show" && message.id === this._id) this._showRows(message.rows);
  }

  _choose(id) {
    if (id !== this._id) {
      this._find("rows").replaceChildren();
      this._rows.clear();
    }
    this._id = id;
    this._showList();
    if (id) this._ask({ do: "show", id });
  }

  _showList() {
    const texts = this._texts;
    const list = this._find("list");
    const focused = document.activeElement?.dataset?.id;
    const items = this._list.map((each) => {
      const item = document.createElement("li");
      const button = document.createElement("button");
      button.type = "button";
      button.dataset.id = each.id;
      button.setAttribute("aria-pressed", String(each.id === this._id));
      const about = [texts.say("assign.counts", each), each.due && texts.say("assign.until", { when: each.due }), each.closed && texts.say("assign.ended")];
      const [title, small] = [document.createElement("span"), document.createElement("small")];
      title.textContent = each.title;
      small.textContent = about.filter(Boolean).join(" · ");
      button.append(title, small);
      button.addEventListener("click", () => this._choose(each.id));
      item.append(button);
      return item;
    });
    list.replaceChildren(...items);
    if (focused) list.querySelector(`[data-id="${CSS.escape(focused)}"]`)?.focus();
    this._find("none").hidden = items.length > 0;
    this._showHead();
  }

  _showHead() {
    const texts = this._texts;
    const chosen = this._chosen;
    this._find("one").hidden = !chosen;
    if (!chosen) return;
    put(this._find("which"), chosen.title);
    put(this._find("progress"), chosen.working ? texts.say(`assign.working.${chosen.working}`, chosen) : "");
    for (const what of DOES) this._find(what).disabled = Boolean(chosen.working);
    put(this._find("end"), texts.say(chosen.closed ? "assign.again" : "assign.end"));
    this._find("csv").href = `class/assignments/${encodeURIComponent(chosen.id)}.csv`;
  }

  _showRows(rows) {
    const place = this._find("rows");
    const names = new Set(rows.map((row) => String(row.name)));
    for (const [name, element] of this._rows) {
      if (names.has(name)) continue;
      element.remove();
      this._rows.delete(name);
    }
    rows.forEach((row, at) => {
      const name = String(row.name);
      if (!this._rows.has(name)) this._rows.set(name, this._newRow(name));
      const element = this._rows.get(name);
      if (place.children[at] !== element) place.insertBefore(element, place.children[at] || null);
      this._fill(element, row);
    });
  }

  _newRow(name) {
    const element = fromTemplate("assignment-row", this._texts);
    const shown = line(name);
    put(element.querySelector(".name"), shown);
    const [mark, words] = ["mark", "line"].map((what) => {
      const field = element.querySelector(`.${what}`);
      field.setAttribute("aria-label", this._texts.say(`assign.${what}.of`, { name: shown }));
      return field;
    });
    const keep = () => this._ask({ do: "word", id: this._id, name, mark: mark.value, line: words.value });
    for (const field of [mark, words]) field.addEventListener("change", keep);
    return element;
  }

  _fill(element, row) {
    const texts = this._texts;
    const find = (name) => element.querySelector(`.${name}`);
    const state = STATES.has(row.state) ? row.state : "waiting";
    element.dataset.state = state;
    const values = { collected: clock(row.collected, texts.language), when: clock(row.returned, texts.language), at: whole(row.at) };
    put(find("state"), texts.say(`assign.state.${state}`, values));
    const badges = [
      row.late === true && "late",
      row.changed === true && "changed",
      whole(row.left_out) && "left_out",
      whole(row.unplayed) && "unplayed",
      row.weak === true && "weak",
      row.news === true && "news",
    ].filter(Boolean);
    const said = badges.map((each) => texts.say(`assign.${each}`, { count: whole(row[each]) }));
    this._badges(find("badges"), badges, said);
    put(find("trouble"), line(row.trouble || row.refused, LONGEST));
    put(find("solved"), row.solved === null || !whole(row.steps) ? "" : `${whole(row.solved)}/${whole(row.steps)}`);
    put(find("points"), row.points === null || row.points === undefined ? "" : `${whole(row.points)}/${whole(row.most)}`);
    for (const what of ["mark", "line"]) {
      const field = find(what);
      if (document.activeElement !== field) field.value = line(row[what], 500);
    }
  }

  _badges(place, kinds, said) {
    if (place.dataset.said === said.join("|")) return;
    place.dataset.said = said.join("|");
    place.replaceChildren(...said.map((text, at) => {
      const badge = document.createElement("span");
      badge.className = `badge ${kinds[at]}`;
      badge.textContent = text;
      return badge;
    }));
  }
}
