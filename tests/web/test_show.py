"""A screen shown to the class: who gets it, when it begins and ends, and that nothing but text and colours arrives."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import socket
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import aiohttp
import pytest

from day6_core.classroom.homes import folder_name
from day6_core.classroom.note import Note, PupilScreen
from day6_core.classroom.order import Order
from day6_tui.detached import meeting, wire
from day6_tui.web import class_page, class_show
from day6_tui.web.names import TEACHERS, BadName, clean
from day6_tui.web.picture import Picture
from tests.web.in_process import serving
from tests.web.in_time import eventually, in_time
from tests.web.scripted_desktops import ScriptedDesktops
from tests.web.serving import WORD, Browser, Tab, browser, run

BLANK = Note(attended=True)


def screen(text: str, columns: int = 20, rows: int = 3) -> PupilScreen:
    return PupilScreen(columns, rows, text)


class Classroom:
    """A server, its teacher's page and its pupils."""

    def __init__(self) -> None:
        self.desks = ScriptedDesktops()
        self.doors: dict[str, Browser] = {}
        self.rows: dict[str, Any] = {}
        self.news: list[str] = []
        self._stack = contextlib.AsyncExitStack()

    async def open(self, folder: Path) -> None:
        self.desks.loop = asyncio.get_running_loop()
        made = await self._stack.enter_async_context(serving(folder, most=3))
        self.base, self._server = made.base, made.server
        self.teacher = await self._browser()
        await self.teacher.get(made.teacher)
        self.page = await self._line(self.teacher, "class/ws")
        self._hearing = asyncio.create_task(self._hear())
        await eventually(lambda: "show" in self.rows)

    async def close(self) -> None:
        self._hearing.cancel()
        await self._stack.aclose()

    async def _browser(self) -> Browser:
        return await self._stack.enter_async_context(browser(self.base))

    async def _line(self, door: Browser, path: str) -> aiohttp.ClientWebSocketResponse:
        return await door.session.ws_connect(f"{self.base}{path}", headers=door.origin)

    async def _hear(self) -> None:
        async for message in self.page:
            found = json.loads(message.data)
            if found["t"] == "rows":
                self.rows = found
                self.news += found["news"]

    async def pupil(self, name: str) -> Tab:
        """A new pupil with a tab."""
        door = self.doors[name] = await self._browser()
        assert (await door.post("enter", word=WORD, name=name))[0] == 303
        return await self.tab(name)

    async def tab(self, name: str) -> Tab:
        """A tab of a pupil who is in, or the teacher's own."""
        door, query = (self.teacher, "mine=1") if name == TEACHERS else (self.doors[name], "")
        tab = await door.tab(query)
        while not tab.got:
            await tab.hear()
        return tab

    async def say(self, do: str, name: str = "", names: list[str] | None = None, *, full: bool = False) -> None:
        await self.page.send_json({"t": "show", "do": do, "name": name, "names": names or "*", "full": full})

    async def look(self, name: str) -> Looking:
        """The second line of a tab."""
        door, query = (self.teacher, "?mine=1") if name == TEACHERS else (self.doors[name], "")
        looking = Looking(await self._line(door, f"shown{query}"))
        assert (await looking.next())["t"] == "hello"
        return looking

    async def is_refused(self, name: str) -> bool:
        try:
            line = await self._line(self.doors[name], "shown")
        except aiohttp.WSServerHandshakeError as error:
            return error.status == 403
        await line.close()
        return False

    def agrees(self, name: str, text: str = "anna's screen") -> None:
        """This desktop does what a real one does whose pupil says yes."""

        def obey(order: Order) -> Note | None:
            if order.do == "ask_to_show":
                return Note(attended=True, asked_show=True)
            if order.do != "show":
                return None
            return Note(attended=True, may_show=True, shown=True, screen=screen(text)) if order.on else BLANK

        self.desks[name].obeys = obey

    async def show(self, name: str, names: list[str] | None = None, *, full: bool = False) -> None:
        """Show a screen, with its pupil's yes."""
        self.agrees(name or TEACHERS, f"{name or 'the teacher'}'s screen")
        await self.say("start", name, names, full=full)
        if name:
            await eventually(lambda: Order("ask_to_show") in self.desks[name].orders)
            self.desks[name].tell(Note(attended=True, may_show=True))
        await eventually(lambda: (self.rows["show"]["on"] or {}).get("name") == name)


