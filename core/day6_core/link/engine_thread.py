"""Zenoh's threads: how they begin; while they run Python, whether this is one of them, and what makes many callbacks cheap.

Python collects garbage on any thread, and that may undeclare something: a node nobody references any more, say. Inside a
callback this would deadlock.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.interrupts import unsignalled

if TYPE_CHECKING:
    import zenoh

OFTEN = 100
"""Callbacks after which a thread keeps what Python needs to run on it."""


class _CallbackState(threading.local):
    inside = False
    kept = False


_state = _CallbackState()


def open_session(config: zenoh.Config) -> zenoh.Session:
    """Open a session whose threads leave signals to Python's main thread.

    Raises:
        zenoh.ZError: as `zenoh.open` does.
    """
    import zenoh

    with unsignalled():
        return zenoh.open(config)


def inside_callback() -> bool:
    """Return whether Zenoh is further up on this thread's stack."""
    return _state.inside


def run_as_engine(function: Callable[[], None]) -> None:
    """Run the body of a thread that takes the part of Zenoh's. Python started it, and keeps what it needs to run on it."""
    _state.inside = _state.kept = True
    function()


def callback(function: Callable[..., None], *, often: bool = False) -> Callable[..., None]:
    """Wrap `function` for handing it to Zenoh; `often`: for messages, which come on few threads and may be thousands a second."""
    calls = 0

    def call(*arguments: Any) -> None:
        nonlocal calls
        state = _state
        before, state.inside = state.inside, True
        if often and not state.kept:
            calls += 1
            if calls > OFTEN:
                state.kept = True
                _keep_thread_state()
        try:
            function(*arguments)
        finally:
            state.inside = before

    return call


def _keep_thread_state() -> None:
    """Let this thread, which Python did not start, keep its thread state until it ends.

    Otherwise Python makes one for every callback, with all thread-local variables: more work than most messages are. (A second
    PyGILState_Ensure without a release is how C programs do it.)
    """
    try:
        from ctypes import pythonapi
    except ImportError:  # a Python built without it
        return
    pythonapi.PyGILState_Ensure()
