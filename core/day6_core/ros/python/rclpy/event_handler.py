"""Events of publishers and subscriptions: incompatible QoS, matched endpoints, and so on."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.graph.endpoints import Endpoint, EventKind, EventStatus
from rclpy._day6.callables import is_coroutine_function
from rclpy._day6.entity import NOTHING
from rclpy._day6.incidental import also
from rclpy._day6.logging_settings import PROCESS
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import (
    Destroyable,
    rcl_publisher_event_type_t,
    rcl_subscription_event_type_t,
    rmw_qos_policy_kind_t,
)
from rclpy._rclpy_pybind11 import UnsupportedEventTypeError as UnsupportedEventTypeError
from rclpy.logging import get_logger as get_logger
from rclpy.qos import qos_policy_name_from_kind
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from rclpy._day6.entity import Scope
    from rclpy._day6.handles import EndpointHandle
    from rclpy._day6.timer_heap import TimerHeap
    from rclpy.callback_groups import CallbackGroup

__getattr__ = also(__name__, "CallbackGroup")


QoSPublisherEventType = rcl_publisher_event_type_t
QoSSubscriptionEventType = rcl_subscription_event_type_t


class _Info:
    """Counters of one kind of event, as its callback gets them."""

    __slots__ = ("total_count", "total_count_change")

    def __init__(self, status: EventStatus | None = None) -> None:
        self.total_count = 0 if status is None else status.total_count
        self.total_count_change = 0 if status is None else status.total_count_change


class QoSRequestedDeadlineMissedInfo(_Info):
    """A subscription's deadline was missed."""

    __slots__ = ()


class QoSLivelinessChangedInfo:
    """Publishers of a subscription gained or lost liveliness."""

    __slots__ = ("alive_count", "alive_count_change", "not_alive_count", "not_alive_count_change")

    def __init__(self, status: EventStatus | None = None) -> None:
        self.alive_count = 0 if status is None else status.current_count
        self.alive_count_change = 0 if status is None else status.current_count_change
        self.not_alive_count = 0 if status is None else status.not_alive_count
        self.not_alive_count_change = 0 if status is None else status.not_alive_count_change


class QoSMessageLostInfo(_Info):
    """Messages were lost on the way to a subscription."""

    __slots__ = ()


class QoSRequestedIncompatibleQoSInfo(_Info):
    """Endpoints of a topic have incompatible QoS; `last_policy_kind` is the latest incompatible policy."""

    __slots__ = ("last_policy_kind",)

    def __init__(self, status: EventStatus | None = None) -> None:
        super().__init__(status)
        self.last_policy_kind = rmw_qos_policy_kind_t(1 if status is None else int(status.last_policy_kind))


class QoSSubscriptionMatchedInfo(_Info):
    """Endpoints matched or unmatched."""

    __slots__ = ("current_count", "current_count_change")

    def __init__(self, status: EventStatus | None = None) -> None:
        super().__init__(status)
        self.current_count = 0 if status is None else status.current_count
        self.current_count_change = 0 if status is None else status.current_count_change


class QoSOfferedDeadlineMissedInfo(_Info):
    """A publisher missed its own deadline."""

    __slots__ = ()


class QoSLivelinessLostInfo(_Info):
    """A publisher did not assert its liveliness in time."""

    __slots__ = ()


class IncompatibleTypeInfo(_Info):
    """Endpoints of a topic have different types."""

    __slots__ = ()


QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo
QoSPublisherMatchedInfo = QoSSubscriptionMatchedInfo
EventHandlerData = Any

_PUBLISHER, _SUBSCRIPTION = rcl_publisher_event_type_t, rcl_subscription_event_type_t
_KINDS: dict[Any, tuple[EventKind, type[Any]]] = {
    _PUBLISHER.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED: (EventKind.DEADLINE_MISSED, QoSOfferedDeadlineMissedInfo),
    _PUBLISHER.RCL_PUBLISHER_LIVELINESS_LOST: (EventKind.LIVELINESS_LOST, QoSLivelinessLostInfo),
    _PUBLISHER.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS: (EventKind.INCOMPATIBLE_QOS, QoSOfferedIncompatibleQoSInfo),
    _PUBLISHER.RCL_PUBLISHER_INCOMPATIBLE_TYPE: (EventKind.INCOMPATIBLE_TYPE, IncompatibleTypeInfo),
    _PUBLISHER.RCL_PUBLISHER_MATCHED: (EventKind.MATCHED, QoSPublisherMatchedInfo),
    _SUBSCRIPTION.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED: (
        EventKind.DEADLINE_MISSED,
        QoSRequestedDeadlineMissedInfo,
    ),
    _SUBSCRIPTION.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: (EventKind.LIVELINESS_CHANGED, QoSLivelinessChangedInfo),
    _SUBSCRIPTION.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS: (
        EventKind.INCOMPATIBLE_QOS,
        QoSRequestedIncompatibleQoSInfo,
    ),
    _SUBSCRIPTION.RCL_SUBSCRIPTION_MESSAGE_LOST: (EventKind.MESSAGE_LOST, QoSMessageLostInfo),
    _SUBSCRIPTION.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE: (EventKind.INCOMPATIBLE_TYPE, IncompatibleTypeInfo),
    _SUBSCRIPTION.RCL_SUBSCRIPTION_MATCHED: (EventKind.MATCHED, QoSSubscriptionMatchedInfo),
}


