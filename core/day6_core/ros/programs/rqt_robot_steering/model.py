"""What Robot Steering shows: a topic, and the linear and the angular velocity that it publishes there (robot_steering.py).

Velocities are whole thousandths of m/s and rad/s, as the places of the real sliders. The window runs on another thread: it reads
and makes requests, the program's thread carries them out.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from geometry_msgs.msg import Twist, TwistStamped

from day6_core.ros.programs.rqt_py_common.requests import Requests
from rclpy.exceptions import InvalidTopicNameException

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher

FACTOR = 1000
"""Places of a slider in 1 m/s or 1 rad/s."""

STEP, PAGE = 10, 100
"""Of a slider: by a key, and by a key with Shift or a button (RobotSteering.ui)."""

FARTHEST = 10.0
"""The greatest limit of a slider, of either sign; those below zero and those above are set apart."""

LIMIT_STEP = 0.1

DEPTH = 10
"""Of the publisher's history."""

PERIOD = 0.1
"""Seconds after which a velocity is published again."""


class Axis(NamedTuple):
    """One of the two sliders."""

    minimum: int
    maximum: int
    value: int = 0

    def at(self, value: int) -> Axis:
        """The slider at a place, or at the end that is next to it."""
        return self._replace(value=max(self.minimum, min(self.maximum, value)))


LINEAR, ANGULAR = "linear", "angular"
MINIMUM, MAXIMUM = "minimum", "maximum"

_KEPT = {
    "vx_max": (LINEAR, MAXIMUM),
    "vx_min": (LINEAR, MINIMUM),
    "vw_max": (ANGULAR, MAXIMUM),
    "vw_min": (ANGULAR, MINIMUM),
}
"""The names of the limits in perspectives."""


