"""Nodes in the graph: what a fresh node has, how it goes, who may use what of it."""

from __future__ import annotations

import gc
from typing import Any

import pytest
from std_msgs.msg import Int32, String
from test_msgs.action import Fibonacci

from day6_core.interfaces import get_interface, type_hash
from rclpy._day6.own_services import GET_TYPE_DESCRIPTION, HASHES
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError
from rclpy.action import ActionClient, ActionServer


def test_a_fresh_node_has_two_publishers_and_seven_services(world: Any) -> None:
    node = world.node("talker", namespace="lab")
    assert [name for name, _ in node.get_publisher_names_and_types_by_node("talker", "/lab")] == [
        "/parameter_events",
        "/rosout",
    ]
    services = dict(node.get_service_names_and_types_by_node("talker", "/lab"))
    assert len(services) == 7
    assert services["/lab/talker/get_type_description"] == [GET_TYPE_DESCRIPTION]


def test_the_hashes_of_a_nodes_own_types_are_the_computed_ones() -> None:
    assert {name: type_hash(get_interface(name)) for name in HASHES} == HASHES


def test_a_node_that_nobody_holds_disappears(world: Any) -> None:
    keeper = world.node("keeper")

    def forget() -> None:
        from rclpy.node import Node

        node = Node("short_lived", context=world.context)
        node.create_publisher(String, "t", 1)

    forget()
    gc.collect()
    assert keeper.get_node_names() == ["keeper"]


def test_everything_of_a_destroyed_node_is_gone_and_says_so(world: Any) -> None:
    keeper = world.node("keeper")
    node = world.node("n")
    publisher = node.create_publisher(String, "c", 1)
    timer = node.create_timer(1.0, lambda: None)
    node.destroy_node()
    node.destroy_node()
    assert keeper.count_publishers("/c") == 0
    for use in (lambda: publisher.publish(String()), timer.cancel, node.get_name, lambda: publisher.topic_name):
        with pytest.raises(InvalidHandle, match="cannot use Destroyable because destruction was requested"):
            use()


def test_a_context_uses_a_topic_with_one_type_only(world: Any) -> None:
    node = world.node("n")
    publisher = node.create_publisher(String, "c", 1)
    with pytest.raises(RCLError, match="existing topic name rt/c with incompatible type std_msgs::msg::dds_::Int32_"):
        node.create_subscription(Int32, "c", lambda _: None, 1)
    node.destroy_publisher(publisher)
    node.create_subscription(Int32, "c", lambda _: None, 1)


def test_a_second_node_of_the_same_name_is_only_warned_of(world: Any) -> None:
    first = world.node("twin")
    world.node("twin")
    assert len(world.log) == 1
    assert "[rcl.logging_rosout]: Publisher already registered for node name: 'twin'." in world.log[0]
    assert first.get_node_names() == ["twin", "twin"]


def test_rosout_keeps_messages_for_late_joiners_without_making_them_before(world: Any) -> None:
    from rcl_interfaces.msg import Log

    from rclpy.qos import qos_profile_rosout_default

    node = world.node("n")
    node.get_logger().warning("early")
    heard: list[Any] = []
    node.create_subscription(Log, "/rosout", heard.append, qos_profile_rosout_default)
    node.get_logger().error("late")
    world.settle()
    assert [(log.level, log.name, log.msg) for log in heard] == [(30, "n", "early"), (40, "n", "late")]
    assert heard[0].file == __file__


def test_a_service_call_is_answered_and_its_future_carries_the_response(world: Any) -> None:
    from std_srvs.srv import SetBool

    node = world.node("n")

    def serve(request: Any, response: Any) -> Any:
        response.success = request.data
        return response

    node.create_service(SetBool, "s", serve)
    client = node.create_client(SetBool, "s")
    assert client.wait_for_service(0)
    assert world.until(client.call_async(SetBool.Request(data=True))).success is True


