"""tf2_echo, tf2_monitor, static_transform_publisher and view_frames, with their texts."""

from __future__ import annotations

import importlib
import math
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster, TransformListener

from day6_core.graph import Graph
from day6_core.link.paths import process_exists
from day6_core.ros.program_index import executables
from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured
from rclpy.time import Time
from tests.support.pdf_text import pdf_text
from tests.support.waiting import until
from tests.tf2.conftest import stamped

EPOCH = 1_700_000_000


class Running:
    def __init__(self, machine: Machine, program: Program, stdout: Captured, stderr: Captured) -> None:
        self._machine = machine
        self.program = program
        self._stdout, self._stderr = stdout, stderr

    @property
    def output(self) -> str:
        return self._stdout.text

    @property
    def errors(self) -> str:
        """What it wrote to stderr, without the time stamps of its log."""
        return re.sub(r" \[17\d+\.\d{9}\]", "", self._stderr.text)

    def interrupt(self) -> int | None:
        self.program.session.interrupt()
        self._machine.advance()
        return self.program.status


class Machine:
    """A machine whose time the test moves on, with a node of its own."""

    def __init__(self, folder: Path) -> None:
        self.scheduler = Scheduler(WorldClock(wall=None, epoch_ns=EPOCH * 1_000_000_000))
        self.graph = Graph()
        self.folder = folder
        session = Session(self.scheduler, self.graph, ["watcher"])
        self.node = session.create_node("watcher")
        self.buffer = Buffer()
        TransformListener(self.buffer, self.node)
        self.programs = [Program(session, lambda session: session.spin(self.node))]
        self.moving = TransformBroadcaster(self.node)
        self.fixed = StaticTransformBroadcaster(self.node)

    def start(self, executable: str, *args: str, package: str = "tf2_ros") -> Running:
        stdout, stderr = Captured(), Captured()
        argv = [executable, *args]
        env = {"PATH": str(self.folder)}
        session = Session(self.scheduler, self.graph, argv, stdout=stdout, stderr=stderr, cwd=self.folder, env=env)
        main = importlib.import_module(f"day6_core.ros.programs.{package}.{executable}").main
        program = Program(session, main)
        self.programs.append(program)
        self.advance()
        return Running(self, program, stdout, stderr)

    def advance(self, seconds: float = 0.0) -> None:
        self.scheduler.advance(seconds)

    def nodes(self) -> set[str]:
        return set(self.node.get_node_names())


def _words(line: str) -> list[str]:
    return line.split()


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    machine = Machine(tmp_path)
    yield machine
    for program in machine.programs:
        program.kill()
    machine.advance()


def test_the_executables_are_found() -> None:
    assert executables("tf2_ros") == ["static_transform_publisher", "tf2_echo", "tf2_monitor"]
    assert executables("tf2_tools") == ["view_frames"]


# -- tf2_echo ----------------------------------------------------------------------------------------------------------


def test_echo_waits_then_prints_once_a_second(machine: Machine) -> None:
    echo = machine.start("tf2_echo", "world", "car")
    waiting = (
        "[INFO] [tf2_echo]: Waiting for transform world ->  car: "
        'Invalid frame ID "world" passed to canTransform argument target_frame - frame does not exist\n'
    )
    assert echo.errors == waiting
    machine.advance(1.0)
    assert echo.errors == 2 * waiting
    half = math.sqrt(0.5)
    machine.moving.sendTransform(stamped("world", "car", EPOCH + 0.000000005, (1.5, -2, 0), (0, 0, half, half)))
    machine.moving.sendTransform(stamped("world", "car", 12.5, (1.5, -2, 0), (0, 0, half, half)))
    machine.advance(2.0)
    once = (
        "At time 1700000000.0\n"
        "- Translation: [1.500, -2.000, 0.000]\n"
        "- Rotation: in Quaternion [0.000, 0.000, 0.707, 0.707]\n"
        "- Rotation: in RPY (radian) [0.000, -0.000, 1.571]\n"
        "- Rotation: in RPY (degree) [0.000, -0.000, 90.000]\n"
        "- Matrix:\n"
        "  0.000 -1.000  0.000  1.500\n"
        "  1.000  0.000  0.000 -2.000\n"
        "  0.000  0.000  1.000  0.000\n"
        "  0.000  0.000  0.000  1.000\n"
    )
    assert echo.output == 2 * once
    assert echo.interrupt() == 0
    assert echo.errors.endswith("[INFO] [rclcpp]: signal_handler(SIGINT/SIGTERM)\n")


