"""Validation of node names."""

from rclpy._day6.incidental import also
from rclpy._day6.resolve import raise_for_node

__getattr__ = also(__name__, "InvalidNodeNameException")


def validate_node_name(node_name: str) -> bool:
    """Return True; raise InvalidNodeNameException for a bad name."""
    raise_for_node(node_name)
    return True
