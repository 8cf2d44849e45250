"""Who comes in by the class word: wrong words, made-up names, half requests; and the teacher is asked. All in this process."""

from __future__ import annotations

import asyncio
import contextlib
import json
import re
import struct
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import aiohttp
import pytest
from yarl import URL

from day6_core.classroom import journal
from day6_core.isolation.cell import IsolationError
from day6_core.isolation.modes import ModeOffer
from day6_core.isolation.users import Users
from day6_core.lessons.catalogue import offer
from day6_core.lessons.progress import FOLDER, Progress, StepDone, file_of, save
from day6_tui.main import main
from day6_tui.web import connections, lobby, lookout, server, sessions
from day6_tui.web.lookout import Lookout
from day6_tui.web.names import who_is
from day6_tui.web.sessions import Full
from day6_tui.web.settings import ServerSettings
from day6_tui.web.tokens import PUPIL, WATCHER, Ticket
from day6_tui.web.tries import MOST_OF_ALL, MOST_OF_ONE, WINDOW, Tries
from day6_tui.web.viewer import Viewer
from tests.web.in_process import InProcess, Teacher, deed_of, place, serving, teaching  # noqa: F401
from tests.web.in_time import eventually, in_time
from tests.web.serving import WORD, Browser, browser, run

WIDE = {code: code + 0xFEE0 for code in range(0x21, 0x7F)}
"""Full-width letters, which a Chinese input method may write."""


@pytest.mark.skipif(sys.platform != "linux", reason="users are those of Linux")
def test_a_server_whose_pupils_cannot_get_to_their_homes_says_so_before_any_comes(tmp_path: Path) -> None:
    tmp_path.chmod(0o700)
    made = server.Server(ServerSettings(data=tmp_path / "class"), ModeOffer("users", Users()), InProcess().tell)
    with pytest.raises(IsolationError) as refusal:
        run(made.open())
    assert refusal.value.words.key == "isolation.no.closed"
    assert tmp_path.is_relative_to(refusal.value.words.values["folder"])


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
                    places[answer.headers.get("Location", str(answer.status)).partition("?")[0]] += 1
        assert places == {"come": 3, "lobby": lobby.MOST_OF_ONE, "429": 297 - lobby.MOST_OF_ONE}
        assert made.said.count("serve.lobby.asks") == 1
        async with teaching(made) as teacher:
            state = await teacher.until(lambda rows: len(rows["lobby"]) == lobby.MOST_OF_ONE)
            assert (await door.post("enter", word=WORD, name="李雷"))[0] == 429  # the list's places are reserved
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
            assert (await door.session.head(f"{door.base}lobby")).status == 204
            state = await teacher.until(lambda rows: rows["lobby"])
            assert [each["why"] for each in state["lobby"]] == ["removed"]
            await teacher.order("admit", ids=[state["lobby"][0]["id"]], trust=True)
            await teacher.until(lambda rows: "dora" in {row["name"] for row in rows["rows"]})
            assert (await door.session.head(f"{door.base}lobby")).status == 200  # which takes nobody's place
            assert (await door.get("lobby"))[0] == 303 and await door.opens()
            for number in range(20):
                async with browser(made.base) as other:
                    await other.post("enter", word=WORD, name=f"pupil {number}")
                    assert await other.opens()

    async def again(made: InProcess, door: Browser) -> None:
        for number in range(20, 30):  # what the teacher has said of an address outlives the server
            async with browser(made.base) as other:
                await other.post("enter", word=WORD, name=f"pupil {number}")
                assert await other.opens()

    deed_of(tmp_path, deed, unasked=3, class_file=tmp_path / "pupils.csv")
    deed_of(tmp_path, again, unasked=3, class_file=tmp_path / "pupils.csv")


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
            assert (await anna.get("lobby"))[0] == 303 and await anna.opens()
            assert (await anna.get("lobby"))[0] == 303  # in another tab that waited, too
            status, page = await bert.get("lobby", **{"Accept-Language": "zh"})
            assert status == 403 and "老师没有让 bert 进来" in page and 'value="bert"' in page
            assert "just come in as anna" in (await eve.get("lobby"))[1]
            assert "just come in as anna" not in (await eve.get("lobby"))[1]
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
        ("mal\ufe00lory", 303, "There is a mallory in this class"),
        ("mallory\u3164", 303, "There is a mallory in this class"),
        ("Mal lory", 409, "looks like mallory"),
        ("王\u30fc", 409, "looks like 王一"),
        ("王一", 303, "There is a 王一 in this class"),
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
            page = (await door.get("lobby"))[1] if found == 303 else page
            assert found == status and words in page
            assert await door.opens() != bool(words)
            if "looks like" in words:
                state = await teacher.until(lambda rows: rows["news"])
                assert len(state["news"]) == 1 and re.search(f"127.0.0.1: .*{words}", state["news"][0])
            assert made.said.count("serve.alike") == int("looks like" in words)

    deed_of(tmp_path, deed, class_file=tmp_path / "pupils.csv")


