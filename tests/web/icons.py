"""Draws the icons of the installable page from icon.svg, with Chromium, by hand: python -m tests.web.icons

`round-*.png` have the rounded corners of the picture; `whole-*.png` are filled to the edge, with the drawing where a system that
cuts icons to its own form leaves it (https://www.w3.org/TR/appmanifest/#icon-masks).
"""

from __future__ import annotations

import base64
import sys
from pathlib import Path

from day6_tui import web
from tests.web.background import Background
from tests.web.chromium import Chromium, program

STATIC = Path(web.__file__).parent / "static"
SIZES = (192, 512)
SAFE = 0.8
"""The part of the width that is never cut off."""

_DRAW = """(async () => {
  const svg = %s, size = %d, safe = %s;
  const picture = new Image(size, size);
  picture.src = "data:image/svg+xml;base64," + svg;
  await picture.decode();
  const canvas = new OffscreenCanvas(size, size), context = canvas.getContext("2d");
  if (safe < 1) {
    context.fillStyle = "#1d4ed8";
    context.fillRect(0, 0, size, size);
  }
  const edge = size * (1 - safe) / 2;
  context.drawImage(picture, edge, edge, size * safe, size * safe);
  const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer());
  return btoa(String.fromCharCode(...bytes));
})()"""


def main() -> None:
    executable = program()
    if executable is None:
        sys.exit("there is no Chromium here")
    svg = (STATIC / "icon.svg").read_text(encoding="utf-8").replace("<svg ", '<svg width="512" height="512" ')
    background = Background()
    browser = Chromium(executable, background)
    try:
        page = browser.page()
        for kind, safe in (("round", 1), ("whole", SAFE)):
            for size in SIZES:
                drawn = page.evaluate(_DRAW % (repr(base64.b64encode(svg.encode()).decode()), size, safe))
                (STATIC / "icons" / f"{kind}-{size}.png").write_bytes(base64.b64decode(drawn))
    finally:
        browser.close()
        background.close()


if __name__ == "__main__":
    main()
