"""The window of rqt_shell: a line for a command, above it what the commands before have printed."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from rich.cells import set_cell_size
from rich.segment import Segment
from textual import events

from day6_tui.core.ros.programs.rqt_shell.model import PROMPT, Kind
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import cell_len, wrap
from day6_tui.tui.look import Look
from day6_tui.tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.core.ros.programs.rqt_shell.model import Shell

MOST_TYPED = 1_000

CURSOR: dict[str, Callable[[int, int], int]] = {
    "left": lambda at, length: max(0, at - 1),
    "right": lambda at, length: min(length, at + 1),
    "home": lambda at, length: 0,
    "ctrl+a": lambda at, length: 0,
    "end": lambda at, length: length,
    "ctrl+e": lambda at, length: length,
}
"""Keys that move the cursor in what is typed."""


class ShellPane(WindowPane["Shell"]):
    """Draws the newest lines; keeps what is typed, and how far it was scrolled back."""

    takes_text = True

    def __init__(self, window: Window[Shell], look: Look) -> None:
        super().__init__(window, look)
        self._typed = ""
        self._at = 0
        """Where in it the cursor is."""
        self._back = 0
        """Lines below the last one that is seen."""
        self._in_history = 0
        """How many lines ago what is typed was run; 0 for a new one."""
        self._state: tuple[object, ...] = ()
        self._wrapped: list[tuple[Kind, str]] = []

    def pull(self, now: float) -> bool:
        state = (self.model.version, self._typed, self._at, self._back, self.extent, self.look.texts.language)
        if state != self._state:
            self._state = state
            self._wrapped = self._newest(max(1, self.inner_width), max(0, self.inner_height - 1))
            self.touch_lines(range(self.inner_height))
            self.touch_frame()
        return False

    def _newest(self, width: int, room: int) -> list[tuple[Kind, str]]:
        """The lines in sight, broken at the width: of thousands only as many are broken."""
        found: list[tuple[Kind, str]] = []
        for kind, line in reversed(self.model.lines):
            text = self.look.texts(line) if kind is Kind.REMARK else line
            found[:0] = [(kind, part) for part in wrap(text, width)]
            if len(found) >= room + self._back:
                break
        self._back = max(0, min(self._back, len(found) - room))
        return found[max(0, len(found) - self._back - room) : len(found) - self._back]

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        colours, shown = self.look.colours, self._wrapped
        if y < len(shown):
            kind, text = shown[y]
            styles = {Kind.COMMAND: colours.strong, Kind.OUTPUT: colours.text}
            return [Segment(text, styles.get(kind, colours.warning))]
        if y > len(shown):
            return ()
        if self.model.running:
            return [Segment(self.look.texts("shell.running"), colours.muted)]
        return [Segment(PROMPT, colours.muted), *self._typed_line(width - cell_len(PROMPT))]

    def _typed_line(self, width: int) -> list[Segment]:
        """What is typed around its cursor, as much as there is room for."""
        colours, typed, at = self.look.colours, self._typed, self._at
        begin, room = at, width - 2
        while begin and cell_len(typed[begin - 1 : at]) <= room:
            begin -= 1
        under, after = typed[at : at + 1] or " ", typed[at + 1 :]
        cursor = colours.choice if self.has_focus else colours.strong
        return [
            Segment(typed[begin:at], colours.strong),
            Segment(under, cursor),
            Segment(
                set_cell_size(after, min(cell_len(after), max(0, room - cell_len(typed[begin:at])))), colours.strong
            ),
        ]

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self.model.running:
            return [("^C", texts("shell.stop"))]
        return [("Enter", texts("shell.run")), ("↑ ↓" if self.look.glyphs.unicode else "^ v", texts("shell.history"))]

    def on_key(self, event: events.Key) -> None:
        if self._press(event.key, event.character or ""):
            event.stop()
            event.prevent_default()
            self.look.wake()

    def on_paste(self, event: events.Paste) -> None:
        event.stop()
        self._type(" ".join(event.text.split("\n")))

    def _press(self, key: str, character: str) -> bool:
        page = max(1, self.inner_height - 2)
        if key == "ctrl+c" and self.model.running:
            self.model.interrupt()
        elif key in ("pageup", "pagedown"):
            self._back = max(0, self._back + (page if key == "pageup" else -page))
        elif self.model.running:
            return False
        elif key == "enter":
            self.model.run(self._typed)
            self._typed, self._at, self._in_history, self._back = "", 0, 0, 0
        elif key in CURSOR:
            self._at = CURSOR[key](self._at, len(self._typed))
        elif key == "backspace":
            self._replace(max(0, self._at - 1), self._at)
        elif key in ("delete", "ctrl+d"):
            self._replace(self._at, self._at + 1)
        elif key == "ctrl+w":
            self._replace(self._typed[: self._at].rstrip().rfind(" ") + 1, self._at)
        elif key == "ctrl+k":
            self._replace(self._at, len(self._typed))
        elif key == "ctrl+u":
            self._replace(0, self._at)
        elif key == "escape" and self._typed:
            self._replace(0, len(self._typed))
        elif key in ("up", "down"):
            self._recall(1 if key == "up" else -1)
        elif character and character.isprintable():
            self._type(character)
        else:
            return False
        return True

    def _type(self, text: str) -> None:
        self._replace(self._at, self._at, text[: max(0, MOST_TYPED - len(self._typed))])
        self._back = 0
        self.look.wake()

    def _replace(self, first: int, end: int, text: str = "") -> None:
        """Put a text in place of some of what is typed; the cursor comes behind it."""
        self._typed = self._typed[:first] + text + self._typed[end:]
        self._at = first + len(text)

    def _recall(self, step: int) -> None:
        history = self.model.history
        self._in_history = max(0, min(len(history), self._in_history + step))
        self._typed = history[-self._in_history] if self._in_history else ""
        self._at = len(self._typed)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        event.stop()
        self._back += 3
        self.look.wake()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        event.stop()
        self._back = max(0, self._back - 3)
        self.look.wake()
