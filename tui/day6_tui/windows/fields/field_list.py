"""A tree of fields in columns, as lines of a list: requests, responses and messages in rqt's windows."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import takewhile
from typing import Any, NamedTuple

from rich.segment import Segment
from rich.style import Style as RichStyle
from textual import events
from textual.strip import Strip
from textual.style import Style
from textual.visual import RenderOptions, Visual
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from day6_core.elide import elide
from day6_core.session.harmless import one_line
from day6_tui.appearance.characters import showable
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, fit, wrap
from day6_tui.textual_private.survival import PersonMessage
from day6_tui.windows.parts.pane_list import PaneList

INDENT = 2
"""Cells by which a field lies further right than its message."""

LEAST_NAME = 6
"""Cells that a name keeps, however deep it lies."""

OPENER, BOX = 2, 4
"""Cells of the mark of what can be opened, and of a check box behind it."""


class FieldNeeds(NamedTuple):
    """Cells that the longest name with its mark takes, and the longest type without its package."""

    name: int = 0
    type: int = 0


Columns = Callable[[int, FieldNeeds], Sequence[int]]
"""The widths of the columns in a list of some width; 0 for one for which there is no room. One cell lies between them."""


@dataclass(frozen=True, slots=True)
class FieldLine:
    """A line: a field with a cell in each column, the names of the columns, or (with one cell only) a remark."""

    key: str
    """Names the line; '' for one that cannot be chosen."""
    cells: tuple[str, ...]
    depth: int = 0
    edited: int | None = None
    """The column whose cell can be typed into."""
    typed: str = ""
    """What is typed over there, at first."""
    ticked: bool | None = None
    is_branch: bool = False
    is_head: bool = False
    problem: str = ""
    """What is wrong with what was typed: a line that warns."""
    begins_closed: bool = False
    """Whether a branch is closed until somebody opens it."""


class FieldList(PaneList):
    """Shows the lines that its pane gives it; the cursor and what is closed outlast their coming and going."""

    class Used(PersonMessage):
        """Enter, or a click, on a line; `part` is 'line', or the 'box', 'opener' or 'cell' to type into that was clicked."""

        def __init__(self, line: FieldLine, part: str) -> None:
            super().__init__()
            self.line, self.part = line, part

    class Moved(PersonMessage):
        """The cursor is on another line."""

    def __init__(self, look: Look, columns: Columns) -> None:
        super().__init__(look)
        self._columns = columns
        self._needs = FieldNeeds()
        self._all: Sequence[FieldLine] = ()
        self.lines_shown: list[FieldLine] = []
        self._toggled: set[str] = set()
        self.wants_open: Callable[[FieldLine], bool] = lambda line: True
        """Whether a branch is open that nobody has opened or closed yet."""

    # -- what is shown -------------------------------------------------------------------------------------------------

    @property
    def chosen(self) -> FieldLine | None:
        """The line the cursor is on."""
        at = self.highlighted
        return self.lines_shown[at] if at is not None and at < len(self.lines_shown) else None

    def show(self, lines: Sequence[FieldLine], *, anew: bool = False) -> None:
        """Show these lines, and draw only those that differ. `anew`: they are about something else than before."""
        self._all = lines
        needs, self._needs = self._needs, needs_of(lines)
        if anew:
            self._toggled.clear()
            self.lines_shown, self.highlighted = [], None
        before, shown = self.lines_shown, self._open_lines(lines)
        if before == shown:
            if needs != self._needs:
                self.refresh()
            return
        at, chosen, offset = self.highlighted, self.chosen, self.scroll_offset.y
        self.lines_shown = shown
        if [(line.key, not line.key) for line in before] == [(line.key, not line.key) for line in shown]:
            for index, (old, new) in enumerate(zip(before, shown, strict=True)):
                if old != new:
                    self.replace_option_prompt_at_index(index, _Drawn(self, index))
            return
        self.set_options([Option(_Drawn(self, index), disabled=not line.key) for index, line in enumerate(shown)])
        self.scroll_to(y=offset, animate=False)
        keys = [line.key for line in shown]
        usable = [index for index, key in enumerate(keys) if key]
        fields = [index for index in usable if shown[index].edited is not None and not shown[index].is_branch]
        if chosen is not None and chosen.key in keys:
            self.highlighted = keys.index(chosen.key)
        elif at is None and fields:
            self.highlighted = fields[0]
        elif usable:
            self.highlighted = min(usable, key=lambda index: abs(index - (at or 0)))
        self.call_after_refresh(self._show_complaint)

    def _open_lines(self, lines: Sequence[FieldLine]) -> list[FieldLine]:
        shown: list[FieldLine] = []
        hidden_below: int | None = None
        for line in lines:
            if hidden_below is not None and line.key and line.depth > hidden_below:
                continue
            hidden_below = line.depth if line.is_branch and not self.is_open(line) else None
            shown += [line] if len(line.cells) > 1 else self._wrapped(line)
            if line.edited is not None and line.problem and not self._fits(line):
                shown += self._wrapped(
                    FieldLine("", (f"{self.look.glyphs.warning} {line.problem}",), problem=line.problem)
                )
        return shown

    def _fits(self, line: FieldLine) -> bool:
        """Whether what is wrong with a cell has room behind it; otherwise it is told below."""
        assert line.edited is not None
        return cell_len(self._with_problem(line)) <= self.widths[line.edited]

    def _with_problem(self, line: FieldLine) -> str:
        assert line.edited is not None
        return f"{line.cells[line.edited]}  {self.look.glyphs.warning} {' '.join(line.problem.split())}"

    def _wrapped(self, remark: FieldLine) -> Iterator[FieldLine]:
        """A remark as so many lines as it needs."""
        for text in wrap(remark.cells[0], max(10, self.scrollable_content_region.width - 2)):
            yield replace(remark, cells=(text,))

    def is_open(self, line: FieldLine) -> bool:
        """Whether the fields of a branch are shown."""
        return (line.key in self._toggled) is not (self.wants_open(line) and not line.begins_closed)

    def toggle(self, line: FieldLine) -> None:
        """Open a branch, or close it."""
        self._toggled ^= {line.key}
        self.show(self._all)
        # The mark of the line itself is not part of it.
        at = self.lines_shown.index(line)
        self.replace_option_prompt_at_index(at, _Drawn(self, at))
        self.call_after_refresh(self.show_branch, line.key)

    def show_branch(self, key: str) -> None:
        """Scroll down as far as is needed to see what is below a line, but not beyond the line itself."""
        at = next((at for at, line in enumerate(self.lines_shown) if line.key == key), None)
        if at is not None:
            depth = self.lines_shown[at].depth
            end = at + len(list(takewhile(lambda line: line.depth > depth, self.lines_shown[at + 1 :])))
            top = min(at, end + 1 - self.size.height)
            if top > self.scroll_offset.y:
                self.scroll_to(y=top, animate=False, immediate=True)

    def choose(self, key: str) -> None:
        """Put the cursor on a line, if it is shown."""
        keys = [line.key for line in self.lines_shown]
        if key in keys:
            self.highlighted = keys.index(key)

    def choose_parent(self) -> None:
        """Put the cursor on the branch to which its line belongs."""
        if (line := self.chosen) is not None and self.highlighted is not None:
            above = [each for each in self.lines_shown[: self.highlighted] if each.key and each.depth < line.depth]
            self.choose(above[-1].key if above else "")

    def show_end(self) -> None:
        """Bring the last lines into sight; the cursor stays where it is."""
        self.scroll_end(animate=False, immediate=True)

    def place_of_cell(self, line: FieldLine) -> tuple[int, int, int] | None:
        """Column, row and width, in this widget, of the cell of a line to type into; None if it is out of sight."""
        keys = [each.key for each in self.lines_shown]
        if line.edited is None or line.key not in keys:
            return None
        y = keys.index(line.key) - int(self.scroll_offset.y)
        widths = self.widths
        x = sum(width + 1 for width in widths[: line.edited] if width)
        return (x, y, widths[line.edited]) if 0 <= y < self.size.height else None

    @property
    def widths(self) -> Sequence[int]:
        """Of the columns, now."""
        return self._columns(max(10, self.scrollable_content_region.width), self._needs)

    def hides_type(self, line: FieldLine) -> bool:
        """Whether a line has no room for its whole type."""
        return len(line.cells) > 1 and cell_len(line.cells[1]) > self.widths[1]

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def watch_highlighted(self, highlighted: int | None) -> None:
        super().watch_highlighted(highlighted)
        self.call_after_refresh(self._show_complaint)
        self.post_message(self.Moved())

    def _show_complaint(self) -> None:
        """Bring what is said below the chosen line into sight, too."""
        line, at = self.chosen, self.highlighted
        if line is None or at is None or line.edited is None or not line.problem:
            return
        below = list(takewhile(lambda each: len(each.cells) == 1, self.lines_shown[at + 1 :]))
        first = min(at, at + len(below) - self.size.height + 1)
        if first > self.scroll_offset.y:
            self.scroll_to(y=first, animate=False)

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()

    def action_select(self) -> None:
        """Enter."""
        if self.chosen is not None:
            self.post_message(self.Used(self.chosen, "line"))

    def on_click(self, event: events.Click) -> None:
        event.stop()
        event.prevent_default()
        index = event.style.meta.get("option")
        if index is None or index >= len(self.lines_shown) or not (line := self.lines_shown[index]).key:
            return
        self.highlighted = index
        x = event.x - self._indent(line)
        if line.is_branch and 0 <= x < OPENER:
            part = "opener"
        elif line.ticked is not None and OPENER <= x < OPENER + BOX:
            part = "box"
        elif (place := self.place_of_cell(line)) is not None and place[0] <= event.x < place[0] + place[2]:
            part = "cell"
        else:
            return
        self.post_message(self.Used(line, part))

    # -- drawing -------------------------------------------------------------------------------------------------------

    def draw(self, index: int, width: int) -> Strip:
        """One line in so many cells."""
        line, colours, glyphs = self.lines_shown[index], self.look.colours, self.look.glyphs
        if len(line.cells) == 1:
            style = colours.warning if line.problem else colours.muted
            segments = [Segment(fit(" " + line.cells[0], width, glyphs.ellipsis), style)]
        else:
            on = None
            if self.highlighted == index:
                on = colours.choice if self.has_focus else colours.strong
            segments = self._cells(line, on)
        return showable(Strip(segments), self.look).adjust_cell_length(width, colours.text)

    def _cells(self, line: FieldLine, on: RichStyle | None) -> list[Segment]:
        colours, dots = self.look.colours, self.look.glyphs.ellipsis
        segments: list[Segment] = []
        for column, (width, cell) in enumerate(zip(self.widths, line.cells, strict=True)):
            if not width:
                continue
            if segments:
                segments.append(Segment(" ", on or colours.text))
            style = colours.muted if line.is_head else colours.accent if column == 1 else colours.text
            if column == 0:
                lead = " " * self._indent(line) + self._lead(line)
                segments.append(Segment(lead, on or (colours.publisher if line.ticked else colours.muted)))
                width -= cell_len(lead)
                cell = elide(one_line(cell), max(1, width), dots) if "/" in cell else cell
                style = colours.strong if line.is_head else colours.node if line.depth else colours.topic
            elif line.problem and column == line.edited:
                cell = self._with_problem(line) if self._fits(line) else f"{self.look.glyphs.warning} {cell}"
                style = colours.warning
            elif column == 1 and cell_len(cell) > width:
                cell = without_package(cell)
            elif cell.startswith("/"):
                cell = elide(one_line(cell), max(1, width), dots)
            segments.append(Segment(fit(cell, width, dots), on or style))
        return segments

    def _indent(self, line: FieldLine) -> int:
        """By how many cells a line lies to the right: by less where its name would have no room."""
        mark = cell_len(self._lead(line))
        return max(0, min(line.depth * INDENT, self.widths[0] - mark - min(cell_len(line.cells[0]), LEAST_NAME)))

    def _lead(self, line: FieldLine) -> str:
        if line.is_head:
            return " "
        lead = "  "
        if line.is_branch and self.look.glyphs.chinese:
            lead = "▾ " if self.is_open(line) else "▸ "
        elif line.is_branch:
            lead = "- " if self.is_open(line) else "+ "
        return lead + ("" if line.ticked is None else "[x] " if line.ticked else "[ ] ")


def needs_of(lines: Sequence[FieldLine]) -> FieldNeeds:
    """What the columns of these lines need; of the names of topics, services and actions their last parts have to stay."""
    columns = [line for line in lines if len(line.cells) > 1]
    names = (
        line.depth * INDENT
        + (1 if line.is_head else OPENER)
        + (BOX if line.ticked is not None else 0)
        + min(cell_len(line.cells[0]), cell_len(line.cells[0].rpartition("/")[2]) + 2)
        for line in columns
    )
    return FieldNeeds(
        max(names, default=0), max((cell_len(without_package(line.cells[1])) for line in columns), default=0)
    )


def without_package(type_name: str) -> str:
    """'Twist' for 'geometry_msgs/msg/Twist', 'sequence<Log>' for 'sequence<rcl_interfaces/Log>'."""
    return re.sub(r"(?:\w+/)+", "", type_name)


class _Drawn(Visual):
    """A line of the list as Textual's options are drawn."""

    def __init__(self, entries: FieldList, index: int) -> None:
        self._list, self._index = entries, index

    def render_strips(self, width: int, height: int | None, style: Style, options: RenderOptions) -> list[Strip]:
        return [self._list.draw(self._index, width)]

    def get_optimal_width(self, rules: Any, container_width: int) -> int:
        return container_width

    def get_minimal_width(self, rules: Any) -> int:
        return 1

    def get_height(self, rules: Any, width: int) -> int:
        return 1
