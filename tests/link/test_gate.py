"""The doors to other machines: what is wrong with one is told, and never touches what this machine's own programs have."""

from __future__ import annotations

import json
import os
import socket
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from day6_core.link import state_of
from day6_core.link.addresses import address_of
from day6_core.link.secret import secret_of
from day6_core.link.state import Door, DoorState
from tests.link.link_harness import World
from tests.support.waiting import until

SECRET, OTHER_SECRET = "chalk-and-sponge", "sponge-and-chalk"


@pytest.fixture
def taken() -> Iterator[socket.socket]:
    """A port that another program has."""
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        yield other


def door(peer: Any) -> Door:
    """The only door of a participant in this process, or of one that tells its own."""
    (only,) = state_of(peer.graph).doors
    return only


def comes_to(peer: Any, *states: DoorState) -> bool:
    return bool(until(lambda: door(peer).state in states))


@pytest.mark.process
def test_a_taken_port_is_told_and_the_local_graph_goes_on(world: World, taken: socket.socket) -> None:
    port = taken.getsockname()[1]
    here = world.here(listen=f"tcp/127.0.0.1:{port}")
    beside = world.process()
    beside.node("pupil")
    here.node("desk")
    assert until(lambda: here.nodes() == beside.nodes() == ["/desk", "/pupil"])
    assert comes_to(here, DoorState.IN_USE)
    taken.close()
    assert comes_to(here, DoorState.OPEN)
    assert here.nodes() == beside.nodes() == ["/desk", "/pupil"]


@pytest.mark.process
@pytest.mark.parametrize(
    ("listen", "state"),
    [
        ("tcp/no-such-host.invalid:7447", DoorState.NO_NAME),
        ("tcp/192.0.2.1:7447", DoorState.FAILED),
    ],
)
def test_an_address_that_is_not_this_machines_is_told(world: World, listen: str, state: DoorState) -> None:
    here, beside = world.here(listen=listen), world.process()
    beside.node("pupil")
    assert until(lambda: here.nodes() == ["/pupil"])
    assert comes_to(here, state)
    assert (door(here).reason != "") == (state == DoorState.FAILED)


@pytest.mark.process
def test_a_machine_that_nobody_answers_on_is_told_until_somebody_does(
    world: World, port: int, short_folder: Path
) -> None:
    here, beside = world.here(connect=f"tcp/127.0.0.1:{port}"), world.process()
    beside.node("pupil")
    assert until(lambda: here.nodes() == ["/pupil"])
    assert comes_to(here, DoorState.NOBODY)
    teacher = world.process(
        DAY6_RUNTIME_DIR=str(short_folder / "m2"), TEST_ADDRESSES=json.dumps({"listen": f"tcp/127.0.0.1:{port}"})
    )
    teacher.node("teacher")
    assert comes_to(here, DoorState.OPEN)
    assert until(lambda: here.nodes() == ["/pupil", "/teacher"])
    teacher.kill()
    assert comes_to(here, DoorState.NOBODY)
    assert until(lambda: here.nodes() == ["/pupil"])


@pytest.mark.process
def test_a_name_that_nobody_knows_is_told(world: World) -> None:
    here = world.here(connect="tcp/no-such-host.invalid:7447")
    assert comes_to(here, DoorState.NO_NAME)


@pytest.mark.process
def test_other_processes_of_the_user_read_how_it_stands_with_the_doors(world: World, port: int) -> None:
    here, beside = world.here(listen=f"tcp/127.0.0.1:{port}"), world.here()
    assert until(lambda: state_of(beside.graph).doors)  # written when the first attempt is over
    assert comes_to(beside, DoorState.OPEN)
    assert door(beside) == door(here)
    here.leave()
    assert until(lambda: state_of(beside.graph).doors == ())


def pupil(world: World, folder: Path, port: int, secret: str | None) -> Any:
    addresses = {"connect": f"tcp/127.0.0.1:{port}", "secret": secret}
    return world.process(DAY6_RUNTIME_DIR=str(folder), TEST_ADDRESSES=json.dumps(addresses))


@pytest.mark.process
def test_who_knows_the_secret_is_let_in(world: World, port: int, short_folder: Path) -> None:
    teacher = world.here(listen=f"tcp/127.0.0.1:{port}", secret=SECRET)
    teacher.node("teacher")
    student = pupil(world, short_folder / "m2", port, SECRET)
    student.node("student")
    assert until(lambda: teacher.nodes() == student.nodes() == ["/student", "/teacher"])
    assert until(lambda: door(teacher).joined == 1)
    assert door(teacher).secret
    publisher = student.publisher(student.node("talker"), "/chatter")
    subscription = teacher.subscription(teacher.node("listener"), "/chatter")
    assert until(lambda: student.matched(publisher) == 1 and teacher.matched(subscription) == 1)
    assert until(lambda: student.publish(publisher, data="hello") or teacher.messages(subscription))


