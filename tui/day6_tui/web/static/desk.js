/** The page of a desktop: the terminal, its connection, the tools around it. */

import { Connection } from "./connection.js";
import { KeyChooser } from "./key_chooser.js";
import { KeyRow, chosenKeys, keepsFocus } from "./key_row.js";
import { meaning } from "./keys.js";
import { memory } from "./memory.js";
import { Notice } from "./notice.js";
import { PageLink } from "./page_link.js";
import { Screen, copyText } from "./screen.js";
import { Shown } from "./shown.js";
import { Speaker } from "./speak.js";
import { Strip } from "./strip.js";
import { Texts, language } from "./texts.js";
import { fingersAreAMouse, keepVisible } from "./touch.js";

const NARROW = 600; // CSS pixels: phones
const MIDDLE = 1000; // tablets
const HOPEFUL = new Set(["connecting", "open"]); // of the connection: the desktop may be about to come
const NOTICE_MS = 2500;
const OPENS = 7701; // the number of the sequence by which the desktop opens a link
const HINT_MS = 8000; // a sentence that says what to do

const GOES_ON = new Set(["open", "connecting", "lost", "offline", "server", "full", "restart"]); // the page comes back by itself

const at = (id) => document.getElementById(id);
const touching = matchMedia("(pointer: coarse)").matches;

class Desk {
  constructor() {
    this._query = new URLSearchParams(location.search);
    this._texts = new Texts(this._query.get("lang") || navigator.language);
    this._readOnly = false;
    this._row = null;
    this._isDrawn = false; // whether the desktop has shown a picture since it was started
    this._copied = ""; // what the desktop copied last: it is still marked there
    this._notice = new Notice(at("notice"));
    this._strip = new Strip(at("strip"), () => this._connection.open());
    this._link = new PageLink(at("link"), () => this._terminal.focus());
    keepVisible();
    this._screen = new Screen(at("screen"), {
      fontSize: this._firstFontSize(),
      label: this._texts.say("screen.label"),
      renderer: this._query.get("renderer") || "auto",
      changed: () => this._connection?.resized(),
      copies: (text) => this._copies(text),
    });
    this._terminal = this._screen.terminal;
    const page = location.pathname.split("/").at(-1);
    this._isMine = page === "mine"; // the teacher's own
    const whose = new URLSearchParams(this._query.has("who") ? { who: this._query.get("who") } : {});
    if (page === "watch" || page === "mine") whose.set(page, "1"); // a pupil may watch another one
    this._shown = new Shown(at("shown"), at("shown-again"), `shown?${whose}`, {
      memory,
      say: (text, milliseconds) => this._notice.show(text, milliseconds),
      leave: () => this._terminal.focus(),
    });
    this._terminal.parser.registerOscHandler(OPENS, (text) => this._open(text));
    this._connection = new Connection(`ws?${whose}`, () => this._screen.size(), {
      hello: (message) => this._hello(message),
      output: (bytes, done) => this._terminal.write(bytes, () => {
        if (!this._isDrawn) this._lookForPicture();
        done();
      }),
      message: (message) => {
        if (message.t === "starting") this._starts(message);
        else if (message.t === "show") this._shown.hear(message, this._texts);
      },
      size: (cols, rows) => this._screen.show(cols, rows, this._readOnly),
      latency: (ms) => this._showLatency(ms),
      state: (name, count) => {
        if (!GOES_ON.has(name)) this._shown.end();
        const shown = name === "left" && this._readOnly ? "left_by_pupil" : name;
        this._strip.show(shown, count, this._texts);
        at("starting").hidden = this._isDrawn || !HOPEFUL.has(name);
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
    const who = this._isMine ? this._texts.say("bar.mine") : name || "";
    at("who").textContent = who;
    at("watching").hidden = !this._readOnly;
    document.body.classList.toggle("watching", this._readOnly);
    if (who) document.title = `${who} · day6`;
    this._terminal.focus();
  }

  /** The desktop is being started, after those of `before` others. */
  _starts({ before }) {
    const key = this._readOnly ? "watched" : before ? "queued" : "now";
    this._isDrawn = false;
    at("starting").textContent = this._texts.say(`starting.${key}`, { before });
    at("starting").hidden = false;
  }

  /** What is said instead of the desktop goes when the desktop itself has something to show. */
  _lookForPicture() {
    const { active } = this._terminal.buffer;
    for (let row = 0; row < this._terminal.rows && !this._isDrawn; row += 1) {
      this._isDrawn = Boolean(active.getLine(row)?.translateToString(true));
    }
    at("starting").hidden ||= this._isDrawn;
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
    fingersAreAMouse(place, {
      rowHeight: () => this._screen.rowHeight,
      word: (x, y) => this._screen.wordAt(x, y),
      size: () => this._screen.fontSize,
      zoom: (size) => this._zoomTo(size),
    });
  }

  /** Keys belong to the terminal wherever the focus went, except in a dialog and among the tools. */
  _keepFocus() {
    addEventListener("focus", () => this._terminal.focus());
    document.addEventListener("keydown", (event) => {
      if (event.target.closest?.("dialog, .xterm")) return;
      if (event.target.closest?.("button, a") && ["Tab", "Enter", " ", "Escape"].includes(event.key)) {
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

  /** The desktop copies: a plain drag in one of its panes does it at once. For who types here, not for those who watch. */
  async _copies(text) {
    if (!text || this._readOnly) return;
    this._copied = text;
    const done = await copyText(text);
    this._say(done ? "copied" : "copy_needs_click", done ? NOTICE_MS : HINT_MS);
  }

  /** A link is opened by who types in this tab, not by those who watch. */
  _open(text) {
    if (!this._readOnly && text.startsWith("open;")) this._link.open(text.slice("open;".length));
    return true;
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
      "choose-keys": () => this._chooser.open(chosenKeys(memory.get("row")), this._texts),
      help: () => at("help-dialog").showModal(),
    };
    this._chooser = new KeyChooser(at("choose-dialog"), (names) => {
      memory.set("row", names && names.join(" "));
      this._writeKeys();
    });
    this._speaker = new Speaker(this._terminal, at("spoken"), (count) => this._texts.say("speak.more", { count }));
    this._speaker.isOn = at("speak").checked = memory.get("speak") === "yes";
    at("speak").addEventListener("change", () => {
      this._speaker.isOn = at("speak").checked;
      memory.set("speak", at("speak").checked ? "yes" : null);
    });
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
    for (const id of ["help-dialog", "choose-dialog"]) at(id).addEventListener("close", () => this._terminal.focus());
  }

  _zoom(step) {
    this._zoomTo(this._screen.fontSize + step);
  }

  _zoomTo(size) {
    if (Math.round(size) === this._screen.fontSize) return;
    this._screen.fontSize = Math.round(size);
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
    this._shown.write(texts);
    this._terminal.textarea.setAttribute("aria-label", texts.say("screen.label"));
    const lines = texts.lines("help.lines").map((line) => {
      const item = document.createElement("li");
      item.textContent = line;
      return item;
    });
    at("help-lines").replaceChildren(...lines);
    this._writeKeys();
  }

  _writeKeys() {
    const mode = () => this._terminal.modes.applicationCursorKeysMode;
    const choose = at("choose-keys");
    at("keys").replaceChildren();
    const names = chosenKeys(memory.get("row"));
    this._row = new KeyRow(at("keys"), this._texts, names, (text) => this._terminal.input(text), mode);
    at("keys").append(choose);
  }
}

window.desk = new Desk(); // named for whoever looks with the browser's own tools, and for the tests
