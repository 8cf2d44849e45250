"""Assignments: handed out, collected from whoever is or was there, graded, marked and given back. All in this process."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import itertools
import json
import os
import socket
import threading
import zipfile
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from aiohttp import WSMsgType

from day6_core.classroom import note as notes
from day6_core.classroom.note import LessonPlace, Note
from day6_core.lessons.grading.archive import unpack
from day6_core.lessons.progress import Progress
from day6_core.lessons.work import Task, Work, pack
from day6_core.whole_file import write_private
from day6_tui.classes.marks import Marks
from day6_tui.detached import meeting, wire
from day6_tui.web import assignment_desk, assignment_giving, assignments, class_page
from day6_tui.web.assignments import Word
from day6_tui.web.grading_room import GradingRoom, NotGraded, report_of
from tests.support.waiting import Deadline, until
from tests.web.in_process import InProcess, serving
from tests.web.in_time import eventually, in_time
from tests.web.serving import browser, run

DESKS: list[assignment_desk.AssignmentDesk] = []
"""Those of the servers that have begun."""
PROGRESS = ".config/day6-tui/pupils/me.json"


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path / "run"))
    monkeypatch.setattr(class_page, "PAUSE", 0.01)
    monkeypatch.setattr(assignment_giving, "PAUSE", 0.01)
    begin = assignment_desk.AssignmentDesk.begin

    def noted(desk: assignment_desk.AssignmentDesk) -> None:
        DESKS.append(desk)
        begin(desk)

    monkeypatch.setattr(assignment_desk.AssignmentDesk, "begin", noted)
    monkeypatch.setattr(meeting, "connect", lambda *_: None)  # no desktop runs


class Pupil:
    """A pupil's desktop without a desktop: it says notes, and hears orders."""

    def __init__(self, made: InProcess, name: str, folder: Path) -> None:
        self.name = name
        self.home = folder / "class" / "homes" / name
        self._made = made
        self.orders: list[dict[str, Any]] = []

    def come(self) -> None:
        self.home.mkdir(parents=True, exist_ok=True)
        ours, theirs = socket.socketpair()
        self._line = wire.Connection(theirs)
        self._made.sessions.feed.begin(self.name, ours)
        self.say()

    def say(self, **note: Any) -> None:
        self._line.send(wire.NOTE, notes.encode(Note(**note)))

    async def hears(self, do: str) -> str:
        """The text of the next order of this kind."""

        def heard() -> dict[str, Any] | None:
            self.orders += [json.loads(data) for kind, data in self._line.receive() if kind == wire.ORDER]
            return next((order for order in self.orders if order["do"] == do), None)

        order = await eventually(heard, lambda: self.orders)
        assert order is not None
        self.orders.remove(order)
        return str(order.get("text", ""))

    def leave(self) -> None:
        self._made.sessions.feed.end(self.name)

    def solve(self, lesson: str, *steps: str, answers: str = "") -> None:
        file = self.home / PROGRESS
        file.parent.mkdir(parents=True, exist_ok=True)
        known = {step: {"solved": 1000.0, "answers": answers} for step in steps}
        file.write_text(json.dumps({"version": 1, "steps": {lesson: known}}))

    def write(self, path: str, text: str) -> None:
        file = self.home / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


class Teacher:
    """The class page without a page."""

    def __init__(self, ws: Any, door: Any, made: InProcess) -> None:
        self._ws, self.door, self.made = ws, door, made
        self.rows: dict[str, Any] = {}

    async def ask(self, do: str, **more: Any) -> None:
        await self._ws.send_json({"t": "assign", "do": do, **more})

    async def told(self, do: str, **more: Any) -> dict[str, Any]:
        """Ask, and return the answer."""
        await self.ask(do, **more)
        while True:
            message = await in_time(self._ws.receive_json())
            if message["t"] == "assign" and message["do"] == do:
                return dict(message)

    async def hand_out(
        self, kind: str, *names: str, to: Any = "*", due: float = 0, title: str = "", **more: Any
    ) -> str:
        made = await self.told("new", kind=kind, names=names, to=to, due=due, title=title, **more)
        assert "wrong" not in made, made
        return str(made["id"])

    async def send(self, key: str, path: str, data: bytes) -> str:
        """Send a file of a folder."""
        address = f"{self.door.base}class/assignments/upload"
        about = {"upload": key, "path": path}
        async with self.door.session.put(address, params=about, data=data, headers=self.door.origin) as answer:
            return str((await answer.json())["upload"])

    async def is_closed(self) -> None:
        while (await in_time(self._ws.receive())).type == WSMsgType.TEXT:
            pass
        assert self._ws.close_code == 1008

    async def table(self, id_: str) -> bytes:
        async with self.door.session.get(f"{self.door.base}class/assignments/{id_}.csv") as answer:
            assert answer.status == 200
            return bytes(await answer.read())

    async def until(self, id_: str, wanted: Any) -> dict[str, dict[str, Any]]:
        """How everybody stands, as soon as this is true of it."""
        deadline = Deadline()
        rows: dict[str, dict[str, Any]] = {}
        while not deadline.is_over():
            told = await self.told("show", id=id_)
            rows = {row["name"]: row for row in told["rows"]}
            if not told["working"] and wanted(rows):
                return rows
            await asyncio.sleep(0.02)
        raise AssertionError(self.made.values[-3:], rows)


