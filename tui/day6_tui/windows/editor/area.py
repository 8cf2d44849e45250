"""The text of an editor's window: Textual's TextArea with the keys of a code editor."""

from __future__ import annotations

from itertools import takewhile
from typing import TYPE_CHECKING

from rich.text import Text
from textual import events
from textual.widgets import TextArea

from day6_core.session.harmless import same_length
from day6_tui.appearance.look import Look
from day6_tui.panes.scrollbars import colour_scrollbar
from day6_tui.screen.key_order import is_letter
from day6_tui.textual_private.survival import Surviving
from day6_tui.textual_private.text_area import CodeArea
from day6_tui.windows.editor.indent import STEP, after, has_own_depth, shifted

if TYPE_CHECKING:
    from day6_tui.windows.editor.editor import EditorPane

_CLOSING = {"right_parenthesis": ")", "right_square_bracket": "]", "right_curly_bracket": "}"}
"""Keys that close the block a deeper line belongs to."""

FASTEST_FINGERS = 0.01
"""Keys closer together than this (seconds) are a paste: a terminal without bracketed paste sends pasted text as keys."""


class EditorArea(Surviving, CodeArea):
    """Keys go to the pane first; Enter keeps the indentation, Tab indents selected lines, the wrong line is underlined."""

    DEFAULT_CSS = """
    EditorArea {
        margin: 1; border: none; padding: 0; width: 1fr; height: 1fr;
        scrollbar-size-vertical: 1; scrollbar-size-horizontal: 0;
    }
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
        colour_scrollbar(self, look)
        self._last_key = 0.0
        self._cut = ""
        self._cut_row = -1
        self._automatic: tuple[int, int] | None = None
        """Where the cursor was after blanks that Enter put there."""
        self._own_row = -1
        """The line whose blanks the user typed; the next one is left to the user too."""

    def take_look(self, look: Look) -> None:
        """Take the colours of the desktop."""
        self.theme = theme_for(look)
        colour_scrollbar(self, look)

    def on_text_area_changed(self, event: TextArea.Changed) -> None:
        event.stop()
        self._pane.edited()

    def on_text_area_selection_changed(self, event: TextArea.SelectionChanged) -> None:
        event.stop()
        self._pane.touch_frame()

    def keeps_keyboard(self, event: events.Event) -> bool:
        return is_letter(event)

    async def take_key(self, event: events.Key) -> bool:
        if keys := self._pane.typed_ahead():
            await self.take_keys(keys)
        pasted, self._last_key = event.time - self._last_key < FASTEST_FINGERS, event.time
        return await self._handle_key(event, pasted=pasted)

    async def take_keys(self, keys: list[events.Key]) -> None:
        """Handle keys that were typed elsewhere, bindings included."""
        for event in keys:
            await self._handle_key(event, pasted=True)

    async def _handle_key(self, event: events.Key, *, pasted: bool) -> bool:
        return self._pane.used(event.key) or self._typed(event.key, pasted) or await self.type_key(event)

    def take_paste(self, event: events.Paste) -> None:
        event.text = event.text.replace("\r\n", "\n").replace("\r", "\n")  # terminals send what Enter sends
        if self._after_automatic_blanks() and has_own_depth(event.text, self.cursor_location[1]):
            self._drop_blanks()

    def _typed(self, key: str, pasted: bool) -> bool:
        """Handle a key that is special in code; return False for an ordinary one."""
        first, last = sorted((self.selection.start[0], self.selection.end[0]))
        if key == "enter" and not pasted:
            self._new_line()
        elif key == "space":
            self._own_blank()
            return False
        elif key == "tab" and first != last:
            self._shift(first, last, 1)
        elif key == "tab" and not pasted and self._complete():
            return True
        elif key == "shift+tab":
            self._shift(first, last, -1)
        elif key == "backspace" and not pasted and self._at_a_step():
            row, column = self.cursor_location
            self.delete((row, (column - 1) // len(STEP) * len(STEP)), (row, column))
        elif key in _CLOSING and not pasted and self.language == "python" and self._at_a_step():
            row, column = self.cursor_location
            if row == self._own_row:
                return False
            self.replace(_CLOSING[key], (row, column - len(STEP)), (row, column), maintain_selection_offset=False)
        elif key != "escape":  # which in a text area would take the keyboard away
            return False
        return True

    def _complete(self) -> bool:
        """Complete the word before the cursor, or offer what it may become; return False where nothing is known."""
        row, column = self.cursor_location
        before = self.document.get_line(row)[:column]
        if not self.selection.is_empty or not before.strip():
            return False
        choices, start = self._pane.editor.completions(self.text, row, column)
        if not choices:
            return False
        alike = takewhile(
            lambda pair: pair[0] == pair[1], zip(choices[0], choices[-1], strict=False)
        )  # they are sorted
        common = "".join(letter for letter, _ in alike)
        if len(choices) == 1 or len(common) > column - start:
            self.replace(common, (row, start), (row, column), maintain_selection_offset=False)
        else:
            self._pane.offer(choices, lambda choice: self._take(choice, (row, start), (row, column)))
        return True

    def _take(self, choice: str, start: tuple[int, int], end: tuple[int, int]) -> None:
        self.replace(choice, start, end, maintain_selection_offset=False)

    def _at_a_step(self) -> bool:
        """Whether nothing is selected and only whole indentation steps precede the cursor."""
        row, column = self.cursor_location
        before = self.document.get_line(row)[:column]
        return self.selection.is_empty and column > 0 and column % len(STEP) == 0 and not before.strip(" ")

    def _new_line(self) -> None:
        """Begin a line as deep as this one suggests; at the left if the user typed this one's blanks."""
        (row, column), end = sorted(self.selection)
        before = self.document.get_line(row)[:column]
        blanks = "" if row == self._own_row else after(before, python=self.language == "python")
        self.replace("\n" + blanks, (row, column), end, maintain_selection_offset=False)
        self._automatic = self.cursor_location if blanks else None
        self._own_row = -1

    def _own_blank(self) -> None:
        """Make way for blanks that the user types before a line: they count from the left, as in a book."""
        row, column = self.cursor_location
        if self._after_automatic_blanks():
            self._drop_blanks()
        elif self.document.get_line(row)[:column].strip():
            return
        self._own_row = row

    def _after_automatic_blanks(self) -> bool:
        """Whether the line is nothing but blanks that Enter put there."""
        row, column = self.cursor_location
        line = self.document.get_line(row)
        return self.selection.is_empty and self._automatic == (row, column) == (row, len(line)) and not line.strip()

    def _drop_blanks(self) -> None:
        row, column = self.cursor_location
        self.delete((row, 0), (row, column), maintain_selection_offset=False)
        self._automatic = None

    def _shift(self, first: int, last: int, steps: int) -> None:
        """Indent or unindent these lines by one step, and leave them selected."""
        start, end = self.selection
        lines = [self.document.get_line(row) for row in range(first, last + 1)]
        moved = [shifted(line, steps) for line in lines]
        if moved == lines:
            return
        by_row = {first + index: len(new) - len(old) for index, (new, old) in enumerate(zip(moved, lines, strict=True))}
        self.replace("\n".join(moved), (first, 0), (last, len(lines[-1])), maintain_selection_offset=False)
        chosen = [(row, max(0, column + by_row.get(row, 0))) for row, column in (start, end)]
        self.selection = type(self.selection)(*chosen)

    def cut_line(self) -> None:
        """nano's ^K: cut the line; consecutive cuts are kept together."""
        row = self.cursor_location[0]
        end = (row + 1, 0) if row + 1 < self.document.line_count else (row, len(self.document.get_line(row)))
        text = self.document.get_line(row) + "\n"
        self._cut = self._cut + text if self._cut_row == row else text
        self.delete((row, 0), end, maintain_selection_offset=False)
        self.move_cursor((row, 0))
        self._cut_row = row

    def put_line(self) -> None:
        """nano's ^U: paste what ^K cut."""
        row = self.cursor_location[0]
        self.insert(self._cut, (row, 0), maintain_selection_offset=False)
        self._cut_row = -1

    def get_line(self, line_index: int) -> Text:
        # Character by character, because TextArea counts places in the line by them.
        text = same_length(self.document.get_line(line_index), pictures=self._pane.look.glyphs.chinese)
        line = Text(text, end="", no_wrap=True)
        problem = self._pane.problem
        if problem is not None and problem.line == line_index + 1:
            line.stylize("underline red")
        return line


def theme_for(look: Look) -> str:
    """The colours of the text: a well-known editor's, or the terminal's own if it has few."""
    return {"dark": "vscode_dark", "light": "github_light", "colourblind": "vscode_dark"}.get(look.colours.name, "css")


def has_grammar(language: str) -> bool:
    """Whether highlighting is available: it comes from packages that a system may lack."""
    from importlib.util import find_spec

    return find_spec("tree_sitter") is not None and find_spec(f"tree_sitter_{language}") is not None
