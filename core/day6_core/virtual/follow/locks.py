"""Locks whose waiting follows the kernel. Only one thread runs at a time, so a lock is no more than a note that it is taken."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import _thread
from collections import deque
from typing import Any, NoReturn

from day6_core.virtual.follow.builtin import is_number
from day6_core.virtual.follow.imports import when_imported
from day6_core.virtual.kernel import Kernel, Wait

_allocate_lock, _get_ident = _thread.allocate_lock, _thread.get_ident
_kernel: Kernel
TIMEOUT_MAX = _thread.TIMEOUT_MAX


def install(kernel: Kernel) -> None:
    """Have the locks that are made from now on follow a kernel."""
    global _kernel
    _kernel = kernel
    thread: Any = _thread
    thread.allocate_lock = thread.allocate = Lock
    thread.RLock = RLock
    if hasattr(thread, "lock"):  # 3.13
        thread.lock = Lock
    import functools
    import threading

    properties: Any = functools
    properties.RLock = RLock
    module: Any = threading
    module._allocate_lock = module.Lock = Lock
    module.RLock = module._PyRLock = RLock
    module._CRLock = None
    when_imported("queue", _follow_queue)


def _follow_queue(module: Any) -> None:
    module.SimpleQueue = module._PySimpleQueue  # the other one has a lock of its own, in C


class Lock:
    """As `_thread.lock`."""

    __slots__ = ("__weakref__", "_locked", "_waiting")

    def __init__(self) -> None:
        self._locked = 0
        """Or whatever else tells that it is taken."""
        self._waiting: deque[Wait] | None = None

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """Take it; False if that isn't possible in time."""
        if timeout == -1 and not self._locked:
            self._locked = 1
            return True
        return self._take(1, blocking, timeout)

    def _take(self, owner: int, blocking: bool, timeout: float) -> bool:
        if timeout != -1 and not (blocking and is_number(timeout) and 0 <= timeout <= TIMEOUT_MAX):
            _allocate_lock().acquire(blocking, timeout)  # says in the words of this Python what is wrong
        if not self._locked:
            self._locked = owner
            return True
        return bool(blocking) and self._wait(None if timeout == -1 else int(timeout * 1e9), owner)

    def release(self) -> None:
        """Let it go; any thread may."""
        self.__exit__()

    def __exit__(self, *_: object) -> None:
        if not self._locked:
            raise RuntimeError("release unlocked lock")
        self._locked = 0
        if self._waiting:
            _kernel.wake(self._waiting.popleft())

    def locked(self) -> bool:
        """Whether it is taken."""
        return bool(self._locked)

    acquire_lock, release_lock, locked_lock = acquire, release, locked
    __enter__ = acquire

    def _wait(self, ns: int | None, owner: int) -> bool:
        kernel = _kernel
        end = None if ns is None else kernel.now + ns
        waiting = self._waiting
        if waiting is None:
            waiting = self._waiting = deque()
        mine = kernel.mine()
        while True:
            waiting.append(mine)
            try:
                in_time = kernel.wait(None if end is None else end - kernel.now)
            except BaseException:  # of a handler of a signal
                if not self._locked and mine not in waiting and waiting:
                    kernel.wake(waiting.popleft())  # it was this one's turn
                raise
            finally:
                if mine in waiting:
                    waiting.remove(mine)
            if not self._locked:
                self._locked = owner
                return True
            if not in_time:
                return False

    def _at_fork_reinit(self) -> None:
        self._locked = 0
        self._waiting = None

    def __reduce_ex__(self, protocol: object) -> NoReturn:
        raise TypeError(f"cannot pickle '_thread.{type(self).__name__}' object")

    def __repr__(self) -> str:
        state = "locked" if self._locked else "unlocked"
        return f"<{state} _thread.lock object at {id(self):#x}>"


class RLock(Lock):
    """As `_thread.RLock`. `_locked` is the thread that has it.

    It changes hands in one step, as anything here may be interrupted by what takes it, too: a handler of a signal, or the end of
    an object that Python clears away.
    """

    __slots__ = ("_again",)

    def __init__(self) -> None:
        super().__init__()
        self._again = 0
        """How often more than once."""

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """Take it, once more if the calling thread has it; False if that isn't possible in time."""
        me = _get_ident()
        if self._locked == me:
            self._again += 1
            return True
        if timeout == -1 and not self._locked:
            self._locked = me
            return True
        return self._take(me, blocking, timeout)

    def __exit__(self, *_: object) -> None:
        if self._locked != _get_ident():
            raise RuntimeError("cannot release un-acquired lock")
        if self._again:
            self._again -= 1
            return
        self._locked = 0
        if self._waiting:
            _kernel.wake(self._waiting.popleft())

    __enter__ = acquire

    # -- for threading.Condition -----------------------------------------------------------------------------------------

    def _is_owned(self) -> bool:
        return self._locked == _get_ident()

    def _recursion_count(self) -> int:
        return self._again + 1 if self._is_owned() else 0

    def _release_save(self) -> int:
        if not self._locked:
            raise RuntimeError("cannot release un-acquired lock")
        again, self._again = self._again, 0
        Lock.__exit__(self)
        return again

    def _acquire_restore(self, again: int) -> None:
        self.acquire()
        self._again = again

    def _at_fork_reinit(self) -> None:
        super()._at_fork_reinit()
        self._again = 0

    def __repr__(self) -> str:
        state = "locked" if self._locked else "unlocked"
        return f"<{state} _thread.RLock object owner={self._locked} count={self._recursion_count()} at {id(self):#x}>"


Lock.__name__ = Lock.__qualname__ = "lock"
Lock.__module__ = RLock.__module__ = "_thread"
