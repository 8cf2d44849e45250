"""Takes the names away that rclpy has in newer distributions only, so that a program meets the same AttributeError as there.

Only in processes of users: our own programs are written on the newest rclpy, whatever distribution they stand in.
"""

from __future__ import annotations

import os
import sys
from typing import Any

from day6_core.ros.differences import lacking

_PYTHON = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
"""Where the packages are that programs import."""

_OURS = os.path.dirname(os.path.realpath(_PYTHON))


def withdraw(module: str) -> None:
    """Delete what a module of rclpy, which has just been defined, lacks in this distribution."""
    names = lacking(module)
    if not names or not _is_a_users():
        return
    for name in names:
        owner, _, attribute = name.rpartition(".")
        place: Any = getattr(sys.modules[module], owner) if owner else sys.modules[module]
        if attribute in vars(place):
            delattr(place, attribute)
        else:
            setattr(place, attribute, _Absent(attribute))


class _Absent:
    """Stands on a class for what it must not inherit."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __get__(self, instance: object, owner: type) -> Any:
        what = f"type object '{owner.__name__}'" if instance is None else f"'{owner.__name__}' object"
        raise AttributeError(f"{what} has no attribute '{self._name}'")


def _is_a_users() -> bool:
    """Whether a user's program runs here: it has the `day6_core` beside rclpy, and is none of our own files."""
    started = os.path.realpath(getattr(sys.modules["__main__"], "__file__", None) or "")
    beside = os.path.join(_PYTHON, "day6_core", "__init__.py")
    return getattr(sys.modules.get("day6_core"), "__file__", None) == beside and not started.startswith(_OURS + os.sep)
