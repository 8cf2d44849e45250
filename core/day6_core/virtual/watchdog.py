"""Tells the user which line it is for which time stands still: it is computing, or waits for something real."""

from __future__ import annotations

import _thread
import os
import sys
import time
from collections.abc import Callable
from types import FrameType

from day6_core.virtual.kernel import Kernel
from day6_core.virtual.told import TOLD_AFTER

_start_new_thread, _allocate_lock, _cpu_time = _thread.start_new_thread, _thread.allocate_lock, time.process_time
_FOLDER = os.path.dirname(__file__)


def watch(kernel: Kernel, tell: Callable[[str, str], None]) -> None:
    """Look at a kernel from time to time, on a thread that isn't the kernel's, and tell of each turn that lasts."""
    _start_new_thread(_watch, (kernel, tell))


def _watch(kernel: Kernel, tell: Callable[[str, str], None]) -> None:
    told = -1
    never = _allocate_lock()
    never.acquire()
    while True:
        turn, cpu = kernel.turns, _cpu_time()
        never.acquire(
            timeout=TOLD_AFTER
        )  # as the other threads wait, and not as a program that sleeps; see `processes`
        if kernel.turns != turn or kernel.idling or turn == told:
            continue
        frame = sys._current_frames().get(kernel.running.ident)
        while frame is not None and frame.f_code.co_filename.startswith(_FOLDER):
            frame = frame.f_back
        if frame is not None:
            told = turn
            tell("busy" if _cpu_time() - cpu > TOLD_AFTER / 10 else "real", _place(frame))


def _place(frame: FrameType) -> str:
    path = frame.f_code.co_filename
    inside = os.path.join(os.getcwd(), "")
    return f"{path.removeprefix(inside)}:{frame.f_lineno}"
