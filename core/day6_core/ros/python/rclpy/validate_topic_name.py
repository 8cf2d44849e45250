"""Validation of topic and service names as programs write them."""

from day6_core.graph import names
from rclpy._day6.incidental import also
from rclpy._day6.resolve import raise_for_topic

__getattr__ = also(__name__, "InvalidServiceNameException InvalidTopicNameException")


TOPIC_SEPARATOR_STRING = "/"


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True; raise InvalidTopicNameException (InvalidServiceNameException for services) for a bad name."""
    raise_for_topic(names.flaw_of_topic_name(name), name, is_service=is_service)
    return True