@pytest.mark.process
@pytest.mark.parametrize(("theirs", "ours"), [(SECRET, OTHER_SECRET), (SECRET, None), (None, SECRET)])
def test_who_does_not_is_kept_out_and_told(
    world: World, port: int, short_folder: Path, theirs: str | None, ours: str | None
) -> None:
    addresses = {"listen": f"tcp/127.0.0.1:{port}", "secret": theirs}
    teacher = world.process(DAY6_RUNTIME_DIR=str(short_folder / "m2"), TEST_ADDRESSES=json.dumps(addresses))
    teacher.node("teacher")
    student = world.here(connect=f"tcp/127.0.0.1:{port}", secret=ours)
    student.node("student")
    assert comes_to(student, DoorState.NOT_LET_IN)
    assert student.nodes() == ["/student"] and teacher.nodes() == ["/teacher"]


@pytest.mark.process
def test_no_password_is_left_in_a_file(world: World, port: int) -> None:
    here = world.here(listen=f"tcp/127.0.0.1:{port}", secret=SECRET)
    assert comes_to(here, DoorState.OPEN)
    for path in world.runtime.rglob("*"):
        with suppress(FileNotFoundError):  # that of the doors is being replaced
            if path.is_file():
                assert SECRET.encode() not in path.read_bytes(), path


@pytest.mark.parametrize(
    "endpoint",
    [
        "tcp/0.0.0.0:7447",
        "tcp/[::]:7447",
        "udp/127.0.0.1:1",
        "ws/teacher.local:65535",
        "tcp/teacher-1:7447",
    ],
)
def test_endpoints_one_can_listen_on(endpoint: str) -> None:
    assert address_of(endpoint, listening=True).port in (7447, 1, 65535)


@pytest.mark.parametrize(
    ("endpoint", "words"),
    [
        ("nonsense", "'nonsense' is not an endpoint like tcp/192.168.1.5:7447"),
        ("", "'' is not an endpoint like"),
        ("tcp/", "'tcp/' is not an endpoint like"),
        ("foo/1.2.3.4:5", "has an unknown protocol: use tcp, udp or ws"),
        ("tls/1.2.3.4:5", "has an unknown protocol"),
        ("tcp/1.2.3.4", "has no port: write tcp/1.2.3.4:7447"),
        ("tcp/[::1]", "has no port: write tcp/[::1]:7447"),
        ("tcp/1.2.3.4:", "has no port from 1 to 65535"),
        ("tcp/1.2.3.4:0", "has no port from 1 to 65535"),
        ("tcp/1.2.3.4:99999", "has no port from 1 to 65535"),
        ("tcp/1.2.3.4:-1", "has no port from 1 to 65535"),
        ("tcp/1.2.3.4:７", "has no port from 1 to 65535"),
        ("tcp/1.2.3.4:7447,tcp/1.2.3.5:7448", "has no valid host name"),
        ("tcp/300.1.1.1:7447", "has no valid address: 300.1.1.1"),
        ("tcp/[::zz]:7447", "has no valid address: ::zz"),
        ("tcp/::1:7447", "needs brackets around an IPv6 address"),
        ("tcp/:7447", "has no valid host name: it is empty"),
        ("tcp/a b:7447", "has no valid host name"),
        ("tcp/\x1b]0;x\x07:7447", "has no valid host name"),
        ("tcp/0.0.0.0:7447", "means every address of this machine, so it cannot be connected to"),
        ("tcp/[::]:7447", "means every address of this machine, so it cannot be connected to"),
    ],
)
def test_endpoints_one_cannot_connect_to(endpoint: str, words: str) -> None:
    with pytest.raises(ValueError) as caught:
        address_of(endpoint, listening=False)
    assert words in str(caught.value)


def test_a_secret_comes_from_a_file_that_only_its_owner_can_read(tmp_path: Path) -> None:
    path = tmp_path / "secret"
    path.write_text(SECRET + "\n", encoding="utf-8")
    path.chmod(0o600)
    assert secret_of(str(path)) == SECRET == secret_of(SECRET)
    if sys.platform != "win32":
        for mode in (0o640, 0o604, 0o666):
            path.chmod(mode)
            with pytest.raises(ValueError, match=r"other users can read .*secret; do: chmod 600"):
                secret_of(str(path))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "the secret has 0 characters, at least 8 are needed"),
        ("short", "the secret has 5 characters"),
        ("x" * 300, "more than 256 characters"),
        ("two words", "must be one word without a colon"),
        ("day6:password", "must be one word without a colon"),
        ("\x1b[31mred-secret", "must be one word"),
        ("/no/such/file", "/no/such/file: No such file or directory"),
    ],
)
def test_a_secret_that_is_none_is_refused(text: str, words: str) -> None:
    with pytest.raises(ValueError) as caught:
        secret_of(text)
    assert words in str(caught.value)


@pytest.mark.skipif(sys.platform == "win32", reason="has no FIFOs")
def test_a_fifo_in_place_of_the_secret_does_not_stop_the_start(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "fifo", 0o600)
    with pytest.raises(ValueError, match="is not a file"):
        secret_of(str(tmp_path / "fifo"))