def test_echo_has_a_node_and_its_listener_another(machine: Machine) -> None:
    echo = machine.start("tf2_echo", "world", "car", "--ros-args", "-r", "__node:=my_echo")
    (listener,) = machine.nodes() - {"watcher", "my_echo"}
    assert re.fullmatch(r"transform_listener_impl_[0-9a-f]{12}", listener)
    assert machine.node.get_subscriber_names_and_types_by_node(listener, "/")[1:] == [
        ("/tf", ["tf2_msgs/msg/TFMessage"]),
        ("/tf_static", ["tf2_msgs/msg/TFMessage"]),
    ]
    echo.interrupt()
    assert machine.nodes() == {"watcher"}


def test_echo_follows_its_rate(machine: Machine) -> None:
    machine.fixed.sendTransform(stamped("world", "car"))
    echo = machine.start("tf2_echo", "world", "car", "4")
    machine.advance(2.1)
    assert echo.output.count("At time 0.0\n") in (8, 9)


def test_echo_says_what_went_wrong_and_goes_on(machine: Machine) -> None:
    echo = machine.start("tf2_echo", "world", "car")
    machine.moving.sendTransform(stamped("world", "car", 1))
    machine.advance(1.0)
    machine.moving.sendTransform(stamped("moon", "car", 2))
    machine.advance(1.0)
    assert echo.output.endswith(
        "\nFailure at 1700000002.000\nException thrown:Could not find a connection between 'world' and 'car' because they"
        " are not part of the same tree.Tf has two or more unconnected trees.\n"
        "The current list of frames is:\nFrame car exists with parent moon.\n\n"
    )
    assert echo.program.status is None


@pytest.mark.parametrize(
    ("args", "status", "output", "errors"),
    [
        ((), 1, "Usage: tf2_echo source_frame target_frame [echo_rate]\n\nThis will", ""),
        (("a",), 1, "Usage: tf2_echo", ""),
        (("a", "b", "foo"), 2, "", "Failed to convert rate argument 'foo' to a floating-point number\n"),
        (("a", "b", "1.0foo"), 3, "", "Failed to convert rate argument '1.0foo' to a floating-point number\n"),
    ],
)
def test_echo_wants_two_frames_and_perhaps_a_rate(
    machine: Machine, args: tuple[str, ...], status: int, output: str, errors: str
) -> None:
    echo = machine.start("tf2_echo", *args)
    assert (echo.program.status, echo.errors) == (status, errors)
    assert echo.output.startswith(output)


# -- tf2_monitor -------------------------------------------------------------------------------------------------------


def test_monitor_reports_every_ten_and_a_half_seconds(machine: Machine) -> None:
    monitor = machine.start("tf2_monitor")
    assert monitor.output == "Gathering data on all frames for 10 seconds...\n"
    for tick in range(110):
        machine.moving.sendTransform(stamped("world", "car", EPOCH + tick * 0.1 - 0.25))
        machine.advance(0.1)
    assert monitor.output.split("...\n", 1)[1] == (
        "\n\n\nRESULTS: for all Frames\n\nFrames:\n"
        "Frame: car, published by <no authority available>, Average Delay: 0.25, Max Delay: 0.25\n"
        "Node: <no authority available> 10.0962 Hz, Average Delay: 0.25 Max Delay: 0.25\n"
    )
    assert monitor.errors == "\nAll Broadcasters:\n"
    assert monitor.interrupt() == 0


def test_monitor_of_two_frames_names_the_chain(machine: Machine) -> None:
    monitor = machine.start("tf2_monitor", "wheel", "car")
    assert 'Waiting for transform wheel ->  car: Invalid frame ID "wheel"' in monitor.errors
    machine.fixed.sendTransform([stamped("world", "car"), stamped("car", "wheel")])
    machine.advance(0.5)
    assert monitor.output == "Gathering data on wheel -> car for 10 seconds...\n"
    machine.advance(10.5)
    assert "RESULTS: for wheel to car\nChain is: wheel -> car\nNet delay     avg = " in monitor.output


def test_monitor_wants_no_frame_or_two(machine: Machine) -> None:
    monitor = machine.start("tf2_monitor", "car")
    assert monitor.program.status == 255
    assert monitor.errors == "[INFO] [tf2_monitor_main]: TF_Monitor: usage: tf2_monitor framea frameb\n"


# -- static_transform_publisher ----------------------------------------------------------------------------------------


