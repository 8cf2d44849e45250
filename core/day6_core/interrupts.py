"""Calls that no Ctrl-C may break off: what a signal handler raises is raised after them."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import ContextDecorator

_deferring = 0
_waiting: Callable[[], object] | None = None


class Deferred(ContextDecorator):
    """A section (`with DEFERRED:`) or a function (`@DEFERRED`). It matters only in the main thread, where Python runs handlers.

    Zenoh calls Python back while it declares, drops or closes something, in the thread that asked for it. It would swallow an
    exception that a signal handler raises in there, and one that is on its way while Zenoh drops an object becomes a
    SystemError.
    """

    def __enter__(self) -> None:
        global _deferring
        if _is_in_main_thread():
            _deferring += 1

    def __exit__(self, *_: object) -> None:
        global _deferring, _waiting
        if not _is_in_main_thread():
            return
        _deferring -= 1
        if not _deferring and _waiting is not None:
            call, _waiting = _waiting, None
            call()


DEFERRED = Deferred()


def _is_in_main_thread() -> bool:
    return threading.get_ident() == threading.main_thread().ident  # current_thread() would take in a thread of Zenoh's


def defer(call: Callable[[], object]) -> bool:
    """Have the end of a signal handler called after the section that it has interrupted; False if it interrupted none."""
    global _waiting
    if _deferring:
        _waiting = call
    return bool(_deferring)
