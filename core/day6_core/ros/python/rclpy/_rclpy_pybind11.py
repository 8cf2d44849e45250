"""The names of rclpy's C++ half that programs use: its exceptions, enumerations and a few constants.

In real ROS this module is compiled; here the graph (`day6_core.graph`) does its work. Exceptions keep their module name,
because it is part of every traceback a student sees.
"""

from __future__ import annotations

import builtins
from enum import Enum
from importlib import import_module
from typing import Any

from day6_core.graph.qos import BEST_AVAILABLE_NS, INFINITE_NS, PolicyKind

RCL_DEFAULT_DOMAIN_ID = 18446744073709551615
RMW_DURATION_INFINITE = INFINITE_NS
RMW_QOS_DEADLINE_BEST_AVAILABLE = BEST_AVAILABLE_NS
RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE = BEST_AVAILABLE_NS

# Names that need more of rclpy than its exceptions are imported from their modules on first use.
_ELSEWHERE = {
    "rclpy._day6.endpoint_handles": {
        "Client": "ClientHandle",
        "Publisher": "PublisherHandle",
        "Service": "ServiceHandle",
        "Subscription": "SubscriptionHandle",
        "rmw_service_info_t": "ServiceInfo",
    },
    "rclpy._day6.handles": {"Node": "NodeHandle"},
    "rclpy._day6.wait_set": {"WaitSet": "WaitSet"},
    "rclpy.clock": {"Clock": "_ClockHandle"},
    "rclpy.context": {"Context": "_ContextHandle"},
    "rclpy.event_handler": {
        "EventHandle": "_EventHandle",
        "rmw_incompatible_type_status_t": "IncompatibleTypeInfo",
        "rmw_liveliness_changed_status_t": "QoSLivelinessChangedInfo",
        "rmw_liveliness_lost_status_t": "QoSLivelinessLostInfo",
        "rmw_matched_status_t": "QoSSubscriptionMatchedInfo",
        "rmw_message_lost_status_t": "QoSMessageLostInfo",
        "rmw_offered_deadline_missed_status_t": "QoSOfferedDeadlineMissedInfo",
        "rmw_requested_deadline_missed_status_t": "QoSRequestedDeadlineMissedInfo",
        "rmw_requested_qos_incompatible_event_status_t": "QoSRequestedIncompatibleQoSInfo",
    },
    "rclpy.experimental.events_executor": {"EventsExecutor": "_EventsExecutor"},
    "rclpy.expand_topic_name": {"rclpy_expand_topic_name": "expand_topic_name"},
    "rclpy.guard_condition": {"GuardCondition": "_GuardHandle"},
    "rclpy.impl.rcutils_logger": {
        "rclpy_logging_get_logger_effective_level": "_effective_level_of",
        "rclpy_logging_logger_is_enabled_for": "_is_enabled_for",
        "rclpy_logging_rcutils_log": "_log_from",
    },
    "rclpy.lifecycle._state_machine": {"LifecycleStateMachine": "StateMachine"},
    "rclpy.logging": {"rclpy_logging_set_logger_level": "set_logger_level"},
    "rclpy.qos": {"rmw_qos_profile_t": "_rmw_qos_profile_t", "rclpy_qos_check_compatible": "qos_check_compatible"},
    "rclpy.serialization": {"rclpy_deserialize": "deserialize_message"},
    "rclpy.signals": {
        "install_signal_handlers": "install_signal_handlers",
        "uninstall_signal_handlers": "uninstall_signal_handlers",
        "get_current_signal_handlers_options": "get_current_signal_handlers_options",
    },
    "rclpy.timer": {"Timer": "_TimerHandle"},
    "rclpy.utilities": {
        "rclpy_get_rmw_implementation_identifier": "get_rmw_implementation_identifier",
        "rclpy_remove_ros_args": "remove_ros_args",
    },
    "day6_core.graph": {"rmw_request_id_t": "RequestId"},
}
_PLACES = {name: (module, own) for module, names in _ELSEWHERE.items() for name, own in names.items()}


def __getattr__(name: str) -> Any:
    place = _PLACES.get(name)
    if place is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(place[0]), place[1])


DESTROYED = "cannot use Destroyable because destruction was requested"


class RCLError(RuntimeError):
    """An error reported by rcl."""


class RCLInvalidROSArgsError(RCLError):
    """The ROS arguments could not be parsed."""


class UnknownROSArgsError(RuntimeError):
    """Something between `--ros-args` and `--` isn't a ROS argument."""


