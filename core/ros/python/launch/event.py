"""Events: what happens while a launched system runs."""

from __future__ import annotations


class Event:
    """Base of all events; `name` is what log messages call them."""

    name = "launch.Event"
