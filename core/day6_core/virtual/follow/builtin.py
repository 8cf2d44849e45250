"""Puts functions in the place of Python's own that are written in C, of which programs expect two things more.

A class can keep one, as logging.Formatter does localtime, and it doesn't become a method: a static method doesn't either. And
another process finds it again by its name.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import copyreg
from collections.abc import Callable
from typing import Any


def put(module: Any, **functions: Callable[..., Any]) -> None:
    """Put functions into a module, under their names there."""
    for name, function in functions.items():
        own: Any = function
        own.__module__, own.__name__, own.__qualname__ = module.__name__, name, name
        own.__doc__ = getattr(module, name).__doc__
        setattr(module, name, staticmethod(own))


def is_number(value: object) -> bool:
    """Return whether a value is what C takes as a number of seconds."""
    return isinstance(value, float) or hasattr(value, "__index__")


def _name_of(function: staticmethod[..., Any]) -> str:
    return function.__qualname__


copyreg.pickle(staticmethod, _name_of)
