"""Quality of service: the policies, profiles and the predefined profiles."""

from __future__ import annotations

import warnings
from enum import Enum, IntEnum
from typing import Any, TypeVar

from day6_core.graph import QoS
from day6_core.graph import qos as graph_qos
from day6_core.ros.differences import value
from rclpy._day6.incidental import also
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import RMW_QOS_DEADLINE_BEST_AVAILABLE, RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE
from rclpy._rclpy_pybind11 import QoSCompatibility as QoSCompatibility
from rclpy.duration import Duration

__getattr__ = also(__name__)


class QoSPolicyKind(IntEnum):
    """The policies; numbers of rmw_qos_policy_kind_t."""

    INVALID = graph_qos.PolicyKind.INVALID
    DURABILITY = graph_qos.PolicyKind.DURABILITY
    DEADLINE = graph_qos.PolicyKind.DEADLINE
    LIVELINESS = graph_qos.PolicyKind.LIVELINESS
    RELIABILITY = graph_qos.PolicyKind.RELIABILITY
    HISTORY = graph_qos.PolicyKind.HISTORY
    LIFESPAN = graph_qos.PolicyKind.LIFESPAN
    DEPTH = graph_qos.PolicyKind.DEPTH
    LIVELINESS_LEASE_DURATION = graph_qos.PolicyKind.LIVELINESS_LEASE_DURATION
    AVOID_ROS_NAMESPACE_CONVENTIONS = graph_qos.PolicyKind.AVOID_ROS_NAMESPACE_CONVENTIONS


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return the name of a policy given by number or by member of rmw_qos_policy_kind_t."""
    return QoSPolicyKind(int(policy_kind)).name


class InvalidQoSProfileException(Exception):
    """A profile lacks a required setting."""

    def __init__(self, message: str) -> None:
        # Real rclpy forgets to put its prefix into the exception; the text programs see is the bare message.
        super().__init__(message)


_Policy = TypeVar("_Policy", bound="QoSPolicyEnum")


class QoSPolicyEnum(IntEnum):
    """Base of the policies that are a choice."""

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the choices in lower case, as command lines name them."""
        return [name.lower() for name in cls.__members__ if not name.startswith("RMW")]

    @classmethod
    def get_from_short_key(cls, name: str) -> int:
        """Return the number of a choice named in any case.

        Raises:
            KeyError: if there is none.
        """
        value: int = cls[name.upper()].value
        return value

    @property
    def short_key(self) -> str:
        """This choice's name in lower case."""
        return self.name.lower()


class _OldName:
    """A name of a choice from before ROS 2 Foxy: still works, with a warning."""

    def __init__(self, old: str, new: str) -> None:
        self._old = old
        self._new = new

    def __get__(self, instance: object, owner: type[_Policy]) -> _Policy:
        name = owner.__name__
        warnings.warn(f"{name}.{self._old} is deprecated. Use {name}.{self._new} instead.", stacklevel=1)
        return owner[self._new]


