"""Processes: how they are started, waited for and sent signals, so that the coordinator knows all of them."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import _posixsubprocess
import os
import time
from collections.abc import Callable, Sequence
from typing import Any, Protocol, TypeVar

from day6_core.virtual import ready
from day6_core.virtual.follow.builtin import put
from day6_core.virtual.follow.descriptors import descriptors_were_shared
from day6_core.virtual.follow.imports import when_imported
from day6_core.virtual.kernel import Kernel
from day6_core.virtual.surroundings import VARIABLE


class World(Protocol):
    """Whom this process tells of others."""

    def spawned(self, pid: int) -> None:
        """A process was started."""

    def killed(self, target: int, number: int) -> None:
        """A signal is sent to a process, or to a group if negative."""


_real_waitpid, _real_waitid, _real_kill, _real_killpg = os.waitpid, os.waitid, os.kill, os.killpg
_kernel: Kernel
_started: set[int] = set()
"""Processes of whose end the coordinator tells."""
_NOBODY = (0, 0)
"""What waitpid says where nobody has ended."""
T = TypeVar("T")


def install(kernel: Kernel, world: Callable[[], World], enter_child: Callable[[], None]) -> None:
    """Have the children that are started from now on be known to the world; one that was forked calls `enter_child`."""
    global _kernel
    _kernel = kernel
    c: Any = _posixsubprocess
    fork_exec, posix_spawn, posix_spawnp, fork = c.fork_exec, os.posix_spawn, os.posix_spawnp, os.fork

    def spawned(pid: int) -> None:
        _started.add(pid)
        world().spawned(pid)

    def fork_exec_and_tell(*args: Any) -> int:
        pid: int = _handed_on(args) or fork_exec(*args)
        if pid and not _is_apart(args[5]):
            spawned(pid)
        if len(args[3]) > 1:  # more than the pipe for errors of its start
            descriptors_were_shared()
        return pid

    def spawn_and_tell(original: Callable[..., int]) -> Callable[..., int]:
        def spawn(path: Any, argv: Any, env: Any, /, **kwargs: Any) -> int:
            pid = original(path, argv, env, **kwargs)
            spawned(pid)
            return pid

        return spawn

    def fork_and_tell() -> int:
        descriptors_were_shared()
        pid = fork()
        if pid:
            spawned(pid)
        else:
            _started.clear()
            enter_child()
        return pid

    def kill(pid: int, signal: int, /) -> None:
        if pid in (os.getpid(), 0, -1):
            _real_kill(pid, signal)
            return
        _real_kill(pid, 0)
        if signal:
            world().killed(pid, int(signal))

    def killpg(pgid: int, signal: int, /) -> None:
        if pgid in (0, os.getpgrp()):
            _real_killpg(pgid, signal)
            return
        _real_killpg(pgid, 0)
        if signal:
            world().killed(-pgid, int(signal))

    c.fork_exec = fork_exec_and_tell
    subprocess: Any = sys.modules.get("subprocess")
    if subprocess is not None and hasattr(subprocess, "_fork_exec"):
        subprocess._fork_exec = fork_exec_and_tell
    if subprocess is not None:
        subprocess._time = time.monotonic
    put(os, posix_spawn=spawn_and_tell(posix_spawn), posix_spawnp=spawn_and_tell(posix_spawnp))
    put(os, fork=fork_and_tell, system=_system, kill=kill, killpg=killpg)
    put(os, waitpid=waitpid, wait=lambda: waitpid(-1, 0), waitid=_waitid)
    when_imported("multiprocessing.synchronize", _follow_semaphores)


def _handed_on(args: Sequence[Any]) -> int:
    """Hand what is to be started to a ready interpreter; return the process number, 0 if none takes it."""
    if ready.wanted is None:
        return 0
    from day6_core.virtual.ready import forks

    argv, _, _, kept, cwd, env, read_end, _, _, out_end, _, error_end, _, error_pipe, _, new_session = args[:16]
    fds = {number: number for number in kept if number != error_pipe}
    fds |= {number: number if fd < 0 else fd for number, fd in enumerate((read_end, out_end, error_end))}
    return forks.start(argv, cwd, env, fds, new_session=new_session)


def _is_apart(environment: Any) -> bool:
    """Whether a process is no part of the world: it was given an empty VARIABLE."""
    return environment is not None and os.fsencode(f"{VARIABLE}=") in environment


def waitpid(pid: int, options: int, /) -> tuple[int, int]:
    """As `os.waitpid`."""

    def look() -> tuple[int, int] | None:
        found = _real_waitpid(pid, options | os.WNOHANG)
        return found if found != _NOBODY else None

    return _wait_for_process(look, options, told=pid in _started) or _NOBODY


def _waitid(idtype: int, number: int, options: int, /) -> Any:
    real: Any = _real_waitid
    told = idtype == os.P_PID and number in _started
    return _wait_for_process(lambda: real(idtype, number, options | os.WNOHANG), options, told=told)


def _wait_for_process(look: Callable[[], T], options: int, *, told: bool) -> T:
    return _kernel.look_until(look, 0 if options & os.WNOHANG else None, told=told)


def _follow_semaphores(module: Any) -> None:
    make_methods = module.SemLock._make_methods

    def make_methods_that_wait(self: Any) -> None:
        make_methods(self)
        taken = self._semlock.acquire

        def acquire(block: bool = True, timeout: float | None = None) -> bool:
            ns = None if timeout is None else int(max(timeout, 0) * 1e9)
            return _kernel.look_until(lambda: bool(taken(False)), ns if block else 0)

        self.acquire = acquire

    module.SemLock._make_methods = make_methods_that_wait
    module.SemLock.__enter__ = lambda self: self.acquire()


def _system(command: Any) -> int:
    import subprocess

    with subprocess.Popen(["/bin/sh", "-c", command]) as process:
        code = process.wait()
    return -code if code < 0 else code << 8
