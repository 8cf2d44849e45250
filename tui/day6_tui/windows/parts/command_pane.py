"""What the windows of rqt for command lines have in common: a line to type in, above it what the lines before have printed."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

from rich.segment import Segment
from textual import events

from day6_core.ros.programs.rqt_py_common.command_lines import CommandLines, Kind
from day6_core.session.display import Window
from day6_core.shell.line.edit_line import KEYS, EditLine
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, wrap
from day6_tui.terminals.keys import encode
from day6_tui.windows import WindowPane

MOST_TYPED = 1_000

Commands = TypeVar("Commands", bound=CommandLines)


class CommandPane(WindowPane[Commands]):
    """Draws the newest lines; keeps what is typed, and how far it was scrolled back."""

    takes_text = True

    def __init__(self, window: Window[Commands], look: Look) -> None:
        super().__init__(window, look)
        self._line = EditLine()
        self._back = 0
        """Lines below the last one that is seen."""
        self._in_history = 0
        """How many lines ago what is typed was run; 0 for a new one."""
        self._state: tuple[object, ...] = ()
        self._wrapped: list[tuple[Kind, str]] = []

    # -- drawing -------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        state = (self.model.version, self._line.text, self._line.at, self._back, self.extent, self.look.texts.language)
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
        return self._entry(width)

    def _entry(self, width: int) -> list[Segment]:
        """The line to type in, or why there is none; of a long one what is around the cursor."""
        colours, prompt, line = self.look.colours, self.model.prompt, self._line
        if prompt is None and not line.text:
            return [Segment(self.look.texts("shell.running"), colours.muted)]
        prompt = (prompt or "")[-max(4, width // 2) :]
        start, room = line.at, width - cell_len(prompt) - 2
        while start and (room := room - cell_len(line.text[start - 1])) >= 0:
            start -= 1
        under = line.text[line.at : line.at + 1] or " "
        return [
            Segment(prompt, colours.muted),
            Segment(line.text[start : line.at], colours.strong),
            Segment(under, colours.choice if self.has_focus else colours.strong),
            Segment(line.text[line.at + 1 :], colours.strong),
        ]

    def key_hints(self) -> list[tuple[str, str]]:
        texts, hints = self.look.texts, []
        if self.model.prompt is not None:
            arrows = "↑ ↓" if self.look.glyphs.unicode else "^ v"
            hints = [("Enter", texts("shell.run")), (arrows, texts("shell.history"))]
        return [*hints, ("^C", texts("shell.stop"))] if self.model.can_interrupt else hints

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def on_paste(self, event: events.Paste) -> None:
        event.stop()
        self._insert(" ".join(event.text.split("\n")))

    def _press(self, key: str, character: str) -> bool:
        page = max(1, self.inner_height - 2)
        if key == "ctrl+c" and self.model.can_interrupt:
            self._line.set("")
            self.model.interrupt()
        elif key in ("pageup", "pagedown"):
            self._back = max(0, self._back + (page if key == "pageup" else -page))
        elif not self._can_type():
            return False
        elif key == "enter":
            self._submit()
        elif key == "escape" and self._line.text:
            self._line.set("")
        elif key in ("up", "down"):
            self._recall(1 if key == "up" else -1)
        elif (edit := KEYS.get(encode(key, character))) is not None:
            edit(self._line)
        elif character and character.isprintable():
            self._insert(character)
        else:
            return False
        return True

    def _can_type(self) -> bool:
        return self.model.prompt is not None

    def _submit(self) -> None:
        self.model.run(self._line.text)
        self._line.set("")
        self._in_history = self._back = 0

    def _insert(self, text: str) -> None:
        self._line.insert(text[: max(0, MOST_TYPED - len(self._line.text))])
        self._back = 0
        self.look.wake()

    def _recall(self, step: int) -> None:
        history = self.model.history
        self._in_history = max(0, min(len(history), self._in_history + step))
        self._line.set(history[-self._in_history] if self._in_history else "")

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._back = max(0, self._back - 3 * notches)
        self.look.wake()
