/** Somebody else's screen as a picture of any size: a terminal that is written to and answers nothing. */

import { Terminal } from "./vendor/xterm/xterm.mjs";
import { UnicodeGraphemesAddon } from "./vendor/xterm/addon-unicode-graphemes.mjs";
import { FONTS } from "./fonts.js";

const LETTERS = 12;

export class Mirror {
  /** Draws into `place`. With `typed`, keys pressed in it are handed over as the bytes of a terminal. */
  constructor(place, typed = null) {
    this._place = place;
    this._shown = "";
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

  show({ cols, rows, ansi }) {
    const shown = `${cols}x${rows} ${ansi}`;
    if (shown === this._shown) return;
    this._shown = shown;
    if (this._terminal.cols !== cols || this._terminal.rows !== rows) this._terminal.resize(cols, rows);
    const lines = ansi.replace(/\n$/, "").split("\n").slice(0, rows);
    while (lines.length < rows) lines.push("");
    const text = lines.map((line, number) => `\x1b[${number + 1};1H\x1b[0m\x1b[2K${line}`).join("");
    this._terminal.write(`\x1b[?25l\x1b[?7l${text}`);
  }

  /** Take the picture away. Written, not reset: what was written before is drawn later and would come back. */
  clear() {
    if (!this._shown) return;
    this._shown = "";
    this._terminal.write("\x1b[2J");
  }

  _scale() {
    const { offsetWidth, offsetHeight } = this._area;
    const { clientWidth, clientHeight } = this._place;
    if (!offsetWidth || !offsetHeight || !clientWidth) return;
    if (!clientHeight) return;
    const scale = Math.min(clientWidth / offsetWidth, clientHeight / offsetHeight);
    const [left, top] = [clientWidth - offsetWidth * scale, clientHeight - offsetHeight * scale].map((rest) => rest / 2);
    const { style } = this._terminal.element;
    style.transformOrigin = "0 0";
    style.transform = `translate(${left}px, ${top}px) scale(${scale})`;
  }

  close() {
    this._observer.disconnect();
    this._terminal.dispose();
  }
}
