"""Desktops start a few at a time, and each tab knows how many are before it. The desktops are sockets of the tests."""

from __future__ import annotations

import asyncio
import errno
import socket
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from day6_core.isolation.cell import Cell
from day6_tui.detached import wire
from day6_tui.web import sessions, starting
from day6_tui.web.viewer import Viewer
from tests.web.in_process import InProcess, place, serving  # noqa: F401
from tests.web.in_time import eventually
from tests.web.serving import WORD, Browser, Tab, browser, run

PUPILS = ("anna", "bert", "carl", "dora", "emil")


class Desktops:
    """Every desktop that was started, in order, by the pupil's name; what `fails` does not start."""

    def __init__(self) -> None:
        self.lines: dict[str, wire.Connection] = {}
        self.words: dict[str, list[str]] = {}
        self.fails: set[str] = set()

    def start(
        self, mode: object, cell: Cell, keepers: Path, domain: int, words: list[str], *_: object
    ) -> socket.socket:
        if cell.name in self.fails:
            raise OSError(errno.EIO, "no such program")
        self.words[cell.name] = words
        ours, theirs = socket.socketpair()
        self.lines[cell.name] = wire.Connection(theirs)
        return ours

    def draw(self, name: str) -> None:
        self.lines[name].send(wire.OUTPUT, b"\x1b[?1049h$ ")

    async def started(self, *names: str) -> None:
        """Wait until just these were started."""
        await eventually(lambda: len(self.lines) >= len(names), lambda: list(self.lines))
        assert set(self.lines) == set(names)

    async def typed(self, name: str, keys: bytes) -> None:
        got: list[bytes] = []

        def came() -> bool:
            got.extend(data for kind, data in self.lines[name].receive() if kind == wire.INPUT)
            return keys in b"".join(got)

        await eventually(came, lambda: got)


class Pupil:
    """A browser and its tab."""

    def __init__(self, name: str, door: Browser) -> None:
        self.name, self.door = name, door

    async def come(self, **headers: str) -> Pupil:
        if not hasattr(self, "tab"):
            await self.door.post("enter", word=WORD, name=self.name)
        self.tab: Tab = await self.door.tab(**headers)
        return self

    async def before(self, number: int) -> None:
        """Wait until the tab was told this number."""
        while self.told[-1:] != [number]:
            assert await self.tab.hear(), self.tab.said

    @property
    def told(self) -> list[int]:
        return [message["before"] for message in self.tab.said if message["t"] == "starting"]


Deed = Callable[[InProcess, Desktops, dict[str, Pupil]], Coroutine[Any, Any, None]]


def two_at_once(folder: Path, monkeypatch: pytest.MonkeyPatch, deed: Deed, **settings: Any) -> None:
    """Five pupils may come to a server that starts two desktops at a time."""
    found = Desktops()
    monkeypatch.setattr(sessions, "at_once", lambda: 2)
    monkeypatch.setattr(starting, "start", found.start)
    monkeypatch.setattr(starting, "stop", lambda *_: True)

    async def whole() -> None:
        async with (
            serving(folder, **settings) as made,
            browser(made.base) as a,
            browser(made.base) as b,
            browser(made.base) as c,
            browser(made.base) as d,
            browser(made.base) as e,
        ):
            await deed(
                made, found, {name: Pupil(name, door) for name, door in zip(PUPILS, (a, b, c, d, e), strict=True)}
            )

    run(whole())


async def all_come(pupils: dict[str, Pupil]) -> list[Pupil]:
    for number, pupil in enumerate(pupils.values()):
        await pupil.come()
        await pupil.before(number if number > 1 else 0)
    return list(pupils.values())


def test_each_who_waits_is_told_how_many_are_before_and_keys_are_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def deed(made: InProcess, found: Desktops, pupils: dict[str, Pupil]) -> None:
        _, bert, carl, dora, emil = await all_come(pupils)
        await found.started("anna", "bert")
        await emil.tab.type("early")
        await emil.tab.ws.send_json({"t": "ping", "n": 7})
        while emil.tab.said[-1] != {"t": "pong", "n": 7}:  # the page does not take the line for dead
            assert await emil.tab.hear()
        found.draw("bert")
        await bert.tab.see("$")
        await found.started("anna", "bert", "carl")
        await dora.before(2)
        await emil.before(3)
        found.draw("anna")
        await found.started("anna", "bert", "carl", "dora")
        found.draw("carl")
        await found.started(*PUPILS)
        await emil.before(0)
        found.draw("emil")
        await emil.tab.see("$")
        await found.typed("emil", b"early")
        await carl.before(0)
        assert (carl.told, dora.told[0], emil.told[0]) == ([2, 0], 3, 4)

    two_at_once(tmp_path, monkeypatch, deed)


