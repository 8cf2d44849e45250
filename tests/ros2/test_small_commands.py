"""Commands that few people need: multicast, security, extensions, doctor hello, service echo, action echo."""

from __future__ import annotations

import socket

import pytest

from day6_core.ros.ros2.cli.tree import command_names, verb_names


def has_multicast() -> bool:
    from day6_core.ros.ros2.cli.multicast import GROUP, member, send

    try:
        with member(GROUP, 49151) as receiver:
            send(b"?", GROUP, 49151, None)
            receiver.settimeout(0.5)
            return receiver.recv(10) == b"?"
    except OSError:
        return False


@pytest.mark.skipif(not has_multicast(), reason="this machine's network lets no multicast through")
def test_a_multicast_packet_arrives(machine):
    receiver = machine.start("multicast", "receive", "--port", "49152")
    assert receiver.stdout == "Waiting for UDP multicast datagram...\n"
    sent = machine.ros2("multicast", "send", "--port", "49152", "--ttl", "1")
    assert sent.stdout == "Sending one UDP multicast datagram...\n"
    for _ in range(100):
        receiver.step(0.1)
        if receiver.status is not None:
            break
    assert receiver.stdout.splitlines()[1].endswith(": 'Hello World!'")
    assert receiver.status == 0


def test_ctrl_c_ends_a_multicast_receiver_with_status_0(machine):
    try:
        receiver = machine.start("multicast", "receive", "--port", "49153")
    except OSError as error:
        pytest.skip(str(error))
    if receiver.status is not None:
        pytest.skip(receiver.stderr)
    receiver.interrupt()
    assert receiver.status == 0


def test_wrong_ports_are_told_by_the_parser(machine):
    result = machine.ros2("multicast", "send", "--port", "0")
    assert result.status == 2
    assert result.stderr.endswith("error: argument --port: value must be a positive integer\n")


@pytest.mark.parametrize("verb", verb_names("security"))
def test_security_says_what_it_cannot(machine, verb):
    assert machine.ros2("security", verb, "--help").status == 0
    words = {"create_permission": ["a", "b", "c"], "create_enclave": ["a", "b"], "create_key": ["a", "b"]}
    result = machine.ros2("security", verb, *words.get(verb, [] if verb == "generate_artifacts" else ["a"]))
    assert result.status == 1
    assert result.stderr.startswith(f"ros2 security {verb}: there is no security in day6-tui")


def test_every_command_and_verb_is_among_the_extensions(machine):
    listed = machine.ros2("extensions").stdout
    for command in command_names():
        assert f"\n  {command}: " in listed
        for verb in verb_names(command):
            assert f"\n  {verb}: " in listed
    points = machine.ros2("extension_points").stdout
    assert "ros2topic.verb: The extension point for 'topic' verb extensions\n" in points


def test_doctor_hello_prints_its_table(machine):
    result = machine.ros2("doctor", "hello", "--once")
    if "OSError" in result.stderr:
        pytest.skip(result.stderr)
    assert result.status == 0
    assert result.stdout.startswith(
        "MULTIMACHINE COMMUNICATION SUMMARY\nTopic: /canyouhearme, Published Msg Count: 1\nSubscribed from:\n"
    )
    assert socket.gethostname() not in result.stdout


def test_service_echo_shows_both_sides_of_a_call(machine):
    machine.run("demo_nodes_py", "introspection")
    machine.ros2("param", "set", "/introspection_service", "service_configure_introspection", "contents")
    echo = machine.start("service", "echo", "--flow-style", "/add_two_ints")
    echo.step(2.5)
    assert "event_type: REQUEST_RECEIVED\n" in echo.stdout
    assert "request: [{a: 2, b: 3}]\nresponse: []\n---\n" in echo.stdout
    assert "request: []\nresponse: [{sum: 5}]\n---\n" in echo.stdout
    echo.interrupt()
    assert echo.status == 2


def test_service_echo_says_when_nobody_tells(machine):
    machine.run("demo_nodes_py", "add_two_ints_server")
    echo = machine.start("service", "echo", "/add_two_ints")
    assert echo.stdout == (
        "No publishers on topic '/add_two_ints/_service_event'; is service introspection on the client or server "
        "enabled?\n"
    )
    echo.interrupt()
    assert machine.ros2("service", "echo", "/nope").stderr == "Cannot find type for '/nope'\n"


def test_action_echo_shows_feedback_and_status(machine):
    machine.run("action_tutorials_py", "fibonacci_action_server")
    echo = machine.start("action", "echo", "/fibonacci", "-i", "feedback_topic")
    echo.step(0.5)
    machine.ros2("action", "send_goal", "/fibonacci", "example_interfaces/action/Fibonacci", "{order: 3}")
    assert "interface: FEEDBACK_TOPIC\ngoal_id:\n" in echo.stdout
    assert "STATUS_TOPIC" not in echo.stdout
    wrong = machine.ros2("action", "echo", "/fibonacci", "-i", "feedback|nope")
    assert (wrong.status, wrong.stderr) == (1, '"feedback" is incorrect interface name.\n')
