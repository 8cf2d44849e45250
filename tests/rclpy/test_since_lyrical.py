"""What rclpy has, or does otherwise, since Lyrical: services' endpoints, actions in the graph, one spin, results from outside."""

from __future__ import annotations

import re
from collections.abc import Callable
from threading import Thread
from typing import Any

import pytest
from rcl_interfaces.msg import SetParametersResult
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci

from rclpy.action import ActionClient, ActionServer
from rclpy.endpoint_info import EndpointTypeEnum, ServiceEndpointInfo
from rclpy.exceptions import InvalidHandle
from rclpy.executors import Executor, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.experimental import EventsExecutor
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.qos import QoSProfile
from rclpy.task import Future
from rclpy.type_hash import TypeHash
from tests.support.waiting import until

EXECUTING, SUCCEEDED, ABORTED = 2, 4, 6


# the graph


def test_clients_and_servers_of_a_service_are_told(world: Any) -> None:
    one, two = world.node("one"), world.node("two", namespace="lab", cli_args=["--ros-args", "-r", "ask:=/serve"])
    one.create_service(Trigger, "serve", lambda _, response: response, qos_profile=QoSProfile(depth=7))
    two.create_client(Trigger, "/serve")
    world.settle()
    one.create_service(Trigger, "other", lambda _, response: response)
    (server,) = one.get_servers_info_by_service("serve")
    others = one.get_servers_info_by_service("other")
    (client,) = two.get_clients_info_by_service("/serve")
    assert two.get_clients_info_by_service("ask") == [client], "a remapped name"
    assert (server.node_name, server.node_namespace, server.service_type) == ("one", "/", "std_srvs/srv/Trigger")
    assert (client.node_name, client.node_namespace, client.service_type) == ("two", "/lab", "std_srvs/srv/Trigger")
    assert (server.endpoint_type, client.endpoint_type) == (EndpointTypeEnum.SERVER, EndpointTypeEnum.CLIENT)
    assert server.service_type_hash == client.service_type_hash != TypeHash()
    assert server.endpoint_count == len(server.endpoint_gids) == len(server.qos_profiles) == 2
    assert len({tuple(gid) for each in (server, client, *others) for gid in each.endpoint_gids}) == 6
    assert {len(gid) for gid in server.endpoint_gids} == {16}
    assert [each.depth for each in server.qos_profiles] == [7, 7]
    assert one.get_servers_info_by_service("nothing") == one.get_servers_info_by_service("serve", no_mangle=True) == []
    with pytest.raises(ValueError, match="must not start with a number"):
        one.get_servers_info_by_service("1st")
    two.destroy_node()
    world.settle()
    assert one.get_clients_info_by_service("serve") == []
    with pytest.raises(InvalidHandle):
        two.get_servers_info_by_service("serve")


def test_an_endpoint_of_a_service_is_a_text_and_takes_what_fits() -> None:
    profile = QoSProfile(depth=1)
    info = ServiceEndpointInfo(
        "n", "/", "a/srv/B", {"version": 1, "value": b"\1" * 32}, [profile, profile], [[1], [2]], 3, 2
    )
    lines = str(info).splitlines()
    assert lines[:6] == [
        *("Node name: n", "Node namespace: /", "Service type: a/srv/B", f"Service type hash: RIHS01_{'01' * 32}"),
        *("Endpoint type: CLIENT", "Endpoint count: 2"),
    ]
    assert lines[6:9] == ["GIDs:", "- Request Writer : 02", "- Response Reader : 01"]
    info.endpoint_count = 1
    assert "GID: 01\nQoS profile:\n  Reliability: RELIABLE\n  History (Depth): KEEP_LAST (1)" in str(info)
    assert info != ServiceEndpointInfo() == ServiceEndpointInfo()
    for name, wrong in (
        ("node_name", 5),
        ("qos_profiles", profile),
        ("endpoint_gids", [5]),
        ("endpoint_type", "CLIENT"),
    ):
        with pytest.raises(AssertionError):
            setattr(info, name, wrong)
    with pytest.raises(AttributeError):
        info.topic_type = "x"  # type: ignore[attr-defined]


def test_a_node_tells_of_actions(world: Any) -> None:
    asker, worker = world.node("asker"), world.node("worker", namespace="lab")
    server: Any = ActionServer(worker, Fibonacci, "count", lambda _: Fibonacci.Result())
    client: Any = ActionClient(asker, Fibonacci, "/lab/count")
    world.settle()
    expected = [("/lab/count", ["test_msgs/action/Fibonacci"])]
    assert asker.get_action_names_and_types() == expected
    assert asker.get_action_server_names_and_types_by_node("worker", "/lab") == expected
    assert asker.get_action_client_names_and_types_by_node("asker", "/") == expected
    assert asker.get_action_server_names_and_types_by_node("asker", "/") == []
    with pytest.raises(RuntimeError, match="Failed to get action client names and type"):
        asker.get_action_client_names_and_types_by_node("nobody", "/")
    server.destroy()
    client.destroy()


