"""What this machine has room for and what becomes short: computed from what is measured, and told before and in the lesson."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.isolation import left, machine
from day6_core.isolation.groups import Tree
from day6_core.isolation.left import ProcessEntry
from day6_core.isolation.machine import Memory, Taken
from day6_tui.web import class_machine, room
from tests.web.in_process import InProcess, deed_of, place, teaching  # noqa: F401
from tests.web.serving import Browser
from tests.web.test_class_tools import ask, class_of

MB, GB = 1 << 20, 1 << 30
MEMINFO = "MemTotal:  8000000 kB\nMemFree: 1 kB\nMemAvailable:  6000000 kB\n"
SMALL, BIG = Memory(2 * GB, 1500 * MB), Memory(64 * GB, 60 * GB)


def group(folder: Path, **files: str) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name.replace("__", ".")).write_text(text)
    return folder


@pytest.mark.parametrize(
    ("is_v2", "files", "expected"),
    [
        (True, {"memory__max": "max", "memory__current": "5"}, (8000000 << 10, 6000000 << 10)),
        (True, {"memory__max": str(GB), "memory__current": str(700 * MB)}, (GB, 324 * MB)),
        (
            True,
            {"memory__max": str(GB), "memory__current": str(700 * MB), "memory__stat": f"inactive_file {300 * MB}\n"},
            (GB, 624 * MB),
        ),
        (True, {"memory__max": str(GB), "memory__current": str(2 * GB)}, (GB, 0)),
        (False, {"memory__limit_in_bytes": str(GB), "memory__usage_in_bytes": str(GB // 2)}, (GB, GB // 2)),
        (
            False,
            {"memory__limit_in_bytes": str((1 << 63) - 4096), "memory__usage_in_bytes": "1"},
            (8000000 << 10, 6000000 << 10),
        ),
    ],
)
def test_a_limit_of_any_group_above_counts(
    tmp_path: Path, is_v2: bool, files: dict[str, str], expected: tuple[int, int]
) -> None:
    above = group(tmp_path / "above", **files)
    tree = Tree(group(above / "server"), is_v2, frozenset({"memory"}))
    assert machine.memory([tree], MEMINFO) == expected
    assert machine.memory([], "nonsense") is None


@pytest.mark.parametrize(
    ("is_v2", "files", "most"),
    [
        (True, {"cpu__max": "50000 100000\n"}, 0.5),
        (True, {"cpu__max": "max 100000\n"}, None),
        (False, {"cpu__cfs_quota_us": "25000", "cpu__cfs_period_us": "100000"}, 0.25),
        (False, {"cpu__cfs_quota_us": "-1", "cpu__cfs_period_us": "100000"}, None),
    ],
)
def test_cores_that_a_group_may_not_fill_do_not_count(
    tmp_path: Path, is_v2: bool, files: dict[str, str], most: float | None
) -> None:
    tree = Tree(group(tmp_path, **files), is_v2, frozenset({"cpu"}))
    assert machine.cores([tree]) == (machine.cores([]) if most is None else most)


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


def test_a_family_is_all_that_is_below_once_without_the_dead() -> None:
    table = [ProcessEntry(*each) for each in ((2, 1, False), (3, 2, True), (4, 3, False), (5, 4, False), (6, 1, False))]
    assert sorted(left.family(table, [2, 4])) == [4, 5]
    assert left.family(table, [6]) == []


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
    monkeypatch.setattr(machine, "memory", lambda: memory)
    monkeypatch.setattr(machine, "cores", lambda: 4.0)

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
    monkeypatch.setattr(machine, "memory", lambda: Memory(4 * GB, 200 * MB))
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

    monkeypatch.setattr(machine, "memory", lambda: None)
    monkeypatch.setattr("day6_core.isolation.same_user.Nothing.processes_of", cannot)

    async def deed(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            await ask(teacher, "measure")
            found = (await teacher.until(lambda state: state["machine"].get("room")))["machine"]
            assert found["memory"] is None and found["measured"] is False and found["desktops"] == []

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna"))
