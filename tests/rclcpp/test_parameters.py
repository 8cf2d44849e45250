"""The parameters of C++ nodes, as `ros2 param` and the services show them: names, answers and refusals of rclcpp."""

from __future__ import annotations

from typing import Any

import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, ParameterEvent

from day6_core.ros.programs.rclcpp.exceptions import ParameterNotDeclared, RclcppException
from day6_core.ros.programs.rclcpp.parameters import CppParameterStore
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.parameter import Parameter

EVENT_QOS = [
    f"qos_overrides./parameter_events.publisher.{each}" for each in ("depth", "durability", "history", "reliability")
]
OF_RED = "parameter {background_r}"
WRONG_TYPE = (
    "parameter 'x' has invalid type: Wrong parameter type, parameter {x} is of type {integer}, "
    "setting it to {string} is not allowed."
)
EVERY_NODE = ["start_type_description_service", "use_sim_time"]


@pytest.fixture
def turtlesim(machine):
    return machine.run("turtlesim", "turtlesim_node")


def listed(machine, node: str) -> list[str]:
    return [line.strip() for line in machine.ros2("param", "list", node).stdout.splitlines()]


# -- which there are ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("package", "executable", "node", "own"),
    [
        ("turtlesim", "turtlesim_node", "/turtlesim", ["background_b", "background_g", "background_r", "holonomic"]),
        ("turtlesim", "draw_square", "/draw_square", []),
        ("turtlesim", "mimic", "/turtle_mimic", []),
        ("demo_nodes_cpp", "talker", "/talker", []),
        ("demo_nodes_cpp", "add_two_ints_server", "/add_two_ints_server", ["one_shot"]),
        ("lifecycle", "lifecycle_listener", "/lc_listener", []),
        ("action_tutorials_cpp", "fibonacci_action_server", "/fibonacci_action_server", []),
        ("rviz2", "rviz2", "/rviz", ["tf_buffer_cache_time_ms"]),
    ],
)
def test_a_cpp_node_has_the_parameters_of_every_cpp_node(machine, package, executable, node, own):
    machine.run(package, executable)
    assert listed(machine, node) == sorted([*own, *EVENT_QOS, *EVERY_NODE])


def test_a_python_node_has_no_qos_parameters(machine):
    machine.node("talker")
    assert listed(machine, "/talker") == EVERY_NODE


def test_a_lifecycle_node_of_cpp_has_none_for_parameter_events(machine):
    machine.run("lifecycle", "lifecycle_talker")
    assert listed(machine, "/lc_talker") == EVERY_NODE
    assert (
        "/parameter_events: rcl_interfaces/msg/ParameterEvent"
        in (machine.ros2("node", "info", "/lc_talker").stdout.partition("Publishers")[0])
    )


def test_the_dump_of_turtlesim_is_that_of_the_tutorial(machine, turtlesim):
    lines = machine.ros2("param", "dump", "/turtlesim").stdout.splitlines()
    dumped = [line for line in lines if "background_" not in line]  # the tutorial has other colours
    assert dumped == [
        "/turtlesim:",
        "  ros__parameters:",
        "    holonomic: false",
        "    qos_overrides:",
        "      /parameter_events:",
        "        publisher:",
        "          depth: 1000",
        "          durability: volatile",
        "          history: keep_last",
        "          reliability: reliable",
        "    start_type_description_service: true",
        "    use_sim_time: false",
        "",
    ]


def test_they_describe_themselves_in_the_words_of_rclcpp(machine, turtlesim):
    described = machine.ros2("param", "describe", "/turtlesim", EVENT_QOS[0], "start_type_description_service").stdout
    assert described == (
        f"Parameter name: {EVENT_QOS[0]}\n"
        "  Type: integer\n"
        "  Description: qos policy {depth} for publisher {/parameter_events}\n"
        "  Constraints:\n"
        "    Read only: true\n"
        "Parameter name: start_type_description_service\n"
        "  Type: boolean\n"
        "  Description: Start the ~/get_type_description service for this node.\n"
        "  Constraints:\n"
        "    Read only: true\n"
    )


def test_a_container_has_no_services_for_its_parameters(machine):
    machine.run("rclcpp_components", "component_container")
    info = machine.ros2("node", "info", "--include-hidden", "/ComponentManager").stdout
    assert "parameters" not in info and "/parameter_events" not in info.partition("Publishers")[2]
    assert "/ComponentManager/_container/load_node" in info


def test_a_component_that_cannot_be_made_says_why_in_the_words_of_cpp(machine):
    machine.run("rclcpp_components", "component_container")
    load = ("component", "load", "/ComponentManager", "composition", "composition::Talker")
    # `ros2 component` writes all letters but the first small.
    thrown = "Failed to load component: Component constructor threw an exception: "
    rule = machine.ros2(*load, "-r", "nonsense").stderr
    assert rule.startswith(thrown + "failed to parse arguments: couldn't parse remap rule: '-r nonsense'. error: ")
    assert machine.ros2(*load, "-p", "use_sim_time:=5").stderr == (
        f"{thrown}parameter 'use_sim_time' has invalid type: "
        "wrong parameter type, parameter {use_sim_time} is of type {bool}, setting it to {integer} is not allowed.\n"
    )


