"""Which machines a program looks for, as rcl reads it from the environment (rcl/discovery_options.c).

Only one answer means anything here: nobody at all. Other machines come by `--listen` and `--connect` alone, so LOCALHOST, SUBNET
and SYSTEM_DEFAULT, ROS_STATIC_PEERS, and what rcl takes for LOCALHOST with a warning, are all this machine's processes.
"""

from __future__ import annotations

from collections.abc import Mapping

_VARIABLE = "ROS_AUTOMATIC_DISCOVERY_RANGE"
_RANGES = ("", "OFF", "LOCALHOST", "SUBNET", "SYSTEM_DEFAULT")


def wants_to_be_alone(environment: Mapping[str, str]) -> bool:
    """Say whether no other process is to be met at all; ROS_LOCALHOST_ONLY=1 does not change that."""
    return environment.get(_VARIABLE) == "OFF"


def discovery_warning(environment: Mapping[str, str]) -> str | None:
    """Return what rcl's init warns of: a range that it does not know. Upper and lower case are different to it."""
    value = environment.get(_VARIABLE, "")
    if value in _RANGES:
        return None
    return f"Invalid value '{value}' specified for '{_VARIABLE}', assuming localhost only"
