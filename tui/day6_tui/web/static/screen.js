/** The terminal on the page: xterm.js with the addons the desktop needs, drawn by the graphics card where there is one. */

import { FONTS, fillCells } from "./fonts.js";
import { Terminal } from "./vendor/xterm/xterm.mjs";
import { FitAddon } from "./vendor/xterm/addon-fit.mjs";
import { UnicodeGraphemesAddon } from "./vendor/xterm/addon-unicode-graphemes.mjs";
import { ImageAddon } from "./vendor/xterm/addon-image.mjs";
import { WebglAddon } from "./vendor/xterm/addon-webgl.mjs";
import { ClipboardAddon } from "./vendor/xterm/addon-clipboard.mjs";

const LEAST = { cols: 20, rows: 5 };
const MOST = { cols: 500, rows: 200 };
const SMALLEST_LETTERS = 6;
const LARGEST_LETTERS = 40;
const LARGEST_SCALE = 2;
const WORD = /^[\p{L}\p{N}\p{M}/_.:~+-]/u; // names, paths and numbers

export function clamp(value, least, most) {
  return Math.min(most, Math.max(least, value));
}

/** A graphics card, not a processor that pretends to be one. */
function hasFastGraphics() {
  const context = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

/**
 * Fill the clipboard; returns whether the browser did it. Where the page is not https and not this machine, browsers allow it only
 * soon after a key or click.
 */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const answer = (event) => {
      event.preventDefault();
      event.stopPropagation();
      event.clipboardData.setData("text/plain", text);
    };
    document.addEventListener("copy", answer, { capture: true, once: true });
    const done = document.execCommand("copy");
    document.removeEventListener("copy", answer, { capture: true });
    return done;
  }
}

/** Pasted text without control characters: it could hold the mark at its own end, or press keys. */
export function harmless(text) {
  return text.replace(/\r\n?/g, "\n").replace(/[\x00-\x08\x0b-\x1f\x7f-\x9f]/g, "");
}

export class Screen {
  /** Opens a terminal in `place`; `changed()` is called when the number of cells changed, `copies(text)` when a program copies. */
  constructor(place, { fontSize, label, renderer = "auto", changed, copies }) {
    this._place = place;
    this._changed = changed;
    this._whole = false;
    this.terminal = new Terminal({
      allowProposedApi: true,
      altClickMovesCursor: false,
      cursorBlink: false,
      customGlyphs: true,
      fontFamily: FONTS,
      fontSize,
      logLevel: "off",
      macOptionClickForcesSelection: true,
      macOptionIsMeta: true,
      rescaleOverlappingGlyphs: true,
      scrollback: 0,
      theme: { background: "#0c0c0c", foreground: "#d8d8d8" },
    });
    this._fit = new FitAddon();
    this.terminal.loadAddon(this._fit);
    this.terminal.loadAddon(new UnicodeGraphemesAddon());
    this.terminal.loadAddon(new ClipboardAddon(undefined, {
      readText: () => "", // programs may fill the clipboard (OSC 52), never read it
      writeText: (_selection, text) => copies(text),
    }));
    this.terminal.open(place);
    this.terminal.loadAddon(new ImageAddon({ storageLimit: 32, showPlaceholder: false, iipSupport: false }));
    this.terminal.textarea.setAttribute("aria-label", label);
    this._area = this.terminal.element.querySelector(".xterm-screen");
    this._draw(renderer);
    this.fit();
    this._fillCells();
    new ResizeObserver(() => this.fit()).observe(place);
    new ResizeObserver(() => this._whole && this._shrink()).observe(this._area);
  }

  _draw(renderer) {
    this.renderer = "dom";
    if (renderer === "dom" || (renderer === "auto" && !hasFastGraphics())) return;
    try {
      const webgl = new WebglAddon();
      webgl.onContextLoss(() => {
        webgl.dispose();
        this.renderer = "dom";
      });
      this.terminal.loadAddon(webgl);
      this.renderer = "webgl";
    } catch (error) {
      console.warn("drawing without WebGL:", error);
    }
  }

  /** Where the graphics card draws, a cell is a whole number of pixels, and narrower than two letters are. */
  async _fillCells() {
    if (this.renderer !== "webgl") return;
    const { w, cols } = this.size();
    await fillCells((2 * w) / cols / this.fontSize);
    this.terminal.clearTextureAtlas();
  }

  /** As many cells as there is room for; a screen of somebody else is made to fit as a picture. */
  fit() {
    if (this._whole) {
      this._shrink();
      return;
    }
    const proposed = this._fit.proposeDimensions();
    if (!proposed || !Number.isFinite(proposed.cols) || !Number.isFinite(proposed.rows)) return;
    this.resize(clamp(proposed.cols, LEAST.cols, MOST.cols), clamp(proposed.rows, LEAST.rows, MOST.rows));
  }

  resize(cols, rows) {
    const { terminal } = this;
    if (terminal.cols === cols && terminal.rows === rows) return;
    terminal.resize(cols, rows);
    this._changed();
  }

  /** Show so many cells, whatever the room; `whole`: as small as it has to be, for somebody else's screen. */
  show(cols, rows, whole) {
    this.terminal.resize(clamp(cols, 1, MOST.cols), clamp(rows, 1, MOST.rows));
    this._whole = whole;
    if (whole) this._shrink();
  }

  _shrink() {
    const { w, h } = this.size();
    const { clientWidth, clientHeight } = this._place;
    if (!w || !h) return;
    const { style } = this.terminal.element;
    style.transformOrigin = "0 0";
    style.transform = `scale(${Math.min(clientWidth / w, clientHeight / h, LARGEST_SCALE)})`;
  }

  /** Cells and pixels. */
  size() {
    const { offsetWidth, offsetHeight } = this._area;
    return { cols: this.terminal.cols, rows: this.terminal.rows, w: offsetWidth, h: offsetHeight };
  }

  /** Pixels of a row as it is seen. */
  get rowHeight() {
    return this._area.getBoundingClientRect().height / this.terminal.rows;
  }

  /** Where the word at a point of the page begins and ends: two points in the middles of cells; null where there is none. */
  wordAt(x, y) {
    const { left, top, width, height } = this._area.getBoundingClientRect();
    const { cols, rows, buffer } = this.terminal;
    const [column, row] = [Math.floor(((x - left) * cols) / width), Math.floor(((y - top) * rows) / height)];
    const line = buffer.active.getLine(buffer.active.viewportY + row);
    const isWord = (at) => {
      const cell = at >= 0 && at < cols ? line?.getCell(at) : undefined;
      return cell !== undefined && (cell.getWidth() === 0 || WORD.test(cell.getChars()));
    };
    if (!isWord(column)) return null;
    let [first, last] = [column, column];
    while (isWord(first - 1)) first--;
    while (isWord(last + 1)) last++;
    const middle = (at) => ({ clientX: left + ((at + 0.5) * width) / cols, clientY: top + ((row + 0.5) * height) / rows });
    return [middle(first), middle(last)];
  }

  get fontSize() {
    return this.terminal.options.fontSize;
  }

  set fontSize(size) {
    const { cols, rows } = this.terminal;
    this.terminal.options.fontSize = clamp(size, SMALLEST_LETTERS, LARGEST_LETTERS);
    this.fit();
    this._fillCells();
    if (this.terminal.cols === cols && this.terminal.rows === rows) this._changed(); // other pixels, all the same
  }

  paste(text) {
    this.terminal.paste(harmless(text));
  }
}