class Looking:
    """Who looks: the screen as the page has it."""

    def __init__(self, ws: aiohttp.ClientWebSocketResponse) -> None:
        self.ws = ws
        self.raw = ""
        self.lines: dict[int, str] = {}

    async def next(self) -> dict[str, Any]:
        message = await in_time(self.ws.receive())
        if message.type != aiohttp.WSMsgType.TEXT:
            return {"t": "closed"}
        self.raw += message.data
        found: dict[str, Any] = json.loads(message.data)
        if found["t"] == "screen":
            self.lines |= {int(row): line for row, line in found["lines"].items()}
            await self.ws.send_json({"t": "ack"})
        return found

    async def sees(self, text: str) -> None:
        while text not in self.lines.values():
            assert (await self.next())["t"] == "screen"

    async def why(self) -> str:
        """Why it ends."""
        while (found := await self.next())["t"] == "screen":
            pass
        assert (await self.next())["t"] == "closed"
        return str(found["why"])


async def told(tab: Tab, *, on: bool) -> dict[str, Any]:
    """What a tab hears last of what is shown."""
    while True:
        heard = [message for message in tab.said if message["t"] == "show"]
        if heard and heard[-1]["on"] is on:
            return heard[-1]
        assert await tab.hear()


@pytest.fixture(autouse=True)
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path / "run"))
    monkeypatch.setattr(class_page, "PAUSE", 0.01)
    monkeypatch.setattr(class_page, "GRACE", 0.05)
    monkeypatch.setattr(class_show, "LEAST_PAUSE", 0.001)


@pytest.fixture
def play(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[[Classroom], Any]], None]:
    @asynccontextmanager
    async def opened() -> AsyncIterator[Classroom]:
        room = Classroom()
        monkeypatch.setattr(meeting, "connect", room.desks.connect)
        await room.open(tmp_path)
        try:
            yield room
        finally:
            await room.close()

    def whole(deed: Callable[[Classroom], Coroutine[Any, Any, None]]) -> None:
        async def played() -> None:
            async with opened() as room:
                await deed(room)

        run(played())

    return whole


Play = Callable[[Callable[[Classroom], Coroutine[Any, Any, None]]], None]


def test_the_teachers_desktop_is_shown_to_all_also_to_who_comes_later_and_counts_for_no_pupil(play: Play) -> None:
    async def deed(room: Classroom) -> None:
        anna = await room.pupil("anna")
        mine = await room.tab(TEACHERS)
        room.agrees(TEACHERS, "the teacher's")
        await room.say("start", full=True)
        assert await told(anna, on=True) == {"t": "show", "on": True, "name": "", "full": True}
        looking = await room.look("anna")
        await looking.sees("the teacher's")
        ben = await room.pupil("ben")
        await told(ben, on=True)
        late = await room.look("ben")
        await late.sees("the teacher's")
        await eventually(lambda: [row["name"] for row in room.rows["rows"]] == ["anna", "ben"])
        await room.pupil("carl")  # the third of three: the teacher's desktop takes no place
        assert room.rows["show"]["on"] == {"name": "", "full": True, "count": None} and room.rows["show"]["mine"]
        assert not any(message.get("on") for message in mine.said)
        await room.say("again", full=False)
        await eventually(lambda: room.rows["show"]["on"]["full"] is False)
        room.desks[TEACHERS].tell(Note(shown=True, screen=screen("another one")))
        await looking.sees("another one")
        await room.say("stop")
        await told(anna, on=False)
        assert [await looking.why(), await late.why()] == ["ended", "ended"]
        assert room.desks[TEACHERS].orders[-1] == Order("show", on=False)
        assert await room.is_refused("anna")

    play(deed)


def test_the_teachers_desktop_is_shown_as_soon_as_it_is_open(play: Play) -> None:
    async def deed(room: Classroom) -> None:
        anna = await room.pupil("anna")
        room.agrees(TEACHERS)
        await room.say("start")
        await eventually(lambda: room.rows["show"]["wanted"])
        assert await room.is_refused("anna")
        await room.tab(TEACHERS)
        await told(anna, on=True)

    play(deed)


