"""Parameters of other nodes: services, the client, events and their callbacks."""

from __future__ import annotations

from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from rcl_interfaces import srv
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, ParameterEvent, ParameterValue
from rcl_interfaces.msg import Parameter as ParameterMessage

from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler


@pytest.fixture
def robot(world: Any) -> Any:
    node = world.node("robot", namespace="lab")
    node.declare_parameter("speed", 5, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10)]))
    node.declare_parameter("arm.name", "left", ParameterDescriptor(dynamic_typing=True))
    return node


@pytest.fixture
def client(world: Any, robot: Any) -> AsyncParameterClient:
    made = AsyncParameterClient(world.node("asker"), "/lab/robot")
    world.settle()
    return made


def values(response: Any) -> list[Any]:
    return [parameter_value_to_python(each) for each in response.values]


def outcomes(response: Any) -> list[tuple[bool, str]]:
    return [(each.successful, each.reason) for each in response.results]


def test_values_types_and_descriptors_are_asked_for(world: Any, client: AsyncParameterClient) -> None:
    assert values(world.until(client.get_parameters(["arm.name", "speed"]))) == ["left", 5]
    assert list(world.until(client.get_parameter_types(["arm.name", "speed"])).types) == [4, 2]
    (descriptor,) = world.until(client.describe_parameters(["speed"])).descriptors
    assert (descriptor.name, descriptor.type, descriptor.integer_range[0].to_value) == ("speed", 2, 10)


def test_the_unknown_makes_an_answer_empty(world: Any, client: AsyncParameterClient) -> None:
    assert values(world.until(client.get_parameters(["speed", "nothing"]))) == []
    assert list(world.until(client.get_parameter_types(["nothing"])).types) == []
    assert list(world.until(client.describe_parameters(["nothing"])).descriptors) == []


def test_names_are_listed(world: Any, client: AsyncParameterClient) -> None:
    own = ["start_type_description_service", "use_sim_time"]
    assert sorted(world.until(client.list_parameters()).result.names) == sorted(["arm.name", "speed", *own])
    assert sorted(world.until(client.list_parameters(depth=1)).result.names) == sorted(["speed", *own])
    found = world.until(client.list_parameters(prefixes=["arm"])).result
    assert (list(found.names), list(found.prefixes)) == (["arm.name"], ["arm"])


def test_parameters_are_set_from_afar(world: Any, client: AsyncParameterClient, robot: Any) -> None:
    changes = [
        Parameter("speed", value=7),
        ParameterMessage(name="speed", value=ParameterValue(type=2, integer_value=70)),
        Parameter("arm.name", value="right"),
    ]
    results = outcomes(world.until(client.set_parameters(changes)))
    assert results == [(True, ""), (False, "Parameter speed out of range. Min: 0, Max: 10, value: 70"), (True, "")]
    assert [robot.get_parameter(name).value for name in ("speed", "arm.name")] == [7, "right"]
    ((successful, reason),) = outcomes(world.until(client.set_parameters([Parameter("nothing", value=1)])))
    assert not successful
    assert reason.startswith("Invalid access to undeclared parameter(s):")


def test_all_parameters_are_set_or_none(world: Any, client: AsyncParameterClient, robot: Any) -> None:
    changes = [Parameter("speed", value=7), Parameter("speed", value="x")]
    result = world.until(client.set_parameters_atomically(changes)).result
    assert (result.successful, result.reason) == (False, "Wrong parameter type, expected '2' got '4'")
    assert robot.get_parameter("speed").value == 5
    assert world.until(client.set_parameters_atomically([Parameter("speed", value=8)])).result.successful
    assert robot.get_parameter("speed").value == 8


def test_parameters_of_dynamic_type_are_deleted(world: Any, client: AsyncParameterClient, robot: Any) -> None:
    results = outcomes(world.until(client.delete_parameters(["arm.name", "speed"])))
    assert results == [(True, ""), (False, "Static parameter cannot be undeclared")]
    assert [robot.has_parameter(name) for name in ("arm.name", "speed")] == [False, True]


