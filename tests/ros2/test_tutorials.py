"""The tutorials "Beginner: CLI tools", page by page: each command that a page shows, answered as the page shows it.

rqt_console's page needs a window and is tried in tests/tui; the pages about launch and bags have tests of their own and are
only touched here.
"""

from __future__ import annotations

import pytest

from tests.ros2.ros2_machine import IdleKeyboard

TURTLE_TOPICS = """\
/parameter_events [rcl_interfaces/msg/ParameterEvent]
/rosout [rcl_interfaces/msg/Log]
/turtle1/cmd_vel [geometry_msgs/msg/Twist]
/turtle1/color_sensor [turtlesim/msg/Color]
/turtle1/pose [turtlesim/msg/Pose]
"""


class Tutorial:
    """A machine on which turtlesim and its keyboard run, as after the first page."""

    def __init__(self, machine) -> None:
        self.machine = machine
        self.turtlesim = machine.run("turtlesim", "turtlesim_node")
        self.teleop = machine.run("turtlesim", "turtle_teleop_key", stdin=IdleKeyboard())

    def __call__(self, line: str, **keywords) -> str:
        """Type a line as the page shows it; it must end well. Returns what it prints."""
        import shlex

        words = shlex.split(line)
        assert words[0] == "ros2"
        result = self.machine.ros2(*words[1:], **keywords)
        assert (result.status, result.stderr) == (0, ""), line
        return result.stdout


@pytest.fixture
def tutorial(machine) -> Tutorial:
    machine.daemon = True
    return Tutorial(machine)


def test_using_turtlesim_and_rqt(tutorial):
    assert tutorial("ros2 pkg executables turtlesim") == (
        "turtlesim draw_square\nturtlesim mimic\nturtlesim turtle_teleop_key\nturtlesim turtlesim_node\n"
    )
    assert "[turtlesim]: Starting turtlesim with node name /turtlesim\n" in tutorial.turtlesim.stderr.text
    assert "[turtlesim]: Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]\n" in (
        tutorial.turtlesim.stderr.text
    )
    assert "Use arrow keys to move the turtle.\n" in tutorial.teleop.stdout.text
    assert tutorial("ros2 node list") == "/teleop_turtle\n/turtlesim\n"
    assert "/turtle1/rotate_absolute\n" in tutorial("ros2 action list")
    assert {"/clear", "/kill", "/reset", "/spawn", "/turtle1/set_pen"} <= set(tutorial("ros2 service list").split())
    assert "name='turtle2'" in tutorial(
        "ros2 service call /spawn turtlesim/srv/Spawn \"{x: 1.0, y: 1.0, theta: 0.0, name: 'turtle2'}\""
    )


def test_understanding_nodes(tutorial):
    machine = tutorial.machine
    machine.run("turtlesim", "turtlesim_node", "--ros-args", "--remap", "__node:=my_turtle")
    assert tutorial("ros2 node list") == "/my_turtle\n/teleop_turtle\n/turtlesim\n"
    assert (
        tutorial("ros2 node info /my_turtle")
        == """\
/my_turtle
  Subscribers:
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /turtle1/cmd_vel: geometry_msgs/msg/Twist
  Publishers:
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /rosout: rcl_interfaces/msg/Log
    /turtle1/color_sensor: turtlesim/msg/Color
    /turtle1/pose: turtlesim/msg/Pose
  Service Servers:
    /clear: std_srvs/srv/Empty
    /kill: turtlesim/srv/Kill
    /my_turtle/describe_parameters: rcl_interfaces/srv/DescribeParameters
    /my_turtle/get_parameter_types: rcl_interfaces/srv/GetParameterTypes
    /my_turtle/get_parameters: rcl_interfaces/srv/GetParameters
    /my_turtle/get_type_description: type_description_interfaces/srv/GetTypeDescription
    /my_turtle/list_parameters: rcl_interfaces/srv/ListParameters
    /my_turtle/set_parameters: rcl_interfaces/srv/SetParameters
    /my_turtle/set_parameters_atomically: rcl_interfaces/srv/SetParametersAtomically
    /reset: std_srvs/srv/Empty
    /spawn: turtlesim/srv/Spawn
    /turtle1/set_pen: turtlesim/srv/SetPen
    /turtle1/teleport_absolute: turtlesim/srv/TeleportAbsolute
    /turtle1/teleport_relative: turtlesim/srv/TeleportRelative
  Service Clients:

  Action Servers:
    /turtle1/rotate_absolute: turtlesim/action/RotateAbsolute
  Action Clients:

"""
    )


