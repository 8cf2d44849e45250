"""The desktop in a terminal that shows real pixels: it finds out by itself, and leaves nothing behind."""

from __future__ import annotations

import codecs
from collections.abc import Callable
from typing import TYPE_CHECKING

import pytest

from tests.pixels.pixel_terminal import PixelTerminal
from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")

GROUND = (69, 86, 255)
COLUMNS, ROWS = 100, 30


class Window:
    """A person's view of the pixels of a terminal, which also answers what it is asked."""

    def __init__(self, screen: Terminal, kind: str) -> None:
        self._screen, self._fed = screen, 0
        self.terminal = PixelTerminal(kind, COLUMNS, ROWS)
        self._decode = codecs.getincrementaldecoder("utf-8")("replace").decode

    def look(self, seconds: float = 0.05) -> None:
        self._screen.look(seconds)
        self._screen._reap()
        new, self._fed = bytes(self._screen.output[self._fed :]), len(self._screen.output)
        if answers := self.terminal.feed(self._decode(new)):
            self._screen.send(answers)

    def until(self, condition: Callable[[], object]) -> None:
        until(condition, every=0.0, meanwhile=self.look, told=self._screen.look)

    def ground(self) -> int:
        """Cells that show the turtles' world."""
        return int(self.terminal.has(GROUND).sum())


@pytest.mark.parametrize("kind", ["kitty", "sixel", "iterm"])
def test_the_turtle_is_drawn_with_pixels_and_quitting_leaves_none(place: Place, kind: str) -> None:
    with place.desktop("--scene", "turtle", columns=COLUMNS, rows=ROWS) as screen:
        window = Window(screen, kind)
        window.until(lambda: window.ground() > 400 and "'q' to quit" in screen.look())  # every pane has its place
        whole = window.ground()
        screen.press("F7")
        window.until(lambda: window.ground() < whole / 2)
        screen.press("Esc")
        window.until(lambda: window.ground() > whole - 20)
        screen.press("Ctrl-Q", "Ctrl-Q")  # programs run: it asks
        window.until(lambda: screen.status is not None)
        window.until(lambda: not window.terminal.images and not window.terminal.placements)
        assert window.terminal.pictures > 0


def test_a_terminal_without_pixels_is_sent_none(place: Place) -> None:
    with place.desktop("--scene", "turtle", columns=COLUMNS, rows=ROWS) as screen:
        window = Window(screen, "plain")
        window.until(lambda: "TurtleSim" in screen.look() and "/turtlesim" in screen.look())
        screen.press("F7")
        window.until(lambda: "Alt+-" in screen.look())  # so everything has been drawn once more
        assert window.terminal.pictures == 0
        assert b"\x1b_G" not in screen.output


@pytest.mark.parametrize("environ", [{"TMUX": "/tmp/tmux-0/default,1,0"}, {"TERM": "screen-256color"}])
def test_behind_tmux_and_screen_nothing_is_asked(place: Place, environ: dict[str, str | None]) -> None:
    with place.desktop("--scene", "turtle", columns=COLUMNS, rows=ROWS, **environ) as screen:
        screen.wait("TurtleSim", "/turtlesim")
        assert b"\x1b[>0q" not in screen.output