@asynccontextmanager
async def lesson(folder: Path, *names: str, **settings: Any) -> AsyncIterator[Any]:
    """A server with these pupils at their desktops, and a teacher."""
    async with serving(folder, **settings) as made, browser(made.base) as door:
        await door.get(made.teacher)
        ws = await door.session.ws_connect(f"{door.base}class/ws", headers=door.origin)
        await ws.receive_json()
        pupils = [Pupil(made, name, folder) for name in names]
        for pupil in pupils:
            pupil.come()
        yield (Teacher(ws, door, made), made, *pupils)
        await ws.close()


def states(rows: dict[str, dict[str, Any]]) -> dict[str, str]:
    return {name: row["state"] for name, row in rows.items()}


@pytest.mark.process
def test_a_lesson_goes_out_comes_back_and_is_given_back(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna", "ben") as (teacher, _, anna, ben):
            id_ = await teacher.hand_out("lesson", "day1")
            for pupil in (anna, ben):
                assert await pupil.hears("lesson") == "day1"
                assert "Day 1" in await pupil.hears("say")
            anna.say(lesson=LessonPlace("day1", {"en": "Day 1"}, 3, 12, False, 0))
            rows = await teacher.until(id_, lambda rows: rows["anna"]["at"] == 3)
            assert states(rows) == {"anna": "working", "ben": "given"}
            anna.solve("day1", "start", "drive", answers="a")
            anna.write("star.py", "print('a star')")
            anna.leave()
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["anna"]["collected"])
            assert rows["anna"]["solved"] == 2 and states(rows) == {"anna": "collected", "ben": "given"}
            await teacher.ask("grade", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["anna"]["points"] is not None)
            await teacher.ask("word", id=id_, name="anna", mark="B+", line="=well done")
            await teacher.ask("return", id=id_, names="*")
            await teacher.until(id_, lambda rows: rows["anna"]["returned"])
            (file,) = (anna.home / "marks").iterdir()
            text = file.read_text()
            assert "B+" in text and "well done" in text and f"of {rows['anna']['most']:g}" in text
            table = await teacher.table(id_)
            assert table.startswith(b"\xef\xbb\xbfname,") and b"'=well done" in table

    run(deed())


REPORT = {
    "points": 1.0, "most": 2.0, "unplayed": 0, "scenarios": [], "refused": None, "shielded": True, "problem": "",
}  # fmt: skip
"""What a grading says, as far as these tests look at it."""


