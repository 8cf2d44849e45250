"""turtlesim_node as others see it: its part of the graph, its log, its services, its action, its window."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from geometry_msgs.msg import Twist
from rcl_interfaces.srv import DescribeParameters, SetParameters
from std_srvs.srv import Empty
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color, Pose
from turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative

from rclpy.action import ActionClient
from rclpy.parameter import Parameter

if TYPE_CHECKING:
    from tests.turtlesim.conftest import Machine, Running

CENTRE = 5.544444561004639
START_LOG = [
    "[INFO] [turtlesim]: Starting turtlesim with node name /turtlesim",
    "[INFO] [turtlesim]: Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]",
]


def start(machine: Machine, *args: str) -> Running:
    """turtlesim after the tick that only starts its clock."""
    turtlesim = machine.start("turtlesim_node", *args)
    machine.ticks(1)
    return turtlesim


def twist(linear: float = 0.0, angular: float = 0.0, sideways: float = 0.0) -> Twist:
    message = Twist()
    message.linear.x, message.linear.y, message.angular.z = linear, sideways, angular
    return message


def test_it_says_where_its_first_turtle_is(machine: Machine) -> None:
    assert start(machine).log == START_LOG


def test_its_part_of_the_graph_is_that_of_the_real_one(machine: Machine) -> None:
    start(machine)
    node = machine.node
    topics = dict(node.get_publisher_names_and_types_by_node("turtlesim", "/"))
    assert topics["/turtle1/pose"] == ["turtlesim/msg/Pose"]
    assert topics["/turtle1/color_sensor"] == ["turtlesim/msg/Color"]
    heard = dict(node.get_subscriber_names_and_types_by_node("turtlesim", "/"))
    assert heard["/turtle1/cmd_vel"] == ["geometry_msgs/msg/Twist"]
    assert heard["/parameter_events"] == ["rcl_interfaces/msg/ParameterEvent"]
    services = dict(node.get_service_names_and_types_by_node("turtlesim", "/"))
    assert {name: kinds for name, kinds in services.items() if not name.startswith("/turtlesim/")} == {
        "/clear": ["std_srvs/srv/Empty"],
        "/kill": ["turtlesim/srv/Kill"],
        "/reset": ["std_srvs/srv/Empty"],
        "/spawn": ["turtlesim/srv/Spawn"],
        "/turtle1/rotate_absolute/_action/cancel_goal": ["action_msgs/srv/CancelGoal"],
        "/turtle1/rotate_absolute/_action/get_result": ["turtlesim/action/RotateAbsolute_GetResult"],
        "/turtle1/rotate_absolute/_action/send_goal": ["turtlesim/action/RotateAbsolute_SendGoal"],
        "/turtle1/set_pen": ["turtlesim/srv/SetPen"],
        "/turtle1/teleport_absolute": ["turtlesim/srv/TeleportAbsolute"],
        "/turtle1/teleport_relative": ["turtlesim/srv/TeleportRelative"],
    }


def test_poses_come_with_every_tick_but_the_first(machine: Machine) -> None:
    poses = machine.watch(Pose, "/turtle1/pose")
    colors = machine.watch(Color, "/turtle1/color_sensor")
    machine.start("turtlesim_node")
    machine.ticks(6)
    assert poses == [Pose(x=CENTRE, y=CENTRE)] * 5
    assert colors == [Color(r=255, g=255, b=255)] * 5


def test_one_twist_moves_the_turtle_for_63_ticks_from_the_tick_that_takes_it(machine: Machine) -> None:
    start(machine)
    poses = machine.watch(Pose, "/turtle1/pose")
    commands = machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10)
    machine.advance(0.005)
    commands.publish(twist(2.0, 1.8))
    machine.ticks(70)
    moving = [pose for pose in poses if pose.linear_velocity]
    assert len(moving) == 63
    last = poses[-1]
    assert f"{last.x:f} {last.y:f} {last.theta:f}" == "6.602817 6.938990 1.814400"


def test_it_takes_one_command_at_each_tick_and_keeps_the_last_seven(machine: Machine) -> None:
    start(machine)
    poses = machine.watch(Pose, "/turtle1/pose")
    commands = machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10)
    for linear in range(10):
        commands.publish(twist(float(linear)))
    machine.ticks(8)
    assert [pose.linear_velocity for pose in poses] == [3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 9.0]


def test_pushing_against_the_wall_warns_once_a_tick(machine: Machine) -> None:
    turtlesim = start(machine)
    machine.call(TeleportAbsolute, "/turtle1/teleport_absolute", x=11.0, y=5.0, theta=0.0)
    machine.ticks(2)
    commands = machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10)
    commands.publish(twist(2.0))
    machine.ticks(4)
    lines = [line for line in turtlesim.log if "wall" in line]
    assert len(lines) == 2
    assert lines[0] == "[WARN] [turtlesim]: Oh no! I hit the wall! (Clamping from [x=11.096000, y=6.088889])"


def test_spawn_gives_numbers_names_and_refuses_a_taken_one(machine: Machine) -> None:
    turtlesim = start(machine)
    assert machine.call(Spawn, "/spawn", x=2.0, y=3.0, theta=0.5).name == "turtle2"
    assert machine.call(Spawn, "/spawn", x=1.0, y=1.0, name="leonardo").name == "leonardo"
    assert machine.call(Spawn, "/spawn", name="leonardo").name == ""
    assert turtlesim.log[2:] == [
        "[INFO] [turtlesim]: Spawning turtle [turtle2] at x=[2.000000], y=[3.000000], theta=[0.500000]",
        "[INFO] [turtlesim]: Spawning turtle [leonardo] at x=[1.000000], y=[1.000000], theta=[0.000000]",
        "[ERROR] [turtlesim]: A turtle named [leonardo] already exists",
    ]
    assert {"/turtle2/pose", "/leonardo/cmd_vel"} <= machine.topics()


def test_kill_takes_the_turtle_out_of_the_graph(machine: Machine) -> None:
    turtlesim = start(machine)
    machine.call(Kill, "/kill", name="turtle1")
    machine.call(Kill, "/kill", name="turtle1")
    assert turtlesim.log[2:] == ["[ERROR] [turtlesim]: Tried to kill turtle [turtle1], which does not exist"]
    assert not [name for name in machine.topics() if name.startswith("/turtle1/")]
    services = {name for name, _ in machine.node.get_service_names_and_types()}
    assert not [name for name in services if name.startswith("/turtle1/")]


def test_reset_leaves_one_turtle_in_the_middle(machine: Machine) -> None:
    turtlesim = start(machine)
    machine.call(Spawn, "/spawn", x=2.0, y=3.0)
    machine.call(TeleportRelative, "/turtle1/teleport_relative", linear=2.0, angular=1.0)
    poses = machine.watch(Pose, "/turtle1/pose")
    machine.call(Empty, "/reset")
    machine.ticks(2)
    assert turtlesim.log[3:] == ["[INFO] [turtlesim]: Resetting turtlesim.", START_LOG[1]]
    assert poses[-1] == Pose(x=CENTRE, y=CENTRE)
    assert "/turtle2/pose" not in machine.topics()


def test_clear_wipes_the_trail_only(machine: Machine) -> None:
    turtlesim = start(machine)
    colors = machine.watch(Color, "/turtle1/color_sensor")
    machine.call(SetPen, "/turtle1/set_pen", r=200, g=10, b=20, width=5, off=0)
    machine.call(TeleportRelative, "/turtle1/teleport_relative", linear=1.0, angular=0.0)
    machine.ticks(2)
    assert colors[-1] == Color(r=200, g=10, b=20)
    machine.call(Empty, "/clear")
    machine.ticks(2)
    assert colors[-1] == Color(r=255, g=255, b=255)
    assert turtlesim.log[2:] == ["[INFO] [turtlesim]: Clearing turtlesim."]


def test_a_name_no_topic_can_have_ends_the_node_as_in_the_original(machine: Machine) -> None:
    turtlesim = start(machine)
    client = machine.node.create_client(Spawn, "/spawn")
    client.call_async(Spawn.Request(name="my turtle"))
    machine.ticks(2)
    assert turtlesim.program.killed_by == 6
    characters = "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
    assert turtlesim.log[2:] == [
        "terminate called after throwing an instance of 'rclcpp::exceptions::InvalidTopicNameError'",
        f"  what():  Invalid topic name: {characters}:",
        "  'my turtle/cmd_vel'",
        "     ^",
        "",
    ]


# -- parameters --------------------------------------------------------------------------------------------------------


def set_parameter(machine: Machine, name: str, value: Any) -> Any:
    request = [Parameter(name, value=value).to_parameter_msg()]
    return machine.call(SetParameters, "/turtlesim/set_parameters", parameters=request).results[0]


def test_the_parameters_describe_themselves(machine: Machine) -> None:
    start(machine)
    names = ["background_r", "background_g", "background_b", "holonomic"]
    answer = machine.call(DescribeParameters, "/turtlesim/describe_parameters", names=names)
    assert [descriptor.description for descriptor in answer.descriptors] == [
        "Red channel of the background color",
        "Green channel of the background color",
        "Blue channel of the background color",
        "If true, then turtles will be holonomic",
    ]
    (limits,) = answer.descriptors[0].integer_range
    assert (limits.from_value, limits.to_value, limits.step) == (0, 255, 1)


def test_the_background_follows_its_parameters_even_through_a_reset(machine: Machine) -> None:
    machine.start("turtlesim_node", screen=True)
    machine.ticks(1)
    (window,) = machine.display.windows
    assert window.model.scene.background == (69, 86, 255)
    assert set_parameter(machine, "background_r", 150).successful
    assert not set_parameter(machine, "background_g", 300).successful
    machine.ticks(2)
    assert window.model.scene.background == (150, 86, 255)
    machine.call(Empty, "/reset")
    assert window.model.scene.background == (150, 86, 255)


def test_the_background_can_be_given_on_the_command_line(machine: Machine) -> None:
    machine.start("turtlesim_node", "--ros-args", "-p", "background_b:=7", screen=True)
    (window,) = machine.display.windows
    assert window.model.scene.background == (69, 86, 7)


def test_holonomic_is_read_with_every_command(machine: Machine) -> None:
    start(machine)
    poses = machine.watch(Pose, "/turtle1/pose")
    commands = machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10)
    commands.publish(twist(3.0, sideways=4.0))
    machine.ticks(1)
    assert poses[-1].linear_velocity == 3.0
    set_parameter(machine, "holonomic", True)
    commands.publish(twist(3.0, sideways=4.0))
    machine.ticks(1)
    assert poses[-1].linear_velocity == 5.0


def test_a_namespace_moves_everything(machine: Machine) -> None:
    turtlesim = start(machine, "--ros-args", "-r", "__ns:=/turtlesim1")
    assert turtlesim.log[0].endswith("Starting turtlesim with node name /turtlesim1/turtlesim")
    assert "/turtlesim1/turtle1/pose" in machine.topics()
    assert machine.call(Spawn, "/turtlesim1/spawn", x=1.0, y=1.0).name == "turtle2"


# -- the action --------------------------------------------------------------------------------------------------------


class Rotation:
    """A goal sent by the watcher, up to the server's answer."""

    def __init__(self, machine: Machine, theta: float) -> None:
        self._machine = machine
        self._client = ActionClient(machine.node, RotateAbsolute, "/turtle1/rotate_absolute")
        self.feedback: list[float] = []
        goal = RotateAbsolute.Goal(theta=theta)
        self.handle = machine.wait(self._client.send_goal_async(goal, self._hear))

    def _hear(self, message: Any) -> None:
        self.feedback.append(message.feedback.remaining)

    def result(self) -> tuple[int, float]:
        """Return status and delta."""
        answer = self._machine.wait(self.handle.get_result_async(), 400)
        return answer.status, answer.result.delta


