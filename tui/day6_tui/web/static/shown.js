/**
 * Somebody else's screen beside one's own: the teacher's, or that of a pupil who lets the class see it. It is looked at only; the
 * own desktop goes on beside it, and the pane can always be made small or closed.
 */

import { Connection } from "./connection.js";
import { keepsFocus } from "./key_row.js";
import { Mirror } from "./mirror.js";
import { harmlessScreen, line } from "./rows.js";

const LAYOUTS = ["beside", "corner", "full"];
const CORNERS = ["bottom-right", "bottom-left", "top-left", "top-right"]; // a further press goes to the next one
const LONGEST_LINE = 20_000;
const MOST_COLUMNS = 500;
const MOST_ROWS = 200;
const NOTICE_MS = 8000;

function number(value, most) {
  return Number.isInteger(value) ? Math.min(most, Math.max(0, value)) : 0;
}

/** The lines of a screen that comes piece by piece; each is made harmless, whatever the server has done. */
export class Lines {
  constructor() {
    this.cols = this.rows = 0;
    this._lines = [];
  }

  take({ columns, rows, lines }) {
    const [cols, count] = [number(columns, MOST_COLUMNS), number(rows, MOST_ROWS)];
    if (cols !== this.cols || count !== this.rows) this._lines = [];
    [this.cols, this.rows] = [cols, count];
    for (const [row, text] of Object.entries(lines ?? {})) {
      if (number(Number(row), count) < count && typeof text === "string") this._lines[row] = harmlessScreen(text.slice(0, LONGEST_LINE)).replaceAll("\n", "");
    }
    const ansi = Array.from({ length: count }, (_, row) => this._lines[row] ?? "").join("\n");
    return { cols, rows: count, ansi };
  }
}

export class Shown {
  /**
   * Fills `pane`; `chip` is the button that brings it back. `address` gives the pictures, `memory` keeps the layout, `say(text, ms)`
   * tells something, `leave()` gives the keyboard back to the desktop.
   */
  constructor(pane, chip, address, { memory, say, leave }) {
    this._pane = pane;
    this._chip = chip;
    this._memory = memory;
    this._say = say;
    this._leave = leave;
    this._show = null;
    this._lines = new Lines();
    this._mirror = null;
    this._find = (name) => pane.querySelector(`.${name}`);
    this._connection = new Connection(address, null, {
      hello: () => { this._lines = new Lines(); },
      message: (message) => message.t === "screen" && this._draw(message),
      state() {}, // the line of the desktop says how the connection is, and when this is over
    });
    for (const layout of LAYOUTS) this._button(this._find(layout), () => this._choose(layout));
    this._button(this._find("close"), () => this._close());
    this._button(chip, () => this._open(this._kept("layout", LAYOUTS)));
    pane.addEventListener("mousedown", (event) => event.preventDefault()); // the keyboard stays with the desktop
    this._dragged(this._find("shown-head"));
  }

  _button(button, act) {
    keepsFocus(button);
    button.addEventListener("click", act);
  }

  _kept(name, allowed) {
    const kept = this._memory.get(`shown.${name}`);
    return allowed.includes(kept) ? kept : allowed[0];
  }

  /** The server says what is shown, or that nothing is any more. */
  hear({ on, name, full }, texts) {
    this._texts = texts;
    const was = this._show;
    this._show = on === true ? { name: line(name), full: full === true } : null;
    if (!this._show) {
      this.end();
      if (was) this._say(texts.say("shown.over"), NOTICE_MS);
      return;
    }
    const isOther = was?.name !== this._show.name || was.full !== this._show.full;
    if (!was) this._say("", 0); // that the one before is over
    if (isOther) this._open(this._show.full ? "full" : this._kept("layout", ["beside", "corner"]));
    this.write(texts);
  }

  /** Nothing is shown here any more. */
  end() {
    this._show = null;
    this._connection.close();
    this._hide();
    this._chip.hidden = true;
  }

  /** In another language. */
  write(texts) {
    this._texts = texts;
    if (!this._show) return;
    this._find("shown-name").textContent = this._title();
    this._pane.setAttribute("aria-label", this._title());
    this._chip.textContent = this._title();
  }

  _title() {
    const { name } = this._show;
    return name ? this._texts.say("shown.pupil", { name }) : this._texts.say("shown.teacher");
  }

  _open(layout) {
    if (this._pane.hidden) {
      this._pane.hidden = false;
      this._mirror = new Mirror(this._find("mirror"));
      this._connection.open();
    }
    this._chip.hidden = true;
    this._lay(layout);
  }

  _lay(layout) {
    this._pane.dataset.layout = layout;
    this._pane.dataset.corner = this._kept("corner", CORNERS);
    for (const each of LAYOUTS) this._find(each).setAttribute("aria-pressed", String(each === layout));
  }

  _choose(layout) {
    const isAgain = layout === "corner" && this._pane.dataset.layout === "corner";
    if (isAgain) this._moveTo(CORNERS[(CORNERS.indexOf(this._pane.dataset.corner) + 1) % CORNERS.length]);
    if (layout !== "full") this._memory.set("shown.layout", layout);
    this._lay(layout);
  }

  _moveTo(corner) {
    this._memory.set("shown.corner", corner);
    this._pane.dataset.corner = corner;
  }

  /** Drag the head: the pane goes to the corner where it is let go. */
  _dragged(head) {
    let from = null;
    const end = () => {
      from = null;
      this._pane.style.transform = "";
    };
    head.addEventListener("pointerdown", (event) => {
      if (this._pane.dataset.layout !== "corner" || event.target.closest("button")) return;
      from = event;
      head.setPointerCapture(event.pointerId);
    });
    head.addEventListener("pointermove", (event) => {
      if (from) this._pane.style.transform = `translate(${event.clientX - from.clientX}px, ${event.clientY - from.clientY}px)`;
    });
    head.addEventListener("pointerup", () => {
      if (!from) return;
      const { x, y, width, height } = this._pane.getBoundingClientRect();
      const room = this._pane.parentElement.getBoundingClientRect();
      const [isLeft, isTop] = [x + width / 2 < room.x + room.width / 2, y + height / 2 < room.y + room.height / 2];
      this._moveTo(`${isTop ? "top" : "bottom"}-${isLeft ? "left" : "right"}`);
      end();
    });
    head.addEventListener("pointercancel", end);
  }

  _draw(message) {
    const done = () => this._connection.tell({ t: "ack" });
    const screen = this._lines.take(message);
    this._pane.style.setProperty("--ratio", `${screen.cols} / ${2 * screen.rows}`); // a cell is twice as high as wide
    this._mirror?.show(screen, { done });
  }

  _close() {
    this._connection.close();
    this._hide();
    this._chip.hidden = false;
    this._leave();
  }

  _hide() {
    this._pane.hidden = true;
    this._mirror?.close();
    this._mirror = null;
  }
}