@pytest.mark.parametrize(("listed", "typed"), [(False, "anna"), (False, " ANNA"), (True, "anna"), (True, "王小明")])
def test_a_pupil_at_another_machine_waits_for_the_teacher_and_has_the_same_desk(
    tmp_path: Path, listed: bool, typed: str
) -> None:
    (tmp_path / "pupils.csv").write_text("Anna\n王小明\n" if listed else "nobody else\n", encoding="utf-8")
    name = "王小明" if typed == "王小明" else "Anna"

    async def deed(made: InProcess, first: Browser) -> None:
        if listed:
            await first.get(next(str(each["link"]) for each in made.values if each.get("name") == name))
        else:
            await first.post("enter", word=WORD, name=name)
        assert await first.opens()
        async with browser(made.base) as second, browser(made.base) as eve, teaching(made) as teacher:
            for each in (second, eve):
                assert (await each.post("enter", word=WORD, name=typed))[0] == 303
                assert (await each.get("desk"))[0] == 403
            assert f"There is a {name} in this class" in (await second.get("lobby"))[1]
            waiting = (await teacher.until(lambda rows: len(rows["lobby"]) == 2))["lobby"]
            assert [(each["name"], each["why"]) for each in waiting] == [(name, "listed" if listed else "known")] * 2
            assert [each["here"] for each in waiting] == [False] * 2
            assert {each["was"] for each in waiting} == {"" if listed else "127.0.0.1"}
            await teacher.order(
                "admit", ids=[each["id"] for each in waiting], trust=True
            )  # all from there: but not as her
            async with browser(made.base) as other:
                assert (await other.post("enter", word=WORD, name="bert"))[0] == 303
            await teacher.until(lambda rows: "bert" in {row["name"] for row in rows["rows"]})
            assert (await second.get("desk"))[0] == (await eve.get("desk"))[0] == 403
            await teacher.order("admit", ids=[waiting[0]["id"]], trust=False)
            await teacher.order("turn_away", ids=[waiting[1]["id"]])
            await teacher.until(lambda rows: not rows["lobby"])
            assert (await second.get("lobby"))[0] == 303 and await second.opens()
            assert f"Continue as {name}" in (await second.get(""))[1]
            assert (await eve.get("lobby"))[0] == 403 and (await eve.get("desk"))[0] == 403
            assert await first.opens(), "the link on paper stays good"
            await teacher.order("remove", name=name)
            await teacher.until(lambda rows: name not in {r["name"] for r in rows["rows"] if r["state"] != "absent"})
            assert (await first.get("desk"))[0] == (await second.get("desk"))[0] == 403

    deed_of(tmp_path, deed, class_file=tmp_path / "pupils.csv")


# -- several pupils in one browser -------------------------------------------------------------------------------------


@pytest.fixture
def no_desktops(monkeypatch: pytest.MonkeyPatch) -> None:
    async def show(*_: object) -> None:
        raise Full

    monkeypatch.setattr(sessions.Sessions, "show", show)


async def greeted(door: Browser, who: str = "") -> str:
    """Whose desktop a tab gets; "" for nobody's."""
    query = f"?who={who_is(who)}" if who else ""
    try:
        ws = await door.session.ws_connect(f"{door.base}ws{query}", headers=door.origin)
    except aiohttp.WSServerHandshakeError as error:
        assert error.status == 403
        return ""
    hello = await in_time(ws.receive_json())
    await ws.close()
    return str(hello["name"])


async def entered(door: Browser, name: str, **more: str) -> str:
    """Where who knows the word is sent to."""
    form = {"word": WORD, "name": name, **more}
    async with door.session.post(f"{door.base}enter", data=form, headers=door.origin, allow_redirects=False) as answer:
        return answer.headers["Location"]


