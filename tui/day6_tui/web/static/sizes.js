/** How large small screens are: as large as all of them fit on the page, or as the teacher says. */

const LEAST = 300; // CSS pixels: below, not even what is drawn can be told
const GAP = 10;
const PADDING = 14;
const TEXT = 100; // what stands above and below a screen in its card
const SHAPE = 3 / 5;

/** The width at which `count` cards fit into `width` x `height`, or the least that is of any use. */
export function fitting(count, width, height) {
  for (let columns = 1; ; columns += 1) {
    const card = Math.floor((width - 2 * PADDING + GAP) / columns) - GAP;
    const rows = Math.ceil(count / columns);
    if (card <= LEAST || columns >= count || rows * (card * SHAPE + TEXT + GAP) <= height) {
      return Math.min(width - 2 * PADDING, Math.max(LEAST, card));
    }
  }
}

export class Sizes {
  /** `slider` is shown while `grid` has screens; `memory` remembers what was chosen. */
  constructor(slider, grid, memory) {
    this._slider = slider;
    this._grid = grid;
    this._memory = memory;
    this._count = 0;
    slider.addEventListener("input", () => {
      memory.set("card", slider.value);
      this._size();
    });
    addEventListener("resize", () => this._size());
  }

  show(count, screens) {
    this._count = count;
    for (const label of document.querySelectorAll(".of-screens")) label.hidden = !screens;
    this._grid.classList.toggle("screens", screens);
    this._size();
  }

  _size() {
    if (!this._grid.classList.contains("screens")) return;
    const { clientWidth } = this._grid;
    const fits = fitting(this._count, clientWidth, innerHeight - this._grid.offsetTop);
    const chosen = Number(this._memory.get("card"));
    const card = Math.min(chosen || fits, clientWidth - 2 * PADDING);
    this._slider.max = clientWidth;
    this._slider.value = card;
    this._grid.style.setProperty("--card", `${card}px`);
  }
}
