"""A window that is one list: Textual's OptionList in the frame of a pane."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Generic, TypeVar

from rich.segment import Segment
from rich.style import Style as RichStyle
from textual import events
from textual.app import ComposeResult
from textual.strip import Strip
from textual.style import Style
from textual.visual import RenderOptions, Visual
from textual.widget import Widget
from textual.widgets import OptionList

from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import harmless, wrap
from day6_tui.panes.marks import Line, marked_lines
from day6_tui.panes.scrollbars import colour_scrollbar
from day6_tui.textual_private.survival import Surviving
from day6_tui.windows import WindowPane


class PaneList(Surviving, OptionList):
    """Textual's list in the colours and characters of the desktop."""

    DEFAULT_CSS = Path(__file__).with_suffix(".tcss").read_text(encoding="utf-8")

    def __init__(self, look: Look) -> None:
        super().__init__(compact=True, markup=False)
        self.look = look
        self.take_look(look)

    def take_look(self, look: Look) -> None:
        """Take the colours and characters of the desktop."""
        colour_scrollbar(self, look)
        self.refresh()


class ListRow(Visual):
    """An entry: a mark, and the text beside it, as high as it needs; `below` it a line of its own in another style."""

    def __init__(
        self,
        entries: PaneList,
        index: int,
        text: str,
        mark: str,
        style: RichStyle,
        below: str = "",
        below_style: RichStyle | None = None,
    ) -> None:
        self._list = entries
        self._index = index
        self._text = text
        self._mark = mark
        self._style = style
        self._below = below
        self._below_style = below_style or style

    def _lines(self, width: int) -> list[Line]:
        before = f" {self._mark} " if self._mark else " "
        room = max(10, width - len(before) - 1)
        code = self._list.look.colours.publisher
        lines = marked_lines(self._text, room, self._style, code)
        if self._below:
            lines += [[Segment(line, self._below_style)] for line in wrap(self._below, room)]
        heads = (before, " " * len(before))
        return [[Segment(heads[min(at, 1)], self._style), *line] for at, line in enumerate(lines)]

    def render_strips(self, width: int, height: int | None, style: Style, options: RenderOptions) -> list[Strip]:
        entries = self._list
        chosen = entries.highlighted == self._index and entries.has_focus
        strips = []
        for line in self._lines(width):
            if chosen:
                line = [Segment("".join(segment.text for segment in line), entries.look.colours.choice)]
            strips.append(Strip(list(harmless(line))).adjust_cell_length(width, line[0].style))
        return strips

    def get_optimal_width(self, rules: Any, container_width: int) -> int:
        return container_width

    def get_minimal_width(self, rules: Any) -> int:
        return 1

    def get_height(self, rules: Any, width: int) -> int:
        return len(self._lines(width))


Model = TypeVar("Model")
List = TypeVar("List", bound=PaneList)


class ListPane(WindowPane[Model], Generic[Model, List]):
    """Draws the frame; the list in it has the keyboard."""

    def __init__(self, window: Window[Model], look: Look, entries: List) -> None:
        super().__init__(window, look)
        self.list = entries

    def compose(self) -> ComposeResult:
        yield self.list

    @property
    def focus_target(self) -> Widget:
        return self.list if self.list.is_attached else self

    def focus(self, scroll_visible: bool = True) -> ListPane[Model, List]:
        self.list.focus(scroll_visible)
        return self

    def restyle(self) -> None:
        self.list.take_look(self.look)
        super().restyle()

    def on_focus(self, event: events.Focus) -> None:
        super().on_focus(event)
        if self.focus_target is not self:
            self.screen.set_focus(self.focus_target, scroll_visible=False)
