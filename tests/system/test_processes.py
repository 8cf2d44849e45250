"""Which processes there are and what they take, with /proc and, as on macOS, without it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator

import pytest

from day6_core.system import processes
from day6_core.system.processes import ProcessEntry

posix = pytest.mark.skipif(os.name != "posix", reason="there is no ps")


@pytest.fixture(params=["proc", "ps"])
def way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """The way by which processes are looked for."""
    if request.param == "ps":
        monkeypatch.setattr(processes, "PROC", "/nothing/here")
    elif not processes.has_proc():
        pytest.skip("no /proc to look at")
    return str(request.param)


class Sleeper(subprocess.Popen[bytes]):
    """A process that bears a mark."""

    def __init__(self, mark: str) -> None:
        code = "import time; print(flush=True); time.sleep(1000)"
        env = {**os.environ, "DAY6_TEST_MARK": mark}
        super().__init__([sys.executable, "-c", code], env=env, stdout=subprocess.PIPE, start_new_session=True)
        assert self.stdout is not None
        self.stdout.readline()


@pytest.fixture
def sleeper() -> Iterator[Sleeper]:
    with Sleeper("a1b2") as process:
        yield process
        process.kill()


def test_a_family_is_all_that_is_below_once_without_the_dead() -> None:
    table = [ProcessEntry(*each) for each in ((2, 1, False), (3, 2, True), (4, 3, False), (5, 4, False), (6, 1, False))]
    assert sorted(processes.family(table, [2, 4])) == [4, 5]
    assert processes.family(table, [6]) == []
    assert sorted(processes.family(table, [2], dead=True)) == [3, 4, 5]


@pytest.mark.process
@posix
def test_the_table_has_each_process_with_its_parent_group_and_memory(way: str, sleeper: Sleeper) -> None:
    (found,) = (each for each in processes.processes() if each.pid == sleeper.pid)
    assert found[:4] == (sleeper.pid, os.getpid(), False, sleeper.pid)
    assert 1 << 20 < found.resident < 1 << 30
    assert sleeper.pid in processes.descendants(os.getpid())
    assert 1 << 20 < processes.own_memory([sleeper.pid]) <= found.resident * 1.5
    assert processes.own_memory([]) == 0


@pytest.mark.process
@posix
def test_who_looks_does_not_count(way: str) -> None:
    """In a process of its own: this one may have children of other tests."""
    code = f"import os; from day6_core.system import processes; processes.PROC = {processes.PROC!r}\n"
    code += "print(processes.descendants(os.getpid()))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout.split() == [b"[]"]


@pytest.mark.process
@posix
def test_a_dead_process_counts_only_if_asked_for(way: str) -> None:
    process = Sleeper("dead")
    os.kill(process.pid, 9)
    os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
    assert process.pid not in processes.descendants(os.getpid())
    assert process.pid in processes.descendants(os.getpid(), dead=True)
    process.communicate()


@pytest.mark.process
@posix
def test_a_process_is_found_by_its_mark_and_only_by_the_whole_of_it(way: str, sleeper: Sleeper) -> None:
    assert processes.marked("DAY6_TEST_MARK=a1b2") == [sleeper.pid]
    assert processes.marked("DAY6_TEST_MARK=a1b") == []


@pytest.mark.process
@posix
def test_the_shell_finds_all_marks_that_begin_alike_but_not_itself(way: str, sleeper: Sleeper) -> None:
    script = processes.shell_marked() + "read -r mark\nmarked\n"
    found = subprocess.run(["/bin/sh", "-c", script], input=b"DAY6_TEST_MARK=a1\n", capture_output=True, check=True)
    assert found.stdout.split() == [str(sleeper.pid).encode()], found.stderr


def test_a_system_without_ps_shows_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(*_: object, **__: object) -> None:
        raise FileNotFoundError

    monkeypatch.setattr(processes, "PROC", "/nothing/here")
    monkeypatch.setattr(subprocess, "Popen", missing)
    assert processes.processes() == processes.marked("A=b") == []
    assert processes.own_memory([1]) == 0
