"""Validation of namespaces."""

from __future__ import annotations

from typing import Literal

from rclpy._resolve import raise_for_namespace


def validate_namespace(namespace: str) -> Literal[True]:
    """Return True for an absolute namespace; raise InvalidNamespaceException otherwise."""
    raise_for_namespace(namespace)
    return True
