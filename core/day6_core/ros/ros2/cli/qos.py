"""QoS profiles from the options of `topic echo` and `topic pub`."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Mapping
from copy import deepcopy
from typing import TYPE_CHECKING

from day6_core.graph.qos import CHOICES
from day6_core.ros.differences import lacking_options
from rclpy.duration import Duration
from rclpy.qos import QoSDurabilityPolicy, QoSPresetProfiles, QoSProfile, QoSReliabilityPolicy

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

_OVERRIDES = ("qos_depth", "qos_liveliness_lease_duration_seconds", *(f"qos_{policy.name}" for policy in CHOICES))


def profile_from_options(args: Namespace) -> QoSProfile:
    """Return the preset of `--qos-profile`, overridden by the other options."""
    words = {policy.name: getattr(args, f"qos_{policy.name}") for policy in CHOICES}
    return overridden(preset(args.qos_profile), words, args.qos_depth, args.qos_liveliness_lease_duration_seconds)


def overridden(
    profile: QoSProfile, words: Mapping[str, str | None], depth: int | None, lease_seconds: float | None
) -> QoSProfile:
    """Set what is given in a profile: policies by the words of their values, the depth, the lease; returns the profile."""
    for policy in CHOICES:
        if word := words.get(policy.name):
            setattr(profile, policy.name, int(policy.values[word.upper()]))
    if lease_seconds and lease_seconds >= 0:
        profile.liveliness_lease_duration = Duration(seconds=lease_seconds)
    if depth and depth >= 0:
        profile.depth = depth
    elif profile.durability == QoSDurabilityPolicy.TRANSIENT_LOCAL and profile.depth == 0:
        profile.depth = 1
    return profile


def profile_for_measuring(session: Session, node: Node, args: Namespace, topic: str) -> QoSProfile:
    """Return the profile that `topic hz`, `bw` and `delay` subscribe with; before their options came it was always the same."""
    if lacking_options("topic hz"):
        return preset("sensor_data")
    return profile_for_echo(session, node, args, topic)


def profile_for_echo(session: Session, node: Node, args: Namespace, topic: str) -> QoSProfile:
    """Return the profile that `topic echo` subscribes with: the options', else one adapted to the present publishers."""
    if any(getattr(args, option) is not None for option in _OVERRIDES):
        return profile_from_options(args)
    profile = preset(args.qos_profile)
    offered = [info.qos_profile for info in node.get_publishers_info_by_topic(topic)]
    if not offered:
        return profile
    for name, strong, weak in (
        ("reliability", QoSReliabilityPolicy.RELIABLE, QoSReliabilityPolicy.BEST_EFFORT),
        ("durability", QoSDurabilityPolicy.TRANSIENT_LOCAL, QoSDurabilityPolicy.VOLATILE),
    ):
        count = sum(getattr(each, name) == strong for each in offered)
        setattr(profile, name, strong if count == len(offered) else weak)
        if 0 < count < len(offered):
            session.print(_fallback(f"QoS{type(strong).__name__}", strong.name, weak.name))
    return profile


def preset(word: str) -> QoSProfile:
    """Return a preset profile by its word: a copy, for the presets belong to the whole process."""
    return deepcopy(QoSPresetProfiles.get_from_short_key(word))


def _fallback(policy: str, offered: str, taken: str) -> str:
    return (
        f"Some, but not all, publishers are offering {policy}.{offered}. "
        f"Falling back to {policy}.{taken} as it will connect to all publishers"
    )
