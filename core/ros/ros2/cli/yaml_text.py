"""Reads the YAML of a command line or a file without keeping other programs waiting."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from day6_tui.core.session.threads import in_thread

if TYPE_CHECKING:
    from typing import TextIO

_Result = TypeVar("_Result")

SHORT = 1000
"""Characters that are read at once; what is longer may take seconds (PyYAML reads 100,000 `[` for five)."""


def load(text: str | bytes | TextIO, abandoned: threading.Event) -> Any:
    """As `yaml.safe_load`, until nobody wants the answer any more. Raises yaml.YAMLError, RecursionError."""
    import yaml

    class Loader(yaml.SafeLoader):
        def fetch_more_tokens(self) -> Any:
            if abandoned.is_set():
                raise KeyboardInterrupt
            return super().fetch_more_tokens()

    loader = Loader(text)
    try:
        return loader.get_single_data()
    finally:
        loader.dispose()


async def in_turns_with_others(read: Callable[[threading.Event], _Result]) -> _Result:
    """Run what reads YAML in a thread of its own; it is told when Ctrl-C has ended its command."""
    abandoned = threading.Event()
    try:
        return await in_thread(lambda: read(abandoned))
    finally:
        abandoned.set()


async def safe_load(text: str | bytes) -> Any:
    """What a YAML text says. Raises yaml.YAMLError, RecursionError."""
    if len(text) <= SHORT:
        return load(text, threading.Event())
    return await in_turns_with_others(lambda abandoned: load(text, abandoned))
