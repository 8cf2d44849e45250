"""What stands around a process: how it begins, its limits, its signals and its input, and what follows when something fails."""

from __future__ import annotations

import io
import os
import signal
import sys
import threading
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.session.streams import Captured, TextInput
from day6_core.shell.process import heap, launch_process, pty_keys
from day6_core.shell.process import process as process_module
from day6_core.shell.process.feeder import FULL, Feeder
from day6_core.shell.process.output_copy import read_waiting
from day6_core.shell.process.process import Process, running_processes
from tests.support.waiting import until

posix = pytest.mark.skipif(os.name != "posix", reason="needs ptys and signals")


# -- how it begins -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("limits", "wish", "now"),
    [
        ((-1, -1), 300, (300, -1)),
        ((200, -1), 300, (200, -1)),
        ((400, -1), 300, (300, -1)),
        ((300, -1), 300, (300, -1)),
        ((-1, 250), 300, (250, 250)),
        ((100, 250), 300, (100, 250)),
    ],
)
@posix
def test_data_is_limited_and_a_lower_limit_stays(
    monkeypatch: pytest.MonkeyPatch, limits: tuple[int, int], wish: int, now: tuple[int, int]
) -> None:
    import resource

    limits = tuple(resource.RLIM_INFINITY if each == -1 else each for each in limits)
    now = tuple(resource.RLIM_INFINITY if each == -1 else each for each in now)
    kept = {resource.RLIMIT_DATA: limits}
    monkeypatch.setattr(resource, "getrlimit", kept.__getitem__)
    monkeypatch.setattr(resource, "setrlimit", kept.__setitem__)
    launch_process.limit_memory(wish)
    assert kept == {resource.RLIMIT_DATA: now}


@posix
@pytest.mark.parametrize("problem", [ValueError, OSError])
def test_a_system_that_does_not_limit_data_is_no_problem(
    monkeypatch: pytest.MonkeyPatch, problem: type[Exception]
) -> None:
    import resource

    def refused(*_: object) -> None:
        raise problem

    monkeypatch.setattr(resource, "setrlimit", refused)
    launch_process.limit_memory(10)


@posix
@pytest.mark.parametrize("mode", ["tty", "no-tty"])
@pytest.mark.parametrize("memory", ["0", "500"])
def test_a_process_is_launched_with_its_terminal_priority_and_limit(
    monkeypatch: pytest.MonkeyPatch, mode: str, memory: str
) -> None:
    import fcntl
    import resource
    import termios

    done: list[object] = []
    limits = {resource.RLIMIT_CORE: (5, 7), resource.RLIMIT_DATA: (resource.RLIM_INFINITY, resource.RLIM_INFINITY)}
    monkeypatch.setattr(sys, "argv", ["launch_process.py", mode, "10", memory, "/bin/prog", "prog", "a", "b"])
    monkeypatch.setattr(signal, "signal", lambda number, handler: done.append((number, handler)))
    monkeypatch.setattr(fcntl, "ioctl", lambda *words: done.append(words))
    monkeypatch.setattr(os, "nice", lambda by: done.append(("nice", by)))
    monkeypatch.setattr(os, "execv", lambda *words: done.append(words))
    monkeypatch.setattr(resource, "getrlimit", limits.__getitem__)
    monkeypatch.setattr(resource, "setrlimit", limits.__setitem__)
    launch_process.main()
    ended = [
        (number, signal.SIG_DFL)
        for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE)
    ]
    terminal = [(0, termios.TIOCSCTTY, 0)] if mode == "tty" else []
    assert done == [*ended, *terminal, ("nice", 10), ("/bin/prog", ["prog", "a", "b"])]
    assert limits[resource.RLIMIT_CORE] == (0, 7)
    assert limits[resource.RLIMIT_DATA][0] == (resource.RLIM_INFINITY if memory == "0" else 500)


def test_a_process_in_a_folder_that_was_removed_says_so(machine: Any) -> None:
    result = machine.run("mkdir d; cd d; rmdir ../d; python3 -c 'print(1)'; echo $?")
    assert result.out == "1\n" and result.err.startswith("python3: ") and result.err.count("\n") == 1


@pytest.mark.process
@pytest.mark.parametrize("piped", [True, False])
def test_a_process_that_cannot_be_started_ends_its_command(
    machine: Any, seat: Any, monkeypatch: pytest.MonkeyPatch, piped: bool
) -> None:
    def failing(*_: object, **__: object) -> None:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr("day6_core.shell.process.process.subprocess.Popen", failing)
    seat.line("python3 -c 1 | cat" if piped else "python3 -c 1")
    seat.wait_prompt()
    assert "Resource temporarily unavailable" in seat.look()
    assert running_processes(machine.desk.scheduler) == []
    assert seat.line("echo goes on").splitlines()[-2] == "goes on"


# -- signals -----------------------------------------------------------------------------------------------------------