SUCCEEDED, CANCELED, ABORTED = 4, 5, 6


@pytest.mark.parametrize(
    ("theta", "ticks", "last", "delta"),
    [(1.57, 98, 0.018000006675720215, -1.5520000457763672), (3.1416, 197, -0.005585488397628069, 3.135999917984009)],
)
def test_a_rotation_goal_is_reached_tick_by_tick(
    machine: Machine, theta: float, ticks: int, last: float, delta: float
) -> None:
    turtlesim = start(machine)
    rotation = Rotation(machine, theta)
    assert rotation.handle.accepted
    assert rotation.result() == (SUCCEEDED, delta)
    assert len(rotation.feedback) == ticks
    assert rotation.feedback[-1] == last
    assert turtlesim.log[2:] == ["[INFO] [turtlesim]: Rotation goal completed successfully"]


def test_a_rotation_can_be_cancelled(machine: Machine) -> None:
    turtlesim = start(machine)
    rotation = Rotation(machine, 1.57)
    machine.ticks(9)
    rotation.handle.cancel_goal_async()
    status, delta = rotation.result()
    assert status == CANCELED
    assert -0.3 < delta < -0.1
    assert turtlesim.log[2:] == ["[INFO] [turtlesim]: Rotation goal canceled"]


def test_a_command_aborts_the_rotation(machine: Machine) -> None:
    turtlesim = start(machine)
    rotation = Rotation(machine, 1.57)
    machine.ticks(9)
    machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10).publish(twist(1.0))
    assert rotation.result()[0] == ABORTED
    assert turtlesim.log[2:] == ["[WARN] [turtlesim]: Velocity command received during rotation goal. Aborting goal"]


