"""An image of a bag as cells: two pixels in each, or the brightness as a character where there are no colours."""

from __future__ import annotations

from rich.style import Style

from day6_core.ros.programs.rqt_bag.model.pictures import Picture
from day6_tui.appearance.colours import pixel_style
from day6_tui.appearance.look import Look

Cell = tuple[str, Style]

MOST_PAINTED = 64
"""Images that are kept painted."""

RAMP = " .:-=+*#%@"
"""From dark to bright."""


class Paintings:
    """The cells of images; those of the last ones are kept."""

    def __init__(self, look: Look) -> None:
        self._look = look
        self._cells: dict[int, tuple[Picture, list[list[Cell]]]] = {}
        """By the identity of the image, which is kept with them."""

    def of(self, found: Picture | None) -> list[list[Cell]]:
        """The lines of an image, none for None."""
        if found is None:
            return []
        if id(found) not in self._cells:
            if len(self._cells) >= MOST_PAINTED:
                self._cells.pop(next(iter(self._cells)))
            self._cells[id(found)] = (found, paint(found, self._look))
        return self._cells[id(found)][1]

    def forget(self) -> None:
        """Paint anew: colours have changed."""
        self._cells.clear()


def paint(picture: Picture, look: Look) -> list[list[Cell]]:
    """The lines of an image whose pixels are half as high as a cell."""
    lines = []
    for at in range(0, len(picture), 2):
        upper = picture[at]
        lower = picture[at + 1] if at + 1 < len(picture) else upper
        lines.append([_cell(a, b, look) for a, b in zip(upper, lower, strict=True)])
    return lines


def _cell(upper: int, lower: int, look: Look) -> Cell:
    if look.colours.colourless or look.glyphs.canvas == "ascii":
        bright = _brightness(upper) + _brightness(lower)
        return RAMP[min(len(RAMP) - 1, bright * len(RAMP) // 511)], look.colours.text
    if look.glyphs.canvas == "cell":
        return " ", pixel_style(-1, upper)
    return (" ", pixel_style(-1, upper)) if upper == lower else ("▀", pixel_style(upper, lower))


def _brightness(rgb: int) -> int:
    """From 0 to 255, as the eye weighs the colours (ITU-R BT.601)."""
    return ((rgb >> 16 & 255) * 299 + (rgb >> 8 & 255) * 587 + (rgb & 255) * 114) // 1000