# executors


@pytest.mark.parametrize("name", ["jazzy", "lyrical"])
@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor, EventsExecutor])
def test_an_executor_spins_once_at_a_time(
    world: Any, in_distribution: Callable[[str], None], kind: Any, name: str
) -> None:
    in_distribution(name)
    executor = kind(context=world.context)
    assert not executor.is_spinning
    future: Future[Any] = Future()
    thread = Thread(target=executor.spin_until_future_complete, args=(future,))
    if name == "lyrical":
        thread.start()
        until(lambda: executor.is_spinning)
        for use in (
            executor.spin,
            executor.spin_once,
            lambda: executor.spin_until_future_complete(Future()),
            lambda: executor.spin_once_until_future_complete(Future()),
        ):
            with pytest.raises(RuntimeError, match=r"^Executor is already spinning$"):
                use()
        assert executor.is_spinning
        future.set_result(None)
        thread.join()
    executor.spin_once(timeout_sec=0)
    assert not executor.is_spinning
    executor.shutdown()


def test_a_callback_that_spins_its_executor_is_told_and_the_next_spin_goes_on(
    world: Any, in_distribution: Callable[[str], None]
) -> None:
    in_distribution("lyrical")
    executor = SingleThreadedExecutor(context=world.context)
    node = world.node("n")
    executor.add_node(node)
    node.create_guard_condition(lambda: executor.spin_once(timeout_sec=0)).trigger()
    with pytest.raises(RuntimeError, match="Executor is already spinning"):
        executor.spin_once(timeout_sec=0)
    executor.spin_once(timeout_sec=0)


class _Own(SingleThreadedExecutor):
    steps = 0

    def spin_once(self, timeout_sec: float | None = None) -> None:
        self.steps += 1
        self.shutdown()

    def _spin_once_impl(self, *_: Any) -> None:
        self.steps += 10
        self.shutdown()


@pytest.mark.parametrize(("name", "steps"), [("kilted", 1), ("lyrical", 10)])
def test_spinning_goes_another_way(world: Any, in_distribution: Callable[[str], None], name: str, steps: int) -> None:
    in_distribution(name)
    executor = _Own(context=world.context)
    executor.spin()
    assert executor.steps == steps
    with pytest.raises(NotImplementedError):
        Executor(context=world.context).spin()


# endpoints


def test_subscriptions_can_filter_by_content(world: Any) -> None:
    subscription = world.node("n").create_subscription(String, "t", lambda _: None, 1)
    assert subscription.is_cft_supported is True
    subscription.destroy()
    with pytest.raises(InvalidHandle):
        _ = subscription.is_cft_supported


def test_handles_call_back_when_something_comes(world: Any) -> None:
    node = world.node("n")
    told: list[tuple[str, int]] = []
    heard: list[str] = []
    publisher = node.create_publisher(String, "t", 5)
    subscription = node.create_subscription(String, "t", lambda message: heard.append(message.data), 5)
    service = node.create_service(Trigger, "s", lambda _, response: response)
    client = node.create_client(Trigger, "s")
    publisher.publish(String(data="early"))
    publisher.publish(String(data="early"))
    subscription.handle.set_on_new_message_callback(lambda number: told.append(("message", number)))
    service.handle.set_on_new_request_callback(lambda number: told.append(("request", number)))
    client.handle.set_on_new_response_callback(lambda number: told.append(("response", number)))
    assert told == [("message", 2)], "what waits already is told at once"
    publisher.publish(String(data="late"))
    client.call_async(Trigger.Request())
    world.settle()
    assert told[1:] == [("message", 1), ("request", 1), ("response", 1)]
    assert heard == ["early", "early", "late"], "the executor goes on"
    for clear in (
        subscription.handle.clear_on_new_message_callback,
        service.handle.clear_on_new_request_callback,
        client.handle.clear_on_new_response_callback,
    ):
        clear()
    publisher.publish(String(data="last"))
    client.call_async(Trigger.Request())
    world.settle()
    assert (len(told), heard[-1]) == (4, "last")
    with pytest.raises(TypeError):
        subscription.handle.set_on_new_message_callback(5)


