"""What this machine has room for and what becomes short: computed from what is measured, and told before and in the lesson."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.isolation import machine
from day6_core.isolation.machine import Taken
from day6_core.system import memory as system_memory
from day6_core.system.memory import Memory
from day6_tui.web import class_machine, room
from tests.web.in_process import InProcess, deed_of, place, teaching  # noqa: F401
from tests.web.serving import Browser
from tests.web.test_class_tools import ask, class_of

MB, GB = 1 << 20, 1 << 30
SMALL, BIG = Memory(2 * GB, 1500 * MB), Memory(64 * GB, 60 * GB)


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="this system does not tell what processes take")
def test_what_processes_take_is_measured_and_who_has_ended_takes_nothing() -> None:
    mine = machine.taken([os.getpid()])
    assert mine.memory > 5 * MB and len(mine.seconds) == 1
    assert machine.taken([4_000_000]) == Taken(0, {})


def test_the_share_of_a_core_counts_new_processes_and_none_that_only_has_the_number_of_an_old_one() -> None:
    before = Taken(0, {(7, 100): 5.0, (8, 100): 9.0})
    now = Taken(0, {(7, 100): 6.0, (9, 250): 0.5, (8, 300): 0.25})
    assert machine.share(before, now, 2.0) == (1.0 + 0.5 + 0.25) / 2
    assert machine.share(before, Taken(0, {}), 2.0) == 0.0


# -- room --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("memory", "cores", "running", "desktop", "most", "expected", "why"),
    [
        (Memory(4 * GB, 3 * GB), 4.0, [], None, 40, 13, "serve.room.memory.unmeasured"),
        (Memory(4 * GB, 3 * GB), 4.0, [], 40 * MB, 40, 15, "serve.room.memory"),
        (Memory(4 * GB, 3 * GB - 600 * MB), 4.0, [60 * MB] * 10, 40 * MB, 40, 15, "serve.room.memory"),
        (BIG, 1.0, [], None, 40, 24, "serve.room.cores"),
        (BIG, 16.0, [], None, 12, 12, "serve.room.most"),
        (BIG, 16.0, [], None, 400, 281, "serve.room.memory.unmeasured"),
        (Memory(GB, 100 * MB), 2.0, [], None, 40, 0, "serve.room.memory.unmeasured"),
        (None, 2.0, [], None, 400, 48, "serve.room.cores"),
    ],
)
def test_room_is_what_memory_cores_and_the_server_allow(
    memory: Memory | None, cores: float, running: list[int], desktop: int | None, most: int, expected: int, why: str
) -> None:
    found = room.room(memory, cores, running, desktop, most)
    assert (found.desktops, found.why.key) == (expected, why)


@pytest.mark.parametrize("content", [b"", b"x", b"-5\n", b"1\n", b"9" * 30, b"\xff"])
def test_what_is_remembered_of_a_desktop_is_not_believed_when_it_cannot_be(tmp_path: Path, content: bytes) -> None:
    room.remember(tmp_path, 58 * MB)
    assert room.remembered(tmp_path) == 58 * MB
    (tmp_path / "desktop-memory").write_bytes(content)
    assert room.remembered(tmp_path) is None


@pytest.mark.parametrize(
    ("memory", "count", "more", "told"),
    [
        (SMALL, 20, {}, ("serve.room.small", 6, 20)),
        (SMALL, 5, {}, None),
        (BIG, 20, {}, None),
        (BIG, 20, {"most": 12}, ("serve.room.small", 12, 20)),
        (SMALL, 0, {}, ("serve.room.small.most", 6, 40)),
        (BIG, 0, {"most": 30}, None),
    ],
)
def test_a_machine_that_is_too_small_is_told_before_the_lesson_and_on_the_page_and_no_other(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    memory: Memory,
    count: int,
    more: dict[str, Any],
    told: tuple[str, int, int] | None,
) -> None:
    monkeypatch.setattr(system_memory, "available", lambda: memory)
    monkeypatch.setattr(system_memory, "cores", lambda: 4.0)

    async def deed(made: InProcess, door: Browser) -> None:
        found = [
            (key, made.values[at]["room"], made.values[at]["wanted"])
            for at, key in enumerate(made.said)
            if "room" in key
        ]
        assert found == ([told] if told else [])
        async with teaching(made) as teacher:
            await ask(teacher, "measure")
            state = await teacher.until(lambda state: state["machine"].get("room"))
            is_small = told is not None and count > 0
            warnings = [each for each in state["machine"]["warnings"] if "are on the list" in each]
            assert len(warnings) == is_small and state["machine"]["desktops"] == []
            if told is not None and is_small:
                assert warnings[0].startswith(f"room for {told[1]} desktops on this machine, {count} are on the list")

    deed_of(
        tmp_path, deed, **more, **(class_of(tmp_path, *(f"pupil {number}" for number in range(count))) if count else {})
    )


# -- what becomes short ------------------------------------------------------------------------------------------------


def test_what_becomes_short_is_told_with_who_takes_it_also_to_a_page_that_does_not_ask(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(system_memory, "available", lambda: Memory(4 * GB, 200 * MB))
    monkeypatch.setattr(shutil, "disk_usage", lambda folder: SimpleNamespace(free=300 * MB))
    sizes = {"anna": 5 * MB, "李雷": 90 * MB}
    for name in sizes:
        (tmp_path / "class" / "homes" / name).mkdir(parents=True)
    monkeypatch.setattr(class_machine, "disk_of", lambda home: sizes[home.name])

    async def deed(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            state = await teacher.until(lambda state: state["machine"]["warnings"])
            memory, disk, small = state["machine"]["warnings"]
            assert memory == "memory: 200 MB left"  # nobody runs
            assert disk == "disk: 300 MB left (most of it is taken by 李雷: 90 MB)"
            assert small.startswith("room for 0 desktops") and state["machine"].keys() == {"warnings"}

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna", "李雷", "carl"))


def test_where_the_system_tells_nothing_no_figure_is_shown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def cannot(self: object, cells: object) -> None:
        raise OSError(38, "Function not implemented")

    monkeypatch.setattr(system_memory, "available", lambda: None)
    monkeypatch.setattr("day6_core.isolation.same_user.Nothing.processes_of", cannot)

    async def deed(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            await ask(teacher, "measure")
            found = (await teacher.until(lambda state: state["machine"].get("room")))["machine"]
            assert found["memory"] is None and found["measured"] is False and found["desktops"] == []

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna"))
