"""The text of an editor's window: Textual's TextArea with the keys of a code editor."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.text import Text
from textual import events
from textual._tree_sitter import get_language
from textual.color import Color
from textual.document._document_navigator import DocumentNavigator
from textual.document._wrapped_document import WrappedDocument
from textual.widgets import TextArea

from day6_tui.core.session.harmless import same_length
from day6_tui.tui.look import Look
from day6_tui.tui.survival import survive
from day6_tui.tui.windows.editor_document import document_of

if TYPE_CHECKING:
    from day6_tui.tui.windows.editor import EditorPane

STEP = "    "
"""What Tab puts before a line."""

_CLOSING = {"right_parenthesis": ")", "right_square_bracket": "]", "right_curly_bracket": "}"}
"""Keys that close the block a deeper line belongs to."""

FASTEST_FINGERS = 0.01
"""Keys closer together than this (seconds) are a paste: a terminal without bracketed paste sends pasted text as keys."""


class EditorArea(TextArea):
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
        self._colour_scrollbar(look)
        self._last_key = 0.0
        self._cut = ""
        self._cut_row = -1

    async def on_event(self, event: events.Event) -> None:
        await survive(self.app, event, super().on_event(event))

    def take_look(self, look: Look) -> None:
        """Take the colours of the desktop."""
        self.theme = theme_for(look)
        self._colour_scrollbar(look)

    def _colour_scrollbar(self, look: Look) -> None:
        thumb, track = look.colours.frame.color, look.colours.frame.bgcolor
        styles = self.styles
        if thumb is not None and track is not None:
            bar, behind = Color.from_rich_color(thumb), Color.from_rich_color(track)
            styles.scrollbar_color = styles.scrollbar_color_hover = styles.scrollbar_color_active = bar
            styles.scrollbar_background = styles.scrollbar_background_hover = styles.scrollbar_background_active = (
                behind
            )

    def _set_document(self, text: str, language: str | None) -> None:
        """Like TextArea's, with documents that change no character."""
        document = document_of(text, get_language(language) if language else None)
        self._highlight_query = None
        if language:
            self._highlight_query = document.prepare_query(self._get_builtin_highlight_query(language))
        self.document = document
        self.wrapped_document = WrappedDocument(document, tab_width=self.indent_width)
        self.navigator = DocumentNavigator(self.wrapped_document)
        self._build_highlight_map()
        self.move_cursor((0, 0))
        self._rewrap_and_refresh_virtual_size()

    def on_text_area_changed(self, event: TextArea.Changed) -> None:
        event.stop()
        self._pane.edited()

    def on_text_area_selection_changed(self, event: TextArea.SelectionChanged) -> None:
        event.stop()
        self._pane.touch_frame()

    async def _on_key(self, event: events.Key) -> None:
        if keys := self._pane.typed_ahead():
            await self.take_keys(keys)
        pasted, self._last_key = event.time - self._last_key < FASTEST_FINGERS, event.time
        if not self._pane.used(event.key) and not self._typed(event.key, pasted):
            await super()._on_key(event)
            return
        event.stop()
        event.prevent_default()

    async def take_keys(self, keys: list[events.Key]) -> None:
        """Handle keys that were typed elsewhere, bindings included."""
        for event in keys:
            if self._pane.used(event.key) or self._typed(event.key, pasted=True):
                continue
            bound = self._bindings.key_to_bindings.get(event.key)
            if bound:
                await self.run_action(bound[0].action)
            else:
                await super()._on_key(event)

    async def _on_paste(self, event: events.Paste) -> None:
        event.stop()  # the text area, which gets the event next, inserts it; nothing else may
        event.text = event.text.replace("\r\n", "\n").replace("\r", "\n")  # terminals send what Enter sends

    def _typed(self, key: str, pasted: bool) -> bool:
        """Handle a key that is special in code; return False for an ordinary one."""
        first, last = sorted((self.selection.start[0], self.selection.end[0]))
        if key == "enter" and not pasted:
            self._new_line()
        elif key == "tab" and first != last:
            self._shift(first, last, 1)
        elif key == "shift+tab":
            self._shift(first, last, -1)
        elif key == "backspace" and not pasted and self._at_a_step():
            row, column = self.cursor_location
            self.delete((row, (column - 1) // len(STEP) * len(STEP)), (row, column))
        elif key in _CLOSING and not pasted and self.language == "python" and self._at_a_step():
            row, column = self.cursor_location
            self.replace(_CLOSING[key], (row, column - len(STEP)), (row, column), maintain_selection_offset=False)
        elif key != "escape":  # which in a text area would take the keyboard away
            return False
        return True

    def _at_a_step(self) -> bool:
        """Whether nothing is selected and only whole indentation steps precede the cursor."""
        row, column = self.cursor_location
        before = self.document.get_line(row)[:column]
        return self.selection.is_empty and column > 0 and column % len(STEP) == 0 and not before.strip(" ")

    def _new_line(self) -> None:
        """Begin a line indented like this one, one step deeper after a colon or an open bracket in Python."""
        (row, column), end = sorted(self.selection)
        before = self.document.get_line(row)[:column]
        indentation = before[: len(before) - len(before.lstrip())]
        if self.language == "python" and before.rstrip().endswith((":", "(", "[", "{")):
            indentation += STEP
        self.replace("\n" + indentation, (row, column), end, maintain_selection_offset=False)

    def _shift(self, first: int, last: int, steps: int) -> None:
        """Indent or unindent these lines by one step, and leave them selected."""
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
    """The colours of the text: a well-known editor's, or the terminal's own if it has few."""
    return {"dark": "vscode_dark", "light": "github_light"}.get(look.colours.name, "css")


def has_grammar(language: str) -> bool:
    """Whether highlighting is available: it comes from packages that a system may lack."""
    from importlib.util import find_spec

    return find_spec("tree_sitter") is not None and find_spec(f"tree_sitter_{language}") is not None
