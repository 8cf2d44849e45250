"""QoS profiles from the options of `topic echo` and `topic pub`."""

from __future__ import annotations

from argparse import Namespace
from copy import deepcopy
from typing import TYPE_CHECKING

from rclpy.duration import Duration
from rclpy.qos import (
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    QoSReliabilityPolicy,
)

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

_OVERRIDES = (
    "qos_reliability",
    "qos_durability",
    "qos_depth",
    "qos_history",
    "qos_liveliness",
    "qos_liveliness_lease_duration_seconds",
)


def profile_from_options(args: Namespace) -> QoSProfile:
    """Return the preset of `--qos-profile`, overridden by the other options."""
    profile = _preset(args)
    if args.qos_history:
        profile.history = QoSHistoryPolicy.get_from_short_key(args.qos_history)
    if args.qos_durability:
        profile.durability = QoSDurabilityPolicy.get_from_short_key(args.qos_durability)
    if args.qos_reliability:
        profile.reliability = QoSReliabilityPolicy.get_from_short_key(args.qos_reliability)
    if args.qos_liveliness:
        profile.liveliness = QoSLivelinessPolicy.get_from_short_key(args.qos_liveliness)
    lease = args.qos_liveliness_lease_duration_seconds
    if lease and lease >= 0:
        profile.liveliness_lease_duration = Duration(seconds=lease)
    if args.qos_depth and args.qos_depth >= 0:
        profile.depth = args.qos_depth
    elif profile.durability == QoSDurabilityPolicy.TRANSIENT_LOCAL and profile.depth == 0:
        profile.depth = 1
    return profile


def profile_for_echo(session: Session, node: Node, args: Namespace) -> QoSProfile:
    """Return the profile that `topic echo` subscribes with: the options', else one adapted to the present publishers."""
    if any(getattr(args, option) is not None for option in _OVERRIDES):
        return profile_from_options(args)
    profile = _preset(args)
    offered = [info.qos_profile for info in node.get_publishers_info_by_topic(args.topic_name)]
    if not offered:
        return profile
    reliable = [each for each in offered if each.reliability == QoSReliabilityPolicy.RELIABLE]
    latched = [each for each in offered if each.durability == QoSDurabilityPolicy.TRANSIENT_LOCAL]
    profile.reliability = QoSReliabilityPolicy.RELIABLE
    if len(reliable) < len(offered):
        profile.reliability = QoSReliabilityPolicy.BEST_EFFORT
        if reliable:
            session.print(_fallback("QoSReliabilityPolicy", "RELIABLE", "BEST_EFFORT"))
    profile.durability = QoSDurabilityPolicy.TRANSIENT_LOCAL
    if len(latched) < len(offered):
        profile.durability = QoSDurabilityPolicy.VOLATILE
        if latched:
            session.print(_fallback("QoSDurabilityPolicy", "TRANSIENT_LOCAL", "VOLATILE"))
    return profile


def _preset(args: Namespace) -> QoSProfile:
    # A copy: the presets belong to the whole process.
    return deepcopy(QoSPresetProfiles.get_from_short_key(args.qos_profile))


def _fallback(policy: str, offered: str, taken: str) -> str:
    return (
        f"Some, but not all, publishers are offering {policy}.{offered}. "
        f"Falling back to {policy}.{taken} as it will connect to all publishers"
    )
