"""The model and the program: nodes that appear, answer, refuse, change by themselves, are silent and vanish."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult

import rclpy.parameter_service
from day6_core.ros.programs.rqt_gui.plugin import PluginPlace
from day6_core.ros.programs.rqt_reconfigure.rqt_reconfigure import ReconfigurePlugin
from rclpy.parameter import Parameter
from tests.support.rqt_machine import OtherProgram, RqtMachine


class Machine(RqtMachine):
    """Parameter Reconfigure beside other nodes."""

    def opened(self, name: str = "/sim") -> Any:
        return next(node for node in self.model.opened if node.name == name)

    def parameter(self, name: str, node: str = "/sim") -> Any:
        return next(each for each in self.opened(node).parameters if each.name == name)

    def load(self, name: str) -> None:
        """Load a file, which takes a thread of its own."""
        self.model.load("/sim", name)
        self.until(lambda: self.model.message)
        self.advance(0.3)


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    found = Machine("rqt_reconfigure", tmp_path)
    yield found
    found.end()


def simulator(machine: Machine) -> OtherProgram:
    """A node with a parameter of each sort; it refuses a gain of 13."""
    program = machine.other("sim")
    node = program.node
    red = ParameterDescriptor(description="Red", integer_range=[IntegerRange(from_value=0, to_value=255, step=1)])
    node.declare_parameter("red", 69, red)
    gain = [FloatingPointRange(from_value=0.0, to_value=20.0, step=0.0)]
    node.declare_parameter("gain", 2.0, ParameterDescriptor(floating_point_range=gain))
    node.declare_parameter("fast", False)
    node.declare_parameter("frame", "map", ParameterDescriptor(read_only=True, description="Never changes"))
    node.declare_parameter("weights", [1.0, 2.0])

    def check(parameters: Any) -> SetParametersResult:
        unlucky = any(each.name == "gain" and each.value == 13.0 for each in parameters)
        return SetParametersResult(successful=not unlucky, reason="13 brings bad luck\x1b[2J" if unlucky else "")

    node.add_on_set_parameters_callback(check)
    return program


def test_the_nodes_with_parameters_are_listed_as_they_come_and_go(machine: Machine) -> None:
    machine.open()
    assert machine.model.nodes == (machine.own, "/watcher")
    talker = machine.other("talker", namespace="/robot")
    machine.advance(0.3)
    assert machine.model.nodes == ("/robot/talker", machine.own, "/watcher")
    talker.end()
    assert machine.model.nodes == (machine.own, "/watcher")


def test_an_opened_node_shows_its_parameters_with_types_ranges_and_descriptions(machine: Machine) -> None:
    simulator(machine)
    machine.open()
    machine.do("toggle", "/sim")
    opened = machine.opened()
    assert opened.there and opened.complete and opened.waited is None
    values = {each.name: each.value for each in opened.parameters}
    assert list(values) == sorted(values)
    assert {"red": 69, "gain": 2.0, "fast": False, "frame": "map", "weights": [1.0, 2.0]}.items() <= values.items()
    red, frame = machine.parameter("red"), machine.parameter("frame")
    assert (red.range.minimum, red.range.maximum, red.description) == (0, 255, "Red")
    assert frame.read_only and frame.description == "Never changes" and not red.read_only


def test_it_has_the_clients_and_the_subscription_of_the_real_plugin(machine: Machine) -> None:
    node = simulator(machine).node
    before = node.count_subscribers("/parameter_events")
    running = machine.open("/sim")
    machine.advance(1.0)
    clients = {name for name, _ in node.get_client_names_and_types_by_node(machine.own[1:], "/")}
    assert clients == {f"/sim/{kind}_parameters" for kind in ("get", "set", "list", "describe")}
    assert node.count_subscribers("/parameter_events") == before + 1
    machine.do("toggle", "/sim")
    assert node.get_client_names_and_types_by_node(machine.own[1:], "/") == []
    assert node.count_subscribers("/parameter_events") == before
    running.program.interrupt()
    machine.advance(0.2)
    assert machine.display.windows == []


def test_a_change_reaches_the_node_and_stays(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    machine.do("set", "/sim", "red", 200)
    assert node.get_parameter("red").value == 200
    assert machine.parameter("red").value == 200 and not machine.parameter("red").sent
    machine.do("move", "/sim", "red", -10)
    assert node.get_parameter("red").value == 190
    machine.do("set", "/sim", "weights", [3.0])
    assert list(node.get_parameter("weights").value) == [3.0]


def test_a_refused_change_shows_the_reason_of_the_node_and_the_old_value(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    machine.do("set", "/sim", "gain", 13.0)
    gain = machine.parameter("gain")
    assert gain.refusal == "13 brings bad luck\x1b[2J"
    assert gain.value == node.get_parameter("gain").value == 2.0 and not gain.sent
    machine.do("set", "/sim", "gain", 25.0)
    assert machine.parameter("gain").refusal == "Parameter gain out of range Min: 0.0, Max: 20.0, value: 25.0"
    machine.do("set", "/sim", "gain", 3.0)
    assert machine.parameter("gain").refusal == "" and machine.parameter("gain").value == 3.0


def test_a_read_only_parameter_is_not_sent(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    machine.do("set", "/sim", "frame", "odom")
    assert machine.parameter("frame").value == node.get_parameter("frame").value == "map"


def test_a_value_that_somebody_else_sets_shows_up(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    node.set_parameters([Parameter("red", value=10)])
    machine.advance(0.2)
    assert machine.parameter("red").value == 10
    assert machine.parameter("red").range is not None


def test_parameters_that_are_declared_later_appear_and_deleted_ones_vanish(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    node.declare_parameter("late", 1.5, ParameterDescriptor(dynamic_typing=True, description="Came late"))
    machine.advance(0.2)
    assert machine.parameter("late").value == 1.5 and machine.parameter("late").description == "Came late"
    node.set_parameters([Parameter("late")])
    machine.advance(0.2)
    assert "late" not in [each.name for each in machine.opened().parameters]


def test_an_undeclared_parameter_is_told_by_no_event_and_vanishes_when_the_node_is_read_again(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    node.undeclare_parameter("fast")
    machine.do("set", "/sim", "fast", True)
    assert machine.parameter("fast").refusal and machine.parameter("fast").value is False
    machine.do("read", "/sim")
    assert "fast" not in [each.name for each in machine.opened().parameters]


def test_a_node_that_vanishes_keeps_its_last_values_and_comes_back(machine: Machine) -> None:
    program = simulator(machine)
    machine.open("/sim")
    machine.do("set", "/sim", "red", 1)
    program.end()
    assert not machine.opened().there and machine.parameter("red").value == 1
    machine.do("set", "/sim", "red", 2)
    assert machine.parameter("red").value == 1
    simulator(machine)
    machine.advance(0.5)
    assert machine.opened().there and machine.parameter("red").value == 69


def test_a_node_that_does_not_spin_is_told_with_the_seconds_and_can_be_given_up(machine: Machine) -> None:
    machine.other("stuck", spins=False)
    machine.open()
    machine.do("toggle", "/stuck", seconds=0.5)
    assert machine.opened("/stuck").waited == 0 and not machine.opened("/stuck").message
    machine.advance(3.0)
    opened = machine.opened("/stuck")
    assert opened.waited == 3 and opened.message == "the target node may not be spinning"
    assert not opened.complete and opened.parameters == ()
    machine.do("cancel", "/stuck")
    assert machine.opened("/stuck").waited is None


def test_a_node_is_asked_when_all_its_services_are_known(machine: Machine) -> None:
    slow = machine.other("slow", start_parameter_services=False).node
    services = rclpy.parameter_service.ParameterService(slow)
    machine.open()
    for each in list(slow.services):
        if not each.srv_name.endswith("list_parameters"):
            slow.destroy_service(each)
    machine.do("toggle", "/slow")
    assert machine.opened("/slow").waited is None
    services = rclpy.parameter_service.ParameterService(slow)
    machine.advance(0.5)
    assert services and machine.opened("/slow").complete and machine.opened("/slow").parameters


def test_a_change_that_is_never_answered_is_put_back_when_one_stops_waiting(machine: Machine) -> None:
    program = simulator(machine)
    machine.open("/sim")
    program.hold()
    machine.do("set", "/sim", "red", 200)
    machine.do("move", "/sim", "red", 1)
    assert machine.parameter("red").value == 201 and machine.parameter("red").sent
    machine.do("cancel", "/sim")
    assert machine.parameter("red").value == 69 and not machine.parameter("red").sent


def test_many_moves_while_one_is_under_way_end_at_the_last_one(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    asked: list[object] = []
    node.add_on_set_parameters_callback(lambda given: asked.extend(given) or SetParametersResult(successful=True))
    for _ in range(50):
        machine.model.move("/sim", "red", 1)
    machine.advance(0.5)
    assert node.get_parameter("red").value == machine.parameter("red").value == 119
    assert len(asked) == 2


def test_several_nodes_and_five_hundred_parameters_are_open_at_once(machine: Machine) -> None:
    many = machine.other("many").node
    for number in range(500):
        many.declare_parameter(f"p{number:03}", number)
    simulator(machine)
    machine.open("/many", "/sim")
    assert [node.name for node in machine.model.opened] == ["/many", "/sim"]
    assert machine.parameter("p499", "/many").value == 499


@pytest.mark.long
def test_three_hundred_nodes_are_listed(machine: Machine) -> None:
    machine.open()
    for number in range(300):
        machine.other(f"n{number:03}", namespace=f"/group{number % 7}", spins=False)
    machine.advance(0.5)
    assert len(machine.model.nodes) == 302


def test_a_node_of_the_command_line_that_is_not_there_is_told_as_in_the_real_one(machine: Machine) -> None:
    running = machine.open("/nobody", seconds=2.0)
    assert "Could not find a dynamic reconfigure client named '/nobody'" in running.errors
    assert machine.model.opened == ()


@pytest.mark.parametrize(
    ("kept", "opened"),
    [({"selected_nodes": ["/sim", 5, "/gone"], "text": "s"}, ["/sim"]), ({"selected_nodes": 3, "text": 7}, [])],
)
def test_a_kept_perspective_opens_the_nodes_that_are_there(machine: Machine, kept: Any, opened: list[str]) -> None:
    simulator(machine)
    program = machine.other("rqt_gui_py_node_1")
    place = PluginPlace(program.session, program.node, settings=kept)
    plugin = ReconfigurePlugin(place)
    place.spawn(plugin.run())
    machine.advance(2.0)
    assert [each.name for each in plugin.model.opened] == opened
    assert plugin.settings() == {"selected_nodes": opened, "text": "s" if opened else ""}
    plugin.close()
    place.end()
    assert machine.node.get_client_names_and_types_by_node("rqt_gui_py_node_1", "/") == []


def test_parameters_are_saved_to_a_file_and_loaded_from_it(machine: Machine) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    path = machine.model.save("/sim", "sim.yaml")
    assert path == machine.folder / "sim.yaml" and "red: 69\n" in path.read_text()
    machine.do("set", "/sim", "red", 3)
    path.write_text("red: 44\ngain: 13.0\nweights: [5.0]\nnobody: 1\n")
    machine.load("sim.yaml")
    assert (node.get_parameter("red").value, list(node.get_parameter("weights").value)) == (44, [5.0])
    assert machine.parameter("gain").value == 2.0 and machine.parameter("gain").refusal.startswith("13 brings")
    assert "nobody" in machine.opened().message


@pytest.mark.long
@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"[1, 2]", "not a mapping"),
        (b"a: {b: 1}", "not one of the allowed types"),
        (b"a: [", "while parsing"),
        (b"\xff\xfe\x00", "unacceptable character"),
        (b"a: " + b"[" * 3000, ""),
        (b"a: 1\n" * 50_000, "more than"),
        (None, "No such file"),
    ],
)
def test_a_bad_file_is_told_and_changes_nothing(machine: Machine, content: bytes | None, told: str) -> None:
    node = simulator(machine).node
    machine.open("/sim")
    if content is not None:
        (machine.folder / "bad.yaml").write_bytes(content)
    machine.load("bad.yaml")
    assert machine.model.message.startswith("Parameter loading wasn't successful because: ")
    assert told in machine.model.message
    assert node.get_parameter("red").value == 69
