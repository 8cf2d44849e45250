"""The last line of a terminal while it is plain text: kept as characters, because most of it scrolls by before anybody looks."""

from __future__ import annotations

from day6_core.shell.screen.cells import HALF
from day6_core.shell.screen.rows import FoldedText, with_mark


class Pen:
    """A line of plain text that is being written. False while it is empty."""

    __slots__ = ("marks", "text")

    def __init__(self) -> None:
        self.text = ""
        """A character for each cell; `HALF` follows a wide one."""
        self.marks: dict[int, str] = {}
        """What stands in the cells whose character has marks that are characters of their own."""

    def __bool__(self) -> bool:
        return bool(self.text)

    def cells(self) -> list[str]:
        """The text of each cell, `HALF` in the second one of a wide character."""
        cells = list(self.text)
        for x, data in self.marks.items():
            cells[x] = data
        return cells

    def lift(self) -> str:
        """Return the line as a row, and begin an empty one."""
        row = "".join(self.cells()) if self.marks else self.text
        self.text, self.marks = "", {}
        return row.replace(HALF, "")

    def fold(self, x: int) -> FoldedText:
        """Return the line as a row whose text goes on in the next one, because it came to cell `x`; begin an empty one."""
        if self.text[x:] == " " and x not in self.marks:  # no room for a wide character: nothing stands there
            self.text = self.text[:x]
        skipped = " " * (x - len(self.text))
        return FoldedText(self.lift() + skipped)

    def put(self, x: int, cells: str) -> None:
        """Write characters, wide ones followed by `HALF`, from cell `x` on."""
        text, end = self.text, x + len(cells)
        if x >= len(text):
            self.text = text + " " * (x - len(text)) + cells
            return
        before, behind = text[:x], text[end:]
        if text[x] == HALF:  # overwriting one half of a wide character removes the other half
            before = before[:-1] + " "
            self.marks.pop(x - 1, None)
        if behind[:1] == HALF:
            behind = " " + behind[1:]
        if self.marks:
            self.marks = {at: data for at, data in self.marks.items() if not x <= at < end}
        self.text = before + cells + behind

    def mark(self, x: int, char: str) -> None:
        """Put a character that takes no cell onto the one before cell `x`."""
        self.text = self.text.ljust(x)
        x -= 1
        if self.text[x] == HALF:
            x -= 1
        data = with_mark(self.marks.get(x, self.text[x]), char)
        if len(data) == 1:
            self.text = self.text[:x] + data + self.text[x + 1 :]
        else:
            self.marks[x] = data