def test_a_pupils_screen_is_shown_only_after_a_yes_and_until_it_is_taken_back(play: Play) -> None:
    async def deed(room: Classroom) -> None:
        await room.pupil("anna")
        ben = await room.pupil("ben")
        room.agrees("anna")
        await room.say("start", "anna")
        await eventually(lambda: Order("ask_to_show") in room.desks["anna"].orders)
        room.desks["anna"].tell(Note(attended=True, asked_show=True, screen=screen("not asked yet")))
        await eventually(lambda: room.rows["rows"][0].get("asked_show"))
        assert Order("show", on=True) not in room.desks["anna"].orders and await room.is_refused("ben")
        room.desks["anna"].tell(Note(attended=True, may_show=True))
        assert (await told(ben, on=True))["name"] == "anna"
        looking = await room.look("ben")
        await looking.sees("anna's screen")
        assert await room.is_refused("anna")  # it is in front of her
        room.desks["anna"].tell(BLANK)
        assert await looking.why() == "ended"
        await told(ben, on=False)
        await eventually(lambda: room.news)
        assert "anna" in room.news[-1] and room.rows["show"]["on"] is None

    play(deed)


@pytest.mark.parametrize(
    "answers",
    [
        [Note(attended=True, asked_show=True), Note(attended=True, refused="class.refused.no")],
        [Note(attended=True, refused="class.refused.busy")],
    ],
)
def test_without_a_yes_nothing_is_shown_and_the_teacher_is_told(play: Play, answers: list[Note]) -> None:
    async def deed(room: Classroom) -> None:
        await room.pupil("anna")
        await room.pupil("ben")
        await room.say("start", "anna")
        await eventually(lambda: Order("ask_to_show") in room.desks["anna"].orders)
        for answer in answers:
            room.desks["anna"].tell(answer)
        await eventually(lambda: room.news)
        assert "anna" in room.news[-1] and room.rows["show"]["wanted"] is None
        assert Order("show", on=True) not in room.desks["anna"].orders and await room.is_refused("ben")
        await room.say("start", "nobody of this name")
        await eventually(lambda: len(room.news) == 2)

    play(deed)


def test_what_is_shown_to_some_reaches_nobody_else(play: Play) -> None:
    async def deed(room: Classroom) -> None:
        tabs = [await room.pupil(name) for name in ("anna", "ben", "carl")]
        await room.tab(TEACHERS)
        await room.show("", ["ben"])
        await told(tabs[1], on=True)
        looking = await room.look("ben")
        assert await room.is_refused("anna") and await room.is_refused("carl")
        status, _ = await room.doors["anna"].get("mine")
        assert status == 403
        await room.say("start", "", ["anna"])
        await told(tabs[0], on=True)
        assert await looking.why() == "ended" and (await told(tabs[1], on=False))["on"] is False

    play(deed)


def test_a_large_screen_does_not_cover_the_question_whether_the_own_one_may_be_shown(play: Play) -> None:
    async def deed(room: Classroom) -> None:
        anna = await room.pupil("anna")
        await room.tab(TEACHERS)
        await room.show("", full=True)
        assert (await told(anna, on=True))["full"] is True
        await room.say("start", "anna", full=True)
        while (await told(anna, on=True))["full"]:
            await anna.hear()
        room.desks["anna"].tell(Note(attended=True, refused="class.refused.busy"))
        while not (await told(anna, on=True))["full"]:
            await anna.hear()

    play(deed)


@pytest.mark.parametrize("goes", ["desktop", "teacher", "another"])
def test_it_ends_with_the_desktop_with_the_teacher_and_with_the_next_one(play: Play, goes: str) -> None:
    async def deed(room: Classroom) -> None:
        await room.pupil("anna")
        await room.pupil("ben")
        await room.tab(TEACHERS)
        await room.show("anna")
        looking = await room.look("ben")
        await looking.sees("anna's screen")
        if goes == "desktop":
            room.desks["anna"].end()
            assert await looking.why() == "ended"
        elif goes == "teacher":
            await room.page.close()
            assert await looking.why() == "ended"
        else:
            room.agrees(TEACHERS, "the teacher's")
            await room.say("start")
            await looking.sees("the teacher's")  # the same line goes on
        if goes != "desktop":
            await eventually(lambda: Order("show") in room.desks["anna"].orders)

    play(deed)


