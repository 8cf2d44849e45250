"""Which keys drive: every teleop reads its own, and whoever presses others must be told the right ones."""

from __future__ import annotations

from day6_tui.locale import Texts
from day6_tui.terminals.view import tab_name

_KEYS = {
    "turtle_teleop_key": "teleop.arrows",
    "teleop_twist_keyboard": "teleop.twist_keyboard",
    "teleop_keyboard": "teleop.turtlebot3",
}
"""Executable -> the text that names its keys."""


def keys_of(command: str, texts: Texts) -> str:
    """Return what the keys are called that a command reads, in words that begin a sentence."""
    return texts(_KEYS.get(tab_name(command), "teleop.other"))


def is_driven_otherwise(command: str) -> bool:
    """Whether a command is a teleop for which the arrow keys mean nothing."""
    return _KEYS.get(tab_name(command), "teleop.arrows") != "teleop.arrows"
