"""What the inspector hears all of: joint states and the robot description, through its node that only looks on."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from sensor_msgs.msg import JointState
from std_msgs.msg import String

from day6_core.ros.programs.day6_inspector.facts import RobotFacts
from day6_core.ros.robot_check import check_robot
from day6_urdf.advice import first_mistake, low_body, uneven_wheels
from day6_urdf.model import MOVING_TYPES
from rclpy.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from day6_urdf.model import Robot
    from rclpy.node import Node
    from rclpy.subscription import Subscription

JOINT_STATES, DESCRIPTION = "/joint_states", "/robot_description"
MEMORY = 20
"""Arrivals kept to measure a rate."""

STILL_S = 3.0
"""A topic that has been silent for so long has no rate."""


class Listening:
    """Subscribes to what is published, and keeps what was heard last."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._arrivals: deque[int] = deque(maxlen=MEMORY)
        self.joint_names: tuple[str, ...] = ()
        self.unequal: tuple[int, int] | None = None
        """Numbers of names and positions of the newest joint states, where they differ."""
        self.timeless = False
        """Whether the newest joint states have no stamp."""
        self.joints: frozenset[str] | None = None
        """The joints of the description that can move, None while there is none."""
        self.robot: RobotFacts | None = None
        self._subscriptions: dict[str, Subscription[Any]] = {}
        self.listen()

    def listen(self) -> None:
        """Subscribe to the topics that have publishers; what was heard of one that has none any more is forgotten."""
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        for topic, kind, callback, qos in (
            (JOINT_STATES, JointState, self._on_joints, QoSProfile(depth=100)),
            (DESCRIPTION, String, self._on_description, latched),
        ):
            published = self._node.count_publishers(topic) > 0
            if published and topic not in self._subscriptions:
                self._subscriptions[topic] = self._node.create_subscription(kind, topic, callback, qos)
            elif not published and topic in self._subscriptions:
                self._node.destroy_subscription(self._subscriptions.pop(topic))
                if topic == DESCRIPTION:
                    self.joints = self.robot = None

    def rate(self) -> float | None:
        """Messages a second on /joint_states, None when there were too few or none lately."""
        now = self._node.get_clock().now().nanoseconds
        if len(self._arrivals) < 3 or now - self._arrivals[-1] > STILL_S * 1e9:
            return None
        gaps = sorted(after - before for before, after in pairwise(self._arrivals))
        middle = gaps[len(gaps) // 2]
        return 1e9 / middle if middle > 0 else None

    def _on_joints(self, message: JointState) -> None:
        self._arrivals.append(self._node.get_clock().now().nanoseconds)
        if tuple(message.name) != self.joint_names:
            self.joint_names = tuple(message.name)
        self.timeless = message.header.stamp.sec == message.header.stamp.nanosec == 0
        names, positions = len(message.name), len(message.position)
        self.unequal = (names, positions) if positions != names else None

    def _on_description(self, message: String) -> None:
        checked = check_robot(message.data)
        robot = checked.robot
        if robot is None:
            self.joints, self.robot = (
                None,
                RobotFacts(problem=str(checked.diagnostics[0].text) if checked.diagnostics else ""),
            )
            return
        moving = [joint for joint in robot.joints if joint.type in MOVING_TYPES and joint.mimic is None]
        self.joints = frozenset(joint.name for joint in moving)
        self.robot = RobotFacts(
            frozenset(link.name for link in robot.links),
            tuple(_mistakes(robot)),
            moved=tuple((joint.name, joint.child) for joint in moving),
            limits=tuple(
                (joint.name, (joint.limit.lower, joint.limit.upper))
                for joint in moving
                if joint.limit is not None and joint.type != "continuous" and joint.limit.lower < joint.limit.upper
            ),
        )


def _mistakes(robot: Robot) -> Iterator[tuple[str, tuple[tuple[str, str], ...]]]:
    if (mistake := first_mistake(robot)) is not None:
        key, joint = mistake
        yield f"wheel_{key}", (("link", joint.child), ("joint", joint.name))
    if (uneven := uneven_wheels(robot)) is not None:
        links, difference = uneven
        yield "wheel_height", (("links", ", ".join(links)), ("difference", f"{difference:.3f}"))
    elif (low := low_body(robot)) is not None:
        link, links, difference = low
        yield "body_low", (("link", link), ("links", ", ".join(links)), ("difference", f"{difference:.3f}"))
