"""The model of the car window: the robot, the poses of its links, the state of its joints, and what is wrong.

The program's thread handles messages and swaps the snapshot; a window on another thread reads it, and need not draw
again while `version` stays the same. The poses of the links come from /tf alone, as in RViz; joint angles are shown
beside them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from day6_core.ros.programs.day6_bot._frames import RobotFrames
from day6_core.ros.programs.day6_bot._joints import JointReading, JointReadings, Moment
from day6_core.ros.programs.day6_bot._status import SILENT_S, CarStatus, JointStateFacts, status_lines
from day6_urdf.kinematics import Transform
from day6_urdf.model import MOVING_TYPES, Robot
from day6_urdf.topview.paint import Turning
from day6_urdf.topview.plan import TopPlan, steering_of
from rclpy.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from day6_core.graph import Endpoint
    from rclpy.node import Node

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
LISTENING = QoSProfile(depth=100)
"""As tf2's listener: a burst of transforms must not be lost while a frame is drawn."""


@dataclass(frozen=True, slots=True)
class CarSnapshot:
    """One moment. `transforms` are by link, in the root link's frame; links without a transform are not in it."""

    version: int = 0
    plan: TopPlan | None = None
    transforms: Mapping[str, Transform] = field(default_factory=dict)
    joints: tuple[JointReading, ...] = ()
    rate: float | None = None
    """Messages a second on /joint_states; None when there are none."""
    status: tuple[CarStatus, ...] = ()

    @property
    def robot(self) -> Robot | None:
        """The robot of the newest description that could be read."""
        return self.plan.robot if self.plan is not None else None

    def labels(self, degree: str = " deg") -> dict[str, tuple[str, ...]]:
        """Return by link what stands beside it: its name, then position and speed of its joint (0 to 360 degrees, or metres).

        A wheel that can be steered shows how far it is turned aside as well, left being positive.
        """
        if self.plan is None:
            return {}
        texts: dict[str, tuple[str, ...]] = {}
        readings = {reading.name: reading for reading in self.joints}
        for joint in self.plan.robot.joints:
            reading = readings.get(joint.name)
            if reading is not None and joint.type == "prismatic":
                texts[joint.child] = joint.child, f"{reading.position:.2f} m", f"{reading.speed:+.2f} m/s"
            elif reading is not None and joint.type in ("continuous", "revolute"):
                angle = math.degrees(reading.position) % 360
                texts[joint.child] = joint.child, f"{angle:.0f}{degree}", f"{reading.speed:+.2f} rad/s"
        for wheel in self.plan.wheels:
            steering = steering_of(self.plan.robot, wheel)
            reading = readings.get(steering.name) if steering is not None else None
            if reading is not None:
                aside = math.degrees(math.remainder(reading.position, 2 * math.pi))
                link = wheel.joint.child
                texts[link] = *texts.get(link, (link,)), f"<{aside:+.0f}{degree}>"
        return texts

    def turning(self, frame_seconds: float) -> Turning:
        """How fast the wheels turn as measured, for pictures that are drawn every `frame_seconds` at most."""
        speeds = {reading.name: reading.speed for reading in self.joints}
        wheels = self.plan.wheels if self.plan is not None else ()
        gap = max(frame_seconds, 1 / self.rate if self.rate else 0.0)
        return Turning({w.joint.child: speeds.get(w.joint.name, 0.0) for w in wheels}, gap)


