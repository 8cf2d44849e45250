"""Plays: moves the playhead, and publishes what it passes on topics with the QoS that was recorded.

A jump publishes of every chosen topic the newest message at or before the playhead, unless it was the last one published; of a
topic whose publisher keeps messages for late subscriptions (transient local) as many as it keeps, so that all of /tf_static is
there. Playing publishes every message that is passed, in order; where this computer can't keep up, the playhead waits. The real
rqt_bag publishes only while it plays, and only the newest message of a topic each time it looks; here Plot and RViz follow
scrubbing too.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from rosbag2_py._playing import CLOCK_QOS
from rosbag2_py._qos import convert_rclcpp_qos_to_rclpy_qos, offer_for
from rosbag2_py._storage import NANOSECONDS, Message, TopicMetadata
from rosgraph_msgs.msg import Clock

from day6_core.interfaces import get_interface
from day6_core.reason import reason
from day6_core.ros.programs.rqt_bag.model.playhead import Playhead
from day6_core.ros.programs.rqt_bag.model.timeline import MOST_AT_ONCE, Found, Passed, Timeline
from day6_core.session.task import Signal, let_others_run, wait_for
from day6_core.session.threads import in_thread
from rclpy.qos import DurabilityPolicy

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher

AT_ONCE = 100
"""Messages published in one go before other programs get their turn."""

AHEAD_NS = NANOSECONDS // 4
"""How far ahead of the playhead messages are read, in time of the world."""

EARLY_NS = NANOSECONDS // 20
"""How long before they are needed."""

SHORTEST_NS = NANOSECONDS // 100
"""A region that is over sooner is not played again and again."""


class Player:
    """`run` plays; all methods are for the scheduler's thread. `topics` are those of the open bags."""

    def __init__(self, node: Node, timeline: Timeline, steady_ns: Callable[[], int], *, publish_clock: bool) -> None:
        self._node = node
        self._timeline = timeline
        self._steady_ns = steady_ns
        self.topics: Mapping[str, TopicMetadata] = {}
        self.playhead = Playhead(steady_ns)
        self.region: tuple[int, int] | None = None
        """What is played, when it is not everything."""
        self.current: dict[str, Message] = {}
        """The newest messages at or before the playhead, of published and watched topics."""
        self.watched: frozenset[str] = frozenset()
        self.problem = ""
        """Why something could not be published or read, '' if it could."""
        self.version = 0
        """Grows with each message in `current` and each choice of a topic."""
        self._publishers: dict[str, Publisher[Any]] = {}
        self._clock = node.create_publisher(Clock, "/clock", CLOCK_QOS) if publish_clock else None
        self._last: dict[str, Found] = {}
        """The newest message of each topic that was published, or taken for `current`."""
        self._queue: deque[Passed] = deque()
        self._read_to = 0
        self._jumped = False
        self.arriving = False
        """Whether what is at the playhead is being read."""
        self._steps = 0
        self._changed = Signal()

    # -- topics --------------------------------------------------------------------------------------------------------

    @property
    def publishing(self) -> frozenset[str]:
        """The topics that are published."""
        return frozenset(self._publishers)

    def start_publishing(self, topic: str) -> bool:
        """Publish a topic from now on, beginning with its message at the playhead; False if that cannot be."""
        about = self.topics.get(topic)
        if about is None or topic in self._publishers:
            return about is not None
        profile, _ = offer_for(about.offered_qos_profiles)
        try:
            kind = get_interface(about.type)
            self._publishers[topic] = self._node.create_publisher(kind, topic, convert_rclcpp_qos_to_rclpy_qos(profile))
        except Exception as error:
            # Whatever is wrong with a type, the other topics can be published.
            self.problem = f"Error creating publisher on topic {topic} for type {about.type}. \nError text: {error}"
            self._node.get_logger().get_child("rqt_bag.Player").error(self.problem)
            return False
        self._last.pop(topic, None)
        self._rejoin()
        return True

    def stop_publishing(self, topic: str) -> None:
        """No longer publish a topic."""
        publisher = self._publishers.pop(topic, None)
        if publisher is not None:
            self._node.destroy_publisher(publisher)
            self.version += 1

    def watch(self, topics: Iterable[str]) -> None:
        """Keep the messages of these topics in `current` too."""
        self.watched = frozenset(topics)
        for topic in self.current.keys() - self.watched - self.publishing:
            del self.current[topic]
            self._last.pop(topic, None)
        self._rejoin()

    def _rejoin(self) -> None:
        """Something else is played from now on: what was read ahead is of no use, and what is at the playhead may be missing."""
        self.version += 1
        self.jump(self.now())

    def forget(self, timeline: Timeline) -> None:
        """The bags are closed; go on with another timeline."""
        for topic in list(self._publishers):
            self.stop_publishing(topic)
        self.topics, self.watched, self.region, self.problem = {}, frozenset(), None, ""
        self._last.clear()
        self.current.clear()
        self._queue.clear()
        self.playhead.set_speed(0.0)
        self._timeline = timeline
        self._jumped, self._steps = False, 0
        self.version += 1

    def close(self) -> None:
        """Destroy what it has on the node."""
        self.forget(self._timeline)
        if self._clock is not None:
            self._node.destroy_publisher(self._clock)

    # -- moving --------------------------------------------------------------------------------------------------------

    def now(self) -> int:
        """Where the playhead is, in nanoseconds since 1970 (any thread)."""
        now = self.playhead.now()
        return min(now, max(self._read_to, self.playhead._at)) if self.playhead.speed > 0 else now

    @property
    def play_region(self) -> tuple[int, int]:
        """What is played: the selected region, or everything."""
        return self.region or (self._timeline.start_ns or 0, self._timeline.end_ns or 0)

    def jump(self, at_ns: int) -> None:
        """Move the playhead; what is there is published as soon as it is read."""
        self.playhead.jump(at_ns)
        self._read_to = at_ns
        self._queue.clear()
        self._jumped = True
        self._changed.set()

    def select(self, region: tuple[int, int] | None) -> None:
        """Play only a part, or everything again."""
        self.region = region
        self._rejoin()

    def set_speed(self, speed: float) -> None:
        """Play at a speed, backwards if it is negative, or stand (0)."""
        self.playhead.jump(self.now())
        self.playhead.set_speed(speed)
        begin, end = self.play_region
        if speed > 0 and self.playhead.now() >= end:
            self.jump(begin)
        self._changed.set()

    def step(self, count: int) -> None:
        """Stand, and move to the next message (+1) or the one before (-1), of whatever topic."""
        self.set_speed(0.0)
        self._steps += count
        self._changed.set()

    # -- playing -------------------------------------------------------------------------------------------------------

    async def run(self) -> None:
        """Play, for ever."""
        while True:
            self._changed.clear()
            try:
                if self._steps:
                    await self._step()
                elif self._jumped:
                    await self._arrive()
                elif self._needs_more():
                    await self._read_ahead()
                else:
                    due = self._advance()
                    if due is not None and due <= self._steady_ns():
                        await let_others_run()
                    else:
                        await wait_for(self._changed, due)
            except (RuntimeError, OSError) as error:
                # A damaged bag is played as far as it can be read.
                if self.topics:  # otherwise it was closed meanwhile
                    self.problem = reason(error)
                self.playhead.set_speed(0.0)

    def _topics(self) -> list[str]:
        return [*self.publishing | self.watched]

    async def _step(self) -> None:
        forward, self._steps = self._steps > 0, self._steps - (1 if self._steps > 0 else -1)
        at, timeline, topics = self.playhead.now(), self._timeline, list(self.topics)
        found = await in_thread(
            lambda: timeline.next_time(topics, at) if forward else timeline.previous_time(topics, at)
        )
        begin, end = timeline.start_ns or 0, timeline.end_ns or 0
        self.jump((begin if forward else end) if found is None else found)

    async def _arrive(self) -> None:
        """Publish what is at the playhead."""
        self._jumped = False
        at, timeline, last = self.playhead._at, self._timeline, dict(self._last)
        wanted = {topic: self._depth(topic) for topic in self._topics()}

        def read() -> list[Passed]:
            found = [
                each
                for topic, most in wanted.items()
                for each in _unless_known(timeline.newest(topic, at, most), last.get(topic))
            ]
            return [Passed(each, each.read()) for each in sorted(found, key=lambda each: each.time_ns)]

        self.arriving = True
        try:
            passed = await in_thread(read)
        finally:
            self.arriving = False
        self._publish_clock(at)
        for each in passed:
            self._pass(each, clock=False)
        for topic in self.current.keys() - {each.found.topic for each in passed}:
            if self.current[topic].received_ns > at:  # there is none before the playhead
                del self.current[topic]
                self._last.pop(topic, None)
                self.version += 1

    def _depth(self, topic: str) -> int:
        """How many messages a jump publishes."""
        publisher = self._publishers.get(topic)
        if publisher is None or publisher.qos_profile.durability != DurabilityPolicy.TRANSIENT_LOCAL:
            return 1
        return max(1, int(publisher.qos_profile.depth))

    def _needs_more(self) -> bool:
        playhead = self.playhead
        if playhead.speed <= 0 or self._read_to >= self.play_region[1]:
            return False
        return playhead.steady_at(self._read_to) - self._steady_ns() <= EARLY_NS and len(self._queue) < MOST_AT_ONCE

    async def _read_ahead(self) -> None:
        topics, timeline, after = self._topics(), self._timeline, self._read_to
        until = min(after + round(AHEAD_NS * max(1.0, self.playhead.speed)), self.play_region[1])
        passed, read_to = await in_thread(lambda: timeline.read(topics, after, until))
        if self._jumped or self._read_to != after:
            return
        # Time that was lost by reading is made up for; more than that, and the playhead waits.
        if self.playhead.speed > 0 and self._steady_ns() - self.playhead.steady_at(after) > EARLY_NS:
            self.playhead.jump(after)
        self._queue.extend(passed)
        self._read_to = read_to

    def _advance(self) -> int | None:
        """Publish what is due; returns the steady time at which there is more to do, None while the playhead stands."""
        playhead = self.playhead
        if not playhead.speed:
            return None
        begin, end = self.play_region
        if playhead.speed < 0:
            if playhead.has_reached(begin):
                self._wrap(end)
                return None
            return playhead.steady_at(begin)
        if playhead.now() < begin:
            self.jump(begin)
            return None
        for _ in range(AT_ONCE):
            if not self._queue or not playhead.has_reached(self._queue[0].found.time_ns):
                break
            self._pass(self._queue.popleft(), clock=True)
        if playhead.has_reached(end) and not self._queue and self._read_to >= end:
            self._wrap(begin)
            return None
        more = self._read_to < end and len(self._queue) < MOST_AT_ONCE
        due = [playhead.steady_at(self._queue[0].found.time_ns)] if self._queue else []
        due += [playhead.steady_at(self._read_to) - EARLY_NS] if more else []
        return min(due, default=playhead.steady_at(end))

    def _wrap(self, at_ns: int) -> None:
        """Go on at the other end, as rqt_bag does; unless it would be reached again at once."""
        begin, end = self.play_region
        if end - begin < SHORTEST_NS * abs(self.playhead.speed):
            self.set_speed(0.0)
        else:
            self.jump(at_ns)

    # -- publishing ----------------------------------------------------------------------------------------------------

    def _pass(self, passed: Passed, *, clock: bool) -> None:
        topic, message = passed.found.topic, passed.message
        self._last[topic] = passed.found
        self.current[topic] = message
        self.version += 1
        publisher = self._publishers.get(topic)
        if publisher is None:
            return
        if clock:
            self._publish_clock(message.received_ns)
        try:
            publisher.publish(message.data)
        except Exception as error:
            # One damaged message must not end the playback.
            self.problem = f"Failed to publish message on '{topic}' topic. \nError: {error}"

    def _publish_clock(self, at_ns: int) -> None:
        if self._clock is None:
            return
        clock = Clock()
        clock.clock.sec, clock.clock.nanosec = divmod(at_ns, NANOSECONDS)
        self._clock.publish(clock)


def _unless_known(found: list[Found], last: Found | None) -> list[Found]:
    """Nothing, if the newest one is the last one that was published."""
    same = found and last is not None and found[-1][:3] == last[:3] and found[-1].source is last.source
    return [] if same else found
