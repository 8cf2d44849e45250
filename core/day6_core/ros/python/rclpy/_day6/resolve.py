"""Expansion of names, and the exceptions for bad ones."""

from __future__ import annotations

from day6_core.graph import names
from day6_core.graph.names import Flaw
from rclpy._rclpy_pybind11 import RCLError
from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NameValidationException,
)


def raise_for_topic(flaw: Flaw | None, name: str, *, is_service: bool = False) -> None:
    """Raise InvalidTopicNameException or InvalidServiceNameException for a flawed name."""
    if flaw is not None:
        error: type[NameValidationException] = InvalidServiceNameException if is_service else InvalidTopicNameException
        raise error(name, flaw.message, flaw.position)  # type: ignore[call-arg]


def raise_for_node(name: str) -> None:
    """Raise InvalidNodeNameException for a flawed node name."""
    flaw = names.flaw_of_node_name(name)
    if flaw is not None:
        raise InvalidNodeNameException(name, flaw.message, flaw.position)


def raise_for_namespace(namespace: str) -> None:
    """Raise InvalidNamespaceException for a flawed namespace."""
    flaw = names.flaw_of_namespace(namespace)
    if flaw is not None:
        raise InvalidNamespaceException(namespace, flaw.message, flaw.position)


def expand(name: str, node_name: str, namespace: str) -> str:
    """Return the full form of a well-formed name; ValueError with rcl's text for an unknown `{substitution}`."""
    try:
        return names.expand(name, node_name, namespace)
    except names.UnknownSubstitution as error:
        text = f"topic name '{name}' is invalid: {error}, at /project/src/rcl/expand_topic_name.c:164"
    raise ValueError(text)


def require_text(name: object) -> None:
    """Raise RCLError, as rclpy does, for a topic name that is None."""
    if name is None:
        raise RCLError(
            "failed to validate name: topic_name argument is null, at /project/src/rcl/validate_topic_name.c:35"
        )
