"""Tells the user which line it is for which time stands still: it is computing, or waits for something real."""

from __future__ import annotations

import _thread
import os
import sys
import time
from collections.abc import Callable

from day6_core.virtual.kernel import Kernel
from day6_core.virtual.told import TOLD_AFTER

_start_new_thread, _allocate_lock, _cpu_time = _thread.start_new_thread, _thread.allocate_lock, time.process_time
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
    looks: list[float] = []
    while True:
        if kernel.turns != turn or kernel.idling:
            turn = kernel.turns
            looks.clear()
        looks.append(_cpu_time())
        if turn != told and (kind := _what_lasts(looks)) and (place := _place(kernel.running.ident)):
            told = turn
            tell(kind, place)
        never.acquire(
            timeout=_LOOKS_EVERY
        )  # as the other threads wait, and not as a program that sleeps; see `processes`


def _what_lasts(looks: list[float]) -> str:
    """What holds time: seconds of computing (however long those take beside other programs), or a time without any."""
    if looks[-1] - looks[0] >= TOLD_AFTER * 0.9:
        return "busy"
    before = len(looks) - 1 - round(TOLD_AFTER / _LOOKS_EVERY)
    return "real" if before >= 0 and looks[-1] - looks[before] < TOLD_AFTER / 10 else ""


def _place(thread: int) -> str:
    """Where a thread is, outside of virtual time itself; '' if nowhere."""
    frame = sys._current_frames().get(thread)
    while frame is not None and frame.f_code.co_filename.startswith(_FOLDER):
        frame = frame.f_back
    if frame is None:
        return ""
    inside = os.path.join(os.getcwd(), "")
    return f"{frame.f_code.co_filename.removeprefix(inside)}:{frame.f_lineno}"
