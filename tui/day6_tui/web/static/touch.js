/** Fingers: a drag is the mouse wheel or the mouse, and the page keeps to the part of the window that a soft keyboard leaves. */

const REST_MS = 450; // as long as phones take for a press that is held
const STILL = 8; // pixels that a resting finger may move
const PINCH = 1.12; // two fingers that go this much apart or together change the size of letters, and scroll no more

/**
 * Drags over the terminal are steps of the wheel, one for each row, by one finger or two. After one has rested it is the mouse, which
 * selects: a word, or what it is dragged over. Two that go apart or together change the size of letters.
 *
 * `on` has rowHeight(), word(x, y) with the two ends of a word or null, size() of the letters and zoom(size).
 */
export function fingersAreAMouse(place, on) {
  let gesture = null;
  const end = (event) => {
    if (gesture?.lift()) event.preventDefault(); // no click follows
    gesture = null;
  };
  const begin = (event) => {
    end(event);
    if (event.touches.length === 1) gesture = new Finger(event, on);
    if (event.touches.length === 2) gesture = new Pair(event, on);
    if (event.touches.length > 1) event.preventDefault();
  };
  const passive = { passive: false };
  place.addEventListener("touchstart", begin, passive);
  place.addEventListener("touchmove", (event) => {
    event.preventDefault();
    gesture?.move(event.touches, Math.max(STILL, on.rowHeight()));
  }, passive);
  for (const name of ["touchend", "touchcancel"]) place.addEventListener(name, end, passive);
}

/** What both kinds have: where the fingers are, and the wheel that they turn. */
class Gesture {
  constructor({ target }, on, now) {
    this._target = target;
    this._on = on;
    this._now = now;
    this._turned = now.clientY; // up to where the wheel has turned
  }

  _turn(step) {
    while (Math.abs(this._turned - this._now.clientY) >= step) {
      const deltaY = Math.sign(this._turned - this._now.clientY);
      this._turned -= deltaY * step;
      this._send(WheelEvent, "wheel", this._now, { deltaY, deltaMode: WheelEvent.DOM_DELTA_LINE });
    }
  }

  _send(Kind, kind, { clientX, clientY }, more) {
    this._target.dispatchEvent(new Kind(kind, { ...more, clientX, clientY, bubbles: true, cancelable: true }));
  }
}

class Finger extends Gesture {
  constructor(event, on) {
    super(event, on, event.touches[0]);
    this._first = this._now;
    this._isMouse = this._hasDragged = false;
    this._timer = setTimeout(() => this._press(), REST_MS);
  }

  _press() {
    this._isMouse = true;
    navigator.vibrate?.(10);
    this._mouse("mousedown", 1);
  }

  move([touch], step) {
    this._now = touch;
    const isStill = Math.hypot(touch.clientX - this._first.clientX, touch.clientY - this._first.clientY) <= STILL;
    if (this._isMouse) {
      this._hasDragged ||= !isStill;
      if (this._hasDragged) this._mouse("mousemove", 1);
      return;
    }
    if (!isStill) clearTimeout(this._timer);
    this._turn(step);
  }

  /** Returns whether it was the mouse. A press that was only held marks the word below it. */
  lift() {
    clearTimeout(this._timer);
    if (!this._isMouse) return false;
    this._mouse("mouseup", 0);
    const word = this._hasDragged ? null : this._on.word(this._first.clientX, this._first.clientY);
    if (word) {
      const [first, last] = word;
      this._mouse("mousedown", 1, first);
      this._mouse("mousemove", 1, last);
      this._mouse("mouseup", 0, last);
    }
    return true;
  }

  _mouse(kind, buttons, place = this._now) {
    this._send(MouseEvent, kind, place, { button: 0, buttons });
  }
}

class Pair extends Gesture {
  constructor(event, on) {
    super(event, on, middle(event.touches));
    this._apart = apart(event.touches);
    this._size = on.size();
    this._does = ""; // "wheel" or "zoom", once that is clear
  }

  move(touches, step) {
    if (touches.length < 2) return;
    this._now = middle(touches);
    const ratio = apart(touches) / this._apart;
    if (!this._does && Math.max(ratio, 1 / ratio) > PINCH) this._does = "zoom";
    if (!this._does && Math.abs(this._turned - this._now.clientY) >= step) this._does = "wheel";
    if (this._does === "zoom") this._on.zoom(this._size * ratio);
    if (this._does === "wheel") this._turn(step);
  }

  /** It was no click. */
  lift() {
    return true;
  }
}

function middle([one, other]) {
  return { clientX: (one.clientX + other.clientX) / 2, clientY: (one.clientY + other.clientY) / 2 };
}

function apart([one, other]) {
  return Math.max(1, Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY));
}

/** Keep `--height` and `--top` of the page at the visible part of the window. */
export function keepVisible() {
  const view = window.visualViewport;
  if (!view) return;
  const follow = () => {
    const style = document.documentElement.style;
    style.setProperty("--height", `${view.height * view.scale}px`);
    style.setProperty("--top", `${Math.max(0, view.scale > 1 ? 0 : view.offsetTop)}px`);
  };
  view.addEventListener("resize", follow);
  view.addEventListener("scroll", follow);
  follow();
}
