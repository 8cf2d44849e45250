"""What an endpoint gets where its program left a policy open.

SYSTEM_DEFAULT is Fast DDS's own choice, another one for publishers than for subscriptions (fastdds/dds/publisher/qos and
subscriber/qos). BEST_AVAILABLE is settled once, when the endpoint is made, by the endpoints that are there then
(rmw_dds_common/qos.hpp); one that comes later may not match.
"""

from __future__ import annotations

from collections.abc import Collection

from day6_tui.core.graph.qos import (
    BEST_AVAILABLE_NS,
    DURATION_UNSPECIFIED,
    INFINITE_NS,
    Durability,
    Liveliness,
    QoS,
    Reliability,
)


def settled_for_publisher(qos: QoS, requests: Collection[QoS]) -> QoS:
    """Return the profile of a new publisher; `requests` are those of the topic's subscriptions.

    The best a publisher can offer suits every subscription, so only its limits depend on them.
    """
    reliability, durability, liveliness = qos.reliability, qos.durability, qos.liveliness
    if reliability in (Reliability.SYSTEM_DEFAULT, Reliability.BEST_AVAILABLE):
        reliability = Reliability.RELIABLE
    if durability in (Durability.SYSTEM_DEFAULT, Durability.BEST_AVAILABLE):
        durability = Durability.TRANSIENT_LOCAL
    if liveliness == Liveliness.BEST_AVAILABLE:
        manual = any(each.liveliness == Liveliness.MANUAL_BY_TOPIC for each in requests)
        liveliness = Liveliness.MANUAL_BY_TOPIC if manual else Liveliness.AUTOMATIC
    deadline = min((_limit(each.deadline) for each in requests), default=INFINITE_NS)
    lease = min((_limit(each.liveliness_lease_duration) for each in requests), default=INFINITE_NS)
    return _with(qos, reliability, durability, liveliness, deadline, lease)


def settled_for_subscription(qos: QoS, offers: Collection[QoS]) -> QoS:
    """Return the profile of a new subscription; `offers` are those of the topic's publishers.

    The best available is what all publishers offer: with none of them there, all there is.
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
    deadline = max((_limit(each.deadline) for each in offers), default=INFINITE_NS)
    lease = max((_limit(each.liveliness_lease_duration) for each in offers), default=INFINITE_NS)
    return _with(qos, reliability, durability, liveliness, deadline, lease)


def is_open(qos: QoS) -> bool:
    """Say whether a profile leaves something open that depends on the kind of endpoint or on the other side."""
    return (
        qos.reliability in (Reliability.SYSTEM_DEFAULT, Reliability.BEST_AVAILABLE)
        or qos.durability in (Durability.SYSTEM_DEFAULT, Durability.BEST_AVAILABLE)
        or qos.liveliness == Liveliness.BEST_AVAILABLE
        or BEST_AVAILABLE_NS in (qos.deadline, qos.liveliness_lease_duration)
    )


def _limit(duration: int) -> int:
    return INFINITE_NS if duration == DURATION_UNSPECIFIED else duration


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
