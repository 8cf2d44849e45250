"""The discovery range, as rcl reads it from the environment (rcl/discovery_options.c).

Only OFF makes a difference here. Other machines are joined by `--listen` and `--connect` alone, so LOCALHOST, SUBNET and
SYSTEM_DEFAULT, ROS_STATIC_PEERS, and the values rcl takes for LOCALHOST with a warning, all mean this machine's processes.
"""

from __future__ import annotations

from collections.abc import Mapping

_VARIABLE = "ROS_AUTOMATIC_DISCOVERY_RANGE"
_RANGES = ("", "OFF", "LOCALHOST", "SUBNET", "SYSTEM_DEFAULT")


def discovery_is_off(environment: Mapping[str, str]) -> bool:
    """Return whether a program must not find any other process; ROS_LOCALHOST_ONLY=1 does not change that."""
    return environment.get(_VARIABLE) == "OFF"


def discovery_warning(environment: Mapping[str, str]) -> str | None:
    """Return the warning of rcl's init about an unknown range, None for a known one. Upper and lower case differ."""
    value = environment.get(_VARIABLE, "")
    if value in _RANGES:
        return None
    return f"Invalid value '{value}' specified for '{_VARIABLE}', assuming localhost only"
