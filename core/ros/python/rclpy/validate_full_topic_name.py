"""Validation of topic and service names after expansion."""

from __future__ import annotations

from typing import Literal

from day6_tui.core.graph.names import flaw_of_full_topic_name
from rclpy._resolve import raise_for_topic


def validate_full_topic_name(name: str, *, is_service: bool = False) -> Literal[True]:
    """Return True for a full name; raise InvalidTopicNameException (or InvalidServiceNameException) otherwise."""
    raise_for_topic(flaw_of_full_topic_name(name), name, is_service=is_service)
    return True