class RobotSteering(Requests):
    """The model of one Robot Steering. The window reads what is public and calls what is below "the window's side"."""

    def __init__(
        self, node: Node, settings: Mapping[str, Any], tell: Callable[[str], object], *, stamped: bool
    ) -> None:
        super().__init__()
        self._node = node
        self._tell = tell
        """Prints a line in the terminal."""
        self._publisher: Publisher[Any] | None = None
        self._stopped = False
        """Whether zero was published: once, so that others can take over."""
        self.axes = {LINEAR: Axis(-1000, 1000), ANGULAR: Axis(-3000, 3000)}
        self.topic = ""
        """As it was typed; nothing is published without one."""
        self.stamped = stamped
        """Whether TwistStamped is published, instead of Twist."""
        self.problem = ""
        """Why there is no publisher, in rclpy's words: no name, or a type that this node's context does not have there."""
        self.heard = 0
        """Subscriptions that get what is published."""
        self.other_types: tuple[str, ...] = ()
        """Types that others give the topic, without that of this one."""
        self.version = 0
        self._restore(settings)

    @property
    def type(self) -> str:
        """What is published."""
        return "geometry_msgs/msg/" + ("TwistStamped" if self.stamped else "Twist")

    @property
    def is_due(self) -> bool:
        """Whether there is something to publish after PERIOD."""
        return self._publisher is not None and not (self._stopped and self._stands)

    @property
    def _stands(self) -> bool:
        return all(axis.value == 0 for axis in self.axes.values())

    # -- the window's side ---------------------------------------------------------------------------------------------

    def set_topic(self, topic: str) -> None:
        """Publish on another topic."""
        self.post(partial(self._set_topic, topic))

    def set_stamped(self, stamped: bool) -> None:
        """Publish the other type."""
        self.post(partial(self._set_stamped, stamped))

    def move(self, axis: str, places: int) -> None:
        """Move a slider on."""
        self.post(lambda: self._set(axis, self.axes[axis].value + places))

    def set(self, axis: str, value: int) -> None:
        """Move a slider to a place."""
        self.post(partial(self._set, axis, value))

    def set_limit(self, axis: str, end: str, limit: float) -> None:
        """Set an end of a slider: MINIMUM from -FARTHEST to 0, MAXIMUM from 0 to FARTHEST."""
        self.post(partial(self._set_limit, axis, end, limit))

    def stop(self) -> None:
        """Move both sliders to zero; if they are there already, publish that again."""
        self.post(self._stop)

    # -- the program's side --------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Look who else uses the topic."""
        heard, types = 0, set()
        if self._publisher is not None:
            name = self._publisher.topic_name
            heard = self._publisher.get_subscription_count()
            infos = [*self._node.get_publishers_info_by_topic(name), *self._node.get_subscriptions_info_by_topic(name)]
            types = {info.topic_type for info in infos} - {self.type}
        if (heard, tuple(sorted(types))) != (self.heard, self.other_types):
            self.heard, self.other_types = heard, tuple(sorted(types))
            self.version += 1

    def publish(self) -> None:
        """Publish the velocities; zero only once. Called every PERIOD, and after every change."""
        if not self.is_due or self._publisher is None:
            return
        self._stopped = self._stands
        twist = Twist()
        twist.linear.x, twist.angular.z = self.axes[LINEAR].value / FACTOR, self.axes[ANGULAR].value / FACTOR
        if self.stamped:
            message = TwistStamped(twist=twist)
            message.header.stamp = self._node.get_clock().now().to_msg()
            self._publisher.publish(message)
        else:
            self._publisher.publish(twist)

    def close(self) -> None:
        """Give back the publisher. As the real one it publishes nothing more: a robot that moves moves on."""
        if self._publisher is not None:
            self._node.destroy_publisher(self._publisher)
            self._publisher = None

    def kept(self) -> dict[str, Any]:
        """What a perspective keeps."""
        limits = {key: getattr(self.axes[axis], end) / FACTOR for key, (axis, end) in _KEPT.items()}
        return {"topic": self.topic, "stamped": self.stamped, **limits}

    def _restore(self, settings: Mapping[str, Any]) -> None:
        for key, (axis, end) in _KEPT.items():
            limit = settings.get(key)
            if isinstance(limit, (int, float)):
                self._set_limit(axis, end, float(limit))
        stamped, topic = settings.get("stamped"), settings.get("topic")
        if isinstance(stamped, (bool, str)):
            self.stamped = stamped in (True, "true", "True")  # Qt's files have words
        self._set_topic(topic if isinstance(topic, str) else "/cmd_vel")

    def _set_topic(self, topic: str) -> None:
        self.close()
        self.topic, self.problem = topic, ""
        if topic:
            try:
                kind = TwistStamped if self.stamped else Twist
                self._publisher = self._node.create_publisher(kind, topic, DEPTH)
            except (InvalidTopicNameException, RuntimeError) as error:  # rcl's errors are of that class
                self.problem = str(error)
                self._tell(f"Error creating publisher: {error}")
        self.version += 1
        self.refresh()

    def _set_stamped(self, stamped: bool) -> None:
        if stamped != self.stamped:
            self.stamped = stamped
            self._set_topic(self.topic)

    def _set(self, axis: str, value: int) -> None:
        self._take(axis, self.axes[axis].at(value))

    def _set_limit(self, axis: str, end: str, limit: float) -> None:
        low, high = (-FARTHEST, 0.0) if end == MINIMUM else (0.0, FARTHEST)
        if math.isfinite(limit):
            place = round(max(low, min(high, limit)) * FACTOR)
            slider = self.axes[axis]._replace(**{end: place})
            self._take(axis, slider.at(slider.value))

    def _take(self, axis: str, slider: Axis) -> None:
        before, self.axes[axis] = self.axes[axis], slider
        self.version += slider != before
        if slider.value != before.value:
            self.publish()

    def _stop(self) -> None:
        if self.axes[LINEAR].value == self.axes[ANGULAR].value == 0:
            self._stopped = False
            self.publish()
        self._set(LINEAR, 0)
        self._set(ANGULAR, 0)
