"""What the gate finds out about its doors, and how all this machine's processes learn of them; no session is opened."""

from __future__ import annotations

import errno
import json
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.link import gateway as gate_module
from day6_core.link import state as state_module
from day6_core.link.addresses import Address, address_of
from day6_core.link.file_lock import FileLock
from day6_core.link.gateway import Gateway
from day6_core.link.paths import MeetingPlace
from day6_core.link.secret import secret_of
from day6_core.link.state import Door, DoorState, read_doors, remove_doors, write_doors
from tests.support.free_port import free_port


@pytest.fixture
def listener() -> Iterator[socket.socket]:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        yield other


# -- what an error means -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "state", "reason"),
    [
        (
            f"Can not create a new TCP listener (os error {errno.EADDRINUSE}) at /x.rs:1.",
            DoorState.IN_USE,
            os.strerror(errno.EADDRINUSE),
        ),
        ("taken (os error 10048)", DoorState.IN_USE, os.strerror(10048)),
        ("taken (os error 10013)", DoorState.IN_USE, os.strerror(10013)),
        (f"(os error {errno.EACCES}) at /x.rs:1", DoorState.FAILED, os.strerror(errno.EACCES)),
        ("failed to lookup address information: nobody at /x.rs:3", DoorState.NO_NAME, ""),
        ("Something else at /home/zenoh/x.rs:3 at /y", DoorState.FAILED, "Something else"),
        ("short", DoorState.FAILED, "short"),
    ],
)
def test_an_error_of_zenoh_is_told_by_the_systems_number(text: str, state: DoorState, reason: str) -> None:
    assert gate_module._problem_in(text) == (state, reason)


# -- what is asked of the network --------------------------------------------------------------------------------------


@pytest.mark.process
def test_a_door_is_free_when_nobody_has_its_port(listener: socket.socket) -> None:
    taken = listener.getsockname()[1]
    assert not gate_module._is_free(f"tcp/127.0.0.1:{taken}")
    assert gate_module._is_free(f"tcp/127.0.0.1:{free_port()}")
    assert gate_module._is_free(f"udp/127.0.0.1:{free_port(socket.SOCK_DGRAM)}")
    assert not gate_module._is_free("tcp/no-such-host.invalid:7447")


