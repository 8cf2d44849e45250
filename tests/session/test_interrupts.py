"""Sections that no Ctrl-C breaks off."""

from __future__ import annotations

import threading

from day6_core.interrupts import DEFERRED, defer


def test_outside_of_a_section_nothing_is_deferred() -> None:
    made: list[int] = []
    assert not defer(lambda: made.append(1))
    assert made == []


def test_in_sections_within_each_other_it_is_made_after_the_outermost() -> None:
    made: list[int] = []
    with DEFERRED:
        with DEFERRED:
            assert defer(lambda: made.append(1))
        assert made == []
    assert made == [1]
    with DEFERRED:
        pass
    assert made == [1]


def test_what_the_call_raises_comes_after_the_section_and_what_it_raised_is_told_too() -> None:
    def interrupt() -> None:
        raise KeyboardInterrupt

    caught: list[BaseException] = []
    try:
        with DEFERRED:
            defer(interrupt)
            raise OSError("the network is gone")
    except KeyboardInterrupt as error:
        caught.append(error)
    assert isinstance(caught[0].__context__, OSError)


def test_a_section_of_another_thread_defers_nothing() -> None:
    entered, leave = threading.Event(), threading.Event()

    def work() -> None:
        with DEFERRED:
            entered.set()
            leave.wait()

    thread = threading.Thread(target=work)
    thread.start()
    entered.wait()
    made: list[int] = []
    assert not defer(lambda: made.append(1))
    leave.set()
    thread.join()
    assert made == []