def test_a_callback_hears_of_the_answer(world: Any, client: AsyncParameterClient) -> None:
    heard: list[Any] = []
    futures = [
        client.get_parameters(["speed"], callback=heard.append),
        client.list_parameters(callback=heard.append),
        client.set_parameters([], callback=heard.append),
        client.set_parameters_atomically([Parameter("speed", value=6)], callback=heard.append),
        client.describe_parameters([], callback=heard.append),
        client.get_parameter_types([], callback=heard.append),
    ]
    world.settle()
    assert len(heard) == len(futures)
    assert all(future in heard for future in futures)


def test_a_file_is_loaded_from_afar(world: Any, client: AsyncParameterClient, robot: Any, tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/lab/robot: {ros__parameters: {speed: 9}}\n/**: {ros__parameters: {arm: {name: both}}}\n")
    assert outcomes(world.until(client.load_parameter_file(str(path)))) == [(True, "")]
    assert [robot.get_parameter(name).value for name in ("speed", "arm.name")] == [9, "left"]
    assert world.until(client.load_parameter_file_atomically(str(path), use_wildcard=True)).result.successful
    assert robot.get_parameter("arm.name").value == "both"


def test_the_services_are_waited_for(world: Any) -> None:
    asker = world.node("asker")
    client = AsyncParameterClient(asker, "late")
    assert not client.services_are_ready()
    assert not client.wait_for_services(0.01)
    thread = Thread(target=world.node, args=("late",))
    thread.start()
    assert client.wait_for_services(5)
    assert client.services_are_ready()
    thread.join()
    incomplete = world.node("incomplete", start_parameter_services=False)
    incomplete.create_service(srv.GetParameters, "~/get_parameters", lambda _, response: response)
    assert not AsyncParameterClient(asker, "incomplete").wait_for_services(0.05)


def test_a_node_has_no_parameter_services_unless_it_wants_them(world: Any) -> None:
    node = world.node("n", start_parameter_services=False)
    services = [name for name, _ in node.get_service_names_and_types_by_node("n", "/")]
    assert services == ["/n/get_type_description"]


# events


def test_events_of_all_nodes_are_heard(world: Any, client: AsyncParameterClient, robot: Any) -> None:
    heard: list[Any] = []
    subscription = client.on_parameter_event(heard.append)
    world.settle()
    robot.set_parameters([Parameter("speed", value=6)])
    world.settle()
    assert [(each.node, each.changed_parameters[0].name) for each in heard] == [("/lab/robot", "speed")]
    assert subscription.topic_name == "/parameter_events"


def test_callbacks_for_a_parameter_and_for_all_the_last_added_first(world: Any, robot: Any) -> None:
    other = world.node("other", namespace="lab")
    other.declare_parameter("speed", 1)
    handler = ParameterEventHandler(robot)
    world.settle()
    ran: list[tuple[str, Any]] = []

    def noted(name: str) -> Any:
        return lambda what: ran.append((name, what.value.integer_value if hasattr(what, "value") else what.node))

    handler.add_parameter_callback("speed", "/lab/other", noted("first"))
    second = handler.add_parameter_callback("speed", "other", noted("second"))
    handler.add_parameter_callback("speed", "/lab/robot", noted("own"))
    handler.add_parameter_callback("arm.name", "/lab/other", noted("never"))
    handler.add_parameter_event_callback(noted("event 1"))
    last = handler.add_parameter_event_callback(noted("event 2"))
    other.set_parameters([Parameter("speed", value=2)])
    world.settle()
    both = [("event 2", "/lab/other"), ("event 1", "/lab/other")]
    assert ran == [("second", 2), ("first", 2), *both]
    ran.clear()
    handler.remove_parameter_callback(second)
    handler.remove_parameter_event_callback(last)
    for node, value in ((other, 3), (robot, 4)):
        node.set_parameters([Parameter("speed", value=value)])
        world.settle()
    assert ran == [("first", 3), both[1], ("own", 4), ("event 1", "/lab/robot")]
    with pytest.raises(RuntimeError, match="Callback doesn't exist"):
        handler.remove_parameter_callback(second)
    with pytest.raises(RuntimeError, match="Callback doesn't exist"):
        handler.remove_parameter_event_callback(last)
    ran.clear()
    handler.destroy()
    other.set_parameters([Parameter("speed", value=5)])
    world.settle()
    assert ran == []


def test_a_node_without_name_is_the_handlers_own(world: Any, robot: Any) -> None:
    handler = ParameterEventHandler(robot)
    world.settle()
    heard: list[int] = []
    handle = handler.add_parameter_callback("speed", "", lambda parameter: heard.append(parameter.value.integer_value))
    assert (handle.parameter_name, handle.node_name) == ("speed", "/lab/robot")
    robot.set_parameters([Parameter("speed", value=3)])
    world.settle()
    assert heard == [3]


def test_parameters_are_found_in_an_event() -> None:
    new, changed, deleted = (ParameterMessage(name=name) for name in ("new", "changed", "deleted"))
    event = ParameterEvent(node="/n", new_parameters=[new], changed_parameters=[changed], deleted_parameters=[deleted])
    find = ParameterEventHandler.get_parameter_from_event
    assert find(event, "new", "/n") == new
    assert find(event, "changed", "/n") == changed
    assert find(event, "deleted", "/n") is None
    assert find(event, "new", "/other") is None
    assert list(ParameterEventHandler.get_parameters_from_event(event)) == [new, changed]


# the description of types


def test_a_node_describes_the_types_it_uses(world: Any) -> None:
    from std_msgs.msg import Header, String
    from type_description_interfaces.srv import GetTypeDescription

    node = world.node("n")
    node.create_publisher(Header, "t", 1)
    world.settle()
    asker = node.create_client(GetTypeDescription, "n/get_type_description")
    (info,) = node.get_publishers_info_by_topic("t")

    def ask(type_hash: str, sources: bool = True) -> Any:
        request = GetTypeDescription.Request(
            type_name="std_msgs/msg/Header", type_hash=type_hash, include_type_sources=sources
        )
        return world.until(asker.call_async(request))

    answer = ask(str(info.topic_type_hash))
    assert answer.successful
    description = answer.type_description.type_description
    assert description.type_name == "std_msgs/msg/Header"
    assert [each.name for each in description.fields] == ["stamp", "frame_id"]
    others = answer.type_description.referenced_type_descriptions
    assert [each.type_name for each in others] == ["builtin_interfaces/msg/Time"]
    sources = {each.type_name: each for each in answer.type_sources}
    assert set(sources) == {"std_msgs/msg/Header", "builtin_interfaces/msg/Time"}
    assert sources["std_msgs/msg/Header"].encoding == "msg"
    assert "string frame_id" in sources["std_msgs/msg/Header"].raw_file_contents
    assert list(ask(str(info.topic_type_hash), sources=False).type_sources) == []
    for wrong, reason in (
        ("nothing", "Failed to parse type hash"),
        ("RIHS01_" + "0" * 64, "Type not currently in use"),
    ):
        answer = ask(wrong)
        assert not answer.successful
        assert reason in answer.failure_reason
    assert String() == String()


def test_a_node_may_be_told_not_to_describe_types(world: Any) -> None:
    override = Parameter("start_type_description_service", value=False)
    node = world.node("n", parameter_overrides=[override])
    assert not any("type_description" in name for name, _ in node.get_service_names_and_types_by_node("n", "/"))
    result = world.node("m").set_parameters([Parameter("start_type_description_service", value=False)])[0]
    assert result.reason == "Trying to set a read-only parameter: start_type_description_service."
