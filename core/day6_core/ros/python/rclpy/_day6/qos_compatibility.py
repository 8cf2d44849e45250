"""Compatibility of two QoS profiles, with the results and texts of rmw_dds_common."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rclpy._rclpy_pybind11 import QoSCompatibility
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, ReliabilityPolicy

if TYPE_CHECKING:
    from rclpy.qos import QoSPolicyEnum, QoSProfile

_OPEN = ("SYSTEM_DEFAULT", "UNKNOWN")


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
    if (
        publisher.reliability == ReliabilityPolicy.BEST_EFFORT
        and subscription.reliability == ReliabilityPolicy.RELIABLE
    ):
        yield "Best effort publisher and reliable subscription"
    volatile = publisher.durability == DurabilityPolicy.VOLATILE
    if volatile and subscription.durability == DurabilityPolicy.TRANSIENT_LOCAL:
        yield "Volatile publisher and transient local subscription"
    offered, wanted = publisher.deadline.nanoseconds, subscription.deadline.nanoseconds
    if wanted and not offered:
        yield "Subscription has a deadline, but publisher does not"
    elif wanted and wanted < offered:
        yield "Subscription deadline is less than publisher deadline"
    automatic = publisher.liveliness == LivelinessPolicy.AUTOMATIC
    if automatic and subscription.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC:
        yield "Publisher's liveliness is automatic and subscription's is manual by topic"
    offered = publisher.liveliness_lease_duration.nanoseconds
    wanted = subscription.liveliness_lease_duration.nanoseconds
    if wanted and not offered:
        yield "Subscription has a liveliness lease duration, but publisher does not"
    elif wanted and wanted < offered:
        yield "Subscription liveliness lease duration is less than publisher"


def _warnings(publisher: QoSProfile, subscription: QoSProfile) -> Iterator[str]:
    # Per policy: the weaker offer, the stronger request, and the texts for a side whose policy is still open.
    # "durabilty" is how real ROS spells it.
    yield from _open(
        publisher.reliability,
        subscription.reliability,
        "BEST_EFFORT",
        "RELIABLE",
        "Publisher reliability is {} and subscription reliability is {}",
        "Best effort publisher, but subscription is {}",
        "Reliable subscription, but publisher is {}",
    )
    yield from _open(
        publisher.durability,
        subscription.durability,
        "VOLATILE",
        "TRANSIENT_LOCAL",
        "Publisher durabilty is {} and subscription durability is {}",
        "Volatile publisher, but subscription is {}",
        "Transient local subscription, but publisher is {}",
    )
    yield from _open(
        publisher.liveliness,
        subscription.liveliness,
        "AUTOMATIC",
        "MANUAL_BY_TOPIC",
        "Publisher liveliness is {} and subscription liveliness is {}",
        "Publisher's liveliness is automatic, but subscription's is {}",
        "Subscription's liveliness is manual by topic, but publisher's is {}",
    )


def _open(
    offered: QoSPolicyEnum,
    requested: QoSPolicyEnum,
    weak: str,
    strong: str,
    both_open: str,
    weak_offered: str,
    strong_requested: str,
) -> Iterator[str]:
    if offered.name in _OPEN and requested.name in _OPEN:
        yield both_open.format(offered.short_key, requested.short_key)
    elif offered.name == weak and requested.name in _OPEN:
        yield weak_offered.format(requested.short_key)
    elif offered.name in _OPEN and requested.name == strong:
        yield strong_requested.format(offered.short_key)
