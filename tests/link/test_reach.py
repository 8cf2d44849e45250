"""Who may meet whom: the folder of the sockets, what listens, and other machines by name only."""

from __future__ import annotations

import json
import os
import socket
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from tests.link.link_harness import World
from tests.support.free_port import free_port
from tests.support.waiting import until


@pytest.mark.process
def test_the_folder_is_private(world: World) -> None:
    world.here()
    if sys.platform != "win32":
        for folder in (world.runtime, world.runtime / "0"):
            assert stat.S_IMODE(folder.stat().st_mode) == 0o700


@pytest.mark.process
def test_nothing_listens_on_the_network(world: World) -> None:
    if not Path("/proc/net/tcp").exists():
        pytest.skip("no /proc")

    def listening() -> set[str]:
        found = set()
        for name in ("tcp", "tcp6", "udp", "udp6"):
            for line in Path("/proc/self/net", name).read_text(encoding="utf-8").splitlines()[1:]:
                found.add(line.split()[9])
        own = set()
        for descriptor in os.listdir("/proc/self/fd"):
            try:
                target = os.readlink(f"/proc/self/fd/{descriptor}")
            except OSError:
                continue
            if target.startswith("socket:["):
                own.add(target[8:-1])
        return found & own

    before = listening()
    world.here()
    other = world.process()
    other.node("other")
    assert listening() <= before  # a socket of an earlier test may be gone meanwhile


@pytest.mark.process
@pytest.mark.parametrize("secret", [None, "wrong"])
def test_where_sockets_are_tcp_a_password_is_asked(
    world: World, monkeypatch: pytest.MonkeyPatch, secret: str | None
) -> None:
    import zenoh

    from day6_core.link.config import command_config
    from day6_core.link.paths import meeting_place

    monkeypatch.setenv("DAY6_LINK", "tcp")
    owner = world.here()
    owner.node("owner")
    place = meeting_place(0)
    zenoh.open(command_config(place, "abc1")).close()
    stranger = zenoh.Config()
    stranger.insert_json5("mode", '"client"')
    stranger.insert_json5("scouting/multicast/enabled", "false")
    stranger.insert_json5("connect/endpoints", f'["{place.meeting_endpoint}"]')
    if secret is not None:
        stranger.insert_json5("transport/auth/usrpwd/user", '"day6"')
        stranger.insert_json5("transport/auth/usrpwd/password", f'"{secret}"')
    with pytest.raises(zenoh.ZError):
        zenoh.open(stranger)
    if sys.platform != "win32":
        for name in ("secret", "users"):
            assert stat.S_IMODE((place.folder / name).stat().st_mode) == 0o600


@contextmanager
def counting_door(port: int, behind: int) -> Iterator[list[int]]:
    """Let callers of one port through to another one; yields how many bytes each call that has ended brought back."""
    ended: list[int] = []

    def pass_on(source: socket.socket, target: socket.socket) -> int:
        count = 0
        with suppress(OSError):
            while data := source.recv(65536):
                target.sendall(data)
                count += len(data)
        for each in (source, target):
            with suppress(OSError):
                each.shutdown(socket.SHUT_RDWR)
        return count

    def serve(caller: socket.socket) -> None:
        with caller, socket.create_connection(("127.0.0.1", behind)) as inside:
            Thread(target=pass_on, args=(caller, inside), daemon=True).start()
            ended.append(pass_on(inside, caller))

    def accept() -> None:
        with suppress(OSError):
            while True:
                Thread(target=serve, args=(door.accept()[0],), daemon=True).start()

    with socket.create_server(("127.0.0.1", port)) as door:
        Thread(target=accept, daemon=True).start()
        yield ended
        with suppress(OSError):
            door.shutdown(socket.SHUT_RDWR)


@pytest.mark.process
@pytest.mark.parametrize("asks", [False, True])
def test_who_takes_the_port_of_a_keeper_that_died_is_not_joined_without_the_password(
    world: World, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, asks: bool
) -> None:
    import zenoh

    from day6_core.link.config import process_config
    from day6_core.link.paths import meeting_place

    monkeypatch.setenv("DAY6_LINK", "tcp")
    place = meeting_place(0)
    behind = free_port()
    settings = {
        "mode": '"router"',
        "scouting/multicast/enabled": "false",
        "listen/endpoints": f'["tcp/127.0.0.1:{behind}"]',
    }
    if asks:
        (tmp_path / "users").write_text("day6:guessed-word\n", encoding="utf-8")
        settings["transport/auth/usrpwd/user"] = '"day6"'
        settings["transport/auth/usrpwd/password"] = '"guessed-word"'
        settings["transport/auth/usrpwd/dictionary_file"] = json.dumps(str(tmp_path / "users"))
    thief = zenoh.Config()
    for name, value in settings.items():
        thief.insert_json5(name, value)
    with (
        zenoh.open(thief) as theirs,
        counting_door(place.meeting_port, behind) as ended,
        zenoh.open(process_config(place, "abcd1234abcd1234")) as ours,
    ):
        # Who calls again has not come in.
        until(lambda: len(ended) >= 3 or ours.info.links() or theirs.info.links())
        assert all(ended) and not ours.info.links() and not theirs.info.links()


def test_a_folder_that_cannot_be_used_leaves_the_program_alone(
    world: World, short_folder: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    from day6_core.graph import Graph
    from day6_core.link import join, leave

    blocked = short_folder / "file"
    blocked.touch()
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(blocked))
    graph = Graph()
    link = join(graph)
    assert link.problem is not None and "file" in link.problem
    assert "other processes cannot be seen" in caplog.text
    graph.create_node("alone")
    assert link.wait_settled(0.1)
    leave(graph)


