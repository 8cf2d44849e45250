"""The decorator that launches a test once for each of several values."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator
from typing import Any


def parametrize(argnames: str, argvalues: Iterable[Any]) -> Callable[[Callable[..., Any]], Callable[[], Iterator[Any]]]:
    """Decorate a `generate_test_description` so that it is launched, and tested, with each of the values.

    `argnames` is a list of names with commas; each of the `argvalues` is a value, or a tuple with one value for each name. Tests
    get them by the same names. What the decorated function yields are pairs `(description function, {name: value})`.
    """
    names = [name.strip() for name in argnames.split(",") if name.strip()]
    rows = [row if isinstance(row, tuple) else (row,) for row in argvalues]

    def decorate(function: Callable[..., Any]) -> Callable[[], Iterator[Any]]:
        @functools.wraps(function)
        def each() -> Iterator[Any]:
            for row in rows:
                arguments = dict(zip(names, row, strict=False))
                yield functools.update_wrapper(functools.partial(function, **arguments), function), arguments

        each.__parametrized__ = True  # type: ignore[attr-defined]
        return each

    return decorate
