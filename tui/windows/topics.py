"""The topic monitor's window: the list of topics, and below it the details of the chosen one."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_tui.core.session.display import Window
from day6_tui.tui.cells import cell_len, clip, fit
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.core.ros.programs.rqt_topic.model import Topic, TopicMonitor


RATE_WIDTH, BANDWIDTH_WIDTH, BARS_WIDTH = 9, 10, 12
MOST_MESSAGE_LINES = 400
MESSAGE_SECONDS = 0.2
"""How often the text of the newest message is made: faster it could not be read."""

Line = list[Segment]


class TopicsPane(WindowPane["TopicMonitor"]):
    """Draws `TopicMonitor.topics`; keeps which topic is chosen."""

    def __init__(self, window: Window[TopicMonitor], look: Look) -> None:
        super().__init__(window, look)
        self.chosen = ""
        """The name of the chosen topic: it stays chosen when others come and go."""
        self._shown: list[Line] = []
        self._version = -1
        self._message: tuple[str, list[str]] = ("", [])
        self._message_at = -1.0
        self._count = -1

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        topic = self._topic()
        fresh = topic is not None and topic.monitored and topic.count != self._count
        if self.model.version == self._version and not fresh and self._shown:
            return False
        if fresh and now - self._message_at < MESSAGE_SECONDS and self._shown and self.model.version == self._version:
            return True
        self._version = self.model.version
        if topic is not None and topic.monitored:
            self._message_at = now
            self._count = topic.count
            self._message = (topic.name, _message_lines(self.model.last_message(topic.name)))
        self._show()
        return False

    def _show(self) -> None:
        """Build all lines and touch those that differ."""
        before, self._shown = self._shown, self._build(self.inner_width, self.inner_height)
        if len(before) != len(self._shown):
            self.touch()
        else:
            self.touch_lines(
                line for line, (old, new) in enumerate(zip(before, self._shown, strict=True)) if old != new
            )

    def _topic(self) -> Topic | None:
        topics = self.model.topics
        return next((topic for topic in topics if topic.name == self.chosen), topics[0] if topics else None)

    def _index(self) -> int:
        return next((index for index, topic in enumerate(self.model.topics) if topic.name == self.chosen), 0)

    # -- building ------------------------------------------------------------------------------------------------------

    def _build(self, width: int, height: int) -> list[Line]:
        topics = self.model.topics
        if not topics:
            return [[Segment(" " + self.look.texts("topics.none"), self.look.colours.muted)], *([[]] * (height - 1))]
        head = 1 if height > 8 else 0
        room = self._room(height)
        first = max(0, min(self._index() - room // 2, len(topics) - room))
        lines = [self._head(width)] * head
        lines += [self._topic_line(topic, width) for topic in topics[first : first + room]]
        self._first = first - head
        topic = self._topic()
        if height > head + room + 1 and topic is not None:
            lines.append([Segment(self.look.glyphs.border.horizontal * width, self.look.colours.frame)])
            lines += self._details(topic, width)
        return lines[:height] + [[]] * (height - len(lines))

    _first = 0
    """The index of the topic that the first line would show."""

    def _room(self, height: int) -> int:
        """Lines for topics in a window of this height."""
        return max(1, min(len(self.model.topics), height // 2 if height > 8 else height))

    def _head(self, width: int) -> Line:
        texts = self.look.texts
        tail = (
            f"{texts('topics.columns.publishers')} {self.look.glyphs.chevron} {texts('topics.columns.subscriptions')} "
        )
        name = fit("     " + texts("topics.columns.topic"), max(0, width - cell_len(tail)))
        return [Segment(name, self.look.colours.muted), Segment(tail, self.look.colours.muted)]

    def _topic_line(self, topic: Topic, width: int) -> Line:
        colours = self.look.colours
        on = topic is self._topic()
        box = "[x]" if topic.monitored else "[ ]"
        numbers = f"{len(topic.publishers):>3} {self.look.glyphs.chevron} {len(topic.subscriptions):<3}"
        tail = numbers
        bars = ""
        if topic.monitored:
            tail = f"{_rate(topic.rate):>{RATE_WIDTH}} {_bandwidth(topic.bandwidth):>{BANDWIDTH_WIDTH}} "
            bars = _sparkline(topic.bars, BARS_WIDTH, self.look.glyphs.bars)
        name_width = max(8, width - cell_len(tail) - cell_len(bars) - 6)
        name = fit(topic.name, name_width, self.look.glyphs.ellipsis)
        style = colours.choice if on and self.has_focus else None
        return [
            Segment(f" {box} ", style or (colours.publisher if topic.monitored else colours.muted)),
            Segment(name, style or (colours.strong if on else colours.topic)),
            Segment(" " + tail, style or colours.text),
            Segment(bars, style or colours.publisher),
        ]

    def _details(self, topic: Topic, width: int) -> list[Line]:
        texts, colours = self.look.texts, self.look.colours
        lines: list[Line] = [
            [
                Segment(f" {topic.name} ", colours.topic),
                Segment(clip(" ".join(topic.types), width, self.look.glyphs.ellipsis), colours.accent),
            ]
        ]
        for key, ends, style in (
            ("topics.publishers", topic.publishers, colours.publisher),
            ("topics.subscriptions", topic.subscriptions, colours.node),
        ):
            lines.append([Segment(f" {texts(key)} {len(ends)}", colours.muted)])
            lines += [[Segment(f"   {end.node}  ", style), Segment(end.qos, colours.muted)] for end in ends]
        if topic.problem:
            lines.append([Segment(" " + clip(topic.problem, width - 1, self.look.glyphs.ellipsis), colours.warning)])
        elif not topic.monitored:
            lines.append([Segment(" " + texts("topics.quiet"), colours.muted)])
        elif self._message[0] != topic.name or not self._message[1]:
            lines.append([Segment(" " + texts("topics.waiting"), colours.muted)])
        else:
            lines.append([Segment(f" {texts('topics.last')}", colours.muted)])
            lines += [[Segment("   " + line, colours.text)] for line in self._message[1]]
        return lines

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if len(self._shown) != self.inner_height:
            self._shown = self._build(width, self.inner_height)
        return self._shown[y] if y < len(self._shown) else ()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._shown = []

    def touch(self) -> None:
        self._shown = []  # built when it is drawn: the focus event comes before the focus itself
        super().touch()

    def status(self) -> list[Piece]:
        topics = self.model.topics
        return [Piece(f" {self._index() + 1}/{len(topics)} ", self.look.colours.muted)] if topics else []

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        topic = self._topic()
        key = "topics.stop" if topic is not None and topic.monitored else "topics.listen"
        return [("Enter", self.look.texts(key))]

    def on_key(self, event: events.Key) -> None:
        step = {"down": 1, "up": -1, "pagedown": 10, "pageup": -10, "home": -9999, "end": 9999}.get(event.key)
        if step is not None:
            self._choose(self._index() + step)
        elif event.key in ("enter", "space"):
            self._toggle()
        else:
            return
        event.stop()
        event.prevent_default()

    def _toggle(self) -> None:
        topic = self._topic()
        if topic is not None:
            self.model.toggle(topic.name)

    def _choose(self, index: int) -> None:
        topics = self.model.topics
        if topics:
            self.chosen = topics[max(0, min(len(topics) - 1, index))].name
            self._count = -1
            self.touch()
            self.look.wake()

    def on_click(self, event: events.Click) -> None:
        super().on_click(event)
        head = 1 if self.inner_height > 8 else 0
        line = event.y - 1
        if head <= line < head + self._room(self.inner_height):
            self._choose(self._first + line)
            if event.x <= 4:
                self._toggle()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        event.stop()
        self._choose(self._index() + 1)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        event.stop()
        self._choose(self._index() - 1)


def _message_lines(message: object) -> list[str]:
    """The message as `ros2 topic echo` prints it."""
    if message is None:
        return []
    from rosidl_runtime_py.convert import message_to_yaml

    text: str = message_to_yaml(message, truncate_length=64)
    return text.rstrip("\n").split("\n")[:MOST_MESSAGE_LINES]


def _rate(rate: float | None) -> str:
    return "- Hz" if rate is None else f"{rate:.2f} Hz" if rate < 100 else f"{rate:.0f} Hz"


def _bandwidth(bandwidth: float | None) -> str:
    if bandwidth is None:
        return "- B/s"
    for unit, size in (("MB/s", 1e6), ("kB/s", 1e3)):
        if bandwidth >= size:
            return f"{bandwidth / size:.2f} {unit}"
    return f"{bandwidth:.0f} B/s"


def _sparkline(values: Sequence[float], width: int, bars: str) -> str:
    """The newest `width` values as bars from the lowest to the highest glyph; the highest value is full."""
    newest = list(values)[-width:]
    top = max(newest, default=0.0)
    if top <= 0:
        return bars[0] * width
    text = "".join(bars[max(1, round(value / top * (len(bars) - 1)))] if value > 0 else bars[0] for value in newest)
    return text.rjust(width)
