"""Type checks of arguments."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any


def ensure_argument_type(argument: Any, types: Any, argument_name: str, caller: str | None = None) -> None:
    """Raise TypeError, with the argument's and the caller's name, unless the value has one of the types."""
    allowed = list(types) if isinstance(types, Iterable) else [types]
    if any(isinstance(argument, each) for each in allowed):
        return
    start = "E" if caller is None else f"'{caller}' e"
    names = ", ".join(map(str, allowed))
    raise TypeError(
        f"{start}xpected '{argument_name}' to be one of [{names}], but got '{argument}' of type '{type(argument)}'"
    )
