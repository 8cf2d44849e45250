"""The check that nothing waits on the scheduler's thread finds what does, and nothing else."""

from __future__ import annotations

import os
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from day6_core.session import watch
from day6_core.session.clock import WorldClock
from day6_core.session.scheduler import Scheduler
from day6_core.whole_file import replace_file
from tests.support.waiting import until

pytestmark = pytest.mark.skipif(os.name != "posix", reason="pipes and ptys of Unix")


@pytest.fixture
def told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[[], object]], str]:
    """Runs a function on a scheduler's thread; returns what the check says of it."""
    file = tmp_path / "waits.txt"
    monkeypatch.setenv(watch.VARIABLE, str(file))
    watch._reported.clear()

    def run(function: Callable[[], object]) -> str:
        scheduler = Scheduler(WorldClock())
        scheduler.start()
        done = threading.Event()

        def call() -> None:
            function()
            done.set()

        scheduler.call_soon_threadsafe(call)
        until(done.is_set)
        scheduler.stop()
        return file.read_text() if file.exists() else ""

    return run


@pytest.fixture
def pipe() -> Iterator[tuple[int, int]]:
    ends = os.pipe()
    yield ends
    for end in ends:
        os.close(end)


def test_a_planted_sleep_is_named(told: Callable[[Callable[[], object]], str]) -> None:
    def planted() -> None:
        time.sleep(0.001)

    assert "sleep" in (said := told(planted)) and "in planted" in said


def test_a_planted_write_to_a_pipe_is_named(told: Callable[[Callable[[], object]], str], pipe: tuple[int, int]) -> None:
    assert "write()" in told(lambda: os.write(pipe[1], b"x"))


@pytest.mark.process
def test_starting_and_waiting_for_a_process_are_named(told: Callable[[Callable[[], object]], str]) -> None:
    assert "subprocess.Popen" in told(lambda: subprocess.call([sys.executable, "-c", ""]))


def test_a_wait_that_no_call_betrays_is_named_from_outside(
    told: Callable[[Callable[[], object]], str], tmp_path: Path
) -> None:
    if not hasattr(time, "pthread_getcpuclockid"):
        pytest.skip("this system does not tell the processor time of a thread")
    empty: queue.SimpleQueue[None] = queue.SimpleQueue()

    def planted() -> None:
        empty.get()

    def release() -> None:
        try:
            until((tmp_path / "waits.txt").exists)
        finally:
            empty.put(None)

    threading.Thread(target=release, daemon=True).start()

    assert "a wait of more than 1 s" in (said := told(planted)) and "in planted" in said


def test_waiting_until_a_file_is_on_the_disk_is_named(
    told: Callable[[Callable[[], object]], str], tmp_path: Path
) -> None:
    assert "fsync()" in told(lambda: replace_file(tmp_path / "file.txt", b"text"))


def test_a_disk_that_is_busy_for_long_is_nobodys_fault(
    told: Callable[[Callable[[], object]], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    empty: queue.SimpleQueue[None] = queue.SimpleQueue()
    seen = threading.Event()
    asked: list[int] = []

    def waits(thread: int) -> bool:
        asked.append(thread)
        if len(asked) > 2 * watch.SAMPLES:
            seen.set()
        return True

    monkeypatch.setattr(watch, "_waits_for_disk", waits)
    threading.Thread(target=lambda: (seen.wait(), empty.put(None)), daemon=True).start()
    assert told(empty.get) == ""


def test_work_and_writes_that_cannot_wait_are_not_named(
    told: Callable[[Callable[[], object]], str], pipe: tuple[int, int], tmp_path: Path
) -> None:
    os.set_blocking(pipe[1], False)

    def works() -> None:
        os.write(pipe[1], b"x")
        (tmp_path / "file.txt").write_text("text")
        threading.Thread(target=int).start()
        end = time.thread_time() + 1.5
        while time.thread_time() < end:
            pass

    assert told(works) == ""


def test_a_thread_that_outlives_its_test_is_not_the_next_ones_fault(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, pipe: tuple[int, int]
) -> None:
    first, second = tmp_path / "first.txt", tmp_path / "second.txt"
    monkeypatch.setenv(watch.VARIABLE, str(first))
    scheduler = Scheduler(WorldClock())
    scheduler.start()
    until(lambda: str(first) in watch._threads.values())
    monkeypatch.setenv(watch.VARIABLE, str(second))
    done = threading.Event()
    scheduler.call_soon_threadsafe(lambda: (os.write(pipe[1], b"x"), done.set()))
    until(done.is_set)
    scheduler.stop()
    assert "write()" in first.read_text() and not second.exists()


@pytest.mark.process
def test_other_threads_may_wait(told: Callable[[Callable[[], object]], str]) -> None:
    time.sleep(0.001)
    assert told(lambda: None) == ""