@pytest.mark.skipif(sys.platform == "win32", reason="ports are shared in another way there")
def test_udp_ports_are_others_than_those_of_tcp() -> None:
    with socket.socket(type=socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
        assert not gate_module._is_free(f"udp/127.0.0.1:{port}")
        assert gate_module._is_free(f"ws/127.0.0.1:{port}")


def test_who_answers_without_joining_does_not_let_us_in(listener: socket.socket) -> None:
    port = listener.getsockname()[1]
    state, addresses = gate_module._probe(Address("tcp", "127.0.0.1", port))
    assert (state, addresses) == (DoorState.NOT_LET_IN, {f"127.0.0.1:{port}"})


@pytest.mark.process
def test_a_port_without_a_program_a_name_without_a_machine_and_udp() -> None:
    port = free_port()
    assert gate_module._probe(Address("tcp", "127.0.0.1", port)) == (DoorState.NOBODY, {f"127.0.0.1:{port}"})
    assert gate_module._probe(Address("udp", "127.0.0.1", port)) == (DoorState.NO_ANSWER, {f"127.0.0.1:{port}"})
    assert gate_module._probe(Address("tcp", "no-such-host.invalid", port)) == (DoorState.NO_NAME, frozenset())


def test_who_does_not_answer_in_time_is_told_so(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(address: tuple[str, int], patience: float) -> Any:
        assert 0 < patience <= 5
        raise TimeoutError

    monkeypatch.setattr(socket, "create_connection", never)
    assert gate_module._probe(Address("tcp", "127.0.0.1", 7447))[0] == DoorState.NO_ANSWER


def test_addresses_are_written_as_links_write_them() -> None:
    assert gate_module._host_and_port("1.2.3.4", 5) == "1.2.3.4:5"
    assert gate_module._host_and_port("fe80::1", 7447) == "[fe80::1]:7447"


# -- the doors ---------------------------------------------------------------------------------------------------------


class Clock:
    now = 1000.0

    def monotonic(self) -> float:
        return self.now


class Links:
    """A session that says which links it has, `(near, far)`."""

    def __init__(self, *links: tuple[str, str]) -> None:
        self._links = [SimpleNamespace(src=near, dst=far) for near, far in links]

    @property
    def info(self) -> Links:
        return self

    def links(self) -> list[SimpleNamespace]:
        return self._links


@pytest.fixture
def place(tmp_path: Path) -> MeetingPlace:
    return MeetingPlace(tmp_path, False)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(gate_module, "time", clock)
    return clock


def gate_of(
    place: MeetingPlace, listen: tuple[str, ...] = (), connect: tuple[str, ...] = (), secret: str | None = None
) -> Gateway:
    return Gateway(place, 0, listen, connect, secret, lambda what, error: None, lambda zid: False)


def test_a_gate_begins_with_doors_that_open(place: MeetingPlace) -> None:
    gate = gate_of(place, ("tcp/0.0.0.0:1", "udp/0.0.0.0:2"), ("tcp/a:3",))
    assert gate.doors == (
        Door("tcp/0.0.0.0:1", True, DoorState.OPENING, False),
        Door("udp/0.0.0.0:2", True),
        Door("tcp/a:3", False),
    )
    assert [door.secret for door in gate_of(place, ("tcp/0.0.0.0:1",), (), "12345678").doors] == [True]


def test_machines_are_counted_once_at_the_door_they_came_in_by(place: MeetingPlace) -> None:
    gate = gate_of(place, ("tcp/0.0.0.0:7447", "tcp/0.0.0.0:17447"))
    near = "tcp/10.0.0.1:7447"
    gate._read_links(Links((near, "tcp/a:1"), (near, "tcp/b:2"), (near, "tcp/a:1"), ("tcp/10.0.0.1:17447", "tcp/c:3")))  # type: ignore[arg-type]
    assert [door.joined for door in gate.doors] == [2, 1]
    gate._read_links(Links())  # type: ignore[arg-type]
    assert [door.joined for door in gate.doors] == [0, 0]


def test_a_machine_that_is_not_joined_is_asked_why_every_five_seconds(
    place: MeetingPlace, clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[Address] = []
    answer = (DoorState.NOBODY, frozenset({"1.2.3.4:7447", "[::5]:7447"}))
    monkeypatch.setattr(gate_module, "_probe", lambda address: asked.append(address) or answer)
    gate = gate_of(place, connect=("tcp/robot:7447",))

    def look(*links: tuple[str, str]) -> tuple[DoorState, int, int]:
        gate._read_links(Links(*links))  # type: ignore[arg-type]
        (door,) = gate.doors
        return door.state, door.joined, len(asked)

    joined = ("tcp/10.0.0.1:5", "tcp/1.2.3.4:7447?bind=x")
    assert look() == (DoorState.NOBODY, 0, 1)
    assert asked == [Address("tcp", "robot", 7447)]
    clock.now += 4.9
    assert look() == (DoorState.NOBODY, 0, 1)
    clock.now += 0.2
    assert look() == (DoorState.NOBODY, 0, 2)
    assert look(joined) == (DoorState.OPEN, 1, 2)
    assert look(("tcp/10.0.0.1:5", "tcp/[::5]:7447")) == (DoorState.OPEN, 1, 2)
    assert look() == (DoorState.OPEN, 1, 2), "it has gone this moment; at the next look it is asked"
    assert look() == (DoorState.NOBODY, 0, 3)


def test_a_machine_that_is_joined_when_its_addresses_become_known_is_not_said_to_be_shut(
    place: MeetingPlace, clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate_module, "_probe", lambda address: (DoorState.NOT_LET_IN, frozenset({"1.2.3.4:7447"})))
    gate = gate_of(place, connect=("tcp/robot:7447",))
    links = Links(("tcp/10.0.0.1:5", "tcp/1.2.3.4:7447"))
    gate._read_links(links)  # type: ignore[arg-type]
    assert gate.doors[0].state == DoorState.OPENING
    gate._read_links(links)  # type: ignore[arg-type]
    assert (gate.doors[0].state, gate.doors[0].joined) == (DoorState.OPEN, 1)


def test_a_shut_door_is_tried_when_all_are_free_but_not_more_often_than_every_two_seconds(
    place: MeetingPlace, clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    free = {"tcp/0.0.0.0:1": True, "tcp/0.0.0.0:2": False}
    monkeypatch.setattr(gate_module, "_is_free", free.__getitem__)
    gate = gate_of(place, tuple(free))
    for endpoint in free:
        gate._change(endpoint, True, state=DoorState.IN_USE)
    assert not gate._may_listen_now()
    free["tcp/0.0.0.0:2"] = True
    assert not gate._may_listen_now(), "it was just looked"
    clock.now += 2.0
    assert gate._may_listen_now()
    for endpoint in free:
        gate._change(endpoint, True, state=DoorState.OPEN)
    clock.now += 2.0
    assert not gate._may_listen_now()
    only_out = gate_of(place, connect=("tcp/a:1",))
    assert not only_out._may_listen_now()


def test_a_gate_that_another_program_keeps_is_told_at_every_door(place: MeetingPlace) -> None:
    other = FileLock(place.folder / "gate.lock")
    assert other.try_acquire()
    gate = gate_of(place, ("tcp/0.0.0.0:1",), ("tcp/a:3",))
    gate._open()
    words = "another program of yours has opened the doors of this domain"
    assert [(door.state, door.reason) for door in gate.doors] == [(DoorState.FAILED, words)] * 2
    other.release()


# -- what other processes read -----------------------------------------------------------------------------------------

DOORS = (Door("tcp/a:1", True, DoorState.OPEN, True, 3, ""), Door("tcp/b:2", False, DoorState.FAILED, False, 0, "错"))


def test_doors_are_read_by_others_as_they_were_written_and_by_nobody_else(place: MeetingPlace) -> None:
    write_doors(place, DOORS)
    assert read_doors(place) == DOORS
    (file,) = place.folder.iterdir()
    assert file.name == f"doors-{os.getpid()}"
    if sys.platform != "win32":
        assert file.stat().st_mode & 0o777 == 0o600
    write_doors(place, DOORS[:1])
    assert read_doors(place) == DOORS[:1]
    remove_doors(place)
    remove_doors(place)
    assert read_doors(place) == () and list(place.folder.iterdir()) == []


@pytest.mark.process
def test_doors_of_several_processes_are_one_list_and_what_the_dead_left_goes(place: MeetingPlace) -> None:
    with subprocess.Popen([sys.executable, "-c", ""]) as ended:
        ended.wait()
    dead = place.folder / f"doors-{ended.pid}"
    dead.write_text("[]")
    alive = place.folder / f"doors-{os.getppid()}"
    alive.write_text(json.dumps([["tcp/c:3", True, "in use", False, 0, ""]]))
    (place.folder / "other").write_text("[]")
    write_doors(place, DOORS)
    assert sorted(door.endpoint for door in read_doors(place)) == ["tcp/a:1", "tcp/b:2", "tcp/c:3"]
    assert not dead.exists() and alive.exists() and (place.folder / "other").exists()


def test_a_file_that_another_process_removes_first_hides_no_doors(
    place: MeetingPlace, monkeypatch: pytest.MonkeyPatch
) -> None:
    def ended(pid: int) -> bool:
        if pid == 1:
            (place.folder / "doors-1").unlink()
        return pid != 1

    monkeypatch.setattr(state_module, "process_exists", ended)
    (place.folder / "doors-1").write_text("[]")
    (place.folder / "doors-2").write_text(json.dumps([["tcp/c:3", True, "in use", False, 0, ""]]))
    assert [door.endpoint for door in read_doors(place)] == ["tcp/c:3"]


def test_doors_of_a_place_that_is_gone_are_none(tmp_path: Path) -> None:
    gone = MeetingPlace(tmp_path / "gone", False)
    assert read_doors(gone) == ()
    remove_doors(gone)


# -- a lock ------------------------------------------------------------------------------------------------------------


def test_a_lock_has_one_holder_until_it_is_released(tmp_path: Path) -> None:
    one, other = FileLock(tmp_path / "lock"), FileLock(tmp_path / "lock")
    assert (one.held, one.try_acquire(), one.try_acquire(), one.held) == (False, True, True, True)
    assert (other.try_acquire(), other.held) == (False, False)
    one.release()
    one.release()
    assert not one.held
    assert other.try_acquire() and not one.try_acquire()
    other.release()
    if sys.platform != "win32":
        assert (tmp_path / "lock").stat().st_mode & 0o777 == 0o600


def test_asking_for_a_taken_lock_leaves_no_file_open(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    one, other = FileLock(tmp_path / "lock"), FileLock(tmp_path / "lock")
    assert one.try_acquire()
    opened: list[int] = []
    original = os.open

    def noted(*arguments: Any) -> int:
        opened.append(original(*arguments))
        return opened[-1]

    with monkeypatch.context() as patched:
        patched.setattr(os, "open", noted)
        assert not other.try_acquire()
    (descriptor,) = opened
    with pytest.raises(OSError):
        os.fstat(descriptor)
    one.release()


# -- endpoints and secrets ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("endpoint", "address"),
    [
        ("tcp/1.2.3.4:1", Address("tcp", "1.2.3.4", 1)),
        ("udp/robot.local:65535", Address("udp", "robot.local", 65535)),
        ("ws/[fe80::1]:7447", Address("ws", "fe80::1", 7447)),
        (f"tcp/{'a' * 63}:80", Address("tcp", "a" * 63, 80)),
        ("tcp/a-b_c.d.:80", Address("tcp", "a-b_c.d.", 80)),
    ],
)
def test_an_endpoint_has_a_protocol_a_host_and_a_port(endpoint: str, address: Address) -> None:
    assert address_of(endpoint, listening=False) == address_of(endpoint, listening=True) == address


@pytest.mark.parametrize(
    ("endpoint", "error"),
    [
        ("", "'' is not an endpoint like tcp/192.168.1.5:7447"),
        ("tcp", "'tcp' is not an endpoint like tcp/192.168.1.5:7447"),
        ("tcp/", "'tcp/' is not an endpoint like tcp/192.168.1.5:7447"),
        ("/a:1", "'/a:1' is not an endpoint like tcp/192.168.1.5:7447"),
        ("quic/a:1", "'quic/a:1' has an unknown protocol: use tcp, udp or ws"),
        ("tcp/a", "'tcp/a' has no port: write tcp/a:7447"),
        ("tcp/[::1]", "'tcp/[::1]' has no port: write tcp/[::1]:7447"),
        ("tcp/a:0", "'tcp/a:0' has no port from 1 to 65535"),
        ("tcp/a:65536", "'tcp/a:65536' has no port from 1 to 65535"),
        ("tcp/a:x", "'tcp/a:x' has no port from 1 to 65535"),
        ("tcp/a:٣", "'tcp/a:٣' has no port from 1 to 65535"),
        ("tcp/::1:7447", "'tcp/::1:7447' needs brackets around an IPv6 address: tcp/[::1]:7447"),
        ("tcp/[1.2.3.4]:1", "'tcp/[1.2.3.4]:1' has no valid address: 1.2.3.4"),
        ("tcp/1.2.3:1", "'tcp/1.2.3:1' has no valid address: 1.2.3"),
        ("tcp/0.0.0.0:1", "'tcp/0.0.0.0:1' means every address of this machine, so it cannot be connected to"),
        ("tcp/[::]:1", "'tcp/[::]:1' means every address of this machine, so it cannot be connected to"),
        ("tcp/-a:1", "'tcp/-a:1' has no valid host name: -a"),
        (f"tcp/{'a' * 64}:1", f"'tcp/{'a' * 64}:1' has no valid host name: {'a' * 64}"),
        ("tcp/:1", "'tcp/:1' has no valid host name: it is empty"),
        ("tcp/a\nb:1", "'tcp/a\\nb:1' has no valid host name"),
    ],
)
def test_what_is_wrong_with_an_endpoint_is_said(endpoint: str, error: str) -> None:
    with pytest.raises(ValueError) as raised:
        address_of(endpoint, listening=False)
    assert str(raised.value) == error


@pytest.mark.parametrize(
    ("secret", "error"),
    [
        ("1234567", "the secret has 7 characters, at least 8 are needed"),
        ("x" * 257, "the secret has more than 256 characters"),
        ("with:colon", "the secret must be one word without a colon"),
        ("two words", "the secret must be one word without a colon"),
        ("tab\tulator", "the secret must be one word without a colon"),
    ],
)
def test_what_is_wrong_with_a_secret_is_said(secret: str, error: str) -> None:
    with pytest.raises(ValueError) as raised:
        secret_of(secret)
    assert str(raised.value) == error


@pytest.mark.parametrize("secret", ["12345678", "x" * 256, "chalk-und-Schwämme"])
def test_a_secret_is_a_word_or_stands_in_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, secret: str) -> None:
    assert secret_of(secret) == secret
    file = tmp_path / "secret"
    file.write_text(f"  {secret}\n", encoding="utf-8")
    file.chmod(0o600)
    monkeypatch.chdir(tmp_path)
    assert secret_of(str(file)) == secret == secret_of("secret")
    if sys.platform != "win32":
        for mode in (0o640, 0o604, 0o610, 0o601):
            file.chmod(mode)
            with pytest.raises(ValueError, match=f"other users can read .*; do: chmod 600 {file}"):
                secret_of(str(file))