class NodeNameNonExistentError(RCLError):
    """A graph query named a node that does not exist."""


class UnsupportedEventTypeError(RCLError):
    """The middleware has no event of that type."""


class TimerCancelledError(RCLError):
    """A cancelled timer was called."""


class NotImplementedError(RCLError, builtins.NotImplementedError):  # noqa: A001
    """The middleware does not support this."""


class RCUtilsError(RuntimeError):
    """An error reported by rcutils."""


class RMWError(RuntimeError):
    """An error reported by the middleware."""


class InvalidHandle(RuntimeError):
    """An entity was used after it had been destroyed."""


class _NumberedEnum(Enum):
    """An enumeration like those of pybind11: members aren't integers, but equal one and can be converted to one."""

    def __eq__(self, other: object) -> bool:
        if isinstance(other, int):
            return bool(self.value == other)
        return self is other

    def __hash__(self) -> int:
        return hash(self.value)

    def __int__(self) -> int:
        return int(self.value)

    def __index__(self) -> int:
        return int(self.value)


class ClockType(_NumberedEnum):
    """rcl_clock_type_t."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


class ClockChange(_NumberedEnum):
    """rcl_clock_change_t: what a time jump did to the source of a ROS clock."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class GoalEvent(_NumberedEnum):
    """rcl_action_goal_event_t."""

    EXECUTE = 0
    CANCEL_GOAL = 1
    SUCCEED = 2
    ABORT = 3
    CANCELED = 4


class SignalHandlerOptions(_NumberedEnum):
    """Which signals rclpy handles."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


class QoSCompatibility(_NumberedEnum):
    """rmw_qos_compatibility_type_t."""

    OK = 0
    WARNING = 1
    ERROR = 2


class TransitionCallbackReturnType(_NumberedEnum):
    """How a transition of a lifecycle node ended; numbers of lifecycle_msgs/msg/Transition."""

    SUCCESS = 97
    FAILURE = 98
    ERROR = 99

    def to_label(self) -> str:
        """Return the label of the transition that follows."""
        return f"transition_{self.name.lower()}"


class ServiceIntrospectionState(_NumberedEnum):
    """rcl_service_introspection_state_t."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


class rmw_qos_policy_kind_t(_NumberedEnum):
    """The QoS policy an incompatible-QoS event names."""

    RMW_QOS_POLICY_INVALID = PolicyKind.INVALID.value
    RMW_QOS_POLICY_DURABILITY = PolicyKind.DURABILITY.value
    RMW_QOS_POLICY_DEADLINE = PolicyKind.DEADLINE.value
    RMW_QOS_POLICY_LIVELINESS = PolicyKind.LIVELINESS.value
    RMW_QOS_POLICY_RELIABILITY = PolicyKind.RELIABILITY.value
    RMW_QOS_POLICY_HISTORY = PolicyKind.HISTORY.value
    RMW_QOS_POLICY_LIFESPAN = PolicyKind.LIFESPAN.value
    RMW_QOS_POLICY_DEPTH = PolicyKind.DEPTH.value
    RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION = PolicyKind.LIVELINESS_LEASE_DURATION.value
    RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS = PolicyKind.AVOID_ROS_NAMESPACE_CONVENTIONS.value


class rcl_publisher_event_type_t(_NumberedEnum):
    """Events a publisher can raise."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class rcl_subscription_event_type_t(_NumberedEnum):
    """Events a subscription can raise."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


class rcl_duration_t:
    """A duration in nanoseconds."""

    def __init__(self, nanoseconds: int) -> None:
        self.nanoseconds = nanoseconds


class rcl_time_point_t:
    """A time in nanoseconds of a kind of clock."""

    def __init__(self, nanoseconds: int, clock_type: int) -> None:
        self.nanoseconds = nanoseconds
        self.clock_type = ClockType(int(clock_type))


class Destroyable:
    """A handle: usable until it is destroyed; entering a destroyed one raises InvalidHandle."""

    def __init__(self) -> None:
        self._destroyed = False

    @property
    def pointer(self) -> int:
        """A number that is unique to this handle while it exists."""
        return id(self)

    def __enter__(self) -> None:
        if self._destroyed:
            raise InvalidHandle(DESTROYED)

    def __exit__(self, exc_type: object, exc_value: object, traceback: object) -> None:
        pass

    def destroy_when_not_in_use(self) -> None:
        """Make every later use raise InvalidHandle."""
        self._destroyed = True
