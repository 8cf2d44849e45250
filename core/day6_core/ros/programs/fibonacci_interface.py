"""The action of the action tutorial, from the package that has it in this distribution, and the field of its feedback."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from day6_core.ros.differences import value

Fibonacci = import_module(f"{value('action_tutorials.interfaces')}.action").Fibonacci
_FIELD: str = next(iter(Fibonacci.Feedback.get_fields_and_field_types()))


def feedback_of(sequence: list[int]) -> Any:
    """Return the feedback with the numbers so far."""
    return Fibonacci.Feedback(**{_FIELD: sequence})


def numbers_in(feedback: Any) -> Any:
    """Return the numbers of a feedback."""
    return getattr(feedback, _FIELD)
