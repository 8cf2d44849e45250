"""The console's window: a table of log messages, the chosen one in full, and what is left out."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from rich.segment import Segment
from textual import events, on
from textual.app import ComposeResult
from textual.widget import Widget

from day6_core.reason import reason
from day6_core.ros.programs.rqt_console.filters import SIDES, Filter
from day6_core.ros.programs.rqt_console.model import Console, Record
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.overlays.prompt import before_replacing
from day6_tui.panes.cells import cell_len, clip, wrap
from day6_tui.panes.pane import Piece
from day6_tui.windows import WindowPane
from day6_tui.windows.console.filters import FilterMenus
from day6_tui.windows.console.line import ConsoleLine
from day6_tui.windows.console.severities import Severities
from day6_tui.windows.console.table import LONGEST, ConsoleTable, end_of, style_of, time_of_day, whole_time

DETAIL_LINES = 4
"""Lines for the chosen message in a window that is high enough; in a lower one it has one line."""

_LEVEL_OF_KEY = {"D": 10, "I": 20, "W": 30, "E": 40, "F": 50}

Line = list[Segment]


class RqtConsolePane(WindowPane[Console]):
    """Draws the frame and the chosen message; the table, the boxes and the line to type in are widgets of their own."""

    key_weight = 3  # one more of its keys where there is no room for F8, too

    DEFAULT_CSS = Path(__file__).with_suffix(".tcss").read_text(encoding="utf-8")

    def __init__(self, window: Window[Console], look: Look) -> None:
        super().__init__(window, look)
        self.console = window.model
        self.table = ConsoleTable(look)
        self.severities = Severities(look)
        self.line = ConsoleLine(look)
        self._filters = FilterMenus(look, self.console, self.lay_over, self._type_text)
        self._details: list[Line] = []
        self._shown: tuple[object, ...] = ()
        """What was last shown: a frame in which it is the same costs nothing."""
        self._switched: tuple[object, ...] = ()

    def compose(self) -> ComposeResult:
        yield self.table
        yield self.severities
        yield self.line

    @property
    def focus_target(self) -> Widget:
        target = self.line.field if self.line.display else self.table
        return target if target.is_attached else self

    def focus(self, scroll_visible: bool = True) -> RqtConsolePane:
        self.table.focus(scroll_visible)
        return self

    def on_focus(self, event: events.Focus) -> None:
        super().on_focus(event)
        if self.focus_target is not self:
            self.screen.set_focus(self.focus_target, scroll_visible=False)

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        state = (self.console.version, self.extent, self.look.texts.language)
        if (state != self._shown or self.console.is_behind) and self.table.is_attached:
            self._shown = state
            console = self.console
            self.table.remark = self.look.texts("console.filtered" if console.total else "console.none")
            self.table.show(console.shown(), console.choice)
            self._show_switches()
            self._show_details()
            self.touch_status()
        return self.console.is_behind

    def _show_switches(self) -> None:
        state = (self.console.choice, self.inner_width, self.look.texts.language)
        if state != self._switched:
            self._switched = state
            self.severities.show(self.console.choice, self.inner_width)

    def _show_details(self) -> None:
        below = self._lines_below
        self._details = self._describe(self.table.current, self.inner_width, below) if below else []
        self.touch_lines(range(self.inner_height - 1 - below, self.inner_height - 1))

    def restyle(self) -> None:
        self._shown = self._switched = ()
        self.table.take_look(self.look)
        super().restyle()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._shown = ()
        self.table.styles.margin = (1, 1, self._lines_below, 1)

    # -- the chosen message --------------------------------------------------------------------------------------------

    @property
    def _lines_below(self) -> int:
        """Lines between the table and the boxes, a ruled one among them if there is room."""
        height = self.inner_height
        return DETAIL_LINES + 1 if height >= 12 else 1 if height >= 6 else 0

    def _describe(self, record: Record | None, width: int, height: int) -> list[Line]:
        colours, texts, dots = self.look.colours, self.look.texts, self.look.glyphs.ellipsis
        if height == 1:
            if record is None:
                return [[]]
            text = clip(f"{record.severity}  {' '.join(record.text[:LONGEST].split())}", width - 2, dots)
            return [[Segment(f" {text} ", style_of(record, self.look))]]
        rule: Line = [Segment(self.look.glyphs.border.horizontal * width, colours.frame)]
        if record is None:
            return [rule, *[[]] * (height - 1)]
        head: Line = [
            Segment(f" #{record.number} ", colours.strong),
            Segment(f"{record.severity} ", style_of(record, self.look)),
            Segment(f"{record.node}  ", colours.node),
        ]
        title = f"  {texts('console.location')} " if record.location else ""
        used = sum(cell_len(segment.text) for segment in head)
        stamp = whole_time(record.stamp_ns)
        if used + cell_len(stamp + title + record.location) > width:
            stamp = time_of_day(record.stamp_ns)  # the place says more than the date
        room = width - used - cell_len(stamp + title)
        head.append(Segment(stamp + title + end_of(record.location, room, dots), colours.muted))
        room = height - 2
        lines = wrap(record.text[: 4 * room * width], width - 2)  # a message may be a megabyte long
        if len(lines) > room:
            lines = [*lines[: room - 1], clip(" ".join(lines[room - 1 :]), width - 2, dots)]
        body: list[Line] = [[Segment(" " + line, colours.text)] for line in lines]
        return [rule, head, *body, *[[]] * (room - len(body))]

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        index = y - (self.inner_height - 1 - self._lines_below)
        return self._details[index] if 0 <= index < len(self._details) else ()

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
        problem = next(
            (each.problem for side in SIDES for each in getattr(self.console.choice, side) if each.problem), ""
        )
        if problem:
            pieces.append(Piece(f" {self.look.glyphs.warning} {problem} ", colours.warning))
        elif self.console.message:
            pieces.append(Piece(f" {self.console.message} ", colours.hint))
        return pieces

    @on(ConsoleTable.Chosen)
    def show_chosen(self, event: ConsoleTable.Chosen) -> None:
        event.stop()
        self._show_details()

    @on(ConsoleTable.Opened)
    def read(self, event: ConsoleTable.Opened) -> None:
        """Show a message in full."""
        from day6_tui.windows.console.reader import ConsoleReader

        event.stop()
        if (record := self.table.current) is not None:
            self.lay_over(ConsoleReader(self.look, record))

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self.line.display:
            kind = texts("console.as_text" if self.line.is_regex else "console.regexp")
            return [("Enter", texts("console.done")), ("Tab", kind), ("Esc", texts("console.undone"))]
        return [
            ("Space", texts("console.resume" if self.console.paused else "console.pause")),
            ("f", texts("console.filters")),
            ("/", texts("console.leave_out")),
            ("h", texts("console.highlight")),
            ("c", texts("console.clear")),
            ("s", texts("console.sort")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [
            (" ".join(_LEVEL_OF_KEY), texts("console.excludes")),
            ("n", texts("console.node_out")),
            ("a", texts("console.all")),
            ("Enter", texts("console.read")),
            ("w o", texts("console.files")),
            ("S", texts("console.reverse")),
            ("Esc", texts("console.newest")),
        ]

    def on_key(self, event: events.Key) -> None:
        if self.used(event):
            event.stop()
            event.prevent_default()
            self.look.wake()

    def used(self, event: events.Key) -> bool:
        """Handle a key; return False for one that is none of this window's."""
        key = event.key
        if self.table.press(event):
            pass
        elif event.character in _LEVEL_OF_KEY:
            self.console.toggle_level(_LEVEL_OF_KEY[event.character])
        elif key in ("p", "space"):
            self.console.toggle_paused()
        elif key == "c":
            self.console.clear()
            self.table.chosen = None
        elif key == "a":
            self.console.show_everything()
        elif key == "n":
            if (record := self.table.current) is not None:
                self.console.toggle_node(record.node)
        elif key == "f":
            self._filters.open(self.table.current)
        elif key in ("slash", "h"):
            side = "excludes" if key == "slash" else "highlights"
            self._type_text(side, self.console.choice.place_of(side, "message"))
        elif key in ("w", "ctrl+s"):
            self._ask_file(saving=True)
        elif key in ("o", "ctrl+o"):
            self._ask_file(saving=False)
        else:
            return False
        return True

    @on(Severities.Toggled)
    def toggle_level(self, event: Severities.Toggled) -> None:
        event.stop()
        self.console.toggle_level(event.level)
        self.look.wake()

    def _type_text(self, side: str, at: int) -> None:
        """Let the text of a filter be typed; behind the last one, that of a new one."""
        texts, filters = self.look.texts, getattr(self.console.choice, side)
        each = filters[at] if at < len(filters) else Filter("message")
        name = texts(f"console.{side}.kind.{each.kind}")
        names = (name, f"{name} ({texts('console.regexp')})")
        titles = (texts("list.head", name=names[0]).rstrip(), texts("list.head", name=names[1]).rstrip())
        self.severities.display = False
        self.line.open((side, at), titles, texts("console.text.note"), each.text, is_regex=each.is_regex)

    @on(ConsoleLine.Typed)
    def take_text(self, event: ConsoleLine.Typed) -> None:
        """Leave messages out, or highlight them, while the text is typed."""
        event.stop()
        side, at = event.line.purpose
        filters = getattr(self.console.choice, side)
        each = filters[at] if at < len(filters) else Filter("message")
        self.console.set_filter(side, at, replace(each, text=event.text, is_regex=event.is_regex, enabled=True))
        if event.done:
            self.severities.display = True
            if self.screen.focused in (event.line.field, None):
                self.screen.set_focus(self.table, scroll_visible=False)
        self.look.wake()

    def _ask_file(self, *, saving: bool) -> None:
        texts, console = self.look.texts, self.console

        def save(text: str) -> str | None:
            try:
                console.tell(texts("reconfigure.saved", file=str(console.save(text, self.table.in_order()))))
            except OSError as error:
                return reason(error)
            return None

        def load(text: str) -> None:
            console.load(text)

        taken = before_replacing(self.look, console.path, save) if saving else load
        self.ask(texts("console.save" if saving else "console.load"), "rqt_console.csv", taken)