@pytest.fixture
def graded(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """No program is played: the works that would have been."""
    found: list[str] = []

    async def grade(self: Any, key: str, *more: Any) -> dict[str, Any]:
        found.append(key)
        return dict(REPORT)

    monkeypatch.setattr(GradingRoom, "grade", grade)
    return found


def test_who_comes_later_gets_it_and_a_question_that_stands_open_is_waited_for(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna") as (teacher, made, anna):
            id_ = await teacher.hand_out("drill", "turtle_does_not_listen")
            assert await anna.hears("lesson") == "turtle_does_not_listen"
            anna.say(refused="class.refused.busy")
            await teacher.until(id_, lambda rows: rows["anna"]["state"] == "waiting")
            anna.say(hand=True)
            assert await anna.hears("lesson") == "turtle_does_not_listen"
            ben = Pupil(made, "ben", tmp_path)
            ben.come()
            assert await ben.hears("lesson") == "turtle_does_not_listen"
            only = await teacher.hand_out("lesson", "day2", to=["ben"])
            assert await ben.hears("lesson") == "day2"
            rows = await teacher.until(only, lambda rows: rows["ben"]["state"] == "given")
            assert list(rows) == ["ben"] and not [each for each in anna.orders if each["do"] == "lesson"]
            ben.leave()
            ben.come()  # has it already
            await teacher.ask("close", id=id_, on=True)
            eve = Pupil(made, "eve", tmp_path)
            eve.come()
            await teacher.told("show", id=only)
            assert not [each for each in ben.orders if each["do"] == "lesson"]
            assert (await teacher.told("show", id=id_))["closed"] is True

    run(deed())


def test_late_missing_and_changed_since_are_seen(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna", "ben", "eve") as (teacher, _, anna, ben, eve):
            desk = DESKS[-1]
            anna.solve("day1", "look")
            eve.solve("day1", "look")
            id_ = await teacher.hand_out("lesson", "day1", due=1000.0)  # long ago: it is collected now
            await desk.take_what_is_due()
            rows = await teacher.until(id_, lambda rows: rows["anna"]["collected"])
            assert states(rows) == {"anna": "collected", "ben": "missing", "eve": "collected"}
            assert not rows["anna"]["late"]
            anna.solve("day1", "look", "where")
            await desk.look_for_changes()
            rows = await teacher.until(id_, lambda rows: rows["anna"]["changed"])
            assert not rows["eve"]["changed"]
            ben.solve("day1", "look")
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["anna"]["late"])
            assert rows["ben"]["late"] and not rows["eve"]["late"] and not rows["anna"]["changed"]
            kept = sorted(tmp_path.glob(f"class/assignments/{id_}/collected/anna/*.zip"))
            assert len(kept) == 2  # nothing collected is overwritten

    run(deed())


def test_a_program_that_grading_plays_isnt_missing_because_no_step_was_solved(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna", "ben") as (teacher, _, anna, _):
            anna.write("star.py", "print()")
            id_ = await teacher.hand_out("lesson", "day3")
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["anna"]["collected"])
            assert states(rows) == {"anna": "collected", "ben": "given"}

    run(deed())


DAY4 = "ros2_ws/src/day6_publisher/day6_publisher/hello.py"
DAY5 = "ros2_ws/src/day6_publisher/day6_publisher/talker.py"


def test_a_program_of_an_earlier_day_is_neither_handed_in_nor_a_change(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna", "ben", "eve") as (teacher, _, *pupils):
            desk, (_, ben, eve) = DESKS[-1], pupils
            for pupil in pupils:
                pupil.write("star.py", "print()")
                pupil.write(DAY4, "print('Hi')")
                pupil.write("ros2_ws/src/day6_publisher/package.xml", "<package/>")
            ben.write(DAY5, "class Talker(Node): ...")
            eve.write(DAY5, "class Talker(Node): ...")
            eve.solve("day4", "package")
            id_ = await teacher.hand_out("lesson", "day5", due=1000.0)
            await desk.take_what_is_due()
            rows = await teacher.until(id_, lambda rows: rows["eve"]["collected"])
            assert states(rows) == {"anna": "missing", "ben": "collected", "eve": "collected"}
            ben.write("star.py", "print('again')")
            ben.write("ros2_ws/src/another/another/node.py", "print()")
            eve.write("ros2_ws/src/day6_publisher/package.xml", "<package>mine</package>")  # of day 5, too
            await desk.look_for_changes()
            rows = await teacher.until(id_, lambda rows: rows["eve"]["changed"])
            assert not rows["ben"]["changed"]
            ben.write("ros2_ws/src/day6_publisher/day6_publisher/helper.py", "")  # of no lesson: it may be imported
            await desk.look_for_changes()
            await teacher.until(id_, lambda rows: rows["ben"]["changed"])

    run(deed())


def test_the_folder_of_a_drill_is_collected_and_its_changes_are_seen(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna") as (teacher, _, anna):
            anna.solve("greeter", "run")
            anna.write("drill24/greeter.py", "print()")
            anna.write("star.py", "print()")
            id_ = await teacher.hand_out("exam", "greeter", "blinker")
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["anna"]["collected"])
            (kept,) = tmp_path.glob(f"class/assignments/{id_}/collected/anna/*.zip")
            assert "folder/drill24/greeter.py" in zipfile.ZipFile(kept).namelist()
            anna.write("star.py", "print('again')")
            await DESKS[-1].look_for_changes()
            rows = await teacher.until(id_, lambda rows: True)
            assert not rows["anna"]["changed"]
            anna.write("drill24/greeter.py", "print('again')")
            await DESKS[-1].look_for_changes()
            await teacher.until(id_, lambda rows: rows["anna"]["changed"])

    run(deed())


def test_a_folder_is_placed_and_what_a_pupil_has_stays(tmp_path: Path, graded: list[str]) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna", "ben") as (teacher, _, anna, ben):
            ben.write("maze/solve.py", "mine")
            key = "0"
            for path, data in {"maze/solve.py": b"pass", "maze/maps/one.txt": b"##", "maze/.git/x": b"no"}.items():
                key = await teacher.send(key, path, data)
            id_ = await teacher.hand_out("folder", upload=key)
            assert "~/maze" in await anna.hears("say") and "~/maze" in await ben.hears("say")
            assert (anna.home / "maze/solve.py").read_text() == "pass" and (
                ben.home / "maze/solve.py"
            ).read_text() == "mine"
            assert (ben.home / "maze/maps/one.txt").exists() and not (anna.home / "maze/.git").exists()
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["ben"]["collected"])
            assert rows["ben"]["solved"] == 0
            (file,) = tmp_path.glob(f"class/assignments/{id_}/collected/ben/*.zip")
            with zipfile.ZipFile(file) as archive:
                assert archive.read("folder/maze/solve.py") == b"mine"
            assert unpack(file, tmp_path / "graded").pupil == "ben"  # `grade` takes it
            assert (tmp_path / "graded/maze/maps/one.txt").exists()

    run(deed())


def test_all_get_the_drills_of_one_exam(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna", "ben") as (teacher, _, anna, ben):
            id_ = await teacher.hand_out("exam")
            drills = (await anna.hears("exam")).split()
            assert len(drills) == 5 and (await ben.hears("exam")).split() == drills
            done = [{"drill": each, "solved": at > 1, "seconds": 9.0, "hints": 0} for at, each in enumerate(drills)]
            anna.write(PROGRESS, json.dumps({"version": 1, "exams": [{"began": 1.0, "drills": done}]}))
            other = [{**each, "drill": "turtle_does_not_listen"} for each in done]
            ben.write(PROGRESS, json.dumps({"version": 1, "exams": [{"began": 1.0, "drills": other}]}))
            ben.write("loose.py", "")
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["anna"]["collected"])
            assert (rows["anna"]["solved"], rows["anna"]["steps"], rows["ben"]["state"]) == (3, 5, "missing")

    run(deed())


def hostile_home(pupil: Pupil, outside: Path) -> None:
    """What a pupil can put there."""
    outside.write_text("secret")
    (pupil.home / "ros2_ws/src/p").mkdir(parents=True)
    pupil.write("ros2_ws/src/p/good.py", "1")
    pupil.write("ros2_ws/src/p/build/big.bin", "x" * 1000)
    os.symlink(outside, pupil.home / "link.py")
    os.symlink(outside.parent, pupil.home / "ros2_ws/src/linked")
    os.mkfifo(pupil.home / "ros2_ws/src/p/fifo")
    pupil.write("huge.py", "x" * 6_000_000)
    pupil.write("ros2_ws/src/p/a:b\\c\x1b[2J.py", "odd name")
    with open(os.fsencode(pupil.home) + b"/ros2_ws/src/p/\xff.py", "wb") as file:
        file.write(b"no UTF-8")
    deep = pupil.home / "ros2_ws/src/p" / "/".join("d" * 40)
    deep.mkdir(parents=True)
    pupil.write(
        PROGRESS, '{"version": 1, "steps": {"day1": {"' + "s" * 5000 + '": {"solved": 1}, "look": {"solved": 1e300}}}}'
    )
    os.symlink(outside, pupil.home / ".config/day6-tui/pupils/other.json")


def test_a_hostile_home_gives_only_what_is_the_pupils(tmp_path: Path) -> None:
    async def deed() -> None:
        async with lesson(tmp_path, "anna") as (teacher, _, anna):
            hostile_home(anna, tmp_path / "secret")
            id_ = await teacher.hand_out("lesson", "day1")
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["anna"]["collected"])
            (file,) = tmp_path.glob(f"class/assignments/{id_}/collected/anna/*.zip")
            with zipfile.ZipFile(file) as archive:
                assert [name for name in archive.namelist() if name != "day6-submission.json"] == ["src/p/good.py"]
                assert b"secret" not in b"".join(archive.read(name) for name in archive.namelist())
            assert rows["anna"]["left_out"] >= 6
            assert unpack(file, tmp_path / "graded").pupil == "anna"

    run(deed())


def test_a_full_disk_names_who_is_missing_and_keeps_what_is_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, graded: list[str]
) -> None:
    write = write_private

    def full(path: Path, data: bytes) -> None:
        if "ben" in path.parts:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))
        write(path, data)

    async def deed() -> None:
        async with lesson(tmp_path, "anna", "ben") as (teacher, made, anna, ben):
            id_ = await teacher.hand_out("lesson", "day1")
            for pupil in (anna, ben):
                pupil.solve("day1", "look")
            monkeypatch.setattr(assignments, "write_private", full)
            await teacher.ask("collect", id=id_, names="*")
            rows = await teacher.until(id_, lambda rows: rows["ben"]["trouble"])
            assert (
                "No space left" in rows["ben"]["trouble"] and rows["anna"]["collected"] and not rows["anna"]["trouble"]
            )
            assert made.sessions.feed.news[-1].values["names"] == "ben"
            monkeypatch.setattr(assignments, "write_private", write)
            await teacher.ask("collect", id=id_, names="*")
            await teacher.until(id_, lambda rows: rows["ben"]["collected"] and not rows["ben"]["trouble"])

    run(deed())