def test_an_action_runs_from_goal_to_result_with_feedback(world: Any) -> None:
    from example_interfaces.action import Fibonacci

    from rclpy.action import ActionClient, ActionServer

    node = world.node("n")

    def execute(goal_handle: Any) -> Any:
        sequence = [0, 1]
        while len(sequence) < goal_handle.request.order:
            sequence.append(sequence[-1] + sequence[-2])
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
        goal_handle.succeed()
        return Fibonacci.Result(sequence=sequence)

    server = ActionServer(node, Fibonacci, "fib", execute)
    client: Any = ActionClient(node, Fibonacci, "fib")
    feedback: list[list[int]] = []
    sent = client.send_goal_async(
        Fibonacci.Goal(order=5), feedback_callback=lambda message: feedback.append(list(message.feedback.sequence))
    )
    goal = world.until(sent)
    result = world.until(goal.get_result_async())
    assert (result.status, list(result.result.sequence)) == (4, [0, 1, 1, 2, 3])
    assert feedback == [[0, 1, 1], [0, 1, 1, 2], [0, 1, 1, 2, 3]]
    server.destroy()
    assert not client.server_is_ready()


def test_a_result_is_forgotten_after_its_timeout(world: Any) -> None:
    from example_interfaces.action import Fibonacci

    from rclpy.action import ActionClient, ActionServer

    node = world.node("n")

    def execute(goal_handle: Any) -> Any:
        goal_handle.succeed()
        return Fibonacci.Result()

    ActionServer(node, Fibonacci, "fib", execute, result_timeout=10)
    client: Any = ActionClient(node, Fibonacci, "fib")
    goal = world.until(client.send_goal_async(Fibonacci.Goal(order=1)))
    world.run(9.9)
    assert world.until(goal.get_result_async()).status == 4
    world.run(0.2)
    assert world.until(goal.get_result_async()).status == 0


def test_a_destroyed_node_stays_in_the_graph_until_its_action_server_goes(world: Any) -> None:
    """So does a real one: the server holds the node."""
    node = world.node("worker")
    server = ActionServer(node, Fibonacci, "count", lambda _goal: Fibonacci.Result())
    client = ActionClient(world.node("asker"), Fibonacci, "count")
    node.destroy_node()
    assert client.server_is_ready()
    server.destroy()
    assert not client.server_is_ready()
    assert [each.name for each in world.graph.nodes] == ["asker"]


def test_shutdown_takes_away_what_an_action_server_kept(world: Any) -> None:
    node = world.node("worker")
    server = ActionServer(node, Fibonacci, "count", lambda _goal: Fibonacci.Result())
    node.destroy_node()
    assert world.graph.nodes
    world.context.shutdown()
    assert not world.graph.nodes
    assert server is not None


def test_a_timer_leaves_out_the_calls_a_busy_program_missed(world: Any) -> None:
    node = world.node("busy")
    calls: list[int] = []
    timer = node.create_timer(1.0, lambda: calls.append(world.time.elapsed))
    world.time.elapsed += 3_000_000_000
    world.settle()
    assert calls == [3_000_000_000]
    assert timer.time_until_next_call() == 1_000_000_000


@pytest.mark.parametrize(
    ("value", "level", "told"),
    [
        (None, "DEBUG", "Parameter start_type_description_service not set, defaulting to true."),
        (5, "ERROR", "Invalid type for parameter 'start_type_description_service' <Type.INTEGER: 2> should be bool"),
    ],
)
def test_a_parameter_that_is_no_truth_value_starts_no_type_description(
    world: Any, value: Any, level: str, told: str
) -> None:
    from rcl_interfaces.msg import ParameterDescriptor

    from rclpy.logging import LoggingSeverity
    from rclpy.node import Node
    from rclpy.type_description_service import TypeDescriptionService

    class Undecided(Node):
        """Has another value for the parameter than the service expects."""

        def has_parameter(self, name: str) -> bool:
            if name == "start_type_description_service" and not super().has_parameter(name):
                self.get_logger().set_level(LoggingSeverity.DEBUG)
                self.declare_parameter(name, value, ParameterDescriptor(dynamic_typing=True))
            return super().has_parameter(name)

    node = Undecided("n", context=world.context)
    assert any(f"[{level}]" in line and told in line for line in world.log), world.log
    assert "/n/get_type_description" not in dict(node.get_service_names_and_types())
    service = TypeDescriptionService(world.node("m"))
    assert service.enabled
    service.destroy()
    assert not service.enabled