@pytest.mark.skipif(sys.platform == "win32", reason="links need a right there")
def test_a_symbolic_link_in_place_of_the_folder_is_refused(
    world: World, short_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from day6_core.link.paths import LinkError, meeting_place

    (short_folder / "elsewhere").mkdir()
    (short_folder / "trap").symlink_to(short_folder / "elsewhere")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "trap"))
    with pytest.raises(LinkError, match="not a folder"):
        meeting_place(0)


@pytest.mark.process
def test_a_folder_with_a_long_name_still_makes_a_meeting_place(
    world: World, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path / ("long" * 30)))
    one, other = world.here(), world.here()
    one.node("one")
    assert until(lambda: other.nodes() == ["/one"])


@pytest.mark.process
@pytest.mark.parametrize("links", [("unix", "unix"), ("tcp", "unix"), ("unix", "tcp"), ("tcp", "tcp")])
def test_two_machines_meet_only_by_name(world: World, short_folder: Path, links: tuple[str, str]) -> None:
    """With `tcp` a machine is one without Unix sockets, as under Windows."""
    port = free_port()
    here, there = str(short_folder / "m1"), str(short_folder / "m2")
    listen = json.dumps({"listen": f"tcp/127.0.0.1:{port}"})
    connect = json.dumps({"connect": [f"tcp/127.0.0.1:{port}"]})
    kind_here, kind_there = links
    teacher = world.process(DAY6_RUNTIME_DIR=here, DAY6_LINK=kind_here, TEST_ADDRESSES=listen)
    beside = world.process(DAY6_RUNTIME_DIR=here, DAY6_LINK=kind_here)
    stranger = world.process(DAY6_RUNTIME_DIR=str(short_folder / "m3"), DAY6_LINK=kind_there)
    stranger.node("stranger")
    student = world.process(DAY6_RUNTIME_DIR=there, DAY6_LINK=kind_there, TEST_ADDRESSES=connect)
    students_program = world.process(DAY6_RUNTIME_DIR=there, DAY6_LINK=kind_there)
    everyone: list[Any] = [teacher, beside, student, students_program]
    for name, peer in zip(("teacher", "beside", "student", "program"), everyone, strict=True):
        peer.node(name)
    names = ["/beside", "/program", "/student", "/teacher"]
    assert until(lambda: all(peer.nodes() == names for peer in everyone))
    assert stranger.nodes() == ["/stranger"]
    publisher = students_program.publisher(students_program.node("talker"), "/chatter")
    subscription = beside.subscription(beside.node("listener"), "/chatter")
    assert until(lambda: students_program.matched(publisher) == 1 and beside.matched(subscription) == 1)
    students_program.publish_numbers(publisher, 0, 5)
    assert until(lambda: beside.length(subscription) >= 5)
    assert beside.messages(subscription) == ["0", "1", "2", "3", "4"]
    beside.service(beside.node("server"), "/add")
    client = students_program.client(students_program.node("asker"), "/add")
    assert until(lambda: students_program.matched(client))
    number = students_program.call(client, 1, 2)
    assert until(lambda: students_program.responses(client)) == [[number, 3]]


@pytest.mark.usefixtures("hour_of_lease")
@pytest.mark.process
def test_what_is_kept_and_who_has_died_is_known_across_two_machines_without_unix_sockets(
    world: World, short_folder: Path
) -> None:
    port = free_port()
    machines = [{"DAY6_RUNTIME_DIR": str(short_folder / name), "DAY6_LINK": "tcp"} for name in ("m1", "m2")]
    gates = [{"listen": f"tcp/127.0.0.1:{port}"}, {"connect": [f"tcp/127.0.0.1:{port}"]}]
    teacher, student = (
        world.process(**machine, TEST_ADDRESSES=json.dumps(gate)) for machine, gate in zip(machines, gates, strict=True)
    )
    far, near = world.process(**machines[0]), world.process(**machines[1])
    publisher = far.publisher(far.node("describer"), "/robot_description", latched=True)
    far.publish(publisher, data="<robot/>")
    late = near.subscription(near.node("rviz"), "/robot_description", latched=True)
    assert until(lambda: near.messages(late) == ["<robot/>"])
    assert until(lambda: student.nodes() == teacher.nodes() == ["/describer", "/rviz"])
    far.kill()
    assert until(lambda: near.nodes() == ["/rviz"])


@pytest.mark.process
@pytest.mark.parametrize(
    ("name", "value", "meet"),
    [
        ("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF", False),
        ("ROS_AUTOMATIC_DISCOVERY_RANGE", "off", True),  # rcl: assuming localhost only
        ("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST", True),
        ("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET", True),
        ("ROS_LOCALHOST_ONLY", "1", True),
    ],
)
def test_processes_of_one_machine_meet_unless_discovery_is_off(world: World, name: str, value: str, meet: bool) -> None:
    here, other = world.here(), world.process(**{name: value})
    here.node("here")
    other.node("other")
    third = world.process()
    third.node("third")
    expected = ["/here", "/other", "/third"] if meet else ["/here", "/third"]
    assert until(lambda: here.nodes() == expected and third.nodes() == expected)
    assert until(lambda: other.nodes() == (expected if meet else ["/other"]))
