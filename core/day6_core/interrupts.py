"""Calls that no Ctrl-C may break off, and threads that no signal may go to: Python handles it in the main thread alone."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ContextDecorator, contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import signal
else:
    import _signal as signal  # what signal is made of, and not a student's signal.py

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


@contextmanager
def unsignalled() -> Iterator[None]:
    """Threads that begin in here, and those that they begin, leave signals to others.

    The system gives a signal to whichever thread is the first to look for one. If that is not the main thread, Python notes
    the signal and `time.sleep` in the main thread sleeps on.
    """
    if sys.platform == "win32":
        yield
        return
    # What comes of the thread's own doing goes to no other one.
    own = {signal.SIGSEGV, signal.SIGBUS, signal.SIGFPE, signal.SIGILL, signal.SIGABRT, signal.SIGTRAP, signal.SIGSYS}
    before = signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals() - own)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