class Killed(BaseException):
    """The server is gone at this moment."""


@pytest.mark.parametrize("step", range(12))
def test_a_server_killed_at_any_step_loses_nothing_collected(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: int
) -> None:
    """Every write of the store is a moment at which the server may be gone; the next one goes on."""
    replace, count = os.replace, itertools.count()

    def dying(source: Any, target: Any) -> None:
        if next(count) == step:
            raise Killed
        replace(source, target)

    store = assignments.AssignmentStore(tmp_path / "assignments")
    task = Task("lesson", ("day1",))
    done: list[str] = []
    monkeypatch.setattr(os, "replace", dying)
    with contextlib.suppress(Killed):
        made = store.new(task, {"en": "Day 1"}, None, 0)
        store.keep(made)
        done.append("kept")
        for number in range(3):
            for name in ("anna", "ben"):
                work = Work({"star.py": b"%d" % number}, (), Progress(name))
                packed = pack(task, work, name, "/home", when=float(number), late=False)
                collected = store.collect(made.id, name, packed, 1000.0 + number)
                done.append(f"{name} {number}")
            if number == 1:
                store.keep_grade(collected, REPORT)
                done.append("grade")
                store.keep_words(made.id, {"ben": Word("A", "fine")})
                done.append("words")
    monkeypatch.setattr(os, "replace", replace)
    again = assignments.AssignmentStore(tmp_path / "assignments")
    known = again.all()
    assert [each.id for each in known] == (["day1"] if "kept" in done else [])
    last = {each.pupil: each for each in again.everybodys("day1")}
    for name in ("anna", "ben"):
        files = [each for each in done if each.startswith(name)]
        latest = last.get(name)
        assert (latest is None) == (not files)
        if latest is not None:
            assert latest.when == float(files[-1][-1])  # the last that was whole
        assert len(list((tmp_path / "assignments/day1/collected" / name).glob("*.zip"))) == len(files)
    assert again.words("day1") == ({"ben": Word("A", "fine")} if "words" in done else {})
    if "grade" in done and "ben 2" not in done:
        assert last["ben"].grade["points"] == 1.0  # type: ignore[index]


