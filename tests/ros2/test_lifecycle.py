"""`ros2 lifecycle`, on the talker of the tutorial."""

from __future__ import annotations

import pytest


@pytest.fixture
def talker(machine):
    return machine.run("lifecycle", "lifecycle_talker")


def test_a_node_is_led_through_its_life(machine, talker):
    assert machine.ros2("lifecycle", "nodes").stdout == "/lc_talker\n"
    assert machine.ros2("lifecycle", "get", "/lc_talker").stdout == "unconfigured [1]\n"
    for transition, state in (("configure", "inactive [2]"), ("3", "active [3]"), ("deactivate", "inactive [2]")):
        assert machine.ros2("lifecycle", "set", "lc_talker", transition).stdout == "Transitioning successful\n"
        assert machine.ros2("lifecycle", "get").stdout == f"/lc_talker: {state}\n"
    assert "on_activate() is called." in talker.stderr.text


def test_only_what_is_possible_now_is_listed(machine, talker):
    listed = machine.ros2("lifecycle", "list", "/lc_talker").stdout
    assert listed == (
        "- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n"
        "- shutdown [5]\n\tStart: unconfigured\n\tGoal: shuttingdown\n"
    )
    assert machine.ros2("lifecycle", "list", "-a", "/lc_talker").stdout.count("Goal:") > 20
    wrong = machine.ros2("lifecycle", "set", "/lc_talker", "activate")
    assert (wrong.status, wrong.stderr) == (
        1,
        "Unknown transition requested, available ones are:\n- configure [1]\n- shutdown [5]\n",
    )


def test_a_transition_that_cannot_be_is_told_in_the_words_of_rclcpp(machine, talker):
    for transition in ("{id: 2}", "{label: nonsense}"):
        called = machine.ros2(
            "service",
            "call",
            "/lc_talker/change_state",
            "lifecycle_msgs/srv/ChangeState",
            f"{{transition: {transition}}}",
        )
        assert "ChangeState_Response(success=False)" in called.stdout
    said = [line.partition("] ")[2].partition("] ")[2] for line in talker.stderr.text.splitlines()]
    reason = "Transition is not registered., at ./src/rcl_lifecycle.c:355"
    assert said == [
        "[rcl_lifecycle]: No transition matching 2 found for current state unconfigured",
        f"[lc_talker]: Unable to start transition 2 from current state unconfigured: {reason}",
        "[rcl_lifecycle]: No transition matching nonsense found for current state unconfigured",
    ]


def test_an_inactive_talker_is_not_heard(machine, talker):
    machine.ros2("lifecycle", "set", "/lc_talker", "configure")
    echo = machine.start("topic", "echo", "/lifecycle_chatter", "std_msgs/msg/String")
    echo.step(3.0)
    assert echo.stdout == ""
    machine.ros2("lifecycle", "set", "/lc_talker", "activate")
    echo.step(3.0)
    assert "Lifecycle HelloWorld #" in echo.stdout


@pytest.mark.parametrize("verb", [["get", "/x"], ["list", "/x"], ["set", "/x", "configure"]])
def test_an_unknown_node_is_told(machine, verb):
    result = machine.ros2("lifecycle", *verb)
    assert (result.status, result.stderr) == (1, "Node not found\n")


def test_the_tab_key_knows_lifecycle_nodes_and_what_they_can_do(machine, talker):
    machine.node("plain")
    assert machine.complete("lifecycle", "get", "") == ["/lc_talker"]
    assert machine.complete("lifecycle", "set", "/lc_talker", "") == ["configure", "shutdown"]


def test_the_service_client_leads_the_talker_to_its_end(machine, talker):
    client = machine.run("lifecycle", "lifecycle_service_client")
    machine.step(70.0)
    assert client.stderr.text.count("successfully triggered") == 7
    assert "on shutdown is called from state unconfigured." in talker.stderr.text
