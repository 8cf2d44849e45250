"""Nodes."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, TypeVar

from day6_tui.core.graph import names
from rclpy._arguments import parse_arguments
from rclpy._entity import Scope
from rclpy._handles import INVALID_NODE, EndpointHandle, NodeHandle
from rclpy._logging_settings import LoggingSettings
from rclpy._node_graph import NodeGraph
from rclpy._node_parameters import NodeParameters
from rclpy._own_services import HASHES, LOG, PARAMETER_EVENT, copy_any
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError
from rclpy._rclpy_pybind11 import NodeNameNonExistentError as NodeNameNonExistentError
from rclpy._resolve import expand, raise_for_namespace, raise_for_node, raise_for_topic, require_text
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock, ROSClock
from rclpy.constants import S_TO_NS
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
from rclpy.type_support import check_is_valid_msg_type, check_is_valid_srv_type
from rclpy.utilities import get_default_context
from rclpy.waitable import Waitable

if TYPE_CHECKING:
    from day6_tui.core.graph.names import RemapRule
    from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
    from rclpy.executors import Executor
    from rclpy.logging_service import LoggingService
    from rclpy.qos_overriding_options import QoSOverridingOptions
    from rclpy.subscription_content_filter_options import ContentFilterOptions

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
_WRONG_NAME_TYPE = (
    "rclpy_resolve_name(): incompatible function arguments. The following argument types are supported:\n"
    "    1. (arg0: rclpy::Node, arg1: str, arg2: bool, arg3: bool) -> str\n\nInvoked with: {!r}, {!r}, {}, {}"
)


class Node(NodeParameters, NodeGraph):
    """A node: a name in the graph, and the maker of publishers, subscriptions, services, clients, timers and parameters.

    `namespace` comes before relative names; `cli_args` are ROS arguments for this node alone, `use_global_arguments` says
    whether those given to init() count too. `parameter_overrides` are initial values for parameters that get declared.
    Raises NotInitializedException before init(), InvalidNodeNameException, InvalidNamespaceException.
    """

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
        self._publishers: list[Publisher[Any]] = []
        self._subscriptions: list[Subscription[Any]] = []
        self._clients: list[Client[Any, Any]] = []
        self._services: list[Service[Any, Any]] = []
        self._timers: list[Timer] = []
        self._hidden_timers: list[Timer] = []
        """Timers of action servers, which are none of the node's `timers`."""
        self._guards: list[GuardCondition] = []
        self.__waitables: list[Waitable[Any]] = []
        self._default_callback_group = MutuallyExclusiveCallbackGroup()
        self._rate_group = ReentrantCallbackGroup()
        self._scope = Scope()
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
        namespace = _checked_namespace(node_name, namespace or "", context, self)
        arguments = [parse_arguments(list(cli_args))] if cli_args else []
        if use_global_arguments and context._arguments is not None:
            arguments.append(context._arguments)
        rules = [rule for each in arguments for rule in each.rules]
        if rules:
            node_name, namespace = names.remap_node(node_name, namespace, rules)
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
        publisher = RosoutPublisher(graph_node, HASHES[LOG], qos.get_c_qos_profile())
        graph_node.graph.add_endpoint(publisher)
        settings: LoggingSettings = self._context._logging
        name = self._logger.name
        if name in settings.publishers:
            settings.emit(30, "rcl.logging_rosout", _SHARED_NAME.format(graph_node.name, name), "", "", 0)
        else:
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
            EndpointHandle(handle, endpoint, is_topic=True),
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
            EndpointHandle(handle, endpoint, is_topic=False),
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

    def _add(self, entity: Any, entities: list[Any], group: CallbackGroup) -> None:
        group.add_entity(entity)
        entities.append(entity)
        entity._enter(self._scope)

    # what the node has

    @property
    def publishers(self) -> Iterator[Publisher[Any]]:
        """The publishers made on this node."""
        yield from self._publishers

    @property
    def subscriptions(self) -> Iterator[Subscription[Any]]:
        """The subscriptions made on this node."""
        yield from self._subscriptions

    @property
    def clients(self) -> Iterator[Client[Any, Any]]:
        """The clients made on this node."""
        yield from self._clients

    @property
    def services(self) -> Iterator[Service[Any, Any]]:
        """The services made on this node."""
        yield from self._services

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers made on this node."""
        yield from self._timers

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions made on this node."""
        yield from self._guards

    @property
    def waitables(self) -> Iterator[Waitable[Any]]:
        """The waitables added to this node."""
        yield from self.__waitables

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

    def _wake_executor(self) -> None:
        executor = self.executor
        if executor is not None:
            executor.wake()

    @property
    def context(self) -> Context:
        """The context of the node."""
        return self._context

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of everything that is made without naming one: its callbacks exclude each other."""
        return self._default_callback_group

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

    # names

    def _resolved(self, name: str, only_expand: bool, is_service: bool) -> str:
        handle = self.__node
        handle.check()
        if not isinstance(name, str):
            require_text(name)
            raise TypeError(_WRONG_NAME_TYPE.format(handle, name, only_expand, is_service))
        flaw = names.flaw_of_topic_name(name)
        if flaw is not None:
            raise RCLError(f"failed to resolve name: {flaw.message}, at /project/src/rcl/expand_topic_name.c:73")
        try:
            full = names.expand(name, handle.name, handle.namespace)
        except names.UnknownSubstitution as error:
            raise RCLError(
                f"failed to resolve name: {error}, at /project/src/rcl/expand_topic_name.c:164"
            ) from None
        if handle.rules and not only_expand:
            full = names.remap_topic(full, handle.name, handle.namespace, _rules_for(handle.rules, is_service))
        flaw = names.flaw_of_full_topic_name(full)
        if flaw is not None:
            raise RCLError(f"failed to resolve name: {flaw.message}, at /project/src/rcl/node_resolve_name.c:102")
        return full

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic, remapped unless `only_expand`. RCLError for a bad name."""
        return self._resolved(topic, only_expand, False)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the full name of a service, remapped unless `only_expand`. RCLError for a bad name."""
        return self._resolved(service, only_expand, True)

    def _full_topic_name(self, topic: str) -> str:
        """Return the full, remapped name; raises what a student sees for a bad one."""
        try:
            full = self.resolve_topic_name(topic)
        except RCLError:
            self._validate_topic_or_service_name(topic)
            raise
        return full

    def _full_service_name(self, service: str) -> str:
        handle = self.__node
        handle.check()
        raise_for_topic(names.flaw_of_topic_name(service), service, is_service=True)
        full = expand(service, handle.name, handle.namespace)
        if handle.rules:
            full = names.remap_topic(full, handle.name, handle.namespace, _rules_for(handle.rules, True))
        raise_for_topic(names.flaw_of_full_topic_name(full), full, is_service=True)
        return full

    def _validate_topic_or_service_name(self, topic_or_service_name: str, *, is_service: bool = False) -> None:
        if topic_or_service_name is None:
            require_text(None)
        raise_for_topic(names.flaw_of_topic_name(topic_or_service_name), topic_or_service_name, is_service=is_service)
        full = expand(topic_or_service_name, self.get_name(), self.get_namespace())
        raise_for_topic(names.flaw_of_full_topic_name(full), full, is_service=is_service)

    def _validate_qos_or_depth_parameter(self, qos_or_depth: QoSProfile | int) -> QoSProfile:
        if isinstance(qos_or_depth, QoSProfile):
            return qos_or_depth
        if isinstance(qos_or_depth, int):
            if qos_or_depth < 0:
                raise ValueError("history depth must be greater than or equal to zero")
            return QoSProfile(depth=qos_or_depth)
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos_or_depth)!r}")

    # entities

    def add_waitable(self, waitable: Waitable[Any]) -> None:
        """Have the executor look after a waitable."""
        self.__waitables.append(waitable)
        waitable._enter(self._scope)
        self._wake_executor()

    def remove_waitable(self, waitable: Waitable[Any]) -> None:
        """Let go of a waitable; ValueError if it is not there."""
        self.__waitables.remove(waitable)
        self._wake_executor()

    def create_publisher(
        self,
        msg_type: type[Any],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher[Any]] = Publisher,
    ) -> Publisher[Any]:
        """Make a publisher of a topic; `qos_profile` may be a depth.

        Raises InvalidTopicNameException, TypeError and ValueError for a bad QoS or type, InvalidHandle after destruction,
        RCLError when the context was shut down or uses the topic with another type.
        """
        qos_profile = self._validate_qos_or_depth_parameter(qos_profile)
        group = callback_group or self.default_callback_group
        full = self._full_topic_name(topic)
        if qos_overriding_options is not None:
            self._override_qos(Publisher, full, qos_profile, qos_overriding_options)
        check_is_valid_msg_type(msg_type)
        handle = self.__node
        handle.check_valid("Failed to create publisher")
        type_name, type_hash = _type_of(msg_type)
        handle.claim_topic(
            full, type_name, "publisher", "/project/src/publisher.cpp:145, at /project/src/rcl/publisher.c:118"
        )
        from day6_tui.core.interfaces import copy_message

        endpoint = handle.node.create_publisher(
            full, type_name, type_hash, qos_profile.get_c_qos_profile(), copy_message
        )
        endpoint_handle = EndpointHandle(handle, endpoint, is_topic=True)
        try:
            publisher = publisher_class(endpoint_handle, msg_type, topic, qos_profile, event_callbacks, group)
        except Exception:
            endpoint_handle.destroy_when_not_in_use()
            raise
        self._publishers.append(publisher)
        publisher._enter(self._scope)
        return publisher

    def create_subscription(
        self,
        msg_type: type[Any],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
        content_filter_options: ContentFilterOptions | None = None,
    ) -> Subscription[Any]:
        """Make a subscription: `callback(message)` or `callback(message, info)` is called for each message.

        With `raw` the message comes as CDR bytes. Raises as `create_publisher`, and RuntimeError for a callback that takes
        neither one nor two arguments. `content_filter_options` are accepted, but nothing is filtered.
        """
        qos_profile = self._validate_qos_or_depth_parameter(qos_profile)
        group = callback_group or self.default_callback_group
        full = self._full_topic_name(topic)
        if qos_overriding_options is not None:
            self._override_qos(Subscription, full, qos_profile, qos_overriding_options)
        check_is_valid_msg_type(msg_type)
        handle = self.__node
        handle.check_valid("Failed to create subscription")
        type_name, type_hash = _type_of(msg_type)
        handle.claim_topic(
            full, type_name, "subscription", "/project/src/subscription.cpp:526, at /project/src/rcl/subscription.c:116"
        )
        endpoint = handle.node.create_subscription(full, type_name, type_hash, qos_profile.get_c_qos_profile())
        endpoint_handle = EndpointHandle(handle, endpoint, is_topic=True)
        try:
            subscription: Subscription[Any] = Subscription(
                endpoint_handle, msg_type, topic, callback, group, qos_profile, raw, event_callbacks
            )
        except Exception:
            endpoint_handle.destroy_when_not_in_use()
            raise
        self._add(subscription, self._subscriptions, group)
        return subscription

    def _override_qos(
        self, kind: type[Any], topic: str, qos_profile: QoSProfile, options: QoSOverridingOptions
    ) -> None:
        from rclpy.qos_overriding_options import _declare_qos_parameters

        _declare_qos_parameters(kind, self, topic, qos_profile, options)

    def create_client(
        self,
        srv_type: type[Any],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client[Any, Any]:
        """Make a client of a service. Raises InvalidServiceNameException, AttributeError and RuntimeError for a wrong type."""
        group = self.default_callback_group if callback_group is None else callback_group
        check_is_valid_srv_type(srv_type)
        full = self._service_name_for("Client", srv_type, srv_name, qos_profile)
        handle = self.__node
        handle.check_valid("failed to create client")
        type_name, type_hash = _type_of(srv_type)
        from day6_tui.core.interfaces import copy_message

        endpoint = handle.node.create_client(full, type_name, type_hash, qos_profile.get_c_qos_profile(), copy_message)
        client: Client[Any, Any] = Client(
            self._context, EndpointHandle(handle, endpoint, is_topic=False), srv_type, srv_name, qos_profile, group
        )
        self._add(client, self._clients, group)
        return client

    def create_service(
        self,
        srv_type: type[Any],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service[Any, Any]:
        """Make a service: `callback(request, response)` returns the response. Raises as `create_client`."""
        group = self.default_callback_group if callback_group is None else callback_group
        check_is_valid_srv_type(srv_type)
        full = self._service_name_for("Service", srv_type, srv_name, qos_profile)
        handle = self.__node
        handle.check_valid("failed to create service")
        type_name, type_hash = _type_of(srv_type)
        from day6_tui.core.interfaces import copy_message

        endpoint = handle.node.create_service(full, type_name, type_hash, qos_profile.get_c_qos_profile(), copy_message)
        service: Service[Any, Any] = Service(
            EndpointHandle(handle, endpoint, is_topic=False), srv_type, srv_name, callback, group, qos_profile
        )
        self._add(service, self._services, group)
        return service

    def _service_name_for(self, kind: str, srv_type: Any, srv_name: Any, qos_profile: QoSProfile) -> str:
        if not isinstance(srv_name, str):
            raise TypeError(
                "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
                f"    1. rclpy._rclpy_pybind11.{kind}(arg0: rclpy::Node, arg1: object, arg2: str, arg3: object)\n\n"
                f"Invoked with: {self.__node!r}, {srv_type!r}, {srv_name!r}, "
                f"<rclpy._rclpy_pybind11.rmw_qos_profile_t object at {id(qos_profile):#x}>"
            )
        return self._full_service_name(srv_name)

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Make a timer: `callback()` is called every `timer_period_sec` seconds, the first time after one period.

        With `autostart=False` it waits for `reset()`. Raises TypeError and ValueError for what is no number, RCLError for a
        negative period.
        """
        period = int(float(timer_period_sec) * S_TO_NS)
        group = self.default_callback_group if callback_group is None else callback_group
        timer = Timer(
            callback,
            group,
            period,
            self._clock if clock is None else clock,
            context=self._context,
            autostart=autostart,
        )
        self._add(timer, self._timers, group)
        timer._schedule()
        return timer

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Make a guard condition: `callback()` is called after each `trigger()`."""
        group = self.default_callback_group if callback_group is None else callback_group
        guard = GuardCondition(callback, group, context=self._context)
        self._add(guard, self._guards, group)
        return guard

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Make a rate: its `sleep()` ends `frequency` times a second while the node spins in another thread.

        ValueError unless the frequency is positive.
        """
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        timer = self.create_timer(1.0 / frequency, None, self._rate_group, clock)
        return Rate(timer, context=self._context)

    # end

    def _remove(self, entity: Any, entities: list[Any]) -> bool:
        if entity not in entities:
            return False
        entities.remove(entity)
        try:
            entity.destroy()
        except InvalidHandle:
            return False
        self._wake_executor()
        return True

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher of this node; False if it is none."""
        return self._remove(publisher, self._publishers)

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription of this node; False if it is none."""
        return self._remove(subscription, self._subscriptions)

    def destroy_client(self, client: Client[Any, Any]) -> bool:
        """Destroy a client of this node; False if it is none."""
        return self._remove(client, self._clients)

    def destroy_service(self, service: Service[Any, Any]) -> bool:
        """Destroy a service of this node; False if it is none."""
        return self._remove(service, self._services)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer of this node; False if it is none."""
        return self._remove(timer, self._timers)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition of this node; False if it is none."""
        return self._remove(guard, self._guards)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate of this node and its timer; False if it is none."""
        success = self.destroy_timer(rate._timer)
        rate.destroy()
        return success

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

    def __del__(self) -> None:
        # A node that nobody holds any more disappears, as a real one does.
        if hasattr(self, "_Node__node") and not self.__node._destroyed:
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


class _OwnPublisher(Publisher[Any]):
    """The publisher of a node's parameter events: its class of messages is made only when one is sent."""


