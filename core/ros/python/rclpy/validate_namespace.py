"""Validation of namespaces."""

from rclpy._resolve import raise_for_namespace


def validate_namespace(namespace: str) -> bool:
    """Return True; raise InvalidNamespaceException for a bad namespace."""
    raise_for_namespace(namespace)
    return True
