"""The topic monitor's window: a tree of the topics with type, bandwidth, rate and value, as in rqt_topic."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from rich.segment import Segment
from textual import events
from textual.app import ComposeResult
from textual.widget import Widget

from day6_core.reason import named_reason
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.pane import Piece
from day6_tui.windows import WindowPane
from day6_tui.windows.parts.buttons import Button, button_line
from day6_tui.windows.rqt.topic_tree import Branch, Path, TopicRow, TopicTree

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_topic.model import MonitoredEndpoint, Topic, TopicMonitor

SORTS = ("topic", "type", "bandwidth", "hz")
"""The columns by which topics can be sorted."""

BARS_WIDTH = 12

WITH_BUTTONS = 10
"""Lines of the inside from which on one is for buttons."""

RESTS = 20
"""A message that took long to read is read again after this many times as long: the window stays quick."""


class TopicsPane(WindowPane["TopicMonitor"]):
    """Draws the frame and the head of the table; the lines, the cursor and what is open belong to the tree."""

    def __init__(self, window: Window[TopicMonitor], look: Look) -> None:
        super().__init__(window, look)
        self.table = TopicTree(self, look)
        self._sort, self._reverse = "topic", False
        self._filter = ""
        self._shown: tuple[object, ...] = ()
        """What the tree was last filled for."""
        self._topics: list[Topic] = []
        """The topics that pass the filter, sorted."""
        self._messages: dict[str, tuple[int, Any]] = {}
        """The newest message that was read of a topic, and how many had come until then."""
        self._due: dict[str, float] = {}

    def compose(self) -> ComposeResult:
        yield self.table

    @property
    def focus_target(self) -> Widget:
        return self.table if self.table.is_attached else self

    def focus(self, scroll_visible: bool = True) -> TopicsPane:
        self.table.focus(scroll_visible)
        return self

    # -- frame ---------------------------------------------------------------------------------------------------------

    def status(self) -> list[Piece]:
        texts, colours, chosen = self.look.texts, self.look.colours, self.table.chosen
        if chosen is None and not self._filter:
            return []
        names = [topic.name for topic in self._topics]
        at = names.index(chosen.path[0]) + 1 if chosen is not None and chosen.path[0] in names else 0
        text = f" {at}/{len(names)} "
        if self._filter:
            text += f"{texts('topics.filtered', text=self._filter, count=len(self.model.topics))} "
        pieces = [Piece(text, colours.muted)]
        if chosen is not None:  # in their columns there may be no room for all of it
            path = chosen.path if chosen.type else chosen.path[:1]
            pieces += [Piece(f"{'/'.join(path)} ", colours.text), Piece(f"{chosen.type} ", colours.muted)]
        return pieces

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if y < self._bar_rows:
            return button_line(self, y, self._buttons(), width)
        return self._head() if y == self._bar_rows else ()

    @property
    def _bar_rows(self) -> int:
        """Lines for the buttons, where there are enough for topics."""
        return 1 if self.inner_height >= WITH_BUTTONS else 0

    def _buttons(self) -> list[Button]:
        """What has no place of its own to be clicked."""
        texts = self.look.texts
        return [
            Button("/", texts("topics.filter"), self._ask_filter),
            Button("v", texts("topics.view"), self._view),
            Button("s", texts("topics.sort"), self._sort_by_next),
        ]

    def _head(self) -> list[Segment]:
        """The names of the columns; a click sorts by one."""
        texts, full = self.look.texts, self.look.glyphs.chinese
        x = 1
        segments: list[Segment] = []
        for key, width in self.table.columns._asdict().items():
            if not width:
                continue
            gap = " " if segments else ""
            name = texts(f"topics.columns.{key}")
            if key == self._sort:
                name += " " + (("▼" if full else "v") if self._reverse else ("▲" if full else "^"))
            text = clip(("      " if key == "topic" else "") + name, width, self.look.glyphs.ellipsis)
            pad = " " * (width - cell_len(text))
            text = gap + (pad + text if key in ("bandwidth", "hz") else text + pad)
            if key in SORTS:
                self.add_hit(self._bar_rows + 1, x, x + cell_len(text), partial(self._sort_by, key))
            x += cell_len(text)
            segments.append(Segment(text, self.look.colours.strong if key == self._sort else self.look.colours.muted))
        return segments

    def key_hints(self) -> list[tuple[str, str]]:
        texts, topic = self.look.texts, self._chosen_topic()
        unicode = self.look.glyphs.unicode
        return [
            ("Enter", texts("topics.stop" if topic is not None and topic.monitored else "topics.listen")),
            ("← →" if unicode else "<- ->", texts("topics.open")),
            ("/", texts("topics.filter")),
            ("v", texts("topics.view")),
            ("s", texts("topics.sort")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        return [("S", self.look.texts("topics.reverse")), ("Esc", self.look.texts("topics.unfilter"))]

    def restyle(self) -> None:
        self._shown = ()
        self.table.take_look(self.look)
        super().restyle()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self.measure()
        self.table.styles.margin = (self._bar_rows + 2, 1, 1, 1)
        self.refill()

    # -- filling the tree ----------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        table = self.table
        state = (self.model.version, table.scroll_offset.y, table.size, self._sort, self._reverse, self._filter)
        if state != self._shown and table.is_attached:
            self._shown = state
            self._fill(now)
        return False

    def refill(self) -> None:
        """Something was opened, or there is another size: fill the tree in the next frame."""
        self._shown = ()
        self.look.wake()

    def _fill(self, now: float) -> None:
        self._topics = self._sorted()
        self.table.remark = self.look.texts("topics.no_match" if self._filter else "topics.none")
        self._read(now)
        self._show()
        if self._read(now):  # other topics have come in sight
            self._show()
        self.touch_lines(range(self._bar_rows + 1))
        self.touch_frame()

    def _show(self) -> None:
        self.table.show([self._branch(topic) for topic in self._topics])

    def _sorted(self) -> list[Topic]:
        sought = self._filter.lower()
        topics = [
            each for each in self.model.topics if not sought or sought in f"{each.name} {' '.join(each.types)}".lower()
        ]
        if self._sort == "type":
            topics.sort(key=lambda topic: topic.types)
        elif self._sort in ("bandwidth", "hz"):
            field = "rate" if self._sort == "hz" else "bandwidth"
            topics.sort(key=lambda topic: getattr(topic, field) or 0.0)
        return topics[::-1] if self._reverse else topics

    def _read(self, now: float) -> bool:
        """Read the newest messages of the topics in sight; return whether there was any."""
        visible = self.table.visible_topics
        heard = {topic.name for topic in self._topics if topic.monitored}
        self._messages = {name: read for name, read in self._messages.items() if name in heard}
        found = False
        for topic in self._topics:
            name = topic.name
            fresh = topic.monitored and topic.count != self._messages.get(name, (0, None))[0]
            if fresh and name in visible and now >= self._due.get(name, 0.0):
                began = time.monotonic()
                self._messages[name] = (topic.count, self.model.last_message(name))
                self._due[name] = now + RESTS * (time.monotonic() - began)
                found = True
        return found

    def _branch(self, topic: Topic) -> Branch:
        texts, value, quiet = self.look.texts, "", True
        message = self._messages.get(topic.name, (0, None))[1]
        if topic.problem:
            value = topic.problem
        elif not topic.monitored:
            value = texts("topics.quiet")
        elif message is None:
            value = texts("topics.waiting")
        else:
            value, quiet = self._summary(message), False
        row = TopicRow(
            (topic.name,),
            ", ".join(topic.types),
            _bandwidth(topic.bandwidth) if topic.monitored else "",
            _rate(topic.rate) if topic.monitored else "",
            value,
            topic.monitored,
            quiet,
        )
        return Branch(row, partial(self._parts, topic, message))

    def _parts(self, topic: Topic, message: Any) -> list[Branch]:
        """What opening a topic shows: the fields of its message, then who is at its ends."""
        texts, path = self.look.texts, (topic.name,)
        parts = self._fields(path, topic.types[0] if topic.types else "", message)
        if topic.monitored:
            bars = _sparkline(topic.bars, BARS_WIDTH, self.look.glyphs.bars)
            parts.append(Branch(TopicRow((*path, texts("topics.history")), value=bars, quiet=True)))
        for key, ends in (("topics.publishers", topic.publishers), ("topics.subscriptions", topic.subscriptions)):
            row = TopicRow((*path, texts(key)), value=str(len(ends)), quiet=True)
            parts.append(Branch(row, partial(_ends, row.path, ends) if ends else None))
        return parts

    def _fields(self, path: Path, type_name: str, value: Any) -> list[Branch]:
        from day6_core.ros.programs.rqt_topic.fields import fields, has_fields

        try:
            found = fields(type_name, value)
        except (LookupError, ValueError):
            return []  # a type this machine does not know: listening tells so
        return [
            Branch(
                TopicRow((*path, field.name), field.type, value=self._summary(field.value)),
                partial(self._fields, (*path, field.name), field.type, field.value)
                if has_fields(field.type, field.value)
                else None,
            )
            for field in found
        ]

    def _summary(self, value: Any) -> str:
        from day6_core.ros.programs.rqt_topic.fields import summary

        return summary(value, self.table.columns.value)

    # -- keys ----------------------------------------------------------------------------------------------------------

    def _chosen_topic(self) -> Topic | None:
        chosen = self.table.chosen
        return next((topic for topic in self._topics if chosen and topic.name == chosen.path[0]), None)

    def used(self, event: events.Key) -> bool:
        """Handle a key of this window; return False for one of the tree's."""
        topic = self._chosen_topic()
        if event.key in ("enter", "space"):
            if topic is not None:
                self.tick(topic.name)
        elif event.character == "s":
            self._sort_by_next()
        elif event.character == "S":
            self._sort_by(self._sort)
        elif event.character == "/":
            self._ask_filter()
        elif event.character == "v":
            self._view()
        elif event.key == "escape" and self._filter:
            self._filter_by("")
        else:
            return False
        return True

    def on_key(self, event: events.Key) -> None:
        if self.used(event):
            event.stop()
            event.prevent_default()

    def _view(self) -> None:
        """Show the whole value of the chosen line, as it is now; of a topic of which nothing has come, what its type is."""
        from day6_core.ros.programs.rqt_topic.fields import text_of, value_at
        from day6_tui.overlays.message import LogModal

        topic, chosen = self._chosen_topic(), self.table.chosen
        if topic is None or chosen is None:
            return
        message = self._messages.get(topic.name, (0, None))[1]
        path = chosen.path if (value := value_at(message, chosen.path[1:])) is not None else chosen.path[:1]
        if message is not None:
            title, text = "/".join(path), text_of(message if value is None else value)
        else:
            title, text = _definition(topic)
        self.lay_over(LogModal(self.look, title, text.split("\n"), from_top=True))

    def tick(self, topic: str) -> None:
        """Listen to a topic, or stop."""
        self.model.toggle(topic)
        self.look.wake()

    def _sort_by_next(self) -> None:
        self._sort_by(SORTS[(SORTS.index(self._sort) + 1) % len(SORTS)])

    def _sort_by(self, column: str) -> None:
        """Sort by a column: the greatest number first; by the same once more: the other way round."""
        self._reverse = not self._reverse if column == self._sort else column in ("bandwidth", "hz")
        self._sort = column
        self.look.wake()

    def _ask_filter(self) -> None:
        def taken(text: str) -> None:
            self._filter_by(text.strip())

        self.ask(self.look.texts("topics.filter"), self._filter, taken, note=self.look.texts("topics.filter_note"))

    def _filter_by(self, text: str) -> None:
        self._filter = text
        self.look.wake()


