"""Gathers the facts through a node of its own, as any node could.

The facts: nodes, the endpoints and QoS of all topics, joint states, the robot description, the link to other processes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from sensor_msgs.msg import JointState
from std_msgs.msg import String

from day6_tui.core.graph.names import full_name
from day6_tui.core.link.state import LinkState
from day6_tui.core.ros.programs.day6_inspector.rules import Endpoint, Facts, Finding, findings
from day6_tui.urdf.check import check_text
from day6_tui.urdf.model import MOVING_TYPES
from rclpy.qos import DurabilityPolicy, QoSCompatibility, QoSProfile, qos_check_compatible

if TYPE_CHECKING:
    from day6_tui.core.session.clock import WorldClock
    from rclpy.node import Node
    from rclpy.subscription import Subscription

JOINT_STATES, DESCRIPTION = "/joint_states", "/robot_description"
JOINT_STATE = "sensor_msgs/msg/JointState"
MEMORY = 20
"""Arrivals kept to measure a rate."""

LOOKS = 21
"""As many looks at the clock tell whether it keeps up: ten seconds of them, so that the start of a program is no finding."""

LEAST_NS = 3_000_000_000
"""Less of the world's time tells nothing."""

STILL_S = 3.0
"""A topic that has been silent for so long has no rate."""


class Inspector:
    """The model of the window: when the findings change, `findings` is replaced as a whole and `version` incremented."""

    def __init__(self, node: Node, clock: WorldClock, link: Callable[[], LinkState] = LinkState) -> None:
        self._node = node
        self._clock = clock
        self._link = link
        self._progress: deque[tuple[int, int]] = deque(maxlen=LOOKS)
        self._arrivals: deque[int] = deque(maxlen=MEMORY)
        self._joint_names: tuple[str, ...] = ()
        self._joints: frozenset[str] | None = None
        self.findings: tuple[Finding, ...] = ()
        self.version = 0
        self._subscriptions: dict[str, Subscription[Any]] = {}
        self.listen()

    def listen(self) -> None:
        """Subscribe to the topics that have publishers, and to no others.

        A subscription makes a topic: `ros2 topic list` would name /robot_description while robot_state_publisher does not run.
        """
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
                    self._joints = None

    def refresh(self) -> None:
        """Look at the graph again (on the program's thread)."""
        self.listen()
        found = tuple(findings(self.facts()))
        if found != self.findings:
            self.findings = found
            self.version += 1

    def facts(self) -> Facts:
        """Return what is known now, without hidden nodes and topics, and without this node."""
        node = self._node
        names = [
            full_name(space, name) for name, space in node.get_node_names_and_namespaces() if not name.startswith("_")
        ]
        publishers: dict[str, tuple[Endpoint, ...]] = {}
        subscriptions: dict[str, tuple[Endpoint, ...]] = {}
        deaf: list[tuple[str, str, str, str]] = []
        for topic, _ in node.get_topic_names_and_types():
            if any(part.startswith("_") for part in topic.split("/")):
                continue
            offers = _shown(node.get_publishers_info_by_topic(topic))
            requests = _shown(node.get_subscriptions_info_by_topic(topic))
            if offers:
                publishers[topic] = tuple(_endpoint(offer) for offer in offers)
            if requests:
                subscriptions[topic] = tuple(_endpoint(request) for request in requests)
            deaf += [
                (topic, _endpoint(offer).node, _endpoint(request).node, _policy(offer.qos_profile, request.qos_profile))
                for offer in offers
                for request in requests
                if qos_check_compatible(offer.qos_profile, request.qos_profile)[0] == QoSCompatibility.ERROR
            ]
        published = JOINT_STATES in publishers
        return Facts(
            publishers=publishers,
            subscriptions=subscriptions,
            nodes=tuple(names),
            deaf=tuple(deaf),
            rates={JOINT_STATES: rate} if (rate := self._rate()) is not None else {},
            heard_joints=self._joint_names if published else (),
            joints=self._joints,
            link=self._link(),
            speed=self._clock.speed,
            pace=self._clock.speed * self._kept(),
        )

    def _kept(self) -> float:
        """How much of the time that the world should have gone lately it did go, 0 to 1."""
        self._progress.append((self._clock.steady_ns(), self._clock.lost_ns))
        (began, lost_before), (now, lost) = self._progress[0], self._progress[-1]
        due = now - began + lost - lost_before
        return (now - began) / due if due >= LEAST_NS else 1.0

    def _rate(self) -> float | None:
        """Messages a second on /joint_states, None when there were too few or none lately."""
        now = self._node.get_clock().now().nanoseconds
        if len(self._arrivals) < 3 or now - self._arrivals[-1] > STILL_S * 1e9:
            return None
        gaps = sorted(after - before for before, after in pairwise(self._arrivals))
        middle = gaps[len(gaps) // 2]
        return 1e9 / middle if middle > 0 else None

    def _on_joints(self, message: JointState) -> None:
        self._arrivals.append(self._node.get_clock().now().nanoseconds)
        if tuple(message.name) != self._joint_names:
            self._joint_names = tuple(message.name)

    def _on_description(self, message: String) -> None:
        robot = check_text(message.data).robot
        if robot is None:
            self._joints = None
        else:
            moving = (joint for joint in robot.joints if joint.type in MOVING_TYPES and joint.mimic is None)
            self._joints = frozenset(joint.name for joint in moving)


def _shown(infos: list[Any]) -> list[Any]:
    """Leave out hidden nodes, except those of `ros2 topic pub` and `echo`, whose topic names are typed by hand."""
    return [info for info in infos if not info.node_name.startswith("_") or info.node_name.startswith("_ros2cli")]


def _endpoint(info: Any) -> Endpoint:
    return Endpoint(full_name(info.node_namespace, info.node_name), info.topic_type)


def _policy(offer: QoSProfile, request: QoSProfile) -> str:
    """Name the incompatible policy, as DDS compares them."""
    text = qos_check_compatible(offer, request)[1]
    return next((policy for word, policy in _POLICIES.items() if word in text.lower()), "QoS")


_POLICIES = {
    "reliab": "reliability",
    "volatile": "durability",
    "transient": "durability",
    "deadline": "deadline",
    "liveliness": "liveliness",
}
"""Words of rmw's reasons -> the policy they are about."""
