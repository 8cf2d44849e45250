"""Validation of parameter names."""

from rclpy.exceptions import InvalidParameterException


def validate_parameter_name(name: str) -> bool:
    """Return True; raise InvalidParameterException for an empty name. Everything else is allowed."""
    if not name:
        raise InvalidParameterException(name)
    return True
