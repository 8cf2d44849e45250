"""Effort (rviz_default_plugins/displays/effort): the efforts of joint states as arcs with arrows around revolute joints."""

from __future__ import annotations

import math
from collections import deque
from itertools import pairwise
from typing import Any, NamedTuple

from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import rainbow
from day6_core.ros.programs.rviz2.model.properties import BOOL, FLOAT, GROUP, INT, TEXT, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Colour, Lines, Scene, placed
from day6_core.ros.programs.rviz2.model.status import ERROR, OK
from day6_core.ros.programs.rviz2.model.topics import FilteredDisplay, stamp_ns
from day6_urdf.kinematics import Transform, about, multiply
from day6_urdf.model import Joint, Robot, Vector
from rclpy.qos import DurabilityPolicy, QoSProfile

LEAST = 0.05
"""Added to the share of the effort, and the arc's radius without any."""
POINTS, OF_CIRCLE = 30, 32
"""An arc has 30 of the 32 corners of a circle."""
DESCRIPTION_TYPE = "std_msgs/msg/String"


class Effort(NamedTuple):
    """The effort of one joint: where its child is, newton metres, and the greatest effort (0: not known)."""

    pose: Transform
    effort: float
    most: float


class EffortDisplay(FilteredDisplay):
    """The joints' axes and limits come from the robot description."""

    type = "Effort"
    message_type = "sensor_msgs/msg/JointState"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.alpha = self.add(floats("Alpha", 1, on_change=changed))
        self.width = self.add(floats("Width", 0.02, on_change=changed))
        self.scale = self.add(floats("Scale", 1, on_change=changed))
        self.history = self.add(Property("History Length", INT, 1, low=1, high=100000, on_change=changed))
        self.robot_topic = self.add(Property("Robot Description", TEXT, "/robot_description", on_change=changed))
        self.prefix = self.add(Property("TF Prefix", TEXT, "", on_change=self._prefix_changed))
        self.joints = self.add(Property("Joints", GROUP))
        self._wanted_joints: dict[str, Any] = {}
        self._robot: Robot | None = None
        self._heard = ""
        """The topic that the description is heard on."""
        self._described: Any = None
        self._shown: deque[dict[str, Effort]] = deque()

    def _prefix_changed(self) -> None:
        self.clear_statuses()
        self.changed()

    # -- the description -----------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        if self._heard != self.robot_topic.value:
            self._listen()
        super().refresh()

    def on_disable(self) -> None:
        super().on_disable()
        self._stop_listening()

    def _listen(self) -> None:
        self._stop_listening()
        self._heard = self.robot_topic.value
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._described = self._try_to_subscribe(
            self._heard, DESCRIPTION_TYPE, self._take_robot, "Array Topic", latched
        )
        if self._described is not None:
            # The original's line for this topic is called so.
            self.put_status(OK, "Array Topic", "OK")

    def _stop_listening(self) -> None:
        if self._described is not None:
            self.rviz.node.destroy_subscription(self._described)
        self._described, self._heard = None, ""

    def _take_robot(self, message: Any) -> None:
        from day6_core.ros.robot_check import check_robot

        self._robot = check_robot(message.data).robot
        self._shown.clear()
        self.joints.children = []
        if self._robot is None:
            self.put_status(ERROR, "URDF", "Unable to parse robot model description!")
        else:
            self.put_status(OK, "URDF", "Robot model parsed Ok")
            for joint in sorted(self._robot.joints, key=lambda each: each.name):
                if joint.type in ("revolute", "continuous"):
                    self._add_joint(joint)
        self.rviz.tree_changed()
        self.rviz.touch()

    def _add_joint(self, joint: Joint) -> None:
        if joint.limit is None:
            self.rviz.node.get_logger().warning(
                f"Joint '{joint.name}' has no <limit> tag in URDF. Effort plugin needs to know the effort limit to "
                "determine the size of the corresponding visual marker. Effort display for this joint will be inhibited."
            )
            return
        switch = self.joints.add(Property(joint.name, BOOL, True, on_change=self.changed))
        switch.add(Property("Effort", FLOAT, 0.0, read_only=True))
        switch.add(Property("Max Effort", FLOAT, joint.limit.effort, read_only=True))
        switch.load(self._wanted_joints.get(joint.name))

    # -- efforts -------------------------------------------------------------------------------------------------------

    def reset(self) -> None:
        super().reset()
        self._shown.clear()

    def show(self, message: Any) -> None:
        robot = self._robot
        if robot is None:
            self.put_status(ERROR, "Process message", "Robot model might not be loaded yet")
            return
        if len(message.name) != len(message.effort):
            text = "Received a joint state msg with different joint names and efforts size!"
            self.put_status(ERROR, "Topic", text)
            return
        switches = {each.name: each for each in self.joints.children}
        joints = {joint.name: joint for joint in robot.joints}
        efforts = {}
        for name, effort in zip(message.name, message.effort, strict=True):
            if (switch := switches.get(name)) is None:
                continue
            switch.child("Effort").value = float(effort)
            if joints[name].type == "revolute":
                shown = self._effort_of(joints[name], effort, message.header.stamp)
                if shown is not None and switch.value:
                    efforts[name] = shown._replace(most=switch.child("Max Effort").value)
        self._shown.append(efforts)

    def _effort_of(self, joint: Joint, effort: float, stamp: Any) -> Effort | None:
        frame = f"{self.prefix.value}/{joint.child}" if self.prefix.value else joint.child
        pose = self.rviz.frames.pose(frame, stamp_ns(stamp))
        if pose is None:
            text = f"Error transforming from frame '{frame}' to frame '{self.rviz.fixed_frame}'"
            self.put_status(ERROR, joint.name, text)
            return None
        if not math.isfinite(effort):
            self.put_status(ERROR, joint.name, f"Invalid effort: {effort}")
            return None
        self.put_status(OK, joint.name, "")
        return Effort(Transform(pose.xyz, multiply(pose.rotation, _to_z(joint.axis))), effort, 0.0)

    def draw(self, scene: Scene) -> None:
        while len(self._shown) > self.history.value:
            self._shown.popleft()
        for efforts in self._shown:
            for each in efforts.values():
                self._draw_effort(scene, each)

    def _draw_effort(self, scene: Scene, shown: Effort) -> None:
        width = self.width.value
        share = (min(abs(shown.effort) / shown.most, 1.0) if shown.most else abs(shown.effort)) + LEAST
        radius = LEAST + share * self.scale.value * 0.5
        way = -1 if shown.effort < 0 else 1
        angles = [math.tau * corner / OF_CIRCLE for corner in range(POINTS)]
        corners = [(way * radius * math.sin(angle), radius * math.cos(angle), 0.0) for angle in angles]
        red, green, blue, alpha = map(float, rainbow(share, 1.0))
        colour: Colour = (red, green, blue, alpha)
        ends = [corner for pair in pairwise(corners) for corner in pair]
        scene.lines.append(Lines(ends, [colour], shown.pose, width))
        # The arrow has no shaft; it looks against the arc's beginning.
        back = (0.0, 0.0, 1.0, 0.0) if shown.effort > 0 else (0.0, 0.0, 0.0, 1.0)
        start = placed(shown.pose, (0.0, radius, 0.0))
        tip = Transform(start, multiply(shown.pose.rotation, back))
        scene.arrow(tip, 0.0, 2 * width, 2 * width, 4 * width, colour)

    def load_extras(self, config: dict[str, Any]) -> None:
        saved = config.get("Joints")
        self._wanted_joints = dict(saved) if isinstance(saved, dict) else {}


def _to_z(axis: Vector) -> tuple[float, float, float, float]:
    """The original's rotation for an axis: that which turns the axis onto z."""
    length = math.sqrt(sum(part * part for part in axis))
    if not length:
        return 0.0, 0.0, 0.0, 1.0
    return about((axis[1], -axis[0], 0.0), math.acos(max(-1.0, min(1.0, axis[2] / length))))
