"""Compatibility of two QoS profiles, with the results and texts of rmw_dds_common."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from day6_core.graph.qos import COMPARED, Choice
from rclpy._rclpy_pybind11 import QoSCompatibility

if TYPE_CHECKING:
    from rclpy.qos import QoSProfile

_OPEN = ("SYSTEM_DEFAULT", "UNKNOWN")


class _ChoiceTexts(NamedTuple):
    """What is said of a weak offer to a strong request, and where a policy is still open."""

    refused: str
    both_open: str
    weak_offered: str
    strong_requested: str


class _LimitTexts(NamedTuple):
    """What is said of an offer without a limit, and of one with a greater limit than requested."""

    unlimited: str
    greater: str


# "durabilty" is how real ROS spells it.
_CHOICES = {
    "reliability": _ChoiceTexts(
        "Best effort publisher and reliable subscription",
        "Publisher reliability is {} and subscription reliability is {}",
        "Best effort publisher, but subscription is {}",
        "Reliable subscription, but publisher is {}",
    ),
    "durability": _ChoiceTexts(
        "Volatile publisher and transient local subscription",
        "Publisher durabilty is {} and subscription durability is {}",
        "Volatile publisher, but subscription is {}",
        "Transient local subscription, but publisher is {}",
    ),
    "liveliness": _ChoiceTexts(
        "Publisher's liveliness is automatic and subscription's is manual by topic",
        "Publisher liveliness is {} and subscription liveliness is {}",
        "Publisher's liveliness is automatic, but subscription's is {}",
        "Subscription's liveliness is manual by topic, but publisher's is {}",
    ),
}
_LIMITS = {
    "deadline": _LimitTexts(
        "Subscription has a deadline, but publisher does not", "Subscription deadline is less than publisher deadline"
    ),
    "liveliness_lease_duration": _LimitTexts(
        "Subscription has a liveliness lease duration, but publisher does not",
        "Subscription liveliness lease duration is less than publisher",
    ),
}


def check(publisher: QoSProfile, subscription: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Return OK, WARNING or ERROR and all reasons of that severity in one line."""
    errors = list(_errors(publisher, subscription))
    if errors:
        return QoSCompatibility.ERROR, "".join(f"ERROR: {text};" for text in errors)
    warnings = list(_warnings(publisher, subscription))
    if warnings:
        return QoSCompatibility.WARNING, "".join(f"WARNING: {text};" for text in warnings)
    return QoSCompatibility.OK, ""


def _errors(publisher: QoSProfile, subscription: QoSProfile) -> Iterator[str]:
    for policy in COMPARED:
        offered, requested = getattr(publisher, policy.name), getattr(subscription, policy.name)
        if isinstance(policy, Choice):
            if offered.name not in _OPEN and policy.refuses(offered, requested):
                yield _CHOICES[policy.name].refused
        elif requested.nanoseconds and not offered.nanoseconds:
            yield _LIMITS[policy.name].unlimited
        elif requested.nanoseconds and requested < offered:
            yield _LIMITS[policy.name].greater


def _warnings(publisher: QoSProfile, subscription: QoSProfile) -> Iterator[str]:
    for policy in COMPARED:
        if not isinstance(policy, Choice):
            continue
        offered, requested = getattr(publisher, policy.name), getattr(subscription, policy.name)
        texts = _CHOICES[policy.name]
        if offered.name in _OPEN and requested.name in _OPEN:
            yield texts.both_open.format(offered.short_key, requested.short_key)
        elif offered in policy.weak and requested.name in _OPEN:
            yield texts.weak_offered.format(requested.short_key)
        elif offered.name in _OPEN and requested == policy.strong:
            yield texts.strong_requested.format(offered.short_key)
