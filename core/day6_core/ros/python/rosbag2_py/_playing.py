"""The player without any waiting: `ros2 bag play` and `Player` call `advance` whenever it is due."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from rosgraph_msgs.msg import Clock

from day6_core.interfaces import get_interface
from day6_core.ros.differences import value
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rosbag2_py._bag_clock import BagClock
from rosbag2_py._options import PlayOptions
from rosbag2_py._qos import convert_rclcpp_qos_to_rclpy_qos, offer_for
from rosbag2_py._reader import SequentialReader, last_moment
from rosbag2_py._service_requests import ServiceRequests
from rosbag2_py._storage import Message, StorageFilter, TopicMetadata, nanoseconds_of
from rosbag2_py._topic_filter import action_of, is_service_event, topics_of_actions

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher

NODE_NAME = "rosbag2_player"
SECOND = 1_000_000_000
AT_ONCE = 100
"""Messages published in one go before other programs get their turn, however late the playback is."""

RATE_STEP = 0.1

CLOCK_QOS = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.VOLATILE)
"""rclcpp::ClockQoS."""


class Playing:
    """Plays bags on `node`. Call `advance` when it is due, after each `on_wake`, and until `finished`.

    `readers` are open. `steady_ns` paces the playback (nanoseconds). `on_wake` is called when a service or a key has changed
    something, so that the caller stops waiting and calls `advance` again.
    """

    def __init__(
        self,
        node: Node,
        readers: list[SequentialReader],
        options: PlayOptions,
        *,
        keyboard: bool,
        steady_ns: Callable[[], int],
        on_wake: Callable[[], None],
    ) -> None:
        self._node = node
        self._readers = readers
        self._options = options
        self._log = node.get_logger()
        self._steady_ns = steady_ns
        self._wake = on_wake
        self.finished = False
        self._bursting = False
        self._stream: Iterator[Message] | None = None
        self._next: Message | None = None
        self._publishers: dict[str, Publisher[Any]] = {}
        self._requests: ServiceRequests | None = None
        if options.publish_service_requests or options.send_actions_as_client:
            self._requests = ServiceRequests(node, options.service_requests_source)
        self._clock_due: int | None = None
        self._delay_until: int | None = None
        metadata = [reader.get_metadata() for reader in readers]
        self.bag_start = min((nanoseconds_of(each.starting_time) for each in metadata if each.message_count), default=0)
        self.bag_end = max((last_moment(each) for each in metadata), default=0)
        self.start_ns = self.bag_start + round(options.start_offset * SECOND)
        self.clock = BagClock(self.start_ns, steady_ns, paused=options.start_paused)
        self.set_rate(options.rate)
        self._make_publishers()
        self._configure_end()
        if keyboard:
            self._log.info("Adding keyboard callbacks.")
            for key, what in KEYS:
                self._log.info(f"Press {key} for {what}")

    # -- publishers ----------------------------------------------------------------------------------------------------

    def _make_publishers(self) -> None:
        options = self._options
        actions = topics_of_actions(options.actions_to_filter)
        not_actions = topics_of_actions(options.exclude_actions_to_filter)
        chosen = StorageFilter(
            topics=self._all_full([*options.topics_to_filter, *actions]),
            services_events=self._all_full([*options.services_to_filter, *actions]),
            regex=options.regex_to_filter,
            exclude_topics=self._all_full([*options.exclude_topics_to_filter, *not_actions]),
            exclude_service_events=self._all_full([*options.exclude_service_events_to_filter, *not_actions]),
            regex_to_exclude=options.exclude_regex_to_filter,
        )
        self._clock_publisher: Publisher[Clock] | None = None
        if options.clock_publish_frequency > 0 or options.clock_publish_on_topic_publish:
            self._clock_publisher = self._node.create_publisher(Clock, "/clock", CLOCK_QOS)
        if options.clock_publish_frequency > 0:
            self._clock_period = round(SECOND / options.clock_publish_frequency)
            self._clock_due = self._steady_ns() + self._clock_period
        for reader in self._readers:
            reader.set_filter(chosen)
            for topic in reader.get_all_topics_and_types():
                if not chosen.allows(topic.name):
                    continue
                if self._requests is not None and self._is_sent_again(topic):
                    self._requests.add(topic)
                elif topic.name not in self._publishers:
                    self._make_publisher(topic)
        self._warn_of_acknowledgements()

    def _is_sent_again(self, topic: TopicMetadata) -> bool:
        """Whether calls are sent in place of the messages of a topic; what an action's server publishes itself, isn't."""
        if action_of(topic.name, topic.type):
            return self._options.send_actions_as_client
        return self._options.publish_service_requests and is_service_event(topic.name, topic.type)

    def _all_full(self, topics: Iterable[str]) -> list[str]:
        return list(map(self._full, topics))

    def _full(self, topic: str) -> str:
        from rclpy.expand_topic_name import expand_topic_name

        return expand_topic_name(topic, self._node.get_name(), self._node.get_namespace())

    def _make_publisher(self, topic: TopicMetadata) -> None:
        override = self._options.topic_qos_profile_overrides.get(topic.name)
        if override is not None:
            self._log.info(f"Overriding QoS profile for topic {topic.name}")
            profile = override
        else:
            qos, agreed = offer_for(topic.offered_qos_profiles)
            if not agreed:
                self._log.warning(
                    f"Not all original publishers on topic {topic.name} offered the same QoS profiles. Rosbag2 cannot yet "
                    "choose an adapted profile to offer for this mixed case. Falling back to the rosbag2_storage default "
                    "publisher offer."
                )
            profile = convert_rclcpp_qos_to_rclpy_qos(qos)
        try:
            kind = get_interface(topic.type)
            self._publishers[topic.name] = self._node.create_publisher(kind, topic.name, profile)
        except Exception as error:
            # Whatever is wrong with a type, the other topics are played.
            self._log.warning(f"Ignoring a topic '{topic.name}', reason: {error}.")

    def _warn_of_acknowledgements(self) -> None:
        if self._options.wait_acked_timeout < 0:
            return
        best_effort = [
            name
            for name, publisher in self._publishers.items()
            if publisher.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
        ]
        if best_effort:
            self._log.warning(
                "--wait-for-all-acked is invalid for the below topics since reliability of QOS is BestEffort.\n"
                + ", ".join(best_effort)
            )

    def _configure_end(self) -> None:
        """Set the end of the playback: the later one of both limits, as in the real player."""
        limits = [self._options.playback_until_timestamp]
        if self._options.playback_duration >= 0:
            limits.append(self.start_ns + round(self._options.playback_duration * SECOND))
        self.until_ns = max(limits)

    # -- time ----------------------------------------------------------------------------------------------------------

    def begin(self) -> None:
        """Log the start, and start."""
        if value("bag.player_logs_end"):
            self._log.info(f"Playback until timestamp: {self.until_ns}")
        self._begin_round()

    def _begin_round(self) -> None:
        delay = round(self._options.delay * SECOND)
        if delay:
            self._log.info(f"Sleep {delay} ns")
            self._delay_until = self._steady_ns() + delay
        else:
            self._enter(self.start_ns)

    def _enter(self, bag_ns: int) -> None:
        self._delay_until = None
        self.clock.jump(bag_ns)
        self._read_from(bag_ns)

    def _read_from(self, bag_ns: int) -> None:
        streams = []
        for reader in self._readers:
            reader.seek(bag_ns)
            streams.append(_messages(reader))
        sent = self._options.message_order == "sent"
        self._stream = heapq.merge(
            *streams, key=(lambda each: each.sent_ns) if sent else (lambda each: each.received_ns)
        )
        self._next = next(self._stream, None)

    def advance(self) -> int | None:
        """Publish the messages that are due.

        Returns the steady time at which more will be due, None while only a key or a service can continue the playback.
        """
        now = self._steady_ns()
        if self._clock_due is not None and now >= self._clock_due:
            self._clock_due = max(self._clock_due + self._clock_period, now)
            self._publish_clock()
        due = self._advance_messages(now)
        if self._clock_due is not None and not self.finished:
            due = self._clock_due if due is None else min(due, self._clock_due)
        return due

    def _advance_messages(self, now: int) -> int | None:
        if self._delay_until is not None:
            if now < self._delay_until:
                return self._delay_until
            self._enter(self.start_ns)
        if self.finished or self.clock.paused:
            return None
        for _ in range(AT_ONCE):
            message = self._next
            if message is None or self._is_past_end(message):
                return self._end_round()
            due = self.clock.steady_at(self._time_of(message))
            if due > now:
                return due
            self._publish(message)
            self._next = next(self._stream, None) if self._stream is not None else None
        return now

    def _time_of(self, message: Message) -> int:
        return message.sent_ns if self._options.message_order == "sent" else message.received_ns

    def _is_past_end(self, message: Message) -> bool:
        return 0 <= self.until_ns < self._time_of(message)

    def _end_round(self) -> int | None:
        if not self._options.loop:
            self._finish()
            return None
        self._begin_round()
        if self._next is None and self._delay_until is None:
            self._finish()  # an empty bag in a loop: there is nothing to wait for
            return None
        return self._steady_ns()

    def _finish(self) -> None:
        self.finished = True
        self.wait_for_all_acked()

    def wait_for_all_acked(self) -> None:
        """Wait for all acknowledgements; our publishers deliver when they publish, so there are none to wait for."""
        if self._options.wait_acked_timeout < 0:
            return
        for publisher in self._publishers.values():
            publisher.wait_for_all_acked()

    # -- messages ------------------------------------------------------------------------------------------------------

    def _publish(self, message: Message) -> bool:
        if self._requests is not None and self._requests.takes(message.topic):
            return self._requests.send(message)
        publisher = self._publishers.get(message.topic)
        if publisher is None:
            return False
        options = self._options
        if options.clock_publish_on_topic_publish and (
            not options.clock_topics or message.topic in map(self._full, options.clock_topics)
        ):
            self._publish_clock(message.received_ns)
        try:
            publisher.publish(message.data)
        except Exception as error:
            # One damaged message must not end the playback.
            self._log.error(f"Failed to publish message on '{message.topic}' topic. \nError: {error}")
            return False
        return True

    def _publish_clock(self, bag_ns: int | None = None) -> None:
        if self._clock_publisher is None:
            return
        seconds, nanoseconds = divmod(self.clock.now() if bag_ns is None else bag_ns, SECOND)
        clock = Clock()
        clock.clock.sec, clock.clock.nanosec = seconds, nanoseconds
        self._clock_publisher.publish(clock)

    # -- control -------------------------------------------------------------------------------------------------------

    def pause(self) -> None:
        """Stop the recording's time."""
        self.clock.pause()
        self._log.info("Pausing play.")
        self._wake()

    def resume(self) -> None:
        """Let the recording's time run again."""
        self.clock.resume()
        self._log.info("Resuming play.")
        self._wake()

    def toggle_paused(self) -> None:
        """Pause, or resume."""
        (self.resume if self.clock.paused else self.pause)()

    def set_rate(self, rate: float) -> bool:
        """Change the rate; returns False unless it is above 0."""
        accepted = math.isfinite(rate) and self.clock.set_rate(rate)
        if accepted:
            self._log.info(f"Set rate to {rate:g}")
        else:
            self._log.warning(f"Failed to set rate to invalid value {rate:g}")
        self._wake()
        return accepted

    def play_next(self) -> bool:
        """While paused: publish one message and stop at its time. Returns False if not paused, or at the end."""
        if not self.clock.paused:
            self._log.warning("Called play next, but not in paused state.")
            return False
        if value("bag.player_logs_next"):
            self._log.info("Playing next message.")
        return self._step()

    def _step(self) -> bool:
        if self._delay_until is not None:
            self._enter(self.start_ns)
        while self._next is not None and not self._is_past_end(self._next):
            message = self._next
            published = self._publish(message)
            self.clock.jump(self._time_of(message))
            self._next = next(self._stream, None) if self._stream is not None else None
            if published:
                return True
        return False

    def burst(self, count: int) -> int:
        """While paused: publish `count` messages at once (0: all remaining ones). Returns the number of messages."""
        if not self.clock.paused:
            self._log.warning("Burst can only be used when in the paused state.")
            return 0
        self._bursting = True
        played = 0
        while (played < count or count == 0) and self._step():
            played += 1
        self._bursting = False
        self._log.info(f"Burst {played} messages.")
        self._wake()
        return played

    def seek(self, bag_ns: int) -> None:
        """Continue at this time of the recording, or at its beginning for an earlier one."""
        self._enter(max(bag_ns, self.start_ns))
        self._wake()

    def stop(self) -> None:
        """End the playback."""
        if not self.finished:
            if value("bag.player_logs_stop"):
                self._log.info("Stopping playback.")
            self.finished = True
            self._wake()

    def press(self, key: str) -> None:
        """Handle a key (as a terminal sends it)."""
        if key == " ":
            self.toggle_paused()
        elif key == "\x1b[C":
            self.play_next()
        elif key in ("\x1b[A", "\x1b[B"):
            # Rounded, because C++ prints six digits: the real one shows 1.1, 1.2 … too.
            self.set_rate(round(self.clock.rate + (RATE_STEP if key == "\x1b[A" else -RATE_STEP), 6))

    # -- progress ------------------------------------------------------------------------------------------------------

    def progress(self) -> str:
        """Return the two lines that show the position of the playback."""
        now = min(max(self.clock.now(), self.bag_start), max(self.bag_end, self.bag_start))
        state = "S" if self.finished else "D" if self._delay_until else "P" if self.clock.paused else "R"
        if self._bursting:
            state = "B"
        passed, total = (now - self.bag_start) / SECOND, (self.bag_end - self.bag_start) / SECOND
        moment = f"{now // SECOND}.{now % SECOND:09d}"
        return f"====== Playback Progress ======\n[{moment}] Duration {passed:.2f}/{total:.2f} [{state}]"


KEYS = (
    ("SPACE", "Pause/Resume"),
    ("CURSOR_RIGHT", "Play Next Message"),
    ("CURSOR_UP", "Increase Rate 10%"),
    ("CURSOR_DOWN", "Decrease Rate 10%"),
)


def _messages(reader: SequentialReader) -> Iterator[Message]:
    while reader.has_next():
        yield reader.read_next_message()
