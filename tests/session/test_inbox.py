"""A queue between threads whose reader wakes up in time, also if a slow machine takes its core away at the wrong moment."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from queue import Empty
from typing import TypeVar

import pytest

from day6_core.inbox import Inbox
from tests.support.waiting import until

T = TypeVar("T")

TIMES = 20_000
"""Shortly before the end of a short timeout a thread loses its core often enough in so many."""


def in_thread(act: Callable[[], T]) -> T:
    """What a function returns that is called in a thread; a thread that waits forever is left behind."""
    returned: list[T] = []
    thread = threading.Thread(target=lambda: returned.append(act()), daemon=True)
    thread.start()
    until(lambda: not thread.is_alive())
    return returned[0]


def test_a_wait_ends_after_its_time_however_short_it_was() -> None:
    inbox: Inbox[int] = Inbox()

    def wait() -> int:
        for number in range(TIMES):
            inbox.put(number)
            assert inbox.get() == number
            with pytest.raises(Empty):
                inbox.get(timeout=1e-6)
        return TIMES

    assert in_thread(wait) == TIMES


def test_what_several_put_in_is_taken_once_and_by_each_in_its_order() -> None:
    inbox: Inbox[tuple[int, int]] = Inbox()
    putters = [
        threading.Thread(target=lambda who=who: [inbox.put((who, number)) for number in range(TIMES)])
        for who in range(3)
    ]
    for putter in putters:
        putter.start()
    taken = in_thread(lambda: [inbox.get() for _ in range(3 * TIMES)])
    for who in range(3):
        assert [number for whose, number in taken if whose == who] == list(range(TIMES))
    assert inbox.empty() and inbox.qsize() == 0


def test_nothing_is_waited_for_where_nothing_is_asked_for() -> None:
    inbox: Inbox[int] = Inbox()
    for _ in range(2):
        with pytest.raises(Empty):
            inbox.get_nowait()
        with pytest.raises(Empty):
            inbox.get(timeout=-1.0)
        inbox.put(1)
        inbox.put(2)
        assert (inbox.qsize(), inbox.get_nowait(), inbox.get(timeout=-1.0)) == (2, 1, 2)


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="this system has no timers that send a signal")
def test_a_signal_handler_may_put_something_in_whatever_it_interrupts() -> None:
    inbox: Inbox[int] = Inbox()
    sent: list[int] = []

    def handle(*_: object) -> None:
        sent.append(1)
        inbox.put(1)

    previous = signal.signal(signal.SIGALRM, handle)
    signal.setitimer(signal.ITIMER_REAL, 1e-4, 1e-4)
    got = 0
    try:
        while len(sent) < 300:
            inbox.put(0)
            got += inbox.get()
            got += inbox.get()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
    assert got + sum(inbox.get() for _ in range(inbox.qsize())) == len(sent)
