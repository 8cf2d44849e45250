"""Who comes in by the class word: wrong words, made-up names, half requests; and the teacher is asked. All in this process."""

from __future__ import annotations

import asyncio
import contextlib
import re
from collections import Counter
from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import pytest

from day6_core.isolation.modes import ModeOffer
from day6_core.isolation.same_user import Nothing
from day6_tui.detached import meeting
from day6_tui.web import class_page, connections, lobby, server, sessions
from day6_tui.web.sessions import Full
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import PUPIL, WATCHER, Ticket
from day6_tui.web.tries import MOST_OF_ALL, MOST_OF_ONE, WINDOW, Tries
from day6_tui.web.viewer import Viewer
from tests.support.waiting import Deadline
from tests.web.in_time import in_time
from tests.web.serving import WORD, Browser, browser, run


@dataclass
class InProcess:
    """A server in this process, and what its user was told."""

    base: str = ""
    server: Any = None
    said: list[str] = field(default_factory=list)
    values: list[dict[str, Any]] = field(default_factory=list)

    def tell(self, key: str, **values: object) -> None:
        self.said.append(key)
        self.values.append(values)
        if key == "serve.at":
            self.base = str(values["address"])
        elif key == "serve.teacher":
            self.teacher = str(values["link"])

    @property
    def sessions(self) -> sessions.Sessions:
        found: sessions.Sessions = self.server._sessions
        return found


@asynccontextmanager
async def serving(folder: Path, **settings: Any) -> AsyncIterator[InProcess]:
    made = InProcess()
    offer = ModeOffer("none", Nothing())
    chosen: dict[str, Any] = {"data": folder / "class", "port": 0, "word": WORD} | settings
    made.server = server.Server(ServerSettings(**chosen), offer, made.tell)
    await made.server.open()
    try:
        yield made
    finally:
        await made.server.close()


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path / "run"))
    monkeypatch.setattr(class_page, "PAUSE", 0.01)
    monkeypatch.setattr(connections, "HEADER_SECONDS", 600.0)  # however slow the machine is
    monkeypatch.setattr(connections, "BODY_SECONDS", 600.0)
    monkeypatch.setattr(meeting, "connect", lambda *_: None)  # no desktop runs


def deed_of(folder: Path, deed: Callable[[InProcess, Browser], Coroutine[Any, Any, None]], **settings: Any) -> None:
    async def whole() -> None:
        async with serving(folder, **settings) as made, browser(made.base) as door:
            await deed(made, door)

    run(whole())


class Teacher:
    """The class page without a page."""

    def __init__(self, ws: Any) -> None:
        self._ws = ws
        self.rows: dict[str, Any] = {}

    async def order(self, do: str, **more: object) -> None:
        await self._ws.send_json({"t": "door", "do": do, **more})

    async def until(self, wanted: Callable[[dict[str, Any]], object]) -> dict[str, Any]:
        """The first state of which this is true."""
        deadline = Deadline()
        while not (self.rows and wanted(self.rows)):
            assert not deadline.is_over(), self.rows
            message = await in_time(self._ws.receive_json())
            if message["t"] == "rows":
                self.rows = message
        return self.rows


@asynccontextmanager
async def teaching(made: InProcess) -> AsyncIterator[Teacher]:
    async with browser(made.base) as door:
        await door.get(made.teacher)
        ws = await door.session.ws_connect(f"{door.base}class/ws", headers=door.origin)
        assert (await ws.receive_json())["word"] is True
        yield Teacher(ws)
        await ws.close()


# -- wrong words -------------------------------------------------------------------------------------------------------


@pytest.fixture
def many_files() -> Iterator[None]:
    """macOS lets a process open 256 files, and here both ends of each connection are in one."""
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if soft != resource.RLIM_INFINITY:
        resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, 2000 if hard < 0 else min(hard, 2000)), hard))
    yield
    resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))


