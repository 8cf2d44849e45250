"""The window of rqt_py_console: a line of Python, above it what the lines before have printed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_tui.windows.parts.command_pane import CommandPane

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_py_console.model import PyConsole  # noqa: F401 - in a base class

INDENT = 4


class PyConsolePane(CommandPane["PyConsole"]):
    """What is typed while Python runs waits for it, as in a terminal."""

    def _entry(self, width: int) -> list[Segment]:
        model = self.model
        if model.can_interrupt:
            return super()._entry(width)
        if model.status is None:
            return []
        text = self.look.texts("py_console.ended", status=model.status)
        return [Segment(text, self.look.colours.muted)]

    def key_hints(self) -> list[tuple[str, str]]:
        hints = super().key_hints()
        if self.model.status is not None:
            return [("Enter", self.look.texts("py_console.begin"))]
        return hints

    def more_key_hints(self) -> list[tuple[str, str]]:
        return [("Tab", self.look.texts("py_console.indent")), ("^D", self.look.texts("py_console.end"))]

    def on_paste(self, event: events.Paste) -> None:
        """Run the whole lines of what is pasted; the rest is typed."""
        event.stop()
        if not self._can_type():
            return
        *lines, rest = event.text.replace("\r\n", "\n").expandtabs(INDENT).split("\n")
        for line in lines:
            self._insert(line)
            super()._submit()
        self._insert(rest)

    def _press(self, key: str, character: str) -> bool:
        model, line = self.model, self._line
        if key == "enter" and model.status is not None:
            model.begin()
        elif key == "tab" and self._can_type():
            self._insert(" " * (INDENT - line.at % INDENT))
        elif key == "backspace" and line.before and not line.before.strip(" "):
            line.cut((line.at - 1) // INDENT * INDENT, line.at, keep=False)
        elif key == "ctrl+d" and model.can_interrupt and not line.text:
            model.end_input()
        else:
            return super()._press(key, character)
        return True

    def _can_type(self) -> bool:
        return self.model.can_interrupt

    def _submit(self) -> None:
        """In a block the next line begins indented; one of blanks alone ends it."""
        text = self._line.text.rstrip()
        self._line.set(text)
        super()._submit()
        indent = len(text) - len(text.lstrip(" ")) + (INDENT if text.endswith(":") else 0)
        self._line.set(" " * indent)