def test_understanding_topics(tutorial):
    machine = tutorial.machine
    assert tutorial("ros2 topic list -t") == TURTLE_TOPICS
    echo = machine.start("topic", "echo", "/turtle1/cmd_vel")
    assert tutorial("ros2 topic info /turtle1/cmd_vel") == (
        "Type: geometry_msgs/msg/Twist\nPublisher count: 1\nSubscription count: 2\n"
    )
    shown = tutorial("ros2 interface show geometry_msgs/msg/Twist")
    fields = [line.partition("#")[0].rstrip() for line in shown.splitlines() if line.partition("#")[0].strip()]
    assert fields == [
        *("Vector3  linear", "\tfloat64 x", "\tfloat64 y", "\tfloat64 z"),
        *("Vector3  angular", "\tfloat64 x", "\tfloat64 y", "\tfloat64 z"),
    ]
    assert tutorial(
        'ros2 topic pub --once -w 2 /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0, y: 0.0, z: 0.0}, '
        'angular: {x: 0.0, y: 0.0, z: 1.8}}"'
    ) == (
        "Waiting for at least 2 matching subscription(s)...\npublisher: beginning loop\n"
        "publishing #1: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=2.0, y=0.0, z=0.0), "
        "angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=1.8))\n\n"
    )
    assert echo.stdout == ("linear:\n  x: 2.0\n  y: 0.0\n  z: 0.0\nangular:\n  x: 0.0\n  y: 0.0\n  z: 1.8\n---\n")
    endless = machine.start("topic", "pub", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", "{linear: {x: 2.0}}")
    endless.step(2.0)
    assert "publishing #3: " in endless.stdout
    hz = machine.start("topic", "hz", "/turtle1/pose")
    hz.step(3.1)
    assert "average rate: 62.5" in hz.stdout
    bw = machine.start("topic", "bw", "/turtle1/pose")
    bw.step(2.1)
    assert bw.stdout.startswith("Subscribed to [/turtle1/pose]\n1.5") and "Message size mean: 0.02 KB" in bw.stdout
    assert tutorial("ros2 topic find geometry_msgs/msg/Twist") == "/turtle1/cmd_vel\n"


def test_publishing_a_stamp(tutorial):
    echo = tutorial.machine.start("topic", "echo", "/reference", "sensor_msgs/msg/TimeReference")
    tutorial(
        'ros2 topic pub -t 1 /reference sensor_msgs/msg/TimeReference \'{header: "auto", time_ref: "now", source: "dumy"}\''
    )
    assert "time_ref:\n  sec: 17" in echo.stdout and "source: dumy\n" in echo.stdout


def test_understanding_services(tutorial):
    assert tutorial("ros2 service type /clear") == "std_srvs/srv/Empty\n"
    assert "/clear [std_srvs/srv/Empty]\n" in tutorial("ros2 service list -t")
    assert tutorial("ros2 service info /clear") == "Type: std_srvs/srv/Empty\nClients count: 0\nServices count: 1\n"
    assert tutorial("ros2 service find std_srvs/srv/Empty") == "/clear\n/reset\n"
    assert tutorial("ros2 interface show --no-comments std_srvs/srv/Empty") == "---\n"
    assert tutorial("ros2 service call /clear std_srvs/srv/Empty") == (
        "requester: making request: std_srvs.srv.Empty_Request()\n\nresponse:\nstd_srvs.srv.Empty_Response()\n\n"
    )
    assert tutorial("ros2 service call /spawn turtlesim/srv/Spawn \"{x: 2, y: 2, theta: 0.2, name: ''}\"") == (
        "requester: making request: turtlesim.srv.Spawn_Request(x=2.0, y=2.0, theta=0.2, name='')\n\n"
        "response:\nturtlesim.srv.Spawn_Response(name='turtle2')\n\n"
    )


def test_understanding_parameters(tutorial):
    machine = tutorial.machine
    listed = tutorial("ros2 param list")
    assert "/teleop_turtle:\n" in listed and "/turtlesim:\n  background_b\n  background_g\n  background_r\n" in listed
    assert {"  scale_angular", "  scale_linear", "  use_sim_time"} <= set(listed.splitlines())
    assert tutorial("ros2 param get /turtlesim background_g") == "Integer value is: 86\n"
    assert tutorial("ros2 param set /turtlesim background_r 150") == "Set parameter successful\n"
    dumped = tutorial("ros2 param dump /turtlesim")
    assert dumped.startswith(
        "/turtlesim:\n  ros__parameters:\n    background_b: 255\n    background_g: 86\n    background_r: 150\n"
    )
    (machine.cwd / "turtlesim.yaml").write_text(dumped.replace("86", "87"), encoding="utf-8")
    assert "Set parameter background_g successful\n" in tutorial_load(machine)
    assert tutorial("ros2 param get /turtlesim background_g") == "Integer value is: 87\n"
    machine.run(
        *("turtlesim", "turtlesim_node", "--ros-args", "--params-file", str(machine.cwd / "turtlesim.yaml")),
        *("-r", "__ns:=/second"),
    )
    assert tutorial("ros2 param get /second/turtlesim background_r") == "Integer value is: 69\n"


def tutorial_load(machine) -> str:
    """The page shows that read-only parameters (`qos_overrides …`) are refused while the others are set."""
    result = machine.ros2("param", "load", "/turtlesim", "turtlesim.yaml")
    assert result.status == 0
    return result.stdout


def test_understanding_actions(tutorial):
    assert tutorial("ros2 action list") == "/turtle1/rotate_absolute\n"
    assert tutorial("ros2 action list -t") == "/turtle1/rotate_absolute [turtlesim/action/RotateAbsolute]\n"
    assert tutorial("ros2 action type /turtle1/rotate_absolute") == "turtlesim/action/RotateAbsolute\n"
    assert [line.strip() for line in tutorial("ros2 action info /turtle1/rotate_absolute").splitlines()] == [
        "Action: /turtle1/rotate_absolute",
        "Action clients: 1",
        "/teleop_turtle",
        "Action servers: 1",
        "/turtlesim",
    ]
    shown = tutorial("ros2 interface show turtlesim/action/RotateAbsolute")
    assert [line for line in shown.splitlines() if line and not line.startswith("#")] == [
        *("float32 theta", "---", "float32 delta", "---", "float32 remaining")
    ]
    sent = tutorial(
        'ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta: 1.57}" --feedback'
    )
    assert sent.startswith(
        "Waiting for an action server to become available...\nSending goal:\n     theta: 1.57\n\nGoal accepted with ID: "
    )
    assert "Feedback:\n    remaining: 1.5" in sent
    assert "Result:\n    delta: -1.5" in sent
    assert sent.endswith("Goal finished with status: SUCCEEDED\n")


def test_managing_logger_levels_and_a_turtle_that_hits_the_wall(tutorial):
    machine = tutorial.machine
    machine.start("topic", "pub", "-r", "1", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", "{linear: {x: 2.0}}")
    machine.step(8.0)
    assert "[WARN]" in tutorial.turtlesim.stderr.text
    assert "[turtlesim]: Oh no! I hit the wall! (Clamping from [x=" in tutorial.turtlesim.stderr.text
    quiet = machine.run(
        *("turtlesim", "turtlesim_node", "--ros-args", "--log-level", "WARN", "-r", "__node:=quiet_turtle")
    )
    assert quiet.stderr.text == ""
