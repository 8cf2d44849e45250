/**
 * The line to the server: one WebSocket that comes back by itself.
 *
 * Binary frames are the terminal's output and the keys; text frames are JSON: hello, pong, size, bye from the server; size, ping,
 * ack to it. The server stops sending when too much is unacknowledged, so `taken` has to be called for what was drawn.
 */

const PING_MS = 2000;
const SILENCE_MS = 9000; // without any sign of the server after a ping: the line is dead, whatever the browser thinks
const FIRST_RETRY_MS = 250;
const LONGEST_RETRY_MS = 5000;
const FULL_RETRY_MS = 10000;
const ANSWER_MS = 4000; // a network may take what is asked and never answer
const ACK_BYTES = 32 * 1024;
const KEY_BYTES = 16 * 1024; // the longest frame of keys
const LATENCIES = 9;

/** Goodbyes after which asking again by itself would be wrong. */
const FINAL = new Set(["taken", "left", "ended", "idle", "disk", "refused", "removed"]);

/** How long to wait before the attempt number `count` (from 1): doubling, at most 5 s, a little apart for thirty tabs. */
export function retryDelay(count, chance = Math.random()) {
  return Math.min(LONGEST_RETRY_MS, FIRST_RETRY_MS * 2 ** (count - 1)) * (0.75 + 0.25 * chance);
}

/** What the server answers to a question for a page's state, without the page; null if it does not answer in time. */
export async function asked(address, milliseconds = ANSWER_MS) {
  const late = new AbortController();
  const timer = setTimeout(() => late.abort(), milliseconds);
  try {
    return await fetch(address, { method: "HEAD", cache: "no-store", signal: late.signal });
  } catch {
    return null; // no server at all
  } finally {
    clearTimeout(timer);
  }
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length ? sorted[sorted.length >> 1] : null;
}

export class Connection {
  /**
   * `size()` gives {cols, rows, w, h}; null where there is no terminal. `on` has hello(message), output(bytes, done), message(other),
   * size(cols, rows) for a size the server wants although nobody here asked for it, latency(ms) and
   * state(name, detail): connecting | open | lost (attempt number) | offline | a goodbye.
   */
  constructor(address, size, on) {
    this._address = address;
    this._size = size;
    this._on = on;
    this._attempts = 0;
    this._timer = 0;
    this._latencies = [];
    this._encoder = new TextEncoder();
    addEventListener("online", () => this._hurry());
    addEventListener("offline", () => this._pulse());
    document.addEventListener("visibilitychange", () => {
      if (!document.hidden) this._hurry();
    });
    setInterval(() => this._pulse(), PING_MS);
  }

  /** Connect now: at the start, and when the user asks. */
  open() {
    this._drop();
    this._isClosed = false;
    this._bye = null;
    this._on.state(this._attempts ? "lost" : "connecting", this._attempts);
    this._asked = [];
    const url = new URL(this._address, location.href);
    url.protocol = url.protocol === "https:" ? "wss:" : "ws:";
    for (const [name, value] of Object.entries(this._size ? this._ask() : {})) url.searchParams.set(name, value);
    const socket = new WebSocket(url);
    socket.binaryType = "arraybuffer";
    this._socket = socket;
    this._greeted = false;
    this._drawn = this._acknowledged = 0;
    this._heard = this._begun = performance.now();
    this._pings = new Map();
    socket.onmessage = (event) => socket === this._socket && this._take(socket, event.data);
    socket.onclose = () => socket === this._socket && this._closed();
  }

  /** Be connected no longer, until `open` is called. */
  close() {
    this._isClosed = true;
    this._cut();
  }

  _cut() {
    this._drop();
    this._greeted = false;
  }

  get isOpen() {
    return Boolean(this._greeted) && this._socket?.readyState === WebSocket.OPEN;
  }

  /** Send keys: text as the terminal sends it, or bytes. */
  keys(data) {
    if (!this.isOpen) return;
    const bytes = typeof data === "string" ? this._encoder.encode(data) : data;
    for (let start = 0; start < bytes.length; start += KEY_BYTES) {
      this._socket.send(bytes.subarray(start, start + KEY_BYTES));
    }
  }

  resized() {
    if (this.isOpen && this._size && !this._watches) this.tell({ t: "size", ...this._ask() });
  }

