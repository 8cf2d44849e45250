"""The window of a pupil in which a screen is seen that is shown to the class, live."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial

from rich.segment import Segment
from textual import events

from day6_core.classroom.note import ROWS, PupilScreen
from day6_core.classroom.show import OWN
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.classes.seen import Seen
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.classroom.screen import ScreenPicture

TICK_SECONDS = 1.0
SIDEWAYS = 8
"""Columns of a step to the side."""
WHEEL_ROWS = 3


class ShownPane(WindowPane[Seen]):
    """Draws the picture; where it is larger than the pane, the part in which its owner works, until somebody scrolls."""

    needs = PaneNeeds(Extent(36, 10), Extent(60, 18), Extent(122, 42), 2.0)

    def __init__(self, window: Window[Seen], look: Look) -> None:
        super().__init__(window, look)
        self._picture: ScreenPicture | None = None
        self._top = self._left = 0
        self._follows = True
        self._beyond = ""
        """Arrows to where the screen goes on."""
        self._drawn: tuple[object, ...] = ()
        self._lines: list[list[Segment]] = []

    def on_mount(self) -> None:
        self.set_interval(TICK_SECONDS, self.look.wake)

    @property
    def label(self) -> str:
        shown = self.model.now
        if shown is None or shown.show.source == OWN:
            return self.look.texts("shown.own")
        return self.look.texts("shown.of", name=shown.show.source)

    def status(self) -> list[Piece]:
        waits = self.model.is_waiting
        text, colours = self.look.texts("shown.waiting" if waits else "shown.live"), self.look.colours
        return [Piece(f" {text} ", colours.warning if waits else colours.muted)]

    def status_right(self) -> list[Piece]:
        return [Piece(f" {self._beyond} ", self.look.colours.hint)] if self._beyond else []

    def key_hints(self) -> list[tuple[str, str]]:
        arrows = "↑↓←→" if self.look.glyphs.unicode else "Arrows"
        return [(arrows, self.look.texts("shown.key.scroll")), ("Home", self.look.texts("shown.key.follow"))]

    def pull(self, now: float) -> bool:
        shown = self.model.now
        if shown is None:
            self.close()  # it ended while this opened
        elif self.extent.width:
            self.model.drawn(self)
        screen = shown.screen if shown is not None else None
        where = (self.extent, self._top, self._left, self._follows)
        state = (screen, self.model.is_waiting, self.label, self.look.colours, *where)
        if state != self._drawn:
            self._drawn = state
            self._lines = self._draw(screen) if screen is not None else []
            self.touch_lines(range(self.inner_height))
            self.touch_status()
        return False

    def restyle(self) -> None:
        self._picture, self._drawn = None, ()
        super().restyle()

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        return self._lines[y] if y < len(self._lines) else ()

    def _draw(self, screen: PupilScreen) -> list[list[Segment]]:
        width, height = self.inner_width, self.inner_height
        below, beside = max(0, screen.rows - height), max(0, screen.columns - width)
        if self._follows:
            self._top, self._left = _part(screen, width, height)
        self._top, self._left = min(self._top, below), min(self._left, beside)
        ways = {"←": self._left > 0, "↑": self._top > 0, "↓": self._top < below, "→": self._left < beside}
        self._beyond = "".join(arrow for arrow, is_open in ways.items() if is_open)
        if self._picture is None or self._picture.source is not screen:
            self._picture = ScreenPicture(screen, self.look.colours.terminal, self._picture)
        return self._picture.lines(min(width, screen.columns), height, self._top, self._left)

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def _press(self, key: str, character: str) -> bool:
        action = self._keys().get(key)
        if action is not None:
            action()
        return action is not None

    def _keys(self) -> Mapping[str, Callable[[], None]]:
        page = max(1, self.inner_height - 1)
        return {
            "up": partial(self._scroll, -1),
            "down": partial(self._scroll, 1),
            "left": partial(self._scroll, 0, -SIDEWAYS),
            "right": partial(self._scroll, 0, SIDEWAYS),
            "pageup": partial(self._scroll, -page),
            "pagedown": partial(self._scroll, page),
            "end": partial(self._scroll, ROWS[1]),
            "home": self._follow,
        }

    def _scroll(self, rows: int = 0, columns: int = 0) -> None:
        self._follows = False
        self._top, self._left = max(0, self._top + rows), max(0, self._left + columns)

    def _follow(self) -> None:
        """Look where its owner works again."""
        self._follows = True

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._scroll(notches * WHEEL_ROWS)
        self.look.wake()


def _part(screen: PupilScreen, width: int, height: int) -> tuple[int, int]:
    """The row and the column from which what counts in a screen is seen in so little room."""
    if screen.work is None:
        return 0, 0
    x, y, across, down, line = screen.work
    if down <= height:
        top = max(0, y + down - height)
    else:  # in a terminal the line of the cursor counts, in a window none: then it is its last, and the first are seen
        top = max(y, line - height + 1) if line < y + down - 1 else y
    left = max(0, x + across - width) if across <= width else x
    return top, left
