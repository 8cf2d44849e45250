"""Short turns on the processor: who asks for them, until when, and that nothing which is started inherits them."""

from __future__ import annotations

import os
import re
import threading
from collections.abc import Iterable
from pathlib import Path

import pytest

from day6_tui import turns

TURN = r"se\.slice\s*:\s*(\d+)"


def _turn(thread: int) -> int:
    """Nanoseconds of a thread's turn; skips the test where the system does not tell."""
    try:
        found = re.search(TURN, Path(f"/proc/self/task/{thread}/sched").read_text(encoding="ascii"))
    except OSError:
        found = None
    if found is None:
        pytest.skip("this system does not tell")
    return int(found[1])


def test_a_threads_turns_get_short_and_usual_again() -> None:
    def ask() -> None:
        thread = threading.get_native_id()
        told.append(_turn(thread))
        for nanoseconds in (turns.SHORT_NS, 0):
            turns.take_short([thread], nanoseconds)
            told.append(_turn(thread))

    _turn(os.getpid())
    told: list[int] = []
    asking = threading.Thread(target=ask)
    asking.start()
    asking.join()
    if told[1] == told[0]:
        pytest.skip("Linux before 6.12")
    assert told == [told[0], turns.SHORT_NS, told[0]]


def test_what_is_started_from_such_a_thread_has_usual_turns() -> None:
    def look() -> None:
        told.append(_turn(threading.get_native_id()))

    def ask() -> None:
        look()
        turns.Turns().typed([threading.get_native_id()])
        started = threading.Thread(target=look)  # for the system the same as a process
        started.start()
        started.join()

    _turn(os.getpid())
    told: list[int] = []
    asking = threading.Thread(target=ask)
    asking.start()
    asking.join()
    assert told[0] == told[1]


def test_a_desktop_asks_once_for_each_thread_and_gives_back_when_nobody_types(monkeypatch) -> None:
    asked: list[tuple[set[int], int]] = []

    def take(threads: Iterable[int], nanoseconds: int = turns.SHORT_NS) -> None:
        asked.append((set(threads), nanoseconds))

    monkeypatch.setattr(turns, "take_short", take)
    monkeypatch.setattr(turns, "keep_from_children", lambda threads: None)
    of_desktop = turns.Turns()
    of_desktop.rest()
    of_desktop.typed([1, 2])
    of_desktop.typed([2, 1])
    of_desktop.typed([1, 2, 3])
    of_desktop.rest()
    of_desktop.rest()
    assert asked == [({1, 2}, turns.SHORT_NS), ({3}, turns.SHORT_NS), ({1, 2, 3}, 0)]
