"""Nodes."""

from __future__ import annotations

import sys
import weakref
from collections.abc import Callable, Iterator, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, Any, ClassVar, Final, TypeVar, Union, overload

from day6_core.graph import names
from rclpy._day6.arguments import parse_node_arguments
from rclpy._day6.entity import Scope
from rclpy._day6.handles import NodeHandle
from rclpy._day6.incidental import also
from rclpy._day6.logging_settings import LoggingSettings
from rclpy._day6.node_entities import NodeEntities, profile_of
from rclpy._day6.node_graph import NamesAndTypes, NodeGraph
from rclpy._day6.node_names import checked_namespace, require_remapped, resolved_name
from rclpy._day6.node_parts import NodePart, Owned
from rclpy._day6.own_services import HASHES, LOG
from rclpy._day6.parameter_events import ParameterEvents, parameter_event_publisher
from rclpy._day6.parameter_store import ParameterStore
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import NodeNameNonExistentError as NodeNameNonExistentError
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock, ROSClock
from rclpy.context import Context
from rclpy.exceptions import NotInitializedException
from rclpy.guard_condition import GuardCondition
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.parameter import Parameter
from rclpy.parameter_service import ParameterService
from rclpy.publisher import Publisher
from rclpy.qos import (
    QoSProfile,
    qos_profile_parameter_events,
    qos_profile_rosout_default,
    qos_profile_services_default,
)
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.time_source import TimeSource
from rclpy.timer import Rate, Timer
from rclpy.type_description_service import TypeDescriptionService
from rclpy.type_support import MsgT, SrvRequestT, SrvResponseT
from rclpy.utilities import get_default_context
from rclpy.waitable import Waitable

if TYPE_CHECKING:
    from typing import TypeAlias

    from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, ParameterValue, SetParametersResult

    from rclpy._day6.parameter_declarations import ParameterTuple
    from rclpy._day6.parameter_store import OnSetCallback, PostSetCallback, PreSetCallback
    from rclpy._day6.typing_names import ServiceType
    from rclpy.endpoint_info import ServiceEndpointInfo
    from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
    from rclpy.executors import Executor
    from rclpy.guard_condition import GuardConditionCallbackType
    from rclpy.parameter import AllowableParameterValue, AllowableParameterValueT
    from rclpy.qos_overriding_options import QoSOverridingOptions
    from rclpy.service import ServiceCallback
    from rclpy.subscription import MessageCallback
    from rclpy.subscription_content_filter_options import ContentFilterOptions
    from rclpy.timer import TimerCallbackType
    from rclpy.topic_endpoint_info import TopicEndpointInfo

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