def test_a_static_transform_is_published_and_told(machine: Machine) -> None:
    publisher = machine.start(
        "static_transform_publisher",
        *_words("--x 1 --y -0.5 --yaw 1.5707963 --frame-id world --child-frame-id car"),
    )
    (name,) = machine.nodes() - {"watcher"}
    assert re.fullmatch(r"static_transform_publisher_[0-9A-Za-z]{16}", name)
    assert publisher.errors == (
        f"[INFO] [{name}]: Spinning until stopped - publishing transform\n"
        "translation: ('1.000000', '-0.500000', '0.000000')\n"
        "rotation: ('0.000000', '0.000000', '0.707107', '0.707107')\n"
        "from 'world' to 'car'\n"
    )
    found = machine.buffer.lookup_transform("world", "car", Time())
    assert (found.transform.translation.y, found.transform.rotation.w) == (-0.5, pytest.approx(math.sqrt(0.5)))
    (endpoint,) = [each for each in machine.node.get_publishers_info_by_topic("/tf_static") if each.node_name == name]
    assert endpoint.qos_profile.durability.name == "TRANSIENT_LOCAL"
    assert publisher.interrupt() == 0


@pytest.mark.parametrize(
    ("words", "rotation"),
    [
        ("1 2 3 0.5 0 0 a b", "('0.000000', '0.000000', '0.247404', '0.968912')"),
        ("1 2 3 0 0 0 1 a b", "('0.000000', '0.000000', '0.000000', '1.000000')"),
    ],
)
def test_the_old_style_still_works_with_a_warning(machine: Machine, words: str, rotation: str) -> None:
    publisher = machine.start("static_transform_publisher", *words.split())
    assert publisher.errors.startswith(
        "[WARN] []: Old-style arguments are deprecated; see --help for new-style arguments\n"
    )
    assert (
        f"translation: ('1.000000', '2.000000', '3.000000')\nrotation: {rotation}\nfrom 'a' to 'b'" in publisher.errors
    )


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ("", "Frame id must not be empty"),
        ("--frame-id a", "Child frame id must not be empty"),
        ("--x", "Not enough arguments for --x"),
        ("--x foo", "Failed to parse --x argument as float"),
        ("a b c", "Extra unparsed arguments on command-line"),
        ("--yaw 1 --qw 1 --frame-id a --child-frame-id b", "Cannot specify both quaternion and Euler rotations"),
        ("1 2 x 0 0 0 a b", "Failed to parse z argument as float"),
        ("--x 1 1 2 3 0 0 0 a b", "Cannot specify both new-style (flags) and old-style (arguments)"),
    ],
)
def test_a_wrong_command_line_is_explained(machine: Machine, words: str, text: str) -> None:
    publisher = machine.start("static_transform_publisher", *words.split())
    assert publisher.program.status == 1
    assert publisher.errors.endswith(f"[ERROR] []: error parsing command line arguments: {text}\n")
    assert publisher.output.startswith("usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] ")


def test_help_is_no_error(machine: Machine) -> None:
    publisher = machine.start("static_transform_publisher", "--help")
    assert (publisher.program.status, publisher.errors) == (0, "")
    assert publisher.output.endswith("  --yaw YAW             yaw component Euler rotation\n")


def test_a_frame_cannot_be_its_own_parent(machine: Machine) -> None:
    publisher = machine.start("static_transform_publisher", "--frame-id", "a", "--child-frame-id", "a")
    assert "cannot publish static transform from 'a' to 'a', exiting\n" in publisher.errors
    assert "terminate called after throwing an instance of 'std::runtime_error'\n" in publisher.errors
    assert "  what():  child_frame_id cannot equal frame_id\n" in publisher.errors
    assert publisher.program.status not in (0, None)


# -- view_frames -------------------------------------------------------------------------------------------------------


def view_frames(machine: Machine, *args: str) -> Running:
    """Run it to its end, with a frame or two."""
    machine.fixed.sendTransform(stamped("car", "wheel"))
    view = machine.start("view_frames", "-t", "0.5", "-o", "tree", *args, package="tf2_tools")
    machine.advance(0.5)
    until(lambda: view.program.status is not None, meanwhile=lambda: machine.advance(0.1))
    return view


def install_dot(folder: Path, script: str) -> None:
    """Put a `dot` onto the PATH of the machine's programs."""
    dot = folder / "dot"
    dot.write_text(f"#!/bin/sh\n{script}\n")
    dot.chmod(0o755)


