"""A mistake of ours in a thread: what waits for the thread goes on, and no traceback of ours is on the screen."""

from __future__ import annotations

import os
import signal
import sys
import threading
from pathlib import Path
from typing import Any

import pytest

from day6_core.session import real_streams
from day6_core.session.clock import WorldClock
from day6_core.session.ending import Ending, EndingStep
from day6_core.session.real_streams import RealInput
from day6_core.session.scheduler import Scheduler
from day6_core.session.streams import Captured
from day6_core.shell.process import process
from day6_core.shell.process.feeder import Feeder
from day6_core.shell.process.output_copy import OutputCopy, read_at_once
from day6_core.workspace import build
from tests.support.waiting import run, until

NEVER = 1000.0
posix = pytest.mark.skipif(os.name != "posix", reason="needs Unix's pipes and processes")
pytestmark = pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")


def breaks(*arguments: object, **named: object) -> Any:
    raise RuntimeError("planted")


class Broken(Captured):
    """A stream that fails of a mistake, not of a reader who has gone."""

    def write(self, text: str) -> int:
        return breaks()


@posix
def test_what_copies_output_reads_on_so_that_the_process_can_end() -> None:
    reading, writing = os.pipe()
    pump = OutputCopy(open(reading, "rb"), Broken(), None, read_at_once)  # noqa: SIM115
    pump.start()
    for _ in range(100):
        os.write(writing, b"x" * 65536)  # far more than a pipe holds
    os.close(writing)
    until(lambda: not pump.is_alive())


@pytest.mark.process
@posix
@pytest.mark.parametrize("planted", ["_end_group", "end_marked", "release", "_set_window_size", "guard"])
def test_a_process_whose_thread_fails_gives_the_prompt_back(
    machine: Any, monkeypatch: pytest.MonkeyPatch, planted: str
) -> None:
    monkeypatch.setattr(process, planted, breaks)
    machine.run("python3 -c 'print(1)'")
    assert not process.running_processes(machine.desk.scheduler)
    monkeypatch.undo()
    assert machine.run("echo 42").out == "42\n"


def test_what_feeds_a_process_says_that_it_will_not_write_any_more() -> None:
    class Pipe:
        write = flush = breaks

        def close(self) -> None:
            """Closed."""

    feeder = Feeder(Pipe())  # type: ignore[arg-type]
    feeder.put(b"x" * 1_000_000)
    until(lambda: feeder.broken)
    assert not feeder.is_full


def test_the_scheduler_goes_on_with_everybody_else(monkeypatch: pytest.MonkeyPatch) -> None:
    scheduler = Scheduler(WorldClock())
    failures = []

    def announce() -> None:
        failures.append(1)
        breaks()

    scheduler.on_activity = announce
    scheduler.start()
    try:
        for _ in range(3):
            heard = threading.Event()
            scheduler.call_soon_threadsafe(heard.set)
            until(heard.is_set)
    finally:
        scheduler.on_activity = None
        scheduler.stop()
    assert failures


def test_a_reader_of_standard_input_that_fails_is_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(real_streams.codecs, "getincrementaldecoder", breaks)
    stream = RealInput()
    lines: list[str] = []

    async def read() -> None:
        lines.append(await stream.read_line())

    scheduler = Scheduler(WorldClock())
    task = scheduler.spawn(read())
    until(lambda: scheduler.run(lambda: task.finished, 0.05), every=0.0)
    assert lines == [""]


@posix
def test_a_signal_is_heard_although_waking_the_application_failed() -> None:
    heard = threading.Event()
    ending = Ending(EndingStep(heard.set, NEVER), EndingStep(breaks, NEVER))
    ending.wake_main_thread = breaks
    numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR2)
    before = {number: signal.getsignal(number) for number in numbers}
    signal.signal(signal.SIGUSR2, lambda number, frame: None)
    ending.handle_signals()
    try:
        os.kill(os.getpid(), signal.SIGUSR2)  # only wakes
        os.kill(os.getpid(), signal.SIGTERM)
        until(heard.is_set)
    finally:
        ending.over()
        for number, handler in before.items():
            signal.signal(number, handler)


def test_a_download_that_fails_tells_its_program(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("day6_core.shell.builtins.download._ask", breaks)
    machine.run("curl http://localhost/x")
    assert machine.run("echo 42").out == "42\n"


@pytest.mark.parametrize("error", [RuntimeError, SystemExit])
def test_a_job_of_colcon_that_fails_ends_the_build(
    machine: Any, monkeypatch: pytest.MonkeyPatch, error: type[BaseException]
) -> None:
    def fail(*arguments: object) -> Any:
        raise error("planted")

    machine.run("mkdir -p ~/ws/src && cd ~/ws/src && ros2 pkg create --build-type ament_python p")
    monkeypatch.setitem(build._TASKS, "ros.ament_python", fail)
    failed = machine.run("cd ~/ws && colcon build")
    assert failed.status != 0 and "planted" in failed.out + failed.err
    assert machine.run("echo 42").out == "42\n"


PLANTED = """\
import sys, threading
from day6_core.shell.process.output_copy import OutputCopy
from day6_tui.main import main
def breaks(*a): raise RuntimeError('planted')
OutputCopy.run = breaks
sys.argv[1:] = ['exec', '--home', sys.argv[1], '-c', "python3 -c 'print(1)' | cat; echo $((6*7))"]
sys.exit(main())
"""


@pytest.mark.process
def test_a_thread_that_fails_outside_the_desktop_is_told_in_one_line(tmp_path: Path) -> None:
    done = run([sys.executable, "-c", PLANTED, str(tmp_path)], env={**os.environ, "DAY6_LINK": "off"})
    assert "Traceback" not in done.stderr
    assert "day6-tui: RuntimeError: planted" in done.stderr
    assert "42" in done.stdout
