"""A debug check: logs the stack wherever the thread that runs all programs blocks. Enabled by DAY6_WATCH=FILE.

Two checks, because neither sees everything. Calls that always block are noticed when they are made, on any machine and however
short they are. Anything else that stops the thread is noticed by a sampling thread: it stays at the same instruction for a second
without processor time, although samples were taken all the time (so the machine was neither suspended nor merely loaded, which
still gives every thread some milliseconds a second) and it did not wait for a disk, which holds up any use of a file where it is
busy.
"""

from __future__ import annotations

import functools
import os
import select
import stat
import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Callable
from types import FrameType
from typing import Any

from day6_core.inbox import Inbox
from day6_core.system.processes import stat_fields

VARIABLE = "DAY6_WATCH"
EVERY = 0.1
SAMPLES = 10
"""Samples, one every 0.1 s, in which a thread makes no progress before it counts as blocked."""

STILL = 0.005
"""Seconds of processor time below which it makes no progress."""

_AUDITED = ("subprocess.Popen", "socket.connect", "socket.getaddrinfo", "os.system")
_ALLOWED = (("threading.py", "start"),)
"""File and function that may block: a new thread confirms its start at once."""

_threads: dict[int, str] = {}
"""The threads that must not block, and the file for what they do: the one that was named when they began."""
_reported: set[tuple[str, str]] = set()
_installed = False


def begin() -> bool:
    """From now on this thread must not block. Returns False if that was so already."""
    _install()
    thread = threading.get_ident()
    if thread in _threads:
        return False
    _threads[thread] = os.environ.get(VARIABLE, os.devnull)
    return True


def end() -> None:
    """Let this thread block again."""
    _threads.pop(threading.get_ident(), None)


def _install() -> None:
    global _installed
    if _installed:
        return
    _installed = True
    sys.addaudithook(_audit)
    _guard(os, "read", _waits_for_file)
    _guard(os, "write", _waits_for_file)
    if sys.platform != "win32":
        _guard(os, "waitpid", lambda pid, options: not options & os.WNOHANG)
    _guard(select, "select", lambda r, w, x, timeout=None: timeout is None or timeout > 0)
    _guard(threading.Condition, "wait", lambda condition, timeout=None: timeout is None or timeout > 0)
    _guard(threading.Thread, "join", lambda thread, timeout=None: thread.is_alive() and timeout != 0)
    _guard(subprocess.Popen, "wait", lambda popen, timeout=None: popen.returncode is None)

    _guard(time, "sleep", lambda seconds: True)
    _guard(os, "fsync", lambda fd: True)
    threading.Thread(target=_sample, name="day6-watch", daemon=True).start()


def _guard(place: Any, name: str, waits: Callable[..., bool]) -> None:
    original = getattr(place, name)

    @functools.wraps(original)
    def guarded(*arguments: Any, **keywords: Any) -> Any:
        file = _threads.get(threading.get_ident())
        if file is not None and waits(*arguments, **keywords):
            _report(file, f"{name}()", sys._getframe(1))
        return original(*arguments, **keywords)

    setattr(place, name, guarded)


def _waits_for_file(fd: int, *_: object) -> bool:
    """Whether reading and writing may block: a pipe, a socket or a terminal in blocking mode."""
    if sys.platform == "win32":
        return False
    try:
        mode = os.fstat(fd).st_mode
        waits = stat.S_ISFIFO(mode) or stat.S_ISSOCK(mode) or os.isatty(fd)
        return waits and os.get_blocking(fd)
    except OSError:
        return False


def _audit(event: str, arguments: tuple[Any, ...]) -> None:
    file = _threads.get(threading.get_ident())
    if file is None:
        return
    if event in _AUDITED:
        _report(file, event, sys._getframe(1))
    elif event == "open" and isinstance(arguments[0], (str, bytes)):
        if arguments[2] & getattr(os, "O_NONBLOCK", 0):
            return
        try:
            mode = os.stat(arguments[0]).st_mode
        except (OSError, ValueError):
            return
        if stat.S_ISFIFO(mode):
            _report(file, f"opening the pipe {arguments[0]!r}", sys._getframe(1))


def _sample() -> None:
    """Sample the watched threads, where the system knows the processor time of a thread."""
    if sys.platform == "win32" or not hasattr(time, "pthread_getcpuclockid"):
        return
    standing: dict[int, tuple[object, float, int]] = {}
    while True:
        time.sleep(EVERY)
        frames = sys._current_frames()
        for thread, file in list(_threads.items()):
            frame = frames.get(thread)
            if frame is None or _waits_for_work(frame):
                standing.pop(thread, None)
                continue
            place = (id(frame), frame.f_lasti)
            used = time.clock_gettime(time.pthread_getcpuclockid(thread))
            before = standing.get(thread)
            if before is None or before[0] != place or used - before[1] > STILL or _waits_for_disk(thread):
                standing[thread] = (place, used, 1)
            elif before[2] == SAMPLES:
                _report(file, f"a wait of more than {EVERY * SAMPLES:g} s", frame)
                standing[thread] = (place, used, 0)
            else:
                standing[thread] = (place, before[1], before[2] + 1)


def _waits_for_work(frame: FrameType) -> bool:
    """Whether this is the scheduler, waiting in its inbox."""
    caller = frame.f_back
    return frame.f_code is Inbox.get.__code__ and caller is not None and caller.f_code.co_name == "_turn"


def _waits_for_disk(thread: int) -> bool:
    """Whether a thread is in the state D, "disk sleep" (proc(5)); False where the system doesn't tell."""
    number = next((each.native_id for each in threading.enumerate() if each.ident == thread), None)
    try:
        return stat_fields(f"self/task/{number}")[0] == b"D"
    except (OSError, IndexError):
        return False


def _report(path: str, what: str, frame: FrameType | None) -> None:
    lines = traceback.format_stack(frame)
    here = frame
    while here is not None:
        if (os.path.basename(here.f_code.co_filename), here.f_code.co_name) in _ALLOWED:
            return
        here = here.f_back
    text = f"the scheduler's thread waits: {what}\n{''.join(lines[-12:])}\n"
    if (path, text) in _reported:
        return
    _reported.add((path, text))
    with open(path, "a", encoding="utf-8") as file:
        file.write(text)
