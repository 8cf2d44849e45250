"""What Tab offers behind `ros2`."""

from __future__ import annotations


def test_commands_and_verbs_are_offered_but_not_the_hidden_ones(machine):
    assert "topic" in machine.complete("")
    assert "extensions" not in machine.complete("")
    assert machine.complete("to") == ["topic"]
    assert machine.complete("topic", "e") == ["echo"]
    assert machine.complete("topics", "") == []


def test_options_are_offered_once_a_dash_was_typed(machine):
    assert "--once" in machine.complete("topic", "echo", "--o")
    assert machine.complete("topic", "echo", "--qos-reliability", "re") == ["reliable"]


def test_interface_types_and_packages_are_offered(machine):
    assert machine.complete("interface", "show", "std_msgs/msg/Str") == ["std_msgs/msg/String"]
    assert machine.complete("interface", "package", "std_s") == ["std_srvs"]


def test_what_belongs_to_the_program_itself_is_not_completed(machine):
    assert machine.complete("run", "turtlesim", "turtlesim_node", "--") == []
