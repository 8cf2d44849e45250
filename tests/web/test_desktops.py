"""A desktop in a tab: it is the pupil's own, it stays when the tab goes, and nothing of it stays when it has ended."""

from __future__ import annotations

import asyncio
import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import aiohttp
import pytest

from day6_tui.web.names import who_is
from day6_tui.web.viewer import MOST_UNACKNOWLEDGED, UNTOLD
from tests.support.short_folder import make_short_folder
from tests.support.waiting import until
from tests.web.in_time import in_time
from tests.web.serving import WORD, Browser, Serving, Tab, browser, run

pytestmark = pytest.mark.process

MADE = "echo made-by-$((40+2))"
SINGLY = ("--most", "2")
"""For so few there is no common parent, whose imports the first desktop would wait for, idle, as nobody can type there yet."""


async def enter(door: Browser, serving: Serving, name: str) -> None:
    status, page = await door.get(serving.link(name))
    assert status == 200 and f"../come?who={who_is(name)}" in page


async def anna(door: Browser, serving: Serving, query: str = "cols=80&rows=24&w=0&h=0") -> Tab:
    await enter(door, serving, "anna")
    tab = await door.tab(query)
    await tab.see("anna@day6:~$")
    return tab


async def say_to_all(serving: Serving, text: str) -> None:
    """What the teacher's page does; it is done when this returns."""
    async with browser(serving.base) as teacher:
        await teacher.get(serving.link("the teacher"))
        ws = await teacher.session.ws_connect(teacher.base + "class/ws", headers=teacher.origin)
        await ws.send_json({"t": "order", "names": "*", "order": {"do": "say", "text": text}})
        while (await in_time(ws.receive_json()))["t"] != "sent":
            pass


def printed(serving: Serving) -> int:
    """The last number that a loop of anna wrote into her file n; 0 before the first and while it is being written."""
    file = serving.folder / "class" / "homes" / "anna" / "n"
    return int(file.read_text() or 0) if file.exists() else 0


