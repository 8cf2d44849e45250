"""Types that only annotations of programs name; they are found in the modules where real rclpy has them.

All annotations here are texts, so nothing is imported for them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal, Protocol, TypedDict, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable

    from builtin_interfaces.msg import Time
    from service_msgs.msg import ServiceEventInfo
    from unique_identifier_msgs.msg import UUID

    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock, ClockChange
    from rclpy.context import Context
    from rclpy.event_handler import PublisherEventCallbacks
    from rclpy.impl.logging_severity import LoggingSeverity
    from rclpy.parameter import Parameter
    from rclpy.qos_overriding_options import QoSOverridingOptions

GoalT = TypeVar("GoalT")
ResultT = TypeVar("ResultT")
FeedbackT = TypeVar("FeedbackT")
_GoalIn = TypeVar("_GoalIn")
_ResultIn = TypeVar("_ResultIn")
_FeedbackIn = TypeVar("_FeedbackIn")


# rclpy.type_support


class PyCapsule(Protocol):
    """What stands for something of C; there is none here."""


class CommonMsgSrvMetaClass(type(Protocol)):  # type: ignore[misc]
    """The class of classes of messages, services and actions."""

    _TYPE_SUPPORT: ClassVar[Any]

    @classmethod
    def __import_type_support__(cls) -> None:
        """Make the class ready for use."""


class MsgMetaClass(CommonMsgSrvMetaClass):
    """The class of classes of messages."""


class Msg(Protocol, metaclass=MsgMetaClass):
    """A message."""


class Srv(Protocol, metaclass=CommonMsgSrvMetaClass):
    """A service: a class with Request, Response and Event."""

    Request: type[Any]
    Response: type[Any]
    Event: type[Any]


class Action(Protocol, metaclass=CommonMsgSrvMetaClass):
    """An action: a class with Goal, Result, Feedback and Impl."""

    Goal: type[Any]
    Result: type[Any]
    Feedback: type[Any]
    Impl: type[Any]


class EventMessage(Msg, Protocol):
    """What introspection tells of a service."""

    info: ServiceEventInfo


class SendGoalServiceRequest(Msg, Protocol[_GoalIn]):
    """The request to take a goal."""

    goal_id: UUID
    goal: _GoalIn


class SendGoalServiceResponse(Msg, Protocol):
    """Whether a goal was taken, and when."""

    accepted: bool
    stamp: Time


class SendGoalService(Protocol, metaclass=CommonMsgSrvMetaClass):
    """The service that takes goals."""

    Request: type[Any]
    Response: type[Any]


class GetResultServiceRequest(Msg, Protocol):
    """The question for a result."""

    goal_id: UUID


class GetResultServiceResponse(Msg, Protocol[_ResultIn]):
    """A result, and how the goal ended."""

    status: int
    result: _ResultIn


class GetResultService(Protocol, metaclass=CommonMsgSrvMetaClass):
    """The service that gives results."""

    Request: type[Any]
    Response: type[Any]


class FeedbackMessage(Msg, Protocol[_FeedbackIn]):
    """Feedback, and of which goal."""

    goal_id: UUID
    feedback: _FeedbackIn


# rclpy.impl.rcutils_logger

SupportedFilters = Literal["throttle", "skip_first", "once"]


class LoggingFilterArgs(TypedDict, total=False):
    """What a call to a logger may say about when to log."""

    once: bool
    throttle_duration_sec: float
    throttle_time_source_type: Clock
    skip_first: bool


class LoggingFilterParams(TypedDict, total=False):
    """The same, of a filter."""

    once: bool | None
    throttle_duration_sec: float | None
    throttle_time_source_type: Clock
    skip_first: bool | None


class LoggingArgs(LoggingFilterArgs, total=False):
    """What a call to a logger may have beside the message."""

    name: str


class RcutilsLoggerContext(TypedDict):
    """What is remembered of one place that logs."""

    name: str
    severity: LoggingSeverity
    filters: list[SupportedFilters]


class OnceContext(RcutilsLoggerContext):
    """What `once` remembers."""

    has_been_logged_once: bool


class ThrottleContext(RcutilsLoggerContext):
    """What `throttle_duration_sec` remembers."""

    throttle_duration_sec: float
    throttle_time_source_type: Clock
    throttle_last_logged: int


class SkipFirstContext(RcutilsLoggerContext):
    """What `skip_first` remembers."""

    first_has_been_skipped: bool


# elsewhere


class TimeJumpDictionary(TypedDict):
    """A time jump (rclpy.clock)."""

    clock_change: ClockChange
    delta: int


class SendGoalKWargs(TypedDict):
    """What `ActionClient.send_goal` takes beside the goal."""

    feedback_callback: Callable[[Any], None] | None
    goal_uuid: UUID | None


class LifecycleNodeArgs(TypedDict, total=False):
    """What a lifecycle node takes beside its name."""

    context: Context | None
    cli_args: list[str] | None
    namespace: str | None
    use_global_arguments: bool
    enable_rosout: bool
    start_parameter_services: bool
    parameter_overrides: list[Parameter[Any]] | None
    allow_undeclared_parameters: bool
    automatically_declare_parameters_from_overrides: bool
    enable_logger_service: bool


class CreateLifecyclePublisherArgs(TypedDict, total=False):
    """What `create_lifecycle_publisher` takes beside type, topic and QoS."""

    callback_group: CallbackGroup | None
    event_callbacks: PublisherEventCallbacks | None
    qos_overriding_options: QoSOverridingOptions | None
