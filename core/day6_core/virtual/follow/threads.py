"""Threads that run one at a time: how they begin, end and are waited for."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import _thread
import threading
from collections.abc import Callable
from typing import Any

from day6_core.virtual.follow.builtin import put
from day6_core.virtual.kernel import Kernel

_start_new_thread = _thread.start_new_thread
_kernel: Kernel


def install(kernel: Kernel) -> None:
    """Have the threads that begin from now on follow a kernel."""
    global _kernel
    _kernel = kernel
    thread: Any = _thread
    module: Any = threading
    put(thread, start_new_thread=_start, start_new=_start)
    if sys.version_info >= (3, 13):
        thread.start_joinable_thread = module._start_joinable_thread = _joinable_starter(thread.start_joinable_thread)
    else:
        module._start_new_thread = _start
    module.Thread.start = _starter(module.Thread.start)
    module.Thread._bootstrap_inner = _bootstrapper(module.Thread._bootstrap_inner)
    module.Thread.join = _join
    module.Thread.is_alive = _is_alive
    module.main_thread()._day6_done = threading.Event()
    module._shutdown = _shutter(module._shutdown)


def _in_turns(function: Callable[..., Any]) -> tuple[Callable[..., None], Callable[[], None]]:
    """Return what a thread has to run in place of a function, and what is to be called if it can't be started."""
    kernel = _kernel
    turn = kernel.begin()

    def run(*args: Any, **kwargs: Any) -> None:
        kernel.enter(turn)
        try:
            function(*args, **kwargs)
        finally:
            kernel.end()

    return run, lambda: kernel.withdraw(turn)


def _start(function: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any] | None = None, /) -> int:
    if not callable(function) or not isinstance(args, tuple):
        return _start_new_thread(function, args)  # says what is wrong with them
    run, withdraw = _in_turns(function)
    try:
        return _start_new_thread(run, args, kwargs or {})
    except BaseException:
        withdraw()
        raise


def _joinable_starter(original: Callable[..., Any]) -> Callable[..., Any]:
    def start(function: Callable[..., Any], handle: Any = None, daemon: bool = True) -> Any:
        run, withdraw = _in_turns(function)
        try:
            return original(run, handle=handle, daemon=daemon)
        except BaseException:
            withdraw()
            raise

    return start


def _starter(original: Callable[..., None]) -> Callable[..., None]:
    def start(self: Any) -> None:
        if not hasattr(self, "_day6_done"):
            self._day6_done = threading.Event()
        original(self)

    return start


def _bootstrapper(original: Callable[..., None]) -> Callable[..., None]:
    def bootstrap_inner(self: Any) -> None:
        try:
            original(self)
        finally:
            self._day6_done.set()

    return bootstrap_inner


def _join(self: Any, timeout: float | None = None) -> None:
    if not self._initialized:
        raise RuntimeError("Thread.__init__() not called")
    if not self._started.is_set():
        raise RuntimeError("cannot join thread before it is started")
    if self is threading.current_thread():
        raise RuntimeError("cannot join current thread")
    done = getattr(self, "_day6_done", None)
    if done is None:
        raise RuntimeError("cannot join a dummy thread")
    done.wait(None if timeout is None else max(timeout, 0))


def _is_alive(self: Any) -> bool:
    assert self._initialized, "Thread.__init__() not called"
    done = getattr(self, "_day6_done", None)
    return bool(self._started.is_set()) and (done is None or not done.is_set())


def _shutter(original: Callable[[], None]) -> Callable[[], None]:
    def shutdown() -> None:
        """Wait for the other threads, as Python does at its end."""
        module: Any = threading
        module.main_thread()._day6_done.set()
        while module._threading_atexits:
            module._threading_atexits.pop()()
        for each in threading.enumerate():
            if not each.daemon and each is not threading.current_thread():
                each.join()
        original()

    return shutdown
