"""`ros2 node`, `ros2 service`, `ros2 action`, `ros2 daemon`, `ros2 doctor` on a stepped machine."""

from __future__ import annotations

import re

import pytest
from std_msgs.msg import String
from std_srvs.srv import SetBool

from day6_core.graph.names import OBSERVER_PREFIX


def server(node):
    def answer(request, response):
        response.success = request.data
        response.message = "开"
        return response

    node.create_service(SetBool, "switch", answer)


# -- node --------------------------------------------------------------------------------------------------------------


def test_nodes_are_sorted_and_equal_names_are_warned_of(machine):
    for name in ("twin", "alone", "twin"):
        machine.node(name)
    result = machine.ros2("node", "list")
    assert result.stdout == "/alone\n/twin\n/twin\n"
    assert result.stderr.startswith("WARNING: Be aware that there are nodes in the graph that share an exact name,")
    assert machine.ros2("node", "info", "/twin").stderr == (
        'There are 2 nodes in the graph with the exact name "/twin". You are seeing information about only one of them.\n'
    )


def test_info_lists_everything_a_node_has_in_a_namespace(machine):
    def build(node):
        node.create_publisher(String, "said", 10)
        node.create_subscription(String, "~/heard", print, 10)
        server(node)

    machine.node("arm", build, namespace="/robot")
    text = machine.ros2("node", "info", "/robot/arm").stdout
    assert text.startswith("/robot/arm\n  Subscribers:\n    /robot/arm/heard: std_msgs/msg/String\n  Publishers:\n")
    assert "    /robot/said: std_msgs/msg/String\n" in text
    assert "    /robot/switch: std_srvs/srv/SetBool\n" in text
    assert text.endswith("  Service Clients:\n\n  Action Servers:\n\n  Action Clients:\n\n")


def test_a_node_must_be_named_in_full(machine):
    machine.node("talker")
    assert machine.ros2("node", "info", "talker") == ("", "Unable to find node 'talker'\n", 1)


# -- service -----------------------------------------------------------------------------------------------------------


def test_a_call_prints_request_and_response(machine):
    machine.node("server", server)
    result = machine.ros2("service", "call", "/switch", "std_srvs/srv/SetBool", "{data: true}")
    assert (result.status, result.stderr) == (0, "")
    assert result.stdout == (
        "requester: making request: std_srvs.srv.SetBool_Request(data=True)\n\n"
        "response:\nstd_srvs.srv.SetBool_Response(success=True, message='开')\n\n"
    )


def test_a_call_waits_for_its_service_and_can_be_interrupted(machine):
    call = machine.start("service", "call", "switch", "std_srvs/SetBool")
    call.step(1.0)
    assert call.stdout == "waiting for service to become available...\n"
    machine.node("server", server)
    call.step(0.2)
    assert call.status == 0
    other = machine.start("service", "call", "/nope", "std_srvs/srv/Empty")
    other.interrupt()
    assert other.status == 2


def test_a_call_can_be_repeated_at_a_rate(machine):
    machine.node("server", server)
    call = machine.start("service", "call", "-r", "2", "/switch", "std_srvs/srv/SetBool")
    call.step(1.9)
    assert call.stdout.count("response:") == 4
    call.interrupt()
    assert call.status == 2


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["SetBool"], "The passed service type is invalid\n"),
        (["std_msgs/msg/String"], "The passed type is not a service\n"),
        (
            ["std_srvs/srv/SetBool", "{dat: 1}"],
            "Failed to populate field: 'SetBool_Request' object has no attribute 'dat'\n",
        ),
        (["std_srvs/srv/SetBool", "{off: 1}"], "Failed to populate field: attribute name must be string, not 'bool'\n"),
        (["-r", "0", "std_srvs/srv/SetBool"], "rate must be greater than zero\n"),
    ],
)
def test_wrong_calls(machine, words, error):
    machine.node("server", server)
    assert machine.ros2("service", "call", "/switch", *words)[1:] == (error, 1)


