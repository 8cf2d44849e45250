/** Fingers: a drag is the mouse wheel, and the page keeps to the part of the window that a soft keyboard leaves. */

/** Turn drags over the terminal into steps of the wheel, one for each row that the finger passes. */
export function dragIsWheel(place, rowHeight) {
  let last = null;
  place.addEventListener("touchstart", (event) => {
    last = event.touches.length === 1 ? event.touches[0].clientY : null;
  }, { passive: true });
  place.addEventListener("touchmove", (event) => {
    if (last === null || event.touches.length !== 1) return;
    event.preventDefault();
    const { clientX, clientY } = event.touches[0];
    const step = Math.max(8, rowHeight());
    while (Math.abs(last - clientY) >= step) {
      const deltaY = Math.sign(last - clientY);
      last -= deltaY * step;
      const init = { deltaY, deltaMode: WheelEvent.DOM_DELTA_LINE, clientX, clientY, bubbles: true, cancelable: true };
      event.target.dispatchEvent(new WheelEvent("wheel", init));
    }
  }, { passive: false });
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
