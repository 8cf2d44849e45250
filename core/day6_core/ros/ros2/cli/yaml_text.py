"""Reads the YAML of a command line or a file without blocking other programs."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from typing import TextIO

_Result = TypeVar("_Result")

SHORT = 1000
"""Characters that are read at once; longer texts may take seconds (PyYAML takes five for 100,000 `[`)."""


def load(text: str | bytes | TextIO, abandoned: threading.Event) -> Any:
    """Like `yaml.safe_load`, but stops once `abandoned` is set. Raises yaml.YAMLError, RecursionError."""
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
    """Run `read` in its own thread; its event is set when Ctrl-C has ended the command."""
    abandoned = threading.Event()
    try:
        return await in_thread(lambda: read(abandoned))
    finally:
        abandoned.set()


async def safe_load(text: str | bytes) -> Any:
    """Return the value of a YAML text. Raises yaml.YAMLError, RecursionError."""
    if len(text) <= SHORT:
        return load(text, threading.Event())
    return await in_turns_with_others(lambda abandoned: load(text, abandoned))
