"""The node of rclcpp: the parameters, topics and services that every one has."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterEvent

from day6_core.ros.programs.rclcpp.exceptions import CppException, RclcppException, thrown_as_cpp
from day6_core.ros.programs.rclcpp.logger import CppLogger
from day6_core.ros.programs.rclcpp.parameters import TYPE_NAMES, CppParameterService, CppParameterStore
from day6_core.ros.programs.rclcpp.qos import ALL_FOUR, declared_qos, event_qos
from rclpy._day6.node_entities import profile_of
from rclpy._day6.parameter_events import parameter_event_publisher
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameter_events
from rclpy.qos_overriding_options import QoSOverridingOptions
from rclpy.time_source import USE_SIM_TIME_NAME, TimeSource
from rclpy.type_description_service import TypeDescriptionService

if TYPE_CHECKING:
    from rclpy.publisher import Publisher
    from rclpy.qos import QoSProfile
    from rclpy.service import Service
    from rclpy.subscription import Subscription

_EVENTS = "/parameter_events"


class _CppTimeSource(TimeSource):
    """rclcpp/time_source.cpp: parameters can change the QoS of its subscription to /clock."""

    _clock_qos_overriding = QoSOverridingOptions(ALL_FOUR)

    def attach_node(self, node: Node) -> None:
        """Attach a node. Raises CppException if an initial value, declared without a type, is no bool."""
        if node.has_parameter(USE_SIM_TIME_NAME):
            kind = node.get_parameter(USE_SIM_TIME_NAME).type_
            if kind != Parameter.Type.BOOL:
                node.get_logger().error(
                    f"Invalid type '{TYPE_NAMES[kind]}' for parameter 'use_sim_time', should be 'bool'"
                )
                raise CppException(
                    "Invalid type for parameter 'use_sim_time', should be 'bool'", "std::invalid_argument"
                )
        super().attach_node(node)


class _CppTypeDescriptionService(TypeDescriptionService):
    """rclcpp/node_interfaces/node_type_descriptions.cpp."""

    def _declare(self, node: Node, name: str) -> None:
        if node.has_parameter(name):
            # By `automatically_declare_parameters_from_overrides`: the original does not expect that.
            what = f"parameter '{name}' has already been declared"
            raise RclcppException(what, "ParameterAlreadyDeclaredException")
        description = "Start the ~/get_type_description service for this node."
        try:
            node._rclpy_parameters.declare_plain(name, True, description=description, read_only=True)
        except CppException as error:
            node.get_logger().error(str(error))
            raise


class CppNode(Node):
    """A node of rclcpp. Without a publisher of parameter events nobody hears of its parameters' changes.

    Raises CppException for what rclcpp throws, as do the methods that make publishers, subscriptions and services.
    """

    _rclpy_logger = CppLogger
    _rclpy_store = CppParameterStore
    _rclpy_parameter_service = CppParameterService
    _rclpy_time_source = _CppTimeSource
    _rclpy_type_description = _CppTypeDescriptionService
    _shows_event_qos = True
    """Whether it has parameters for the QoS of /parameter_events."""

    def __init__(self, name: str, *, start_parameter_event_publisher: bool = True, **keywords: Any) -> None:
        self._publishes_events = start_parameter_event_publisher
        with thrown_as_cpp():
            super().__init__(name, **keywords)
            topic = self.resolve_topic_name(_EVENTS)
            qos = qos_profile_parameter_events
            if self._shows_event_qos:
                declared_qos(self._rclpy_parameters, "publisher", topic, qos, QoSOverridingOptions(ALL_FOUR))
            # The clock's: rclcpp looks for `use_sim_time` in these events.
            self.create_subscription(ParameterEvent, _EVENTS, _ignore, qos)

    def _rclpy_event_publisher(self, overrides: dict[str, Parameter[Any]]) -> Publisher[Any] | None:
        if not self._publishes_events:
            return None
        qos = qos_profile_parameter_events
        if self._shows_event_qos:
            qos = event_qos(qos, overrides, self.handle.resolve(_EVENTS, is_service=False))
        return parameter_event_publisher(self.handle, self.default_callback_group, qos)

    def _declare_overrides(self) -> None:
        from rcl_interfaces.msg import ParameterDescriptor

        overrides = sorted(self._rclpy_parameters.overrides.items())
        entries = [(name, each.value, ParameterDescriptor(dynamic_typing=True)) for name, each in overrides]
        self.declare_parameters("", entries, ignore_override=True)

    def create_publisher(
        self,
        msg_type: Any,
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        qos_overriding_options: QoSOverridingOptions | None = None,
        **keywords: Any,
    ) -> Publisher[Any]:
        """Make a publisher; see `rclpy.node.Node.create_publisher`."""
        with thrown_as_cpp():
            qos = self._qos_of("publisher", topic, qos_profile, qos_overriding_options)
            return super().create_publisher(msg_type, topic, qos, **keywords)

    def create_subscription(
        self,
        msg_type: Any,
        topic: str,
        callback: Any,
        qos_profile: QoSProfile | int,
        *,
        qos_overriding_options: QoSOverridingOptions | None = None,
        **keywords: Any,
    ) -> Subscription[Any]:
        """Make a subscription; see `rclpy.node.Node.create_subscription`."""
        with thrown_as_cpp():
            qos = self._qos_of("subscription", topic, qos_profile, qos_overriding_options)
            return super().create_subscription(msg_type, topic, callback, qos, **keywords)

    def create_service(self, srv_type: Any, srv_name: str, callback: Any, **keywords: Any) -> Service[Any, Any]:
        """Make a service; see `rclpy.node.Node.create_service`."""
        with thrown_as_cpp():
            return super().create_service(srv_type, srv_name, callback, **keywords)

    def _qos_of(
        self, entity: str, topic: str, qos: QoSProfile | int, options: QoSOverridingOptions | None
    ) -> QoSProfile:
        if options is None:
            return profile_of(qos)
        return declared_qos(self._rclpy_parameters, entity, self.resolve_topic_name(topic), profile_of(qos), options)


def _ignore(_: object) -> None:
    """Here the node's own parameter callback sets its clock."""