  /** The size as it is now; the server's answer to it will be no news. */
  _ask() {
    const { cols, rows, w, h } = this._size();
    this._asked.push(`${cols}x${rows}`);
    return { cols, rows, w, h };
  }

  /** What is no answer to a question of ours is the server's own decision; who watches asks nothing. */
  _sized({ cols, rows }) {
    const place = this._watches ? -1 : this._asked.indexOf(`${cols}x${rows}`);
    if (place >= 0) this._asked.splice(0, place + 1);
    else this._on.size(cols, rows);
  }

  /** Send a message of the protocol, if anybody hears it. */
  tell(message) {
    if (this.isOpen) this._socket.send(JSON.stringify(message));
  }

  _take(socket, data) {
    this._heard = performance.now();
    if (typeof data !== "string") {
      this._attempts = 0; // a greeting alone may be followed by a goodbye
      this._on.output(new Uint8Array(data), () => this._shown(socket, data.byteLength));
      return;
    }
    const message = JSON.parse(data);
    if (message.t === "bye") {
      this._bye = message.why;
      return;
    }
    if (!this._greeted) this._greet(message);
    if (message.t === "pong") this._measure(message.n);
    else if (message.t === "size") this._sized(message);
    else if (message.t !== "hello") {
      this._attempts = 0;
      this._on.message?.(message);
    }
  }

  /** The first message is the greeting, whatever it says. */
  _greet(message) {
    this._greeted = true;
    this._watches = message.read_only === true;
    this._answers = message.t === "hello"; // who says hello answers pings
    this._on.hello?.(message);
    this._on.state("open");
    this.resized(); // it may have changed meanwhile
    this._pulse();
  }

  /** Acknowledge in steps; what is less than a step never stops the server. */
  _shown(socket, count) {
    if (socket !== this._socket) return;
    this._drawn += count;
    if (this._drawn - this._acknowledged >= ACK_BYTES) {
      this._acknowledged = this._drawn;
      this.tell({ t: "ack", bytes: this._drawn });
    }
  }

  _measure(n) {
    const sent = this._pings.get(n);
    if (sent === undefined) return;
    this._pings.clear();
    this._latencies = [...this._latencies, performance.now() - sent].slice(-LATENCIES);
    this._on.latency?.(median(this._latencies));
  }

  _pulse() {
    const now = performance.now();
    if (!navigator.onLine && !this._local()) this._on.state("offline");
    if (this._socket && !this._greeted && now - this._begun > SILENCE_MS) return this._closed();
    if (!this.isOpen) return;
    const asked = this._pings.size ? Math.min(...this._pings.values()) : Infinity;
    if (now - asked > SILENCE_MS && now - this._heard > SILENCE_MS) return this._closed();
    if (this._answers && this._pings.size < 8) {
      this._count = (this._count || 0) + 1;
      this._pings.set(this._count, now);
      this.tell({ t: "ping", n: this._count });
    }
  }

  /** Whether the server is this machine, which needs no network. */
  _local() {
    return ["localhost", "127.0.0.1", "[::1]"].includes(location.hostname);
  }

  /** The network is back, or somebody looks again: do not wait for the timer. */
  _hurry() {
    if (this.isOpen) this._pulse();
    else if (this._timer) this.open();
  }

  _drop() {
    clearTimeout(this._timer);
    this._timer = 0;
    const socket = this._socket;
    this._socket = null;
    if (socket && socket.readyState <= WebSocket.OPEN) socket.close();
  }

  async _closed() {
    const greeted = this._greeted;
    this._cut();
    if (!this._bye && !greeted && (await this._refused())) this._bye = "refused";
    if (this._socket || this._timer || this._isClosed) return; // somebody was quicker while we asked
    if (FINAL.has(this._bye)) {
      this._attempts = 0;
      this._on.state(this._bye);
      return;
    }
    this._attempts += 1;
    const delay = this._bye === "full" ? FULL_RETRY_MS : retryDelay(this._attempts);
    this._on.state(this._bye || "lost", this._attempts);
    this._timer = setTimeout(() => this.open(), delay);
  }

  /** A browser hides why a WebSocket was refused; the page itself is refused for the same reason. */
  async _refused() {
    const answer = await asked(location.href);
    return answer?.status === 401 || answer?.status === 403;
  }
}
