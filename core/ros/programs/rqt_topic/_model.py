"""What the topic monitor shows: every topic with who speaks and who hears, and numbers for those it listens to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from day6_tui.core.graph.names import full_name
from day6_tui.core.interfaces import deserialize, get_message
from day6_tui.core.ros.programs.rqt_topic._measure import Measure
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.subscription import Subscription
    from rclpy.topic_endpoint_info import TopicEndpointInfo


@dataclass(frozen=True, slots=True)
class End:
    """A publisher or subscription: full name of its node, its QoS in words."""

    node: str
    qos: str


@dataclass(frozen=True, slots=True)
class Topic:
    """One topic. `rate` (Hz) and `bandwidth` (bytes per second) are None while nothing is measured."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[End, ...]
    subscriptions: tuple[End, ...]
    monitored: bool = False
    count: int = 0
    rate: float | None = None
    bandwidth: float | None = None
    bars: tuple[float, ...] = ()
    problem: str = ""
    """Why it cannot be listened to, in rclpy's words."""


class TopicMonitor:
    """The model of one topic monitor. The window may call `toggle` and `last_message` and read `topics` and `version`."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._ears: dict[str, _Ear] = {}
        self._problems: dict[str, str] = {}
        self._wishes: list[str] = []
        self.topics: tuple[Topic, ...] = ()
        self.version = 0
        self.on_wish: Callable[[], None] | None = None
        """Called (any thread) when the window wants something."""

    # -- the window's side ---------------------------------------------------------------------------------------------

    def toggle(self, topic: str) -> None:
        """Begin or stop to listen to a topic."""
        self._wishes.append(topic)
        if self.on_wish is not None:
            self.on_wish()

    def last_message(self, topic: str) -> Any | None:
        """The newest message of a topic that is listened to."""
        ear = self._ears.get(topic)
        data = ear.newest if ear is not None else None
        return deserialize(data, ear.type_class) if ear is not None and data is not None else None

    # -- the program's side --------------------------------------------------------------------------------------------

    def grant_wishes(self) -> None:
        """Do what the window asked for."""
        while self._wishes:
            topic = self._wishes.pop(0)
            ear = self._ears.pop(topic, None)
            if ear is not None:
                self._node.destroy_subscription(ear.subscription)
            else:
                self._listen(topic)
        self.refresh()

    def _listen(self, name: str) -> None:
        topic = next((topic for topic in self.topics if topic.name == name), None)
        if topic is None:
            return
        try:
            self._ears[name] = _Ear(self._node, name, topic.types[0])
            self._problems.pop(name, None)
        except Exception as error:
            # A type this machine does not know: the window says so, in the words of the import.
            self._problems[name] = f"{type(error).__name__}: {error}"

    def tick(self) -> None:
        """Close a step of every sparkline and look at the numbers."""
        now_ns = self._now_ns()
        for ear in self._ears.values():
            ear.measure.tick(now_ns)
        self.refresh()

    @property
    def listening(self) -> bool:
        return bool(self._ears)

    def refresh(self) -> None:
        """Look at the graph and at the numbers again."""
        now_ns = self._now_ns()
        found = tuple(
            self._topic(name, tuple(types), now_ns) for name, types in sorted(self._node.get_topic_names_and_types())
        )
        if found != self.topics:
            self.topics = found
            self.version += 1

    def _topic(self, name: str, types: tuple[str, ...], now_ns: int) -> Topic:
        publishers = tuple(map(_end, self._node.get_publishers_info_by_topic(name)))
        subscriptions = tuple(map(_end, self._node.get_subscriptions_info_by_topic(name)))
        ear = self._ears.get(name)
        if ear is None:
            return Topic(name, types, publishers, subscriptions, problem=self._problems.get(name, ""))
        rates = ear.measure.rates(now_ns)
        rate, bandwidth = rates if rates is not None else (None, None)
        return Topic(name, types, publishers, subscriptions, True, ear.measure.count, rate, bandwidth, ear.measure.bars)

    def _now_ns(self) -> int:
        return int(self._node.get_clock().now().nanoseconds)


class _Ear:
    """Listens to one topic: counts, and keeps the newest message as it came."""

    def __init__(self, node: Node, topic: str, type_name: str) -> None:
        self.type_class = get_message(type_name)
        self.measure = Measure()
        self.newest: bytes | None = None
        self._clock = node.get_clock()
        self.subscription: Subscription[Any] = node.create_subscription(
            self.type_class, topic, self._hear, _qos_for(node.get_publishers_info_by_topic(topic)), raw=True
        )

    def _hear(self, data: bytes) -> None:
        self.newest = data
        self.measure.add(int(self._clock.now().nanoseconds), len(data))


def _qos_for(offers: list[TopicEndpointInfo]) -> QoSProfile:
    """A profile that hears every publisher: reliable or lasting only where all of them are, as `ros2 topic echo` chooses."""
    profiles = [offer.qos_profile for offer in offers]
    reliable = bool(profiles) and all(profile.reliability == ReliabilityPolicy.RELIABLE for profile in profiles)
    lasting = bool(profiles) and all(profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for profile in profiles)
    return QoSProfile(
        depth=10,
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if lasting else DurabilityPolicy.VOLATILE,
    )


def _end(info: TopicEndpointInfo) -> End:
    profile = info.qos_profile
    words = [profile.reliability.name, profile.durability.name]
    if profile.depth:
        words.append(f"{profile.history.name} ({profile.depth})")
    return End(full_name(info.node_namespace, info.node_name), " ".join(words))
