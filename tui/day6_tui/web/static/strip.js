/** The strip that says how the connection is, when it is not simply good. */

const PATIENCE_MS = 600; // a quick beginning or reconnect needs no words

/** States with a button, and its text. */
const BUTTONS = {
  lost: "again", server: "again", full: "again", taken: "take", left: "start", left_by_pupil: "start", ended: "start", idle: "start",
  disk: "start",
};
const QUIET = new Set(["connecting", "lost"]);

export class Strip {
  /** `strip` holds a span and a button; `again()` is what the button asks for. */
  constructor(strip, again) {
    this._strip = strip;
    this._text = strip.querySelector("span");
    this._button = strip.querySelector("button");
    this._button.addEventListener("click", again);
    this._timer = 0;
    this.state = "";
  }

  show(state, count, texts) {
    clearTimeout(this._timer);
    this.state = state;
    if (state === "open") {
      this._strip.hidden = true;
      return;
    }
    const write = () => {
      this._text.textContent = texts.say(`strip.${state}`, { count });
      this._button.hidden = !(state in BUTTONS);
      if (state in BUTTONS) this._button.textContent = texts.say(`button.${BUTTONS[state]}`);
      this._strip.dataset.state = state;
      this._strip.hidden = false;
    };
    if (QUIET.has(state) && (count || 0) <= 1 && this._strip.hidden) this._timer = setTimeout(write, PATIENCE_MS);
    else write();
  }
}