@pytest.mark.parametrize(("chosen", "spoken"), [("", ("zh", "en", "en")), ("zh", ("zh", "zh", "zh"))])
def test_a_desktop_speaks_the_language_of_its_browser_unless_the_server_chose_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, chosen: str, spoken: tuple[str, ...]
) -> None:
    asks = {"anna": "zh-CN,zh;q=0.9,en;q=0.8", "bert": "en-GB", "carl": "fr"}

    async def deed(made: InProcess, found: Desktops, pupils: dict[str, Pupil]) -> None:
        for name, languages in asks.items():
            await pupils[name].come(**{"Accept-Language": languages})
        await found.started("anna", "bert")
        found.draw("anna")
        await found.started(*asks)
        assert [found.words[name] for name in asks] == [["--lang", language] for language in spoken]

    two_at_once(tmp_path, monkeypatch, deed, desktop_lang=chosen)


def test_who_goes_while_waiting_keeps_nobody_else_waiting_and_a_reload_keeps_the_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def deed(made: InProcess, found: Desktops, pupils: dict[str, Pupil]) -> None:
        _, _, carl, dora, _ = await all_come(pupils)
        await carl.tab.ws.close()
        await dora.tab.ws.close()
        await dora.come()
        await dora.before(3)
        await found.started("anna", "bert")
        found.draw("anna")
        await found.started("anna", "bert", "dora")
        found.draw("dora")
        await dora.tab.see("$")
        await found.started("anna", "bert", "dora", "emil")
        assert "carl" not in made.sessions.running
        await carl.come()
        found.draw("bert")
        await found.started("anna", "bert", "dora", "emil", "carl")

    two_at_once(tmp_path, monkeypatch, deed)


def test_a_second_tab_that_goes_before_its_turn_leaves_the_first_one_its_desktop(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def deed(made: InProcess, found: Desktops, pupils: dict[str, Pupil]) -> None:
        anna = await pupils["anna"].come()
        await found.started("anna")
        second = Viewer(None, (80, 24, 0, 0), read_only=False, lang="en")  # type: ignore[arg-type]
        second.bye("gone")
        assert await made.sessions.show("anna", second) is None
        found.draw("anna")
        await anna.tab.see("$")
        assert not made.sessions.running["anna"].is_over

    two_at_once(tmp_path, monkeypatch, deed)


def test_a_desktop_that_fails_hangs_or_is_left_while_it_starts_lets_the_next_one_start(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sessions, "DRAW_SECONDS", 0.05)

    async def deed(made: InProcess, found: Desktops, pupils: dict[str, Pupil]) -> None:
        found.fails = {"carl"}
        everybody = [await pupil.come() for pupil in pupils.values()]
        await found.started("anna", "bert", "dora", "emil")
        assert await everybody[2].tab.end() == "refused"
        assert "carl" not in made.sessions.running
        assert made.said.count("serve.refused") == 1

    two_at_once(tmp_path, monkeypatch, deed)


@pytest.mark.parametrize("how", ["close", "remove", "link"])
def test_who_waits_hears_at_once_that_the_server_ends_or_the_teacher_removes_somebody(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, how: str
) -> None:
    async def deed(made: InProcess, found: Desktops, pupils: dict[str, Pupil]) -> None:
        _, _, carl, dora, _ = await all_come(pupils)
        if how == "close":
            ending = asyncio.create_task(made.sessions.end_all())
            assert [await dora.tab.end(), await carl.tab.end()] == ["server", "server"]
            await ending
            assert not made.sessions.running and set(found.lines) == {"anna", "bert"}
        elif how == "remove":
            await made.sessions.remove("carl")
            assert await carl.tab.end() == "removed"
            await dora.before(2)
            assert "carl" not in made.sessions.running
        else:
            made.sessions.turn_out("carl", "refused")
            assert await carl.tab.end() == "refused"
            found.draw("anna")
            await dora.before(0)
            await found.started("anna", "bert", "dora")

    two_at_once(tmp_path, monkeypatch, deed)
