"""The action of the action tutorial, from the package that has it in this distribution, and the field of its feedback."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value

if TYPE_CHECKING:
    from rclpy.node import Node

Fibonacci = import_module(f"{value('action_tutorials.interfaces')}.action").Fibonacci
_FIELD: str = next(iter(Fibonacci.Feedback.get_fields_and_field_types()))


def feedback_of(sequence: list[int]) -> Any:
    """Return the feedback with the numbers so far."""
    return Fibonacci.Feedback(**{_FIELD: sequence})


def numbers_in(feedback: Any) -> Any:
    """Return the numbers of a feedback."""
    return getattr(feedback, _FIELD)


def introspect(node: Node, end: str, made: Any) -> None:
    """Let a parameter of the node decide whether its action server or client publishes events, where the demos have it."""
    if value("action_tutorials.introspection"):
        from day6_core.ros.programs.demo_nodes_cpp.introspection import follow_parameter

        follow_parameter(node, f"action_{end}_configure_introspection", made)
