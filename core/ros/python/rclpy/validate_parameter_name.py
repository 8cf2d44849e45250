"""Validation of parameter names."""

from __future__ import annotations

from typing import Literal

from rclpy.exceptions import InvalidParameterException


def validate_parameter_name(name: str) -> Literal[True]:
    """Return True for any name but the empty one; raise InvalidParameterException for that."""
    if not name:
        raise InvalidParameterException(name)
    return True
