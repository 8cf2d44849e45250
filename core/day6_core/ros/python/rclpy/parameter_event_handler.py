"""Callbacks for changes of parameters, of this node or others."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain
from threading import Lock
from typing import TYPE_CHECKING

from rclpy._day6.incidental import also
from rclpy.qos import QoSProfile, qos_profile_parameter_events

if TYPE_CHECKING:
    from rcl_interfaces.msg import Parameter, ParameterEvent

    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import SubscriptionEventCallbacks
    from rclpy.node import Node
    from rclpy.qos_overriding_options import QoSOverridingOptions

__getattr__ = also(
    __name__, "CallbackGroup Node ParameterEvent ParameterMsg QoSOverridingOptions SubscriptionEventCallbacks"
)


_MISSING = "Callback doesn't exist"


class ParameterCallbackHandle:
    """A callback for one parameter of one node."""

    def __init__(self, parameter_name: str, node_name: str, callback: Callable[[Parameter], object]) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback
        self.mutex = Lock()


class ParameterEventCallbackHandle:
    """A callback for all parameter events."""

    def __init__(self, callback: Callable[[ParameterEvent], object]) -> None:
        self.callback = callback
        self.mutex = Lock()


class ParameterEventHandler:
    """Subscribes to /parameter_events and calls the added callbacks, the last added first."""

    class Callbacks:
        """The added callbacks."""

        def __init__(self) -> None:
            self.parameter_callbacks: dict[tuple[str, str], list[ParameterCallbackHandle]] = {}
            self.event_callbacks: list[ParameterEventCallbackHandle] = []
            self.mutex = Lock()

        def event_callback(self, event: ParameterEvent) -> None:
            """Call every callback that an event concerns."""
            with self.mutex:
                for (name, node), handles in self.parameter_callbacks.items():
                    parameter = ParameterEventHandler.get_parameter_from_event(event, name, node)
                    if parameter is not None:
                        for handle in handles:
                            with handle.mutex:
                                handle.callback(parameter)
                for each in self.event_callbacks:
                    with each.mutex:
                        each.callback(event)

        def add_parameter_callback(
            self, parameter_name: str, node_name: str, callback: Callable[[Parameter], object]
        ) -> ParameterCallbackHandle:
            """Add a callback for one parameter."""
            handle = ParameterCallbackHandle(parameter_name, node_name, callback)
            with self.mutex:
                self.parameter_callbacks.setdefault((parameter_name, node_name), []).insert(0, handle)
            return handle

        def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
            """Remove a callback.

            Raises:
                RuntimeError: if it was not added.
            """
            key = (handle.parameter_name, handle.node_name)
            with self.mutex:
                handles = self.parameter_callbacks.get(key, [])
                if handle not in handles:
                    raise RuntimeError(_MISSING)
                handles.remove(handle)
                if not handles:
                    del self.parameter_callbacks[key]

        def add_parameter_event_callback(
            self, callback: Callable[[ParameterEvent], object]
        ) -> ParameterEventCallbackHandle:
            """Add a callback for all events."""
            handle = ParameterEventCallbackHandle(callback)
            with self.mutex:
                self.event_callbacks.insert(0, handle)
            return handle

        def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
            """Remove a callback.

            Raises:
                RuntimeError: if it was not added.
            """
            with self.mutex:
                if handle not in self.event_callbacks:
                    raise RuntimeError(_MISSING)
                self.event_callbacks.remove(handle)

    def __init__(
        self,
        node: Node,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> None:
        from rcl_interfaces.msg import ParameterEvent

        self.node = node
        self.qos_profile = qos_profile
        self._callbacks = ParameterEventHandler.Callbacks()
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            self._callbacks.event_callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )

    def destroy(self) -> None:
        """Destroy the subscription."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    @staticmethod
    def get_parameter_from_event(event: ParameterEvent, parameter_name: str, node_name: str) -> Parameter | None:
        """Return the message of a new or changed parameter, None if the event has none with that name and node."""
        if event.node == node_name:
            for parameter in chain(event.new_parameters, event.changed_parameters):
                if parameter.name == parameter_name:
                    return parameter
        return None

    @staticmethod
    def get_parameters_from_event(event: ParameterEvent) -> Iterator[Parameter]:
        """Return the messages of all new and changed parameters."""
        yield from chain(event.new_parameters, event.changed_parameters)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[Parameter], object]
    ) -> ParameterCallbackHandle:
        """Call `callback(parameter message)` when that parameter of that node changes."""
        return self._callbacks.add_parameter_callback(parameter_name, self._resolve_path(node_name), callback)

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Remove a callback.

        Raises:
            RuntimeError: if it was not added.
        """
        self._callbacks.remove_parameter_callback(handle)

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], object]
    ) -> ParameterEventCallbackHandle:
        """Call `callback(event)` for every parameter event."""
        return self._callbacks.add_parameter_event_callback(callback)

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Remove a callback.

        Raises:
            RuntimeError: if it was not added.
        """
        self._callbacks.remove_parameter_event_callback(handle)

    def _resolve_path(self, node_path: str | None = None) -> str:
        """Return the full name of a node named relative to this node's namespace; '' is this node."""
        if not node_path:
            return self.node.get_fully_qualified_name()
        if node_path.startswith("/"):
            return node_path
        return f"{self.node.get_namespace().rstrip('/')}/{node_path}"