def test_lists_types_and_counts_of_services(machine):
    machine.node("server", server)
    assert "/switch [std_srvs/srv/SetBool]\n" in machine.ros2("service", "list", "-t").stdout
    assert machine.ros2("service", "type", "/switch").stdout == "std_srvs/srv/SetBool\n"
    assert machine.ros2("service", "find", "std_srvs/srv/SetBool").stdout == "/switch\n"
    assert machine.ros2("service", "info", "/switch").stdout == (
        "Type: std_srvs/srv/SetBool\nClients count: 0\nServices count: 1\n"
    )
    assert machine.ros2("service", "type", "/nope").status == 1


# -- action ------------------------------------------------------------------------------------------------------------


def turner(node):
    """An action server that turns for a second and tells of it four times."""
    from turtlesim.action import RotateAbsolute

    from rclpy.action import ActionServer, CancelResponse

    async def turn(handle):
        feedback = RotateAbsolute.Feedback()
        for step in range(4):
            feedback.remaining = float(step)
            handle.publish_feedback(feedback)
            pause = node.executor.create_future()
            timer = node.create_timer(0.25, lambda pause=pause: pause.set_result(None))
            await pause
            node.destroy_timer(timer)
            if handle.is_cancel_requested:
                node.cancelled = True
                handle.canceled()
                return RotateAbsolute.Result()
        handle.succeed()
        return RotateAbsolute.Result(delta=0.5)

    node.cancelled = False
    node.server = ActionServer(
        node, RotateAbsolute, "turn", execute_callback=turn, cancel_callback=lambda goal: CancelResponse.ACCEPT
    )


def test_a_goal_is_followed_to_its_result_with_feedback(machine):
    machine.node("turner", turner)
    result = machine.ros2("action", "send_goal", "-f", "/turn", "turtlesim/action/RotateAbsolute", "{theta: 1}")
    head, _, rest = result.stdout.partition("Goal accepted with ID: ")
    assert head == "Waiting for an action server to become available...\nSending goal:\n     theta: 1.0\n\n"
    assert rest[32:] == "\n\n" + "".join(f"Feedback:\n    remaining: {n}.0\n\n" for n in range(4)) + (
        "Result:\n    delta: 0.5\n\nGoal finished with status: SUCCEEDED\n"
    )
    assert result.status == 0


def test_ctrl_c_cancels_the_goal(machine):
    node = machine.node("turner", turner)
    goal = machine.start("action", "send_goal", "/turn", "turtlesim/action/RotateAbsolute", "{theta: 1}")
    goal.step(0.3)
    goal.interrupt()
    goal.step(0.5)
    assert goal.stdout.endswith("\n\nCanceling goal...\n")
    assert (goal.stderr, goal.status) == ("Exception while canceling goal: None\n", 1)
    assert node.cancelled


def test_lists_and_info_of_actions(machine):
    machine.node("turner", turner)
    assert machine.ros2("action", "list", "-t").stdout == "/turn [turtlesim/action/RotateAbsolute]\n"
    assert machine.ros2("action", "info", "/turn").stdout == (
        "Action: /turn\nAction clients: 0\nAction servers: 1\n    /turner\n"
    )
    assert machine.ros2("action", "info", "turn", "-c").stdout == "Action: turn\nAction clients: 0\nAction servers: 1\n"
    assert machine.ros2("action", "type", "/turn").stdout == "turtlesim/action/RotateAbsolute\n"
    assert machine.ros2("action", "find", "turtlesim/action/RotateAbsolute").stdout == "/turn\n"
    assert "/turn: turtlesim/action/RotateAbsolute" in machine.ros2("node", "info", "/turner").stdout


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["Nope"], "The passed action type is invalid\n"),
        (
            ["turtlesim/action/RotateAbsolute", "{angle: 1}"],
            "Failed to populate message fields: AttributeError(\"'RotateAbsolute_Goal' object has no attribute 'angle'\")\n",
        ),
    ],
)
def test_wrong_goals(machine, words, error):
    assert machine.ros2("action", "send_goal", "/turn", *words) == ("", error, 1)


# -- daemon, doctor ----------------------------------------------------------------------------------------------------


