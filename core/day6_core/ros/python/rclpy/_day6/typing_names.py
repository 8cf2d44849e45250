"""Types that programs use only in annotations; the modules of real rclpy that have them find them here.

All annotations here are strings, so nothing is imported for them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Generic, Literal, Protocol, TypedDict, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable

    from action_msgs.msg import GoalStatusArray
    from action_msgs.srv import CancelGoal
    from builtin_interfaces.msg import Time
    from service_msgs.msg import ServiceEventInfo
    from unique_identifier_msgs.msg import UUID

    from day6_core.graph import RequestId
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
_Request = TypeVar("_Request")
_Response = TypeVar("_Response")
_Goal = TypeVar("_Goal")
_Result = TypeVar("_Result")
_Feedback = TypeVar("_Feedback")


# -- rclpy.type_support ------------------------------------------------------------------------------------------------


class PyCapsule(Protocol):
    """A C object in Python's C API; there are none here."""


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

    if TYPE_CHECKING:
        # Services and actions don't have this method, so a type checker doesn't take them for messages.
        @classmethod
        def get_fields_and_field_types(cls) -> dict[str, str]:
            """Return the names of the fields with rosidl's texts for their types."""


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


class ServiceType(Srv, Protocol[_Request, _Response]):
    """A service's class, from which a type checker infers the types of requests and responses."""

    Request: type[_Request]
    Response: type[_Response]


class ActionType(Action, Protocol[_Goal, _Result, _Feedback]):
    """An action's class, from which a type checker infers the types of goals, results and feedback."""

    Goal: type[_Goal]
    Result: type[_Result]
    Feedback: type[_Feedback]


class EventMessage(Msg, Protocol):
    """An event of service introspection."""

    info: ServiceEventInfo


class SendGoalServiceRequest(Msg, Protocol[_GoalIn]):
    """The request to accept a goal."""

    goal_id: UUID
    goal: _GoalIn


class SendGoalServiceResponse(Msg, Protocol):
    """Whether a goal was accepted, and when."""

    accepted: bool
    stamp: Time


class SendGoalService(Protocol, metaclass=CommonMsgSrvMetaClass):
    """The service that accepts goals."""

    Request: type[Any]
    Response: type[Any]


class GetResultServiceRequest(Msg, Protocol):
    """The request for a result."""

    goal_id: UUID


class GetResultServiceResponse(Msg, Protocol[_ResultIn]):
    """A result, and the final status of the goal."""

    status: int
    result: _ResultIn


class GetResultService(Protocol, metaclass=CommonMsgSrvMetaClass):
    """The service that returns results."""

    Request: type[Any]
    Response: type[Any]


class FeedbackMessage(Msg, Protocol[_FeedbackIn]):
    """Feedback, and the id of its goal."""

    goal_id: UUID
    feedback: _FeedbackIn


# -- rclpy.impl.rcutils_logger -----------------------------------------------------------------------------------------

SupportedFilters = Literal["throttle", "skip_first", "once"]


class LoggingFilterArgs(TypedDict, total=False):
    """The arguments of a logging call that filter it."""

    once: bool
    throttle_duration_sec: float
    throttle_time_source_type: Clock
    skip_first: bool


class LoggingFilterParams(TypedDict, total=False):
    """The arguments of a filter."""

    once: bool | None
    throttle_duration_sec: float | None
    throttle_time_source_type: Clock
    skip_first: bool | None


class LoggingArgs(LoggingFilterArgs, total=False):
    """The arguments of a logging call besides the message."""

    name: str


class RcutilsLoggerContext(TypedDict):
    """The state of one logging call."""

    name: str
    severity: LoggingSeverity
    filters: list[SupportedFilters]


class OnceContext(RcutilsLoggerContext):
    """The state of `once`."""

    has_been_logged_once: bool


class ThrottleContext(RcutilsLoggerContext):
    """The state of `throttle_duration_sec`."""

    throttle_duration_sec: float
    throttle_time_source_type: Clock
    throttle_last_logged: int


class SkipFirstContext(RcutilsLoggerContext):
    """The state of `skip_first`."""

    first_has_been_skipped: bool


# -- elsewhere ---------------------------------------------------------------------------------------------------------


class TimeJumpDictionary(TypedDict):
    """A time jump (rclpy.clock)."""

    clock_change: ClockChange
    delta: int


if TYPE_CHECKING:

    class ClientTaken(TypedDict, Generic[_ResultIn, _FeedbackIn], total=False):
        """Data taken together by an action client: responses with the numbers of their requests, and messages."""

        goal: tuple[SendGoalServiceResponse, int]
        cancel: tuple[CancelGoal.Response, int]
        result: tuple[GetResultServiceResponse[_ResultIn], int]
        feedback: tuple[FeedbackMessage[_FeedbackIn], object]
        status: tuple[GoalStatusArray, object]

    class ServerTaken(TypedDict, Generic[_GoalIn], total=False):
        """Data taken together by an action server: requests with their ids."""

        goal: tuple[SendGoalServiceRequest[_GoalIn], RequestId]
        cancel: tuple[CancelGoal.Request, RequestId]
        result: tuple[GetResultServiceRequest, RequestId]

    FeedbackCallback = Callable[[FeedbackMessage[_FeedbackIn]], object]

    class SendGoalKWargs(TypedDict, Generic[_FeedbackIn], total=False):
        """Keyword arguments of `ActionClient.send_goal` besides the goal."""

        feedback_callback: FeedbackCallback[_FeedbackIn] | None
        goal_uuid: UUID | None

else:
    # A generic TypedDict needs Python 3.11.
    class SendGoalKWargs(TypedDict):
        """Keyword arguments of `ActionClient.send_goal` besides the goal."""

        feedback_callback: Callable[[Any], None] | None
        goal_uuid: UUID | None


class LifecycleNodeArgs(TypedDict, total=False):
    """Keyword arguments of a lifecycle node besides its name."""

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
    """Keyword arguments of `create_lifecycle_publisher` besides type, topic and QoS."""

    callback_group: CallbackGroup | None
    event_callbacks: PublisherEventCallbacks | None
    qos_overriding_options: QoSOverridingOptions | None
