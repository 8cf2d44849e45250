"""The node of joint_state_publisher, which joint_state_publisher_gui uses too."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from day6_core.ros.programs.joint_state_publisher.joints import (
    JointOptions,
    Joints,
    MimicCycle,
    read_followers,
    read_joints,
)
from day6_core.ros.programs.joint_state_publisher.other_formats import DescriptionError
from rclpy.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from rclpy.node import Node

NAME = "joint_state_publisher"
OPTIONS = {"automatically_declare_parameters_from_overrides": True}
_PARAMETERS: tuple[tuple[str, Any, int], ...] = (
    ("publish_default_efforts", False, ParameterType.PARAMETER_BOOL),
    ("publish_default_positions", True, ParameterType.PARAMETER_BOOL),
    ("publish_default_velocities", False, ParameterType.PARAMETER_BOOL),
    ("rate", 10, ParameterType.PARAMETER_INTEGER),
    ("source_list", [], ParameterType.PARAMETER_STRING_ARRAY),
    ("use_mimic_tags", True, ParameterType.PARAMETER_BOOL),
    ("use_smallest_joint_limits", True, ParameterType.PARAMETER_BOOL),
    ("delta", 0.0, ParameterType.PARAMETER_DOUBLE),
)


class JointStatePublisher:
    """What the node `joint_state_publisher` does, and its joints. NAME and OPTIONS say how the node is made.

    `description` is a URDF's text from the command line, or None. Raises DescriptionError for a description or a
    parameter that cannot be used. Parameters `zeros.JOINT` and `dependent_joints.JOINT.{parent,factor,offset}` have no
    declaration: like the original, the node declares whatever the command line gives. `dependent_joints` works as its
    documentation says; version 2.4.0 itself reads it and forgets it as soon as it has a description.
    """

    def __init__(self, node: Node, description: str | None) -> None:
        self.node = node
        for name, default, kind in _PARAMETERS:
            if not node.has_parameter(name):
                node.declare_parameter(name, default, ParameterDescriptor(type=kind))
        self.joints = Joints()
        self.options = JointOptions(
            zeros={name: parameter.value for name, parameter in node.get_parameters_by_prefix("zeros").items()},
            dependent_joints=read_followers(
                {name: item.value for name, item in node.get_parameters_by_prefix("dependent_joints").items()}
            ),
            **{name: self._value(name) for name in JointOptions.__dataclass_fields__ if node.has_parameter(name)},
        )
        self.on_joints: Callable[[], None] | None = None
        """Called when a description was read: there are other joints now."""
        self.on_source: Callable[[], None] | None = None
        """Called when a message of `source_list` moved joints."""
        if description is not None:
            self._configure(description)
        else:
            node.get_logger().info("Waiting for robot_description to be published on the robot_description topic...")
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        node.create_subscription(String, "robot_description", self._hear_description, latched)
        self._delta = self._value("delta")
        for source in self._value("source_list") or ():
            node.create_subscription(JointState, source, self._hear_source, 10)
        self._publisher = node.create_publisher(JointState, "joint_states", 10)
        node.create_timer(1.0 / self._value("rate"), self._publish)

    def _value(self, name: str) -> Any:
        return self.node.get_parameter(name).value

    def _configure(self, description: str) -> None:
        self.node.get_logger().debug("Got description, configuring robot")
        self.joints = read_joints(description, self.options)
        if self.on_joints is not None:
            self.on_joints()

    def _hear_description(self, message: String) -> None:
        try:
            self._configure(message.data)
        except DescriptionError as error:
            self.node.get_logger().warning(str(error))

    def _hear_source(self, message: JointState) -> None:
        for index, name in enumerate(message.name):
            joint = self.joints.free.get(name)
            if joint is None:
                continue
            if message.position:
                joint.position = message.position[index]
            if message.velocity:
                joint.velocity = message.velocity[index]
            if message.effort:
                joint.effort = message.effort[index]
        if self.on_source is not None:
            self.on_source()

    def _publish(self) -> None:
        if self._delta > 0:
            self.joints.advance(self._delta)
        try:
            names, positions, velocities, efforts = self.joints.values()
        except MimicCycle as error:
            self.node.get_logger().error(str(error))
            raise SystemExit(1) from error
        if not names:
            return
        state = JointState(name=names, position=positions, velocity=velocities, effort=efforts)
        state.header.stamp = self.node.get_clock().now().to_msg()
        self._publisher.publish(state)