def test_a_link_opens_a_desktop_and_a_reload_shows_the_same_screen_again(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            first = await anna(door, class_server)
            assert first.said[0] == {"t": "hello", "name": "anna", "read_only": False, "lang": "en"}
            await first.type(MADE + "; echo [$SECRET_OF_SERVER] [$ROS_DOMAIN_ID]\r")
            await first.see("made-by-42")
            await first.see("[] [1]")
            second = await door.tab()
            await second.see("made-by-42")
            assert await first.end() == "taken"
            await second.ws.close()
            third = await door.tab()
            await third.see("made-by-42")

    run(deed())


def test_pupils_have_desktops_and_homes_of_their_own(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as hers, browser(class_server.base) as his:
            one = await anna(hers, class_server)
            await enter(his, class_server, "李雷")
            other = await his.tab()
            await other.see("day6:~$")
            await one.type("echo of-anna > mine.txt; ls\r")
            await one.see("mine.txt")
            await other.type("ls; echo li-has-$((1+1))\r")
            await other.see("li-has-2")
            assert "mine.txt" not in other.text()

    run(deed())
    homes = class_server.folder / "class" / "homes"
    assert (homes / "anna" / "mine.txt").read_text() == "of-anna\n" and (homes / "李雷").is_dir()


def test_a_desktop_is_measured_and_restarted_with_its_files_and_gets_an_empty_home(class_server: Serving) -> None:
    async def until_told(ws: aiohttp.ClientWebSocketResponse, wanted: Callable[[dict[str, Any]], Any]) -> Any:
        while True:
            found = await in_time(ws.receive_json())
            if found["t"] == "rows" and (told := wanted(found)):
                return told

    async def deed() -> None:
        async with browser(class_server.base) as door, browser(class_server.base) as teacher:
            tab = await anna(door, class_server)
            await tab.type("echo kept-$((40+2)) > kept.txt; cat kept.txt\r")
            await tab.see("kept-42")
            await teacher.get(class_server.link("the teacher"))
            ws = await teacher.session.ws_connect(teacher.base + "class/ws", headers=teacher.origin)
            await ws.send_json({"t": "measure"})
            of_anna = await until_told(
                ws,
                lambda found: [
                    row for row in found["machine"].get("desktops", ()) if row["name"] == "anna" and row["disk"]
                ],
            )
            assert of_anna[0]["memory"] > 10 << 20 and of_anna[0]["processes"] >= 2
            ends = {"restart": "kept-42", "home": "No such file"}
            for number, (do, seen) in enumerate(ends.items(), 1):
                await ws.send_json({"t": "desk", "do": do, "names": ["anna"]})
                assert await tab.end() == "restart"
                tab = await door.tab()  # as the page does it by itself
                await tab.see("anna@day6:~$")
                await tab.type("clear; cat kept.txt\r")
                await tab.see(seen)
                told = await until_told(
                    ws, lambda found, number=number: found["desks"][number - 1 :] and found["desks"][-1]["count"]
                )
                assert told == 1
            await ws.close()

    run(deed())
    (kept,) = (class_server.folder / "class" / "before").iterdir()
    assert (kept / "kept.txt").read_text() == "kept-42\n"


def test_who_watches_sees_the_same_and_types_nothing(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door, browser(class_server.base) as teacher:
            tab = await anna(door, class_server)
            await teacher.get(class_server.link("the teacher"))
            assert (await teacher.post("links/new", kind="watch", name="anna"))[0] == 303
            _, page = await teacher.get("links")
            link = page.partition('<p class="screen">To watch only: <code>')[2].partition("<")[0]
            assert (await teacher.get(link))[0] == 200
            watching = await teacher.tab("cols=80&rows=24&watch=1")
            await watching.type("echo not-$((2+2))\r")
            await tab.type("echo seen-$((3+3))\r")
            await watching.see("seen-6")
            assert "not-4" not in watching.text() and watching.said[0]["read_only"] is True

    run(deed())


def test_sizes_that_no_screen_has_are_made_fit(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            await anna(door, class_server)
            tab = await door.tab("cols=1&rows=1&w=x&h=-3")
            while len(tab.said) < 2:
                assert await tab.hear()
            assert tab.said[1] == {"t": "size", "cols": 20, "rows": 5}
            await tab.ws.send_json({"t": "size", "cols": 5000, "rows": 2000, "w": 1e9, "h": 0})
            while tab.said[-1] != {"t": "size", "cols": 500, "rows": 200}:
                assert await tab.hear()
            await tab.ws.send_json({"t": "size", "cols": 80, "rows": 24, "w": 800, "h": 480})
            await tab.ws.send_json({"t": "ping", "n": 7})
            while tab.said[-1] != {"t": "pong", "n": 7}:
                assert await tab.hear()

    run(deed())


def test_a_tab_that_changes_its_size_while_the_desktop_begins_gets_the_last_one() -> None:
    with Serving(make_short_folder("d6w-"), "--word", WORD, "--isolation", "none") as serving:

        async def deed() -> None:
            async with browser(serving.base) as door:
                assert (await door.post("enter", word=WORD, name="anna"))[0] == 303
                tab = await door.tab()
                while len(tab.said) < 2:
                    assert await tab.hear()
                tab.screen.resize(30, 100)
                await tab.ws.send_json({"t": "size", "cols": 100, "rows": 30, "w": 0, "h": 0})
                await tab.see(lambda text: "F2 Terminal" in text.splitlines()[29])

        run(deed())


@pytest.mark.parametrize(
    ("sent", "code"),
    [
        ("no json", 1008),
        ("[]", 1008),
        ('{"t": "order"}', 1008),
        ('{"t": "ack", "bytes": "many"}', 1008),
        ("[" * 30000, 1008),
        (b"x" * 70_000, 1009),  # or 1006, where the rest of the frame meets a closed socket
    ],
)
def test_what_no_page_of_ours_says_closes_the_socket_and_the_desktop_stays(
    class_server: Serving, sent: str | bytes, code: int
) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            tab = await anna(door, class_server)
            await (tab.ws.send_str(sent) if isinstance(sent, str) else tab.ws.send_bytes(sent))
            while await tab.hear():
                pass
            assert tab.ws.close_code == code or (code, tab.ws.close_code) == (1009, 1006)
            await anna(door, class_server)

    run(deed())


def test_a_tab_that_takes_nothing_gets_no_more_than_it_may_have_and_goes_on_later(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            tab = await anna(door, class_server, "cols=200&rows=60")
            tab.acknowledges, before = False, tab.got
            await tab.type(
                "\x1b[200~n=0; while :; do x=$((++n*999331)); echo $x$x$x$x$x$x$x$x$x$x$x$x; echo $n > n; done\x1b[201~\r"
            )
            try:
                while tab.got - before <= UNTOLD:
                    assert await tab.hear()
                held = 0
                for number in range(1, 100):  # until it gets no more
                    # The desktop has as much again to show, and its answer to the ping stands behind whatever it sent of that.
                    filled = printed(class_server)
                    await asyncio.to_thread(until, lambda filled=filled: printed(class_server) > 2 * filled)
                    await tab.ws.send_json({"t": "ping", "n": number})
                    while tab.said[-1] != {"t": "pong", "n": number}:
                        assert await tab.hear()
                    if tab.got == held:
                        break
                    held = tab.got
                assert tab.got == held and UNTOLD < held - before <= MOST_UNACKNOWLEDGED
            finally:  # the desktop is of all these tests
                tab.acknowledges = True
                await tab.ws.send_json({"t": "ack", "bytes": tab.got})
                await tab.type("\x03")
            await tab.see("anna@day6:~$")

    run(deed())


def test_two_hundred_tabs_of_one_pupil_leave_one(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            await (await anna(door, class_server)).ws.close()
            tabs = await asyncio.gather(*(door.tab() for _ in range(200)))
            ends = {asyncio.create_task(tab.end()): tab for tab in tabs}
            over, left = set[asyncio.Task[str]](), set(ends)
            while len(left) > 1:
                over, left = await asyncio.wait(ends, timeout=0.05)
            assert {task.result() for task in over} == {"taken"}
            (last,) = left
            last.cancel()
            await asyncio.wait([last])
            await (await anna(door, class_server)).ws.close()

    run(deed())


def test_a_pupil_more_than_there_may_be_is_told_so(class_server: Serving) -> None:
    async def deed() -> None:
        doors = []
        for name in ("anna", "李雷", "bert", "carl"):
            async with browser(class_server.base) as door:
                if name == "carl":
                    assert (await door.post("enter", word=WORD, name=name))[0] == 303
                    assert await (await door.tab()).end() == "full"
                    continue
                await enter(door, class_server, name)
                tab = await door.tab()
                await tab.see("day6:~$")
                doors.append(name)
        assert len(doors) == 3

    run(deed())


@pytest.mark.parametrize("record", [b"", None, b"{"], ids=["whole", "missing", "broken"])
def test_a_server_that_was_killed_finds_its_desktops_again_and_one_that_ends_leaves_nothing(
    record: bytes | None,
) -> None:
    folder = make_short_folder("d6w-")
    with Serving(folder, "--word", WORD, "--isolation", "none") as serving:

        async def deed() -> None:
            async with browser(serving.base) as door:
                assert (await door.post("enter", word=WORD, name="anna"))[0] == 303
                tab = await door.tab()
                await tab.see("anna@day6:~$")
                await tab.type("echo kept > kept.txt; sleep 600 & " + MADE + "\r")
                await tab.see("made-by-42")
                cookies = door.session.cookie_jar
                await say_to_all(serving, "this is not lost")
                serving.end(signal.SIGKILL)
                assert serving.cells()
                if record is None:  # the disk was full when the desktop began
                    (folder / "class" / "server" / "sessions.json").unlink()
                elif record:
                    (folder / "class" / "server" / "sessions.json").write_bytes(record)
                serving.start()
                assert any("1 desktops of the last server are still running" in line for line in serving.said)
                async with browser(serving.base) as teacher:
                    await teacher.get(serving.link("the teacher"))
                    log = (await teacher.get("class/log.csv"))[1]
                    assert "teacher,anna,said,this is not lost" in log and log.count("server started") == 2
                async with aiohttp.ClientSession(cookie_jar=cookies) as session:
                    again = await Browser(session, serving.base).tab()
                    await again.see("made-by-42")
                    serving.process.send_signal(signal.SIGTERM)
                    assert await again.end() == "server"

        run(deed())
        assert serving.end() == 0
        assert serving.cells() == []
        assert (folder / "class" / "homes" / "anna" / "kept.txt").read_text() == "kept\n"


def test_a_desktop_nobody_types_at_ends_and_its_files_stay() -> None:
    folder = make_short_folder("d6w-")
    with Serving(folder, "--word", WORD, "--isolation", "none", "--idle", "0.05", *SINGLY) as serving:

        async def deed() -> None:
            async with browser(serving.base) as door:
                assert (await door.post("enter", word=WORD, name="anna"))[0] == 303
                tab = await door.tab()
                async with tab.not_idle():
                    await tab.see("anna@day6:~$")
                    await tab.type("echo kept > kept.txt\r")
                    await asyncio.to_thread(until, (folder / "class" / "homes" / "anna" / "kept.txt").exists)
                assert await tab.end() == "idle"

        run(deed())
        assert serving.end() == 0 and serving.cells() == []
        assert Path(folder, "class", "homes", "anna", "kept.txt").exists()
        assert any("anna: ended after 0.05 minutes without a key" in line for line in serving.said)


def test_a_home_that_grows_too_large_is_told_and_then_the_desktop_ends_with_its_files(tmp_path: Path) -> None:
    table = tmp_path / "pupils.csv"
    table.write_text("name\nanna\n")
    # Idle after 6 s, so that it looks every 1.5 s.
    words = ("--class", str(table), "--isolation", "none", "--disk", "16", "--idle", "0.1", *SINGLY)
    with Serving(make_short_folder("d6w-"), *words) as serving:
        homes = serving.folder / "class" / "homes"

        async def deed() -> None:
            async with browser(serving.base) as door:
                await enter(door, serving, "anna")
                tab = await door.tab()
                async with tab.not_idle():
                    await tab.see("anna@day6:~$")
                    await tab.type("head -c 9000000 /dev/zero > one; cp one two\r")
                    await tab.see("Your home")
                    await asyncio.to_thread(until, lambda: (homes / "anna" / "two").stat().st_size == 9_000_000)
                    (serving.folder / "three").write_bytes(bytes(9_000_000))
                    os.replace(serving.folder / "three", homes / "anna" / "three")  # never seen half there
                    assert await tab.end() == "disk"

        run(deed())
        assert [(homes / "anna" / name).stat().st_size for name in ("one", "two", "three")] == [9_000_000] * 3
        assert serving.end() == 0
    assert any("ended, 25 MB in the home folder with 16 MB allowed" in line for line in serving.said)
