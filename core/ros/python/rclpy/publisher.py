"""Publishers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, TypeVar

from rclpy._endpoint_events import EventSource
from rclpy._incidental import also
from rclpy.duration import Duration
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from rclpy._handles import EndpointHandle
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import PublisherEventCallbacks

__getattr__ = also(__name__, "CallbackGroup EventHandler PublisherEventCallbacks")


MsgT = TypeVar("MsgT")
MsgType = TypeVar("MsgType")


class Publisher(EventSource, Generic[MsgT]):
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
        self.callback_group = None
        self._context = publisher_impl._node.context
        self._send = publisher_impl._endpoint.publish
        self._set_up_events(publisher_impl, event_callbacks, callback_group, topic, "PublisherEventCallbacks")

    def publish(self, msg: MsgT | bytes) -> None:
        """Send a message, given as an object of the topic's type or as its CDR bytes.

        TypeError for anything else; InvalidHandle after destruction, RCLError when the context was shut down.
        """
        if self._handle._destroyed or not self._context._valid:
            self._handle.check_publisher("Failed to publish")
        if isinstance(msg, self.msg_type):
            self._send(msg)
        elif isinstance(msg, bytes):
            from rclpy.serialization import deserialize_message

            self._send(deserialize_message(msg, self.msg_type))
        else:
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")

    def _endpoint_is_heard(self) -> bool:
        """Say whether anybody would get a message; raises what `publish` raises."""
        self._handle.check_publisher("Failed to publish")
        endpoint = self._handle._endpoint
        return bool(endpoint.matched or endpoint.remote_matched)

    def get_subscription_count(self) -> int:
        """Return how many subscriptions match."""
        self._handle.check_publisher("failed to get subscription count")
        count: int = self._handle._endpoint.subscription_count
        return count

    @property
    def topic_name(self) -> str:
        """The full name of the topic."""
        self._handle.check()
        return self._handle.get_topic_name()

    def destroy(self) -> None:
        """Take the publisher out of the graph; prefer `Node.destroy_publisher`."""
        self._destroy_events()
        self._handle.destroy_when_not_in_use()

    def assert_liveliness(self) -> None:
        """Show that the publisher lives (for the liveliness MANUAL_BY_TOPIC)."""
        self._handle.check_publisher("Failed to assert liveliness on the Publisher")
        self._handle._endpoint.assert_liveliness()

    def wait_for_all_acked(self, timeout: Duration = Duration(seconds=-1)) -> bool:  # noqa: B008
        """Wait until every subscription has every message: they have it when `publish` returns."""
        self._handle.check_publisher("Failed to wait for all acknowledged")
        if not isinstance(timeout, Duration):
            raise AttributeError(f"'{type(timeout).__name__}' object has no attribute '_duration_handle'")
        return True

    def _process(self) -> Any:
        raise NotImplementedError("a publisher has nothing to process")
