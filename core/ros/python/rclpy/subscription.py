"""Subscriptions."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import TYPE_CHECKING, Any, Generic, TypedDict, TypeVar

from rclpy._callables import accepts, is_coroutine_function
from rclpy._endpoint_events import EventSource
from rclpy._entity import NOTHING, SUBSCRIPTION
from rclpy._incidental import also
from rclpy._rclpy_pybind11 import RCLError as RCLError
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from rclpy._endpoint_handles import SubscriptionHandle
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import SubscriptionEventCallbacks
    from rclpy.subscription_content_filter_options import ContentFilterOptions

__getattr__ = also(__name__, "CallbackGroup ContentFilterOptions SubscriptionEventCallbacks")


MsgT = TypeVar("MsgT")
MsgType = TypeVar("MsgType")


class MessageInfo(TypedDict):
    """What a callback with two arguments gets beside the message; times are epoch nanoseconds."""

    source_timestamp: int
    received_timestamp: int
    publication_sequence_number: int | None
    reception_sequence_number: int | None
    publisher_gid: dict[str, Any] | None


class Subscription(EventSource, Generic[MsgT]):
    """Calls a function for every message of a topic; made by `Node.create_subscription`."""

    _kind = SUBSCRIPTION
    _handle: SubscriptionHandle

    class CallbackType(Enum):
        """What a callback wants."""

        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self,
        subscription_impl: SubscriptionHandle,
        msg_type: type[MsgT],
        topic: str,
        callback: Callable[[MsgT], Any] | Callable[[MsgT, MessageInfo], Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        raw: bool,
        event_callbacks: SubscriptionEventCallbacks | None,
    ) -> None:
        self._endpoint = subscription_impl._endpoint
        self._received_queue = self._endpoint.queue
        self._take_sample = self._endpoint.take
        self.msg_type = msg_type
        self.topic = topic
        self.raw = raw
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        self.qos_profile = qos_profile
        self._set_up_events(subscription_impl, event_callbacks, callback_group, topic, "SubscriptionEventCallbacks")
        self._endpoint.on_ready = self._notify

    def _pending(self) -> bool:
        return bool(self._received_queue)

    def _process(self) -> Any:
        self._queued = False
        sample = self._take_sample()
        if sample is None or self._handle._destroyed:
            return NOTHING
        if self._received_queue:
            self._notify()
        if self._simple:
            self._callback(sample[0])
            return None
        return self._call_specially(sample)

    def _call_specially(self, sample: Any) -> Any:
        message = sample[0]
        if self.raw:
            from rclpy.serialization import serialize_message

            message = serialize_message(message)
        if self._callback_type is Subscription.CallbackType.WithMessageInfo:
            result = self._callback(message, self._handle.info(sample))
        else:
            result = self._callback(message)
        return result if self._is_async else None

    def get_publisher_count(self) -> int:
        """Return how many publishers match."""
        self._handle.check()
        count: int = self._endpoint.publisher_count
        return count

    def destroy(self) -> None:
        """Take the subscription out of the graph; prefer `Node.destroy_subscription`."""
        self._destroy_events()
        self._handle.destroy_when_not_in_use()

    @property
    def topic_name(self) -> str:
        """The full name of the topic."""
        self._handle.check()
        return self._handle.get_topic_name()

    @property
    def callback(self) -> Any:
        """The function that is called. Setting one that takes neither one nor two arguments raises RuntimeError."""
        return self._callback

    @callback.setter
    def callback(self, value: Any) -> None:
        self._callback = value
        self._callback_type = Subscription.CallbackType.MessageOnly
        if not callable(value) or not accepts(value, 1):
            if not callable(value) or not accepts(value, 2):
                raise RuntimeError(
                    "Subscription.__init__(): callback should be either be callable with one argument"
                    "(to get only the message) or two (to get message and message info)"
                )
            self._callback_type = Subscription.CallbackType.WithMessageInfo
        self._is_async = is_coroutine_function(value)
        self._simple = (
            not self._is_async and not self.raw and self._callback_type is Subscription.CallbackType.MessageOnly
        )

    @property
    def is_cft_enabled(self) -> bool:
        """Whether a content filter works."""
        return self._handle.is_cft_enabled()

    def set_content_filter(self, filter_expression: str, expression_parameters: list[str]) -> None:
        """Receive only messages for which an SQL-like expression is true (`x > %0 AND name LIKE 'a%'`); '' ends that.

        `%0`, `%1` … stand for the parameters. RCLError for an expression that does not fit.
        """
        self._handle.set_content_filter(filter_expression, expression_parameters)

    def get_content_filter(self) -> ContentFilterOptions:
        """Return expression and parameters of the filter; RCLError if there is none."""
        return self._handle.get_content_filter()