def test_a_timers_handle_calls_back_when_it_is_reset(world: Any) -> None:
    timer = world.node("n").create_timer(1.0, lambda: None)
    told: list[int] = []
    timer.handle.set_on_reset_callback(told.append)
    timer.reset()
    timer.handle.clear_on_reset_callback()
    timer.reset()
    assert told == [1]


# actions


@pytest.mark.parametrize(("how", "status"), [("succeed", SUCCEEDED), ("abort", ABORTED)])
@pytest.mark.parametrize("given", [True, False])
def test_a_goal_is_ended_from_outside_of_a_callback(
    world: Any, in_distribution: Callable[[str], None], how: str, status: int, given: bool
) -> None:
    in_distribution("lyrical")
    node = world.node("n")
    kept: list[Any] = []
    ActionServer(node, Fibonacci, "count", handle_accepted_callback=kept.append)
    client: Any = ActionClient(node, Fibonacci, "count")
    handle = world.until(client.send_goal_async(Fibonacci.Goal(order=3)))
    kept[0].executing()
    result = handle.get_result_async()
    world.settle()
    assert (handle.status, result.done()) == (EXECUTING, False)
    getattr(kept[0], how)(*[Fibonacci.Result(sequence=[1, 2])] * given)
    answer = world.until(result)
    assert (answer.status, list(answer.result.sequence)) == (status, [1, 2] if given else [])
    assert world.log == []


def test_a_server_that_does_nothing_says_so(world: Any, in_distribution: Callable[[str], None]) -> None:
    in_distribution("lyrical")
    server = ActionServer(world.node("n"), Fibonacci, "count")
    assert (
        "[WARN]" in world.log[0] and "Not handling nor executing the goal, this server will do nothing" in world.log[0]
    )
    server.destroy()


def test_before_a_callback_had_to_execute(world: Any) -> None:
    node = world.node("n")
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'execute_callback'"):
        ActionServer(node, Fibonacci, "count")
    kept: list[Any] = []
    ActionServer(node, Fibonacci, "count", lambda _: Fibonacci.Result(), handle_accepted_callback=kept.append)
    client: Any = ActionClient(node, Fibonacci, "count")
    world.until(client.send_goal_async(Fibonacci.Goal(order=3)))
    with pytest.raises(TypeError, match=r"succeed\(\) takes 1 positional argument but 2 were given"):
        kept[0].succeed(Fibonacci.Result())


@pytest.mark.parametrize(("name", "heard"), [("jazzy", [1, 2, 3]), ("lyrical", [2])])
def test_feedback_is_of_goals_that_are_executing(
    world: Any, in_distribution: Callable[[str], None], name: str, heard: list[int]
) -> None:
    in_distribution(name)
    node = world.node("n")
    kept: list[Any] = []
    ActionServer(node, Fibonacci, "count", lambda _: Fibonacci.Result(), handle_accepted_callback=kept.append)
    client: Any = ActionClient(node, Fibonacci, "count")
    got: list[int] = []
    world.until(
        client.send_goal_async(
            Fibonacci.Goal(order=3), feedback_callback=lambda message: got.append(message.feedback.sequence[0])
        )
    )
    kept[0].publish_feedback(Fibonacci.Feedback(sequence=[1]))
    kept[0].executing()
    kept[0].publish_feedback(Fibonacci.Feedback(sequence=[2]))
    world.settle()
    kept[0].succeed()
    kept[0].publish_feedback(Fibonacci.Feedback(sequence=[3]))
    world.settle()
    assert got == heard
    assert len([line for line in world.log if "publish_feedback" in line and "[WARN]" in line]) == 3 - len(heard)


# parameters


@pytest.mark.parametrize("name", ["jazzy", "lyrical"])
def test_a_node_says_that_it_refused_a_parameter(world: Any, in_distribution: Callable[[str], None], name: str) -> None:
    in_distribution(name)
    robot, asker = world.node("robot"), world.node("asker")
    robot.declare_parameter("speed", 1)
    robot.add_on_set_parameters_callback(
        lambda parameters: SetParametersResult(successful=parameters[0].value < 5, reason="too fast")
    )
    client = AsyncParameterClient(asker, "robot")
    for speed in (2, 9):
        world.until(client.set_parameters([Parameter("speed", value=speed)]))
    world.until(client.set_parameters_atomically([Parameter("unknown", value=1)]))
    said = [line for line in world.log if "[WARN]" in line]
    if name == "jazzy":
        assert said == []
    else:
        assert [bool(re.search(r"\[robot\]: .*'speed'.*too fast", line)) for line in said] == [True, False]
        assert "unknown" in said[1]
