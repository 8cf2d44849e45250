"""What a server keeps for the tabs of one desktop."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("aiohttp", reason="needs the extra: pip install 'day6-tui[serve]'")

from day6_tui.detached import wire
from day6_tui.web.session import WebSession
from day6_tui.web.viewer import MOST_UNACKNOWLEDGED, MOST_WAITING, STALE_SECONDS, UNTOLD, Viewer


def tab(*, read_only: bool) -> Viewer:
    ws: Any = None  # nothing is sent
    return Viewer(ws, (80, 24, 0, 0), read_only=read_only, lang="en")


def session_with_line(frame: bytes) -> tuple[WebSession, Any]:
    """A session, and a line that brings one frame of the desktop whenever it is heard."""
    cell: Any = None
    session = WebSession("anna", cell, 0, lambda over: None)
    line: Any = SimpleNamespace(closed=False, receive=lambda: [(wire.OUTPUT, frame)], on_readable=lambda heard: None)
    session._line = line
    return session, line


def test_a_watching_tab_that_takes_nothing_is_let_go_and_fills_no_memory() -> None:
    session, _ = session_with_line(b"x" * 65536)
    stuck, awake = tab(read_only=True), tab(read_only=True)
    session.watchers += [stuck, awake]
    for _ in range(MOST_WAITING // 65536 * 4):
        session._hear()
        awake._waiting.clear()
    assert stuck.is_over and len(stuck._waiting) <= MOST_WAITING + 65536
    assert not awake.is_over


def test_the_desktop_waits_for_the_tab_that_types() -> None:
    session, line = session_with_line(b"x" * MOST_UNACKNOWLEDGED)
    heard: list[Any] = []
    line.on_readable = heard.append
    session.writer = tab(read_only=False)
    session._is_read = True
    session._hear()
    assert heard == [None] and not session.writer.is_over


class Writer:
    """A session with the tab that types, and everything that the desktop wrote sent to it."""

    def __init__(self) -> None:
        async def taken(data: bytes) -> None:
            """Take it."""

        ws: Any = SimpleNamespace(send_bytes=taken)
        self.session, self.line = session_with_line(b"")
        self.heard: list[Any] = []
        self.line.on_readable = self.heard.append
        self.viewer = self.session.writer = Viewer(ws, (80, 24, 0, 0), read_only=False, lang="en")
        self.viewer.on_room = self.session.has_room
        self.session._read(True)

    async def write(self, size: int) -> None:
        """Have the desktop write so much, and send it."""
        self.line.receive = lambda: [(wire.OUTPUT, b"x" * size)]
        self.session._hear()
        sending = asyncio.create_task(self.viewer.run())
        await asyncio.sleep(0)
        while self.viewer._waiting and self.viewer._sent - self.viewer._acknowledged < MOST_UNACKNOWLEDGED:
            await asyncio.sleep(0)
        sending.cancel()

    @property
    def is_read(self) -> bool:
        """Whether the desktop's output is read."""
        return self.heard[-1] is not None


def test_a_desktop_is_read_again_when_the_tab_has_shown_exactly_all_it_may_have() -> None:
    async def deed() -> None:
        writer = Writer()
        await writer.write(MOST_UNACKNOWLEDGED)
        assert not writer.is_read
        writer.viewer.acknowledge(MOST_UNACKNOWLEDGED)
        assert writer.is_read

    asyncio.run(deed())


def test_a_tab_that_shows_late_gets_fewer_frames_and_no_queue_of_them(monkeypatch) -> None:
    now = 100.0
    monkeypatch.setattr("day6_tui.web.viewer.time.monotonic", lambda: now)

    async def deed() -> None:
        nonlocal now
        writer = Writer()
        await writer.write(UNTOLD)
        now += 10 * STALE_SECONDS
        await writer.write(1000)
        assert writer.is_read, "the page has said nothing of what it does not have to"
        now += STALE_SECONDS - 0.1
        await writer.write(1000)
        assert writer.is_read
        now += 0.2
        await writer.write(1000)
        assert not writer.is_read and not writer.viewer._waiting
        writer.viewer.acknowledge(UNTOLD + 3000)
        assert writer.is_read

    asyncio.run(deed())
