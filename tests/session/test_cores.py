"""Seconds of a thread without those in which the machine was busy with others."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from day6_core.session import cores
from tests.support.waiting import run, until

linux = pytest.mark.skipif(not Path("/proc/self/schedstat").exists(), reason="this system does not tell who waits")


@linux
@pytest.mark.process
def test_who_shares_a_core_waits_for_it() -> None:
    core = min(os.sched_getaffinity(0))
    other = subprocess.Popen(
        [sys.executable, "-c", f"import os; os.sched_setaffinity(0, [{core}]); print(flush=True)\nwhile True: pass"],
        stdout=subprocess.PIPE,
    )
    waited: list[float] = []

    def share() -> None:
        os.sched_setaffinity(0, [core])  # of this thread alone
        before = cores.waited_for_a_core(threading.get_native_id())
        until(lambda: cores.waited_for_a_core(threading.get_native_id()) > before, every=0.0)
        waited.append(cores.waited_for_a_core(threading.get_native_id()) - before)

    assert other.stdout is not None and other.stdout.readline()
    sharing = threading.Thread(target=share)
    sharing.start()
    sharing.join()
    other.kill()
    other.communicate()
    assert waited and waited[0] > 0


IDLE = """
import time
from day6_core.session.cores import idle_seconds

def idle_while(ends):
    before = idle_seconds()
    while not ends():
        pass
    return idle_seconds() - before

def work():
    end = time.thread_time() + 0.02
    return idle_while(lambda: time.thread_time() > end)

print(min(work() for _ in range(5)), idle_while(lambda: time.sleep(0.1) is None))
"""


@pytest.mark.process
def test_a_clock_of_idleness_stands_still_while_there_is_work() -> None:
    # By itself: a thread that waits for Python's lock is idle. The least of five: one may lie where the machine stood still.
    worked, slept = map(float, run([sys.executable, "-c", IDLE]).stdout.split())
    assert worked < slept / 5


def test_a_thread_that_does_not_end_is_waited_for_as_long_as_it_could_run(monkeypatch: pytest.MonkeyPatch) -> None:
    let_go, asked = threading.Event(), []
    slow = threading.Thread(target=let_go.wait)
    slow.start()

    def waits(thread: int) -> float:
        asked.append(thread)
        if len(asked) == 5:
            let_go.set()
        return time.monotonic()  # all the time

    monkeypatch.setattr(cores, "waited_for_a_core", waits)
    cores.join(slow, 0.01)
    assert not slow.is_alive() and set(asked) == {slow.native_id}
    monkeypatch.undo()
    let_go.clear()
    stuck = threading.Thread(target=let_go.wait)
    stuck.start()
    cores.join(stuck, 0.01)
    assert stuck.is_alive()
    let_go.set()
    stuck.join()


def test_where_the_system_does_not_tell_nobody_waits() -> None:
    assert cores.waited_for_a_core(0) == 0.0