def test_view_frames_writes_the_tree_of_five_seconds(machine: Machine) -> None:
    machine.fixed.sendTransform(stamped("car", "wheel"))
    view = machine.start("view_frames", package="tf2_tools")
    assert view.errors == "[INFO] [view_frames]: Listening to tf data for 5.0 seconds...\n"
    for tick in range(48):
        machine.moving.sendTransform(stamped("world", "car", 100 + tick * 0.1))
        machine.advance(0.1)
    until(lambda: view.program.status is not None, meanwhile=lambda: machine.advance(0.1))
    assert view.program.status == 0
    lines = view.errors.splitlines()
    assert lines[1] == "[INFO] [view_frames]: Generating graph..."
    assert lines[2].startswith("[INFO] [view_frames]: Result:tf2_msgs.srv.FrameGraph_Response(frame_yaml=")
    exported = re.fullmatch(
        r"\[INFO\] \[view_frames\]: Exporting graph in (frames_[0-9._-]+)\.pdf file\.\.\.", lines[3]
    )
    assert exported is not None and lines[4:] == []
    dot = (machine.folder / f"{exported[1]}.gv").read_text(encoding="utf-8")
    assert dot.startswith(
        'digraph G {\n"car" -> "wheel"[label=" Broadcaster: default_authority\\nAverage rate: 10000.0\\n'
    )
    assert (
        '"world" -> "car"[label=" Broadcaster: default_authority\\nAverage rate: 10.213\\nBuffer length: 4.7\\n' in dot
    )
    assert dot.endswith('[ shape=plaintext ] ;\n}->"world";\n}')
    text = pdf_text(machine.folder / f"{exported[1]}.pdf")
    assert "Averagerate:10.213Bufferlength:4.7" in text and "wheel" in text


def test_view_frames_without_frames(machine: Machine) -> None:
    view = machine.start("view_frames", "-t", "1", "-o", "tree", package="tf2_tools")
    machine.advance(1.0)
    until(lambda: view.program.status is not None, meanwhile=lambda: machine.advance(0.1))
    assert view.program.status == 0
    assert (machine.folder / "tree.gv").read_text(encoding="utf-8") == 'digraph G { "No tf data received" }'
    assert pdf_text(machine.folder / "tree.pdf") == "Notfdatareceived"


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="its graphviz is a program, no script")
def test_graphviz_draws_where_it_is_installed(machine: Machine) -> None:
    install_dot(machine.folder, 'read line < "$2"; echo "%PDF by $1 of $line"; echo "Warning: of dot" >&2')
    view = view_frames(machine)
    assert view.program.status == 0
    assert (machine.folder / "tree.pdf").read_text() == "%PDF by -Tpdf of digraph G {\n"
    assert view.errors.endswith("\nWarning: of dot\n")


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="its graphviz is a program, no script")
@pytest.mark.parametrize(
    ("script", "told"),
    [
        ("echo nonsense", "graphviz (dot) made no PDF: status 0"),
        ("echo %PDF; exit 3", "graphviz (dot) made no PDF: status 3"),
        ("kill -9 $$", "graphviz (dot) made no PDF: status -9"),
    ],
)
def test_what_graphviz_does_not_draw_is_drawn_without_it(machine: Machine, script: str, told: str) -> None:
    install_dot(machine.folder, script)
    view = view_frames(machine)
    assert view.program.status == 0 and f"[WARN] [view_frames]: {told}\n" in view.errors
    assert "wheel" in pdf_text(machine.folder / "tree.pdf")


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="its graphviz is a program, no script")
def test_graphviz_has_a_time_limit(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("day6_core.ros.programs._drawn_pdf.LIMIT_SECONDS", 0.05)
    install_dot(machine.folder, "exec /bin/sleep 600")
    view = view_frames(machine)
    assert view.program.status == 0 and "timed out after 0.05 seconds" in view.errors
    assert "wheel" in pdf_text(machine.folder / "tree.pdf")


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="its graphviz is a program, no script")
def test_a_graphviz_that_hangs_ends_with_view_frames(machine: Machine) -> None:
    install_dot(machine.folder, f"echo $$ > '{machine.folder}/pid'; exec /bin/sleep 600")
    view = machine.start("view_frames", "-t", "0", "-o", "tree", package="tf2_tools")
    file = machine.folder / "pid"
    until(lambda: file.exists() and file.read_text().strip(), meanwhile=lambda: machine.advance(0.1))
    assert view.interrupt() == 130
    until(lambda: not process_exists(int(file.read_text())))


def test_an_older_file_of_that_name_stays_whole_where_the_new_one_cannot_be_written(machine: Machine) -> None:
    (machine.folder / "tree.pdf").mkdir()
    view = view_frames(machine)
    assert view.program.status == 1
    assert view.errors.splitlines()[-1].startswith("view_frames: ") and "tree.pdf" in view.errors.splitlines()[-1]
    assert (machine.folder / "tree.gv").exists() and not list((machine.folder / "tree.pdf").iterdir())


def test_the_watcher_hears_what_is_sent(machine: Machine) -> None:
    heard: list[TFMessage] = []
    machine.node.create_subscription(TFMessage, "/tf", heard.append, 10)
    machine.moving.sendTransform(stamped("world", "car", 1))
    machine.advance()
    assert len(heard) == 1