def _definition(topic: Topic) -> tuple[str, str]:
    """The name and the text of the type of a topic; that of its action or service, if it belongs to one."""
    from day6_core.interfaces import definition_text

    name = topic.types[0] if "/msg/" in topic.types[0] else topic.types[0].partition("_")[0]
    try:
        return name, definition_text(name)
    except (LookupError, OSError, ValueError) as error:
        return topic.types[0], named_reason(error)


def _ends(path: Path, ends: Sequence[MonitoredEndpoint]) -> list[Branch]:
    return [Branch(TopicRow((*path, f"{end.node}"), value=end.qos)) for end in ends]


def _rate(rate: float | None) -> str:
    return "-" if rate is None else f"{rate:.2f}" if rate < 100 else f"{rate:.0f}"


def _bandwidth(bandwidth: float | None) -> str:
    if bandwidth is None:
        return "-"
    for unit, size in (("MB/s", 1e6), ("kB/s", 1e3)):
        if bandwidth >= size:
            return f"{_three_digits(bandwidth / size)} {unit}"
    return f"{bandwidth:.0f} B/s"


def _three_digits(number: float) -> str:
    return f"{number:.{2 if number < 10 else 1 if number < 100 else 0}f}"


def _sparkline(values: Sequence[float], width: int, bars: str) -> str:
    """The newest `width` values as bars from the lowest to the highest glyph; the highest value is full."""
    newest = list(values)[-width:]
    top = max(newest, default=0.0)
    if top <= 0:
        return bars[0] * width
    text = "".join(bars[max(1, round(value / top * (len(bars) - 1)))] if value > 0 else bars[0] for value in newest)
    return text.rjust(width)
