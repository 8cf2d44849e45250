"""The Service Caller: services found, requests filled in, answers and their absence, on a clock that the test moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from example_interfaces.srv import AddTwoInts
from std_srvs.srv import Empty, SetBool

from day6_core.graph import Graph
from day6_core.ros.programs.rqt_service_caller import rqt_service_caller
from day6_core.ros.programs.turtlesim import turtlesim_node
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured


class _World:
    """A machine with the Service Caller and a node of the test's."""

    def __init__(self) -> None:
        self.scheduler = Scheduler(WorldClock(wall=None, epoch_ns=1_700_000_000 * 10**9))
        self.graph = Graph()
        self.display = Display()
        self.server = Session(self.scheduler, self.graph, ["server"])
        self.node = self.server.create_node("server")

    def start(self, main: Callable[[Session], Any], *, display: Display | None = None) -> tuple[Program, Captured]:
        output = Captured()
        session = Session(self.scheduler, self.graph, ["program"], stdout=output, stderr=output, display=display)
        return Program(session, main), output

    def open(self) -> tuple[Any, Captured, Program]:
        program, output = self.start(rqt_service_caller.main, display=self.display)
        self.wait(0.3)
        return self.display.windows[0].model, output, program

    def serve(self) -> None:
        """Let the test's node answer."""
        self.server.spawn(self.server.spin(self.node))

    def wait(self, seconds: float) -> None:
        self.scheduler.advance(seconds)


@pytest.fixture
def world() -> Iterator[_World]:
    found = _World()
    yield found
    found.server.close()


def _fields(rows: Any) -> list[tuple[str, str, str]]:
    return [(row.name, row.type, row.text) for row in rows]


def test_a_turtle_is_spawned_as_the_tutorial_does_it(world) -> None:
    _, turtle_output = world.start(turtlesim_node.main, display=Display())
    model, output, _ = world.open()
    model.choose("/spawn")
    world.wait(0.1)
    assert _fields(model.request) == [
        ("x", "float", "0.0"),
        ("y", "float", "0.0"),
        ("theta", "float", "0.0"),
        ("name", "string", "''"),
    ]
    for path, text in (("/x", "1.0"), ("/y", "1.0"), ("/name", "'turtle2'")):
        model.set_expression(path, text)
    model.call()
    world.wait(0.2)
    assert model.state == "answered" and _fields(model.response) == [("name", "string", "'turtle2'")]
    model.set_expression("/name", "turtle2")  # without quotes it is the same
    model.call()
    world.wait(0.2)
    assert _fields(model.response) == [("name", "string", "''")]
    assert "A turtle named [turtle2] already exists" in turtle_output.text and output.text == ""


def test_a_value_out_of_range_is_named_in_the_window_and_the_terminal(world) -> None:
    world.start(turtlesim_node.main, display=Display())
    model, output, _ = world.open()
    model.choose("/turtle1/set_pen")
    for path, text in (("/r", "300"), ("/g", "green"), ("/b", "'x'"), ("/width", "5"), ("/off", "0.9")):
        model.set_expression(path, text)
    world.wait(0.1)
    problems = {row.name: row.problem for row in model.request}
    assert "unsigned integer in [0, 255]" in problems["r"] and not problems["width"] and not problems["off"]
    assert problems["g"] == "failed to evaluate expression: green"
    assert problems["b"] == "can not convert expression to slot type: <class 'str'> -> <class 'int'>"
    assert output.text == ""
    model.call()
    world.wait(0.2)
    assert model.state == "answered"
    assert "Failed to set r to 300" in output.text and "failed to evaluate expression: green" in output.text


def test_i_is_nought_in_a_request(world) -> None:
    world.start(turtlesim_node.main, display=Display())
    model, output, _ = world.open()
    model.choose("/spawn")
    model.set_expression("/x", "i + 2")
    world.wait(0.1)
    assert [row.problem for row in model.request] == [""] * 4
    model.call()
    world.wait(0.2)
    assert model.state == "answered" and output.text == ""


def test_services_come_and_go_while_the_window_is_open(world) -> None:
    world.serve()
    model, _, _ = world.open()
    service = world.node.create_service(AddTwoInts, "add", lambda request, response: response)
    world.wait(0.2)
    assert ("/add", "example_interfaces/srv/AddTwoInts") in model.services
    model.choose("/add")
    world.wait(0.1)
    world.node.destroy_service(service)
    world.wait(0.2)
    assert "/add" not in dict(model.services) and model.service == "/add"
    model.call()
    world.wait(0.1)
    assert model.message == 'Service "/add" is no longer available. Refresh the list of services'


