"""Resolves the policies that a program left open.

SYSTEM_DEFAULT is Fast DDS's own default, which differs between publishers and subscriptions (fastdds/dds/publisher/qos and
subscriber/qos). BEST_AVAILABLE is resolved once, when the endpoint is created, by the endpoints that exist then
(rmw_dds_common/qos.hpp); a later one may not match.
"""

from __future__ import annotations

from collections.abc import Collection

from day6_core.graph.qos import (
    BEST_AVAILABLE_NS,
    DURATION_UNSPECIFIED,
    INFINITE_NS,
    Durability,
    Liveliness,
    QoS,
    Reliability,
    limit_of,
)


def resolved_for_publisher(qos: QoS, requests: Collection[QoS]) -> QoS:
    """Return the profile of a new publisher; `requests` are the profiles of the topic's subscriptions.

    The best a publisher can offer suits every subscription, so only its durations and liveliness depend on them.
    """
    reliability, durability, liveliness = qos.reliability, qos.durability, qos.liveliness
    if reliability in (Reliability.SYSTEM_DEFAULT, Reliability.BEST_AVAILABLE):
        reliability = Reliability.RELIABLE
    if durability in (Durability.SYSTEM_DEFAULT, Durability.BEST_AVAILABLE):
        durability = Durability.TRANSIENT_LOCAL
    if liveliness == Liveliness.BEST_AVAILABLE:
        manual = any(each.liveliness == Liveliness.MANUAL_BY_TOPIC for each in requests)
        liveliness = Liveliness.MANUAL_BY_TOPIC if manual else Liveliness.AUTOMATIC
    deadline = min((limit_of(each.deadline) for each in requests), default=INFINITE_NS)
    lease = min((limit_of(each.liveliness_lease_duration) for each in requests), default=INFINITE_NS)
    return _with(qos, reliability, durability, liveliness, deadline, lease)


def resolved_for_subscription(qos: QoS, offers: Collection[QoS]) -> QoS:
    """Return the profile of a new subscription; `offers` are the profiles of the topic's publishers.

    The best available is what all publishers offer; without publishers, the highest policies and no limits.
    """
    reliability, durability, liveliness = qos.reliability, qos.durability, qos.liveliness
    if reliability == Reliability.SYSTEM_DEFAULT:
        reliability = Reliability.BEST_EFFORT
    elif reliability == Reliability.BEST_AVAILABLE:
        reliable = all(each.reliability == Reliability.RELIABLE for each in offers)
        reliability = Reliability.RELIABLE if reliable else Reliability.BEST_EFFORT
    if durability == Durability.BEST_AVAILABLE:
        kept = all(each.durability == Durability.TRANSIENT_LOCAL for each in offers)
        durability = Durability.TRANSIENT_LOCAL if kept else Durability.VOLATILE
    if liveliness == Liveliness.BEST_AVAILABLE:
        manual = all(each.liveliness == Liveliness.MANUAL_BY_TOPIC for each in offers)
        liveliness = Liveliness.MANUAL_BY_TOPIC if manual else Liveliness.AUTOMATIC
    deadline = max((limit_of(each.deadline) for each in offers), default=INFINITE_NS)
    lease = max((limit_of(each.liveliness_lease_duration) for each in offers), default=INFINITE_NS)
    return _with(qos, reliability, durability, liveliness, deadline, lease)


def is_open(qos: QoS) -> bool:
    """Return whether a profile leaves a policy open that depends on the kind of endpoint or on the other endpoints."""
    return (
        qos.reliability in (Reliability.SYSTEM_DEFAULT, Reliability.BEST_AVAILABLE)
        or qos.durability in (Durability.SYSTEM_DEFAULT, Durability.BEST_AVAILABLE)
        or qos.liveliness == Liveliness.BEST_AVAILABLE
        or BEST_AVAILABLE_NS in (qos.deadline, qos.liveliness_lease_duration)
    )


def _with(
    qos: QoS, reliability: Reliability, durability: Durability, liveliness: Liveliness, deadline: int, lease: int
) -> QoS:
    changes = qos._replace(reliability=reliability, durability=durability, liveliness=liveliness)
    if qos.deadline == BEST_AVAILABLE_NS:
        changes = changes._replace(deadline=_specified(deadline))
    if qos.liveliness_lease_duration == BEST_AVAILABLE_NS:
        changes = changes._replace(liveliness_lease_duration=_specified(lease))
    return changes


def _specified(limit: int) -> int:
    return DURATION_UNSPECIFIED if limit == INFINITE_NS else limit
