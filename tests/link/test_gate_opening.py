"""How the gate opens, watches and shuts its doors, with sessions that go nowhere."""

from __future__ import annotations

import errno
import sys
import threading
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import zenoh

from day6_core.link import gateway as gate_module
from day6_core.link.file_lock import FileLock
from day6_core.link.gateway import Gateway
from day6_core.link.paths import MeetingPlace
from day6_core.link.state import Door, DoorState, read_doors
from tests.link.clock import Clock
from tests.link.fake_engine import FakeSession, StillThread

IN, IN_TOO, OUT = "tcp/0.0.0.0:1", "tcp/0.0.0.0:2", "tcp/robot:3"
SECRET = "chalk-and-sponge"
IN_USE = f"taken (os error {errno.EADDRINUSE})"


pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="files have other modes there")


class FakeBridge:
    def __init__(self, inner: Any, outer: Any, domain_id: int, *_: Any) -> None:
        self.sessions = (inner.name, outer.name)
        self.domain_id = domain_id
        self.closed = 0

    def close(self) -> None:
        self.closed += 1


class Gates:
    """A gate whose sessions are opened by `opened`; `refused` are the texts with which the next ones are not."""

    def __init__(self, place: MeetingPlace, monkeypatch: pytest.MonkeyPatch) -> None:
        self.place = place
        self.clock = Clock()
        self.refused: dict[str, str] = {}
        self.log: list[str] = []
        self.seen: list[tuple[Any, ...]] = []
        self.users: list[str] = []
        self.problems: list[str] = []
        self.bridges: list[FakeBridge] = []
        monkeypatch.setattr(gate_module, "time", self.clock)
        monkeypatch.setattr(gate_module, "threading", SimpleNamespace(Thread=StillThread, Event=threading.Event))
        monkeypatch.setattr(gate_module, "Bridge", self._bridge)
        monkeypatch.setattr(gate_module, "outer_config", self._outer_config)
        monkeypatch.setattr(gate_module, "inner_config", lambda place: "inner")
        monkeypatch.setattr(zenoh, "open", self._open)
        monkeypatch.setattr(FakeSession, "info", SimpleNamespace(links=list))
        monkeypatch.setattr(gate_module, "_probe", lambda address: (DoorState.NOBODY, frozenset()))

    def _bridge(self, *arguments: Any) -> FakeBridge:
        self.bridges.append(FakeBridge(*arguments))
        return self.bridges[-1]

    def _outer_config(self, listen: Any, connect: Any, secret: str | None, users: Path) -> str:
        self.seen.append((listen, connect, secret))
        if secret is not None:
            assert users.stat().st_mode & 0o777 == 0o600
            self.users.append(users.read_text())
        return f"outer listening {bool(listen)}"

    def _open(self, config: str) -> FakeSession:
        self.log.append(f"open {config}")
        if config in self.refused:
            raise zenoh.ZError(self.refused[config])
        return FakeSession(config, self.log)

    def gate(self, listen: tuple[str, ...] = (), connect: tuple[str, ...] = (), secret: str | None = None) -> Gateway:
        return Gateway(self.place, 4, listen, connect, secret, self._report, lambda zid: False)

    def _report(self, what: str, error: Exception) -> None:
        self.problems.append(f"{what}: {error}")


@pytest.fixture
def it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Gates:
    return Gates(MeetingPlace(tmp_path, False), monkeypatch)


def states(gate: Gateway) -> list[tuple[DoorState, str]]:
    return [(door.state, door.reason) for door in gate.doors]


def test_all_doors_are_opened_at_once_by_one_bridge(it: Gates) -> None:
    gate = it.gate((IN, IN_TOO), (OUT,), SECRET)
    gate._poll()
    assert it.seen == [((IN, IN_TOO), (OUT,), SECRET)] and it.users == [f"day6:{SECRET}\n"]
    assert it.log == ["open outer listening True", "open inner"]
    (bridge,) = it.bridges
    assert (bridge.sessions, bridge.domain_id) == (("inner", "outer listening True"), 4)
    assert states(gate) == [(DoorState.OPEN, ""), (DoorState.OPEN, ""), (DoorState.NOBODY, "")]
    assert read_doors(it.place) == gate.doors
    assert sorted(path.name.partition("-")[0] for path in it.place.folder.iterdir()) == ["doors", "gate.lock"]
    gate._poll()
    assert len(it.bridges) == 1 and bridge.closed == 0
    assert not FileLock(it.place.folder / "gate.lock").try_acquire()


def test_doors_to_listen_at_that_cannot_be_opened_do_not_keep_us_from_others(it: Gates) -> None:
    it.refused["outer listening True"] = IN_USE
    gate = it.gate((IN, IN_TOO), (OUT,))
    gate._poll()
    assert it.seen == [((IN, IN_TOO), (OUT,), None), ((), (OUT,), None)]
    assert [state for state, _ in states(gate)] == [DoorState.IN_USE, DoorState.IN_USE, DoorState.NOBODY]
    assert [bridge.sessions for bridge in it.bridges] == [("inner", "outer listening False")]
    assert it.users == []