def test_a_second_goal_aborts_the_first(machine: Machine) -> None:
    turtlesim = start(machine)
    first = Rotation(machine, 1.57)
    machine.ticks(9)
    second = Rotation(machine, -0.5)
    assert first.result()[0] == ABORTED
    assert second.result()[0] == SUCCEEDED
    assert turtlesim.log[2] == (
        "[WARN] [turtlesim]: Rotation goal received before a previous goal finished. Aborting previous goal"
    )


def test_killing_a_turtle_ends_its_rotation(machine: Machine) -> None:
    turtlesim = start(machine)
    rotation = Rotation(machine, 1.57)
    result = rotation.handle.get_result_async()
    machine.ticks(3)
    machine.call(Kill, "/kill", name="turtle1")
    assert machine.wait(result).status == CANCELED
    machine.ticks(3)
    assert turtlesim.program.status is None
    services = machine.node.get_service_names_and_types_by_node("turtlesim", "/")
    assert not [name for name, _ in services if name.startswith("/turtle1/")]


# -- window and end ----------------------------------------------------------------------------------------------------


def test_the_window_shows_the_turtles_and_the_trail(machine: Machine) -> None:
    machine.start("turtlesim_node", screen=True)
    machine.ticks(1)
    (window,) = machine.display.windows
    assert (window.kind, window.title) == ("turtlesim", "TurtleSim")
    model = window.model
    still = model.scene
    assert [turtle.name for turtle in still.turtles] == ["turtle1"]
    machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10).publish(twist(2.0))
    machine.ticks(3)
    assert model.scene is not still
    assert model.scene.turtles[0].x > CENTRE
    assert model.trail.drawn == 3