# -- setting -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("background_r", "300", "Parameter {background_r} doesn't comply with integer range."),
        (
            *("background_r", "red"),
            f"Wrong parameter type, {OF_RED} is of type {{integer}}, setting it to {{string}} is not allowed.",
        ),
        (
            *("background_r", "[1, 2]"),
            f"Wrong parameter type, {OF_RED} is of type {{integer}}, setting it to {{integer_array}} is not allowed.",
        ),
        ("nope", "1", "parameter 'nope' cannot be set because it was not declared"),
        (EVENT_QOS[0], "5", f"parameter '{EVENT_QOS[0]}' cannot be set because it is read-only"),
    ],
)
def test_a_refusal_is_in_the_words_of_rclcpp(machine, turtlesim, name, value, reason):
    refused = machine.ros2("param", "set", "/turtlesim", name, value)
    assert refused.stdout + refused.stderr == f"Setting parameter failed: {reason}\n"


def test_a_parameter_of_one_type_cannot_be_deleted(machine, turtlesim):
    deleted = machine.ros2("param", "delete", "/turtlesim", "background_r")
    assert "cannot undeclare a statically typed parameter\n" in deleted.stdout + deleted.stderr


def test_setting_all_or_nothing_has_an_answer_of_its_own_for_what_is_not_declared(machine, turtlesim):
    request = "{parameters: [{name: nope, value: {type: 2, integer_value: 1}}]}"
    kind = "rcl_interfaces/srv/SetParametersAtomically"
    answer = machine.ros2("service", "call", "/turtlesim/set_parameters_atomically", kind, request).stdout
    assert "reason='One or more parameters were not declared before setting'" in answer
    nothing = machine.ros2("service", "call", "/turtlesim/set_parameters_atomically", kind).stdout
    assert "reason='parameter list cannot be empty, this might be due to pre_set" in nothing


def test_a_parameter_without_a_name_ends_the_node_as_in_the_original(machine, turtlesim):
    request = "{parameters: [{value: {type: 2, integer_value: 1}}]}"
    machine.start("service", "call", "/turtlesim/set_parameters", "rcl_interfaces/srv/SetParameters", request)
    machine.step(0.1)
    assert turtlesim.stderr.text.endswith(
        "terminate called after throwing an instance of 'rclcpp::exceptions::InvalidParametersException'\n"
        "  what():  parameter name must not be empty\n"
    )


def test_a_blackboard_takes_parameters_of_any_type_and_forgets_them(machine):
    board = machine.run(
        "demo_nodes_cpp", "parameter_blackboard", "--ros-args", "-p", "some_int:=42", "-p", "a_string:=Hello world"
    )
    assert "and serving '8' parameters already!" in board.stderr.text
    name = "/parameter_blackboard"
    assert listed(machine, name) == sorted(["a_string", "some_int", *EVENT_QOS, *EVERY_NODE])
    assert machine.ros2("param", "set", name, "some_int", "now a text").stdout == "Set parameter successful\n"
    assert machine.ros2("param", "get", name, "some_int").stdout == "String value is: now a text\n"
    assert "  Type: string\n" in machine.ros2("param", "describe", name, "some_int").stdout
    assert machine.ros2("param", "delete", name, "some_int").stdout == "Deleted parameter successfully\n"
    assert "some_int" not in listed(machine, name)
    assert machine.ros2("param", "set", name, "new", "1.5").stdout == "Set parameter successful\n"
    assert machine.ros2("param", "get", name, "new").stdout == "Double value is: 1.5\n"


# -- the rules alone ---------------------------------------------------------------------------------------------------


class Heard:
    """Hears of changes."""

    def __init__(self) -> None:
        self.events: list[tuple[list[str], list[str], list[str]]] = []

    def require(self) -> None: ...

    def has_subscribers(self) -> bool:
        return True

    def changed(self, *lists: list[Parameter[Any]]) -> None:
        new, changed, deleted = ([each.name for each in parameters] for parameters in lists)
        self.events.append((new, changed, deleted))


def parameter(name: str, value: Any = None) -> Parameter[Any]:
    return Parameter(name, value=value)


def test_names_are_listed_sorted_with_their_prefixes():
    store = CppParameterStore()
    for name in ("foo.second", "bar", "foo.first", "foo", "a.b.c"):
        store.declare("", [(name, 0)])
    everything = store.names_below([], 0)
    assert everything.names == ["a.b.c", "bar", "foo", "foo.first", "foo.second"]
    assert everything.prefixes == ["a.b", "foo"]
    assert store.names_below([], 1).names == ["bar", "foo"]
    assert store.names_below(["foo"], 1).names == ["foo", "foo.first", "foo.second"]
    assert list(store.by_prefix("foo")) == ["first", "second"]


