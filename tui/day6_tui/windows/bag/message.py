"""The message at the playhead as a tree of fields, below the timeline."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from rich.segment import Segment

from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, fit

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_bag.model.bags import ShownMessage

Path = tuple[str, ...]
"""The names of the fields that lead to one."""

MOST_LINES = 2000
"""Of a tree that is opened wide."""


class _Line(NamedTuple):
    path: Path
    value: Any
    can_open: bool


class MessageTree:
    """Keeps which fields are open, and where the cursor is, from message to message."""

    def __init__(self, look: Look, topic: str) -> None:
        self._look = look
        self.topic = topic
        self._open: set[Path] = set()
        self._cursor = self._first = 0
        self._lines: list[_Line] = []
        self._shown: ShownMessage | None = None
        self._made_for: tuple[object, ...] = ()

    def take(self, shown: ShownMessage | None) -> None:
        """Show another message."""
        made_for = (len(self._open), self._cursor)
        if shown is self._shown and made_for == self._made_for:
            return
        self._shown, self._made_for = shown, made_for
        self._lines = []
        if shown is not None and shown.message is not None:
            self._add((), shown.type, shown.message)
        self._cursor = max(0, min(self._cursor, len(self._lines) - 1))

    def _add(self, path: Path, type_name: str, value: Any) -> None:
        from day6_core.ros.programs.rqt_topic.fields import fields, has_fields

        for field in fields(type_name, value):
            if len(self._lines) >= MOST_LINES:
                return
            inner = (*path, field.name)
            can_open = has_fields(field.type, field.value)
            self._lines.append(_Line(inner, field.value, can_open))
            if can_open and inner in self._open:
                self._add(inner, field.type, field.value)

    @property
    def field(self) -> str:
        """The path of the field that the cursor is on, as rqt_plot wants it: /turtle1/pose/x, /joint_states/position[0]."""
        if not self._lines:
            return ""
        return self.topic + "".join(
            step if step.startswith("[") else f"/{step}" for step in self._lines[self._cursor].path
        )

    def press(self, key: str) -> bool:
        """Handle a key; False for one that means nothing here."""
        if not self._lines:
            return False
        line = self._lines[self._cursor]
        if key in ("up", "down"):
            self._cursor = max(0, min(len(self._lines) - 1, self._cursor + (1 if key == "down" else -1)))
        elif key in ("right", "enter") and line.can_open and line.path not in self._open:
            self._open.add(line.path)
        elif key in ("left", "enter") and line.path in self._open:
            self._open.discard(line.path)
        elif key == "left" and len(line.path) > 1:
            self._cursor = next(at for at, each in enumerate(self._lines) if each.path == line.path[:-1])
        else:
            return False
        return True

    def click(self, y: int) -> None:
        """A click on a line: the cursor goes there, and a branch opens or closes."""
        if self._first + y < len(self._lines):
            self._cursor = self._first + y
            self.press("enter")

    def line(self, y: int, width: int, height: int, *, focused: bool) -> list[Segment]:
        """Draw one line of so many."""
        from day6_core.ros.programs.rqt_topic.fields import summary

        self._first = max(min(self._first, self._cursor), self._cursor - height + 1)
        at = self._first + y
        if at >= len(self._lines):
            return []
        path, value, can_open = self._lines[at]
        colours, glyphs = self._look.colours, self._look.glyphs
        opener = ("▾ " if path in self._open else "▸ ") if glyphs.chinese else ("- " if path in self._open else "+ ")
        name = f" {'  ' * (len(path) - 1)}{opener if can_open else '  '}{path[-1]}: "
        on = at == self._cursor and focused
        room = max(0, width - cell_len(name))
        return [
            Segment(clip(name, width, glyphs.ellipsis), colours.choice if on else colours.node),
            Segment(fit(summary(value, room), room, glyphs.ellipsis), colours.text),
        ]
