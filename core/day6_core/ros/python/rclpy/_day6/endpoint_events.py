"""The events of a publisher or subscription, created only when they are needed.

Every endpoint has default handlers that log incompatible QoS; they hardly ever run, so they are made when an event occurs.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.graph.endpoints import Endpoint, EventKind

if TYPE_CHECKING:
    from rclpy._day6.entity import Scope
    from rclpy._day6.handles import EndpointHandle
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import EventHandler, PublisherEventCallbacks, SubscriptionEventCallbacks

_TROUBLE = (EventKind.INCOMPATIBLE_QOS, EventKind.INCOMPATIBLE_TYPE)


class EndpointEvents:
    """The event handlers of one endpoint. An executor runs them, but not the publisher itself."""

    __slots__ = ("_callbacks", "_default_class", "_group", "_handle", "_handlers", "_scope", "_topic")

    def __init__(
        self,
        handle: EndpointHandle,
        callbacks: PublisherEventCallbacks | SubscriptionEventCallbacks | None,
        group: CallbackGroup,
        topic: str,
        default_class: str,
    ) -> None:
        self._handle = handle
        self._callbacks = callbacks
        self._group = group
        self._topic = topic
        self._default_class = default_class
        self._handlers: list[EventHandler] | None = None
        self._scope: Scope | None = None
        if callbacks is not None:
            self._handlers = callbacks.create_event_handlers(group, handle, topic)
        handle._endpoint.on_event = self._on_event

    @property
    def handlers(self) -> list[EventHandler]:
        """The handlers; the first access makes the default ones."""
        return self._made()

    @handlers.setter
    def handlers(self, handlers: list[EventHandler]) -> None:
        self._handlers = handlers

    def _made(self) -> list[EventHandler]:
        if self._handlers is None:
            from rclpy import event_handler

            callbacks = getattr(event_handler, self._default_class)()
            handlers: list[EventHandler] = callbacks.create_event_handlers(self._group, self._handle, self._topic)
            self._handlers = handlers
            if self._scope is not None:
                for handler in handlers:
                    handler._enter(self._scope)
        return self._handlers

    def _on_event(self, endpoint: Endpoint, kind: EventKind) -> None:
        if self._handlers is None and kind not in _TROUBLE:
            return
        for handler in self._made():
            if handler._event_kind is kind:
                handler._notify()

    def enter(self, scope: Scope) -> None:
        """Join the node of `scope`, whose executor then runs the handlers."""
        self._scope = scope
        for handler in self._handlers or ():
            handler._enter(scope)
        events = self._handle._endpoint.events
        if any(events[kind].total_count for kind in _TROUBLE):
            self._made()

    def destroy(self) -> None:
        """Destroy the handlers that were made."""
        self._handle._endpoint.on_event = None
        for handler in self._handlers or ():
            handler.destroy()
