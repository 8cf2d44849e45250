"""The base of publishers, subscriptions, services and clients: their handle, the logger of their node, their destruction."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeVar

from rclpy._day6.entity import Entity

if TYPE_CHECKING:
    from rclpy._day6.endpoint_events import EndpointEvents
    from rclpy._day6.handles import EndpointHandle
    from rclpy._day6.introspection import Introspection
    from rclpy.clock import Clock
    from rclpy.event_handler import EventHandler
    from rclpy.qos import QoSProfile
    from rclpy.service_introspection import ServiceIntrospectionState

_Endpoint = TypeVar("_Endpoint", bound="NodeEndpoint")


class NodeEndpoint:
    """An endpoint of a node; usable with `with`, which destroys it."""

    _handle: EndpointHandle

    @property
    def handle(self) -> EndpointHandle:
        """The handle."""
        return self._handle

    @property
    def logger_name(self) -> str:
        """The name of the logger of its node."""
        self._handle.check()
        return self._handle.get_logger_name()

    def destroy(self) -> None:
        """Take it out of the graph; prefer the node's `destroy_…`."""
        self._handle.destroy_when_not_in_use()

    def __enter__(self: _Endpoint) -> _Endpoint:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.destroy()


class TopicEndpoint(NodeEndpoint):
    """A publisher or subscription."""

    _events: EndpointEvents

    @property
    def topic_name(self) -> str:
        """The full name of the topic."""
        self._handle.check()
        return self._handle.get_topic_name()

    @property
    def event_handlers(self) -> list[EventHandler]:
        """The handlers of the endpoint's events."""
        return self._events.handlers

    @event_handlers.setter
    def event_handlers(self, handlers: list[EventHandler]) -> None:
        self._events.handlers = handlers

    def destroy(self) -> None:
        """Take it out of the graph; prefer the node's `destroy_…`."""
        self._events.destroy()
        self._handle.destroy_when_not_in_use()


class ServiceEndpoint(NodeEndpoint, Entity):
    """One side of a service."""

    srv_type: Any
    _introspection: Introspection | None = None

    @property
    def service_name(self) -> str:
        """The full name of the service."""
        self._handle.check()
        return self._handle.get_topic_name()

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish requests and responses on `<service>/_service_event`: not at all, only metadata, or with contents."""
        from rclpy._day6.introspection import Introspection

        self._handle.check()
        self._introspection = Introspection.configured(
            self._introspection,
            self._handle._node,
            self._handle._endpoint,
            self.srv_type,
            clock,
            service_event_qos_profile,
            introspection_state,
        )

    def destroy(self) -> None:
        if self._introspection is not None:
            self._introspection.destroy()
        super().destroy()
