"""The socket over which a launch lets programs of ours run on the desk (`ros2 launch` in the desktop)."""

from __future__ import annotations

import contextlib
import json
import os
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.ros.ros2.launch import _host
from day6_core.ros.ros2.launch._host import ROOM, HostedOutput, LaunchHost
from day6_core.session.clock import WorldClock
from day6_core.session.streams import Captured, TextInput
from day6_core.session.task import Signal
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from tests.support.waiting import PATIENCE, until

pytestmark = pytest.mark.process


class Launch:
    """A `ros2 launch` on a desk, and the other end of its socket: what the launch process would send and hear."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(home, domain_id=0, join_link=False, clock=WorldClock())
        self.shell = self.desk.shell()
        self.ended = Signal()

        async def main(session):
            await session.wait(self.ended)

        streams = Streams(TextInput(""), Captured(), Captured())
        env = self.shell.environment
        self.command = self.desk.start_program(["ros2"], main, streams, env=env, cwd=home, shell=self.shell)
        self.host = LaunchHost(self.command.session, self.command.session.host)
        self.end = None
        self.heard = []
        self._rest = b""

    def connect(self) -> None:
        kind, _, rest = self.host.address.partition(":")
        if kind == "unix":
            self.end = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            self.end.connect(rest)
        else:
            port, _, secret = rest.partition(":")
            self.end = socket.create_connection(("127.0.0.1", int(port)))
            self.end.sendall(f"{secret}\n".encode())
        self.end.setblocking(False)

    def send(self, **message) -> None:
        self.end.sendall(json.dumps(message).encode() + b"\n")

    def start(self, number, kind, *argv) -> None:
        env = dict(self.shell.environment)
        self.send(do="start", id=number, kind=kind, argv=list(argv), cwd=str(self.desk.home), env=env)

    def _receive(self) -> None:
        try:
            data = self.end.recv(1_000_000)
        except BlockingIOError:
            return
        *lines, self._rest = (self._rest + data).split(b"\n")
        self.heard.extend(map(json.loads, lines))

    def wait(self, condition) -> None:
        def done():
            if self.end is not None and self.end.fileno() >= 0:
                self._receive()
            return condition()

        until(lambda: self.desk.scheduler.run(done, 0.01), every=0, told=lambda: f"heard so far: {self.heard}")

    def wait_for(self, kind, number=None):
        """Let programs run until this message has come; returns it."""
        found = []

        def there():
            found[:] = [each for each in self.heard if each["is"] == kind and each.get("id") == number]
            return bool(found)

        self.wait(there)
        return found[0]

    def output(self, number, fd):
        return "".join(
            each["text"] for each in self.heard if each["is"] == "output" and (each["id"], each["fd"]) == (number, fd)
        )

    def running(self):
        return [program.session.name for program in self.desk.programs.values() if program is not self.command]


@pytest.fixture
def launch(tmp_path: Path) -> Iterator[Launch]:
    made = Launch(tmp_path / "home")
    made.connect()
    yield made
    made.end.close()
    made.host.close()
    made.desk.close()


def test_a_shell_line_runs_and_tells_its_output_and_its_end(launch):
    launch.start(1, "line", "echo out; echo err >&2; exit 3")
    assert launch.wait_for("ended", 1) == {"is": "ended", "id": 1, "code": 3}
    assert next(each["is"] for each in launch.heard) == "started"
    assert (launch.output(1, 1), launch.output(1, 2)) == ("out\n", "err\n")
    assert launch.running() == []


def test_started_tells_the_pid_by_which_the_desk_knows_it(launch):
    launch.start(7, "line", "sleep 100")
    pid = launch.wait_for("started", 7)["pid"]
    (program,) = (each for each in launch.desk.programs.values() if each.pid == pid)
    assert program.session.background and program.session.name == "bash"


def test_programs_and_commands_of_ours_are_found_by_their_paths(launch):
    launch.start(1, "program", "/opt/ros/jazzy/lib/demo_nodes_py/talker", "--ros-args", "-r", "__node:=me")
    launch.start(2, "command", "/opt/ros/jazzy/bin/ros2", "pkg", "executables", "turtlesim")
    launch.wait_for("ended", 2)
    assert launch.output(2, 1).startswith("turtlesim draw_square\n")
    launch.wait(lambda: "[me]: Publishing" in launch.output(1, 2))


@pytest.mark.parametrize(
    ("kind", "words", "reason"),
    [
        ("command", ["/bin/no_such_thing"], "LookupError: /bin/no_such_thing: command not found"),
        ("program", ["/x/no_such/thing"], None),
    ],
)
def test_what_does_not_exist_has_failed(launch, kind, words, reason):
    launch.start(5, kind, *words)
    failed = launch.wait_for("failed", 5)
    assert reason is None or failed["reason"] == reason
    assert launch.running() == []
    launch.start(6, "line", "true")
    launch.wait_for("ended", 6)


@pytest.mark.parametrize(("number", "code"), [(2, 0), (15, 0), (9, -9)])
def test_signals_end_a_program_and_ctrl_c_is_a_good_end(launch, number, code):
    launch.start(1, "program", "/opt/ros/jazzy/lib/demo_nodes_py/talker")
    launch.wait(lambda: "Publishing" in launch.output(1, 2))
    launch.send(do="signal", id=99, number=9)  # nobody
    launch.send(do="signal", id=1, number=number)
    assert launch.wait_for("ended", 1)["code"] == code


def test_ctrl_c_of_the_command_is_told_and_goes_on_to_it(launch):
    assert launch.command.session.on_interrupt() is False
    assert launch.wait_for("interrupted") == {"is": "interrupted"}


def test_the_end_of_the_connection_ends_all_programs(launch):
    launch.start(1, "line", "sleep 100")
    launch.start(2, "line", "sleep 100")
    launch.wait_for("started", 2)
    launch.end.close()
    launch.wait(lambda: not launch.running())


def test_the_end_of_the_command_ends_all_programs_and_the_connection(launch):
    launch.start(1, "line", "sleep 100")
    launch.wait_for("started", 1)
    kind, _, path = launch.host.address.partition(":")
    launch.host.close()
    launch.wait(lambda: not launch.running())
    assert launch.command.session.on_interrupt is None
    if kind == "unix":
        assert not Path(path).parent.exists()
    launch.end.setblocking(True)
    launch.end.settimeout(PATIENCE)
    while launch.end.recv(1000):
        pass


def test_a_host_may_be_closed_before_anybody_came(tmp_path):
    launch = Launch(tmp_path / "home")
    launch.host.close()
    launch.desk.close()
    assert launch.end is None


@pytest.mark.skipif(os.name != "posix", reason="there are no sockets in folders")
def test_only_this_user_can_reach_the_socket(launch):
    assert launch.host.address.startswith("unix:")
    path = Path(launch.host.address.partition(":")[2])
    assert path.parent.stat().st_mode & 0o777 == 0o700
    assert len(str(path)) < 104 or len(str(path.parent.parent)) > 60


@pytest.fixture
def over_tcp(tmp_path, monkeypatch):
    """A launch where there are no Unix sockets."""
    monkeypatch.delattr(socket, "AF_UNIX")
    made = Launch(tmp_path / "home")
    yield made
    made.host.close()
    made.desk.close()


def test_without_unix_sockets_it_is_a_port_of_this_machine_and_a_secret(over_tcp):
    kind, port, secret = over_tcp.host.address.split(":")
    assert kind == "tcp" and int(port) > 0 and len(secret) == 32
    over_tcp.connect()
    over_tcp.start(1, "line", "echo hi")
    over_tcp.wait_for("ended", 1)
    assert over_tcp.output(1, 1) == "hi\n"
    over_tcp.end.close()


def test_who_does_not_know_the_secret_is_not_obeyed(over_tcp):
    _, port, secret = over_tcp.host.address.split(":")
    with socket.create_connection(("127.0.0.1", int(port))) as stranger:
        stranger.settimeout(PATIENCE)
        stranger.sendall(secret[:-1].encode() + b"\n")
        stranger.sendall(b'{"do": "start", "id": 1, "kind": "line", "argv": ["true"], "cwd": "/", "env": {}}\n')
        with contextlib.suppress(ConnectionResetError):
            assert stranger.recv(100) == b"", "the connection is closed"
    assert over_tcp.running() == []


def test_two_hosts_do_not_share_a_secret(over_tcp):
    other = LaunchHost(over_tcp.command.session, over_tcp.command.session.host)
    assert other.address.rpartition(":")[2] != over_tcp.host.address.rpartition(":")[2]
    other.close()


# -- what nobody takes -------------------------------------------------------------------------------------------------


class Taker:
    """Takes texts while it has room."""

    def __init__(self):
        self.texts = []
        self.full = False

    def __call__(self, text):
        if not self.full:
            self.texts.append(text)
        return not self.full


def test_lines_that_find_no_room_are_counted_and_told():
    taker = Taker()
    output = HostedOutput(taker)
    assert output.write("a\n") == 2
    taker.full = True
    assert output.write("b\nc\n") == 4
    output.write("")
    output.write("d\n")
    taker.full = False
    output.write("e\n")
    output.write("f\n")
    assert taker.texts == ["a\n", "… 3 lines dropped\n", "e\n", "f\n"]


def test_at_the_end_what_is_missing_is_told():
    taker = Taker()
    output = HostedOutput(taker)
    output.report_dropped()
    taker.full = True
    output.write("a\n")
    output.report_dropped()
    taker.full = False
    output.report_dropped()
    output.report_dropped()
    assert taker.texts == ["… 1 lines dropped\n"]


def test_output_waits_for_a_launch_that_does_not_read_up_to_the_room(tmp_path, monkeypatch):
    launch = Launch(tmp_path / "home")  # nobody connects, so nothing is taken
    line = "x" * 1000
    message = len(json.dumps({"is": "output", "id": 1, "fd": 1, "text": line})) + 1
    taken = 0
    while launch.host._send_output(1, 1, line):
        taken += 1
        assert taken <= ROOM // message
    assert taken == ROOM // message
    launch.connect()
    launch.wait(lambda: len(launch.heard) == taken)
    assert launch.host._send_output(1, 1, line)
    launch.wait(lambda: len(launch.heard) == taken + 1)
    launch.end.close()
    launch.host.close()
    assert launch.host._send_output(1, 1, line), "after the end nothing is counted as dropped"
    launch.desk.close()


def test_the_address_is_told_by_the_variable_that_the_launch_reads():
    from launch import _host as other_end

    assert _host.VARIABLE == other_end.VARIABLE
