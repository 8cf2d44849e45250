"""Whether this thread is inside a Zenoh callback.

Python collects garbage on any thread, and that may undeclare something: a node nobody references any more, say. Inside a
callback this would deadlock.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any


class _CallbackState(threading.local):
    inside = False


_state = _CallbackState()


def inside_callback() -> bool:
    """Return whether Zenoh is further up on this thread's stack."""
    return _state.inside


def callback(function: Callable[..., None]) -> Callable[..., None]:
    """Wrap `function` for handing it to Zenoh."""

    def call(*arguments: Any) -> None:
        _state.inside = True
        try:
            function(*arguments)
        finally:
            _state.inside = False

    return call