class Half:
    """A form of which only the header was sent."""

    def __init__(self, base: str, word: str, name: str = "x") -> None:
        self._at = base.split("//")[1].rstrip("/")
        self._body = urlencode({"word": word, "name": name}).encode()

    async def begin(self) -> Half:
        host, port = self._at.split(":")
        self._reader, self._writer = await asyncio.open_connection(host, int(port))
        form = "Content-Type: application/x-www-form-urlencoded"
        head = f"POST /enter HTTP/1.1\r\nHost: {self._at}\r\nOrigin: http://{self._at}\r\n{form}\r\n"
        self._writer.write(f"{head}Content-Length: {len(self._body)}\r\n\r\n".encode())
        await self._writer.drain()
        return self

    async def end(self) -> int:
        """The status of the answer; 0 if there is none."""
        with contextlib.suppress(ConnectionError):
            self._writer.write(self._body)
            line = await in_time(self._reader.readline())
            self._writer.close()
            return int(line.split()[1]) if line else 0
        return 0


@pytest.mark.usefixtures("many_files")
def test_words_are_counted_when_they_are_answered_however_many_were_begun_before(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        begun = [await Half(made.base, f"wrong {number}").begin() for number in range(300)]
        found = Counter(await asyncio.gather(*(each.end() for each in begun)))
        # An address has no more connections than these at a time.
        assert found == {403: MOST_OF_ONE, 429: connections.MOST_OF_ONE - MOST_OF_ONE, 0: 300 - connections.MOST_OF_ONE}
        assert (await door.post("enter", word=WORD, name="anna"))[0] == 429

    deed_of(tmp_path, deed)


def test_a_try_is_judged_and_counted_in_one_and_an_ipv6_network_is_one_place() -> None:
    now = 0.0
    tries = Tries(lambda: now)
    found = [tries.refusal(f"2001:db8::{number:x}", is_right=False) for number in range(MOST_OF_ONE + 1)]
    assert found == ["wrong"] * MOST_OF_ONE + ["often"]
    assert tries.refusal("2001:db8:0:0:ffff::1", is_right=True) == "often"
    assert tries.refusal("::ffff:192.0.2.1", is_right=True) == tries.refusal("2001:db8:0:1::1", is_right=True) == ""
    others = [tries.refusal(f"192.0.2.{number}", is_right=False) for number in range(MOST_OF_ALL)]
    assert others.count("wrong") == MOST_OF_ALL - MOST_OF_ONE
    now = WINDOW + 1
    assert tries.refusal("2001:db8::1", is_right=True) == ""


def test_browsers_with_old_links_shut_nobody_out(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        assert (await door.post("enter", word=WORD, name="anna"))[0] == 303
        await made.server._sessions.remove("anna")
        made.server._tokens._tickets.clear()
        for _ in range(MOST_OF_ONE + 1):
            assert (await door.get("desk"))[0] == 403
        assert (await door.post("enter", word=WORD, name="bert"))[0] == 303

    deed_of(tmp_path, deed)


# -- half requests -----------------------------------------------------------------------------------------------------


def test_half_a_request_is_not_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connections, "HEADER_SECONDS", 0.2)
    monkeypatch.setattr(connections, "BODY_SECONDS", 0.2)

    async def deed(made: InProcess, door: Browser) -> None:
        host, port = made.base.split("//")[1].rstrip("/").split(":")
        for sent in (b"", b"GET / HTTP/1.1\r\nHost: x\r\n"):
            reader, writer = await asyncio.open_connection(host, int(port))
            writer.write(sent)
            with contextlib.suppress(ConnectionError):
                assert await in_time(reader.read()) == b""
            writer.close()
        monkeypatch.setattr(connections, "HEADER_SECONDS", 600.0)
        late = await Half(made.base, WORD).begin()
        assert b"408 Request Timeout" in await in_time(late._reader.readline())
        assert (await door.get(""))[0] == 200

    deed_of(tmp_path, deed)


@pytest.mark.usefixtures("many_files")
def test_who_asks_at_once_gets_in_beside_many_who_ask_only_half(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        host, port = made.base.split("//")[1].rstrip("/").split(":")
        held = [await asyncio.open_connection(host, int(port)) for _ in range(300)]
        for _, writer in held:
            writer.write(b"GET / HTTP/1.1\r\nHost: x\r\n")
        for _ in range(5):
            assert (await door.get(""))[0] == 200
        for reader, writer in held[: 300 - connections.MOST_OF_ONE]:  # those who have waited longest
            with contextlib.suppress(ConnectionError):
                assert await in_time(reader.read()) == b""
            writer.close()
        assert not any(reader.at_eof() for reader, _ in held[100:])
        for _, writer in held:
            writer.close()

    deed_of(tmp_path, deed)


class Line(asyncio.Transport):
    """A transport that only says where it comes from, and whether it was closed."""

    def __init__(self, address: str) -> None:
        super().__init__({"peername": (address, 1)})
        self.is_closed = False

    def abort(self) -> None:
        self.is_closed = True


def test_where_all_together_have_too_many_connections_the_address_with_the_most_gives_way() -> None:
    async def deed() -> None:
        book = connections.Connections(asyncio.Protocol, most=10)
        greedy = [Line("192.0.2.1") for _ in range(8)]
        others = [Line(f"192.0.2.{number}") for number in range(2, 7)]
        for line in (*greedy, *others):
            book().connection_made(line)
        many = connections.Connections(asyncio.Protocol, most=2)
        alone = [Line(f"192.0.2.{number}") for number in range(4)]
        for line in alone:
            many().connection_made(line)
        assert [line.is_closed for line in alone].count(True) == 2 and len(many) == 2
        assert [line.is_closed for line in greedy] == [True] * 3 + [False] * 5
        assert not any(line.is_closed for line in others) and len(book) == 10

    run(deed())


# -- names -------------------------------------------------------------------------------------------------------------


def test_made_up_names_from_one_address_wait_for_the_teacher_and_the_school_behind_it_for_one_click(
    tmp_path: Path,
) -> None:
    (tmp_path / "pupils.csv").write_text("李雷\n", encoding="utf-8")

    async def deed(made: InProcess, door: Browser) -> None:
        places: Counter[str] = Counter()
        for number in range(300):
            async with browser(made.base) as other:
                address = f"{other.base}enter"
                form = {"word": WORD, "name": f"name{number}"}
                async with other.session.post(
                    address, data=form, headers=other.origin, allow_redirects=False
                ) as answer:
                    places[answer.headers.get("Location", str(answer.status))] += 1
        assert places == {"desk": 3, "lobby": lobby.MOST_OF_ONE, "429": 297 - lobby.MOST_OF_ONE}
        assert made.said.count("serve.lobby.asks") == 1
        assert (await door.post("enter", word=WORD, name="李雷"))[0] == 409  # the list's places are reserved
        async with teaching(made) as teacher:
            state = await teacher.until(lambda rows: len(rows["lobby"]) == lobby.MOST_OF_ONE)
            first = state["lobby"][0]
            assert (first["name"], first["address"], first["why"]) == ("name3", "127.0.0.1", "many")
            assert {row["name"]: row["address"] for row in state["rows"]} == {"李雷": ""} | {
                f"name{number}": "127.0.0.1" for number in range(3)
            }
            await teacher.order("turn_away", ids=[each["id"] for each in state["lobby"]])
            await teacher.until(lambda rows: not rows["lobby"])
            assert (await door.post("enter", word=WORD, name="dora"))[0] == 303
            assert "dora, please wait" in (await door.get(""))[1] or (await door.get(""))[0] == 303
            assert "dora, please wait" in (await door.get("lobby"))[1]
            state = await teacher.until(lambda rows: rows["lobby"])
            assert [each["why"] for each in state["lobby"]] == ["removed"]
            await teacher.order("admit", ids=[state["lobby"][0]["id"]], trust=True)
            await teacher.until(lambda rows: "dora" in {row["name"] for row in rows["rows"]})
            assert (await door.get("lobby"))[0] == 303 and (await door.get("desk"))[0] == 200
            for number in range(20):
                async with browser(made.base) as other:
                    await other.post("enter", word=WORD, name=f"pupil {number}")
                    assert (await other.get("desk"))[0] == 200

    deed_of(tmp_path, deed, unasked=3, class_file=tmp_path / "pupils.csv")


def test_the_teacher_is_asked_about_everybody_and_what_is_decided_reaches_the_browser(tmp_path: Path) -> None:
    async def deed(made: InProcess, anna: Browser) -> None:
        async with browser(made.base) as bert, browser(made.base) as eve, teaching(made) as teacher:
            await teacher.until(lambda rows: rows["asks"] is False)
            await teacher.order("ask", on=True)
            await teacher.until(lambda rows: rows["asks"] is True)
            for each, name in ((anna, "anna"), (bert, "bert"), (eve, "anna")):
                assert (await each.post("enter", word=WORD, name=name))[0] == 303
                assert (await each.get("desk"))[0] == 403
            waiting = (await teacher.until(lambda rows: len(rows["lobby"]) == 3))["lobby"]
            await teacher.order("admit", ids=[waiting[0]["id"], waiting[2]["id"]], trust=False)
            await teacher.order("turn_away", ids=[waiting[1]["id"]])
            await teacher.until(lambda rows: not rows["lobby"])
            assert (await anna.get("lobby"))[0] == 303 and (await anna.get("desk"))[0] == 200
            assert (await anna.get("lobby"))[0] == 303  # in another tab that waited, too
            status, page = await bert.get("lobby", **{"Accept-Language": "zh"})
            assert status == 403 and "老师没有让 bert 进来" in page and 'value="bert"' in page
            assert "already called anna" in (await eve.get("lobby"))[1]
            assert "already called anna" not in (await eve.get("lobby"))[1]
            await teacher.order("remove", name="anna")
            await teacher.until(lambda rows: not rows["rows"])
            assert (await anna.get("desk"))[0] == 403
            (tmp_path / "class" / "homes" / "old").mkdir()
            await teacher.order("ask", on=False)
            await teacher.until(lambda rows: rows["asks"] is False)
            await eve.post("enter", word=WORD, name="old")
            state = await teacher.until(lambda rows: rows["lobby"])
            assert [(each["name"], each["why"]) for each in state["lobby"]] == [("old", "files")]
            assert (await eve.post("leave"))[0] == 303
            await teacher.until(lambda rows: not rows["lobby"])

    deed_of(tmp_path, deed)


@pytest.mark.parametrize(
    ("name", "status", "words"),
    [
        ("m\u0430llory", 400, "mixes letters that look alike"),
        ("\u0441\u043e\u0441\u043e", 409, "looks like coco"),
        ("mal\ufe00lory", 409, "already called mallory"),
        ("mallory\u3164", 409, "already called mallory"),
        ("Mal lory", 409, "looks like mallory"),
        ("王\u30fc", 409, "looks like 王一"),
        ("王一", 409, "already called 王一"),
        ("王二", 303, ""),
    ],
)
def test_a_name_that_could_be_taken_for_another_is_refused_and_the_teacher_is_told(
    tmp_path: Path, name: str, status: int, words: str
) -> None:
    (tmp_path / "pupils.csv").write_text("mallory\ncoco\n王一\n", encoding="utf-8")

    async def deed(made: InProcess, door: Browser) -> None:
        async with teaching(made) as teacher:
            await teacher.until(lambda rows: True)
            found, page = await door.post("enter", word=WORD, name=name)
            assert found == status and words in page
            if "looks like" in words:
                state = await teacher.until(lambda rows: rows["news"])
                assert len(state["news"]) == 1 and re.search(f"127.0.0.1: .*{words}", state["news"][0])
            assert made.said.count("serve.alike") == int("looks like" in words)

    deed_of(tmp_path, deed, class_file=tmp_path / "pupils.csv")


# -- links that are good no more ---------------------------------------------------------------------------------------


def test_a_new_link_closes_the_tabs_that_came_by_the_old_one(tmp_path: Path) -> None:
    (tmp_path / "pupils.csv").write_text("anna\nbert\ncarl\n", encoding="utf-8")

    async def deed(made: InProcess, door: Browser) -> None:
        tabs = {}
        for name in ("anna", "bert", "carl"):
            for kind in (PUPIL, WATCHER):
                tabs[name, kind] = Viewer(None, (80, 24, 0, 0), read_only=kind == WATCHER)  # type: ignore[arg-type]
                made.sessions._tabs.setdefault(name, []).append(tabs[name, kind])
        await door.get(made.teacher)
        await door.post("links/new", kind="pupil", name="anna")
        await door.post("links/new", kind="watch", name="bert")
        assert [who for who, tab in tabs.items() if tab.is_over] == [("anna", PUPIL), ("bert", WATCHER)]
        await door.post("links/new", kind="all")
        assert [who for who, tab in tabs.items() if not tab.is_over] == [("anna", WATCHER), ("carl", WATCHER)]

    deed_of(tmp_path, deed, class_file=tmp_path / "pupils.csv")


def test_a_pupil_who_is_removed_while_the_tab_is_being_opened_gets_no_desktop(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        say = Viewer.say

        async def removed_meanwhile(viewer: Viewer, **words: Any) -> None:
            made.server._tokens.revoke(Ticket(PUPIL, "anna"))
            await say(viewer, **words)

        monkeypatch.setattr(Viewer, "say", removed_meanwhile)
        await door.post("enter", word=WORD, name="anna")
        assert await (await door.tab()).end() == "refused"
        assert not made.sessions.running

    deed_of(tmp_path, deed)


# -- places ------------------------------------------------------------------------------------------------------------


def test_desktops_that_begin_at_the_same_time_are_not_more_than_there_may_be_and_the_list_keeps_its_places(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "pupils.csv").write_text("anna\nbert\n", encoding="utf-8")

    async def deed(made: InProcess, door: Browser) -> None:
        found = made.sessions

        async def begin(name: str) -> bool:
            try:
                await found._new(name)
            except Full:
                return False
            return True

        assert sum(await asyncio.gather(*(begin(f"guest {number}") for number in range(20)))) == 3
        assert set(made.said) >= {"serve.full.kept"} and "serve.full" not in made.said
        assert len({session.domain for session in found.running.values()}) == 3
        assert await asyncio.gather(*map(begin, ("guest 30", "anna", "bert"))) == [False, True, True]
        found.running.clear()

    deed_of(tmp_path, deed, most=5, class_file=tmp_path / "pupils.csv")


# -- what nobody awaits ------------------------------------------------------------------------------------------------


def test_what_fails_in_the_background_is_told_once_and_the_rest_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sessions, "LOOK_SECONDS", 0.01)
    looked: list[str] = []

    async def deed(made: InProcess, door: Browser) -> None:
        async def look_at(session: Any) -> None:
            looked.append(session.name)
            if session.name == "anna":
                raise RuntimeError("no such disk")

        monkeypatch.setattr(made.sessions, "_look_at", look_at)
        for name in ("anna", "bert"):
            await made.sessions._new(name)
        deadline = Deadline()
        while looked.count("bert") < 3:
            assert not deadline.is_over(), looked
            await asyncio.sleep(0.01)
        assert made.said.count("serve.failed") == 1
        assert made.values[made.said.index("serve.failed")]["reason"] == "RuntimeError: no such disk"
        made.sessions.running.clear()

    deed_of(tmp_path, deed, idle=0)


def test_a_class_page_that_cannot_be_shown_is_told_and_comes_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        def fail() -> list[Any]:
            raise RuntimeError("broken")

        monkeypatch.setattr(made.sessions.feed.roster, "rows", fail)
        await door.get(made.teacher)
        ws = await door.session.ws_connect(f"{door.base}class/ws", headers=door.origin)
        await ws.receive_json()
        assert (await in_time(ws.receive())).type.name == "CLOSE"
        assert made.said.count("serve.failed") == 1

    deed_of(tmp_path, deed)
