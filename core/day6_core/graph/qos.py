"""Quality of service: the policies, profiles, and which offers satisfy which requests.

Numbers are those of rmw/qos_policy_kind.h and rmw/types.h; the matching rules those of the DDS specification 1.4,
§2.2.3.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

DURATION_UNSPECIFIED = 0
"""0 ns in a profile means "not specified", which DDS takes as infinite."""
INFINITE_NS = 9223372036854775807
BEST_AVAILABLE_NS = INFINITE_NS - 1
"""RMW_QOS_DEADLINE_BEST_AVAILABLE: the limit of the other side, none of one's own."""

KEEP_ALL_LIMIT = 5000
"""Fast DDS's default resource limit: the messages KEEP_ALL really keeps."""
SYSTEM_DEFAULT = 0
"""The member of every enumeration below that leaves the choice to the middleware."""


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


class Choice(NamedTuple):
    """A policy with a few values."""

    name: str
    kind: PolicyKind
    values: type[IntEnum]
    default: IntEnum
    """What is meant where neither the kind of endpoint nor the other endpoints decide, and where rmw_zenoh writes nothing."""
    publisher: IntEnum | None = None
    subscription: IntEnum | None = None
    """Fast DDS's own defaults."""
    strong: IntEnum | None = None
    weak: tuple[IntEnum, ...] = ()
    """The offers that do not satisfy a request for `strong`."""
    open: tuple[int, ...] = ()
    """The values that the kind of endpoint or the other endpoints decide."""

    @property
    def words(self) -> tuple[str, ...]:
        """The values as command lines and bags name them."""
        return tuple(name.lower() for name in self.values.__members__)

    def refuses(self, offered: int, requested: int) -> bool:
        """Return whether an offer does not satisfy a request."""
        return requested == self.strong and offered in self.weak


class Limit(NamedTuple):
    """A policy that is a duration. `open` as for a Choice."""

    name: str
    kind: PolicyKind
    open: tuple[int, ...] = ()

    def refuses(self, offered: int, requested: int) -> bool:
        """Return whether an offer does not satisfy a request."""
        return limit_of(offered) > limit_of(requested)


class Plain(NamedTuple):
    """A policy that is a number or a truth value."""

    name: str
    values: type[int]


POLICIES: dict[str, Choice | Limit | Plain] = {
    each.name: each
    for each in (
        Choice("history", PolicyKind.HISTORY, History, History.KEEP_LAST),
        Plain("depth", int),
        Choice(
            "reliability",
            PolicyKind.RELIABILITY,
            Reliability,
            default=Reliability.RELIABLE,
            publisher=Reliability.RELIABLE,
            subscription=Reliability.BEST_EFFORT,
            strong=Reliability.RELIABLE,
            weak=(Reliability.BEST_EFFORT,),
            open=(Reliability.SYSTEM_DEFAULT, Reliability.BEST_AVAILABLE),
        ),
        Choice(
            "durability",
            PolicyKind.DURABILITY,
            Durability,
            default=Durability.VOLATILE,
            publisher=Durability.TRANSIENT_LOCAL,
            subscription=Durability.VOLATILE,
            strong=Durability.TRANSIENT_LOCAL,
            weak=(Durability.VOLATILE,),
            open=(Durability.SYSTEM_DEFAULT, Durability.BEST_AVAILABLE),
        ),
        Limit("deadline", PolicyKind.DEADLINE, open=(BEST_AVAILABLE_NS,)),
        Limit("lifespan", PolicyKind.LIFESPAN),
        Choice(
            "liveliness",
            PolicyKind.LIVELINESS,
            Liveliness,
            default=Liveliness.AUTOMATIC,
            publisher=Liveliness.AUTOMATIC,
            subscription=Liveliness.AUTOMATIC,
            strong=Liveliness.MANUAL_BY_TOPIC,
            weak=(Liveliness.AUTOMATIC, Liveliness.UNKNOWN),
            open=(Liveliness.BEST_AVAILABLE,),
        ),
        # In DDS the lease is a part of liveliness.
        Limit("liveliness_lease_duration", PolicyKind.LIVELINESS, open=(BEST_AVAILABLE_NS,)),
        Plain("avoid_ros_namespace_conventions", bool),
    )
}
"""All policies by their names in profiles, in the order of rmw_qos_profile_t."""

CHOICES = tuple(each for each in POLICIES.values() if isinstance(each, Choice))

COMPARED = tuple(each for each in POLICIES.values() if not isinstance(each, Plain) and each.open)
"""The policies of which an offer has to satisfy the request; BEST_AVAILABLE exists for these alone."""


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
        found: dict[str, Any] = {"depth": max(1, self.depth)}
        for each in CHOICES:
            if getattr(self, each.name) in (SYSTEM_DEFAULT, *each.open):
                found[each.name] = each.default
        return self._replace(**found)

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
    return sorted(
        {each.kind for each in COMPARED if each.refuses(getattr(offered, each.name), getattr(requested, each.name))}
    )
