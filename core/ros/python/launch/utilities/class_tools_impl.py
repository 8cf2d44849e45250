"""Questions about classes."""

from __future__ import annotations

import inspect
from typing import Any


def isclassinstance(obj: Any) -> bool:
    """Say whether `obj` is an object of a class, as in Python everything is."""
    return hasattr(obj, "__class__")


def is_a(obj: Any, entity_type: type) -> bool:
    """`isinstance`, with a RuntimeError for what is no class."""
    if not inspect.isclass(entity_type):
        raise RuntimeError(f"entity_type '{obj}' is not a class")
    return isinstance(obj, entity_type)


def is_a_subclass(obj: Any, entity_type: type) -> bool:
    """Say whether `obj` is an instance of the class, or itself a class derived from it."""
    return is_a(obj, entity_type) or (inspect.isclass(obj) and issubclass(obj, entity_type))
