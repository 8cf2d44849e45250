"""Whether this thread is inside a callback of Zenoh's.

Python collects garbage on any thread, and what it collects may undeclare something: a node that nobody holds any more,
say. Inside a callback that would wait for itself for ever.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any


class _Mark(threading.local):
    here = False


_mark = _Mark()


def inside_callback() -> bool:
    """Say whether Zenoh is calling, further up on this thread's stack."""
    return _mark.here


def callback(function: Callable[..., None]) -> Callable[..., None]:
    """Return `function` for handing to Zenoh."""

    def call(*arguments: Any) -> None:
        _mark.here = True
        try:
            function(*arguments)
        finally:
            _mark.here = False

    return call
