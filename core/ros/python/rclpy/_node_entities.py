"""What is made on a node: publishers, subscriptions, services, clients, timers, guard conditions, rates."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, cast

from rclpy._endpoint_handles import ClientHandle, PublisherHandle, ServiceHandle, SubscriptionHandle
from rclpy._entity import Scope
from rclpy._node_names import NodeNames
from rclpy._rclpy_pybind11 import InvalidHandle
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock
from rclpy.constants import S_TO_NS
from rclpy.guard_condition import GuardCondition
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile, qos_profile_services_default
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.timer import Rate, Timer
from rclpy.type_support import check_is_valid_msg_type, check_is_valid_srv_type
from rclpy.waitable import Waitable

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
    from rclpy.node import Node
    from rclpy.qos_overriding_options import QoSOverridingOptions
    from rclpy.subscription_content_filter_options import ContentFilterOptions


class NodeEntities(NodeNames):
    """The part of `rclpy.node.Node` that makes and destroys what is on the node."""

    _context: Context
    _default_callback_group: CallbackGroup
    _clock: Clock

    def _set_up_entities(self) -> None:
        self._publishers: list[Publisher[Any]] = []
        self._subscriptions: list[Subscription[Any]] = []
        self._clients: list[Client[Any, Any]] = []
        self._services: list[Service[Any, Any]] = []
        self._timers: list[Timer] = []
        self._guards: list[GuardCondition] = []
        self._waitables: list[Waitable[Any]] = []
        self._hidden_timers: list[Timer] = []
        """Timers of action servers, which are none of the node's `timers`."""
        self._hidden_entities: list[Any] = []
        self._default_callback_group = MutuallyExclusiveCallbackGroup()
        self._rate_group = ReentrantCallbackGroup()
        self._scope = Scope()

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of everything that is made without naming one: its callbacks exclude each other."""
        return self._default_callback_group

    def _wake_executor(self) -> None:
        executor = self._scope.executor
        if executor is not None:
            executor.wake()

    def _add(self, entity: Any, entities: list[Any], group: CallbackGroup) -> None:
        group.add_entity(entity)
        entities.append(entity)
        entity._enter(self._scope)

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
        yield from self._waitables

    def _validate_qos_or_depth_parameter(self, qos_or_depth: QoSProfile | int) -> QoSProfile:
        if isinstance(qos_or_depth, QoSProfile):
            return qos_or_depth
        if isinstance(qos_or_depth, int):
            if qos_or_depth < 0:
                raise ValueError("history depth must be greater than or equal to zero")
            return QoSProfile(depth=qos_or_depth)
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos_or_depth)!r}")

    # making

    def add_waitable(self, waitable: Waitable[Any]) -> None:
        """Have the executor look after a waitable."""
        self._waitables.append(waitable)
        if isinstance(waitable, Waitable):
            waitable._enter(self._scope)
        self._wake_executor()

    def remove_waitable(self, waitable: Waitable[Any]) -> None:
        """Let go of a waitable; ValueError if it is not there."""
        self._waitables.remove(waitable)
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
        endpoint_handle = PublisherHandle(self.handle, msg_type, full, qos_profile.get_c_qos_profile(), resolved=True)
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
        neither one nor two arguments, RCLError for a content filter that does not fit.
        """
        qos_profile = self._validate_qos_or_depth_parameter(qos_profile)
        group = callback_group or self.default_callback_group
        full = self._full_topic_name(topic)
        if qos_overriding_options is not None:
            self._override_qos(Subscription, full, qos_profile, qos_overriding_options)
        check_is_valid_msg_type(msg_type)
        endpoint_handle = SubscriptionHandle(
            self.handle, msg_type, full, qos_profile.get_c_qos_profile(), content_filter_options, resolved=True
        )
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

        _declare_qos_parameters(kind, cast("Node", self), topic, qos_profile, options)

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
        handle = ClientHandle(self.handle, srv_type, full, qos_profile.get_c_qos_profile(), resolved=True)
        client: Client[Any, Any] = Client(self._context, handle, srv_type, srv_name, qos_profile, group)
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
        handle = ServiceHandle(self.handle, srv_type, full, qos_profile.get_c_qos_profile(), resolved=True)
        service: Service[Any, Any] = Service(handle, srv_type, srv_name, callback, group, qos_profile)
        self._add(service, self._services, group)
        return service

    def _service_name_for(self, kind: str, srv_type: Any, srv_name: Any, qos_profile: QoSProfile) -> str:
        if not isinstance(srv_name, str):
            raise TypeError(
                "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
                f"    1. rclpy._rclpy_pybind11.{kind}(arg0: rclpy::Node, arg1: object, arg2: str, arg3: object)\n\n"
                f"Invoked with: {self.handle!r}, {srv_type!r}, {srv_name!r}, "
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

    # destroying

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