@pytest.mark.usefixtures("no_desktops")
def test_who_comes_into_a_browser_takes_nobodys_tab_over(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        assert await entered(door, "anna") == f"come?who={who_is('anna')}"
        assert await greeted(door) == await greeted(door, "anna") == "anna"
        come = await entered(door, "O'Neil")
        status, page = await door.get(come)
        assert status == 200 and "anna is at work in this browser" in page and "as O&#x27;Neil" in page
        assert [await greeted(door, name) for name in ("anna", "O'Neil", "", "eve")] == ["anna", "O'Neil", "", ""]
        assert await entered(door, "carl", beside="") == f"desk?who={who_is('carl')}"
        status, page = await door.get("desk")
        assert status == 303
        _, page = await door.get("")
        assert [name in page for name in ("Continue as anna", "Continue as carl", "Continue as eve")] == [
            True,
            True,
            False,
        ]
        for then in ("", who_is("eve"), who_is("anna"), "//evil.example"):
            form = {"who": who_is("anna"), "then": then}
            address = f"{door.base}leave"
            async with door.session.post(address, data=form, headers=door.origin, allow_redirects=False) as answer:
                assert answer.headers["Location"] == "./"
        assert [await greeted(door, name) for name in ("anna", "O'Neil", "carl")] == ["", "O'Neil", "carl"]
        assert (await door.get(f"desk?who={who_is('anna')}"))[0] == 403
        form = {"who": who_is("O'Neil"), "then": who_is("carl")}
        async with door.session.post(
            f"{door.base}leave", data=form, headers=door.origin, allow_redirects=False
        ) as answer:
            assert answer.headers["Location"] == f"desk?who={who_is('carl')}"
        assert await greeted(door) == "carl"

    deed_of(tmp_path, deed)


@pytest.mark.usefixtures("no_desktops")
def test_links_to_watch_two_pupils_show_each_its_own_and_an_older_servers_cookie_still_counts(tmp_path: Path) -> None:
    (tmp_path / "pupils.csv").write_text("anna\nbert\n", encoding="utf-8")

    async def deed(made: InProcess, door: Browser) -> None:
        for name in ("anna", "bert"):
            _, page = await door.get(f"p/{made.server._tokens.make(Ticket(WATCHER, name))}")
            assert f"../watch?who={who_is(name)}" in page
        assert [(await door.get(f"watch?who={who_is(name)}"))[0] for name in ("anna", "bert", "carl")] == [
            200,
            200,
            403,
        ]
        async with browser(made.base) as older:
            await older.get(f"p/{made.server._tokens.make(Ticket(PUPIL, 'anna'))}")
            (cookie,) = older.session.cookie_jar
            older.session.cookie_jar.clear()
            older.session.cookie_jar.update_cookies({cookie.key.rpartition("-")[0]: cookie.value}, URL(made.base))
            assert await greeted(older) == await greeted(older, "anna") == "anna"
            await older.post("leave", who=who_is("anna"))
            assert await greeted(older) == ""

    deed_of(tmp_path, deed, class_file=tmp_path / "pupils.csv")


def test_who_says_to_be_somebody_is_asked_about_whatever_the_address_may(tmp_path: Path) -> None:
    async def deed(made: InProcess, first: Browser) -> None:
        async with browser(made.base) as eve, teaching(made) as teacher:
            await first.post("enter", word=WORD, name="anna")
            waiting = (await teacher.until(lambda rows: rows["lobby"]))["lobby"]
            await teacher.order("admit", ids=[waiting[0]["id"]], trust=True)
            await teacher.until(lambda rows: not rows["lobby"])
            await eve.post("enter", word=WORD, name="anna")
            assert (await eve.get("desk"))[0] == 403
            assert (await teacher.until(lambda rows: rows["lobby"]))["lobby"][0]["why"] == "known"

    (tmp_path / "class" / "homes" / "anna").mkdir(parents=True)  # so that the first one has to wait, too
    deed_of(tmp_path, deed, unasked=50)


def test_what_makes_the_page_installable_is_there_for_everybody_in_both_languages(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        for start, begins in {"": "./", "?start=desk": "desk", "?start=class": "class", "?start=//evil": "./"}.items():
            for lang, name in {"en": "day6: ", "zh": "day6："}.items():
                status, text = await door.get(f"manifest.webmanifest{start}", **{"Accept-Language": lang})
                told = json.loads(text)
                assert (status, told["start_url"], told["display"]) == (200, begins, "standalone")
                assert told["name"].startswith(name)
        purposes = set()
        for icon in told["icons"]:
            async with door.session.get(f"{made.base}{icon['src']}") as answer:
                data = await answer.read()
                assert answer.status == 200 and answer.content_type == icon["type"]
            if icon["type"] == "image/png":
                width, height = struct.unpack(">II", data[16:24])
                assert data[:8] == b"\x89PNG\r\n\x1a\n" and icon["sizes"] == f"{width}x{height}"
                purposes.add((width, icon["purpose"]))
        assert purposes == {(192, "any"), (512, "any"), (192, "maskable"), (512, "maskable")}
        async with door.session.get(made.base) as answer:
            assert "manifest-src 'self'" in answer.headers["Content-Security-Policy"]
            assert 'rel="manifest" href="manifest.webmanifest"' in await answer.text()
        assert 'href="../manifest.webmanifest"' in (await door.get("p/wrong"))[1]

    deed_of(tmp_path, deed)


def test_who_waits_asks_whether_it_is_decided_and_loses_nothing_by_asking(tmp_path: Path) -> None:
    async def deed(made: InProcess, door: Browser) -> None:
        async def looked() -> int:
            return (await door.session.head(f"{door.base}lobby")).status

        assert await looked() == 200  # who waits for nothing
        async with teaching(made) as teacher:
            await door.post("enter", word=WORD.upper().translate(WIDE), name="anna")
            assert (await door.get("lobby"))[0] == 303
            await door.post("enter", word=f" {WORD.translate(WIDE)} ", name="anna")  # as an input method may write it
            assert [await looked() for _ in range(2)] == [204] * 2
            page = (await door.get("lobby"))[1]
            assert "waiting.js" in page and "http-equiv" in page.partition("<noscript>")[2].partition("</noscript>")[0]
            waiting = (await teacher.until(lambda rows: rows["lobby"]))["lobby"]
            await teacher.order("turn_away", ids=[waiting[0]["id"]])
            await teacher.until(lambda rows: not rows["lobby"])
            assert [await looked() for _ in range(2)] == [200] * 2
            assert "did not let anna in" in (await door.get("lobby"))[1]

    deed_of(tmp_path, deed, unasked=0)


# -- links that are good no more ---------------------------------------------------------------------------------------


def test_a_new_link_closes_the_tabs_that_came_by_the_old_one(tmp_path: Path) -> None:
    (tmp_path / "pupils.csv").write_text("anna\nbert\ncarl\n", encoding="utf-8")

    async def deed(made: InProcess, door: Browser) -> None:
        tabs = {}
        for name in ("anna", "bert", "carl"):
            for kind in (PUPIL, WATCHER):
                tabs[name, kind] = Viewer(None, (80, 24, 0, 0), read_only=kind == WATCHER, lang="en")  # type: ignore[arg-type]
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
    monkeypatch.setattr(lookout, "LOOK_SECONDS", 0.01)
    looked: list[str] = []

    async def deed(made: InProcess, door: Browser) -> None:
        async def look_at(_: Lookout, session: Any) -> None:
            looked.append(session.name)
            if session.name == "anna":
                raise RuntimeError("no such disk")

        monkeypatch.setattr(Lookout, "_look_at", look_at)
        for name in ("anna", "bert"):
            await made.sessions._new(name)
        await eventually(lambda: looked.count("bert") >= 3, lambda: looked)
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


# -- the log of the lesson ---------------------------------------------------------------------------------------------


def test_the_log_has_what_the_teacher_did_also_after_the_server_has_ended_and_only_for_the_teacher(
    tmp_path: Path,
) -> None:
    async def deed(made: InProcess, anna: Browser) -> None:
        async with browser(made.base) as bert, teaching(made) as teacher:
            await teacher.order("ask", on=True)
            await teacher.until(lambda rows: rows["asks"] is True)
            for each, name in ((anna, "anna"), (bert, "bert")):
                await each.post("enter", word=WORD, name=name)
                await each.get("lobby")
            waiting = (await teacher.until(lambda rows: len(rows["lobby"]) == 2))["lobby"]
            await teacher.order("admit", ids=[waiting[0]["id"]], trust=False)
            await teacher.order("turn_away", ids=[waiting[1]["id"]])
            await teacher.until(lambda rows: not rows["lobby"])
            await teacher.order("remove", name="anna")
            await teacher.until(lambda rows: not rows["rows"])

    async def again(made: InProcess, door: Browser) -> None:
        assert (await door.get("class/log.csv"))[0] == 403
        await door.get(made.teacher)
        status, log = await door.get("class/log.csv", **{"Accept-Language": "zh"})
        assert status == 200 and "时间,谁,学生," in log
        rows = [line.split(",", 1)[1] for line in (await door.get("class/log.csv"))[1].splitlines()]
        assert rows == [
            "who,pupil,what,text",
            "server,,the class page's server started,",
            "teacher,all,opened the class,",
            "teacher,anna,let in,127.0.0.1",
            "teacher,bert,turned away,127.0.0.1",
            "teacher,anna,removed from the class,",
            "server,,the class page's server started,",
        ]
        (file,) = (tmp_path / "class" / "server" / "log").iterdir()
        file.with_name("2026-03-02.jsonl").write_bytes(file.read_bytes().splitlines(keepends=True)[2])
        status, log = await door.get("class/log.csv?day=2026-03-02")
        assert status == 200 and "let in" in log and len(log.splitlines()) == 2
        for day in ("2026-02-30", "../../tokens", "2026-03-02/..", "1"):
            assert (await door.get(f"class/log.csv?day={day}"))[0] == 400

    deed_of(tmp_path, deed, unasked=3)
    deed_of(tmp_path, again, unasked=3)


def test_the_report_is_what_report_writes_of_all_days_also_of_who_has_not_come_since_the_server_began(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "pupils.csv").write_text("Anna\n=1+1\nBen\n", encoding="utf-8")

    async def deed(made: InProcess, door: Browser) -> None:
        assert (await door.get("class/report.csv"))[0] == 403
        home = tmp_path / "class" / "homes" / "anna"
        done = Progress("anna")
        done.note("day1", "gone", StepDone())
        for step in offer().lessons[0].steps[:2]:
            done.note("day1", step.name, StepDone(solved=1e9, seconds=60))
        save(file_of(home, "anna"), done)
        (home / FOLDER / "bad.json").symlink_to("/etc/passwd")
        await door.get(made.teacher)
        status, report = await door.get("class/report.csv", **{"Accept-Language": "en"})
        command = ["report", "--data", str(tmp_path / "class"), "--csv", str(tmp_path / "r.csv"), "--lang", "en"]
        assert status == 200 and await asyncio.to_thread(main, command) == 1
        assert (tmp_path / "r.csv").read_bytes().decode() == report
        rows = [line.split(",") for line in report.splitlines()]
        assert [row[:2] for row in rows[1:]] == [["Anna", "2"], ["Ben", ""]]
        assert "bad.json: not a file" in report and "root:" not in report

    deed_of(tmp_path, deed, class_file=tmp_path / "pupils.csv")


def test_on_a_full_disk_the_class_goes_on_and_the_teacher_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(path: Path, data: bytes) -> None:
        raise OSError(28, "No space left on device", str(path))

    async def deed(made: InProcess, anna: Browser) -> None:
        async with teaching(made) as teacher:
            await teacher.until(lambda rows: True)  # that the teacher has come is in the log by now
            monkeypatch.setattr(journal, "append_private", full)
            for number in range(3):
                await anna.post("enter", word=WORD, name=f"anna{number}")
                await anna.get("lobby")
            waiting = (await teacher.until(lambda rows: [each["name"] for each in rows["lobby"]] == ["anna2"]))["lobby"]
            await teacher.order("admit", ids=[waiting[0]["id"]], trust=False)
            rows = await teacher.until(lambda rows: any("log of the lesson" in each for each in rows["news"]))
            assert "no space left" in str(rows["news"]).lower()
            await teacher.order("remove", name="anna2")
            rows = await teacher.until(lambda rows: "anna2" not in {row["name"] for row in rows["rows"]})
            assert not rows["news"] and made.said.count("serve.no_log") == 1
        async with browser(made.base) as door:
            await door.get(made.teacher)
            log = (await door.get("class/log.csv"))[1]
            assert "let in" in log and "removed from the class" in log

    deed_of(tmp_path, deed, unasked=0)
