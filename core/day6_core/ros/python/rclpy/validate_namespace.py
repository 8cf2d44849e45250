"""Validation of namespaces."""

from rclpy._day6.incidental import also
from rclpy._day6.resolve import raise_for_namespace

__getattr__ = also(__name__, "InvalidNamespaceException")


def validate_namespace(namespace: str) -> bool:
    """Return True; raise InvalidNamespaceException for a bad namespace."""
    raise_for_namespace(namespace)
    return True