def test_a_service_that_never_answers_is_waited_for_until_that_is_cancelled(world) -> None:
    world.node.create_service(Empty, "mute", lambda request, response: response)  # its node is not spun
    model, _, _ = world.open()
    model.choose("/mute")
    model.call()
    world.wait(3.4)
    assert (model.state, model.waited, model.is_waiting) == ("waiting", 3, True)
    model.call()  # is one call
    model.cancel()
    world.wait(0.1)
    assert model.state == "cancelled" and not model.is_waiting
    world.serve()
    world.wait(1.0)  # now it answers, and nobody waits any more
    assert model.state == "cancelled" and model.response is None


def test_the_next_call_after_a_cancelled_one_gets_its_own_answer(world) -> None:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    world.node.create_service(AddTwoInts, "add", add)
    model, _, _ = world.open()
    model.choose("/add")
    model.set_expression("/a", "1")
    model.call()
    model.cancel()
    model.set_expression("/a", "41")
    model.set_expression("/b", "2 - 1")
    model.call()
    world.wait(0.2)
    world.serve()
    world.wait(0.5)
    assert _fields(model.response) == [("sum", "int64", "42")]


def test_a_node_that_ends_while_it_is_waited_for_is_said_to_be_gone(world) -> None:
    service = world.node.create_service(SetBool, "switch", lambda request, response: response)
    model, _, _ = world.open()
    model.choose("/switch")
    model.call()
    world.wait(0.2)
    assert model.state == "waiting"
    world.node.destroy_service(service)
    world.wait(0.2)
    assert model.state == "gone" and not model.is_waiting


def test_services_of_unknown_types_and_parts_of_actions_are_left_out(world) -> None:
    class Strange(AddTwoInts):
        pass

    world.start(turtlesim_node.main, display=Display())
    model, _, _ = world.open()
    model._node.get_service_names_and_types = lambda: [
        ("/strange", ["nowhere_msgs/srv/Strange"]),
        ("/turtle1/rotate_absolute/_action/send_goal", ["turtlesim/action/RotateAbsolute_SendGoal"]),
        ("/odd", ["srv"]),
        ("/spawn", ["turtlesim/srv/Spawn"]),
    ]
    model.refresh()
    world.wait(0.1)
    assert model.services == (("/spawn", "turtlesim/srv/Spawn"),)


def test_the_service_of_a_perspective_is_chosen_as_soon_as_it_is_there(world) -> None:
    from day6_core.ros.programs.rqt_gui.plugin import PluginPlace

    place = PluginPlace(world.server, world.node, settings={"current_service_name": "/late"})
    plugin = rqt_service_caller.ServiceCallerPlugin(place)
    world.server.spawn(plugin.run())
    world.wait(0.2)
    world.node.create_service(Empty, "late", lambda request, response: response)
    world.wait(0.2)
    assert plugin.settings() == {"current_service_name": "/late"}
    plugin.close()
    place.end()


@pytest.mark.parametrize("kept", [None, 5, ["/x"], "/nowhere"])
def test_a_perspective_may_say_anything(world, kept: object) -> None:
    from day6_core.ros.programs.rqt_gui.plugin import PluginPlace

    place = PluginPlace(world.server, world.node, settings={"current_service_name": kept})
    plugin = rqt_service_caller.ServiceCallerPlugin(place)
    plugin.model.follow()
    assert plugin.model.service
    plugin.close()


def test_nothing_is_left_on_the_node_when_the_window_is_closed_while_it_waits(world) -> None:
    world.node.create_service(Empty, "mute", lambda request, response: response)
    model, _, program = world.open()
    model.choose("/mute")
    model.call()
    world.wait(0.1)
    node = model._node
    assert len(list(node.clients)) == 1
    model.close()
    assert list(node.clients) == []
    program.interrupt()
    world.wait(0.1)
    assert program.status is not None


def test_five_hundred_services_are_listed(world) -> None:
    for number in range(500):
        world.node.create_service(Empty, f"service{number:03}", lambda request, response: response)
    model, _, _ = world.open()
    assert sum(name.startswith("/service") for name, _ in model.services) == 500


def test_without_a_screen_it_is_a_node(world) -> None:
    program, output = world.start(rqt_service_caller.main)
    world.wait(0.3)
    assert "There is no screen for the window" in output.text and program.status is None
    program.interrupt()
    world.wait(0.1)
