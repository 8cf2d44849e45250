"""Choosing the topics of a bag that is recorded or exported: a list with check boxes, in place of the timeline."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from rich.segment import Segment

from day6_core.elide import elide
from day6_core.session.harmless import one_line
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip, fit

Taken = Callable[[Sequence[str] | None], object]
"""Gets the chosen topics; None for all of them."""


class TopicChoice:
    """The list; its first entry stands for all topics, as in rqt_bag (topic_selection.py)."""

    def __init__(self, look: Look, title: str, names: Iterable[str], taken: Taken, *, ticked: bool) -> None:
        self._look = look
        self._title = title
        self.names = list(names)
        self._taken = taken
        self.ticked = set(self.names) if ticked else set()
        self._cursor = self._first = 0
        self.is_over = False

    @property
    def is_all(self) -> bool:
        return len(self.ticked) == len(self.names)

    def press(self, key: str) -> bool:
        """Handle a key; False for one that means nothing here."""
        if key in ("up", "down"):
            self._cursor = max(0, min(len(self.names), self._cursor + (1 if key == "down" else -1)))
        elif key == "space":
            self.toggle(self._cursor)
        elif key == "enter":
            self.is_over = True
            if self.ticked:
                self._taken(None if self.is_all else [name for name in self.names if name in self.ticked])
        elif key == "escape":
            self.is_over = True
        else:
            return False
        return True

    def toggle(self, index: int) -> None:
        """Tick an entry, or untick it; the first one is all."""
        if index == 0:
            self.ticked = set() if self.is_all else set(self.names)
        elif index <= len(self.names):
            self.ticked ^= {self.names[index - 1]}

    def click(self, line: int) -> None:
        """A click on a line of the list."""
        if line >= 1 and self._first + line - 1 <= len(self.names):
            self._cursor = self._first + line - 1
            self.toggle(self._cursor)

    def line(self, y: int, width: int, height: int) -> list[Segment]:
        """Draw one line: the title, then as many entries as there is room for."""
        colours, glyphs, texts = self._look.colours, self._look.glyphs, self._look.texts
        if y == 0:
            return [Segment(" " + clip(self._title, width - 1, glyphs.ellipsis), colours.strong)]
        room = max(1, height - 1)
        self._first = max(min(self._first, self._cursor), self._cursor - room + 1)
        index = self._first + y - 1
        if index > len(self.names):
            return []
        ticked = self.is_all if index == 0 else self.names[index - 1] in self.ticked
        name = texts("bag.all") if index == 0 else elide(one_line(self.names[index - 1]), width - 6, glyphs.ellipsis)
        on = index == self._cursor
        return [
            Segment(f" {'[x]' if ticked else '[ ]'} ", colours.publisher if ticked else colours.muted),
            Segment(fit(name, max(0, width - 6), glyphs.ellipsis), colours.choice if on else colours.topic),
        ]
