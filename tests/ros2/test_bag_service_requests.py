"""`ros2 bag play --publish-service-requests`: recorded calls are sent to the server again."""

from __future__ import annotations

import pytest
from example_interfaces.srv import AddTwoInts

from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
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