def test_where_nothing_can_be_opened_every_door_says_why_and_nothing_is_left_open(it: Gates) -> None:
    it.refused["inner"] = "no room at /x.rs:1"
    gate = it.gate((IN,), (OUT,), SECRET)
    gate._poll()
    assert states(gate) == [(DoorState.FAILED, "no room")] * 2
    assert it.log == [
        "open outer listening True",
        "open inner",
        "close outer listening True",
        "open outer listening False",
        "open inner",
        "close outer listening False",
    ]
    assert it.bridges == [] and gate._outer is None
    assert not any("guests" in path.name for path in it.place.folder.iterdir())


def test_a_gate_with_nobody_to_reach_opens_nothing_more(it: Gates) -> None:
    it.refused["outer listening True"] = "failed to lookup"
    gate = it.gate((IN,))
    gate._poll()
    assert states(gate) == [(DoorState.NO_NAME, "")] and it.log == ["open outer listening True"]


def test_a_door_that_becomes_free_is_opened_with_the_others_by_a_new_bridge(
    it: Gates, monkeypatch: pytest.MonkeyPatch
) -> None:
    free = [False]
    monkeypatch.setattr(gate_module, "_is_free", lambda endpoint: free[0])
    it.refused["outer listening True"] = IN_USE
    gate = it.gate((IN,), (OUT,))
    gate._poll()
    (first,) = it.bridges
    it.refused.clear()
    it.clock.now += 3
    gate._poll()
    assert len(it.bridges) == 1 and states(gate)[0][0] == DoorState.IN_USE
    free[0] = True
    it.clock.now += 3
    gate._poll()
    assert (first.closed, len(it.bridges)) == (1, 2) and states(gate)[0] == (DoorState.OPEN, "")
    assert it.seen[-1] == ((IN,), (OUT,), None)


def test_doors_are_written_for_others_when_they_change(it: Gates, monkeypatch: pytest.MonkeyPatch) -> None:
    written: list[tuple[Door, ...]] = []
    monkeypatch.setattr(gate_module, "write_doors", lambda place, doors: written.append(doors))
    gate = it.gate((IN,))
    for _ in range(3):
        gate._poll()
    assert written == [gate.doors]
    gate._change(IN, True, joined=1)
    gate._read_links = lambda session: None  # type: ignore[method-assign]
    gate._poll()
    assert [doors[0].joined for doors in written] == [0, 1]


class Waits:
    """In place of the event that ends the gate: it notes how long was waited, and is set after so many waits."""

    def __init__(self, number: int) -> None:
        self.waited: list[float] = []
        self._number = number
        self.set_by_close = False

    def is_set(self) -> bool:
        return len(self.waited) == self._number

    def wait(self, seconds: float) -> None:
        self.waited.append(seconds)

    def set(self) -> None:
        self.set_by_close = True


def test_the_gate_looks_twice_a_second_and_tries_again_every_two(it: Gates) -> None:
    it.refused["inner"] = "no"
    gate = it.gate((), (OUT,))
    waits: Any = Waits(2)
    gate._closing = waits
    gate._run()
    assert waits.waited == [2.0, 2.0] and gate._tried.is_set() and it.log.count("open inner") == 2
    it.refused.clear()
    gate._closing = waits = Waits(2)
    gate._run()
    assert waits.waited == [0.5, 0.5]
    (bridge,) = it.bridges
    assert bridge.closed == 1 and gate._outer is None
    assert FileLock(it.place.folder / "gate.lock").try_acquire(), "the lock was given back"


def test_what_fails_at_a_door_is_told_and_the_gate_goes_on(it: Gates, monkeypatch: pytest.MonkeyPatch) -> None:
    gate = it.gate((IN,))

    def fail() -> None:
        raise OSError("disk full")

    monkeypatch.setattr(gate, "_poll", fail)
    waits: Any = Waits(3)
    gate._closing = waits
    gate._run()
    assert it.problems == ["the gate to other machines: disk full"] * 3 and gate._tried.is_set()


def test_starting_waits_for_the_first_attempt_and_closing_for_the_end_but_not_for_long(it: Gates) -> None:
    gate = it.gate((IN,))
    thread: Any = gate._thread
    gate.close()
    assert thread.joined == [] and gate._closing.is_set()
    gate = it.gate((IN,))
    thread = gate._thread
    patience: list[float] = []
    tried: Any = SimpleNamespace(wait=patience.append, set=lambda: None)
    gate._tried = tried
    gate.start(1.0)
    assert thread.started and thread.daemon and patience == [1.0]
    gate._poll()
    assert read_doors(it.place) != ()
    gate.close()
    assert thread.joined == [0.7] and read_doors(it.place) == ()