class CarModel:
    """The model of one car window. Everything but `snapshot` is for the program's thread.

    `timer_ns` is the time that timers run by; what falls silent is judged by it, so that it does not in a pause.
    """

    def __init__(self, node: Node, timer_ns: Callable[[], int]) -> None:
        self._node = node
        self._timer_ns = timer_ns
        self._frames = RobotFrames()
        self._readings = JointReadings()
        self._snapshot = CarSnapshot()
        self._prefix: str = node.declare_parameter("tf_prefix", "").value
        self._joint_states = node.resolve_topic_name("joint_states")
        self._description_topic = node.resolve_topic_name("robot_description")
        self._known = frozenset[str]()
        self._turning = frozenset[str]()
        self._problem = ""
        self._last_heard: Moment | None = None
        self._publishers: tuple[tuple[str, str], ...] = ()
        self.waiting_description: str | None = None
        """A received description that is not read yet; `on_description` is called when there is one."""
        self.on_description: Callable[[], object] | None = None
        self._description: str | None = None
        node.create_subscription(String, "robot_description", self._hear_description, LATCHED)
        node.create_subscription(JointState, "joint_states", self._hear_joints, LISTENING)
        node.create_subscription(TFMessage, "/tf", self._hear_transforms, LISTENING)
        node.create_subscription(
            TFMessage, "/tf_static", self._hear_transforms, QoSProfile(depth=100, durability=LATCHED.durability)
        )
        self.refresh()

    def is_description(self, endpoint: Endpoint) -> bool:
        """Whether an endpoint of the graph is of the topic that the robot comes by."""
        return endpoint.topic == self._description_topic

    def snapshot(self) -> CarSnapshot:
        """Return the newest moment (any thread)."""
        return self._snapshot

    @property
    def version(self) -> int:
        """Grows whenever something that can be seen changed (any thread)."""
        return self._snapshot.version

    def show(self, plan: TopPlan | None, problem: str = "") -> None:
        """The waiting description has been read: this is its robot, or this is why there is none."""
        self.waiting_description = None
        self._problem = problem
        if plan is not None:
            robot = plan.robot
            self._known = frozenset(joint.name for joint in robot.joints if joint.type in MOVING_TYPES)
            self._turning = frozenset(j.name for j in robot.joints if j.type in ("continuous", "revolute"))
        self._swap(plan=plan)
        self._place_links()
        self.refresh()

    def refresh(self) -> None:
        """Look at who publishes, how often, and what is missing; called a few times a second."""
        now = self._now()
        self._readings.forget_silent(now.timer_ns)
        infos = self._node.get_publishers_info_by_topic(self._joint_states)
        self._publishers = tuple(sorted((_full_name(info), info.topic_type) for info in infos))
        self._swap(joints=self._readings.readings(self._known), rate=self._readings.rate(now.real_ns))
        self._judge(now)

    def _hear_description(self, message: String) -> None:
        if message.data != self._description:
            self._description = self.waiting_description = message.data
            self._judge(self._now())
            if self.on_description is not None:
                self.on_description()

    def _hear_joints(self, message: JointState) -> None:
        self._last_heard = now = self._now()
        self._readings.hear(list(message.name), list(message.position), now, self._turning)
        self._swap(joints=self._readings.readings(self._known))

    def _hear_transforms(self, message: TFMessage) -> None:
        if self._frames.update(message.transforms):
            self._place_links()

    def _place_links(self) -> None:
        robot = self._snapshot.robot
        transforms: dict[str, Transform] = {}
        if robot is not None:
            root = self._prefix + robot.root
            for link in robot.links:
                transform = self._frames.lookup(root, self._prefix + link.name)
                if transform is not None:
                    transforms[link.name] = transform
        some_appeared = transforms.keys() != self._snapshot.transforms.keys()
        self._swap(transforms=transforms)
        if some_appeared:
            self._judge(self._now())

    def _judge(self, now: Moment) -> None:
        plan, robot = self._snapshot.plan, self._snapshot.robot
        links = robot.links if robot is not None else ()
        missing = [link.name for link in links if link.name not in self._snapshot.transforms]
        facts = JointStateFacts(
            described=robot is not None,
            loading=self.waiting_description is not None,
            problem=self._problem,
            joints=self._known,
            wheels=len(plan.wheels) if plan is not None else 0,
            missing=tuple(missing),
            root=robot.root if robot is not None else "",
            publishers=self._publishers,
            topic=self._joint_states,
            heard_joints=self._readings.heard_lately(now.timer_ns),
            rate=self._snapshot.rate,
            silent_s=self._silence(now),
            rolling=self._is_rolling(),
        )
        self._swap(status=status_lines(facts))

    def _silence(self, now: Moment) -> float | None:
        """Seconds since the last joint states; None if there were none, or the world stood still since."""
        last = self._last_heard
        if last is None or now.timer_ns - last.timer_ns < SILENT_S * 1e9:
            return None
        return (now.real_ns - last.real_ns) / 1e9

    def _is_rolling(self) -> bool:
        """Whether wheels turn, as far as is known."""
        plan = self._snapshot.plan
        wheels = {wheel.joint.name for wheel in plan.wheels} if plan is not None else set()
        return any(reading.name in wheels and abs(reading.speed) > 0.05 for reading in self._snapshot.joints)

    def _swap(self, **changes: Any) -> None:
        old = self._snapshot
        if any(getattr(old, name) != value for name, value in changes.items()):
            self._snapshot = replace(old, version=old.version + 1, **changes)

    def _now(self) -> Moment:
        return Moment(int(self._node.get_clock().now().nanoseconds), self._timer_ns())


def _full_name(info: Any) -> str:
    namespace = info.node_namespace.strip("/")
    return f"{namespace}/{info.node_name}" if namespace else str(info.node_name)
