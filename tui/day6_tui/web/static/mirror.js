/** Somebody else's screen as a picture of any size: a terminal that is written to and answers nothing. */

import { Terminal } from "./vendor/xterm/xterm.mjs";
import { UnicodeGraphemesAddon } from "./vendor/xterm/addon-unicode-graphemes.mjs";
import { FONTS } from "./fonts.js";

const LETTERS = 12;
const READABLE = 0.75; // of the letters: smaller ones cannot be read
const BELOW = 2; // lines below the one that counts

export class Mirror {
  /** Draws into `place`. With `typed`, keys pressed in it are handed over as the bytes of a terminal. */
  constructor(place, typed = null) {
    this._place = place;
    this._lines = [];
    this._zooms = false;
    this._work = null;
    this._terminal = new Terminal({
      allowProposedApi: true,
      cols: 80,
      rows: 24,
      cursorInactiveStyle: "none",
      disableStdin: !typed,
      fontFamily: FONTS,
      fontSize: LETTERS,
      linkHandler: { activate() {} }, // what a pupil's program calls a link is none
      logLevel: "off",
      scrollback: 0,
      theme: { background: "#0c0c0c", foreground: "#d8d8d8" },
    });
    this._terminal.loadAddon(new UnicodeGraphemesAddon());
    this._terminal.open(place);
    this._area = this._terminal.element.querySelector(".xterm-screen");
    if (typed) this._terminal.onData(typed);
    else this._terminal.textarea.tabIndex = -1;
    this._observer = new ResizeObserver(() => this._scale());
    this._observer.observe(place);
    this._observer.observe(this._area);
  }

  /**
   * Draw what has changed; `done()` is called when it is drawn. With `zooms`, what would be too small to be read gives way to the
   * part in which the pupil works.
   */
  show({ cols, rows, ansi, work }, { zooms = false, done = () => {} } = {}) {
    const place = JSON.stringify([zooms, work]);
    if (place !== this._lookedAt) {
      this._lookedAt = place;
      [this._zooms, this._work] = [zooms, work];
      this._scale();
    }
    const isSameSize = this._terminal.cols === cols && this._terminal.rows === rows;
    if (!isSameSize) this._terminal.resize(cols, rows);
    const lines = ansi.replace(/\n$/, "").split("\n").slice(0, rows);
    while (lines.length < rows) lines.push("");
    const old = isSameSize ? this._lines : [];
    const drawn = lines.map((line, number) => (line === old[number] ? "" : `\x1b[${number + 1};1H\x1b[0m\x1b[2K${line}`)).join("");
    this._lines = lines;
    if (drawn) this._terminal.write(`\x1b[?25l\x1b[?7l${drawn}`, done);
    else done();
  }

  /** Take the picture away. Written, not reset: what was written before is drawn later and would come back. */
  clear() {
    if (!this._lines.length) return;
    this._lines = [];
    this._terminal.write("\x1b[2J");
  }

  _scale() {
    const { offsetWidth, offsetHeight } = this._area;
    const { clientWidth, clientHeight } = this._place;
    if (!offsetWidth || !offsetHeight || !clientWidth) return;
    if (!clientHeight) return;
    const whole = Math.min(clientWidth / offsetWidth, clientHeight / offsetHeight);
    const zoom = this._zooms && this._work && whole < READABLE ? this._zoomed(offsetWidth, offsetHeight) : null;
    const scale = zoom?.scale ?? whole;
    const [left, top] = zoom?.at ?? [clientWidth - offsetWidth * scale, clientHeight - offsetHeight * scale].map((rest) => rest / 2);
    const { style } = this._terminal.element;
    style.transformOrigin = "0 0";
    style.transform = `translate(${left}px, ${top}px) scale(${scale})`;
  }

  /** Where the left end of the line that counts is to be seen, with letters that can be read. */
  _zoomed(width, height) {
    const { clientWidth, clientHeight } = this._place;
    const { x, y, cols, rows, line } = this._work;
    const [across, down] = [width / this._terminal.cols, height / this._terminal.rows];
    const scale = Math.max(READABLE, Math.min(1, clientWidth / (cols * across), clientHeight / (rows * down)));
    const seen = clientHeight / (down * scale); // lines
    const first = Math.max(y, Math.min(line + 1 + BELOW, y + rows) - seen);
    return { scale, at: [-x * across * scale, -first * down * scale] };
  }

  close() {
    this._observer.disconnect();
    this._terminal.dispose();
  }
}
