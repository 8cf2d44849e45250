"""Resolves the policies that a program left open.

SYSTEM_DEFAULT is Fast DDS's own default, which differs between publishers and subscriptions (fastdds/dds/publisher/qos and
subscriber/qos). BEST_AVAILABLE is resolved once, when the endpoint is created, by the endpoints that exist then
(rmw_dds_common/qos.hpp); a later one may not match.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from typing import Any

from day6_core.graph.qos import (
    COMPARED,
    DURATION_UNSPECIFIED,
    INFINITE_NS,
    SYSTEM_DEFAULT,
    Choice,
    Limit,
    QoS,
    limit_of,
)


def resolved_for_publisher(qos: QoS, requests: Collection[QoS]) -> QoS:
    """Return the profile of a new publisher; `requests` are the profiles of the topic's subscriptions.

    The best a publisher can offer suits every subscription, so only its durations and liveliness depend on them.
    """
    return _resolved(qos, requests, lambda choice: choice.publisher, any, min)


def resolved_for_subscription(qos: QoS, offers: Collection[QoS]) -> QoS:
    """Return the profile of a new subscription; `offers` are the profiles of the topic's publishers.

    The best available is what all publishers offer; without publishers, the highest policies and no limits.
    """
    return _resolved(qos, offers, lambda choice: choice.subscription, all, max)


def is_open(qos: QoS) -> bool:
    """Return whether a profile leaves a policy open that depends on the kind of endpoint or on the other endpoints."""
    return any(getattr(qos, each.name) in each.open for each in COMPARED)


def _resolved(
    qos: QoS,
    others: Collection[QoS],
    own: Callable[[Choice], object],
    is_strong: Callable[[Iterable[bool]], bool],
    limit: Callable[[Iterable[int]], int],
) -> QoS:
    """Resolve by the endpoint's own defaults, and by whether any or all others are strong and their least or greatest limit."""
    found: dict[str, Any] = {}
    for policy in COMPARED:
        value = getattr(qos, policy.name)
        if value not in policy.open:
            continue
        theirs = [getattr(each, policy.name) for each in others]
        if isinstance(policy, Limit):
            strictest = limit(map(limit_of, theirs)) if theirs else INFINITE_NS
            found[policy.name] = DURATION_UNSPECIFIED if strictest == INFINITE_NS else strictest
        elif value != SYSTEM_DEFAULT and is_strong(each == policy.strong for each in theirs):
            found[policy.name] = policy.strong
        else:
            found[policy.name] = own(policy)
    return qos._replace(**found)
