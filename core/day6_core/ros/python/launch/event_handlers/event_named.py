"""Matches events by name."""

from __future__ import annotations

from collections.abc import Callable

from launch.event import Event


def event_named(name: str) -> Callable[[Event], bool]:
    """Return a matcher for events with that name."""
    return lambda event: event.name == name