class HistoryPolicy(QoSPolicyEnum):
    """How many messages are kept."""

    SYSTEM_DEFAULT = graph_qos.History.SYSTEM_DEFAULT
    KEEP_LAST = graph_qos.History.KEEP_LAST
    KEEP_ALL = graph_qos.History.KEEP_ALL
    UNKNOWN = graph_qos.History.UNKNOWN


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether lost messages are sent again."""

    SYSTEM_DEFAULT = graph_qos.Reliability.SYSTEM_DEFAULT
    RELIABLE = graph_qos.Reliability.RELIABLE
    BEST_EFFORT = graph_qos.Reliability.BEST_EFFORT
    UNKNOWN = graph_qos.Reliability.UNKNOWN
    BEST_AVAILABLE = graph_qos.Reliability.BEST_AVAILABLE


class DurabilityPolicy(QoSPolicyEnum):
    """Whether late joiners get older messages."""

    SYSTEM_DEFAULT = graph_qos.Durability.SYSTEM_DEFAULT
    TRANSIENT_LOCAL = graph_qos.Durability.TRANSIENT_LOCAL
    VOLATILE = graph_qos.Durability.VOLATILE
    UNKNOWN = graph_qos.Durability.UNKNOWN
    BEST_AVAILABLE = graph_qos.Durability.BEST_AVAILABLE


class LivelinessPolicy(QoSPolicyEnum):
    """How a publisher shows that it lives."""

    SYSTEM_DEFAULT = graph_qos.Liveliness.SYSTEM_DEFAULT
    AUTOMATIC = graph_qos.Liveliness.AUTOMATIC
    MANUAL_BY_TOPIC = graph_qos.Liveliness.MANUAL_BY_TOPIC
    UNKNOWN = graph_qos.Liveliness.UNKNOWN
    BEST_AVAILABLE = graph_qos.Liveliness.BEST_AVAILABLE


_OLD_NAMES: tuple[tuple[type[QoSPolicyEnum], str, tuple[str, ...]], ...] = (
    (HistoryPolicy, "HISTORY", ("SYSTEM_DEFAULT", "KEEP_LAST", "KEEP_ALL", "UNKNOWN")),
    (ReliabilityPolicy, "RELIABILITY", ("SYSTEM_DEFAULT", "RELIABLE", "BEST_EFFORT", "UNKNOWN")),
    (DurabilityPolicy, "DURABILITY", ("SYSTEM_DEFAULT", "TRANSIENT_LOCAL", "VOLATILE", "UNKNOWN")),
    (LivelinessPolicy, "LIVELINESS", ("SYSTEM_DEFAULT", "AUTOMATIC", "MANUAL_BY_TOPIC")),
    # A slip of real rclpy that programs could rely on: the unknown liveliness has a name of durability.
    (LivelinessPolicy, "DURABILITY", ("UNKNOWN",)),
)
for _class, _prefix, _names in _OLD_NAMES if value("rclpy.deprecated_names") else ():
    for _name in _names:
        setattr(_class, f"RMW_QOS_POLICY_{_prefix}_{_name}", _OldName(f"RMW_QOS_POLICY_{_prefix}_{_name}", _name))

QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

_NO_TIME = Duration()


class _rmw_qos_profile_t(QoS):
    """The graph's QoS with the interface of rmw's profile."""

    __slots__ = ()

    @staticmethod
    def predefined(name: str) -> _rmw_qos_profile_t:
        """Return a profile of rmw/qos_profiles.h, like `qos_profile_default`.

        Raises:
            ValueError: if there is none.
        """
        known = {each.name.lower(): each.value for each in QoSPresetProfiles if each.name != "ACTION_STATUS_DEFAULT"}
        profile = known.get(name.removeprefix("qos_profile_")) if name.startswith("qos_profile_") else None
        if profile is None:
            raise ValueError(f"Requested unknown rmw_qos_profile: {name}")
        return profile.get_c_qos_profile()

    def to_dict(self) -> dict[str, Any]:
        """Return the keyword arguments of an equal QoSProfile."""
        return {
            "depth": self.depth,
            "history": int(self.history),
            "reliability": int(self.reliability),
            "durability": int(self.durability),
            "lifespan": Duration(nanoseconds=self.lifespan),
            "deadline": Duration(nanoseconds=self.deadline),
            "liveliness": int(self.liveliness),
            "liveliness_lease_duration": Duration(nanoseconds=self.liveliness_lease_duration),
            "avoid_ros_namespace_conventions": self.avoid_ros_namespace_conventions,
        }


class QoSProfile:
    """All policies of one endpoint.

    Raises:
        InvalidQoSProfileException: unless `depth` is given, or a `history` other than KEEP_LAST.
        AssertionError: for values of a wrong type.
        ValueError: for numbers that aren't members of the policy.
    """

    __slots__ = (
        "_avoid_ros_namespace_conventions",
        "_deadline",
        "_depth",
        "_durability",
        "_history",
        "_lifespan",
        "_liveliness",
        "_liveliness_lease_duration",
        "_reliability",
    )
    _ORDER = (
        "history",
        "depth",
        "reliability",
        "durability",
        "lifespan",
        "deadline",
        "liveliness",
        "liveliness_lease_duration",
        "avoid_ros_namespace_conventions",
    )

    def __init__(
        self,
        history: QoSHistoryPolicy | int | None = None,
        depth: int | None = None,
        reliability: QoSReliabilityPolicy | int | None = None,
        durability: QoSDurabilityPolicy | int | None = None,
        lifespan: Duration | None = None,
        deadline: Duration | None = None,
        liveliness: QoSLivelinessPolicy | int | None = None,
        liveliness_lease_duration: Duration | None = None,
        avoid_ros_namespace_conventions: bool | None = None,
    ) -> None:
        if history is None:
            if depth is None:
                raise InvalidQoSProfileException("History and/or depth settings are required.")
            history = HistoryPolicy.KEEP_LAST
        self.history = history
        if depth is None and self._history == HistoryPolicy.KEEP_LAST:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")
        self.depth = 10 if depth is None else depth
        self.reliability = ReliabilityPolicy.RELIABLE if reliability is None else reliability
        self.durability = DurabilityPolicy.VOLATILE if durability is None else durability
        self.lifespan = _NO_TIME if lifespan is None else lifespan
        self.deadline = _NO_TIME if deadline is None else deadline
        self.liveliness = LivelinessPolicy.SYSTEM_DEFAULT if liveliness is None else liveliness
        self.liveliness_lease_duration = _NO_TIME if liveliness_lease_duration is None else liveliness_lease_duration
        bare_name = avoid_ros_namespace_conventions
        self.avoid_ros_namespace_conventions = False if bare_name is None else bare_name

    @property
    def history(self) -> QoSHistoryPolicy:
        """How many messages are kept."""
        return self._history

    @history.setter
    def history(self, value: QoSHistoryPolicy | int) -> None:
        assert isinstance(value, int)
        self._history = HistoryPolicy(value)

    @property
    def depth(self) -> int:
        """Length of the queue (messages) for KEEP_LAST."""
        return self._depth

    @depth.setter
    def depth(self, value: int) -> None:
        assert isinstance(value, int)
        if value == 0 and self._history == HistoryPolicy.KEEP_LAST:
            warnings.warn(
                "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
                "This will be interpreted as SYSTEM_DEFAULT",
                stacklevel=1,
            )
        self._depth = value

    @property
    def reliability(self) -> QoSReliabilityPolicy:
        """Whether lost messages are sent again."""
        return self._reliability

    @reliability.setter
    def reliability(self, value: QoSReliabilityPolicy | int) -> None:
        assert isinstance(value, int)
        self._reliability = ReliabilityPolicy(value)

    @property
    def durability(self) -> QoSDurabilityPolicy:
        """Whether late joiners get older messages."""
        return self._durability

    @durability.setter
    def durability(self, value: QoSDurabilityPolicy | int) -> None:
        assert isinstance(value, int)
        self._durability = DurabilityPolicy(value)

    @property
    def lifespan(self) -> Duration:
        """How long after publication a message may be delivered."""
        return self._lifespan

    @lifespan.setter
    def lifespan(self, value: Duration) -> None:
        assert isinstance(value, Duration)
        self._lifespan = value

    @property
    def deadline(self) -> Duration:
        """The longest time between two messages."""
        return self._deadline

    @deadline.setter
    def deadline(self, value: Duration) -> None:
        assert isinstance(value, Duration)
        self._deadline = value

    @property
    def liveliness(self) -> QoSLivelinessPolicy:
        """How a publisher shows that it lives."""
        return self._liveliness

    @liveliness.setter
    def liveliness(self, value: QoSLivelinessPolicy | int) -> None:
        assert isinstance(value, int)
        self._liveliness = LivelinessPolicy(value)

    @property
    def liveliness_lease_duration(self) -> Duration:
        """The longest time between two assertions of liveliness."""
        return self._liveliness_lease_duration

    @liveliness_lease_duration.setter
    def liveliness_lease_duration(self, value: Duration) -> None:
        assert isinstance(value, Duration)
        self._liveliness_lease_duration = value

    @property
    def avoid_ros_namespace_conventions(self) -> bool:
        """Whether the topic's name is passed to the middleware unchanged."""
        return self._avoid_ros_namespace_conventions

    @avoid_ros_namespace_conventions.setter
    def avoid_ros_namespace_conventions(self, value: bool) -> None:
        assert isinstance(value, bool)
        self._avoid_ros_namespace_conventions = value

    def get_c_qos_profile(self) -> _rmw_qos_profile_t:
        """Return the graph's QoS for this profile."""
        return _rmw_qos_profile_t.__new__(
            _rmw_qos_profile_t,
            self._depth,
            graph_qos.History(self._history),
            graph_qos.Reliability(self._reliability),
            graph_qos.Durability(self._durability),
            self._deadline.nanoseconds,
            self._lifespan.nanoseconds,
            graph_qos.Liveliness(self._liveliness),
            self._liveliness_lease_duration.nanoseconds,
            self._avoid_ros_namespace_conventions,
        )

    @classmethod
    def _from_graph(cls, qos: QoS, *, known_history: bool) -> QoSProfile:
        """Return the profile for a QoS of the graph; discovery in DDS does not include history and depth."""
        return cls(
            history=int(qos.history) if known_history else HistoryPolicy.UNKNOWN,
            depth=qos.depth if known_history else 0,
            reliability=int(qos.reliability),
            durability=int(qos.durability),
            lifespan=_discovered(qos.lifespan),
            deadline=_discovered(qos.deadline),
            liveliness=int(qos.liveliness),
            liveliness_lease_duration=_discovered(qos.liveliness_lease_duration),
            avoid_ros_namespace_conventions=qos.avoid_ros_namespace_conventions,
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return False
        return all(getattr(self, name) == getattr(other, name) for name in self._ORDER)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        # str() of the choices is their number on every Python; IntEnum prints names before 3.11.
        values = ((name, getattr(self, name)) for name in self._ORDER)
        shown = (f"{name}={int(value) if isinstance(value, QoSPolicyEnum) else value}" for name, value in values)
        return f"{type(self).__name__}({', '.join(shown)})"


def _discovered(nanoseconds: int) -> Duration:
    return Duration(nanoseconds=nanoseconds or graph_qos.INFINITE_NS)


DeadlineBestAvailable = Duration(nanoseconds=RMW_QOS_DEADLINE_BEST_AVAILABLE)
LivelinessLeaseDurationeBestAvailable = Duration(nanoseconds=RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE)

# rmw/qos_profiles.h, rcl_action/default_qos.h and rcl/logging_rosout.h
qos_profile_unknown = QoSProfile(
    history=HistoryPolicy.UNKNOWN,
    depth=0,
    reliability=ReliabilityPolicy.UNKNOWN,
    durability=DurabilityPolicy.UNKNOWN,
    liveliness=LivelinessPolicy.UNKNOWN,
)
qos_profile_default = QoSProfile(depth=10)
qos_profile_system_default = QoSProfile(
    history=HistoryPolicy.SYSTEM_DEFAULT,
    depth=0,
    reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
    durability=DurabilityPolicy.SYSTEM_DEFAULT,
)
qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(depth=10)
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_best_available = QoSProfile(
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
    deadline=DeadlineBestAvailable,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    liveliness_lease_duration=LivelinessLeaseDurationeBestAvailable,
)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
qos_profile_rosout_default = QoSProfile(
    depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10)
)


class QoSPresetProfiles(Enum):
    """The predefined profiles by name."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available
    ROSOUT_DEFAULT = qos_profile_rosout_default

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the names in lower case, as command lines name them."""
        return [name.lower() for name in cls.__members__ if not name.startswith("RMW")]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile with this name (in any case).

        Raises:
            KeyError: if there is none.
        """
        profile: QoSProfile = cls[name.upper()].value
        return profile


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Return whether endpoints with two profiles would match, and the reason if not certainly so.

    The result is OK, WARNING (a policy is not decided yet, for instance SYSTEM_DEFAULT) or ERROR.
    """
    from rclpy._day6.qos_compatibility import check

    return check(publisher_qos, subscription_qos)


withdraw(__name__)