class _EventHandle(Destroyable):
    """One kind of event of a publisher or subscription: whether it happened, and its counters."""

    def __init__(self, parent: EndpointHandle, event_type: Any) -> None:
        super().__init__()
        self._kind, self._info_class = _KINDS[event_type]
        self._endpoint: Endpoint = parent._endpoint
        self._seen = EventStatus()

    def _pending(self) -> bool:
        status, seen = self._endpoint.status(self._kind), self._seen
        return (
            status.total_count != seen.total_count
            or status.current_count != seen.current_count
            or status.not_alive_count != seen.not_alive_count
        )

    def _due_in(self) -> int | None:
        """Nanoseconds until the passing of time raises the event, None if it will not."""
        due = self._endpoint.due(self._kind)
        return None if due is None else max(0, due - self._endpoint.node.graph.now_ns())

    def take_event(self) -> Any:
        """Return the counters; their changes are those since the last time."""
        status, seen = self._endpoint.status(self._kind), self._seen
        # Several handles may read the same counters, so each remembers what it has reported.
        status.total_count_change = status.total_count - seen.total_count
        status.current_count_change = status.current_count - seen.current_count
        status.not_alive_count_change = status.not_alive_count - seen.not_alive_count
        self._seen = status.take()
        return self._info_class(self._seen)


class EventHandler(Waitable[Any]):
    """Calls a function when one kind of event occurs on a publisher or subscription.

    `parent_impl` is the handle of the publisher or subscription.
    """

    def __init__(
        self,
        *,
        callback_group: CallbackGroup,
        callback: Callable[..., object],
        event_type: QoSPublisherEventType | QoSSubscriptionEventType,
        parent_impl: EndpointHandle,
    ) -> None:
        super().__init__(callback_group)
        self.event_type = event_type
        self.callback = callback
        self._event = _EventHandle(parent_impl, event_type)
        self._event_kind = self._event._kind
        self._timed = self._event_kind in self._event._endpoint.watches
        # The attributes that the executor's heap of deadlines needs.
        self._heap: TimerHeap | None = None
        self._heap_deadline = self._next = 0
        self._canceled = False

    def _enter(self, scope: Scope) -> None:
        super()._enter(scope)
        if self._timed:
            scope.timed.append(self)
            self._schedule()

    def _schedule(self) -> None:
        """Schedule a check for the time at which the event may occur."""
        executor = None if self._scope is None else self._scope.executor
        wait = self._event._due_in()
        if wait is None or executor is None or self._canceled:
            return
        self._next = executor._steady_ns() + wait
        if self._heap is None or self._heap_deadline > self._next:
            executor._add_timer(self)

    def _pending(self) -> bool:
        return self._event._pending()

    def _process(self) -> Any:
        self._queued = False
        if self._canceled:
            return NOTHING
        if self._timed:
            self._schedule()
        if not self._event._pending():
            return NOTHING
        result = self.callback(self._event.take_event())
        return result if is_coroutine_function(self.callback) else None

    def __exit__(self, t: object, v: object, tb: object) -> None:
        pass

    def __enter__(self) -> None:
        pass

    def get_num_entities(self) -> NumberOfEntities:
        """Return the number of entities: one event."""
        return NumberOfEntities(num_events=1)

    def destroy(self) -> None:
        """Stop calling the callback."""
        self._canceled = True
        self._event.destroy_when_not_in_use()
        if self._timed and self._scope is not None and self in self._scope.timed:
            self._scope.timed.remove(self)