def test_the_next_server_finds_everything_and_goes_on(tmp_path: Path, graded: list[str]) -> None:
    async def first() -> None:
        async with lesson(tmp_path, "anna") as (teacher, _, anna):
            id_ = await teacher.hand_out("lesson", "day1")
            await anna.hears("lesson")
            anna.solve("day1", "look")
            await teacher.ask("collect", id=id_, names="*")
            await teacher.until(id_, lambda rows: rows["anna"]["collected"])
            await teacher.ask("word", id=id_, name="anna", mark="A", line="fine")
            await teacher.until(id_, lambda rows: rows["anna"]["mark"])

    async def second() -> None:
        async with lesson(tmp_path, "anna") as (teacher, _, anna):
            rows = await teacher.until("day1", lambda rows: True)
            assert (rows["anna"]["mark"], rows["anna"]["solved"]) == ("A", 1)
            await teacher.ask("grade", id="day1", names="*")
            await teacher.until("day1", lambda rows: rows["anna"]["points"] == 1.0)
            await teacher.ask("grade", id="day1", names="*")  # has a grade already
            await teacher.ask("return", id="day1", names="*")
            await teacher.until("day1", lambda rows: rows["anna"]["returned"] and not rows["anna"]["news"])
            assert await anna.hears("file") == "marks/Day_1_terminal_and_environment.md"
            await teacher.ask("word", id="day1", name="anna", mark="A+", line="fine")
            await teacher.until("day1", lambda rows: rows["anna"]["news"])
            assert graded == ["day1/anna"] and not [each for each in anna.orders if each["do"] == "lesson"]

    run(first())
    run(second())