def test_nothing_but_text_and_colours_reaches_another_pupil(play: Play) -> None:
    evil = (
        "\x1b[31mred\x1b[0m \x1b]52;c;cm0=\x07 \x1b]8;;http://evil/\x1b\\link\x1b]8;;\x1b\\ \x1b]0;title\x07 \x1bPq#0~\x1b\\"
        " \x1b_Gf=24;AAAA\x1b\\ \x9b6n \x1b[6n \x1b[c \x1b[?1003h \x1bc \x1b[2J \u202eesrever\r\x08\x00<script>alert(1)</script>"
    )

    async def deed(room: Classroom) -> None:
        await room.pupil("anna")
        await room.pupil("ben")
        await room.show("anna")
        looking = await room.look("ben")
        await looking.sees("anna's screen")
        found = json.loads(b'{"v": 1, "attended": true, "may_show": true, "shown": true}')
        found["screen"] = {"columns": 500, "rows": 2, "ansi": f"{evil}\n{evil}\nmore lines than rows\n" + "x" * 1000}
        room.desks["anna"].tell_raw(json.dumps(found).encode())
        await looking.next()
        assert set(looking.lines) == {0, 1, 2} and looking.lines[0] == looking.lines[1]
        shown = looking.lines[0].replace("\x1b[31m", "").replace("\x1b[0m", "")
        assert shown.isprintable() and "red" in shown and "more" not in looking.raw
        too_large = {**found, "screen": {"columns": 10**9, "rows": 1, "ansi": ""}}
        room.desks["anna"].tell_raw(json.dumps(too_large).encode())
        room.desks["anna"].tell(Note(attended=True, may_show=True, shown=True, screen=screen("harmless again")))
        await looking.sees("harmless again")
        await looking.ws.send_bytes(b"rm -rf /\r")  # who looks types nothing: the line closes
        assert (await looking.next())["t"] == "closed"
        assert not any(order.do == "type" for order in room.desks["anna"].orders)

    play(deed)


def test_who_takes_nothing_holds_nobody_up_and_then_sees_the_screen_as_it_is(play: Play) -> None:
    async def deed(room: Classroom) -> None:
        for name in ("anna", "ben", "carl"):
            await room.pupil(name)
        await room.show("anna")
        slow, quick = await room.look("ben"), await room.look("carl")
        first = await in_time(slow.ws.receive())  # and never says that it has drawn this
        for number in range(20):
            text = f"first {number}\nsecond"
            room.desks["anna"].tell(Note(attended=True, may_show=True, shown=True, screen=screen(text)))
            await quick.sees(f"first {number}")
        assert "anna's screen" in first.data
        await slow.ws.send_json({"t": "ack"})
        message = await slow.next()
        assert message["lines"] == {"0": "first 19", "1": "second"}

    play(deed)


def test_only_lines_that_changed_are_told_and_all_of_another_size() -> None:
    picture = Picture()
    assert picture.take(screen("one\ntwo")) and not picture.take(screen("one\ntwo\n"))
    assert json.loads(picture.since(0))["lines"] == {"0": "one", "1": "two", "2": ""}
    seen = picture.version
    picture.take(screen("one\n2"))
    assert json.loads(picture.since(seen))["lines"] == {"1": "2"}
    picture.take(screen("one\n2", columns=30))
    assert json.loads(picture.since(seen + 1))["lines"] == {"0": "one", "1": "2", "2": ""}


def test_no_pupil_is_called_as_the_teachers_desktop_nor_has_its_folder() -> None:
    with pytest.raises(BadName):
        clean(TEACHERS)
    assert folder_name(TEACHERS) != TEACHERS


def test_a_server_that_takes_no_notes_for_a_while_gets_the_newest_one_then_and_not_all() -> None:
    from day6_tui.detached.keeper import Keeper

    held: Any = SimpleNamespace(listener=SimpleNamespace(getsockname=lambda: ""))
    near, far = (wire.Connection(each) for each in socket.socketpair())
    keeper = Keeper(held, near, "", "", [], os._exit)  # type: ignore[arg-type]  # which starts no desktop
    keeper._observers = [near]
    size = 50_000
    for number in range(100):
        keeper._hear_desktop(wire.NOTE, b"%02d" % number + b" " * size)
    assert not near.closed and near.unsent <= size + 100
    heard: list[bytes] = []
    while not heard or heard[-1] != b"99":
        heard += [data[:2] for _, data in far.receive()]
        near.flush()
        keeper._tell_behind()
    assert len(heard) < 20 and not keeper._behind
    near.close()
    far.close()