class QoSEventHandler(EventHandler):
    """The old name of EventHandler."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        warnings.warn("QoSEventHandler is deprecated, use EventHandler instead.", DeprecationWarning, stacklevel=2)
        super().__init__(*args, **kwargs)


class SubscriptionEventCallbacks:
    """The callbacks for events of a subscription. By default incompatible QoS and types are logged."""

    def __init__(
        self,
        *,
        deadline: Callable[[QoSRequestedDeadlineMissedInfo], None] | None = None,
        incompatible_qos: Callable[[QoSRequestedIncompatibleQoSInfo], None] | None = None,
        liveliness: Callable[[QoSLivelinessChangedInfo], None] | None = None,
        message_lost: Callable[[QoSMessageLostInfo], None] | None = None,
        incompatible_type: Callable[[IncompatibleTypeInfo], None] | None = None,
        matched: Callable[[QoSSubscriptionMatchedInfo], None] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.incompatible_qos = incompatible_qos
        self.liveliness = liveliness
        self.message_lost = message_lost
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def create_event_handlers(
        self, callback_group: CallbackGroup, subscription: EndpointHandle, topic_name: str
    ) -> list[EventHandler]:
        """Make the handlers of a subscription, given by its handle."""
        types = rcl_subscription_event_type_t
        qos, type_ = self.incompatible_qos, self.incompatible_type
        if self.use_default_callbacks:
            qos = qos or _qos_warning(
                subscription,
                f"New publisher discovered on topic '{topic_name}', offering incompatible QoS. "
                "No messages will be received from it. Last incompatible policy: ",
            )
            type_ = type_ or _type_warning(subscription, topic_name)
        return _make_handlers(
            callback_group,
            subscription,
            (
                (self.deadline, types.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED),
                (qos, types.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS),
                (self.liveliness, types.RCL_SUBSCRIPTION_LIVELINESS_CHANGED),
                (self.message_lost, types.RCL_SUBSCRIPTION_MESSAGE_LOST),
                (type_, types.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE),
                (self.matched, types.RCL_SUBSCRIPTION_MATCHED),
            ),
        )


class PublisherEventCallbacks:
    """The callbacks for events of a publisher. By default incompatible QoS and types are logged."""

    def __init__(
        self,
        *,
        deadline: Callable[[QoSOfferedDeadlineMissedInfo], None] | None = None,
        liveliness: Callable[[QoSLivelinessLostInfo], None] | None = None,
        incompatible_qos: Callable[[QoSRequestedIncompatibleQoSInfo], None] | None = None,
        incompatible_type: Callable[[IncompatibleTypeInfo], None] | None = None,
        matched: Callable[[QoSPublisherMatchedInfo], None] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.incompatible_qos = incompatible_qos
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def create_event_handlers(
        self, callback_group: CallbackGroup, publisher: EndpointHandle, topic_name: str
    ) -> list[EventHandler]:
        """Make the handlers of a publisher, given by its handle."""
        types = rcl_publisher_event_type_t
        qos, type_ = self.incompatible_qos, self.incompatible_type
        if self.use_default_callbacks:
            qos = qos or _qos_warning(
                publisher,
                f"New subscription discovered on topic '{topic_name}', requesting incompatible QoS. "
                "No messages will be sent to it. Last incompatible policy: ",
            )
            type_ = type_ or _type_warning(publisher, topic_name)
        return _make_handlers(
            callback_group,
            publisher,
            (
                (self.deadline, types.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED),
                (self.liveliness, types.RCL_PUBLISHER_LIVELINESS_LOST),
                (qos, types.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS),
                (type_, types.RCL_PUBLISHER_INCOMPATIBLE_TYPE),
                (self.matched, types.RCL_PUBLISHER_MATCHED),
            ),
        )


def _warn(parent: EndpointHandle, text: str) -> None:
    logger = parent.get_logger()
    if logger._settings is PROCESS:
        # By name, as real rclpy does it: programs replace the root logger to catch these.
        logger = get_logger(logger.name)
    # So does real rclpy: `warn` until it was taken away, and programs replace that one.
    (logger.warn if hasattr(logger, "warn") else logger.warning)(text)


def _qos_warning(parent: Any, text: str) -> Callable[[QoSRequestedIncompatibleQoSInfo], None]:
    def warn(event: QoSRequestedIncompatibleQoSInfo) -> None:
        _warn(parent, text + qos_policy_name_from_kind(int(event.last_policy_kind)))

    return warn


def _type_warning(parent: Any, topic_name: str) -> Callable[[IncompatibleTypeInfo], None]:
    def warn(_event: IncompatibleTypeInfo) -> None:
        _warn(parent, f"Incompatible type on topic '{topic_name}', no messages will be sent to it.")

    return warn


def _make_handlers(
    group: CallbackGroup, parent: Any, wanted: tuple[tuple[Callable[..., Any] | None, Any], ...]
) -> list[EventHandler]:
    return [
        EventHandler(callback_group=group, callback=callback, event_type=event_type, parent_impl=parent)
        for callback, event_type in wanted
        if callback
    ]


withdraw(__name__)
