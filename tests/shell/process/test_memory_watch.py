"""Where the system doesn't hold programs to a limit of memory, the largest process of one that has too much is ended."""

from __future__ import annotations

import pytest

from day6_core.shell.process import memory, memory_watch, prepared
from day6_core.shell.process.memory_watch import MemoryWatch, too_large
from day6_core.system.processes import ProcessEntry

MB = 1 << 20
TABLE = [
    ProcessEntry(10, 1, False, 10, 20 * MB),
    ProcessEntry(11, 10, False, 10, 300 * MB),
    ProcessEntry(12, 11, False, 12, 400 * MB),  # in a session of its own, and still below
    ProcessEntry(13, 1, False, 10, 500 * MB),  # its parent has ended, and it is still in the group
    ProcessEntry(14, 10, True, 10, 900 * MB),
    ProcessEntry(20, 1, False, 20, 999 * MB),
    ProcessEntry(30, 0, False, 0, 999 * MB),
]


@pytest.mark.parametrize(
    ("table", "program", "limit", "expected"),
    [
        (TABLE, 10, 200, 13),
        (TABLE[:3], 10, 200, 12),
        (TABLE[:2], 10, 200, 11),
        (TABLE, 10, 500, None),
        (TABLE, 10, 0, None),
        (TABLE, 0, 200, None),  # it is being started
        (TABLE, 99, 200, None),
        ([], 10, 200, None),
    ],
)
def test_the_largest_of_a_program_is_ended(
    table: list[ProcessEntry], program: int, limit: int, expected: int | None
) -> None:
    assert too_large(table, program, limit * MB) == expected


class Program:
    def __init__(self, pid: int) -> None:
        self.pid = pid
        self.ended: list[tuple[int, int]] = []

    def end_for_memory(self, pid: int, limit: int) -> None:
        self.ended.append((pid, limit))


def test_each_program_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(memory.VARIABLE, "450")
    monkeypatch.setattr(memory_watch, "processes", lambda: TABLE)
    programs = [Program(pid) for pid in (10, 20, 40)]
    MemoryWatch(lambda: programs).look()
    assert [each.ended for each in programs] == [[(13, 450 * MB)], [(20, 450 * MB)], []]


@pytest.mark.parametrize(("held", "wish", "threads"), [(True, "300", 0), (False, "0", 0), (False, "300", 1)])
def test_one_thread_looks_as_long_as_programs_run(
    monkeypatch: pytest.MonkeyPatch, held: bool, wish: str, threads: int
) -> None:
    started: list[MemoryWatch] = []
    looks: list[int] = []
    running = [Program(10)]

    class Thread:
        def __init__(self, **_: object) -> None: ...

        def start(self) -> None:
            started.append(watch)

    def sleep(seconds: float) -> None:
        looks.append(len(running))
        if len(looks) == 3:
            running.clear()

    monkeypatch.setenv(memory.VARIABLE, wish)
    monkeypatch.setattr(memory_watch, "is_held_by_system", lambda: held)
    monkeypatch.setattr(memory_watch, "processes", list)
    monkeypatch.setattr(memory_watch.threading, "Thread", Thread)
    monkeypatch.setattr(memory_watch.time, "sleep", sleep)
    watch = MemoryWatch(lambda: running)
    watch.begin()
    watch.begin()
    assert len(started) == threads
    if threads:
        watch._run()
        assert looks == [1, 1, 1]
        running.append(Program(11))
        watch.begin()
        assert len(started) == 2, "it had come to its end"


def test_a_system_that_would_limit_addresses_gets_no_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(memory.VARIABLE, "300")
    monkeypatch.setattr(prepared.sys, "platform", "darwin")
    monkeypatch.setattr(prepared, "is_held_by_system", lambda: False)
    words = prepared.prepared(["/bin/prog", "a"])
    assert list(words[-5:]) == ["10", "0", "/bin/prog", "/bin/prog", "a"]
