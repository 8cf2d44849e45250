"""Events: things that happen while a launched system runs."""

from __future__ import annotations


class Event:
    """Base of all events; `name` is their name in log messages."""

    name = "launch.Event"
