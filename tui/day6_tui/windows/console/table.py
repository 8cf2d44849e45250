"""The console's table: messages in columns, sorted by one of them.

Not Textual's DataTable, whose rows are objects that are measured and drawn anew with every change. With the 20,000 messages
that the console keeps (Textual 8.2, 120x40, milliseconds of processor time) it is filled in 2200, a frame in which messages come
takes 60, and 80 more when old ones go, a filter 1200, and it holds 28 MB. This table draws what is in sight: 20, 3, 20 and 1 MB,
and to sort by another column takes 40; with 50,000 messages 25, 4, 45 and 80.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.cache import LRUCache
from textual.geometry import Region, Size
from textual.scroll_view import ScrollView
from textual.scrollbar import ScrollBar
from textual.strip import Strip
from textual.widget import Widget

from day6_core.ros.programs.rqt_console.filters import FilterChoice
from day6_core.ros.programs.rqt_console.model import Record
from day6_tui.appearance.characters import showable
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, fit, harmless
from day6_tui.panes.scrollbars import colour_scrollbar
from day6_tui.textual_private.survival import PersonMessage, Surviving
from day6_tui.windows.console.order import COLUMNS, Order, SortedRecords

NUMBER_WIDTH, SEVERITY_WIDTH, STAMP_WIDTH = 6, 8, 12
NODE_FROM, STAMP_FROM, LOCATION_FROM = 42, 70, 100
"""Columns of the window from which there is room for node, stamp and location."""

LONGEST = 2000
"""Characters of a message that a line of the table looks at."""

_STEPS = {"down": 1, "up": -1, "home": -(10**9), "end": 10**9}
_PAGES = {"pagedown": 1, "pageup": -1}


class ConsoleTable(Surviving, ScrollView, can_focus=True):
    """Shows what it is given; keeps the order, and which message is chosen, or that the newest is followed."""

    class Chosen(PersonMessage):
        """The user chose another message, or the newest."""

        def __init__(self, table: ConsoleTable) -> None:
            super().__init__()
            self.table = table

        @property
        def control(self) -> ConsoleTable:
            return self.table

    class Opened(Chosen):
        """The user wants to read the chosen message in full."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._records = SortedRecords()
        self._choice = FilterChoice()
        self.chosen: Record | None = None
        """None follows the newest message, or whatever comes first in another order."""
        self.remark = ""
        """What is shown while there are no messages."""
        self._lines: list[Strip] = []
        """What is on the screen, the head first."""
        self._height = 0
        """Lines of the table, as of the last resize."""
        self._bar: list[tuple[str, bool]] = []
        """The cells of the scroll bar: their characters, and which are the thumb's."""
        self._strips: LRUCache[tuple[int, bool], Strip] = LRUCache(512)
        self.take_look(look)

    def take_look(self, look: Look) -> None:
        """Take the colours and characters of the desktop."""
        colour_scrollbar(self, look)
        self._forget()

    # -- what is shown -------------------------------------------------------------------------------------------------

    @property
    def order(self) -> Order:
        """How it is sorted."""
        return self._records.order

    def show(self, records: Sequence[Record], choice: FilterChoice) -> None:
        """Show these messages, the oldest first; what is in sight stays there unless the newest is followed."""
        following, top = self._is_following, self._first_record
        if choice != self._choice:
            self._choice = choice
            self._strips.clear()
        self._records.update(records, choice)
        self._make_room()
        line = self._end if following else self._records.index(top) if top is not None else 0
        if line == self.scroll_offset.y:
            self._show_bar()
            self._draw()
        else:
            self._bring_to_top(line)

    @property
    def current(self) -> Record | None:
        """The message with the cursor: the chosen one, or of those that are shown the next one to it."""
        return self._records[self._cursor] if self._records else None

    def in_order(self) -> list[Record]:
        """All messages that are shown, from the first line on."""
        return [self._records[index] for index in range(len(self._records))]

    def follow(self) -> None:
        """Choose no message, and show the newest."""
        self.chosen = None
        self._bring_to_top(self._end)
        self._tell()

    @property
    def _cursor(self) -> int:
        if self.chosen is not None:
            return self._records.index(self.chosen)
        return len(self._records) - 1 if self.order.newest_last else 0

    @property
    def _room(self) -> int:
        """Lines for messages: what is left below the head."""
        return max(1, self.size.height - 1)

    @property
    def _end(self) -> int:
        """The line at the top when the newest is in sight."""
        return max(0, len(self._records) - self._room) if self.order.newest_last else 0

    @property
    def _is_following(self) -> bool:
        """Whether nobody has chosen a message or scrolled away."""
        return self.chosen is None and self.scroll_offset.y == self._end

    @property
    def _first_record(self) -> Record | None:
        first = self.scroll_offset.y
        return self._records[first] if first < len(self._records) else None

    def _make_room(self) -> None:
        """Tell Textual how many lines there are.

        As a reactive value that would lay out the whole screen with every message; only whether the bar is seen needs that.
        """
        size = Size(self.scrollable_content_region.width, len(self._records) + 1)
        bar = (self.virtual_size.height > self.size.height) != (size.height > self.size.height)
        if bar:
            self.virtual_size = size
        elif size != self.virtual_size:
            self.set_reactive(Widget.virtual_size, size)

    def _bring_to_top(self, line: int) -> None:
        self.scroll_to(y=line, animate=False, force=True)

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        # Not ScrollView's, which refreshes every cell: many lines of a log are alike.
        self._show_bar()
        self._draw()

    def _show_bar(self) -> None:
        """Move the scroll bar's thumb, where it is seen to move: each of its cells costs as much as a column of a line."""
        if not self.show_vertical_scrollbar:
            return
        bar, count, height = self.vertical_scrollbar, self.virtual_size.height, self.size.height
        for name, value in (("window_virtual_size", count), ("window_size", height), ("position", self.scroll_y)):
            bar.set_reactive(getattr(ScrollBar, name), value)
        position = min(self.scroll_y, count - height)
        drawn = ScrollBar.renderer.render_bar(height, count, height, position).segments
        cells = [(cell.text, bool(cell.style and cell.style.reverse)) for cell in drawn]
        rows = [y for y, (old, new) in enumerate(zip(self._bar, cells, strict=False)) if old != new]
        if len(cells) != len(self._bar):
            bar.refresh()
        elif rows:
            bar.refresh(*(Region(0, y, 1, 1) for y in rows))
        self._bar = cells

    def on_resize(self) -> None:
        before, self._height = self._height, self.size.height
        # Of a table that has grown, Textual has moved the lines already.
        end = min(self._end, max(0, len(self._records) - before + 1)) if self.order.newest_last else 0
        following = self.chosen is None and self.scroll_offset.y >= end
        self._forget()
        self._make_room()
        if following:
            self._bring_to_top(self._end)
        elif self.chosen is not None:
            self._bring_into_sight(self._cursor)
        self._look.wake()

    # -- drawing -------------------------------------------------------------------------------------------------------

    def _forget(self) -> None:
        """Draw everything anew."""
        self._strips.clear()
        self._lines = []
        self.refresh()

    def _draw(self) -> None:
        """Make the lines in sight and refresh the cells that differ."""
        before = self._lines
        if not before:
            self.refresh()
            return
        self._lines = self._make_lines()
        regions = [
            Region(first, y, end - first, 1)
            for y, (old, new) in enumerate(zip(before, self._lines, strict=False))
            if old is not new
            for first, end in _changed(old, new)
        ]
        if len(before) != len(self._lines):
            self.refresh()
        elif regions:
            self.refresh(*regions)

    def render_lines(self, crop: Region) -> list[Strip]:
        if not self._lines:
            self._lines = self._make_lines()
        ground, nothing = self._look.colours.text, Strip([])
        lines = [self._lines[y] if y < len(self._lines) else nothing for y in range(crop.y, crop.bottom)]
        # The column that is kept for the scroll bar is the table's while there is none.
        return [line.adjust_cell_length(crop.right, ground).crop(crop.x, crop.right) for line in lines]

    def _make_lines(self) -> list[Strip]:
        width, first, cursor = self.scrollable_content_region.width, self.scroll_offset.y, self._cursor
        lines = [self._finished(self._head(width), width)]
        for index in range(first, first + self.size.height - 1):
            if index < len(self._records):
                lines.append(self._line(self._records[index], index == cursor, width))
            else:
                remark = index == 0 and clip(" " + self.remark, width, self._look.glyphs.ellipsis)
                lines.append(self._finished([Segment(remark or "", self._look.colours.muted)], width))
        return lines

    def _line(self, record: Record, has_cursor: bool, width: int) -> Strip:
        key = (record.number, has_cursor)
        if (strip := self._strips.get(key)) is None:
            strip = self._strips[key] = self._finished(self._row(record, has_cursor, width), width)
        return strip

    def _finished(self, segments: list[Segment], width: int) -> Strip:
        strip = Strip(harmless(segments)).adjust_cell_length(width, self._look.colours.text)
        return showable(strip, self._look)

    def _head(self, width: int) -> list[Segment]:
        """The names of the columns, with an arrow at the one by which it is sorted."""
        look, order = self._look, self.order
        full = look.glyphs.chinese
        arrow = ("▼" if full else "v") if order.descending else ("▲" if full else "^")
        segments = []
        for column, size in columns_in(width).items():
            chosen = column == order.column
            name = "#" if column == "number" else look.texts(f"console.{column}")
            if column == "number":
                text = fit_number(arrow * chosen + name) + " "
            elif chosen and cell_len(name) + 2 > size:
                text = fit(name, size, look.glyphs.ellipsis) + arrow
            else:
                text = fit(f"{name} {arrow}" if chosen else name, size, look.glyphs.ellipsis) + " "
            segments.append(Segment(text, look.colours.strong if chosen else look.colours.muted))
        return segments

    def _row(self, record: Record, has_cursor: bool, width: int) -> list[Segment]:
        colours, dots = self._look.colours, self._look.glyphs.ellipsis
        if has_cursor and self.has_focus:
            style = colours.choice
        elif self._choice.is_highlighted(record):
            style = colours.hint
        else:
            style = style_of(record, self._look)
        widths = columns_in(width)
        cells = {
            "number": fit_number(f"#{record.number}"),
            "message": fit(" ".join(record.text[:LONGEST].split()), widths["message"], dots),
            "severity": fit(record.severity, widths["severity"], dots),
            "node": fit(record.node, widths.get("node", 0), dots),
            "stamp": fit(time_of_day(record.stamp_ns), widths.get("stamp", 0), dots),
            "location": fit(end_of(record.location, widths.get("location", 0), dots), widths.get("location", 0)),
        }
        mark = self._look.glyphs.marker if has_cursor else " "
        cells["number"] = mark + cells["number"][1:]
        return [Segment(f"{cells[column]} ", style) for column in widths]

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def on_focus(self) -> None:
        self._strips.clear()
        self._draw()

    def on_blur(self) -> None:
        self._strips.clear()
        self._draw()

    def press(self, event: events.Key) -> bool:
        """Handle a key of the table; return False for any other. Its owner asks, so that quick keys keep their order."""
        key = event.key
        if key in _STEPS:
            self._move(_STEPS[key])
        elif key in _PAGES:
            self._move(_PAGES[key] * max(1, self._room - 1))
        elif key == "enter":
            self._open()
        elif event.character == "s":
            self._sort_by_next()
        elif event.character == "S":
            self.sort(Order(self.order.column, not self.order.descending))
        elif key == "escape" and not self._is_following:
            self.follow()
        else:
            return False
        return True

    def _move(self, step: int) -> None:
        """Choose another message; at the end where new ones come they are followed again."""
        if not self._records:
            return
        last = len(self._records) - 1
        self._choose(max(0, min(last, self._cursor + step)))

    def _choose(self, index: int) -> None:
        newest = len(self._records) - 1 if self.order.newest_last else 0
        if index == newest:
            self.follow()
            return
        self.chosen = self._records[index]
        self._bring_into_sight(index)
        self._tell()

    def _bring_into_sight(self, index: int) -> None:
        first = self.scroll_offset.y
        if not first <= index < first + self._room:
            self._bring_to_top(max(0, index if index < first else index - self._room + 1))

    def _tell(self) -> None:
        self._draw()
        self.post_message(self.Chosen(self))
        self._look.wake()

    def _open(self) -> None:
        if self._records:
            self.post_message(self.Opened(self))

    def _sort_by_next(self) -> None:
        shown = list(columns_in(self.scrollable_content_region.width))
        at = shown.index(self.order.column) + 1 if self.order.column in shown else 0
        self.sort(Order.first_by(shown[at % len(shown)]))

    def sort(self, order: Order) -> None:
        """Sort by a column; the chosen message stays in sight."""
        self._records.sort(order)
        if self.chosen is None:
            self._bring_to_top(self._end)
        else:
            self._bring_to_top(max(0, self._cursor - self._room // 2))
        self._tell()

    def on_click(self, event: events.Click) -> None:
        if event.y == 0:
            self._sort_at(event.x)
        elif (index := self.scroll_offset.y + event.y - 1) < len(self._records):
            self._choose(index)
            if event.chain % 2 == 0:
                self._open()
        event.stop()

    def _sort_at(self, x: int) -> None:
        """A click on a column's name sorts by it, a second one the other way round."""
        for column, size in columns_in(self.scrollable_content_region.width).items():
            if x <= size:
                order = self.order
                again = column == order.column
                self.sort(Order(column, not order.descending) if again else Order.first_by(column))
                return
            x -= size + 1


def _changed(old: Strip, new: Strip) -> Iterator[tuple[int, int]]:
    """The spans (first cell, end) in which two lines differ, one for a column: comparing all cells costs more than it saves."""
    if len(old) != len(new):
        yield (0, new.cell_length)
        return
    x = 0
    for before, after in zip(old, new, strict=True):
        size = after.cell_length
        if before != after:
            first, end = 0, size
            if (
                before.style == after.style
                and before.text.isascii()
                and after.text.isascii()
                and len(before.text) == size
            ):
                while before.text[first] == after.text[first]:
                    first += 1
                while before.text[end - 1] == after.text[end - 1]:
                    end -= 1
            yield (x + first, x + end)
        x += size


def columns_in(width: int) -> dict[str, int]:
    """The columns for which there is room and their cells, one between them: the message comes first."""
    stamp = STAMP_WIDTH if width >= STAMP_FROM else 0
    rest = width - NUMBER_WIDTH - SEVERITY_WIDTH - 2 - (stamp + 1 if stamp else 0)
    node = max(10, min(22, rest // 4)) if width >= NODE_FROM else 0
    location = min(36, rest * 3 // 10) if width >= LOCATION_FROM else 0
    message = max(4, rest - sum(size + 1 for size in (node, location) if size))
    sizes = (NUMBER_WIDTH, message, SEVERITY_WIDTH, node, stamp, location)
    return {column: size for column, size in zip(COLUMNS, sizes, strict=True) if size}


def fit_number(text: str) -> str:
    """The number of a message, at the right of its column."""
    return text.rjust(NUMBER_WIDTH - 1) + " "


def style_of(record: Record, look: Look) -> Style:
    """The style of a severity."""
    if record.level >= 40:
        return look.colours.error
    return {10: look.colours.muted, 30: look.colours.warning}.get(record.level, look.colours.text)


def end_of(text: str, width: int, ellipsis: str) -> str:
    """The end of a path in at most `width` cells: its last parts say the most."""
    while text and cell_len(text) > max(0, width):
        text = ellipsis + text[2 if text.startswith(ellipsis) else 1 :]
        if text == ellipsis:
            return text if width > 0 else ""
    return text


def time_of_day(stamp_ns: int) -> str:
    """A stamp as the local time of day, with milliseconds."""
    local = _local(stamp_ns)
    if local is None:
        return f"{stamp_ns / 1e9:.3f}"
    return f"{local.tm_hour:02d}:{local.tm_min:02d}:{local.tm_sec:02d}.{stamp_ns // 1_000_000 % 1000:03d}"


def whole_time(stamp_ns: int) -> str:
    """A stamp as the local date and time of day."""
    local = _local(stamp_ns)
    date = "" if local is None else f"{local.tm_year}-{local.tm_mon:02d}-{local.tm_mday:02d} "
    return date + time_of_day(stamp_ns)


def _local(stamp_ns: int) -> time.struct_time | None:
    """The local time of a stamp; None for one that this system's calendar does not have, as before 1970 on Windows."""
    try:
        return time.localtime(stamp_ns // 1_000_000_000)
    except (OSError, OverflowError, ValueError):
        return None
