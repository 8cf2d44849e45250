"""Handlers of signals: Python calls them in the main thread at any moment, but here that may not be the one that runs."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import _signal  # type: ignore[import-not-found]
import _thread
import math
import os
from collections.abc import Callable
from typing import Any

from day6_core.virtual.follow.builtin import is_number, put
from day6_core.virtual.kernel import Kernel, Watch
from day6_core.virtual.member import deliver as send

_real_signal, _real_getsignal, _real_set_wakeup_fd = _signal.signal, _signal.getsignal, _signal.set_wakeup_fd
_real_setitimer, _real_alarm = _signal.setitimer, _signal.alarm
_real_raise, _real_pthread_kill = _signal.raise_signal, _signal.pthread_kill
_get_ident = _thread.get_ident


def install(kernel: Kernel) -> None:
    """Have the kernel call the handlers, those that are there and those to come."""

    def signal(signalnum: int, handler: Any, /) -> Any:
        before = getsignal(signalnum)
        if callable(handler):
            _real_signal(signalnum, kernel.arrived)
            kernel.handlers[int(signalnum)] = handler
        else:
            _real_signal(signalnum, handler)
            kernel.handlers.pop(int(signalnum), None)
        return before

    def getsignal(signalnum: int, /) -> Any:
        return kernel.handlers.get(int(signalnum)) or _real_getsignal(signalnum)

    def set_wakeup_fd(fd: int, /, *, warn_on_full_buffer: bool = True) -> int:
        before: int = _real_set_wakeup_fd(fd, warn_on_full_buffer=warn_on_full_buffer)
        kernel.wakeup_fd = fd
        return before

    def raise_signal(signalnum: int, /) -> None:
        if _get_ident() == main or not deliver(int(signalnum)):
            _real_raise(signalnum)

    def pthread_kill(thread_id: int, signalnum: int, /) -> None:
        if thread_id == _get_ident() == main or not signalnum or not deliver(int(signalnum)):
            _real_pthread_kill(thread_id, signalnum)

    def kill(pid: int, signal: int, /) -> None:
        if _get_ident() == main or pid != os.getpid() or not deliver(int(signal)):
            sent(pid, signal)

    def deliver(number: int) -> bool:
        """Have a handler called; False if it has none."""
        if number not in kernel.handlers:
            return False
        send(kernel, number)
        return True

    def pause() -> None:
        before = kernel.handled
        kernel.wait(None, Watch(lambda: kernel.handled != before, (), told=True))

    timer: list[tuple[int, int]] = [(0, 0)]
    """When the alarm goes off, and how long after that again, ns; a new pair for each alarm."""

    def setitimer(which: int, seconds: float, interval: float = 0.0, /) -> tuple[float, float]:
        if which != _signal.ITIMER_REAL or not all(is_number(each) and each >= 0 for each in (seconds, interval)):
            found: tuple[float, float] = _real_setitimer(which, seconds, interval)
            return found
        before, set_now = timer[0], (kernel.now + int(seconds * 1e9), int(interval * 1e9))
        timer[0] = set_now
        if seconds:
            _thread.start_new_thread(ring, (set_now,))
        return max(0, before[0] - kernel.now) / 1e9, before[1] / 1e9

    def ring(mine: tuple[int, int]) -> None:
        at, every = mine
        while True:
            kernel.wait(at - kernel.now)
            if timer[0] is not mine:
                return  # another one was set, or none
            kill(os.getpid(), _signal.SIGALRM)
            if not every:
                return
            at += every

    def alarm(seconds: int, /) -> int:
        if not isinstance(seconds, int):
            _real_alarm(seconds)  # says what is wrong with it
        return math.ceil(setitimer(_signal.ITIMER_REAL, seconds)[0])

    main, sent = _get_ident(), os.kill
    replaced: dict[str, Callable[..., Any]] = {
        "signal": signal,
        "getsignal": getsignal,
        "set_wakeup_fd": set_wakeup_fd,
        "raise_signal": raise_signal,
        "pthread_kill": pthread_kill,
        "pause": pause,
        "setitimer": setitimer,
        "alarm": alarm,
    }
    copies: Any = sys.modules.get("signal")  # has taken some of them as they are
    for name, function in replaced.items():
        put(_signal, **{name: function})
        if copies is not None and name not in ("signal", "getsignal"):
            put(copies, **{name: function})
    put(os, kill=kill)
    if _real_getsignal(_signal.SIGINT) is _signal.default_int_handler:
        signal(_signal.SIGINT, _signal.default_int_handler)
