"""Service introspection: the events of a service or client on `<service>/_service_event`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.graph import Endpoint, RequestId
from day6_core.interfaces import copy_message, type_hash, type_name
from rclpy._rclpy_pybind11 import ServiceIntrospectionState

if TYPE_CHECKING:
    from rclpy._day6.handles import NodeHandle
    from rclpy.clock import Clock
    from rclpy.qos import QoSProfile

# service_msgs/msg/ServiceEventInfo
_REQUEST_SENT, _REQUEST_RECEIVED, _RESPONSE_SENT, _RESPONSE_RECEIVED = range(4)


class Introspection:
    """Publishes the events of one service or client."""

    def __init__(
        self,
        node: NodeHandle,
        endpoint: Endpoint,
        srv_type: Any,
        clock: Clock,
        qos: QoSProfile,
        state: ServiceIntrospectionState,
    ) -> None:
        self._event_type = srv_type.Event
        self._clock = clock
        self._gid = endpoint.gid
        self.contents = state is ServiceIntrospectionState.CONTENTS
        self._publisher = node.node.create_publisher(
            f"{endpoint.topic}/_service_event",
            type_name(self._event_type),
            type_hash(self._event_type),
            qos.get_c_qos_profile(),
            copy_message,
        )

    @classmethod
    def configured(
        cls,
        current: Introspection | None,
        node: NodeHandle,
        endpoint: Endpoint,
        srv_type: Any,
        clock: Clock,
        qos: QoSProfile,
        state: ServiceIntrospectionState,
    ) -> Introspection | None:
        """Return the introspection for a new state, which replaces the current one (None for OFF)."""
        if current is not None:
            current.destroy()
        return None if state is ServiceIntrospectionState.OFF else cls(node, endpoint, srv_type, clock, qos, state)

    def _publish(self, kind: int, gid: bytes, number: int, request: Any = None, response: Any = None) -> None:
        event = self._event_type()
        event.info.event_type = kind
        event.info.stamp = self._clock.now().to_msg()
        event.info.client_gid = list(gid)
        event.info.sequence_number = number
        if self.contents:
            event.request = [] if request is None else [request]
            event.response = [] if response is None else [response]
        self._publisher.publish(event)

    def request_sent(self, request: Any, number: int) -> None:
        """Publish that the client has sent a request."""
        self._publish(_REQUEST_SENT, self._gid, number, request=request)

    def request_received(self, request: Any, request_id: RequestId) -> None:
        """Publish that the service has received a request."""
        self._publish(_REQUEST_RECEIVED, request_id.client_gid, request_id.sequence_number, request=request)

    def response_sent(self, response: Any, request_id: RequestId) -> None:
        """Publish that the service has sent a response."""
        self._publish(_RESPONSE_SENT, request_id.client_gid, request_id.sequence_number, response=response)

    def response_received(self, response: Any, number: int) -> None:
        """Publish that the client has received a response."""
        self._publish(_RESPONSE_RECEIVED, self._gid, number, response=response)

    def destroy(self) -> None:
        """Destroy the publisher of the events."""
        self._publisher.destroy()
