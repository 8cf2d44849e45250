"""What a teacher does to desktops, as a real server in this process has it; the desktops are scripted."""

from __future__ import annotations

import asyncio
import threading
from pathlib import Path
from typing import Any

import pytest

from day6_core.isolation.cell import Cell
from day6_core.isolation.mode import Mode
from day6_core.lessons.progress import Progress, StepDone, file_of, load, save
from day6_tui.web import resets
from tests.web.in_time import eventually
from tests.web.serving import WORD
from tests.web.test_show import Classroom, Play, play, quick  # noqa: F401

EVIL = "\x1b]52;c;AAAA\x07\u202e<b>"


async def desk(room: Classroom, do: str, *names: str, **more: object) -> None:
    await room.page.send_json({"t": "desk", "do": do, "names": list(names) or "*", **more})


async def done(room: Classroom, number: int = 1) -> dict[str, Any]:
    """What came of the nth order, once all of it is done."""

    def found() -> dict[str, Any] | None:
        each = next((each for each in room.rows["desks"] if each["id"] == number), None)
        return each if each and each["count"] + len(each["failed"]) >= each["all"] else None

    told = await eventually(found)
    assert told is not None
    return told


def log(room: Classroom) -> list[tuple[str, str, str]]:
    events = room._server._sessions.feed.roster.journal.events()
    return [(event.what, event.name, event.text) for event in events if event.what.startswith(("re", "cl"))]


def home(folder: Path, name: str) -> Path:
    """A home, which scripted desktops do not make."""
    made = folder / "class" / "homes" / name
    made.mkdir(parents=True, exist_ok=True)
    return made


def test_restarted_desktops_end_and_their_tabs_are_told_to_come_back(play: Play) -> None:  # noqa: F811
    async def deed(room: Classroom) -> None:
        anna, ben = await room.pupil("anna"), await room.pupil("ben")
        await desk(room, "restart", "ben", "nobody", EVIL)
        assert await ben.end() == "restart"
        assert (await done(room))["name"] == "ben" and (await done(room))["count"] == 1
        await eventually(lambda: {row["name"]: row["state"] for row in room.rows["rows"]}["ben"] == "gone")
        await room.tab("ben")
        await desk(room, "restart")
        assert await anna.end() == "restart" and (await done(room, 2))["count"] == 2
        assert log(room) == [("restarted", "ben", ""), ("restarted", "anna", ""), ("restarted", "ben", "")] or log(
            room
        ) == [("restarted", "ben", ""), ("restarted", "ben", ""), ("restarted", "anna", "")]
        await desk(room, "restart", "anna")
        assert (await done(room, 3))["failed"] == [["anna", "no desktop is running"]]

    play(deed)


def test_a_place_is_kept_for_who_is_restarted_though_others_wait_for_one(play: Play) -> None:  # noqa: F811
    async def deed(room: Classroom) -> None:
        tabs = {name: await room.pupil(name) for name in ("anna", "ben", "carl")}  # as many as there may be
        await desk(room, "restart", "anna")
        assert await tabs["anna"].end() == "restart"
        await done(room)
        door = await room._browser()
        await door.post("enter", word=WORD, name="dora")
        assert await (await door.tab()).end() == "full"
        await room.tab("anna")

    play(deed)


def test_who_comes_back_while_the_home_is_reset_waits_until_it_is(
    play: Play,  # noqa: F811
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    begun, goes_on, real = threading.Event(), threading.Event(), resets.reset_home

    def slow(mode: Mode, cell: Cell) -> str:
        begun.set()
        assert goes_on.wait(60)
        return real(mode, cell)

    monkeypatch.setattr(resets, "reset_home", slow)

    async def deed(room: Classroom) -> None:
        anna = await room.pupil("anna")
        (home(tmp_path, "anna") / "mine").write_text("1")
        await desk(room, "home", "anna")
        assert await anna.end() == "restart"
        await asyncio.to_thread(begun.wait)
        lines = len(room.desks["anna"].lines)
        back = await room.doors["anna"].tab()
        while not any(message["t"] == "starting" for message in back.said):
            assert await back.hear()
        await desk(room, "restart", "anna")  # from another page of the teacher, perhaps
        assert (await done(room, 2))["failed"][0][1] in ("this is being done already", "no desktop is running")
        assert len(room.desks["anna"].lines) == lines and (home(tmp_path, "anna") / "mine").exists()
        goes_on.set()
        kept = (await done(room))["kept"]
        while not back.got:
            await back.hear()
        assert (tmp_path / "class" / kept / "mine").read_text() == "1"
        assert not (home(tmp_path, "anna") / "mine").exists()
        assert ("reset_home", "anna", kept) in log(room)

    play(deed)


def test_a_lesson_begins_anew_for_the_chosen_and_a_file_that_cannot_be_read_is_told(
    play: Play,  # noqa: F811
    tmp_path: Path,
) -> None:
    async def deed(room: Classroom) -> None:
        tabs = {name: await room.pupil(name) for name in ("anna", "ben", "carl")}
        for name in tabs:
            file = file_of(home(tmp_path, name), name)
            save(file, Progress(name, {"day1": {"one": StepDone(solved=1.0)}}))
        file_of(home(tmp_path, "ben"), "ben").write_bytes(b"[" * 99_999)
        await desk(room, "lesson", "anna", "ben", lesson="day1")
        told = await done(room)
        assert told["failed"] == [["ben", "the progress file cannot be read; it was left as it is"]]
        assert await tabs["anna"].end() == "restart"
        steps = {name: load(file_of(home(tmp_path, name), name)).steps for name in ("anna", "carl")}
        assert steps["anna"] == {} and steps["carl"] != {}
        assert [each[:2] for each in log(room)] == [("reset_lesson", "anna")]

    play(deed)


def test_a_disk_that_is_full_is_told_and_the_desktop_comes_back(
    play: Play,  # noqa: F811
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def full(cell: Cell) -> str:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(resets, "clear_desk", full)

    async def deed(room: Classroom) -> None:
        anna = await room.pupil("anna")
        home(tmp_path, "anna")
        await desk(room, "clear", "anna")
        assert await anna.end() == "restart"
        assert (await done(room))["failed"] == [["anna", "No space left on device"]] and log(room) == []
        await room.tab("anna")

    play(deed)


@pytest.mark.parametrize(
    "message",
    [
        {"do": "rm", "names": ["anna"]},
        {"do": "home", "names": "*"},
        {"do": "home", "names": ["anna", "ben"]},
        {"do": "lesson", "names": ["anna"]},
        {"do": ["restart"], "names": 3},
    ],
)
def test_what_no_page_of_ours_says_does_nothing(play: Play, message: dict[str, Any]) -> None:  # noqa: F811
    async def deed(room: Classroom) -> None:
        anna = await room.pupil("anna")
        await room.page.send_json({"t": "desk", **message})
        await eventually(lambda: room.page.closed)
        assert room._server._sessions.has_tab("anna") and log(room) == [] and not anna.ws.closed

    play(deed)