def _type_of(interface: type[Any]) -> tuple[str, str]:
    from day6_tui.core.interfaces import type_hash, type_name

    return type_name(interface), type_hash(interface)


def _rules_for(rules: list[RemapRule], is_service: bool) -> list[RemapRule]:
    """Return the rules that count for topics or for services; `rostopic://` and `rosservice://` limit a rule."""
    if not any("://" in rule.match for rule in rules):
        return rules
    wanted, other = ("rosservice://", "rostopic://") if is_service else ("rostopic://", "rosservice://")
    return [
        type(rule)(rule.kind, rule.match.removeprefix(wanted), rule.replacement, rule.node)
        for rule in rules
        if not rule.match.startswith(other)
    ]


def _checked_namespace(node_name: Any, namespace: Any, context: Context, node: Node) -> str:
    """Check a node's names as rclpy's binding, rcl and rmw do; returns the full namespace."""
    if node_name is None:
        raise RCLError("error creating node: name argument is null, at /project/src/rcl/node.c:126")
    if not isinstance(node_name, str) or not isinstance(namespace, str):
        raise TypeError(
            "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
            "    1. rclpy._rclpy_pybind11.Node(arg0: str, arg1: str, arg2: rclpy._rclpy_pybind11.Context, arg3: object, "
            f"arg4: bool, arg5: bool, arg6: object)\n\nInvoked with: {node_name!r}, {namespace!r}, "
            f"<rclpy._rclpy_pybind11.Context object at {id(context):#x}>, None, True, True, "
            f"<rclpy._rclpy_pybind11.rmw_qos_profile_t object at {id(node):#x}>"
        )
    raise_for_node(node_name)
    if not namespace.startswith("/"):
        namespace = f"/{namespace}"
    raise_for_namespace(namespace)
    return namespace
