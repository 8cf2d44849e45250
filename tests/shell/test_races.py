"""What other threads do to a desk while it closes something, with Python changing threads every microsecond."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_core.session.session import Session
from day6_core.shell.desk import Desk


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    desk = Desk(tmp_path, domain_id=0, join_link=False, display=False)
    desk.start(link=False)
    yield desk
    desk.close()
    sys.setswitchinterval(before)


def test_terminals_are_closed_while_programs_come_and_go(desk: Desk) -> None:
    over = threading.Event()

    async def nothing(_: Session) -> int:
        return 0

    def keep_starting() -> None:
        while not over.is_set():
            desk.start_unseen("nothing", nothing)
            time.sleep(0.0002)

    starting = threading.Thread(target=keep_starting)
    starting.start()
    try:
        for _ in range(100):
            desk.open_terminal().close()
    finally:
        over.set()
        starting.join()
    assert desk.terminals == []


def test_every_terminal_is_closed_with_its_desk(tmp_path: Path) -> None:
    desk = Desk(tmp_path, domain_id=0, join_link=False, display=False)
    desk.start(link=False)
    terminals: list[Any] = [desk.open_terminal() for _ in range(4)]
    closed: list[Any] = []
    for terminal in terminals:
        terminal.close = lambda terminal=terminal, close=terminal.close: (closed.append(terminal), close())
    desk.close()
    assert closed == terminals and desk.terminals == []


def test_closing_a_desk_leaves_the_processes_of_another_stopped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from day6_core.shell.process import process as processes

    class Pausable:
        def __init__(self, desk: Desk) -> None:
            self.session = type("Session", (), {"scheduler": desk.scheduler})
            self.stopped = False

        def pause(self, stopped: bool, _: str) -> None:
            self.stopped = stopped

    desks = [Desk(tmp_path / name, domain_id=0, join_link=False, display=False) for name in "ab"]
    theirs = [Pausable(desk) for desk in desks]
    monkeypatch.setattr(processes, "_running", theirs)
    for desk in desks:
        desk.pause()
    assert [each.stopped for each in theirs] == [True, True]
    desks[1].close()
    assert [each.stopped for each in theirs] == [True, False]
    desks[0].close()
