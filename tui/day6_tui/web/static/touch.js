/** Fingers: a drag is the mouse wheel or the mouse, and the page keeps to the part of the window that a soft keyboard leaves. */

const REST_MS = 450; // as long as phones take for a press that is held
const STILL = 8; // pixels that a resting finger may move

/** Drags over the terminal are steps of the wheel, one for each row; after a finger has rested they are the mouse, which selects. */
export function fingersAreAMouse(place, rowHeight) {
  let finger = null;
  const end = (event) => {
    if (finger?.lift()) event.preventDefault(); // no click follows
    finger = null;
  };
  place.addEventListener("touchstart", (event) => {
    end(event);
    if (event.touches.length === 1) finger = new Finger(event);
  }, { passive: false });
  place.addEventListener("touchmove", (event) => {
    if (!finger) return;
    event.preventDefault();
    finger.move(event.touches[0], Math.max(STILL, rowHeight()));
  }, { passive: false });
  place.addEventListener("touchend", end, { passive: false });
  place.addEventListener("touchcancel", end, { passive: false });
}

class Finger {
  constructor({ target, touches }) {
    this._target = target;
    this._first = this._now = touches[0];
    this._turned = this._now.clientY; // up to where the wheel has turned
    this._isMouse = false;
    this._timer = setTimeout(() => this._press(), REST_MS);
  }

  _press() {
    this._isMouse = true;
    this._mouse("mousedown", 1);
  }

  move(touch, step) {
    this._now = touch;
    if (this._isMouse) {
      this._mouse("mousemove", 1);
      return;
    }
    const { clientX, clientY } = touch;
    if (Math.hypot(clientX - this._first.clientX, clientY - this._first.clientY) > STILL) clearTimeout(this._timer);
    while (Math.abs(this._turned - clientY) >= step) {
      const deltaY = Math.sign(this._turned - clientY);
      this._turned -= deltaY * step;
      this._send(WheelEvent, "wheel", { deltaY, deltaMode: WheelEvent.DOM_DELTA_LINE });
    }
  }

  /** Returns whether it was the mouse. */
  lift() {
    clearTimeout(this._timer);
    if (this._isMouse) this._mouse("mouseup", 0);
    return this._isMouse;
  }

  _mouse(kind, buttons) {
    this._send(MouseEvent, kind, { button: 0, buttons });
  }

  _send(Kind, kind, more) {
    const { clientX, clientY } = this._now;
    this._target.dispatchEvent(new Kind(kind, { ...more, clientX, clientY, bubbles: true, cancelable: true }));
  }
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
