"""What a server keeps for the tabs of one desktop."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("aiohttp", reason="needs the extra: pip install 'day6-tui[serve]'")

from day6_tui.detached import wire
from day6_tui.web.session import WebSession
from day6_tui.web.viewer import MOST_UNACKNOWLEDGED, MOST_WAITING, Viewer


def tab(*, read_only: bool) -> Viewer:
    ws: Any = None  # nothing is sent
    return Viewer(ws, (80, 24, 0, 0), read_only=read_only)


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
