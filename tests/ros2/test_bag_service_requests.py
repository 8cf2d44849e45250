"""`ros2 bag play --publish-service-requests`, `--send-actions-as-client`: recorded calls are sent to the server again."""

from __future__ import annotations

import pytest
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts

from rclpy.action import ActionClient, ActionServer, CancelResponse
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.task import Future
from tests.ros2.bag_commands import lines, play, record, wait_for_end


def adding(machine, state=ServiceIntrospectionState.CONTENTS):
    """Record a client that calls a server twice a second; return what the server is asked from then on, the number of calls
    and the server's node."""
    asked = []

    def serve(node):
        def add(request, response):
            asked.append((request.a, request.b))
            response.sum = request.a + request.b
            return response

        service = node.create_service(AddTwoInts, "add_two_ints", add)
        service.configure_introspection(node.get_clock(), qos_profile_system_default, state)

    def call(node):
        client = node.create_client(AddTwoInts, "add_two_ints")
        client.configure_introspection(node.get_clock(), qos_profile_system_default, state)
        node.calling = node.create_timer(0.5, lambda: client.call_async(AddTwoInts.Request(a=2, b=3)))

    server = machine.node("server", serve)
    caller = machine.node("caller", call)
    record(machine, "--services", "/add_two_ints")
    caller.destroy_timer(caller.calling)
    recorded = len(asked)
    asked.clear()
    return asked, recorded, server


@pytest.mark.parametrize("source", ("service", "client"))
def test_recorded_calls_reach_the_server_again(machine, source):
    asked, recorded, _ = adding(machine)
    command = play(machine, "--publish-service-requests", "--service-requests-source", f"{source}_introspection")
    wait_for_end(command)
    assert recorded >= 3 and asked == [(2, 3)] * recorded
    assert command.status == 0 and "ERROR" not in command.stderr


def test_without_the_option_events_are_published_and_nobody_is_called(machine):
    asked, _, _ = adding(machine)
    wait_for_end(play(machine))
    assert asked == []


def test_a_service_that_is_not_there_is_told_for_each_call(machine):
    _, recorded, server = adding(machine)
    server.destroy_node()
    command = play(machine, "--publish-service-requests")
    wait_for_end(command)
    told = "[ERROR] [rosbag2_player]: Service request hasn't been sent. The '/add_two_ints' service isn't ready !"
    assert lines(command.stderr).count(told) == recorded


def test_calls_recorded_without_contents_are_told_once(machine):
    asked, _, _ = adding(machine, ServiceIntrospectionState.METADATA)
    command = play(machine, "--publish-service-requests")
    wait_for_end(command)
    told = "Can't send service request. The configuration of introspection for '/add_two_ints' was metadata only on service side!"
    assert asked == [] and command.stderr.count(told) == 1


def counting(machine, cancels=False):
    """Record a client whose goal succeeds, or is cancelled; return what the server was asked for from then on."""
    done = []

    def serve(node):
        async def count(goal):
            goal.publish_feedback(Fibonacci.Feedback(sequence=[0, 1]))
            while cancels and not goal.is_cancel_requested:
                await moment(node)
            if cancels:
                goal.canceled()
            else:
                goal.succeed()
            done.append(("canceled" if cancels else "succeeded", goal.request.order, bytes(goal.goal_id.uuid)))
            return Fibonacci.Result(sequence=[goal.request.order])

        server = ActionServer(node, Fibonacci, "count", count, cancel_callback=lambda _: CancelResponse.ACCEPT)
        server.configure_introspection(node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS)

    def ask(node):
        client = ActionClient(node, Fibonacci, "count")

        def accepted(future):
            if cancels:
                future.result().cancel_goal_async()
            future.result().get_result_async()

        node.asking = client.send_goal_async(Fibonacci.Goal(order=7))
        node.asking.add_done_callback(accepted)

    machine.node("server", serve)
    command = machine.start("bag", "record", "-o", "bag", "--actions", "/count")
    command.step(1.0)
    machine.node("caller", ask)
    command.step(1.0)
    command.interrupt()
    recorded = list(done)
    done.clear()
    return done, recorded


async def moment(node):
    ended = Future()
    timer = node.create_timer(0.1, lambda: ended.set_result(None) if not ended.done() else None)
    await ended
    node.destroy_timer(timer)


@pytest.mark.parametrize("cancels", [False, True])
def test_recorded_goals_reach_the_server_again_as_new_ones(machine, in_distribution, cancels):
    in_distribution("kilted")
    done, recorded = counting(machine, cancels)
    wait_for_end(play(machine, "--send-actions-as-client"))
    machine.step(1.0)
    assert (
        [each[:2] for each in done] == [each[:2] for each in recorded] == [("canceled" if cancels else "succeeded", 7)]
    )
    assert done[0][2] != recorded[0][2]


def test_goals_are_left_out_with_their_action_and_without_the_option(machine, in_distribution):
    in_distribution("kilted")
    done, _ = counting(machine)
    wait_for_end(play(machine))
    wait_for_end(play(machine, "--send-actions-as-client", "--exclude-actions", "/count"))
    wait_for_end(play(machine, "--send-actions-as-client", "--actions", "/other"))
    machine.step(1.0)
    assert done == []
    wait_for_end(play(machine, "--send-actions-as-client", "--actions", "/count"))
    machine.step(1.0)
    assert len(done) == 1


def test_info_tells_of_actions(machine, in_distribution):
    in_distribution("kilted")
    counting(machine)
    head, _, told = machine.ros2("bag", "info", "bag").stdout.partition("Messages:")
    assert head and told.rstrip("\n").splitlines() == [
        "          0",
        "Topic information: ",
        "Services:          0",
        "Service information: ",
        "Actions:           1",
        "Action information: ",
        "  Action: /count | Type: example_interfaces/action/Fibonacci | Topics: 2 | Service: 3 | Serialization Format: cdr",
        "    Topic: feedback | Count: 1",
        "    Topic: status | Count: 3",
        "    Service: send_goal | Event Count: 2",
        "    Service: cancel_goal | Event Count: 0",
        "    Service: get_result | Event Count: 2",
    ]
    told = machine.ros2("bag", "info", "-v", "bag").stdout
    assert "    Service: send_goal | Request Count: 1 | Response Count: 1\n" in told