def test_marks_that_cannot_be_read_are_kept_aside(tmp_path: Path) -> None:
    store = assignments.AssignmentStore(tmp_path)
    made = store.new(Task("lesson", ("day1",)), {}, None, 0)
    (tmp_path / made.id / "marks.json").write_text("{half")
    assert store.words(made.id) == {}
    store.keep_words(made.id, {"anna": Word("A")})
    (aside,) = (tmp_path / made.id).glob("marks-unreadable-*.json")
    assert aside.read_text() == "{half" and store.words(made.id) == {"anna": Word("A")}


@pytest.mark.parametrize(
    "order",
    [
        {"do": "new", "kind": "virus", "names": [], "to": "*", "due": 0, "title": ""},
        {"do": "collect", "id": "../server", "names": "*"},
        {"do": "word", "id": "day1"},
        {"do": "new", "kind": "lesson", "names": ["day1"], "to": "*", "due": 1e300, "title": ""},
        {"do": "no"},
    ],
)
def test_nonsense_closes_the_page(tmp_path: Path, order: dict[str, Any]) -> None:
    async def deed() -> None:
        async with lesson(tmp_path) as (teacher, _):
            await teacher.ask(**order)
            await teacher.is_closed()

    run(deed())


@pytest.mark.parametrize(
    "changed",
    [
        {"points": "much"}, {"scenarios": [{"mark": "genius"}]}, {"scenarios": 7}, {"refused": {"en": 1, "zh": ""}},
        {"scenarios": [{"lesson": "a", "scenario": "b", "title": {"en": "", "zh": ""}, "mark": "right", "points": 9, "most": 1,
                        "checks": []}]},
    ],
)  # fmt: skip
def test_a_report_from_a_cell_is_not_believed(changed: dict[str, Any]) -> None:
    good = {**REPORT, "file": "x", "seconds": 1.0}
    assert report_of(json.dumps(good).encode())["points"] == 0  # counted from what was played
    if "points" not in changed:
        with pytest.raises(NotGraded):
            report_of(json.dumps({**good, **changed}).encode())
    for said in (b"", b"{", b"[]", b"[" * 100_000, b"x" * 3_000_000):
        with pytest.raises(NotGraded):
            report_of(said)


def test_marks_that_were_not_opened_are_announced_at_the_next_start(tmp_path: Path) -> None:
    (tmp_path / "marks").mkdir()
    for number, name in enumerate(("old", "one", "two", "three", "bad\x1b[2J")):
        (tmp_path / "marks" / f"{name}.md").write_text("A")
        os.utime(tmp_path / "marks" / f"{name}.md", (number, number))

    def start() -> list[str]:
        told: list[str] = []
        app: Any = SimpleNamespace(
            machine=SimpleNamespace(desk=SimpleNamespace(home=tmp_path)), call_from_thread=lambda do, order: do(order)
        )
        marks = Marks(app, lambda order: told.append(order.text))
        for _ in range(2):
            marks.look()
        until(lambda: not any(each.name == "day6-marks" for each in threading.enumerate()))
        marks.opened(told[-1] if told else "handed/other.md")
        return told

    assert start() == ["marks/two.md", "marks/three.md"]  # a name that could act on a terminal is none
    assert start() == ["marks/one.md", "marks/two.md"]
