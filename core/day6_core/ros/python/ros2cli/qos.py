"""QoS profiles from the words of a command line."""

from __future__ import annotations

from argparse import ArgumentParser

from day6_core.ros.ros2.cli.options import add_qos_options
from day6_core.ros.ros2.cli.qos import overridden, preset
from rclpy.qos import QoSProfile


def profile_configure_short_keys(
    profile: QoSProfile,
    reliability: str | None = None,
    durability: str | None = None,
    depth: int | None = None,
    history: str | None = None,
    liveliness: str | None = None,
    liveliness_lease_duration_s: float | None = None,
) -> QoSProfile:
    """Override policies of a profile by their words, and return it."""
    words = {"reliability": reliability, "durability": durability, "history": history, "liveliness": liveliness}
    return overridden(profile, words, depth, liveliness_lease_duration_s)


def qos_profile_from_short_keys(
    preset_profile: str,
    reliability: str | None = None,
    durability: str | None = None,
    depth: int | None = None,
    history: str | None = None,
    liveliness: str | None = None,
    liveliness_lease_duration_s: float | None = None,
) -> QoSProfile:
    """Return a preset profile by its word, with policies overridden."""
    profile = preset(preset_profile)
    return profile_configure_short_keys(
        profile, reliability, durability, depth, history, liveliness, liveliness_lease_duration_s
    )


def add_qos_arguments(
    parser: ArgumentParser, subscribe_or_publish: str, default_profile_str: str = "sensor_data", extra_message: str = ""
) -> None:
    """Add the options."""
    add_qos_options(parser, subscribe_or_publish, default_profile_str)
