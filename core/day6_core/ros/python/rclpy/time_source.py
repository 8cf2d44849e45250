"""Simulated time: the clock of a node with `use_sim_time` follows the topic /clock."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

from rclpy._day6.incidental import also
from rclpy.clock import ROSClock
from rclpy.clock_type import ClockType
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.time import Time

if TYPE_CHECKING:
    from rcl_interfaces.msg import SetParametersResult
    from rosgraph_msgs.msg import Clock as ClockMessage

    from rclpy.node import Node
    from rclpy.qos_overriding_options import QoSOverridingOptions
    from rclpy.subscription import Subscription

__getattr__ = also(__name__, "SetParametersResult")


CLOCK_TOPIC = "/clock"
USE_SIM_TIME_NAME = "use_sim_time"


class TimeSource:
    """Sets the clocks attached to it from /clock while the node's parameter `use_sim_time` is true."""

    _clock_qos_overriding: QoSOverridingOptions | None = None
    """Which policies of the subscription to /clock parameters may change: none in rclpy."""

    def __init__(self, *, node: Node | None = None) -> None:
        self._clock_sub: Subscription[ClockMessage] | None = None
        self._node_weak_ref: weakref.ReferenceType[Node] | None = None
        self._associated_clocks: list[ROSClock] = []
        self._last_time_set = Time(clock_type=ClockType.ROS_TIME)
        self._ros_time_is_active = False
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clocks show simulated time."""
        return self._ros_time_is_active

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled: bool) -> None:
        if self._ros_time_is_active == enabled:
            return
        self._ros_time_is_active = enabled
        for clock in self._associated_clocks:
            clock._set_ros_time_is_active(enabled)
        if enabled:
            self._subscribe_to_clock_topic()
        else:
            self._unsubscribe()

    def _get_node(self) -> Node | None:
        return None if self._node_weak_ref is None else self._node_weak_ref()

    def _subscribe_to_clock_topic(self) -> None:
        node = self._get_node()
        if self._clock_sub is None and node is not None:
            from rosgraph_msgs.msg import Clock

            qos = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
            self._clock_sub = node.create_subscription(
                Clock, CLOCK_TOPIC, self.clock_callback, qos, qos_overriding_options=self._clock_qos_overriding
            )

    def _unsubscribe(self) -> None:
        node = self._get_node()
        if self._clock_sub is not None and node is not None:
            node.destroy_subscription(self._clock_sub)
            self._clock_sub = None

    def attach_node(self, node: Node) -> None:
        """Attach a node: use its parameter and subscribe with it.

        Raises:
            TypeError: for anything that isn't a node.
        """
        from rclpy.node import Node

        if not isinstance(node, Node):
            raise TypeError("Node must be of type rclpy.node.Node")
        if self._node_weak_ref is not None:
            self.detach_node()
        self._node_weak_ref = weakref.ref(node)
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node._rclpy_parameters.declare_plain(USE_SIM_TIME_NAME, False)
        parameter = node.get_parameter(USE_SIM_TIME_NAME)
        if parameter.type_ == Parameter.Type.BOOL:
            self.ros_time_is_active = parameter.value
        elif parameter.type_ == Parameter.Type.NOT_SET:
            node.get_logger().debug(f"'{USE_SIM_TIME_NAME}' parameter not set, using wall time by default")
        else:
            node.get_logger().error(
                f"Invalid type for parameter '{USE_SIM_TIME_NAME}' {parameter.type_!r} should be bool"
            )
        node.add_on_set_parameters_callback(self._on_parameter_event)

    def detach_node(self) -> None:
        """Detach the node.

        Raises:
            RuntimeError: if it no longer exists and left a subscription behind.
        """
        if self._clock_sub is not None:
            if self._get_node() is None:
                raise RuntimeError("Unable to destroy previously created clock subscription")
            self._unsubscribe()
        self._node_weak_ref = None

    def attach_clock(self, clock: ROSClock) -> None:
        """Set that clock too.

        Raises:
            ValueError: for anything that isn't a ROS clock.
        """
        if not isinstance(clock, ROSClock):
            raise ValueError("Only clocks with type ROS_TIME can be attached.")
        clock.set_ros_time_override(self._last_time_set)
        clock._set_ros_time_is_active(self._ros_time_is_active)
        if clock not in self._associated_clocks:
            self._associated_clocks.append(clock)

    def clock_callback(self, msg: ClockMessage) -> None:
        """Set the clocks by a rosgraph_msgs/Clock message."""
        self._last_time_set = Time.from_msg(msg.clock)
        for clock in self._associated_clocks:
            clock.set_ros_time_override(self._last_time_set)

    def _on_parameter_event(self, parameter_list: list[Parameter[Any]]) -> SetParametersResult:
        from rcl_interfaces.msg import SetParametersResult

        for parameter in parameter_list:
            if parameter.name != USE_SIM_TIME_NAME:
                continue
            if parameter.type_ != Parameter.Type.BOOL:
                reason = f"{USE_SIM_TIME_NAME} parameter set to something besides a bool"
                node = self._get_node()
                if node is not None:
                    node.get_logger().error(reason)
                return SetParametersResult(successful=False, reason=reason)
            self.ros_time_is_active = parameter.value
        return SetParametersResult(successful=True, reason="")