@pytest.mark.parametrize(
    ("value", "fits"),
    [(0, True), (255, True), (10, True), (12, False), (-1, False), (256, False)],
)
def test_an_integer_has_to_be_on_a_step_or_at_an_end(value, fits):
    descriptor = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=255, step=5)])
    store = CppParameterStore()
    store.declare("", [("x", 0, descriptor)])
    result = store.set_atomically([parameter("x", value)])
    assert (result.successful, result.reason) == (
        fits,
        "" if fits else "Parameter {x} doesn't comply with integer range.",
    )


@pytest.mark.parametrize(
    ("value", "fits"),
    [(-1.0, True), (2.0, True), (0.1 + 0.2, True), (0.30001, False), (-1.00001, False), (1.95, False)],
)
def test_a_number_has_to_be_on_a_step_or_at_an_end(value, fits):
    allowed = FloatingPointRange(from_value=-1.0, to_value=2.0, step=0.1)
    store = CppParameterStore()
    store.declare("", [("x", 0.0, ParameterDescriptor(floating_point_range=[allowed]))])
    result = store.set_atomically([parameter("x", value)])
    assert (result.successful, result.reason) == (
        fits,
        "" if fits else "Parameter {x} doesn't comply with floating point range.",
    )


def test_of_several_parameters_all_or_none_are_set():
    store = CppParameterStore()
    store.declare("", [("a", 1), ("b", 2)])
    assert not store.set_atomically([parameter("a", 5), parameter("b", "text")]).successful
    assert store.get("a").value == 1
    assert store.set_atomically([parameter("a", 5), parameter("b", 6)]).successful
    assert [each.value for each in store.get_each(["a", "b"])] == [5, 6]


def test_what_is_not_declared_cannot_be_set():
    store = CppParameterStore()
    with pytest.raises(
        ParameterNotDeclared, match=r"^parameter 'x' cannot be set because it was not declared$"
    ) as told:
        store.set_atomically([parameter("x", 1)])
    assert isinstance(told.value, ParameterNotDeclaredException)
    assert told.value.report.splitlines()[0].endswith("'rclcpp::exceptions::ParameterNotDeclaredException'")


@pytest.mark.parametrize(
    ("override", "kind", "what"),
    [
        (
            *("text", "InvalidParameterTypeException"),
            WRONG_TYPE,
        ),
        (
            *(9, "InvalidParameterValueException"),
            "parameter 'x' could not be set: Parameter {x} doesn't comply with integer range.",
        ),
    ],
)
def test_an_initial_value_that_does_not_fit_is_thrown(override, kind, what):
    store = CppParameterStore(overrides={"x": parameter("x", override)})
    descriptor = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=5)])
    with pytest.raises(RclcppException) as thrown:
        store.declare("", [("x", 1, descriptor)])
    assert (thrown.value.kind, str(thrown.value)) == (f"rclcpp::exceptions::{kind}", what)
    assert not store.has("x")


def test_events_tell_what_is_new_changed_and_deleted():
    heard = Heard()
    store = CppParameterStore(allow_undeclared=True, listener=heard)
    store.declare("", [("a", 1)])
    store.declare("", [("unset", Parameter.Type.STRING)])
    store.set_atomically([parameter("a", 2), parameter("b", 3)])
    store.set_atomically([parameter("unset", "now")])
    store.set_atomically([parameter("b")])
    assert heard.events == [
        (["a"], [], []),
        ([], [], []),  # declared, but without a value there is nothing to tell
        (["b"], ["a"], []),
        ([], ["unset"], []),
        ([], [], ["b"]),
    ]


def test_a_callback_before_the_setting_changes_what_the_next_one_gets():
    store = CppParameterStore()
    store.declare("", [("a", 1), ("b", 1)])
    store.add_pre_set_callback(lambda parameters: [*parameters, parameter("b", len(parameters))])
    store.add_pre_set_callback(lambda parameters: [*parameters, parameter("b", 7)])  # called first
    store.set_atomically([parameter("a", 2)])
    assert [each.value for each in store.get_each(["a", "b"])] == [2, 2]


def test_a_node_tells_of_its_parameters_when_it_declares_them(machine):
    heard: list[ParameterEvent] = []
    machine.node("ear", lambda node: node.create_subscription(ParameterEvent, "/parameter_events", heard.append, 100))
    machine.run("demo_nodes_cpp", "talker")
    names = [each.name for event in heard if event.node == "/talker" for each in event.new_parameters]
    assert sorted(names) == sorted([*EVERY_NODE, *EVENT_QOS])
