"""Nodes."""

from __future__ import annotations

import sys
import weakref
from collections.abc import Callable
from types import FunctionType, TracebackType
from typing import TYPE_CHECKING, Any, Final, TypeVar, Union

from day6_tui.core.graph import names
from rclpy._arguments import parse_node_arguments
from rclpy._endpoint_handles import PublisherHandle, ServiceHandle
from rclpy._handles import NodeHandle
from rclpy._incidental import also
from rclpy._logging_settings import LoggingSettings
from rclpy._node_declarations import NodeDeclarations
from rclpy._node_entities import NodeEntities
from rclpy._node_graph import NodeGraph
from rclpy._node_names import NodeNames, checked_namespace, require_remapped
from rclpy._node_parameters import NodeParameters
from rclpy._own_services import HASHES, LOG, PARAMETER_EVENT, copy_any
from rclpy._rclpy_pybind11 import NodeNameNonExistentError as NodeNameNonExistentError
from rclpy.clock import Clock, ROSClock
from rclpy.context import Context
from rclpy.exceptions import NotInitializedException
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.parameter import Parameter
from rclpy.parameter_service import ParameterService
from rclpy.publisher import Publisher
from rclpy.qos import (
    QoSProfile,
    qos_profile_parameter_events,
    qos_profile_rosout_default,
)
from rclpy.service import Service
from rclpy.time_source import TimeSource
from rclpy.type_description_service import TypeDescriptionService
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.executors import Executor
    from rclpy.logging_service import LoggingService

__getattr__ = also(
    __name__,
    "Srv AllowableParameterValueT CallbackGroup Client ContentFilterOptions Executor FloatingPointRange "
    "GuardCondition IntegerRange InvalidHandle InvalidParameterTypeException "
    "InvalidParameterValueException InvalidTopicNameException ListParameters ListParametersResult "
    "LoggingService MessageInfo MutuallyExclusiveCallbackGroup PARAMETER_SEPARATOR_STRING "
    "ParameterAlreadyDeclaredException ParameterDescriptor ParameterEvent ParameterImmutableException "
    "ParameterMsg ParameterNotDeclaredException ParameterType ParameterUninitializedException "
    "ParameterValue PublisherEventCallbacks QoSOverridingOptions Rate ReentrantCallbackGroup S_TO_NS "
    "SetParametersResult Subscription SubscriptionEventCallbacks Timer TimerInfo TopicEndpointInfo "
    "Waitable check_is_valid_msg_type check_is_valid_srv_type expand_topic_name get_logger "
    "qos_profile_services_default validate_full_topic_name validate_namespace validate_node_name "
    "validate_parameter_name validate_topic_name",
)


HIDDEN_NODE_PREFIX: Final = "_"

MsgType = TypeVar("MsgType")
SrvType = TypeVar("SrvType")
SrvTypeRequest = TypeVar("SrvTypeRequest")
SrvTypeResponse = TypeVar("SrvTypeResponse")

_SHARED_NAME = (
    "Publisher already registered for node name: '{}'. If this is due to multiple nodes with the same name then all "
    "logs for the logger named '{}' will go out over the existing publisher. As soon as any node with that name is "
    "destructed it will unregister the publisher, preventing any further logs for that name from being published on "
    "the rosout topic."
)


