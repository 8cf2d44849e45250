"""The text of an editor's window: Textual's TextArea with what one expects of a program's text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.text import Text
from textual import events
from textual.widgets import TextArea

from day6_tui.tui.look import Look

if TYPE_CHECKING:
    from day6_tui.tui.windows.editor import EditorPane

STEP = "    "
"""What Tab puts before a line."""

FASTEST_FINGERS = 0.01
"""Seconds between two keys below which nobody types: a terminal without bracketed paste sends pasted text as keys."""


class EditorArea(TextArea):
    """Keys go to the pane first; Enter keeps the indentation, Tab moves chosen lines, the wrong line is underlined."""

    DEFAULT_CSS = """
    EditorArea { margin: 1; border: none; padding: 0; width: 1fr; height: 1fr; }
    EditorArea:focus { border: none; }
    """

    def __init__(self, pane: EditorPane, look: Look) -> None:
        super().__init__(
            "",
            theme=theme_for(look),
            soft_wrap=False,
            tab_behavior="indent",
            show_line_numbers=True,
            compact=True,
        )
        self._pane = pane
        self._last_key = 0.0
        self._cut = ""
        self._cut_row = -1

    def on_text_area_changed(self, event: TextArea.Changed) -> None:
        event.stop()
        self._pane.edited()

    def on_text_area_selection_changed(self, event: TextArea.SelectionChanged) -> None:
        event.stop()
        self._pane.touch_frame()

    async def _on_key(self, event: events.Key) -> None:
        pasted, self._last_key = event.time - self._last_key < FASTEST_FINGERS, event.time
        if not self._pane.used(event.key) and not self._typed(event.key, pasted):
            await super()._on_key(event)
            return
        event.stop()
        event.prevent_default()

    async def _on_paste(self, event: events.Paste) -> None:
        event.stop()  # the text area, which Textual asks next, inserts it; nobody else shall

    def _typed(self, key: str, pasted: bool) -> bool:
        """Do what a program's text wants of a key; False if it is an ordinary one."""
        first, last = sorted((self.selection.start[0], self.selection.end[0]))
        if key == "enter" and not pasted:
            self._new_line()
        elif key == "tab" and first != last:
            self._shift(first, last, 1)
        elif key == "shift+tab":
            self._shift(first, last, -1)
        elif key != "escape":  # which in a text area would take the keyboard away
            return False
        return True

    def _new_line(self) -> None:
        """Begin a line as deep as this one, a step deeper after a colon in Python."""
        (row, column), end = sorted(self.selection)
        before = self.document.get_line(row)[:column]
        indentation = before[: len(before) - len(before.lstrip())]
        if self.language == "python" and before.rstrip().endswith(":"):
            indentation += STEP
        self.replace("\n" + indentation, (row, column), end, maintain_selection_offset=False)

    def _shift(self, first: int, last: int, steps: int) -> None:
        """Put these lines a step deeper or a step back, and leave them chosen."""
        start, end = self.selection
        lines = [self.document.get_line(row) for row in range(first, last + 1)]
        moved = [_shifted(line, steps) for line in lines]
        if moved == lines:
            return
        by_row = {first + index: len(new) - len(old) for index, (new, old) in enumerate(zip(moved, lines, strict=True))}
        self.replace("\n".join(moved), (first, 0), (last, len(lines[-1])), maintain_selection_offset=False)
        chosen = [(row, max(0, column + by_row.get(row, 0))) for row, column in (start, end)]
        self.selection = type(self.selection)(*chosen)

    def cut_line(self) -> None:
        """nano's ^K: take the line away; several in a row are kept together."""
        row = self.cursor_location[0]
        end = (row + 1, 0) if row + 1 < self.document.line_count else (row, len(self.document.get_line(row)))
        text = self.document.get_line(row) + "\n"
        self._cut = self._cut + text if self._cut_row == row else text
        self.delete((row, 0), end, maintain_selection_offset=False)
        self.move_cursor((row, 0))
        self._cut_row = row

    def put_line(self) -> None:
        """nano's ^U: put back here what ^K took."""
        row = self.cursor_location[0]
        self.insert(self._cut, (row, 0), maintain_selection_offset=False)
        self._cut_row = -1

    def get_line(self, line_index: int) -> Text:
        line = super().get_line(line_index)
        problem = self._pane.problem
        if problem is not None and problem.line == line_index + 1:
            line.stylize("underline red")
        return line

    def forget_lines(self) -> None:
        """Draw all lines anew."""
        self._line_cache.clear()
        self.refresh()


def _shifted(line: str, steps: int) -> str:
    if steps > 0:
        return STEP + line if line.strip() else line
    blank = len(line) - len(line.lstrip(" "))
    return line[1:] if line.startswith("\t") else line[min(blank, len(STEP)) :]


def theme_for(look: Look) -> str:
    """The colours of the text: those of a well-known editor, or the terminal's own where there are few."""
    return {"dark": "vscode_dark", "light": "github_light"}.get(look.colours.name, "css")


def has_grammar(language: str) -> bool:
    """Say whether highlighting can be had: it comes from packages that a system may lack."""
    from importlib.util import find_spec

    return find_spec("tree_sitter") is not None and find_spec(f"tree_sitter_{language}") is not None
