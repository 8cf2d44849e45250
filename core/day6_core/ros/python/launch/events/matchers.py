"""Matchers for events that concern one action."""

from __future__ import annotations

from collections.abc import Callable

from launch.action import Action


def matches_action(target_action: Action) -> Callable[[Action], bool]:
    """Return a function that is true for this action."""
    return lambda action: action == target_action