class Node(NodeParameters, NodeGraph, NodeEntities):
    """A node: a name in the graph, and the maker of publishers, subscriptions, services, clients, timers and parameters.

    `namespace` comes before relative names; `cli_args` are ROS arguments for this node alone, `use_global_arguments` says
    whether those given to init() count too. `parameter_overrides` are initial values for parameters that get declared.
    Raises NotInitializedException before init(), InvalidNodeNameException, InvalidNamespaceException.
    """

    ParameterInput = Union[Any, Parameter.Type]  # noqa: UP007 (Any | … needs Python 3.11)
    """In real rclpy a name for the types of what declares a parameter."""

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        rosout_qos_profile: QoSProfile | int = qos_profile_rosout_default,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter[Any]] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        self._context = get_default_context() if context is None else context
        self._set_up_entities()
        self.__executor_weakref: weakref.ReferenceType[Executor] | None = None
        self._set_up_parameters(allow_undeclared_parameters)
        if self._context.handle is None or not self._context.ok():
            raise NotInitializedException("cannot create node")
        rosout_qos = self._validate_qos_or_depth_parameter(rosout_qos_profile)
        self._rosout_name: str | None = None
        overrides = self._create_in_graph(node_name, namespace, cli_args, use_global_arguments)
        if enable_rosout:
            self._create_rosout(rosout_qos)
        self._parameter_event_publisher = self._create_own_publisher()
        self._parameter_overrides = {name: Parameter(name, value=value) for name, value in overrides.items()}
        if parameter_overrides is not None:
            self._parameter_overrides.update({parameter.name: parameter for parameter in parameter_overrides})
        self._clock: ROSClock = ROSClock()
        self._clock._time = self._context._time
        if automatically_declare_parameters_from_overrides:
            self._declare_overrides()
        self._time_source = TimeSource(node=self)
        self._time_source.attach_clock(self._clock)
        if start_parameter_services:
            self._parameter_service = ParameterService(self)
        self._logger_service: LoggingService | None = None
        if enable_logger_service:
            from rclpy.logging_service import LoggingService

            self._logger_service = LoggingService(self)
        self._type_description_service = TypeDescriptionService(self)
        self._context.track_node(self)

    # making

    def _create_in_graph(
        self, node_name: str, namespace: str | None, cli_args: list[str] | None, use_global_arguments: bool
    ) -> dict[str, Any]:
        """Put the node into the graph under its remapped name; returns the parameters its arguments name."""
        context = self._context
        namespace = checked_namespace(node_name, namespace or "", context, self)
        arguments = [parse_node_arguments(list(cli_args))] if cli_args else []
        if use_global_arguments and context._arguments is not None:
            arguments.append(context._arguments)
        rules = [rule for each in arguments for rule in each.rules]
        if rules:
            node_name, namespace = names.remap_node(node_name, namespace, rules)
            require_remapped(namespace)
        full_name = names.full_name(namespace, node_name)
        overrides: dict[str, Any] = {}
        for each in reversed(arguments):
            overrides.update(each.parameters_of(full_name))
        assert context._graph is not None
        context._join_link()
        enclave = context._arguments.enclave if context._arguments is not None else "/"
        graph_node = context._graph.create_node(node_name, namespace, enclave=enclave)
        self._logger = RcutilsLogger._of_node(full_name[1:].replace("/", "."), context._logging)
        self.__node = NodeHandle(context, graph_node, rules, self._logger, self._scope)
        return overrides

    def _create_rosout(self, qos: QoSProfile) -> None:
        from rclpy._rosout import RosoutPublisher

        graph_node = self.__node.node
        settings: LoggingSettings = self._context._logging
        name = self._logger.name
        if name in settings.publishers:
            settings.emit(30, "rcl.logging_rosout", _SHARED_NAME.format(graph_node.name, name), "", "", 0)
        else:
            publisher = RosoutPublisher(graph_node, HASHES[LOG], qos.get_c_qos_profile(), self._context.ok)
            graph_node.graph.add_endpoint(publisher)
            settings.publishers[name] = publisher
        self._rosout_name = name

    def _create_own_publisher(self) -> Publisher[Any]:
        qos = qos_profile_parameter_events
        handle = self.__node
        topic = self.resolve_topic_name("/parameter_events")
        handle.claim_topic(topic, PARAMETER_EVENT, "publisher", "")
        endpoint = handle.node.create_publisher(
            topic, PARAMETER_EVENT, HASHES[PARAMETER_EVENT], qos.get_c_qos_profile(), copy_any
        )
        publisher: Publisher[Any] = _OwnPublisher(
            PublisherHandle._of(handle, endpoint, is_topic=True),
            object,
            "/parameter_events",
            qos,
            None,
            self._default_callback_group,
        )
        publisher._enter(self._scope)
        self._publishers.append(publisher)
        return publisher

    def _create_own_service(
        self, type_name: str, name: str, callback: Callable[[Any, Any], Any], qos: QoSProfile
    ) -> None:
        """Add one of the services every node has; its class is made when the first request comes."""
        handle = self.__node
        srv_name = f"{handle.name}/{name}"
        full_name = self._full_service_name(srv_name)
        endpoint = handle.node.create_service(
            full_name, type_name, HASHES[type_name], qos.get_c_qos_profile(), copy_any
        )
        service: Service[Any, Any] = Service(
            ServiceHandle._of(handle, endpoint, is_topic=False),
            type_name,
            srv_name,
            callback,
            self._default_callback_group,
            qos,
        )
        self._add(service, self._services, self._default_callback_group)

    def _declare_overrides(self) -> None:
        from rcl_interfaces.msg import ParameterDescriptor

        entries = [(name, each.value, ParameterDescriptor()) for name, each in self._parameter_overrides.items()]
        self.declare_parameters("", entries, ignore_override=True)

    # what the node has

    @property
    def executor(self) -> Executor | None:
        """The executor the node was added to last, None if there is none."""
        return None if self.__executor_weakref is None else self.__executor_weakref()

    @executor.setter
    def executor(self, new_executor: Executor) -> None:
        current = self.executor
        if current == new_executor:
            return
        if current is not None:
            current.remove_node(self)
        if new_executor is None:
            self.__executor_weakref = None
        else:
            new_executor.add_node(self)
            self.__executor_weakref = weakref.ref(new_executor)

    @property
    def context(self) -> Context:
        """The context of the node."""
        return self._context

    @property
    def handle(self) -> NodeHandle:
        """The handle; it cannot be replaced (AttributeError)."""
        return self.__node

    @handle.setter
    def handle(self, value: Any) -> None:
        raise AttributeError("handle cannot be modified after node creation")

    def get_name(self) -> str:
        """Return the node's name, without namespace."""
        self.__node.check()
        return self.__node.name

    def get_namespace(self) -> str:
        """Return the node's namespace."""
        self.__node.check()
        return self.__node.namespace

    def get_clock(self) -> Clock:
        """Return the node's clock: system time, or simulated time with the parameter `use_sim_time`."""
        return self._clock

    def get_logger(self) -> RcutilsLogger:
        """Return the node's logger."""
        return self._logger

    # end

    def destroy_node(self) -> None:
        """Take the node with everything on it out of the graph."""
        self._context.untrack_node(self)
        self._parameter_event_publisher = None
        for entities in (
            self._publishers,
            self._subscriptions,
            self._clients,
            self._services,
            self._timers,
            self._guards,
            self._hidden_entities,
        ):
            while entities:
                self._remove(entities[0], entities)
        self._type_description_service.destroy()
        self._forget_in_graph()
        self._wake_executor()

    def _forget_in_graph(self) -> None:
        if self._rosout_name is not None:
            self._context._logging.publishers.pop(self._rosout_name, None)
            self._rosout_name = None
        self.__node.destroy_when_not_in_use()

    def __del__(self, python_ends: Callable[[], bool] = sys.is_finalizing) -> None:
        # A node that nobody holds any more disappears, as a real one does; at Python's end with the process, half of whose
        # modules are empty by then.
        if not python_ends() and hasattr(self, "_Node__node") and not self.__node._destroyed:
            self._forget_in_graph()

    def __enter__(self) -> Node:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.destroy_node()


for _part in (NodeParameters, NodeDeclarations, NodeGraph, NodeEntities, NodeNames):
    for _name, _member in vars(_part).items():
        if isinstance(_member, FunctionType):
            # What Python says about wrong arguments names the class: "Node.create_publisher() missing 1 required …".
            _member.__qualname__ = f"Node.{_name}"


class _OwnPublisher(Publisher[Any]):
    """The publisher of a node's parameter events: its class of messages is made only when one is sent."""
