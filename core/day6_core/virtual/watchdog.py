"""Tells the user which line it is for which time stands still: it is computing, or waits for something real."""

from __future__ import annotations

import _thread
import os
import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

from collections.abc import Callable

from day6_core.virtual.kernel import Kernel
from day6_core.virtual.processes import used
from day6_core.virtual.told import TOLD_AFTER, Used, is_computing, is_waiting

_start_new_thread, _allocate_lock = _thread.start_new_thread, _thread.allocate_lock
_FOLDER = os.path.dirname(__file__)
_LOOKS_EVERY = TOLD_AFTER / 4
"""Real seconds."""


def watch(kernel: Kernel, tell: Callable[[str, str], None]) -> None:
    """Look at a kernel from time to time, on a thread that isn't the kernel's, and tell of each turn that lasts."""
    _start_new_thread(_watch, (kernel, tell))


def _watch(kernel: Kernel, tell: Callable[[str, str], None]) -> None:
    never = _allocate_lock()
    never.acquire()
    turn, told = -1, -1
    looks: list[Used] = []
    while True:
        if kernel.turns != turn or kernel.idling:
            turn = kernel.turns
            looks.clear()
        looks.append(used(os.getpid()))
        if turn != told and (kind := what_lasts(looks)) and (place := _place(kernel.running.ident)):
            told = turn
            tell(kind, place)
        # As the other threads wait, and not as a program that sleeps; see `processes`.
        never.acquire(timeout=_LOOKS_EVERY)


def what_lasts(looks: list[Used]) -> str:
    """Say what holds time, '' if nothing yet; a look is what `used` says."""
    before = len(looks) - 1 - round(TOLD_AFTER / _LOOKS_EVERY)
    if is_computing(looks[0], looks[-1]):
        return "busy"
    return "real" if before >= 0 and is_waiting(looks[before], looks[-1]) else ""


def _place(thread: int) -> str:
    """Where a thread is, outside of virtual time itself; '' if nowhere."""
    frame = sys._current_frames().get(thread)
    while frame is not None and frame.f_code.co_filename.startswith(_FOLDER):
        frame = frame.f_back
    if frame is None:
        return ""
    inside = os.path.join(os.getcwd(), "")
    return f"{frame.f_code.co_filename.removeprefix(inside)}:{frame.f_lineno}"