def test_ctrl_c_ends_it_and_takes_everything_along(machine: Machine) -> None:
    turtlesim = machine.start("turtlesim_node", screen=True)
    machine.ticks(2)
    turtlesim.program.interrupt()
    machine.advance()
    assert turtlesim.program.status == 0
    assert turtlesim.log[-1] == "[INFO] [rclcpp]: signal_handler(SIGINT/SIGTERM)"
    assert machine.display.windows == []
    assert "/turtle1/pose" not in machine.topics()
    assert machine.node.get_node_names() == ["watcher"]


def test_closing_the_window_ends_the_node_without_a_word(machine: Machine) -> None:
    turtlesim = machine.start("turtlesim_node", screen=True)
    machine.ticks(2)
    machine.display.windows[0].close_by_user()
    machine.advance()
    assert turtlesim.program.status == 0
    assert turtlesim.log == START_LOG


def test_the_window_knows_who_drives_each_turtle(machine: Machine) -> None:
    machine.start("turtlesim_node", "--ros-args", "-r", "__ns:=/left", screen=True)
    machine.until(lambda: machine.display.windows)
    simulation = machine.display.windows[0].model
    machine.ticks(20)
    assert simulation.topics == {"turtle1": ("/left/turtle1/pose", "/left/turtle1/cmd_vel", ())}
    driver = machine.node.create_publisher(Twist, "/left/turtle1/cmd_vel", 1)
    machine.ticks(20)
    assert simulation.topics["turtle1"].senders == (machine.node.get_fully_qualified_name(),)
    before = simulation.topics
    machine.ticks(40)
    assert simulation.topics is before
    machine.node.destroy_publisher(driver)
    machine.ticks(20)
    assert simulation.topics["turtle1"].senders == ()
