/** What the desktops take of the server's machine: a table while it is open, and always a line about what becomes short. */

import { put } from "./pupil_card.js";
import { line } from "./rows.js";

const ASK_MS = 4000;
const MB = 2 ** 20;

const inMB = (bytes) => (bytes < 10 * MB ? (bytes / MB).toFixed(1) : String(Math.round(bytes / MB)));

/** The columns: how a row is shown, and by what it is sorted. What was not measured is a dash, and comes last. */
const COLUMNS = {
  name: { value: (row) => row.shownName },
  memory: { value: (row) => row.memory, shown: (row) => `${inMB(row.memory)} MB` },
  cpu: { value: (row) => row.cpu, shown: (row) => `${(row.cpu * 100).toFixed(1)} %` },
  processes: { value: (row) => row.processes, shown: (row) => String(row.processes) },
  disk: { value: (row) => row.disk, shown: (row, most) => `${inMB(row.disk)} / ${inMB(most.disk)} MB` },
};

export class Machine {
  /** `tell(message)` sends to the server, if there is a line. */
  constructor(dialog, button, warning, tell) {
    this._dialog = dialog;
    this._warning = warning;
    this._tell = tell;
    this._sorted = { by: "memory", up: false };
    this._machine = null;
    button.addEventListener("click", () => {
      dialog.showModal();
      this._ask();
    });
    dialog.querySelector(".close").addEventListener("click", () => dialog.close());
    for (const head of dialog.querySelectorAll("th button")) head.addEventListener("click", () => this._sort(head.dataset.by));
    setInterval(() => this._ask(), ASK_MS);
  }

  get isOpen() {
    return this._dialog.open;
  }

  _ask() {
    if (this.isOpen && !document.hidden) this._tell({ t: "measure" });
  }

  _sort(by) {
    const up = this._sorted.by === by ? !this._sorted.up : by === "name";
    this._sorted = { by, up };
    this._showTable();
  }

  show(machine, texts) {
    this._texts = texts;
    const warnings = (Array.isArray(machine?.warnings) ? machine.warnings : []).map((each) => line(each, 300));
    const text = warnings.join(texts.say("news.between"));
    put(this._warning, text);
    this._warning.hidden = !text;
    if (!Array.isArray(machine?.desktops)) return;
    this._machine = machine;
    if (this.isOpen) this._showTable();
  }

  _showTable() {
    const { _machine: machine, _texts: texts } = this;
    if (!machine) return;
    const { memory, disk, cores, room } = machine;
    const sum = [
      ...(memory ? [texts.say("machine.memory", { free: Math.round(memory.free / MB), total: Math.round(memory.total / MB) })] : []),
      ...(Number.isFinite(disk) ? [texts.say("machine.disk", { free: Math.round(disk / MB) })] : []),
      texts.say("machine.cores", { cores }),
    ];
    this._dialog.querySelector(".sum").textContent = sum.join(" · ");
    this._dialog.querySelector(".room").textContent = [line(room, 300), ...(machine.measured ? [] : [texts.say("machine.unmeasured")])].join(" ");
    for (const head of this._dialog.querySelectorAll("thead th")) {
      const isBy = head.firstElementChild.dataset.by === this._sorted.by;
      head.setAttribute("aria-sort", isBy ? (this._sorted.up ? "ascending" : "descending") : "none");
    }
    const rows = machine.desktops.map((row) => ({ ...row, shownName: row.teacher ? texts.say("class.mine") : line(row.name) }));
    this._dialog.querySelector("tbody").replaceChildren(...this._ordered(rows).map((row) => this._row(row)));
  }

  _ordered(rows) {
    const { by, up } = this._sorted;
    const { value } = COLUMNS[by];
    const known = (row) => value(row) !== undefined && value(row) !== null;
    const compared = (a, b) => (by === "name" ? value(a).localeCompare(value(b), this._texts.language) : value(a) - value(b));
    const sorted = rows.filter(known).sort((a, b) => (up ? compared(a, b) : compared(b, a)));
    return [...sorted, ...rows.filter((row) => !known(row))];
  }

  _row(row) {
    const made = document.createElement("tr");
    for (const [name, { value, shown }] of Object.entries(COLUMNS)) {
      const cell = document.createElement(name === "name" ? "th" : "td");
      if (name === "name") cell.scope = "row";
      const isKnown = name === "name" || Number.isFinite(value(row));
      cell.textContent = !isKnown ? "–" : shown ? shown(row, this._machine.most) : value(row);
      made.append(cell);
    }
    return made;
  }
}
