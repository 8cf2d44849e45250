/**
 * What a screen reader hears of the terminal: the new lines of the pane that has the keyboard, in a polite live region.
 *
 * The terminal's own mode for screen readers says every cell that is drawn anew, which on a desktop of panes is most of the time
 * something else. The pane with the keyboard is the one whose frame is heavy.
 */

const QUIET_MS = 250; // a line may come in parts
const LATEST_MS = 1500; // and some programs never rest
const MOST_LINES = 12; // at a time: more nobody listens to
const KEPT_LINES = 60; // for who goes back in them
const SECOND_HALF = "\u200b"; // of a wide character
const FRAME = { left: "┏", right: "┓", side: "┃", below: "┗", foot: "┛" };

/** The pane with a heavy frame: {which, title, lines} without its last, empty lines; everything where no pane has one. */
export function paneOf(rows, cursor) {
  const columns = rows.map((row) => [...row]);
  let found = null;
  for (let top = 0; top < rows.length; top++) {
    for (let left = columns[top].indexOf(FRAME.left); left >= 0; left = columns[top].indexOf(FRAME.left, left + 1)) {
      const right = columns[top].indexOf(FRAME.right, left);
      let foot = top + 1;
      while (foot < rows.length && columns[foot][left] === FRAME.side) foot++;
      if (right < 0 || foot >= rows.length || columns[foot][left] !== FRAME.below) continue;
      found = { left, right, top, foot }; // of several the last: a question lies below the line of its pane
    }
  }
  const inner = (row, left, right) => (row === cursor ? "" : columns[row].slice(left, right).join("").replaceAll(SECOND_HALF, "").trim());
  if (!found) return { which: "", title: "", lines: trimmed(rows.map((row, at) => inner(at, 0, row.length))) };
  const { left, right, top, foot } = found;
  const lines = [];
  for (let row = top + 1; row < foot; row++) lines.push(inner(row, left + 1, right));
  const title = inner(top, left + 1, right).replace(/[━×\s]+/g, " ").trim();
  const number = /^\d*/.exec(title)[0]; // a terminal's title says what runs in it, and changes with that
  return { which: [left, right, top, foot, number].join(" "), title, lines: trimmed(lines) };
}

function trimmed(lines) {
  const last = lines.findLastIndex((text) => text !== "");
  return lines.slice(0, last + 1);
}

/** The lines that came: what follows the old ones after they moved up, else all that were not there. */
export function newLines(before, now) {
  for (let moved = 0; moved < before.length; moved++) {
    const rest = before.slice(moved);
    if (rest.every((text, at) => now[at] === text)) return now.slice(rest.length).filter(Boolean);
  }
  const known = new Map();
  for (const text of before) known.set(text, (known.get(text) || 0) + 1);
  return now.filter((text) => {
    const count = known.get(text) || 0;
    known.set(text, count - 1);
    return text !== "" && count < 1;
  });
}

export class Speaker {
  /** `log` is the live region; `more(count)` is the sentence about lines that are left out. */
  constructor(terminal, log, more) {
    this._terminal = terminal;
    this._log = log;
    this._more = more;
    this._listener = null;
    this._timer = 0;
    this._since = 0;
  }

  get isOn() {
    return this._listener !== null;
  }

  set isOn(on) {
    if (on === this.isOn) return;
    if (!on) {
      this._listener.dispose();
      this._listener = null;
      clearTimeout(this._timer);
      this._since = 0;
      this._log.replaceChildren();
      return;
    }
    this._before = { which: null, lines: [] };
    this._listener = this._terminal.onWriteParsed(() => this._soon());
    this._soon();
  }

  _soon() {
    const now = performance.now();
    this._since ||= now;
    clearTimeout(this._timer);
    this._timer = setTimeout(() => this._look(), Math.min(QUIET_MS, Math.max(0, this._since + LATEST_MS - now)));
  }

  _look() {
    this._since = 0;
    const buffer = this._terminal.buffer.active;
    const rows = Array.from({ length: this._terminal.rows }, (_, at) => cellsOf(buffer.getLine(buffer.viewportY + at)));
    const pane = paneOf(rows, buffer.cursorY);
    const isSame = pane.which === this._before.which;
    const lines = isSame ? newLines(this._before.lines, pane.lines) : [pane.title, ...pane.lines].filter(Boolean);
    this._before = pane;
    const left = lines.length - MOST_LINES;
    this._say(left > 0 ? [this._more(left), ...lines.slice(left)] : lines);
  }

  _say(lines) {
    for (const text of lines) {
      const line = document.createElement("p");
      line.textContent = text;
      this._log.append(line);
    }
    while (this._log.childElementCount > KEPT_LINES) this._log.firstElementChild.remove();
  }
}

/** A line as text in which each cell is one place: the second half of a wide character is none, and a blank otherwise. */
function cellsOf(line) {
  let text = "";
  for (let x = 0; line && x < line.length; x++) {
    const cell = line.getCell(x);
    const chars = cell.getChars();
    text += cell.getWidth() === 0 ? SECOND_HALF : [...chars].length === 1 ? chars : chars ? [...chars][0] : " ";
  }
  return text;
}