def test_the_daemon_is_a_hidden_node_that_commands_start_where_it_can_live(machine):
    machine.daemon = True
    assert machine.ros2("daemon", "status").stdout == "The daemon is not running\n"
    assert machine.ros2("topic", "list").stdout == "/parameter_events\n/rosout\n"
    assert machine.ros2("daemon", "status").stdout == "The daemon is running\n"
    assert machine.ros2("daemon", "start").stdout == "The daemon is already running\n"
    assert machine.ros2("node", "list", "-a").stdout.startswith("/_ros2cli_daemon_0_")
    assert machine.ros2("node", "list").stdout == ""
    assert machine.ros2("service", "list", "--include-hidden-services").stdout == "", "it serves nothing"
    assert machine.ros2("daemon", "stop").stdout == "The daemon has been stopped\n"
    assert machine.ros2("daemon", "stop").stdout == "The daemon is not running\n"
    assert machine.ros2("daemon", "start").stdout == "The daemon has been started\n"
    machine.ros2("daemon", "stop")


def test_without_a_desktop_a_command_asks_by_a_node_of_its_own(machine):
    assert machine.ros2("node", "list", "-a").stdout.startswith("/_ros2cli_1")
    assert machine.graph.nodes == ()


def test_beside_a_daemon_of_another_process_a_command_has_no_node_that_is_seen(machine):
    machine.graph.create_node("_ros2cli_daemon_0_1234")
    assert machine.ros2("node", "list", "-a").stdout == "/_ros2cli_daemon_0_1234\n"
    assert machine.ros2("node", "list", "-a", "--no-daemon").stdout.startswith("/_ros2cli_1")
    assert machine.ros2("topic", "list").stdout == ""
    assert machine.ros2("daemon", "start").stdout == "The daemon is already running\n"


def test_doctor_passes_a_sound_graph_and_names_what_is_wrong(machine):
    assert machine.ros2("doctor", "-ep").stdout == "\nAll 3 checks passed\n\n"
    machine.node("talker", lambda node: node.create_publisher(String, "chatter", 10))
    result = machine.ros2("wtf", "-iw")
    assert "\nFailed modules: " in result.stdout
    assert "UserWarning: Publisher without subscriber detected on /chatter.\n" in result.stderr
    assert "publisher count     : 1\n" in machine.ros2("doctor", "--report").stdout


def test_doctor_reports_this_machine_its_network_and_its_packages(machine):
    import platform
    import socket

    report = machine.ros2("doctor", "--report").stdout
    titles = [line.strip() for line in report.splitlines() if line.startswith("   ")]
    assert titles == [
        "NETWORK CONFIGURATION",
        "PACKAGE VERSIONS",
        "PLATFORM INFORMATION",
        "QOS COMPATIBILITY LIST",
        "RMW MIDDLEWARE",
        "ROS 2 INFORMATION",
        "TOPIC LIST",
    ]
    for _, name in socket.if_nameindex():
        assert re.search(rf"^device +: {re.escape(name)}$", report, re.M)
    if platform.system() == "Linux":
        assert "inet         : 127.0.0.1\n" in report and "flags        : UP,LOOPBACK,RUNNING\n" in report
    assert f"release          : {platform.release()}\n" in report
    assert "latest=N/A, local=" in next(line for line in report.splitlines() if line.startswith("turtlesim "))
    assert "PACKAGE VERSIONS" not in machine.ros2("doctor", "--report", "-ep").stdout


def test_who_only_looks_on_is_in_no_list_and_no_count(machine):
    heard = []
    machine.node(OBSERVER_PREFIX, lambda node: node.create_subscription(String, "/chatter", heard.append, 10))
    assert "/chatter" not in machine.ros2("topic", "list", "--include-hidden-topics").stdout
    pub = machine.start("topic", "pub", "--once", "/chatter", "std_msgs/msg/String", "{data: hello}")
    pub.step(2.0)
    assert "Waiting for at least 1 matching subscription(s)..." in pub.stdout and pub.status is None
    assert heard == []
    machine.node("listener", lambda node: node.create_subscription(String, "/chatter", print, 10))
    pub.step(4.0)
    assert pub.status == 0 and [message.data for message in heard] == ["hello"]
    machine.daemon = True
    assert machine.ros2("node", "list").stdout == "/listener\n"
    assert OBSERVER_PREFIX not in machine.ros2("node", "list", "-a").stdout
    assert "Subscription count: 1" in machine.ros2("topic", "info", "-v", "/chatter").stdout
