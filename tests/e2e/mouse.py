"""A hand on the mouse of a real terminal: it points at what it sees, and sends what a terminal reports (SGR, 1006)."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tests.e2e.terminal import Terminal

LEFT, MIDDLE = 0, 1
_MOVING, _WHEEL_UP, _WHEEL_DOWN = 32, 64, 65


class Mouse:
    """Acts on one terminal. Places are columns and rows of the screen, from 0."""

    def __init__(self, screen: Terminal) -> None:
        self.screen = screen

    def find(self, text: str) -> tuple[int, int]:
        """The cell in which a text begins, once it is on the screen."""
        return self._cells(text)[0]

    def click(self, column: int, row: int, button: int = LEFT) -> None:
        self._report(button, column, row)
        self._report(button, column, row, "m")

    def double_click(self, column: int, row: int) -> None:
        """Click twice, in one piece: on a busy machine the time between two may be too long."""
        place = f"\x1b[<{LEFT};{column + 1};{row + 1}"
        self.screen.send(f"{place}M{place}m" * 2)

    def click_on(self, text: str) -> None:
        """Click in the middle of a text."""
        cells = self._cells(text)
        self.click(*cells[len(cells) // 2])

    def drag(self, start: tuple[int, int], *way: tuple[int, int]) -> None:
        """Press at `start`, move along the way and let go at its end."""
        self._report(LEFT, *start)
        for place in way:
            self._report(LEFT + _MOVING, *place)
        self._report(LEFT, *way[-1], "m")

    def wheel(self, column: int, row: int, clicks: int) -> None:
        """Turn the wheel, upwards if `clicks` is positive."""
        for _ in range(abs(clicks)):
            self._report(_WHEEL_UP if clicks > 0 else _WHEEL_DOWN, column, row)

    def _cells(self, text: str) -> list[tuple[int, int]]:
        """Where each character of a text stands, once it is on the screen; a Chinese one takes two columns."""
        lines = self.screen.wait(text).split("\n")
        row = next(row for row, line in enumerate(lines) if text in line)
        first = lines[row].index(text)
        return [(column, row) for column in self.screen.columns_of(row)[first : first + len(text)]]

    def _report(self, button: int, column: int, row: int, end: str = "M") -> None:
        self.screen.send(f"\x1b[<{button};{column + 1};{row + 1}{end}")