class Node:
    """A node: a name in the graph, and the maker of publishers, subscriptions, services, clients, timers and parameters.

    `namespace` is put before relative names; `cli_args` are ROS arguments for this node alone, with `use_global_arguments`
    those given to init() apply too. `parameter_overrides` are initial values for parameters that are declared later.
    Raises NotInitializedException before init(), InvalidNodeNameException, InvalidNamespaceException.
    """

    PARAM_REL_TOL = 1e-6
    """How far, relatively, a float may be from a range's end or step and still count as on it."""

    if TYPE_CHECKING:
        ParameterInput: TypeAlias = AllowableParameterValue | Parameter.Type | ParameterValue
    else:
        ParameterInput = Union[Any, Parameter.Type]  # noqa: UP007 (Any | … needs Python 3.11)
    """In real rclpy a name for the types of what declares a parameter."""

    # What the nodes of rclcpp replace (day6_core/ros/programs/rclcpp).
    _rclpy_logger: ClassVar[type[RcutilsLogger]] = RcutilsLogger
    _rclpy_store: ClassVar[type[ParameterStore]] = ParameterStore
    _rclpy_parameter_service: ClassVar[type[ParameterService]] = ParameterService
    _rclpy_time_source: ClassVar[type[TimeSource]] = TimeSource
    _rclpy_type_description: ClassVar[type[TypeDescriptionService]] = TypeDescriptionService

    # The parts have names that no attribute of a program's own node class is likely to hide.
    _rclpy_entities = NodePart[NodeEntities]("_default_callback_group")
    _rclpy_parameters = NodePart[ParameterStore]("_parameters")
    _rclpy_graph = NodePart[NodeGraph]("_Node__node")

    _publishers = Owned("_rclpy_entities", "publishers")
    _subscriptions = Owned("_rclpy_entities", "subscriptions")
    _clients = Owned("_rclpy_entities", "clients")
    _services = Owned("_rclpy_entities", "services")
    _timers = Owned("_rclpy_entities", "timers")
    _guards = Owned("_rclpy_entities", "guards")
    _parameters = Owned("_rclpy_parameters", "parameters")
    _parameter_overrides = Owned("_rclpy_parameters", "overrides")
    _descriptors = Owned("_rclpy_parameters", "descriptors")
    _allow_undeclared_parameters = Owned("_rclpy_parameters", "allow_undeclared")
    _pre_set_parameters_callbacks = Owned("_rclpy_parameters", "pre_set_callbacks")
    _on_set_parameters_callbacks = Owned("_rclpy_parameters", "on_set_callbacks")
    _post_set_parameters_callbacks = Owned("_rclpy_parameters", "post_set_callbacks")
    _parameter_event_publisher = Owned("_Node__parameter_events", "publisher")

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
        self.__executor_weakref: weakref.ReferenceType[Executor] | None = None
        if self._context.handle is None or not self._context.ok():
            raise NotInitializedException("cannot create node")
        rosout_qos = profile_of(rosout_qos_profile)
        self._rosout_name: str | None = None
        overrides = self._create_in_graph(node_name, namespace, cli_args, use_global_arguments)
        if enable_rosout:
            self._create_rosout(rosout_qos)
        self._default_callback_group: CallbackGroup = MutuallyExclusiveCallbackGroup()
        self._rate_group = ReentrantCallbackGroup()
        self._clock: ROSClock = ROSClock()
        self._clock._time = self._context._time
        overrides.update({parameter.name: parameter for parameter in parameter_overrides or ()})
        event_publisher = self._rclpy_event_publisher(overrides)
        self.__parameter_events = ParameterEvents(event_publisher, self.__node, self._clock)
        self._rclpy_graph = NodeGraph(self.__node)
        self._rclpy_parameters = self._rclpy_store(
            overrides=overrides,
            allow_undeclared=allow_undeclared_parameters,
            rel_tol=self.PARAM_REL_TOL,
            listener=self.__parameter_events,
        )
        self._rclpy_entities = NodeEntities(self.__node, self._rclpy_parameters)
        if event_publisher is not None:
            self._rclpy_entities.add_publisher(event_publisher)
        if automatically_declare_parameters_from_overrides:
            self._declare_overrides()
        self._time_source = self._rclpy_time_source(node=self)
        self._time_source.attach_clock(self._clock)
        if start_parameter_services:
            self._parameter_service = self._rclpy_parameter_service(self)
        if enable_logger_service:
            from rclpy.logging_service import LoggingService

            self._logger_service = LoggingService(self)
        self._type_description_service = self._rclpy_type_description(self)
        self._context.track_node(self)

    def _create_in_graph(
        self, node_name: str, namespace: str | None, cli_args: list[str] | None, use_global_arguments: bool
    ) -> dict[str, Parameter[Any]]:
        """Add the node to the graph under its remapped name; returns the parameters in its arguments."""
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
        values: dict[str, Any] = {}
        for each in reversed(arguments):
            values.update(each.parameters_of(full_name))
        assert context._graph is not None
        context._join_link()
        enclave = context._arguments.enclave if context._arguments is not None else "/"
        graph_node = context._graph.create_node(node_name, namespace, enclave=enclave, program=context._program)
        self._logger = self._rclpy_logger._of_node(full_name[1:].replace("/", "."), context._logging)
        self.__node = NodeHandle(context, graph_node, rules, self._logger, Scope())
        return {name: Parameter(name, value=value) for name, value in values.items()}

    def _create_rosout(self, qos: QoSProfile) -> None:
        from rclpy._day6.rosout import RosoutPublisher

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

    def _rclpy_event_publisher(self, overrides: dict[str, Parameter[Any]]) -> Publisher[Any] | None:
        """Return the publisher of /parameter_events; `overrides` are the initial values of parameters."""
        return parameter_event_publisher(self.__node, self._default_callback_group, qos_profile_parameter_events)

    def _declare_overrides(self) -> None:
        from rcl_interfaces.msg import ParameterDescriptor

        overrides = self._rclpy_parameters.overrides.items()
        entries = [(name, parameter.value, ParameterDescriptor()) for name, parameter in overrides]
        self.declare_parameters("", entries, ignore_override=True)

    # -- what the node has ---------------------------------------------------------------------------------------------

    @property
    def publishers(self) -> Iterator[Publisher[Any]]:
        """The publishers made on this node."""
        yield from self._rclpy_entities.publishers

    @property
    def subscriptions(self) -> Iterator[Subscription[Any]]:
        """The subscriptions made on this node."""
        yield from self._rclpy_entities.subscriptions

    @property
    def clients(self) -> Iterator[Client[Any, Any]]:
        """The clients made on this node."""
        yield from self._rclpy_entities.clients

    @property
    def services(self) -> Iterator[Service[Any, Any]]:
        """The services made on this node."""
        yield from self._rclpy_entities.services

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers made on this node."""
        yield from self._rclpy_entities.timers

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions made on this node."""
        yield from self._rclpy_entities.guards

    @property
    def waitables(self) -> Iterator[Waitable[Any]]:
        """The waitables added to this node."""
        yield from self._rclpy_entities.waitables

    @property
    def executor(self) -> Executor | None:
        """The last executor that the node was added to, None if there is none."""
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
    def default_callback_group(self) -> CallbackGroup:
        """The default callback group of the node's entities: its callbacks exclude each other."""
        return self._default_callback_group

    @property
    def handle(self) -> NodeHandle:
        """The handle; it cannot be replaced (AttributeError)."""
        return self.__node

    @handle.setter
    def handle(self, value: object) -> None:
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

    # -- parameters ----------------------------------------------------------------------------------------------------

    @overload
    def declare_parameter(
        self,
        name: str,
        value: Parameter.Type | ParameterValue | None = None,
        descriptor: ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter[Any]: ...

    @overload
    def declare_parameter(
        self,
        name: str,
        value: AllowableParameterValueT,
        descriptor: ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter[AllowableParameterValueT]: ...

    def declare_parameter(
        self,
        name: str,
        value: ParameterInput = None,
        descriptor: ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter[Any]:
        """Declare a parameter and return it with its value: from the command line or a parameter file, else `value`.

        `value` may be a `Parameter.Type` for a parameter that has no value yet.

        Raises:
            ParameterAlreadyDeclaredException: if the parameter is already declared.
            InvalidParameterException: for a bad name.
            InvalidParameterValueException: if the value is out of range or a callback rejects it.
            InvalidParameterTypeException: if the override has another type.
            TypeError, ValueError: for a bad value or descriptor.
        """
        entry: ParameterTuple = (name,)
        if value is not None or descriptor is not None:
            entry = (name, value) if descriptor is None else (name, value, descriptor)
        return self.declare_parameters("", [entry], ignore_override)[0]

    def declare_parameters(
        self, namespace: str, parameters: Sequence[ParameterTuple], ignore_override: bool = False
    ) -> list[Parameter[Any]]:
        """Declare several parameters, given as tuples (name[, value[, descriptor]]), in a namespace. See `declare_parameter`."""
        return self._rclpy_parameters.declare(namespace, parameters, ignore_override)

    def undeclare_parameter(self, name: str) -> None:
        """Forget a parameter.

        Raises:
            ParameterNotDeclaredException: for an undeclared one.
            ParameterImmutableException: for a read-only one.
        """
        self._rclpy_parameters.undeclare(name)

    def has_parameter(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        return self._rclpy_parameters.has(name)

    def get_parameter_types(self, names: list[str]) -> list[int]:
        """Return the types of some parameters; see `get_parameter_type`."""
        return self._rclpy_parameters.types_of(names)

    def get_parameter_type(self, name: str) -> int:
        """Return a parameter's type as a number; NOT_SET or ParameterNotDeclaredException for an undeclared one."""
        return self._rclpy_parameters.type_of(name)

    def get_parameters(self, names: list[str]) -> list[Parameter[Any]]:
        """Return some parameters; see `get_parameter`."""
        return self._rclpy_parameters.get_each(names)

    def get_parameter(self, name: str) -> Parameter[Any]:
        """Return a parameter.

        Raises:
            ParameterNotDeclaredException: if it is undeclared, unless the node allows that; then it is NOT_SET.
            ParameterUninitializedException: for one declared by type alone that has no value yet.
        """
        return self._rclpy_parameters.get(name)

    @overload
    def get_parameter_or(self, name: str, alternative_value: None = None) -> Parameter[Any]: ...

    @overload
    def get_parameter_or(
        self, name: str, alternative_value: Parameter[AllowableParameterValueT]
    ) -> Parameter[AllowableParameterValueT]: ...

    def get_parameter_or(self, name: str, alternative_value: Parameter[Any] | None = None) -> Parameter[Any]:
        """Return a parameter, or the alternative (by default a NOT_SET one) if it is undeclared or has no value."""
        return self._rclpy_parameters.get_or(name, alternative_value)

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter[Any]]:
        """Return the parameters below a prefix, by their names without it; '' means all."""
        return self._rclpy_parameters.by_prefix(prefix)

    def list_parameters(self, prefixes: list[str], depth: int) -> ListParametersResult:
        """Return names and prefixes of parameters below some prefixes (none: all), down to a depth (0: any)."""
        return self._rclpy_parameters.names_below(prefixes, depth)

    def set_parameters(self, parameter_list: list[Parameter[Any]]) -> list[SetParametersResult]:
        """Set parameters one by one; returns a result for each. Raises ParameterNotDeclaredException."""
        return self._rclpy_parameters.set_each(parameter_list)

    def set_parameters_atomically(self, parameter_list: list[Parameter[Any]]) -> SetParametersResult:
        """Set all parameters or none. Raises ParameterNotDeclaredException."""
        return self._rclpy_parameters.set_atomically(parameter_list)

    def add_pre_set_parameters_callback(self, callback: PreSetCallback) -> None:
        """Call `callback(parameters)` before parameters are checked; it returns the list to set."""
        self._rclpy_parameters.add_pre_set_callback(callback)

    def add_on_set_parameters_callback(self, callback: OnSetCallback) -> None:
        """Call `callback(parameters)` before parameters are set; it returns a SetParametersResult. Last added, first called."""
        self._rclpy_parameters.add_on_set_callback(callback)

    def add_post_set_parameters_callback(self, callback: PostSetCallback) -> None:
        """Call `callback(parameters)` after parameters were set."""
        self._rclpy_parameters.add_post_set_callback(callback)

    def remove_pre_set_parameters_callback(self, callback: PreSetCallback) -> None:
        """Remove a callback.

        Raises:
            ValueError: if it was not added.
        """
        self._rclpy_parameters.pre_set_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: OnSetCallback) -> None:
        """Remove a callback.

        Raises:
            ValueError: if it was not added.
        """
        self._rclpy_parameters.on_set_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: PostSetCallback) -> None:
        """Remove a callback.

        Raises:
            ValueError: if it was not added.
        """
        self._rclpy_parameters.post_set_callbacks.remove(callback)

    def describe_parameter(self, name: str) -> ParameterDescriptor:
        """Return a parameter's descriptor; an empty one or ParameterNotDeclaredException for an undeclared one."""
        return self._rclpy_parameters.describe(name)

    def describe_parameters(self, names: list[str]) -> list[ParameterDescriptor]:
        """Return the descriptors of some parameters; see `describe_parameter`."""
        return self._rclpy_parameters.describe_each(names)

    def set_descriptor(
        self, name: str, descriptor: ParameterDescriptor, alternative_value: ParameterValue | None = None
    ) -> ParameterValue:
        """Replace a parameter's descriptor; if its value does not fit the new one, the parameter takes the alternative value.

        Returns the resulting value.

        Raises:
            ParameterNotDeclaredException: for an undeclared parameter.
            ParameterImmutableException: for a read-only one.
            InvalidParameterValueException: if the alternative doesn't fit either.
        """
        return self._rclpy_parameters.set_descriptor(name, descriptor, alternative_value)

    # -- making --------------------------------------------------------------------------------------------------------

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic, remapped unless `only_expand`.

        Raises:
            RCLError: for a bad name.
        """
        return resolved_name(self.__node, topic, only_expand=only_expand, is_service=False)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the full name of a service, remapped unless `only_expand`.

        Raises:
            RCLError: for a bad name.
        """
        return resolved_name(self.__node, service, only_expand=only_expand, is_service=True)

    def add_waitable(self, waitable: Waitable[Any]) -> None:
        """Let the executor run a waitable."""
        self._rclpy_entities.add_waitable(waitable)

    def remove_waitable(self, waitable: Waitable[Any]) -> None:
        """Remove a waitable.

        Raises:
            ValueError: if the node doesn't have it.
        """
        self._rclpy_entities.remove_waitable(waitable)

    def create_publisher(
        self,
        msg_type: type[MsgT],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher[MsgT]] = Publisher,
    ) -> Publisher[MsgT]:
        """Make a publisher of a topic; `qos_profile` may be a depth.

        Raises:
            InvalidTopicNameException: for a bad name.
            TypeError, ValueError: for a bad QoS or type.
            InvalidHandle: after destruction.
            RCLError: when the context was shut down or uses the topic with another type.
        """
        group = callback_group or self.default_callback_group
        return self._rclpy_entities.create_publisher(
            msg_type, topic, qos_profile, group, event_callbacks, qos_overriding_options, publisher_class
        )

    def create_subscription(
        self,
        msg_type: type[MsgT],
        topic: str,
        callback: MessageCallback[MsgT],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
        content_filter_options: ContentFilterOptions | None = None,
    ) -> Subscription[MsgT]:
        """Make a subscription: `callback(message)` or `callback(message, info)` is called for each message.

        With `raw` the message is passed as CDR bytes. Raises as `create_publisher`, and RuntimeError for a callback that takes
        neither one nor two arguments, RCLError for a content filter that does not fit.
        """
        group = callback_group or self.default_callback_group
        return self._rclpy_entities.create_subscription(
            msg_type,
            topic,
            callback,
            qos_profile,
            group,
            event_callbacks,
            qos_overriding_options,
            raw,
            content_filter_options,
        )

    def create_client(
        self,
        srv_type: type[ServiceType[SrvRequestT, SrvResponseT]],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client[SrvRequestT, SrvResponseT]:
        """Make a client of a service.

        Raises:
            InvalidServiceNameException: for a bad name.
            AttributeError, RuntimeError: for a wrong type.
        """
        group = self.default_callback_group if callback_group is None else callback_group
        return self._rclpy_entities.create_client(self._context, srv_type, srv_name, qos_profile, group)

    def create_service(
        self,
        srv_type: type[ServiceType[SrvRequestT, SrvResponseT]],
        srv_name: str,
        callback: ServiceCallback[SrvRequestT, SrvResponseT],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service[SrvRequestT, SrvResponseT]:
        """Make a service: `callback(request, response)` returns the response. Raises as `create_client`."""
        group = self.default_callback_group if callback_group is None else callback_group
        return self._rclpy_entities.create_service(srv_type, srv_name, callback, qos_profile, group)

    def create_timer(
        self,
        timer_period_sec: float,
        callback: TimerCallbackType | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Make a timer: `callback()` is called every `timer_period_sec` seconds, the first time after one period.

        With `autostart=False` it waits for `reset()`.

        Raises:
            TypeError, ValueError: for a period that isn't a number.
            RCLError: for a negative one.
        """
        group = self.default_callback_group if callback_group is None else callback_group
        clock = self._clock if clock is None else clock
        return self._rclpy_entities.create_timer(self._context, timer_period_sec, callback, group, clock, autostart)

    def create_guard_condition(
        self, callback: GuardConditionCallbackType, callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Make a guard condition: `callback()` is called after each `trigger()`."""
        group = self.default_callback_group if callback_group is None else callback_group
        return self._rclpy_entities.create_guard_condition(self._context, callback, group)

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Make a rate: its `sleep()` ends `frequency` times a second while the node spins in another thread.

        Raises:
            ValueError: for a frequency that isn't positive.
        """
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        timer = self.create_timer(1.0 / frequency, None, self._rate_group, clock)
        return Rate(timer, context=self._context)

    # -- destroying ----------------------------------------------------------------------------------------------------

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher of this node; False if it isn't one of them."""
        return self._rclpy_entities.destroy(publisher, self._publishers)

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription of this node; False if it isn't one of them."""
        return self._rclpy_entities.destroy(subscription, self._subscriptions)

    def destroy_client(self, client: Client[Any, Any]) -> bool:
        """Destroy a client of this node; False if it isn't one of them."""
        return self._rclpy_entities.destroy(client, self._clients)

    def destroy_service(self, service: Service[Any, Any]) -> bool:
        """Destroy a service of this node; False if it isn't one of them."""
        return self._rclpy_entities.destroy(service, self._services)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer of this node; False if it isn't one of them."""
        return self._rclpy_entities.destroy(timer, self._timers)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition of this node; False if it isn't one of them."""
        return self._rclpy_entities.destroy(guard, self._guards)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate of this node and its timer; False if it isn't one of them."""
        success = self.destroy_timer(rate._timer)
        rate.destroy()
        return success

    def destroy_node(self) -> None:
        """Destroy the node and all its entities."""
        self._context.untrack_node(self)
        self._parameter_event_publisher = None
        self._rclpy_entities.destroy_all()
        self._type_description_service.destroy()
        self._forget_in_graph()
        self._rclpy_entities.wake_executor()

    def _forget_in_graph(self) -> None:
        if self._rosout_name is not None:
            self.__node.context._logging.publishers.pop(self._rosout_name, None)
            self._rosout_name = None
        self.__node.destroy_when_not_in_use()

    def __del__(self, python_ends: Callable[[], bool] = sys.is_finalizing) -> None:
        # A node without references disappears, as in real rclpy; not while the interpreter ends, when half of its modules are
        # already empty.
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

    # -- the graph -----------------------------------------------------------------------------------------------------

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics a node publishes, with types.

        Raises:
            NodeNameNonExistentError: if it is unknown.
            RCLError: for bad names.
        """
        return self._rclpy_graph.get_publisher_names_and_types_by_node(node_name, node_namespace, no_demangle)

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics a node subscribes to, with types; raises as `get_publisher_names_and_types_by_node`."""
        return self._rclpy_graph.get_subscriber_names_and_types_by_node(node_name, node_namespace, no_demangle)

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services a node serves; raises as `get_publisher_names_and_types_by_node`."""
        return self._rclpy_graph.get_service_names_and_types_by_node(node_name, node_namespace)

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services a node is a client of; raises as `get_publisher_names_and_types_by_node`."""
        return self._rclpy_graph.get_client_names_and_types_by_node(node_name, node_namespace)

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """Return all topics with their types."""
        return self._rclpy_graph.get_topic_names_and_types(no_demangle)

    def get_service_names_and_types(self) -> NamesAndTypes:
        """Return all services with their types."""
        return self._rclpy_graph.get_service_names_and_types()

    def get_node_names(self) -> list[str]:
        """Return the names of all nodes, without namespaces."""
        return self._rclpy_graph.get_node_names()

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the full names of all nodes."""
        return self._rclpy_graph.get_fully_qualified_node_names()

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return (name, namespace) of all nodes."""
        return self._rclpy_graph.get_node_names_and_namespaces()

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Return (name, namespace, enclave) of all nodes."""
        return self._rclpy_graph.get_node_names_and_namespaces_with_enclaves()

    def get_fully_qualified_name(self) -> str:
        """Return this node's namespace and name."""
        self.__node.check()
        return self.__node.get_fully_qualified_name()

    def count_publishers(self, topic_name: str) -> int:
        """Return the number of publishers of a topic (relative names belong to the node's namespace; no remapping)."""
        return self._rclpy_graph.count_publishers(topic_name)

    def count_subscribers(self, topic_name: str) -> int:
        """Return the number of subscriptions of a topic."""
        return self._rclpy_graph.count_subscribers(topic_name)

    def count_clients(self, service_name: str) -> int:
        """Return the number of clients of a service."""
        return self._rclpy_graph.count_clients(service_name)

    def count_services(self, service_name: str) -> int:
        """Return the number of servers of a service."""
        return self._rclpy_graph.count_services(service_name)

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the publishers of a topic: node, type, GID, QoS."""
        return self._rclpy_graph.get_publishers_info_by_topic(topic_name, no_mangle)

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the subscriptions of a topic: node, type, GID, QoS."""
        return self._rclpy_graph.get_subscriptions_info_by_topic(topic_name, no_mangle)

    def get_clients_info_by_service(self, service_name: str, no_mangle: bool = False) -> list[ServiceEndpointInfo]:
        """Return the clients of a service: node, type, GIDs, QoS."""
        return self._rclpy_graph.get_clients_info_by_service(service_name, no_mangle)

    def get_servers_info_by_service(self, service_name: str, no_mangle: bool = False) -> list[ServiceEndpointInfo]:
        """Return the servers of a service: node, type, GIDs, QoS."""
        return self._rclpy_graph.get_servers_info_by_service(service_name, no_mangle)

    def get_action_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the actions a node is a client of; RCLError if it is unknown."""
        return self._rclpy_graph.get_action_client_names_and_types_by_node(node_name, node_namespace)

    def get_action_server_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the actions a node serves; RCLError if it is unknown."""
        return self._rclpy_graph.get_action_server_names_and_types_by_node(node_name, node_namespace)

    def get_action_names_and_types(self) -> NamesAndTypes:
        """Return all actions with their types."""
        return self._rclpy_graph.get_action_names_and_types()

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Block until a node exists, at most `timeout` seconds; returns whether it does."""
        return self._rclpy_graph.wait_for_node(fully_qualified_node_name, timeout)


withdraw(__name__)
