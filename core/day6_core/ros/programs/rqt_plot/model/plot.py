"""What the plot shows: curves of numbers over world time, the span of time that is seen, and whether it stands still."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.interfaces import UnknownInterfaceError, get_message
from day6_core.ros.programs.rqt_plot.model.field import NoField, find_topic, plottable, reader, split_paths
from rclpy.qos import QoSProfile, ReliabilityPolicy

if TYPE_CHECKING:
    from rclpy.node import Node

SPANS = (2.0, 5.0, 10.0, 20.0, 60.0, 300.0)
"""Seconds that can be seen at once."""

DEFAULT_SPAN = 10.0
MOST = 40_000
"""Points of one curve that are kept."""

EAR = QoSProfile(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT)
"""Compatible with every publisher."""


class Curve:
    """One number over time. `times` are seconds of world time, `values` as long; both only grow, and are replaced as a whole."""

    def __init__(self, path: str, number: int) -> None:
        self.path = path
        self.number = number
        """Which of the colours it has; a removed curve's becomes free."""
        self.points: tuple[list[float], list[float]] = ([], [])
        self.problem = ""
        """Why there is nothing: an error in the path, or nobody publishes the topic ('')."""
        self.topic = ""
        self.read: Callable[[Any], float | None] | None = None

    @property
    def last(self) -> float | None:
        """The newest value."""
        values = self.points[1]
        return values[-1] if values else None

    def add(self, time: float, value: float) -> None:
        """Append a point."""
        times, values = self.points
        if len(values) >= 2 * MOST:
            # New lists, because the window may be going through the old ones.
            times, values = times[-MOST:], values[-MOST:]
            self.points = (times, values)
        times.append(time)
        values.append(value)

    def clear(self) -> None:
        """Forget the points."""
        self.points = ([], [])


class Plot:
    """The model. The window reads `curves`, `span`, `now()` and calls the methods of its side."""

    def __init__(self, node: Node, steady_ns: Callable[[], int]) -> None:
        self._node = node
        self._steady_ns = steady_ns
        self._subscriptions: dict[str, Any] = {}
        self._requests: list[Callable[[], None]] = []
        self.curves: tuple[Curve, ...] = ()
        self.span = DEFAULT_SPAN
        self.paused_at: float | None = None
        self.version = 0
        """Grows with everything but new points and the time."""
        self.received = 0
        """Points so far, of all curves."""
        self.message = ""
        """Why the last request failed, '' if it did not."""
        self.on_request: Callable[[], None] | None = None
        """Called (any thread) when the window wants something."""

    # -- the window's side ---------------------------------------------------------------------------------------------

    def now(self) -> float:
        """The right edge of the picture, in seconds of world time."""
        return self._steady_ns() / 1e9 if self.paused_at is None else self.paused_at

    def add(self, words: str) -> None:
        """Plot more fields: paths as on the command line, with spaces between them."""
        self._request(lambda: self._add(words))

    def remove(self, curve: Curve) -> None:
        """Stop plotting a field."""
        self._request(lambda: self._remove(curve))

    def toggle_paused(self) -> None:
        """Let the picture stand still, or run again. Points go on being kept."""
        self.paused_at = None if self.paused_at is not None else self.now()
        self.version += 1

    def clear(self) -> None:
        """Forget all points."""
        for curve in self.curves:
            curve.clear()
        self.version += 1

    def zoom(self, step: int) -> None:
        """Show more (+1) or less (-1) time."""
        place = SPANS.index(self.span) + step
        self.span = SPANS[max(0, min(len(SPANS) - 1, place))]
        self.version += 1

    def _request(self, request: Callable[[], None]) -> None:
        self._requests.append(request)
        if self.on_request is not None:
            self.on_request()

    def suggestions(self) -> list[str]:
        """Return paths that can be plotted, for completing what is typed; hidden and internal topics are left out."""
        found = []
        for topic, types in self._node.get_topic_names_and_types():
            if "/_" in topic or topic in ("/rosout", "/parameter_events"):
                continue
            try:
                found += [f"{topic}/{field}" for field in plottable(topic, types[0], "")]
            except (NoField, UnknownInterfaceError, ValueError):
                continue  # a topic without numbers, or of a type that is not here
        return sorted(found)

    # -- the program's side --------------------------------------------------------------------------------------------

    def handle_requests(self) -> None:
        """Carry out the window's requests, and look again for missing topics."""
        while self._requests:
            self.message = ""
            self._requests.pop(0)()
            self.version += 1
        self.connect()

    def _add(self, words: str) -> None:
        for word in words.split():
            for path in split_paths(word if word.startswith("/") else f"/{word}"):
                self._add_path(path)

    def add_now(self, words: list[str]) -> None:
        """Begin with the fields of the command line."""
        self._add(" ".join(words))
        self.connect()

    def _add_path(self, path: str) -> None:
        """Add a field. A path into a message stands for all numbers in it, if its topic is there."""
        try:
            paths = self._expand(path)
        except NoField as error:
            self.message = str(error)
            return
        for each in paths:
            if any(curve.path == each for curve in self.curves):
                continue
            taken = {curve.number for curve in self.curves}
            free = next(number for number in range(len(taken) + 1) if number not in taken)
            self.curves = (*self.curves, Curve(each, free))
        self.version += 1

    def _expand(self, path: str) -> list[str]:
        found = find_topic(path, dict(self._node.get_topic_names_and_types()))
        if found is None:
            return [path]
        topic, type_name, rest = found
        try:
            return [f"{topic}/{field}" for field in plottable(topic, type_name, rest)]
        except (UnknownInterfaceError, ValueError) as error:
            raise NoField(str(error)) from None

    def _remove(self, curve: Curve) -> None:
        self.curves = tuple(each for each in self.curves if each is not curve)
        if curve.topic and all(each.topic != curve.topic for each in self.curves):
            self._node.destroy_subscription(self._subscriptions.pop(curve.topic))

    def close(self) -> None:
        """Stop listening."""
        for subscription in self._subscriptions.values():
            self._node.destroy_subscription(subscription)
        self._subscriptions.clear()

    def connect(self) -> None:
        """Subscribe for the curves whose topics have appeared."""
        waiting = [curve for curve in self.curves if curve.read is None and not curve.problem]
        if not waiting:
            return
        topics = dict(self._node.get_topic_names_and_types())
        for curve in waiting:
            found = find_topic(curve.path, topics)
            if found is not None:
                self._connect(curve, *found)
                self.version += 1

    def _connect(self, curve: Curve, topic: str, type_name: str, rest: str) -> None:
        try:
            fields = plottable(topic, type_name, rest)
            if fields != ["/".join(step for step in rest.split("/") if step)]:
                # It was asked for before its topic was there: now it is known what it means.
                self.curves = tuple(each for each in self.curves if each is not curve)
                for field in fields:
                    self._add_path(f"{topic}/{field}")
                self.connect()
                return
            kind = get_message(type_name)
        except (NoField, UnknownInterfaceError, ValueError) as error:
            curve.problem = str(error)
            return
        curve.topic, curve.read = topic, reader(rest)
        if topic not in self._subscriptions:
            self._subscriptions[topic] = self._node.create_subscription(
                kind, topic, lambda message: self._hear(topic, message), EAR
            )

    def _hear(self, topic: str, message: Any) -> None:
        now = self._steady_ns() / 1e9
        for curve in self.curves:
            if curve.topic == topic and curve.read is not None:
                value = curve.read(message)
                if value is not None:
                    curve.add(now, value)
                    self.received += 1
