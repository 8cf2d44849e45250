"""Work in a thread holds up only the program that waits for it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

import pytest

from day6_core.session.clock import WorldClock
from day6_core.session.scheduler import Scheduler
from day6_core.session.task import Task
from day6_core.session.threads import in_thread
from tests.support.waiting import until


def finish(scheduler: Scheduler, task: Task) -> Task:
    until(lambda: task.finished, every=0.0, meanwhile=scheduler.advance)
    return task


def run(function: Callable[[], Any]) -> Task:
    scheduler = Scheduler(WorldClock(wall=None, epoch_ns=0))
    return finish(scheduler, scheduler.spawn(in_thread(function)))


def test_the_result_comes_back_from_another_thread() -> None:
    assert run(threading.get_ident).result not in (None, threading.get_ident())


def test_an_exception_comes_back_too() -> None:
    def fail() -> None:
        raise ValueError("no")

    error = run(fail).exception
    assert isinstance(error, ValueError) and str(error) == "no"


def test_other_programs_go_on_meanwhile() -> None:
    scheduler = Scheduler(WorldClock(wall=None, epoch_ns=0))
    release = threading.Event()
    slow = scheduler.spawn(in_thread(release.wait))

    async def quick() -> str:
        return "done"

    assert finish(scheduler, scheduler.spawn(quick())).result == "done"
    assert not slow.finished
    release.set()
    assert finish(scheduler, slow).result is True


def test_who_is_cancelled_does_not_wait_for_the_thread() -> None:
    scheduler = Scheduler(WorldClock(wall=None, epoch_ns=0))
    release = threading.Event()
    slow = scheduler.spawn(in_thread(release.wait))
    scheduler.advance()
    slow.cancel()
    assert isinstance(finish(scheduler, slow).exception, BaseException)
    release.set()


@pytest.mark.parametrize("value", [None, 0, ""])
def test_results_that_count_as_false_come_back(value: object) -> None:
    task = run(lambda: value)
    assert task.exception is None and task.result == value
