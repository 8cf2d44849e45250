"""What Tab offers behind `ros2`."""

from __future__ import annotations

from std_msgs.msg import String
from std_srvs.srv import SetBool


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


def test_what_is_in_the_graph_is_offered(machine):
    def build(node):
        node.create_publisher(String, "chatter", 10)
        node.create_service(SetBool, "switch", lambda request, response: response)
        node.declare_parameter("speed", 1)

    machine.node("robot", build)
    assert machine.complete("topic", "echo", "/ch") == ["/chatter"]
    assert machine.complete("topic", "pub", "/chatter", "") == ["std_msgs/msg/String"]
    assert machine.complete("topic", "pub", "/chatter", "std_msgs/msg/String", "") == ["{data: ''}"]
    assert machine.complete("node", "info", "") == ["/robot"]
    assert machine.complete("service", "call", "/sw") == ["/switch"]
    assert machine.complete("service", "call", "/switch", "") == ["std_srvs/srv/SetBool"]
    assert machine.complete("param", "get", "/robot", "sp") == ["speed"]
    assert machine.complete("param", "get", "/nobody", "") == []
    assert "_ros2cli" not in str(machine.graph.nodes)


def test_packages_and_executables_are_offered(machine):
    assert machine.complete("run", "turtles") == ["turtlesim"]
    assert machine.complete("run", "turtlesim", "turtle_") == ["turtle_teleop_key"]
    assert machine.complete("run", "nope", "") == []


def test_fields_are_offered_part_by_part(machine):
    from geometry_msgs.msg import Twist

    machine.node("robot", lambda node: node.create_publisher(Twist, "cmd_vel", 10))
    assert machine.complete("topic", "echo", "/cmd_vel", "--field", "") == ["angular", "linear"]
    assert machine.complete("topic", "echo", "/cmd_vel", "--field", "linear.") == ["linear.x", "linear.y", "linear.z"]
    assert machine.complete("topic", "echo", "/cmd_vel", "--field", "linear.x.") == []
    assert machine.complete("topic", "echo", "/nobody", "--field", "") == []
