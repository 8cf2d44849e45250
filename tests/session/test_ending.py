"""The end of a process: steps that are taken in time, or at once when somebody insists; then force."""

from __future__ import annotations

import itertools
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

from day6_core.session import cores
from day6_core.session.ending import Ending, EndingStep
from tests.support.waiting import communicate, until

NEVER = 1000.0


def test_the_first_wish_takes_the_first_step_and_no_other() -> None:
    first, second = threading.Event(), threading.Event()
    ending = Ending(EndingStep(first.set, NEVER), EndingStep(second.set, NEVER))
    ending.begin()
    ending.begin()
    until(first.is_set)
    assert (ending.begun, ending.status, second.is_set()) == (True, 0, False)
    ending.over()


def test_a_step_that_brings_no_end_in_its_time_is_followed_by_the_next() -> None:
    second = threading.Event()
    ending = Ending(EndingStep(lambda: None, 0.0), EndingStep(second.set, NEVER))
    ending.begin()
    until(second.is_set)
    ending.over()


def test_seconds_in_which_the_machine_is_busy_with_others_do_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    second, asked = threading.Event(), itertools.count()

    def waits(thread: int) -> float:
        return time.monotonic() if next(asked) < 6 else 0.0  # all the time at first

    monkeypatch.setattr(cores, "waited_for_a_core", waits)
    ending = Ending(
        EndingStep(lambda: None, 0.01), EndingStep(lambda: second.set() if next(asked) > 6 else None, NEVER)
    )
    ending.begin()
    until(second.is_set)
    ending.over()


def test_a_step_that_fails_does_not_hold_up_the_others() -> None:
    second = threading.Event()

    def fail() -> None:
        raise OSError("no")

    ending = Ending(EndingStep(fail, 0.0), EndingStep(second.set, NEVER))
    ending.begin()
    until(second.is_set)
    ending.over()


PROGRAM = """\
import os, signal, threading
from day6_core.session import cores
from day6_core.session.ending import Ending, EndingStep
first = EndingStep(lambda: print("first", flush=True), 1000)
ending = Ending(first, EndingStep(lambda: print("second", flush=True), {last}))
ending.restore_terminal = lambda: (print("given back", flush=True), threading.Event().wait())
ending.handle_signals()
print("ready", flush=True)
threading.Event().wait()
"""


def run(*signals: str, last: float = NEVER) -> tuple[int, list[str]]:
    """Send the signals, each after the line that the one before led to; return the status and what was said."""
    child = subprocess.Popen(
        [sys.executable, "-c", PROGRAM.format(last=last)], stdout=subprocess.PIPE, text=True, encoding="utf-8"
    )
    assert child.stdout is not None
    said = []
    for name in signals:
        said.append(child.stdout.readline().strip())
        child.send_signal(getattr(signal, name))
    rest, _ = communicate(child)
    return child.returncode, [*said[1:], *rest.split("\n")[:-1]]


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="the signals of Unix")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_a_process_that_no_step_ends_is_ended_by_force_with_the_status_of_the_signal(name: str) -> None:
    status, said = run(name, "SIGTERM", last=0.0)
    assert (status, said) == (128 + getattr(signal, name), ["first", "second", "given back"])


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="the signals of Unix")
def test_a_second_signal_takes_the_next_step_at_once() -> None:
    assert run("SIGTERM", "SIGINT", "SIGTERM") == (143, ["first", "second", "given back"])
