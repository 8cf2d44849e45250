/** The page of a desktop: the terminal, its connection, the tools around it. */

import { Connection } from "./connection.js";
import { KeyRow, keepsFocus } from "./key_row.js";
import { meaning } from "./keys.js";
import { Notice } from "./notice.js";
import { Screen, copyText } from "./screen.js";
import { Strip } from "./strip.js";
import { Texts, language } from "./texts.js";
import { fingersAreAMouse, keepVisible } from "./touch.js";

const NARROW = 600; // CSS pixels: phones
const MIDDLE = 1000; // tablets
const NOTICE_MS = 2500;
const HINT_MS = 8000; // a sentence that says what to do

const at = (id) => document.getElementById(id);
const touching = matchMedia("(pointer: coarse)").matches;

/** What this browser remembers; nothing where it must not. */
const memory = {
  get(name) {
    try { return localStorage.getItem(`day6.${name}`); } catch { return null; }
  },
  set(name, value) {
    try { localStorage.setItem(`day6.${name}`, value); } catch { /* private browsing: forgotten with the tab */ }
  },
};

class Desk {
  constructor() {
    this._query = new URLSearchParams(location.search);
    this._texts = new Texts(this._query.get("lang") || navigator.language);
    this._readOnly = false;
    this._row = null;
    this._copied = ""; // what the desktop copied last: it is still marked there
    this._notice = new Notice(at("notice"));
    this._strip = new Strip(at("strip"), () => this._connection.open());
    keepVisible();
    this._screen = new Screen(at("screen"), {
      fontSize: this._firstFontSize(),
      label: this._texts.say("screen.label"),
      renderer: this._query.get("renderer") || "auto",
      changed: () => this._connection?.resized(),
      copies: (text) => this._copies(text),
    });
    this._terminal = this._screen.terminal;
    const address = location.pathname.endsWith("/watch") ? "ws?watch=1" : "ws"; // a pupil may watch another one
    this._connection = new Connection(address, () => this._screen.size(), {
      hello: (message) => this._hello(message),
      output: (bytes, done) => this._terminal.write(bytes, done),
      size: (cols, rows) => this._screen.show(cols, rows, this._readOnly),
      latency: (ms) => this._showLatency(ms),
      state: (name, count) => {
        const shown = name === "left" && this._readOnly ? "left_by_pupil" : name;
        this._strip.show(shown, count, this._texts);
      },
    });
    this._listen();
    this._tools();
    this._write();
    this._showKeys(memory.get("keys") === null ? touching : memory.get("keys") === "yes");
    this._terminal.focus();
    this._connection.open();
  }

  _firstFontSize() {
    const kept = Number(memory.get("font"));
    if (kept) return kept;
    return innerWidth < NARROW ? 11 : innerWidth < MIDDLE ? 13 : 15;
  }

  _hello({ name, read_only: readOnly, lang }) {
    this._terminal.reset();
    this._readOnly = Boolean(readOnly);
    this._terminal.options.disableStdin = this._readOnly;
    if (lang && language(lang) !== this._texts.language) {
      this._texts = new Texts(lang);
      this._write();
    }
    at("who").textContent = name || "";
    at("watching").hidden = !this._readOnly;
    document.body.classList.toggle("watching", this._readOnly);
    if (name) document.title = `${name} · day6`;
    this._terminal.focus();
  }

  _listen() {
    const send = (data) => {
      if (!this._readOnly) this._connection.keys(data);
    };
    this._terminal.onData((text) => send(this._row.modified(text)));
    this._terminal.onBinary((text) => send(Uint8Array.from(text, (char) => char.charCodeAt(0))));
    this._terminal.attachCustomKeyEventHandler((event) => this._key(event));
    this._keepFocus();
    const place = at("screen");
    place.addEventListener("paste", (event) => {
      event.preventDefault();
      event.stopPropagation();
      this._screen.paste(event.clipboardData?.getData("text/plain") || "");
    }, true);
    place.addEventListener("contextmenu", (event) => {
      if (this._terminal.modes.mouseTrackingMode !== "none" && !event.shiftKey) event.preventDefault();
    });
    fingersAreAMouse(place, () => place.clientHeight / this._terminal.rows);
  }

