"""Publishers."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Generic, TypeVar

from rclpy._day6.endpoint_events import EndpointEvents
from rclpy._day6.incidental import also
from rclpy._day6.node_endpoint import TopicEndpoint
from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from rclpy.type_support import MsgT

if TYPE_CHECKING:
    from rclpy._day6.handles import EndpointHandle
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import PublisherEventCallbacks

__getattr__ = also(__name__, "CallbackGroup EventHandler PublisherEventCallbacks")


MsgType = TypeVar("MsgType")


class Publisher(TopicEndpoint, Generic[MsgT]):
    """Sends messages to a topic; made by `Node.create_publisher`."""

    def __init__(
        self,
        publisher_impl: EndpointHandle,
        msg_type: type[MsgT],
        topic: str,
        qos_profile: QoSProfile,
        event_callbacks: PublisherEventCallbacks | None,
        callback_group: CallbackGroup,
    ) -> None:
        self.msg_type = msg_type
        self.topic = topic
        self.qos_profile = qos_profile
        self._context = publisher_impl._node.context
        self._send = publisher_impl._endpoint.publish
        self._handle = publisher_impl
        self._events = EndpointEvents(publisher_impl, event_callbacks, callback_group, topic, "PublisherEventCallbacks")

    def publish(self, msg: MsgT | bytes) -> None:
        """Send a message, given as an object of the topic's type or as its CDR bytes.

        Raises:
            TypeError: for anything else.
            InvalidHandle: after destruction.
            RCLError: if the context was shut down.
        """
        if self._handle._destroyed or not self._context._valid:
            self._handle.check_publisher("Failed to publish")
        if isinstance(msg, self.msg_type):
            self._send(msg)
        elif isinstance(msg, bytes):
            from rclpy._rclpy_pybind11 import RMWError
            from rclpy.serialization import deserialize_message

            with suppress(RMWError):  # there it is sent, and no subscription can read it
                self._send(deserialize_message(msg, self.msg_type))
        else:
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")

    def _has_subscribers(self) -> bool:
        """Return whether any subscription matches, here or in other processes; raises as `publish`."""
        self._handle.check_publisher("Failed to publish")
        endpoint = self._handle._endpoint
        return bool(endpoint.matched or endpoint.remote_matched)

    def _is_attended(self) -> bool:
        """Return whether it matters to anybody when exactly a message is published."""
        attended: bool = self._handle._endpoint.is_attended
        return attended

    def _publish_unheard(self, messages: int) -> None:
        """Publish so many messages while it matters to nobody: they are only counted."""
        self._handle._endpoint.publish_unheard(messages)

    def get_subscription_count(self) -> int:
        """Return how many subscriptions match."""
        self._handle.check_publisher("failed to get subscription count")
        count: int = self._handle._endpoint.subscription_count
        return count

    def assert_liveliness(self) -> None:
        """Assert the publisher's liveliness (for MANUAL_BY_TOPIC)."""
        self._handle.check_publisher("Failed to assert liveliness on the Publisher")
        self._handle._endpoint.assert_liveliness()

    def wait_for_all_acked(self, timeout: Duration = Duration(seconds=-1)) -> bool:  # noqa: B008
        """Return True at once.

        Subscriptions of this process have every message as soon as `publish` returns; messages to others are under way by then,
        and nothing says when they arrive.
        """
        self._handle.check_publisher("Failed to wait for all acknowledged")
        if not isinstance(timeout, Duration):
            raise AttributeError(f"'{type(timeout).__name__}' object has no attribute '_duration_handle'")
        return True
