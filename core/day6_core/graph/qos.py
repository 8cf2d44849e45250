"""Quality of service: the policies, profiles, and which offers satisfy which requests.

Numbers are those of rmw/qos_policy_kind.h and rmw/types.h; the matching rules those of the DDS specification 1.4,
§2.2.3.
"""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

DURATION_UNSPECIFIED = 0
"""0 ns in a profile means "not specified", which DDS takes as infinite."""
INFINITE_NS = 9223372036854775807
BEST_AVAILABLE_NS = INFINITE_NS - 1
"""RMW_QOS_DEADLINE_BEST_AVAILABLE: the limit of the other side, none of one's own."""

KEEP_ALL_LIMIT = 5000
"""Fast DDS's default resource limit: the messages KEEP_ALL really keeps."""


class Reliability(IntEnum):
    """rmw_qos_reliability_policy_t."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class Durability(IntEnum):
    """rmw_qos_durability_policy_t."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class History(IntEnum):
    """rmw_qos_history_policy_t."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class Liveliness(IntEnum):
    """rmw_qos_liveliness_policy_t."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


class PolicyKind(IntEnum):
    """rmw_qos_policy_kind_t: the name of a policy, as incompatible-QoS events carry it."""

    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64
    DEPTH = 128
    LIVELINESS_LEASE_DURATION = 256
    AVOID_ROS_NAMESPACE_CONVENTIONS = 512


class QoS(NamedTuple):
    """One endpoint's profile. Durations are nanoseconds, 0 means infinite."""

    depth: int = 10
    history: History = History.KEEP_LAST
    reliability: Reliability = Reliability.RELIABLE
    durability: Durability = Durability.VOLATILE
    deadline: int = DURATION_UNSPECIFIED
    lifespan: int = DURATION_UNSPECIFIED
    liveliness: Liveliness = Liveliness.SYSTEM_DEFAULT
    liveliness_lease_duration: int = DURATION_UNSPECIFIED
    avoid_ros_namespace_conventions: bool = False

    def resolved(self) -> QoS:
        """Return the profile with every open policy resolved, independent of the kind of endpoint.

        For publishers and subscriptions the kind matters: `open_policies` is applied first.
        """
        reliable = self.reliability in (Reliability.SYSTEM_DEFAULT, Reliability.BEST_AVAILABLE)
        volatile = self.durability in (Durability.SYSTEM_DEFAULT, Durability.BEST_AVAILABLE)
        automatic = self.liveliness in (Liveliness.SYSTEM_DEFAULT, Liveliness.BEST_AVAILABLE)
        return self._replace(
            history=History.KEEP_LAST if self.history == History.SYSTEM_DEFAULT else self.history,
            depth=self.depth if self.depth > 0 else 1,
            reliability=Reliability.RELIABLE if reliable else self.reliability,
            durability=Durability.VOLATILE if volatile else self.durability,
            liveliness=Liveliness.AUTOMATIC if automatic else self.liveliness,
        )

    @property
    def capacity(self) -> int:
        """The number of messages in a queue or cache with this profile; the oldest is dropped first."""
        return KEEP_ALL_LIMIT if self.history == History.KEEP_ALL else max(1, self.depth)


def is_finite(duration: int) -> bool:
    """Return whether a duration (ns) of a profile is a finite limit."""
    return DURATION_UNSPECIFIED < duration < BEST_AVAILABLE_NS


def limit_of(duration: int) -> int:
    """Return a profile's duration as a limit in nanoseconds: INFINITE_NS if it is not specified."""
    return INFINITE_NS if duration == DURATION_UNSPECIFIED else duration


def incompatible_policies(offered: QoS, requested: QoS) -> list[PolicyKind]:
    """Return the policies of a publisher's offer that do not satisfy a subscription's request (empty: they match).

    Both profiles must be resolved. The last one is the "last policy kind" of the event.
    """
    found: list[PolicyKind] = []
    if requested.durability == Durability.TRANSIENT_LOCAL and offered.durability == Durability.VOLATILE:
        found.append(PolicyKind.DURABILITY)
    if limit_of(offered.deadline) > limit_of(requested.deadline):
        found.append(PolicyKind.DEADLINE)
    manual_wanted = requested.liveliness == Liveliness.MANUAL_BY_TOPIC
    lease_too_long = limit_of(offered.liveliness_lease_duration) > limit_of(requested.liveliness_lease_duration)
    if (manual_wanted and offered.liveliness != Liveliness.MANUAL_BY_TOPIC) or lease_too_long:
        found.append(PolicyKind.LIVELINESS)
    if requested.reliability == Reliability.RELIABLE and offered.reliability == Reliability.BEST_EFFORT:
        found.append(PolicyKind.RELIABILITY)
    return found
