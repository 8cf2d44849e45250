"""What packages above rclpy tell the inspector of a node, for as long as they are imported (`rclpy._day6.signs` asks them)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

sources: dict[str, Callable[[Any], Iterator[dict[str, Any]]]] = {}
"""A kind of sign, and what yields the values of each sign of that kind of an rclpy node."""