  /** Keys belong to the terminal wherever the focus went, except in a dialog and among the tools. */
  _keepFocus() {
    addEventListener("focus", () => this._terminal.focus());
    document.addEventListener("keydown", (event) => {
      if (event.target.closest?.("dialog, .xterm")) return;
      if (event.target.closest?.("button") && ["Tab", "Enter", " ", "Escape"].includes(event.key)) {
        if (event.key === "Escape") this._terminal.focus();
        return;
      }
      this._terminal.focus();
      if (event.key.startsWith("F") && meaning(event) !== "browser") event.preventDefault(); // F5 must not reload
    }, true);
  }

  /** Whether the terminal shall treat a key itself. */
  _key(event) {
    const what = meaning(event);
    if (what === null) return true;
    if (what === "browser" || what === "paste" || event.type !== "keydown") return false;
    event.preventDefault();
    if (what === "copy") this._copy();
    else if (what === "tools") at("smaller").focus();
    else this._terminal.input(what.text);
    return false;
  }

  /** The desktop copies: a plain drag in one of its panes does it at once. */
  async _copies(text) {
    if (!text) return;
    this._copied = text;
    const done = await copyText(text);
    this._say(done ? "copied" : "copy_needs_click", done ? NOTICE_MS : HINT_MS);
  }

  /** What is selected on this page, or else in the desktop. */
  async _copy() {
    const text = this._terminal.getSelection() || this._copied;
    if (text && (await copyText(text))) this._say("copied", NOTICE_MS);
    else this._say(touching ? "nothing_selected.touch" : "nothing_selected", HINT_MS);
  }

  /** Paste with a button: browsers show the clipboard only to https and this machine, else a field takes it. */
  async _paste() {
    try {
      this._screen.paste(await navigator.clipboard.readText());
      this._terminal.focus();
    } catch {
      at("paste-text").value = "";
      at("paste-dialog").showModal();
    }
  }

  _tools() {
    const tools = {
      smaller: () => this._zoom(-1),
      larger: () => this._zoom(1),
      "show-keys": () => {
        this._showKeys(at("keys").hidden);
        memory.set("keys", at("keys").hidden ? "no" : "yes");
      },
      keyboard: () => this._softKeyboard(),
      copy: () => this._copy(),
      paste: () => this._paste(),
      full: () => this._fullScreen(),
      help: () => at("help-dialog").showModal(),
    };
    for (const [id, act] of Object.entries(tools)) {
      keepsFocus(at(id));
      at(id).addEventListener("click", act);
    }
    at("full").hidden = !document.documentElement.requestFullscreen;
    at("keyboard").hidden = !touching;
    at("paste-dialog").addEventListener("close", () => {
      if (at("paste-dialog").returnValue === "send") this._screen.paste(at("paste-text").value);
      this._terminal.focus();
    });
    at("help-dialog").addEventListener("close", () => this._terminal.focus());
  }

  _zoom(step) {
    this._screen.fontSize += step;
    memory.set("font", this._screen.fontSize);
  }

  _showKeys(shown) {
    at("keys").hidden = !shown;
    at("show-keys").setAttribute("aria-pressed", String(shown));
    this._screen.fit();
  }

  _softKeyboard() {
    const area = this._terminal.textarea;
    const away = area.inputMode !== "none";
    area.blur();
    area.inputMode = away ? "none" : "text";
    area.focus();
  }

  async _fullScreen() {
    if (document.fullscreenElement) {
      await document.exitFullscreen();
      return;
    }
    await document.documentElement.requestFullscreen();
    await navigator.keyboard?.lock?.(["KeyW", "KeyT", "KeyN", "KeyQ", "Escape"]); // Chromium only
    this._terminal.focus();
  }

  _showLatency(ms) {
    const place = at("latency");
    place.textContent = this._texts.say("bar.latency", { ms: Math.round(ms) });
    place.dataset.slow = String(ms > 150);
  }

  _say(key, milliseconds) {
    this._notice.show(this._texts.say(key), milliseconds);
  }

  /** Everything that is written on the page, in its language. */
  _write() {
    const texts = this._texts;
    texts.write(document);
    this._terminal.textarea.setAttribute("aria-label", texts.say("screen.label"));
    const lines = texts.lines("help.lines").map((line) => {
      const item = document.createElement("li");
      item.textContent = line;
      return item;
    });
    at("help-lines").replaceChildren(...lines);
    at("keys").replaceChildren();
    const mode = () => this._terminal.modes.applicationCursorKeysMode;
    this._row = new KeyRow(at("keys"), texts, (text) => this._terminal.input(text), mode);
  }
}

window.desk = new Desk(); // named for whoever looks with the browser's own tools, and for the tests
