"""rqt_tf_tree on a clock that the test moves: its node, what it measures, and how it gives back what it had."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from geometry_msgs.msg import TransformStamped
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

from day6_core.graph import Graph
from day6_core.ros.program_index import COMMANDS, executables
from day6_core.ros.programs.rqt_gui.plugin import PluginPlace, create_node
from day6_core.ros.programs.rqt_tf_tree import rqt_tf_tree
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured
from rclpy.task import Future
from tests.support.waiting import until


class _World:
    """A machine with a node that sends transforms."""

    def __init__(self) -> None:
        self.clock = WorldClock(wall=None, epoch_ns=1_700_000_000 * 1_000_000_000)
        self.scheduler = Scheduler(self.clock)
        self.graph = Graph()
        self.display = Display()
        self.session = Session(self.scheduler, self.graph, ["sender"])
        self.node = self.session.create_node("sender")
        self.moving, self.fixed = TransformBroadcaster(self.node), StaticTransformBroadcaster(self.node)

    def start(self, display: Display | None, *words: str) -> tuple[Program, Captured]:
        output = Captured()
        argv = ["rqt_tf_tree", *words]
        session = Session(self.scheduler, self.graph, argv, stdout=output, stderr=output, display=display)
        program = Program(session, rqt_tf_tree.main)
        self.scheduler.advance(0.1)
        return program, output

    def open(self) -> tuple[Program, Any]:
        program, _ = self.start(self.display)
        (window,) = self.display.windows
        return program, window.model

    def send(self, seconds: float) -> None:
        """Ten times a second, stamped with the real time, as nodes do."""
        for _ in range(round(seconds * 10)):
            self.moving.sendTransform(self.transform("world", "car"))
            self.scheduler.advance(0.1)

    def transform(self, parent: str, child: str) -> TransformStamped:
        found = TransformStamped(child_frame_id=child)
        found.header.frame_id = parent
        found.header.stamp = self.node.get_clock().now().to_msg()
        return found

    def wait(self, condition: Callable[[], object]) -> None:
        """Move on until it holds; reading the answer takes a thread."""
        until(condition, meanwhile=lambda: self.scheduler.advance(0.05))


@pytest.fixture
def world() -> Iterator[_World]:
    found = _World()
    yield found
    found.session.close()


def names(model: Any) -> list[str]:
    return [line.name for line in model.snapshot.lines]


def test_it_is_run_by_ros2_run_and_is_no_command_of_its_own() -> None:
    assert executables("rqt_tf_tree") == ["rqt_tf_tree"] and "rqt_tf_tree" not in COMMANDS


def test_its_node_is_rqts_with_a_listener_and_the_service(world: _World) -> None:
    program, _ = world.open()
    name = f"rqt_gui_py_node_{program.session.pid}"
    topics = dict(world.node.get_subscriber_names_and_types_by_node(name, "/"))
    assert topics["/tf"] == topics["/tf_static"] == ["tf2_msgs/msg/TFMessage"]
    services = dict(world.node.get_service_names_and_types_by_node(name, "/"))
    assert services["/tf2_frames"] == ["tf2_msgs/srv/FrameGraph"]
    assert dict(world.node.get_client_names_and_types_by_node(name, "/")) == {
        "/tf2_frames": ["tf2_msgs/srv/FrameGraph"]
    }


def test_it_looks_by_itself_once_a_second(world: _World) -> None:
    world.fixed.sendTransform(world.transform("car", "laser"))
    _, model = world.open()
    world.send(3.0)
    world.wait(lambda: names(model) == ["world", "car", "laser"])
    (car,) = [frame for frame in model.snapshot.frames if frame.name == "car"]
    assert car.parent == "world" and car.broadcaster == "default_authority"
    assert model.snapshot.age(car) is not None
    (laser,) = [frame for frame in model.snapshot.frames if frame.name == "laser"]
    assert model.snapshot.age(laser) is None


def test_without_auto_refresh_it_looks_when_asked(world: _World) -> None:
    _, model = world.open()
    world.wait(lambda: model.version)
    model.set_auto_refresh(False)
    world.wait(lambda: model.version >= 2)
    before = model.version
    world.send(5.0)
    assert model.version == before and not model.snapshot.lines
    model.request_refresh()
    world.wait(lambda: names(model) == ["world", "car"])


def test_the_program_writes_what_the_window_wants_saved(world: _World, tmp_path: Path) -> None:
    _, model = world.open()
    world.send(1.0)
    world.wait(lambda: names(model) == ["world", "car"])
    model.request_save(str(tmp_path / "frames.svg"))
    world.wait(lambda: model.saved == ("frames.svg", ""))
    assert "car" in (tmp_path / "frames.svg").read_text()


def test_a_cleared_buffer_keeps_static_frames_only(world: _World) -> None:
    world.fixed.sendTransform(world.transform("car", "laser"))
    _, model = world.open()
    world.send(1.0)
    world.wait(lambda: "world" in names(model))
    model.request_clear()
    world.wait(lambda: names(model) == ["car", "laser"])


def test_a_service_of_another_node_that_never_answers_is_told_and_the_tree_stays(
    world: _World, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, model = world.open()
    world.send(1.0)
    world.wait(lambda: names(model) == ["world", "car"])
    monkeypatch.setattr("rclpy.client.Client.call_async", lambda client, request: Future())
    world.wait(lambda: model.problem == "Service tf2_frames does not answer")
    assert names(model) == ["world", "car"]


def test_an_answer_that_is_no_tree_is_told(world: _World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tf2_ros.Buffer.all_frames_as_yaml", lambda buffer: "a: {")
    _, model = world.open()
    world.wait(lambda: model.problem.startswith("Service call failed ParserError"))


def test_a_closed_plugin_leaves_nothing_on_the_node_it_shared(world: _World) -> None:
    session = Session(world.scheduler, world.graph, ["rqt"])
    node = create_node(session)
    place = PluginPlace(session, node, settings={"auto_refresh": False})
    plugin = rqt_tf_tree.TfTreePlugin(place)
    assert plugin.settings() == {"auto_refresh": False}
    plugin.close()
    place.end()
    world.scheduler.advance(0.1)
    kinds = (
        world.node.get_subscriber_names_and_types_by_node,
        world.node.get_client_names_and_types_by_node,
    )
    assert [ask(node.get_name(), "/") for ask in kinds] == [[], []]
    services = dict(world.node.get_service_names_and_types_by_node(node.get_name(), "/"))
    assert "/tf2_frames" not in services
    session.close()


def test_without_a_screen_it_prints_the_tree_once(world: _World) -> None:
    program, output = world.start(None)
    world.fixed.sendTransform(world.transform("car", "laser"))
    world.wait(lambda: program.status is not None)
    assert (program.status, output.text) == (0, "car\n  laser: static, default_authority\n")


def test_without_a_screen_and_without_frames_it_says_so(world: _World) -> None:
    program, output = world.start(None)
    world.wait(lambda: program.status is not None)
    assert (program.status, output.text) == (0, "No tf data received\n")
