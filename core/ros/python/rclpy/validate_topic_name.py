"""Validation of topic and service names as programs write them."""

from __future__ import annotations

from typing import Literal

from day6_tui.core.graph.names import flaw_of_topic_name
from rclpy._resolve import raise_for_topic

TOPIC_SEPARATOR_STRING = "/"


def validate_topic_name(name: str, *, is_service: bool = False) -> Literal[True]:
    """Return True for a well-formed name, relative ones too; raise InvalidTopicNameException (or …Service…) otherwise."""
    raise_for_topic(flaw_of_topic_name(name), name, is_service=is_service)
    return True
