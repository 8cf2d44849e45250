"""The handles of publishers, subscriptions, services and clients: the classes `rclpy._rclpy_pybind11` has for them.

`Node.create_publisher` and the like make them with a full, remapped name; when a program makes one itself (for a waitable,
say), the handle resolves the name.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.graph import RequestId
from rclpy._day6.handles import EndpointHandle, NodeHandle
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import RCLError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from day6_core.graph import QoS
    from rclpy.duration import Duration
    from rclpy.subscription_content_filter_options import ContentFilterOptions


_BAD_FILTER = "create_contentfilteredtopic() failed to create contentfilteredtopic"


_LARGEST_WHOLE = 65_324
"""Bytes of CDR that Fast DDS sends to another process in one packet; of more it makes fragments (measured, rclpy 9.1.2)."""


class ServiceInfo(NamedTuple):
    """When a request or response was sent and received (epoch ns), and its request id (rmw_service_info_t)."""

    source_timestamp: int
    received_timestamp: int
    request_id: RequestId


def _type_of(interface: type[Any]) -> tuple[str, str]:
    from day6_core.interfaces import type_hash, type_name

    return type_name(interface), type_hash(interface)


def _refuse_unknown(qos: QoS, kind: str, line: int) -> None:
    """Raise RCLError if a policy is UNKNOWN, which is valid only for discovered endpoints (rmw_fastrtps, qos.cpp)."""
    for name, place in (("history", 68), ("durability", 82), ("reliability", 96), ("Liveliness", 134)):
        if getattr(qos, name.lower()).name == "UNKNOWN":
            raise RCLError(
                f"Failed to create {kind}: Unknown QoS {name} policy, at /project/src/qos.cpp:{place}, "
                f"at /project/src/rcl/{kind}.c:{line}"
            )


class PublisherHandle(EndpointHandle):
    """A publisher. Raises InvalidHandle for a destroyed node, RCLError when the context is shut down."""

    def __init__(
        self, node: NodeHandle, msg_type: Any, topic: str, qos_profile: QoS, *, resolved: bool = False
    ) -> None:
        from day6_core.interfaces import copy_message

        node.check_valid("Failed to create publisher")
        full = topic if resolved else node.resolve(topic, is_service=False)
        type_name, type_hash = _type_of(msg_type)
        node.claim_topic(
            full, type_name, "publisher", "/project/src/publisher.cpp:145, at /project/src/rcl/publisher.c:118"
        )
        _refuse_unknown(qos_profile, "publisher", 118)
        endpoint = node.node.create_publisher(full, type_name, type_hash, qos_profile, copy_message)
        super().__init__(node, endpoint, is_topic=True)
        self._msg_type = msg_type

    def publish(self, msg: Any) -> None:
        """Send a message."""
        self.check_publisher("Failed to publish")
        self._endpoint.publish(msg)

    def publish_raw(self, msg: bytes) -> None:
        """Send a message given as CDR bytes."""
        from rclpy.serialization import deserialize_message

        self.publish(deserialize_message(msg, self._msg_type))

    def get_subscription_count(self) -> int:
        """Return how many subscriptions match."""
        self.check_publisher("failed to get subscription count")
        count: int = self._endpoint.subscription_count
        return count

    def wait_for_all_acked(self, timeout: Duration | Any) -> bool:
        """Return at once: subscriptions have every message as soon as `publish` returns."""
        self.check_publisher("Failed to wait for all acknowledged")
        return True


class SubscriptionHandle(EndpointHandle):
    """A subscription. Raises as PublisherHandle."""

    def __init__(
        self,
        node: NodeHandle,
        msg_type: Any,
        topic: str,
        qos_profile: QoS,
        content_filter_options: ContentFilterOptions | None = None,
        *,
        resolved: bool = False,
    ) -> None:
        node.check_valid("Failed to create subscription")
        full = topic if resolved else node.resolve(topic, is_service=False)
        type_name, type_hash = _type_of(msg_type)
        node.claim_topic(
            full, type_name, "subscription", "/project/src/subscription.cpp:526, at /project/src/rcl/subscription.c:116"
        )
        _refuse_unknown(qos_profile, "subscription", 116)
        endpoint = node.node.create_subscription(full, type_name, type_hash, qos_profile)
        super().__init__(node, endpoint, is_topic=True)
        self._msg_type = msg_type
        self._filter: ContentFilterOptions | None = None
        if content_filter_options is not None:
            try:
                self._use_filter(content_filter_options)
            except ValueError:
                self.destroy_when_not_in_use()
                raise RCLError(
                    f"Failed to create subscription: {_BAD_FILTER}, at /project/src/subscription.cpp:630, "
                    "at /project/src/rcl/subscription.c:116"
                ) from None

    def take_message(self, pymsg_type: Any, raw: bool) -> tuple[Any, dict[str, Any]] | None:
        """Take the oldest message and its MessageInfo, None if there is none; with `raw` as CDR bytes."""
        sample = self._endpoint.take()
        if sample is None:
            return None
        message = sample[0]
        if raw:
            message = self.raw(sample)
        elif isinstance(message, bytes):
            from rclpy.serialization import deserialize_message

            message = deserialize_message(message, self._msg_type)
        return message, self.info(sample)

    def raw(self, sample: Any) -> bytes:
        """Return the bytes of a sample as Fast DDS delivers them: what came in one packet fills its last four bytes."""
        message, publisher, node = sample[0], sample[3], self._endpoint.node
        if not isinstance(message, bytes):
            from rclpy.serialization import serialize_message

            message = serialize_message(message)
        if publisher.origin is node.origin and publisher.node.program is node.program:
            return message
        return message + bytes(-len(message) % 4) if len(message) <= _LARGEST_WHOLE else message

    def set_on_new_message_callback(self, callback: Callable[[int], object]) -> None:
        """Call `callback(number)` for messages that arrive, on the thread that receives them, and for those that wait."""
        self._call_on_ready(callback)

    def clear_on_new_message_callback(self) -> None:
        """Stop calling it."""
        self._call_on_ready(None)

    def take_at_once(self, callback: Callable[[Any], object]) -> None:
        """Hand every message to `callback` on the thread that receives it, as C++ programs can have it; no executor does.

        As with rcl_subscription_set_on_new_message_callback it must be quick and raise nothing. It is given CDR bytes by a `raw`
        subscription for messages of other processes, and a message else.
        """
        self._endpoint.on_message = callback

    def info(self, sample: Any) -> dict[str, Any]:
        """Return the MessageInfo of a sample. Fast DDS does not number received messages."""
        info = self._endpoint.message_info(sample)
        return {
            "source_timestamp": info.source_timestamp,
            "received_timestamp": info.received_timestamp,
            "publication_sequence_number": info.publication_sequence_number,
            "reception_sequence_number": None,
            "publisher_gid": {"implementation_identifier": "rmw_fastrtps_cpp", "data": info.publisher_gid},
        }

    def get_publisher_count(self) -> int:
        """Return how many publishers match."""
        self.check()
        count: int = self._endpoint.publisher_count
        return count

    def is_cft_supported(self) -> bool:
        """Return True: every subscription can filter by content."""
        self.check()
        return True

    def is_cft_enabled(self) -> bool:
        """Return whether a content filter is active."""
        self.check()
        return self._filter is not None

    def set_content_filter(self, filter_expression: str, expression_parameters: Sequence[str]) -> None:
        """Receive only messages for which an SQL-like expression is true; an empty one removes the filter.

        RCLError for an expression that cannot be parsed or does not fit the messages.
        """
        self.check()
        try:
            if self._filter is None and not filter_expression:
                raise ValueError(
                    "current subscriber has no content filter topic, at /project/src/rmw_subscription.cpp:119"
                )
            self._use_filter((filter_expression, list(expression_parameters)))
        except ValueError as error:
            reason = str(error) if not filter_expression else f"{_BAD_FILTER}, at /project/src/rmw_subscription.cpp:160"
            raise RCLError(
                f"Failed to set cft expression parameters: {reason}, at /project/src/rcl/subscription.c:502"
            ) from None

    def _use_filter(self, options: tuple[str, list[str]]) -> None:
        """Filter from now on, or stop filtering if the expression is empty; ValueError for one that does not fit."""
        from rclpy._day6.content_filter import FilterError, compile_filter
        from rclpy.subscription_content_filter_options import ContentFilterOptions

        expression, parameters = options
        if not expression:
            self._filter = None
            self._endpoint.filter_by(None)
            return
        try:
            self._endpoint.filter_by(compile_filter(expression, parameters, self._msg_type))
        except FilterError as error:
            # Fast DDS gives the reason only on the console.
            print(f"DDSSQLFILTER Error: {error}", file=sys.stderr)
            raise
        self._filter = ContentFilterOptions(expression, list(parameters))

    def get_content_filter(self) -> ContentFilterOptions:
        """Return expression and parameters of the filter; RCLError if there is none."""
        self.check()
        if self._filter is None:
            raise RCLError(
                "Failed to get cft expression parameters: this subscriber has not created a ContentFilteredTopic, "
                "at /project/src/rmw_subscription.cpp:229"
            )
        return self._filter


class ServiceHandle(EndpointHandle):
    """A service server. Raises as PublisherHandle."""

    def __init__(
        self, node: NodeHandle, srv_type: Any, service_name: str, qos_profile: QoS, *, resolved: bool = False
    ) -> None:
        from day6_core.interfaces import copy_message

        node.check_valid("failed to create service")
        full = service_name if resolved else node.resolve(service_name, is_service=True)
        endpoint = node.node.create_service(full, *_type_of(srv_type), qos_profile, copy_message)
        super().__init__(node, endpoint, is_topic=False)

    def service_take_request(self, pyrequest_type: Any) -> tuple[Any, ServiceInfo | None]:
        """Take the oldest request and its ServiceInfo; (None, None) if there is none."""
        self.check()
        taken = self._endpoint.take()
        if taken is None:
            return None, None
        request, request_id = taken
        now = self._endpoint.node.graph.now_ns()
        return request, ServiceInfo(now, now, request_id)

    def set_on_new_request_callback(self, callback: Callable[[int], object]) -> None:
        """Call `callback(number)` for requests that arrive, on the thread that receives them, and for those that wait."""
        self._call_on_ready(callback)

    def clear_on_new_request_callback(self) -> None:
        """Stop calling it."""
        self._call_on_ready(None)

    def service_send_response(self, pyresponse: Any, header: RequestId) -> None:
        """Send the response to a request."""
        self.check()
        self._endpoint.send_response(header, pyresponse)


class ClientHandle(EndpointHandle):
    """A service client. Raises as PublisherHandle."""

    def __init__(
        self, node: NodeHandle, srv_type: Any, service_name: str, qos_profile: QoS, *, resolved: bool = False
    ) -> None:
        from day6_core.interfaces import copy_message

        node.check_valid("failed to create client")
        full = service_name if resolved else node.resolve(service_name, is_service=True)
        endpoint = node.node.create_client(full, *_type_of(srv_type), qos_profile, copy_message)
        super().__init__(node, endpoint, is_topic=False)

    def send_request(self, pyrequest: Any) -> int:
        """Send a request; returns its sequence number."""
        self.check()
        number: int = self._endpoint.send_request(pyrequest)
        return number

    def take_response(self, pyresponse_type: Any) -> tuple[ServiceInfo | None, Any]:
        """Take the oldest response and its ServiceInfo; (None, None) if there is none."""
        self.check()
        taken = self._endpoint.take()
        if taken is None:
            return None, None
        response, number = taken
        now = self._endpoint.node.graph.now_ns()
        return ServiceInfo(now, now, RequestId(self._endpoint.gid, number)), response

    def set_on_new_response_callback(self, callback: Callable[[int], object]) -> None:
        """Call `callback(number)` for responses that arrive, on the thread that receives them, and for those that wait."""
        self._call_on_ready(callback)

    def clear_on_new_response_callback(self) -> None:
        """Stop calling it."""
        self._call_on_ready(None)

    def service_server_is_available(self) -> bool:
        """Return whether the service has a server."""
        self.check()
        ready: bool = self._endpoint.service_is_ready()
        return ready


withdraw(__name__)
