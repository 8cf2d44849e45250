"""The entities of a node: publishers, subscriptions, services, clients, timers, guard conditions, waitables."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from rclpy._day6.endpoint_handles import ClientHandle, PublisherHandle, ServiceHandle, SubscriptionHandle
from rclpy._day6.node_names import full_service_name, full_topic_name
from rclpy._day6.own_services import HASHES, copy_any
from rclpy._rclpy_pybind11 import InvalidHandle
from rclpy.client import Client
from rclpy.constants import S_TO_NS
from rclpy.guard_condition import GuardCondition
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.timer import Timer
from rclpy.type_support import MsgT, check_is_valid_msg_type, check_is_valid_srv_type
from rclpy.waitable import Waitable

if TYPE_CHECKING:
    from rclpy._day6.entity import Entity
    from rclpy._day6.handles import NodeHandle
    from rclpy._day6.parameter_store import ParameterStore
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock
    from rclpy.context import Context
    from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
    from rclpy.guard_condition import GuardConditionCallbackType
    from rclpy.qos_overriding_options import QoSOverridingOptions
    from rclpy.service import ServiceCallback
    from rclpy.subscription import MessageCallback
    from rclpy.subscription_content_filter_options import ContentFilterOptions
    from rclpy.timer import TimerCallbackType


class Destroyed(Protocol):
    """Anything a node can destroy."""

    def destroy(self) -> None:
        """Destroy it; InvalidHandle if it is already destroyed."""


_Made = TypeVar("_Made", bound=Destroyed)


def profile_of(qos_or_depth: QoSProfile | int) -> QoSProfile:
    """Return the given profile, or the default one with the given depth. TypeError and ValueError for anything else."""
    if isinstance(qos_or_depth, QoSProfile):
        return qos_or_depth
    if isinstance(qos_or_depth, int):
        if qos_or_depth < 0:
            raise ValueError("history depth must be greater than or equal to zero")
        return QoSProfile(depth=qos_or_depth)
    raise TypeError(f"Expected QoSProfile or int, but received {type(qos_or_depth)!r}")


class NodeEntities:
    """Makes and destroys the entities of a node, which its executor runs.

    QoS overrides are parameters, so they are declared in `parameters`.
    """

    def __init__(self, handle: NodeHandle, parameters: ParameterStore) -> None:
        self.publishers: list[Publisher[Any]] = []
        self.subscriptions: list[Subscription[Any]] = []
        self.clients: list[Client[Any, Any]] = []
        self.services: list[Service[Any, Any]] = []
        self.timers: list[Timer] = []
        self.guards: list[GuardCondition] = []
        self.waitables: list[Waitable[Any]] = []
        self._hidden: list[Publisher[Any]] = []
        self._handle = handle
        self._scope = handle.scope
        self._parameters = parameters

    # -- keeping -------------------------------------------------------------------------------------------------------

    def _add(self, entity: Entity, group: CallbackGroup) -> None:
        group.add_entity(entity)
        entity._enter(self._scope)

    def add_publisher(self, publisher: Publisher[Any]) -> None:
        """Add a publisher that was made for this node."""
        self.publishers.append(publisher)
        publisher._events.enter(self._scope)

    def hide(self, publisher: Publisher[Any]) -> None:
        """Keep a publisher of the node, but not as one of its `publishers`: in real ROS it belongs to another object."""
        self.publishers.remove(publisher)
        self._hidden.append(publisher)

    def add_waitable(self, waitable: Waitable[Any]) -> None:
        """Let the executor run a waitable."""
        self.waitables.append(waitable)
        if isinstance(waitable, Waitable):
            waitable._enter(self._scope)
        self.wake_executor()

    def remove_waitable(self, waitable: Waitable[Any]) -> None:
        """Remove a waitable; ValueError if the node doesn't have it."""
        self.waitables.remove(waitable)
        if isinstance(waitable, Waitable):
            waitable._leave()
        self.wake_executor()

    def wake_executor(self) -> None:
        """Let the executor check the node's entities again."""
        executor = self._scope.executor
        if executor is not None:
            executor.wake()

    # -- making --------------------------------------------------------------------------------------------------------

    def create_publisher(
        self,
        msg_type: type[MsgT],
        topic: str,
        qos_profile: QoSProfile | int,
        group: CallbackGroup,
        event_callbacks: PublisherEventCallbacks | None,
        qos_overriding_options: QoSOverridingOptions | None,
        publisher_class: type[Publisher[MsgT]],
    ) -> Publisher[MsgT]:
        """See `Node.create_publisher`."""
        qos_profile = profile_of(qos_profile)
        full = full_topic_name(self._handle, topic)
        if qos_overriding_options is not None:
            self._override_qos(Publisher, full, qos_profile, qos_overriding_options)
        check_is_valid_msg_type(msg_type)
        handle = PublisherHandle(self._handle, msg_type, full, qos_profile.get_c_qos_profile(), resolved=True)
        try:
            publisher = publisher_class(handle, msg_type, topic, qos_profile, event_callbacks, group)
        except Exception:
            handle.destroy_when_not_in_use()
            raise
        self.add_publisher(publisher)
        return publisher

    def create_subscription(
        self,
        msg_type: type[MsgT],
        topic: str,
        callback: MessageCallback[MsgT],
        qos_profile: QoSProfile | int,
        group: CallbackGroup,
        event_callbacks: SubscriptionEventCallbacks | None,
        qos_overriding_options: QoSOverridingOptions | None,
        raw: bool,
        content_filter_options: ContentFilterOptions | None,
    ) -> Subscription[MsgT]:
        """See `Node.create_subscription`."""
        qos_profile = profile_of(qos_profile)
        full = full_topic_name(self._handle, topic)
        if qos_overriding_options is not None:
            self._override_qos(Subscription, full, qos_profile, qos_overriding_options)
        check_is_valid_msg_type(msg_type)
        handle = SubscriptionHandle(
            self._handle, msg_type, full, qos_profile.get_c_qos_profile(), content_filter_options, resolved=True
        )
        try:
            subscription = Subscription(handle, msg_type, topic, callback, group, qos_profile, raw, event_callbacks)
        except Exception:
            handle.destroy_when_not_in_use()
            raise
        self.subscriptions.append(subscription)
        self._add(subscription, group)
        return subscription

    def _override_qos(
        self, kind: type[Any], topic: str, qos_profile: QoSProfile, options: QoSOverridingOptions
    ) -> None:
        from rclpy.qos_overriding_options import _declare_qos_in

        _declare_qos_in(kind, self._parameters, topic, qos_profile, options)

    def create_client(
        self, context: Context, srv_type: type[Any], srv_name: str, qos_profile: QoSProfile, group: CallbackGroup
    ) -> Client[Any, Any]:
        """See `Node.create_client`."""
        check_is_valid_srv_type(srv_type)
        full = self._service_name("Client", srv_type, srv_name, qos_profile)
        handle = ClientHandle(self._handle, srv_type, full, qos_profile.get_c_qos_profile(), resolved=True)
        client: Client[Any, Any] = Client(context, handle, srv_type, srv_name, qos_profile, group)
        self.clients.append(client)
        self._add(client, group)
        return client

    def create_service(
        self,
        srv_type: type[Any],
        srv_name: str,
        callback: ServiceCallback[Any, Any],
        qos_profile: QoSProfile,
        group: CallbackGroup,
    ) -> Service[Any, Any]:
        """See `Node.create_service`."""
        check_is_valid_srv_type(srv_type)
        full = self._service_name("Service", srv_type, srv_name, qos_profile)
        handle = ServiceHandle(self._handle, srv_type, full, qos_profile.get_c_qos_profile(), resolved=True)
        return self._add_service(Service(handle, srv_type, srv_name, callback, group, qos_profile), group)

    def create_own_service(
        self, type_name: str, name: str, callback: ServiceCallback[Any, Any], qos: QoSProfile, group: CallbackGroup
    ) -> None:
        """Add one of the services every node has; its class is made at the first request."""
        node = self._handle
        srv_name = f"{node.name}/{name}"
        full = full_service_name(node, srv_name)
        endpoint = node.node.create_service(full, type_name, HASHES[type_name], qos.get_c_qos_profile(), copy_any)
        handle = ServiceHandle._of(node, endpoint, is_topic=False)
        self._add_service(Service(handle, type_name, srv_name, callback, group, qos), group)

    def _add_service(self, service: Service[Any, Any], group: CallbackGroup) -> Service[Any, Any]:
        self.services.append(service)
        self._add(service, group)
        return service

    def _service_name(self, kind: str, srv_type: object, srv_name: object, qos_profile: QoSProfile) -> str:
        if not isinstance(srv_name, str):
            raise TypeError(
                "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
                f"    1. rclpy._rclpy_pybind11.{kind}(arg0: rclpy::Node, arg1: object, arg2: str, arg3: object)\n\n"
                f"Invoked with: {self._handle!r}, {srv_type!r}, {srv_name!r}, "
                f"<rclpy._rclpy_pybind11.rmw_qos_profile_t object at {id(qos_profile):#x}>"
            )
        return full_service_name(self._handle, srv_name)

    def create_timer(
        self,
        context: Context,
        timer_period_sec: float,
        callback: TimerCallbackType | None,
        group: CallbackGroup,
        clock: Clock,
        autostart: bool,
    ) -> Timer:
        """See `Node.create_timer`."""
        period = int(float(timer_period_sec) * S_TO_NS)
        timer = Timer(callback, group, period, clock, context=context, autostart=autostart)
        self.timers.append(timer)
        self._add(timer, group)
        timer._schedule()
        return timer

    def create_guard_condition(
        self, context: Context, callback: GuardConditionCallbackType, group: CallbackGroup
    ) -> GuardCondition:
        """See `Node.create_guard_condition`."""
        guard = GuardCondition(callback, group, context=context)
        self.guards.append(guard)
        self._add(guard, group)
        return guard

    # -- destroying ----------------------------------------------------------------------------------------------------

    def destroy(self, entity: _Made, entities: list[_Made]) -> bool:
        """Destroy one of these entities; False if it is not one of the node's or is already destroyed."""
        if entity not in entities:
            return False
        entities.remove(entity)
        try:
            entity.destroy()
        except InvalidHandle:
            return False
        self.wake_executor()
        return True

    def destroy_all(self) -> None:
        """Destroy everything except the waitables, which their owners destroy."""
        made: tuple[list[Any], ...] = (
            self.publishers,
            self.subscriptions,
            self.clients,
            self.services,
            self.timers,
            self.guards,
            self._hidden,
        )
        for entities in made:
            while entities:
                self.destroy(entities[0], entities)
