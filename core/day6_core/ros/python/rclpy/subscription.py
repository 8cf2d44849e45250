"""Subscriptions."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import TYPE_CHECKING, Any, Generic, TypedDict, TypeVar

from rclpy._day6.callables import accepts, is_coroutine_function
from rclpy._day6.endpoint_events import EndpointEvents
from rclpy._day6.entity import NOTHING, SUBSCRIPTION, Entity
from rclpy._day6.incidental import also
from rclpy._day6.node_endpoint import TopicEndpoint
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import RCLError as RCLError
from rclpy.qos import QoSProfile
from rclpy.type_support import MsgT

if TYPE_CHECKING:
    from rclpy._day6.endpoint_handles import SubscriptionHandle
    from rclpy._day6.entity import Scope
    from rclpy.callback_groups import CallbackGroup
    from rclpy.event_handler import SubscriptionEventCallbacks
    from rclpy.subscription_content_filter_options import ContentFilterOptions

__getattr__ = also(__name__, "CallbackGroup ContentFilterOptions SubscriptionEventCallbacks")


MsgType = TypeVar("MsgType")


class MessageInfo(TypedDict):
    """The second argument of a callback with two; times are in epoch nanoseconds."""

    source_timestamp: int
    received_timestamp: int
    publication_sequence_number: int | None
    reception_sequence_number: int | None
    publisher_gid: dict[str, Any] | None


if TYPE_CHECKING:
    MessageCallback = Callable[[MsgT], object] | Callable[[MsgT, MessageInfo], object]


class Subscription(TopicEndpoint, Entity, Generic[MsgT]):
    """Calls a function for every message of a topic; made by `Node.create_subscription`."""

    _kind = SUBSCRIPTION
    _handle: SubscriptionHandle

    class CallbackType(Enum):
        """The arguments of a callback."""

        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self,
        subscription_impl: SubscriptionHandle,
        msg_type: type[MsgT],
        topic: str,
        callback: MessageCallback[MsgT],
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
        self._handle = subscription_impl
        self._events = EndpointEvents(
            subscription_impl, event_callbacks, callback_group, topic, "SubscriptionEventCallbacks"
        )
        self._endpoint.takes_bytes = raw
        self._endpoint.on_ready = self._notify

    @property
    def handle(self) -> SubscriptionHandle:
        """The handle."""
        return self._handle

    def _enter(self, scope: Scope) -> None:
        super()._enter(scope)
        self._events.enter(scope)

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
        message = self._handle.raw(sample) if self.raw else sample[0]
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

    @property
    def callback(self) -> MessageCallback[MsgT]:
        """The function that is called. Setting one that takes neither one nor two arguments raises RuntimeError."""
        return self._callback

    @callback.setter
    def callback(self, value: MessageCallback[MsgT]) -> None:
        self._callback: Callable[..., Any] = value
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
    def is_cft_supported(self) -> bool:
        """Whether the middleware can filter by content: always."""
        return self._handle.is_cft_supported()

    @property
    def is_cft_enabled(self) -> bool:
        """Whether a content filter is active."""
        return self._handle.is_cft_enabled()

    def set_content_filter(self, filter_expression: str, expression_parameters: list[str]) -> None:
        """Receive only messages for which an SQL-like expression is true (`x > %0 AND name LIKE 'a%'`); '' removes the filter.

        `%0`, `%1` … are the parameters.

        Raises:
            RCLError: for an expression that cannot be parsed or does not fit the messages.
        """
        self._handle.set_content_filter(filter_expression, expression_parameters)

    def get_content_filter(self) -> ContentFilterOptions:
        """Return expression and parameters of the filter.

        Raises:
            RCLError: if there is none.
        """
        return self._handle.get_content_filter()


withdraw(__name__)
