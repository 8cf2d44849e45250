"""Validation of node names."""

from __future__ import annotations

from typing import Literal

from rclpy._resolve import raise_for_node


def validate_node_name(node_name: str) -> Literal[True]:
    """Return True for a node name without namespace; raise InvalidNodeNameException otherwise."""
    raise_for_node(node_name)
    return True
