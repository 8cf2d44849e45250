/** A sentence that stays long enough to be read, and then goes. */

export class Notice {
  /** `place` has the role `status`. */
  constructor(place) {
    this._place = place;
    this._timer = 0;
  }

  show(text, milliseconds) {
    clearTimeout(this._timer);
    this._place.textContent = text;
    this._timer = setTimeout(() => { this._place.textContent = ""; }, milliseconds);
  }
}
