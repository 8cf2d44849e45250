"""What the topic monitor shows: every topic with its publishers and subscriptions, and numbers for the monitored ones."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from day6_core.graph.names import full_name
from day6_core.interfaces import DeserializationError, deserialize, serialize
from day6_core.ros.programs.rqt_topic._measure import Measure
from day6_core.ros.programs.rqt_topic.fields import message_class
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.subscription import Subscription
    from rclpy.topic_endpoint_info import TopicEndpointInfo


MOST_BYTES = 8_000_000
"""A larger message is counted, but not read: that would hold up the window."""


@dataclass(frozen=True, slots=True)
class MonitoredEndpoint:
    """A publisher or subscription: full name of its node, its QoS in words."""

    node: str
    qos: str


@dataclass(frozen=True, slots=True)
class Topic:
    """One topic. `rate` (Hz) and `bandwidth` (bytes per second) are None while nothing is measured."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[MonitoredEndpoint, ...]
    subscriptions: tuple[MonitoredEndpoint, ...]
    monitored: bool = False
    count: int = 0
    rate: float | None = None
    bandwidth: float | None = None
    bars: tuple[float, ...] = ()
    problem: str = ""
    """Why subscribing or reading the newest message failed, in the words of the error."""


class TopicMonitor:
    """The model of one topic monitor. The window may call `toggle` and `last_message` and read `topics` and `version`."""

    def __init__(self, node: Node, now_ns: Callable[[], int], selected: Iterable[str] = ()) -> None:
        self._node, self._now_ns = node, now_ns
        self._monitors: dict[str, _Monitor] = {}
        self._problems: dict[str, str] = {}
        self._toggled: list[str] = []
        self._awaited = set(selected)
        """Topics to listen to as soon as they are there."""
        self.topics: tuple[Topic, ...] = ()
        self.version = 0
        self.on_request: Callable[[], None] | None = None
        """Called (any thread) when the window wants something."""

    # -- the window's side ---------------------------------------------------------------------------------------------

    def toggle(self, topic: str) -> None:
        """Start or stop monitoring a topic."""
        self._toggled.append(topic)
        if self.on_request is not None:
            self.on_request()

    def last_message(self, topic: str) -> Any | None:
        """The newest message of a monitored topic; None if there is none, or none that can be shown (see `problem`)."""
        monitor = self._monitors.get(topic)
        data = monitor.newest if monitor is not None else None
        if monitor is None or data is None:
            return None
        monitor.problem = ""
        try:
            if len(data) <= MOST_BYTES:
                return deserialize(data, monitor.type_class)
            monitor.problem = f"{len(data)} bytes"
        except DeserializationError as error:
            monitor.problem = str(error)
        return None

    # -- the program's side --------------------------------------------------------------------------------------------

    def handle_requests(self) -> None:
        """Carry out the window's requests, and read the graph."""
        while self._toggled:
            topic = self._toggled.pop(0)
            self._awaited.discard(topic)
            monitor = self._monitors.pop(topic, None)
            if monitor is not None:
                self._node.destroy_subscription(monitor.subscription)
            else:
                self._listen(topic)
        self.refresh()

    def _listen(self, name: str) -> None:
        topic = next((topic for topic in self.topics if topic.name == name), None)
        if topic is None:
            return
        try:
            self._monitors[name] = _Monitor(self._node, name, topic.types[0], self._now_ns)
            self._problems.pop(name, None)
        except Exception as error:
            # A type this machine does not know: the window says so, in the words of the import.
            self._problems[name] = f"{type(error).__name__}: {error}"

    def tick(self) -> None:
        """Close a step of every sparkline and look at the numbers."""
        now_ns = self._now_ns()
        for monitor in self._monitors.values():
            monitor.measure.tick(now_ns)
        self._show(self.topics)

    @property
    def selected(self) -> list[str]:
        """The topics that are listened to, or will be as soon as they are there."""
        return [*self._monitors, *sorted(self._awaited)]

    def close(self) -> None:
        """Stop listening."""
        for monitor in self._monitors.values():
            self._node.destroy_subscription(monitor.subscription)
        self._monitors.clear()

    def refresh(self) -> None:
        """Read the graph: all topics, and who is at their ends."""
        node = self._node
        self._show(
            Topic(
                name,
                tuple(types),
                tuple(map(_endpoint, node.get_publishers_info_by_topic(name))),
                tuple(map(_endpoint, node.get_subscriptions_info_by_topic(name))),
            )
            for name, types in sorted(node.get_topic_names_and_types())
        )
        for name in self._awaited.intersection(topic.name for topic in self.topics):
            self._awaited.discard(name)
            self._listen(name)

    def _show(self, topics: Iterable[Topic]) -> None:
        """Show topics with the newest numbers."""
        now_ns = self._now_ns()
        found = tuple(self._with_numbers(topic, now_ns) for topic in topics)
        if found != self.topics:
            self.topics = found
            self.version += 1

    def _with_numbers(self, topic: Topic, now_ns: int) -> Topic:
        monitor = self._monitors.get(topic.name)
        if monitor is None:
            problem = self._problems.get(topic.name, "")
            if not topic.monitored and topic.problem == problem:
                return topic
            return Topic(topic.name, topic.types, topic.publishers, topic.subscriptions, problem=problem)
        measure = monitor.measure
        rate, bandwidth = measure.rates(now_ns) or (None, None)
        numbers = (True, measure.count, rate, bandwidth, measure.bars, monitor.problem)
        return Topic(topic.name, topic.types, topic.publishers, topic.subscriptions, *numbers)


class _Monitor:
    """The subscription to one monitored topic: counts messages, and keeps the newest one serialized.

    Counted on the thread that receives them: to wake the program for each of thousands a second costs more than all the rest.
    """

    def __init__(self, node: Node, topic: str, type_name: str, now_ns: Callable[[], int]) -> None:
        self.type_class = message_class(type_name)
        self.measure = Measure()
        self.newest: bytes | None = None
        self.problem = ""
        self._now_ns = now_ns
        self.subscription: Subscription[Any] = node.create_subscription(
            self.type_class, topic, self._on_message, _qos_for(node.get_publishers_info_by_topic(topic)), raw=True
        )
        self.subscription.handle.take_at_once(self._on_message)

    def _on_message(self, message: Any) -> None:
        self.newest = data = message if isinstance(message, bytes) else serialize(message)
        self.measure.add(self._now_ns(), len(data))


def _qos_for(offers: list[TopicEndpointInfo]) -> QoSProfile:
    """A profile compatible with every publisher: reliable or lasting only where all of them are, as `ros2 topic echo` chooses."""
    profiles = [offer.qos_profile for offer in offers]
    reliable = bool(profiles) and all(profile.reliability == ReliabilityPolicy.RELIABLE for profile in profiles)
    lasting = bool(profiles) and all(profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for profile in profiles)
    return QoSProfile(
        depth=10,
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if lasting else DurabilityPolicy.VOLATILE,
    )


def _endpoint(info: TopicEndpointInfo) -> MonitoredEndpoint:
    profile = info.qos_profile
    words = [profile.reliability.name, profile.durability.name]
    if profile.depth:
        words.append(f"{profile.history.name} ({profile.depth})")
    return MonitoredEndpoint(full_name(info.node_namespace, info.node_name), " ".join(words))
