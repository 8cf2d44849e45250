"""The events of publishers and subscriptions, made ready only when they are needed.

Every endpoint has default handlers that log incompatible QoS; nearly none ever runs, so they are made when something happens.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_tui.core.graph.endpoints import Endpoint, EventKind
from rclpy._entity import Scope
from rclpy._node_endpoint import NodeEndpoint

if TYPE_CHECKING:
    from rclpy._handles import EndpointHandle
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import EventHandler, PublisherEventCallbacks, SubscriptionEventCallbacks

_TROUBLE = (EventKind.INCOMPATIBLE_QOS, EventKind.INCOMPATIBLE_TYPE)


class EventSource(NodeEndpoint):
    """What has event handlers: base of Publisher and Subscription."""

    def _set_up_events(
        self,
        handle: EndpointHandle,
        callbacks: PublisherEventCallbacks | SubscriptionEventCallbacks | None,
        group: CallbackGroup,
        topic: str,
        default_class: Any,
    ) -> None:
        self._handle = handle
        self._event_callbacks = callbacks
        self._event_group = group
        self._event_topic = topic
        self._default_callbacks = default_class
        self._made_handlers: list[EventHandler] | None = None
        if callbacks is not None:
            self._make_handlers()
        handle._endpoint.on_event = self._on_event

    def _make_handlers(self) -> list[EventHandler]:
        if self._made_handlers is None:
            callbacks = self._event_callbacks
            if callbacks is None:
                from rclpy import event_handler

                callbacks = getattr(event_handler, self._default_callbacks)()
            handlers = callbacks.create_event_handlers(self._event_group, self._handle, self._event_topic)
            self._made_handlers = handlers
            if self._scope is not None:
                for handler in handlers:
                    handler._enter(self._scope)
        return self._made_handlers

    @property
    def event_handlers(self) -> list[EventHandler]:
        """The handlers of the endpoint's events."""
        return self._make_handlers()

    @event_handlers.setter
    def event_handlers(self, handlers: list[EventHandler]) -> None:
        self._made_handlers = handlers

    def _on_event(self, endpoint: Endpoint, kind: EventKind) -> None:
        if self._made_handlers is None and kind not in _TROUBLE:
            return
        for handler in self._make_handlers():
            if handler._event_kind is kind:
                handler._notify()

    def _enter(self, scope: Scope) -> None:
        super()._enter(scope)
        if self._made_handlers is not None:
            for handler in self._made_handlers:
                handler._enter(scope)
        events = self._handle._endpoint.events
        if any(events[kind].total_count for kind in _TROUBLE):
            self._make_handlers()

    def _destroy_events(self) -> None:
        self._handle._endpoint.on_event = None
        for handler in self._made_handlers or ():
            handler.destroy()
