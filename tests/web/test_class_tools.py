"""Groups, questions and files for pupils, as a real server in this process has them; the desktops are not real."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom.handed import LARGEST
from day6_core.classroom.note import LONGEST_REPLY, Note, Reply
from day6_core.classroom.order import Order
from day6_tui.detached import wire
from day6_tui.detached.loop_line import LoopLine
from tests.web.in_process import InProcess, Teacher, deed_of, place, teaching  # noqa: F401
from tests.web.in_time import eventually, in_time
from tests.web.serving import Browser

EVIL = "\x1b]52;c;AAAA\x07\u202e<b>"


class FakeDesktop:
    """Hears orders, and says what the test says, as a keeper carries it."""

    def __init__(self, made: InProcess, name: str) -> None:
        ours, theirs = socket.socketpair()
        self.name, self.orders = name, list[Order]()
        self.note = Note(attended=True)
        self.handed: dict[str, int] = {}
        """The numbers of links and files."""
        self.answers: Callable[[Order], dict[str, Any] | None] = lambda order: None
        """What it says to a question, as JSON; None: nothing."""
        made.sessions.feed.begin(name, theirs)
        self._line = LoopLine(ours)
        self._line.on_readable(self._hear)
        self.tell()

    def _hear(self) -> None:
        for kind, data in self._line.receive():
            if kind == wire.ORDER:
                order = orders.decode(data)
                if order.do in ("link", "file"):
                    self.handed[order.text], order = order.number, replace(order, number=0)
                self.orders.append(order)
                if order.do == "say" and (reply := self.answers(order)) is not None:
                    self.tell(reply)

    def tell(self, *replies: dict[str, Any]) -> None:
        found = json.loads(notes.encode(self.note))
        found["replies"] = list(replies)
        self._line.send(wire.NOTE, json.dumps(found).encode())

    async def hears(self, order: Order) -> None:
        """Wait for an order."""
        await eventually(lambda: order in self.orders, lambda: self.orders)

    def files(self) -> list[str]:
        return [order.text for order in self.orders if order.do == "file"]


def class_of(folder: Path, *names: str) -> dict[str, Any]:
    """A server with a list."""
    file = folder / "pupils.csv"
    file.write_text("\n".join(("name", *names)), encoding="utf-8")
    return {"class_file": file}


async def ask(teacher: Teacher, t: str, **more: object) -> None:
    await teacher._ws.send_json({"t": t, **more})


async def hand(teacher: Browser, line: Teacher, name: str, data: bytes, names: object = "*") -> None:
    async with teacher.session.post(
        f"{teacher.base}class/hand", params={"name": name}, data=data, headers=teacher.origin
    ) as answer:
        assert answer.status == 200
        await ask(line, "hand", names=names, id=(await answer.json())["id"])


def groups(state: dict[str, Any]) -> dict[str, list[str]]:
    return {each["name"]: each["names"] for each in state["groups"]}


# -- groups ------------------------------------------------------------------------------------------------------------


def test_groups_are_on_every_page_of_the_teacher_and_survive_the_server(tmp_path: Path) -> None:
    settings = class_of(tmp_path, "anna", "李雷", "carl")

    async def deed(made: InProcess, door: Browser) -> None:
        async with teaching(made) as one, teaching(made) as other:
            await ask(one, "group", do="keep", name=" 三 A ", names=["李雷", "anna", "anna", "stranger", EVIL])
            await other.until(lambda state: groups(state) == {"三 A": ["李雷", "anna"]})
            await ask(other, "group", do="keep", name="all", names=["anna", "李雷", "carl"])
            await ask(other, "group", do="keep", name="三 A", names=["carl"])
            await one.until(lambda state: groups(state).get("三 A") == ["carl"] and len(groups(state)) == 2)
            await ask(one, "group", do="drop", name="all")
            await other.until(lambda state: groups(state) == {"三 A": ["carl"]})

    async def again(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            await teacher.until(lambda state: groups(state) == {"三 A": ["carl"]})

    deed_of(tmp_path, deed, **settings)
    deed_of(tmp_path, again, **settings)


@pytest.mark.parametrize("name", ["", EVIL, "x" * 100, "../tokens"])
def test_what_is_no_group_is_refused_with_a_reason(tmp_path: Path, name: str) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            await ask(teacher, "group", do="keep", name=name, names=["anna"])
            state = await teacher.until(lambda state: state["news"])
            assert state["groups"] == []

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna"))


@pytest.mark.parametrize(
    "content", [b"", b"[]", b'{"groups": {"a": 3}}', b'{"groups": {"\\u202e": []}}', b"[" * 99_999]
)
def test_a_damaged_file_of_groups_is_told_and_no_reason_not_to_begin(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "class" / "server" / "groups.json"
    file.parent.mkdir(parents=True)
    file.write_bytes(content)

    async def deed(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            state = await teacher.until(lambda state: state["news"])
            assert "groups.json" in state["news"][0] and state["groups"] == []

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna"))


def reply(state: dict[str, Any], name: str) -> str:
    """What this pupil has answered to the first question; "" if nothing."""
    return next((str(each["replies"].get(name, {}).get("kind", "")) for each in state["questions"]), "")


# -- questions ---------------------------------------------------------------------------------------------------------


def test_thirty_pupils_answer_at_once_and_whoever_was_not_asked_does_not_count(tmp_path: Path) -> None:
    names = [f"pupil{number}" for number in range(30)]
    kinds = ("yes", "no", "done")

    async def deed(made: InProcess, door: Browser) -> None:
        desktops = [FakeDesktop(made, name) for name in (*names, "eve")]
        async with teaching(made) as one, teaching(made) as other:
            for at, desktop in enumerate(desktops):
                desktop.answers = lambda order, at=at: {"number": order.number, "kind": kinds[at % 3]}  # type: ignore[misc]
            await ask(one, "ask", names=[*names, "absent"], text="Done?")
            answered = await other.until(
                lambda state: state["questions"] and len(state["questions"][0]["replies"]) == 30
            )
            (question,) = answered["questions"]
            assert question["text"] == "Done?" and question["asked"] == names
            assert question["replies"]["pupil1"] == {"kind": "no", "text": ""}
            number = question["number"]
            desktops[-1].tell({"number": number, "kind": "no"})  # eve makes it up
            desktops[0].tell({"number": number, "kind": "no"})  # and one thinks better of it
            changed = await one.until(lambda state: reply(state, "pupil0") == "no")
            assert "eve" not in changed["questions"][0]["replies"]
            await ask(other, "settle", number=number)
            await one.until(lambda state: state["questions"] == [])

    deed_of(tmp_path, deed, **class_of(tmp_path, *names))


def test_an_answer_is_short_and_harmless_whatever_a_desktop_says(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        desktop = FakeDesktop(made, "anna")
        async with teaching(made) as teacher:
            await ask(teacher, "ask", names="*", text="Why?")
            state = await teacher.until(lambda state: state["questions"])
            number = state["questions"][0]["number"]
            desktop.tell({"number": number, "kind": "words", "text": EVIL + "长" * 1000})
            state = await teacher.until(lambda state: reply(state, "anna"))
            text = state["questions"][0]["replies"]["anna"]["text"]
            assert len(text) <= LONGEST_REPLY and text.isprintable() and "\u202e" not in text

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna"))


def test_who_has_not_answered_is_asked_no_longer_when_the_question_is_over(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        quick, slow = FakeDesktop(made, "anna"), FakeDesktop(made, "ben")
        quick.answers = lambda order: {"number": order.number, "kind": "yes"}
        async with teaching(made) as teacher:
            await ask(teacher, "ask", names="*", text="Done?")
            state = await teacher.until(lambda state: reply(state, "anna"))
            number = state["questions"][0]["number"]
            await ask(teacher, "settle", number=number)
            await teacher.until(lambda state: not state["questions"])
            await slow.hears(Order("settle", number=number))
            assert Order("settle", number=number) not in quick.orders

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna", "ben"))


def test_the_teacher_sees_who_has_opened_what_was_handed_out_and_nothing_else(tmp_path: Path) -> None:
    link = "https://docs.ros.org/"

    def opened(state: dict[str, Any]) -> list[tuple[str, list[str], list[str]]]:
        return [(each["text"], sorted(each["given"]), each["opened"]) for each in state["handouts"]]

    async def deed(made: InProcess, door: Browser) -> None:
        anna, ben = FakeDesktop(made, "anna"), FakeDesktop(made, "ben")
        await door.get(made.teacher)
        async with teaching(made) as teacher:
            await ask(teacher, "order", names="*", order={"do": "link", "text": link, "number": 5})
            await teacher.until(lambda state: opened(state) == [(link, ["anna", "ben"], [])])
            for desk in (anna, ben):
                await desk.hears(Order("link", text=link))
            assert anna.handed == ben.handed and anna.handed[link] != 5
            anna.note = replace(anna.note, opened=(3, anna.handed[link]))  # 3: of another server
            anna.tell()
            await teacher.until(lambda state: opened(state) == [(link, ["anna", "ben"], ["anna"])])
            await hand(door, teacher, "map.py", b"print()\n", ["anna", "carl"])
            await anna.hears(Order("file", text="handed/map.py"))
            ben.note = replace(ben.note, opened=(anna.handed["handed/map.py"],))  # it was not handed to ben
            ben.tell()
            carl = FakeDesktop(made, "carl")
            await carl.hears(Order("file", text="handed/map.py"))
            assert carl.handed == {"handed/map.py": anna.handed["handed/map.py"]}
            carl.note = replace(carl.note, opened=tuple(carl.handed.values()))
            carl.tell()
            wanted = [(link, ["anna", "ben"], ["anna"]), ("map.py", ["anna", "carl"], ["carl"])]
            await teacher.until(lambda state: opened(state) == wanted)
            carl.note = replace(carl.note, opened=())  # the desktop began anew
            carl.tell()
            assert opened(await teacher.until(lambda state: state["rows"])) == wanted

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna", "ben", "carl"))


def test_what_is_open_outlives_the_server_with_what_was_answered_meanwhile(tmp_path: Path) -> None:
    numbers: list[int] = []

    async def deed(made: InProcess, door: Browser) -> None:
        desks = [FakeDesktop(made, name) for name in ("anna", "ben", "carl")]
        async with teaching(made) as teacher:
            await ask(teacher, "ask", names="*", text="Done?")
            state = await teacher.until(lambda state: state["questions"])
            await ask(teacher, "order", names=["anna"], order={"do": "link", "text": "https://a.b/"})
            numbers.append(state["questions"][0]["number"])
            desks[0].tell({"number": numbers[0], "kind": "yes"})
            await teacher.until(lambda state: reply(state, "anna") and state["handouts"])

    async def again(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:  # anna has gone meanwhile
            state = await teacher.until(lambda state: state["rows"])
            assert reply(state, "anna") == "yes" and state["questions"][0]["asked"] == ["anna", "ben", "carl"]
            assert [each["given"] for each in state["handouts"]] == [["anna"]]
            ben, carl = FakeDesktop(made, "ben"), FakeDesktop(made, "carl")
            ben.tell({"number": numbers[0], "kind": "words", "text": "soon"})  # answered while no server was there
            await teacher.until(lambda state: reply(state, "ben") == "words")
            await ask(teacher, "settle", number=numbers[0])
            await carl.hears(Order("settle", number=numbers[0]))
            await ask(teacher, "ask", names="*", text="And now?")
            state = await teacher.until(lambda state: [each["text"] for each in state["questions"]] == ["And now?"])
            assert state["questions"][0]["number"] > numbers[0]
            numbers.append(state["questions"][0]["number"])

    async def at_last(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            state = await teacher.until(lambda state: state["rows"])
            assert [each["number"] for each in state["questions"]] == numbers[1:]

    for part in (deed, again, at_last):
        deed_of(tmp_path, part, **class_of(tmp_path, "anna", "ben", "carl"))


@pytest.mark.parametrize("name", ["asked.json", "addresses.json"])
@pytest.mark.parametrize("content", [b"", b"[3]", b'{"questions": {"open": [3], "last": 1}, "a": 3}', b"[" * 99_999])
def test_a_damaged_file_of_what_was_open_is_told_and_no_reason_not_to_begin(
    tmp_path: Path, name: str, content: bytes
) -> None:
    (tmp_path / "class" / "server").mkdir(parents=True)
    (tmp_path / "class" / "server" / name).write_bytes(content)

    async def deed(made: InProcess, door: Browser) -> None:
        assert "serve.kept.unread" in made.said and made.values[made.said.index("serve.kept.unread")]["file"].endswith(
            name
        )
        FakeDesktop(made, "anna")
        async with teaching(made) as teacher:
            await ask(teacher, "ask", names="*", text="Done?")
            await teacher.until(lambda state: state["questions"])

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna"))


# -- files -------------------------------------------------------------------------------------------------------------


def test_a_file_comes_into_every_home_and_whoever_comes_later_is_told(tmp_path: Path) -> None:
    homes = tmp_path / "class" / "homes"

    async def deed(made: InProcess, door: Browser) -> None:
        anna = FakeDesktop(made, "anna")
        (homes / "ben").mkdir()
        (homes / "ben" / "handed").symlink_to(tmp_path / "class" / "server")
        await door.get(made.teacher)
        async with teaching(made) as teacher:
            await hand(door, teacher, "../../\u202e地图.py", b"print()\n")
            state = await teacher.until(lambda state: state["handed"] and state["handed"][0]["failed"])
            state = await teacher.until(lambda state: state["handed"][0]["count"] == 2)
            ((failed, why),) = state["handed"][0]["failed"]
            assert failed == "ben" and why and not (tmp_path / "class" / "server" / "地图.py").exists()
            assert {(homes / name / "handed" / "地图.py").read_bytes() for name in ("anna", "carl")} == {b"print()\n"}
            (homes / "anna" / "handed" / "地图.py").write_bytes(b"mine")
            await hand(door, teacher, "地图.py", b"print()\n", ["anna", "anna", "stranger"])
            await anna.hears(Order("file", text="handed/地图_2.py"))
            assert anna.files() == ["handed/地图.py", "handed/地图_2.py"]
            assert (homes / "anna" / "handed" / "地图.py").read_bytes() == b"mine"
            carl = FakeDesktop(made, "carl")
            await carl.hears(Order("file", text="handed/地图.py"))
            assert carl.files() == ["handed/地图.py"] and not (homes / "stranger").exists()

    deed_of(tmp_path, deed, **class_of(tmp_path, "anna", "ben", "carl"))


def test_only_the_teachers_page_sends_files_and_none_that_is_too_large(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        async def status(data: bytes, origin: str) -> int:
            address, headers = f"{door.base}class/hand?name=x", {"Origin": origin}
            async with door.session.post(address, data=data, headers=headers) as answer:
                return answer.status

        ours = door.origin["Origin"]
        assert await in_time(status(b"x", ours)) == 403
        await door.get(made.teacher)
        assert await in_time(status(b"x", "http://evil.example")) == 403
        assert await in_time(status(b"x" * LARGEST, ours)) == 200
        assert await in_time(status(b"x" * (LARGEST + 1), ours)) == 413

    deed_of(tmp_path, deed)


def test_a_note_carries_the_last_answers_only() -> None:
    sent = Note(replies=tuple(Reply(number, "words", "almost") for number in range(1, 20)))
    assert [each.number for each in notes.decode(notes.encode(sent)).replies] == list(range(12, 20))
