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


def test_the_arguments_that_a_launch_file_declares_are_offered_with_their_values(machine):
    line = ("launch", "day6_bot", "display.launch.py")
    assert machine.complete("launch", "day6_b") == ["day6_bot"]
    assert machine.complete("launch", "day6_bot", "") == ["car.launch.py", "display.launch.py"]
    assert machine.complete(*line, "") == ["robot:=", "rviz_config:=", "sliders:=", "spin:="]
    assert machine.complete(*line, "spin:=false", "s") == ["sliders:="]
    assert machine.complete(*line, "spin:=") == ["spin:=false", "spin:=true"]
    assert machine.complete(*line, "nothing:=") == []


def test_arguments_of_launch_files_in_python_xml_and_yaml_are_found_without_running_them(machine):
    from day6_core.ros.ros2.launch._declared import declared_arguments

    folder = machine.cwd
    (folder / "a.launch.py").write_text(
        "raise SystemExit('was run')\n"
        "launch.actions.DeclareLaunchArgument(name='speed', choices=['slow', 'fast'], default_value='slow')\n"
        "DeclareLaunchArgument(computed, default_value='x')\nDeclareLaunchArgument('gui', default_value='True')\n"
    )
    (folder / "b.launch.xml").write_text(
        '<launch><arg name="use_sim_time" default="false"/><arg name="mode"><choice value="a"/></arg>'
        '<include file="c.xml"><arg name="theirs" value="1"/></include>'
        '<arg name="file" default="$(find-pkg-share x)/f"/></launch>'
    )
    (folder / "c.launch.yaml").write_text(
        "launch:\n- arg:\n    name: gui\n    default: true\n- node: {pkg: p, exec: e}\n"
    )
    (folder / "d.launch.py").write_text("def broken(:\n")
    found = {
        name: declared_arguments(folder / name)
        for name in ["a.launch.py", "b.launch.xml", "c.launch.yaml", "d.launch.py"]
    }
    assert found == {
        "a.launch.py": [("speed", ("slow", "fast")), ("gui", ("True", "false"))],
        "b.launch.xml": [("use_sim_time", ("false", "true")), ("mode", ("a",)), ("file", ())],
        "c.launch.yaml": [("gui", ("true", "false"))],
        "d.launch.py": [],
    }
    assert machine.complete("launch", "a.l") == ["a.launch.py"]
    assert machine.complete("launch", "a.launch.py", "sp") == ["speed:="]
    assert machine.complete("launch", "a.launch.py", "gui:=True", "speed:=f") == ["speed:=fast"]