class Sent(Process):
    """A process that only notes what it is sent."""

    def __init__(self, machine: Any) -> None:
        super().__init__(machine.start("true").session, [])
        self.numbers: list[int] = []

    def send(self, number: int) -> None:
        self.numbers.append(number)


@posix
def test_a_process_stands_still_as_long_as_anybody_wants_it_to(machine: Any) -> None:
    sent = Sent(machine)
    stop, go_on = 19, 18
    for stopped, reason, number in [
        (True, "job", stop),
        (True, "world", stop),
        (False, "job", stop),
        (False, "world", go_on),
        (False, "world", go_on),
    ]:
        sent.pause(stopped, reason)
        assert sent.numbers[-1] == number
    sent.interrupt()
    sent.kill()
    assert sent.numbers[-2:] == [2, 9]


@pytest.mark.process
@posix
def test_a_signal_from_before_the_process_began_arrives(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    begin = threading.Event()
    launch = Process._launch

    def late(self: Process) -> None:
        assert begin.wait()
        launch(self)

    monkeypatch.setattr(Process, "_launch", late)
    program = machine.start("python3 -c 'import time; time.sleep(1000)'; echo $?")
    machine.go()
    for each in machine.desk.programs.values():
        if each.session.argv[0] == "python3":
            each.send(15)
    machine.go()
    begin.set()
    machine.wait(lambda: program.status is not None)
    assert machine.out.text == "143\n"


def test_a_process_that_is_gone_is_sent_nothing(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    gone = Process(machine.start("true").session, [])
    assert gone.pid == 0
    gone._early = None
    gone.send(15)  # it could not be started
    assert not gone.wants_signal_keys()
    gone.resize(10, 10)
    gone.keys("x")


@pytest.mark.process
@posix
@pytest.mark.parametrize("problem", [ProcessLookupError, PermissionError])
def test_what_is_left_of_a_group_gets_term_and_then_kill(
    monkeypatch: pytest.MonkeyPatch, problem: type[OSError]
) -> None:
    sent: list[tuple[int, int]] = []
    gone, left = 2**30, 2**30 + 1  # higher than any process's number
    killpg = os.killpg

    def note(group: int, number: int) -> None:
        if group not in (gone, left):
            killpg(group, number)
            return
        sent.append((group, number))
        if group == gone or number == 9:
            raise problem

    monkeypatch.setattr(os, "killpg", note)
    process_module._end_group(gone)
    process_module._end_group(left)
    assert sent == [(gone, 15), (left, 15), (left, 9)]


# -- input and output --------------------------------------------------------------------------------------------------


class Pipe(io.BytesIO):
    """Notes what is flushed; `broken` as soon as that many bytes were written."""

    def __init__(self, broken: int | None = None) -> None:
        super().__init__()
        self.flushed = b""
        self.closings = 0
        self.broken = broken

    def write(self, data: Any) -> int:
        if self.broken is not None and len(self.getvalue()) >= self.broken:
            raise BrokenPipeError
        return super().write(data)

    def flush(self) -> None:
        self.flushed = self.getvalue()

    def close(self) -> None:
        self.closings += 1


def test_what_is_fed_arrives_at_once_and_an_empty_piece_closes_the_pipe() -> None:
    pipe = Pipe()
    feeder = Feeder(pipe)
    feeder.put(b"one\n")
    assert until(lambda: pipe.flushed == b"one\n")
    feeder.put(b"two\n")
    assert until(lambda: pipe.flushed == b"one\ntwo\n")
    assert not feeder.broken and not feeder.is_full and pipe.closings == 0
    feeder.put(b"")
    assert until(lambda: feeder.broken and feeder.has_room.is_set())
    assert pipe.closings == 1


def test_a_pipe_whose_reader_is_gone_is_broken_and_never_full() -> None:
    pipe = Pipe(broken=0)
    feeder = Feeder(pipe)
    feeder.put(b"x" * (FULL + 1))
    assert until(lambda: feeder.broken and feeder.has_room.is_set())
    feeder.put(b"x" * (FULL + 1))
    assert not feeder.is_full and pipe.closings == 1


def test_a_feeder_is_full_when_more_than_its_bound_waits() -> None:
    begin = threading.Event()

    class Slow(Pipe):
        def write(self, data: Any) -> int:
            assert begin.wait()
            return super().write(data)

    pipe = Slow()
    feeder = Feeder(pipe)
    feeder.put(b"x" * FULL)
    assert not feeder.is_full
    feeder.put(b"y")
    assert feeder.is_full and not feeder.has_room.is_set()
    begin.set()
    assert until(lambda: not feeder.is_full and feeder.has_room.is_set())
    assert until(lambda: pipe.flushed == b"x" * FULL + b"y")
    feeder.put(b"")


@posix
def test_all_that_is_there_is_read_at_once_and_what_breaks_is_the_end() -> None:
    reading, writing = os.pipe()
    os.set_blocking(reading, False)
    os.write(writing, b"one")
    assert read_waiting(reading) == b"one"
    os.write(writing, b"two")
    os.close(writing)
    assert read_waiting(reading) == b"two"
    assert read_waiting(reading) == b""
    os.close(reading)
    with pytest.raises(OSError):
        read_waiting(reading)


@posix
def test_keys_put_after_the_end_are_the_next_readers_and_never_another_programs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(pty_keys, "LOOK_AGAIN", 0.01)
    monkeypatch.setattr(os, "tcgetpgrp", lambda fd: os.getpid())
    (reading, writing), (next_reading, next_writing) = os.pipe(), os.pipe()
    keys = pty_keys.PtyKeys(writing, reading)
    keys.put(b"x" * 200_000)  # more than there is room for: its thread waits
    flusher = keys._flusher
    assert flusher is not None and keys.close()
    keys.put(b"late\n")
    os.dup2(next_writing, writing)  # closed, and the number is the next program's at once
    flusher.join(10)
    assert not flusher.is_alive() and keys.close() == b"late\n"
    os.set_blocking(next_reading, False)
    with pytest.raises(BlockingIOError):
        os.read(next_reading, 100)
    for fd in (reading, writing, next_reading, next_writing):
        os.close(fd)


@posix
def test_what_copies_output_never_reads_that_of_the_program_that_got_its_number(machine: Any) -> None:
    session, target = SimpleNamespace(scheduler=machine.desk.scheduler, stdin=TextInput("")), Captured()
    ended = Process(session, ["talker"])  # type: ignore[arg-type]
    (reading, writing), (next_reading, next_writing) = os.pipe(), os.pipe()
    os.set_blocking(reading, False)
    ended._master = reading
    ended._read(reading, target)
    os.write(writing, b"its own")
    until(lambda: target.text == "its own")
    left = os.dup(reading)
    ended._close_master()
    os.dup2(next_reading, reading)
    os.write(next_writing, b"the next program's")
    os.write(writing, b"too late")  # from what it left behind
    until(lambda: not ended._copies[0].is_alive())
    assert target.text == "its own"
    assert os.read(next_reading, 100) == b"the next program's"
    for fd in (left, reading, writing, next_reading, next_writing):
        os.close(fd)


@pytest.mark.process
def test_a_process_without_input_meets_its_end_at_once(machine: Any) -> None:
    (machine.desk.home / "a.py").write_text("import sys\nprint(repr(sys.stdin.read()))\n", encoding="utf-8")
    assert machine.run("python3 a.py < /dev/null").out == "''\n"
    assert machine.run("python3 a.py & wait").out == "''\n"
    assert machine.run("printf 'a\\nb' | python3 a.py").out == "'a\\nb'\n"
    assert machine.run("python3 a.py", stdin="given\n").out == "'given\\n'\n"
    assert machine.run("echo q > f; python3 a.py < f").out == "'q\\n'\n"


@pytest.mark.process
def test_bytes_that_are_no_text_pass_a_process_unchanged(machine: Any) -> None:
    home: Path = machine.desk.home
    (home / "up.py").write_text("import sys\nsys.stdout.buffer.write(sys.stdin.buffer.read())\n", encoding="utf-8")
    (home / "in").write_bytes(b"\xff\xfe\xc3\xa4\n\x80")
    assert machine.run("cat in | python3 up.py | cat > out").err == ""
    assert (home / "out").read_bytes() == b"\xff\xfe\xc3\xa4\n\x80"


# -- the heap ----------------------------------------------------------------------------------------------------------


class Enough(BaseException):
    pass


@pytest.mark.parametrize(
    ("system", "names", "calls"),
    [
        ("linux", ["mallopt", "malloc_trim"], [("mallopt", -8, 1), ("slept", 30.0), ("malloc_trim", 0)]),
        ("linux", ["malloc_trim"], []),
        ("linux", ["mallopt"], []),
        ("darwin", ["mallopt", "malloc_trim"], []),
        ("win32", ["mallopt", "malloc_trim"], []),
    ],
)
def test_the_heap_is_one_and_is_given_back_now_and_then_where_the_c_library_can(
    monkeypatch: pytest.MonkeyPatch, system: str, names: list[str], calls: list[object]
) -> None:
    import ctypes

    done: list[object] = []

    class Library:
        pass

    class Thread:
        def __init__(self, target: Any, name: str, daemon: bool) -> None:
            assert (name, daemon) == ("day6-heap", True)
            self.target = target

        def start(self) -> None:
            with pytest.raises(Enough):
                self.target()

    def sleep(seconds: float) -> None:
        if len(done) > 2:
            raise Enough
        done.append(("slept", seconds))

    library = Library()
    for each in names:
        setattr(library, each, lambda *words, each=each: done.append((each, *words)))
    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(ctypes, "CDLL", lambda name: library)
    monkeypatch.setattr(heap, "threading", SimpleNamespace(Thread=Thread))
    monkeypatch.setattr(heap, "time", SimpleNamespace(sleep=sleep))
    heap.keep_heap_small()
    assert done == calls
