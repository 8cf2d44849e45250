"""Properties of a program's callbacks, found without importing `inspect` for plain functions and methods."""

from __future__ import annotations

from types import FunctionType, MethodType
from typing import Any

_CO_VARARGS = 0x04
_CO_COROUTINE = 0x80


def is_coroutine_function(function: Any) -> bool:
    """Return what `inspect.iscoroutinefunction` returns."""
    plain = function.__func__ if isinstance(function, MethodType) else function
    if isinstance(plain, FunctionType):
        return bool(plain.__code__.co_flags & _CO_COROUTINE)
    import inspect

    return inspect.iscoroutinefunction(function)


def lacks_self(function: Any) -> bool:
    """Return whether this is a method that takes no argument at all, not even `self`; `inspect.signature` refuses it."""
    plain = function.__func__ if isinstance(function, MethodType) else None
    return (
        isinstance(plain, FunctionType)
        and plain.__code__.co_argcount == 0
        and not plain.__code__.co_flags & _CO_VARARGS
    )


def accepts(function: Any, arguments: int) -> bool:
    """Return whether a function can be called with that many positional arguments.

    As `inspect.signature` does, it raises ValueError for built-in functions without a signature and for a method without `self`.
    """
    bound = isinstance(function, MethodType)
    plain = function.__func__ if bound else function
    if isinstance(plain, FunctionType) and not hasattr(plain, "__wrapped__") and not lacks_self(function):
        code = plain.__code__
        given = arguments + bound
        if given > code.co_argcount and not code.co_flags & _CO_VARARGS:
            return False
        if given < code.co_argcount - len(plain.__defaults__ or ()):
            return False
        required = code.co_varnames[code.co_argcount : code.co_argcount + code.co_kwonlyargcount]
        return set(required) <= set(plain.__kwdefaults__ or ())
    import inspect

    try:
        inspect.signature(function).bind(*[None] * arguments)
    except TypeError:
        return False
    except ValueError:
        if function is print:  # has a signature from Python 3.11 on, and is a favourite first callback
            return True
        raise
    return True
