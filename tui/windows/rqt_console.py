"""The console's window: a table of log messages, the chosen one in full, and which severities are excluded."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from functools import partial

from rich.segment import Segment
from rich.style import Style
from textual import events

from day6_tui.core.ros.programs.rqt_console.model import SEVERITIES, Console, Record
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import cell_len, clip, fit, wrap
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane

NUMBER_WIDTH, SEVERITY_WIDTH, STAMP_WIDTH = 6, 8, 12
NODE_FROM, STAMP_FROM, LOCATION_FROM = 42, 70, 100
"""Columns of the window from which there is room for node, stamp and location."""

SWITCHES_WIDTH = 58
"""Columns that the boxes need with the severities in full; in fewer they have their letters."""

DETAIL_LINES = 4
"""Lines for the chosen message in a window that is high enough; in a lower one it has one line."""

_LEVEL_OF_KEY = {"d": 10, "i": 20, "w": 30, "e": 40, "f": 50}
_STEPS = {"down": 1, "up": -1, "pagedown": 10, "pageup": -10, "home": -(10**9), "end": 10**9}

Line = list[Segment]


class RqtConsolePane(WindowPane[Console]):
    """Draws `Console.shown()`; keeps which message is chosen, or whether the newest is followed."""

    def __init__(self, window: Window[Console], look: Look) -> None:
        super().__init__(window, look)
        self.console = window.model
        self._chosen: Record | None = None
        """None follows the newest message."""
        self._first = 0
        self._boxes: list[tuple[int, int, int]] = []
        """First column, end and level of the boxes of the severities."""
        self._room = 1
        """Lines for messages."""
        self._lines: list[Line] = []
        self._version = -1

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if self.console.version != self._version or len(self._lines) != self.inner_height:
            self._version = self.console.version
            self._show()
        return False

    def _show(self) -> None:
        """Build all lines and touch those that differ."""
        before, self._lines = self._lines, self._build(self.inner_width, self.inner_height)
        if len(before) != len(self._lines):
            super().touch()
        else:
            pairs = zip(before, self._lines, strict=True)
            self.touch_lines(line for line, (old, new) in enumerate(pairs) if old != new)
            self.touch_frame()

    def touch(self) -> None:
        self._lines = []  # built when it is drawn: the focus event comes before the focus itself
        super().touch()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._lines = []

    # -- building ------------------------------------------------------------------------------------------------------

    def _build(self, width: int, height: int) -> list[Line]:
        if width < 10 or height < 1:
            return [[] for _ in range(height)]
        records = self.console.shown()
        details = DETAIL_LINES if height >= 12 else 1 if height >= 6 else 0
        room = self._room = max(1, height - 2 - details - (1 if details > 1 else 0))
        chosen = self._index(records)
        follow = self._chosen is None
        self._first = max(0, min(self._first, len(records) - room))
        if follow:
            self._first = max(0, len(records) - room)
        elif chosen < self._first or chosen >= self._first + room:
            self._first = max(0, min(chosen - room // 2, len(records) - room))
        lines = [self._heading(width)]
        for index in range(self._first, self._first + room):
            lines.append(self._row(records[index], index == chosen, width) if index < len(records) else [])
        if not records:
            key = "console.filtered" if self.console.total else "console.none"
            text = clip(self.look.texts(key), width - 1, self.look.glyphs.ellipsis)
            lines[1] = [Segment(" " + text, self.look.colours.muted)]
        if details > 1:
            lines.append([Segment(self.look.glyphs.border.horizontal * width, self.look.colours.frame)])
        if details:
            lines += self._details(records[chosen] if records else None, width, details)
        lines.append(self._switches(width))
        return lines[:height]

    def _index(self, records: Sequence[Record]) -> int:
        """The index of the chosen message; of the next newer one if it is excluded now."""
        if self._chosen is None:
            return len(records) - 1
        low, high = 0, len(records)
        while low < high:
            middle = (low + high) // 2
            if records[middle].number < self._chosen.number:
                low = middle + 1
            else:
                high = middle
        return min(low, len(records) - 1)

    def _widths(self, width: int) -> tuple[int, int, int, int]:
        """Columns of message, node, stamp and location; 0 where there is no room: the message comes first."""
        stamp = STAMP_WIDTH if width >= STAMP_FROM else 0
        rest = width - NUMBER_WIDTH - SEVERITY_WIDTH - 2 - (stamp + 1 if stamp else 0)
        node = max(10, min(22, rest // 4)) if width >= NODE_FROM else 0
        location = min(36, rest // 3) if width >= LOCATION_FROM else 0
        return max(4, rest - sum(size + 1 for size in (node, location) if size)), node, stamp, location

    def _columns(self, width: int, number: str, text: str, severity: str, node: str, stamp: str, place: str) -> str:
        message_width, node_width, stamp_width, place_width = self._widths(width)
        dots = self.look.glyphs.ellipsis
        parts = [
            number.rjust(NUMBER_WIDTH - 1) + " ",
            fit(text, message_width, dots),
            fit(severity, SEVERITY_WIDTH, dots),
        ]
        if node_width:
            parts.append(fit(node, node_width, dots))
        if stamp_width:
            parts.append(fit(stamp, stamp_width, dots))
        if place_width:
            parts.append(fit(_end_of(place, place_width, dots), place_width))
        return " ".join(parts)

    def _heading(self, width: int) -> Line:
        texts = self.look.texts
        keys = ("message", "severity", "node", "stamp", "location")
        return [Segment(self._columns(width, "#", *(texts(f"console.{key}") for key in keys)), self.look.colours.muted)]

    def _row(self, record: Record, chosen: bool, width: int) -> Line:
        colours = self.look.colours
        text = self._columns(
            width,
            f"#{record.number}",
            " ".join(record.text.split()),
            record.severity,
            record.node,
            _time_of_day(record.stamp_ns),
            record.location,
        )
        if chosen and self.has_focus:
            style = colours.choice
        elif self.console.choice.highlights(record):
            style = colours.hint
        else:
            style = self._style(record)
        mark = self.look.glyphs.marker if chosen else " "
        return [Segment(mark, style), Segment(text[1:], style)]

    def _style(self, record: Record) -> Style:
        colours = self.look.colours
        if record.level >= 40:
            return colours.error
        return {10: colours.muted, 30: colours.warning}.get(record.level, colours.text)

    def _details(self, record: Record | None, width: int, height: int) -> list[Line]:
        colours, texts = self.look.colours, self.look.texts
        if record is None:
            return [[] for _ in range(height)]
        if height == 1:
            text = clip(f"{record.severity}  {' '.join(record.text.split())}", width - 2, self.look.glyphs.ellipsis)
            return [[Segment(f" {text} ", self._style(record))]]
        head: Line = [
            Segment(f" #{record.number} ", colours.strong),
            Segment(f"{record.severity} ", self._style(record)),
            Segment(f"{record.node}  ", colours.node),
            Segment((_whole_time if width >= 70 else _time_of_day)(record.stamp_ns), colours.muted),
        ]
        used = sum(cell_len(segment.text) for segment in head)
        if record.location:
            title = f"  {texts('console.location')} "
            place = _end_of(record.location, width - used - cell_len(title), self.look.glyphs.ellipsis)
            head.append(Segment(title + place, colours.muted))
        lines = wrap(record.text, width - 2)
        if len(lines) > height - 1:
            lines = [*lines[: height - 2], clip(" ".join(lines[height - 2 :]), width - 2, self.look.glyphs.ellipsis)]
        body: list[Line] = [[Segment(" " + line, colours.text)] for line in lines]
        return [head, *body, *([[]] * (height - 1 - len(body)))]

    def _switches(self, width: int) -> Line:
        """The severities with their boxes: a ticked one is left out, as in the real window's list."""
        colours, choice = self.look.colours, self.console.choice
        self._boxes = []
        line: Line = [
            Segment(" " + self.look.texts("list.head", name=self.look.texts("console.exclude")), colours.muted)
        ]
        in_full = width >= SWITCHES_WIDTH
        x = cell_len(line[0].text)
        for key, level in _LEVEL_OF_KEY.items():
            word, on = SEVERITIES[level] if in_full else SEVERITIES[level][:1], level in choice.levels
            box = f"[{'x' if on else ' '}]{' ' * in_full}"
            line.append(Segment(box, colours.muted))
            # The letters are the keys.
            line.append(Segment(word[: len(key)], colours.accent))
            line.append(Segment(f"{word[len(key) :]} ", colours.strong if on else colours.text))
            end = x + len(box) + len(word) + 1
            self._boxes.append((x, end, level))
            x = end
        for title, text in (("console.containing", choice.text), ("console.highlighted", choice.highlight)):
            if text:
                line.append(Segment(" " + self.look.texts("list.head", name=self.look.texts(title)), colours.muted))
                line.append(Segment(clip(text, 20, self.look.glyphs.ellipsis), colours.accent))
        if choice.nodes:
            line.append(
                Segment(" " + self.look.texts("list.head", name=self.look.texts("console.nodes")), colours.muted)
            )
            line.append(Segment(clip(", ".join(sorted(choice.nodes)), 30, self.look.glyphs.ellipsis), colours.accent))
        return line

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if len(self._lines) != self.inner_height:
            self._lines = self._build(width, self.inner_height)
        if y == self.inner_height - 1:
            for first, end, level in self._boxes:
                self.add_hit(y + 1, first + 1, end, partial(self._toggle_level, level))
        return self._lines[y] if y < len(self._lines) else ()

    def status(self) -> list[Piece]:
        texts, colours = self.look.texts, self.look.colours
        total, shown = self.console.total, len(self.console.shown())
        if total == shown:
            text = texts("console.count", count=total)
        else:
            text = texts("console.shown", count=shown, total=total)
        pieces = [Piece(f" {text} ", colours.muted)]
        if self.console.paused:
            pieces.append(Piece(f" {self.look.glyphs.paused} {texts('console.paused')} ", colours.hint))
        return pieces

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [
            ("p", texts("console.resume" if self.console.paused else "console.pause")),
            ("c", texts("console.clear")),
            ("/", texts("console.leave_out")),
            ("h", texts("console.highlight")),
            ("n", texts("console.node_out")),
            ("a", texts("console.all")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [(" ".join(_LEVEL_OF_KEY), texts("console.exclude")), ("Esc", texts("console.newest"))]

    def on_key(self, event: events.Key) -> None:
        key = event.key
        if key in _STEPS:
            self._move(_STEPS[key])
        elif key in _LEVEL_OF_KEY:
            self.console.toggle_level(_LEVEL_OF_KEY[key])
        elif key in ("p", "space"):
            self.console.toggle_paused()
        elif key == "c":
            self.console.clear()
            self._chosen = None
        elif key == "a":
            self.console.show_everything()
        elif key == "n":
            self._leave_node_out()
        elif key == "slash":
            self._ask("console.containing", self.console.choice.text, self.console.exclude_text)
        elif key == "h":
            self._ask("console.highlighted", self.console.choice.highlight, self.console.highlight)
        elif key == "escape" and self._chosen is not None:
            self._chosen = None
        else:
            return
        event.stop()
        event.prevent_default()
        self._show()
        self.look.wake()

    def _toggle_level(self, level: int) -> None:
        self.console.toggle_level(level)
        self._show()
        self.look.wake()

    def _move(self, step: int) -> None:
        """Choose another message; behind the last one the newest is followed again."""
        records = self.console.shown()
        if not records:
            return
        place = self._index(records) + step
        self._chosen = None if place >= len(records) - 1 else records[max(0, place)]

    def _leave_node_out(self) -> None:
        records = self.console.shown()
        if records:
            self.console.toggle_node(records[self._index(records)].node)

    def _ask(self, title: str, value: str, give: Callable[[str], None]) -> None:
        def taken(text: str) -> None:
            give(text)
            self.look.wake()

        self.ask(self.look.texts(title), value, taken, note=self.look.texts(f"{title}.note"))

    def on_click(self, event: events.Click) -> None:
        super().on_click(event)
        index = self._first + event.y - 1 - self.inner_offset
        records = self.console.shown()
        if 0 <= index - self._first < self._room and index < len(records):
            self._chosen = records[index]
            self._show()
            self.look.wake()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        event.stop()
        self._move(3)
        self._show()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        event.stop()
        self._move(-3)
        self._show()


def _end_of(text: str, width: int, ellipsis: str) -> str:
    """The end of a path in at most `width` cells: its last parts say the most."""
    while text and cell_len(text) > max(0, width):
        text = ellipsis + text[2 if text.startswith(ellipsis) else 1 :]
        if text == ellipsis:
            return text if width > 0 else ""
    return text


def _time_of_day(stamp_ns: int) -> str:
    local = time.localtime(stamp_ns // 1_000_000_000)
    return f"{local.tm_hour:02d}:{local.tm_min:02d}:{local.tm_sec:02d}.{stamp_ns // 1_000_000 % 1000:03d}"


def _whole_time(stamp_ns: int) -> str:
    local = time.localtime(stamp_ns // 1_000_000_000)
    return f"{local.tm_year}-{local.tm_mon:02d}-{local.tm_mday:02d} {_time_of_day(stamp_ns)}"
