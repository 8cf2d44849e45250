"""Displays that show messages of a topic: subscribing, counting, and waiting for transforms."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rclcpp import CppException
from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.properties import INT, TOPIC, Property
from day6_core.ros.programs.rviz2.model.qos import QosProperties
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN
from day6_urdf.kinematics import Transform
from rclpy.event_handler import SubscriptionEventCallbacks

if TYPE_CHECKING:
    from rclpy.qos import QoSProfile
    from rclpy.subscription import Subscription

INVALID_FLOATS = "Message contained invalid floating point values (nans or infs)"

FULL = "discarding message because the queue is full"
NO_FRAME = "the frame id of the message is empty"
"""Why a message is dropped (tf2_ros/message_filter.h)."""


class TopicDisplay(Display):
    """Subscribes while enabled (rviz_common/ros_topic_display.hpp)."""

    topic_name = "Topic"
    topic_line = "Topic"
    """The line of its status that counts the messages."""
    default_topic = ""
    usual_topic = ""
    """The one that is offered first, where somebody publishes it."""
    depth = 5
    transient_local = False
    asks_who_sent = False
    """Whether `sender` is set before a message is processed."""

    def build(self) -> None:
        self.topic = Property(
            self.topic_name,
            TOPIC,
            self.default_topic,
            f"{self.message_type} topic to subscribe to.",
            options=self._topics,
            on_change=self.changed,
        )
        durability = "Transient Local" if self.transient_local else "Volatile"
        self.qos = QosProperties(self.topic, self.changed, depth=self.depth, durability=durability)
        self.add(self.topic)
        self.subscription: Subscription[Any] | None = None
        self.received = 0
        self.sender: bytes | None = None
        """The gid of the publisher of the message that is processed now."""
        self._since_ns = 0
        self._subscribed: tuple[Any, ...] = ()

    def _topics(self) -> list[str]:
        found = [name for name, types in self.rviz.topics() if self.message_type in types]
        return sorted(found, key=lambda name: name != self.usual_topic)

    def choose_topic(self, topic: str) -> None:
        self.topic.set(topic)

    def process(self, message: Any) -> None:
        """Take in a message."""
        raise NotImplementedError

    # -- subscribing ---------------------------------------------------------------------------------------------------

    def _wanted(self) -> tuple[Any, ...]:
        return (self.topic.value, *self.qos.values)

    def on_enable(self) -> None:
        self._subscribe()

    def on_disable(self) -> None:
        self._unsubscribe()
        self.reset()

    def reset(self) -> None:
        super().reset()
        self.received = 0

    def refresh(self) -> None:
        if self._subscribed != self._wanted():
            self._unsubscribe()
            self.reset()
            self._subscribe()

    def _subscribe(self) -> None:
        self._subscribed = self._wanted()
        if not self.topic.value:
            self.put_status(ERROR, "Topic", "Error subscribing: Empty topic name")
            return
        if self._try_to_subscribe(self.topic.value, self.message_type, self._incoming, "Topic") is not None:
            self._since_ns = self.rviz.now_ns()
            self.put_status(OK, "Topic", "OK")

    def _try_to_subscribe(
        self, topic: str, type_name: str, callback: Any, line: str, qos: QoSProfile | None = None
    ) -> Subscription[Any] | None:
        from day6_core.interfaces import get_message

        def lost(info: Any) -> None:
            text = f"Some messages were lost:\n>\tNumber of new lost messages: {info.total_count_change} "
            self.put_status(WARN, line, f"{text}\n>\tTotal number of messages lost: {info.total_count}")

        def with_sender(message: Any, info: Any) -> None:
            self.sender = bytes(info["publisher_gid"]["data"])
            callback(message)

        try:
            subscription = self.rviz.node.create_subscription(
                get_message(type_name),
                topic,
                with_sender if self.asks_who_sent else callback,
                qos or self.qos.profile(),
                event_callbacks=SubscriptionEventCallbacks(message_lost=lost),
            )
        except CppException as error:
            self.put_status(ERROR, line, f"Error subscribing: {error}".rstrip())
            return None
        if line == self.topic_line:
            self.subscription = subscription
        return subscription

    def _unsubscribe(self) -> None:
        if self.subscription is not None:
            self.rviz.node.destroy_subscription(self.subscription)
            self.subscription = None

    def _incoming(self, message: Any) -> None:
        self.count()
        self.process(message)
        self.rviz.touch()

    def count(self) -> None:
        """A message counts: say how many came, and how often on the average."""
        self.received += 1
        passed = (self.rviz.now_ns() - self._since_ns) / 1e9
        often = f"{self.received / passed:.1f}" if passed > 0 else "inf"
        self.put_status(OK, self.topic_line, f"{self.received} messages received at {often} hz.")


class FilteredDisplay(TopicDisplay):
    """Holds messages back until their transform is there (rviz_common/message_filter_display.hpp)."""

    default_filter_size = 10

    def build(self) -> None:
        super().build()
        self.filter_size = Property("Filter size", INT, self.default_filter_size, low=1)
        self.topic.add(self.filter_size)
        self._waiting: deque[tuple[Any, bytes | None]] = deque()
        """Messages and who sent them."""
        self.nameless = 0
        """How many messages came whose header names no frame."""

    @property
    def waiting(self) -> int:
        """How many messages wait."""
        return len(self._waiting)

    @property
    def waiting_for(self) -> str:
        """The frame that the newest one waits for, '' if none waits; any thread."""
        newest = list(self._waiting)[-1:]
        return str(newest[0][0].header.frame_id) if newest else ""

    def show(self, message: Any) -> None:
        """A message whose transform is known (or was, when it came)."""
        raise NotImplementedError

    def reset(self) -> None:
        super().reset()
        self._waiting.clear()
        self.nameless = 0

    def _incoming(self, message: Any) -> None:
        if not message.header.frame_id.removeprefix("/"):
            self.nameless += 1
            self._drop(message, NO_FRAME)
        else:
            self._waiting.append((message, self.sender))
        while len(self._waiting) > self.filter_size.value:
            self._drop(self._waiting.popleft()[0], FULL)
        self.rviz.touch()

    def _drop(self, message: Any, reason: str) -> None:
        stamp = message.header.stamp
        # The text of tf2_ros' message filter.
        self.rviz.log_info(
            f"Message Filter dropping message: frame '{message.header.frame_id}' at time"
            f" {stamp.sec + stamp.nanosec * 1e-9:.3f} for reason '{reason}'"
        )

    def refresh(self) -> None:
        super().refresh()
        frames = self.rviz.frames
        for _ in range(len(self._waiting)):
            message, sender = self._waiting.popleft()
            if frames.pose(message.header.frame_id, stamp_ns(message.header.stamp)) is None:
                self._waiting.append((message, sender))
            else:
                self.sender = sender
                self.count()
                self.show(message)

    def place(self, header: Any) -> Transform | None:
        """The pose of a message's frame at its time; sets the status `Transform`."""
        pose = self.rviz.frames.pose(header.frame_id, stamp_ns(header.stamp))
        if pose is None:
            self.transform_missing(header.frame_id)
        else:
            self.transform_ok()
        return pose


def stamp_ns(stamp: Any) -> int:
    """A message's time in nanoseconds."""
    return int(stamp.sec) * 1_000_000_000 + int(stamp.nanosec)


def all_finite(numbers: Iterable[float]) -> bool:
    return all(map(math.isfinite, numbers))


def pose_of(message: Any) -> Transform:
    """A geometry_msgs Pose as a transform; a quaternion of zeros is taken for none, others are normalised."""
    position, turn = message.position, message.orientation
    norm = math.sqrt(turn.x**2 + turn.y**2 + turn.z**2 + turn.w**2)
    rotation = (0.0, 0.0, 0.0, 1.0) if norm == 0 else (turn.x / norm, turn.y / norm, turn.z / norm, turn.w / norm)
    return Transform((position.x, position.y, position.z), rotation)


def pose_numbers(message: Any) -> tuple[float, ...]:
    position, turn = message.position, message.orientation
    return position.x, position.y, position.z, turn.x, turn.y, turn.z, turn.w
