/** A pupil's screen, large enough to be read, as long as the mouse or the focus is on the small one. */

import { Mirror } from "./mirror.js";

const EDGE = 12;
const LETTER_WIDTH = 8; // of a screen that is not made larger than it was
const MOST_OF_WIDTH = 0.66;
const SHAPE = 2; // the height of a cell

export class Preview {
  constructor(place) {
    this._place = place;
    this._mirror = null;
  }

  /** Show a screen beside `near`, on the half of the window that has more room. */
  show(screen, near) {
    this._place.hidden = false;
    const { left, top, width, height } = near.getBoundingClientRect();
    const wide = Math.min(innerWidth * MOST_OF_WIDTH, screen.cols * LETTER_WIDTH);
    const high = Math.min((wide / screen.cols) * screen.rows * SHAPE, innerHeight - 2 * EDGE);
    const { style } = this._place;
    style.width = `${wide}px`;
    style.height = `${high}px`;
    const room = left + width / 2 < innerWidth / 2 ? Math.min(left + width + EDGE, innerWidth - wide - EDGE) : Math.max(EDGE, left - wide - EDGE);
    style.left = `${room}px`;
    style.top = `${Math.min(Math.max(EDGE, top + height / 2 - high / 2), innerHeight - high - EDGE)}px`;
    this._mirror ??= new Mirror(this._place);
    this._mirror.show(screen);
  }

  hide() {
    if (this._place.hidden) return;
    this._place.hidden = true;
    this._mirror.clear();
  }
}
