"""The world as a node: it drives, it senses, it refuses ghosts, and its time is its own."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from day6_world.srv import SetSpeed, Step
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import Float32MultiArray
from std_srvs.srv import Empty, SetBool
from tf2_msgs.msg import TFMessage

from day6_core.session.task import sleep_until
from day6_urdf import shipped_model

if TYPE_CHECKING:
    from tests.world.conftest import Machine


def drive(machine: Machine, linear: float, angular: float = 0.0, seconds: float = 0.0) -> None:
    twist = Twist()
    twist.linear.x, twist.angular.z = linear, angular
    if not hasattr(machine, "driver"):
        machine.driver = machine.node.create_publisher(Twist, "/cmd_vel", 10)  # type: ignore[attr-defined]
    machine.driver.publish(twist)  # type: ignore[attr-defined]
    machine.advance(seconds)


def test_cmd_vel_makes_the_car_drive_and_odom_and_tf_tell_how_far(machine: Machine) -> None:
    machine.open_world()
    odometry, transforms = machine.watch(Odometry, "/odom"), machine.watch(TFMessage, "/tf")
    drive(machine, 0.5, seconds=4.0)
    x, y, yaw = machine.model.snapshot().pose
    assert 1.85 < x < 2.0 and y == pytest.approx(0) and yaw == pytest.approx(0)
    last = odometry[-1]
    assert (last.header.frame_id, last.child_frame_id) == ("odom", "base_footprint")
    assert last.pose.pose.position.x == pytest.approx(x)
    assert last.twist.twist.linear.x == pytest.approx(0.5)
    moved = transforms[-1].transforms[0]
    assert (moved.header.frame_id, moved.child_frame_id) == ("odom", "base_footprint")
    assert moved.transform.translation.x == pytest.approx(x)


def test_a_car_that_turns_drives_a_circle_back_to_where_it_began(machine: Machine) -> None:
    machine.open_world()
    drive(machine, 0.5, 1.0, seconds=1.0)
    x, y, yaw = machine.model.snapshot().pose
    machine.advance(round(2 * math.pi / 0.02) * 0.02)
    there = machine.model.snapshot().pose
    assert math.hypot(there[0] - x, there[1] - y) < 0.01
    assert math.remainder(there[2] - yaw, 2 * math.pi) == pytest.approx(0, abs=0.02)


def test_the_wheels_say_on_joint_states_how_far_they_have_rolled(machine: Machine) -> None:
    machine.open_world()
    states = machine.watch(JointState, "/joint_states")
    drive(machine, 0.5, seconds=2.0)
    state = states[-1]
    wheel = dict(zip(state.name, state.position, strict=True))["left_wheel_joint"]
    assert wheel * 0.05 == pytest.approx(machine.model.snapshot().pose[0])
    assert dict(zip(state.name, state.velocity, strict=True))["right_wheel_joint"] == pytest.approx(10.0)


def test_wheel_spinner_moves_nothing_and_the_window_says_why(machine: Machine) -> None:
    machine.open_world()
    machine.start("day6_bot", "wheel_spinner")
    machine.advance(2.0)
    assert machine.model.snapshot().pose[0] == 0
    assert machine.said == [
        (
            "wheel_spinner publishes /joint_states as well. That topic reports where the wheels are; it is not a command, "
            "so nothing rolls. With -r joint_states:=joint_commands it becomes one"
        )
    ]


@pytest.mark.parametrize(
    ("parameters", "arguments"),
    [((), ("--ros-args", "-r", "joint_states:=joint_commands")), (("follow_joint_states:=true",), ())],
)
def test_wheel_spinner_as_an_order_rolls_the_car_at_five_centimetres_a_second(
    machine: Machine, parameters: tuple[str, ...], arguments: tuple[str, ...]
) -> None:
    machine.open_world(*parameters)
    machine.start("day6_bot", "wheel_spinner", *arguments)
    machine.advance(1.0)
    before = machine.model.snapshot().pose[0]
    machine.advance(10.0)  # more than one whole turn: the angle jumps from 2 pi to 0, the wheel does not
    assert machine.model.snapshot().pose[0] - before == pytest.approx(0.5, abs=0.005)
    assert machine.said == []


def test_wheel_speeds_can_be_ordered_one_by_one(machine: Machine) -> None:
    machine.open_world()
    orders = machine.node.create_publisher(JointState, "/joint_commands", 10)
    orders.publish(JointState(name=["left_wheel_joint", "right_wheel_joint"], velocity=[-2.0, 2.0]))
    machine.advance(2.0)
    x, y, yaw = machine.model.snapshot().pose
    assert (x, y) == (pytest.approx(0, abs=1e-6), pytest.approx(0, abs=1e-6))
    assert yaw == pytest.approx(2 * 2.0 * 0.05 / 0.3 * 2.0, abs=0.1)


def test_a_wall_stops_the_car_and_only_odom_believes_it_went_on(machine: Machine) -> None:
    machine.open_world("world:=walls", "y:=1.0", "x:=-0.2")
    odometry, truth = machine.watch(Odometry, "/odom"), machine.watch(Odometry, "/ground_truth")
    drive(machine, 0.5, seconds=6.0)
    x = machine.model.snapshot().pose[0]
    assert 0.55 - 0.2 - 0.03 < x <= 0.55 - 0.2  # the wall's side less half the car
    assert truth[-1].pose.pose.position.x == pytest.approx(x)
    assert truth[-1].twist.twist.linear.x == pytest.approx(0)
    assert odometry[-1].pose.pose.position.x > 2.5
    assert "it touches a wall: the wheels slip, and /odom doesn't notice" in machine.said
    drive(machine, -0.5, seconds=2.0)
    assert machine.model.snapshot().pose[0] < x - 0.5


def without(tag: str, name: str, tmp_path: Path) -> Path:
    """The shipped car with one part taken out of one link."""
    text = shipped_model("day6_bot_gazebo").read_text(encoding="utf-8")
    link = text.index(f'<link name="{name}">')
    start = text.index(f"<{tag}>", link)
    end = text.index(f"</{tag}>", start) + len(tag) + 3
    file = tmp_path / "car.urdf"
    file.write_text(text[:start] + text[end:], encoding="utf-8")
    return file


def test_the_article_s_car_is_a_ghost_and_may_not_enter(machine: Machine) -> None:
    running = machine.open_world(robot=shipped_model())
    assert machine.model.snapshot().robot is None
    assert machine.said == [
        "day6_bot cannot enter this world:",
        (
            "base_link, left_wheel, right_wheel, caster: no <inertial>. Forces cannot move a link without mass; it "
            "would be a ghost"
        ),
    ]
    assert "[ERROR] [world]: day6_bot cannot enter this world:" in running.log


def test_a_refused_robot_has_no_joint_states(machine: Machine) -> None:
    machine.open_world(robot=shipped_model())
    assert machine.node.count_publishers("/joint_states") == 0


def test_one_link_without_mass_is_named(machine: Machine, tmp_path: Path) -> None:
    machine.open_world(robot=without("inertial", "right_wheel", tmp_path))
    assert machine.said[1].startswith("right_wheel: no <inertial>")


def test_a_chassis_without_collision_drives_through_walls(machine: Machine, tmp_path: Path) -> None:
    machine.open_world("world:=walls", "y:=1.0", "x:=-0.2", robot=without("collision", "base_link", tmp_path))
    assert machine.said[0] == "base_link: no <collision>. They pass through walls like ghosts"
    drive(machine, 0.5, seconds=3.0)
    # Its wheels, caster and lidar still have one: the caster is the first to touch the wall.
    assert 0.55 - 0.2 < machine.model.snapshot().pose[0] < 0.55


def test_wheels_without_collision_turn_in_the_air(machine: Machine, tmp_path: Path) -> None:
    machine.open_world(robot=without("collision", "left_wheel", tmp_path))
    assert machine.said[0].startswith("left_wheel: wheels without <collision> don't touch the floor")
    drive(machine, 0.5, seconds=2.0)
    assert machine.model.snapshot().pose == (0.0, 0.0, 0.0)
    assert machine.model.snapshot().angles["left_wheel_joint"] > 10


def test_a_robot_that_is_corrected_may_enter(machine: Machine) -> None:
    from std_msgs.msg import String

    from rclpy.qos import DurabilityPolicy, QoSProfile

    machine.open_world(robot=shipped_model())
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = machine.node.create_publisher(String, "/robot_description", latched)
    publisher.publish(String(data=shipped_model("day6_bot_gazebo").read_text(encoding="utf-8")))
    machine.until(lambda: machine.model.snapshot().robot is not None)
    assert not machine.refused


@pytest.mark.parametrize("size", ["0.4 0.25 1e999", "0.4 0.25 nan", "0.4 -inf 0.1"])
def test_sizes_that_are_no_numbers_are_named(machine: Machine, tmp_path: Path, size: str) -> None:
    file = tmp_path / "car.urdf"
    text = shipped_model("day6_bot_gazebo").read_text(encoding="utf-8").replace("0.4 0.25 0.08", size)
    file.write_text(text, encoding="utf-8")
    machine.open_world(robot=file)
    assert any(size.split()[1 if "-inf" in size else 2] in line or "no number" in line for line in machine.said)
    drive(machine, 0.5, seconds=1.0)
    assert all(math.isfinite(value) for value in machine.model.snapshot().pose)


def test_no_robot_starts_inside_a_wall(machine: Machine) -> None:
    machine.open_world("world:=walls", "x:=0.6", "y:=1.0")
    assert machine.said[1] == "at (0.60, 1.00) it would stand in a wall"


def test_the_lidar_measures_the_wall_in_front(machine: Machine) -> None:
    machine.open_world("world:=walls", "y:=1.0", "x:=-0.2", "lidar_noise:=0.0")
    scans = machine.watch(LaserScan, "/scan")
    machine.advance(0.5)
    scan = scans[-1]
    assert scan.header.frame_id == "laser" and len(scan.ranges) == 180
    ahead = round((0 - scan.angle_min) / scan.angle_increment)
    assert scan.ranges[ahead] == pytest.approx(0.55 - (-0.2 + 0.05))
    assert len(scans) == pytest.approx(5, abs=1)


def test_nobody_measures_while_nobody_listens(machine: Machine) -> None:
    machine.open_world("world:=walls")
    machine.advance(0.5)
    assert machine.model.snapshot().scan is None
    machine.model.wants_rays = True
    machine.advance(0.5)
    assert len(machine.model.snapshot().scan.ranges) == 180


def test_the_line_sensor_sees_the_line_under_the_middle(machine: Machine) -> None:
    machine.open_world("world:=line")
    seen = machine.watch(Float32MultiArray, "/line_sensor")
    machine.advance(0.5)
    left, _, middle, _, right = seen[-1].data
    assert middle == 1.0 and left == right == 0.0
    assert seen[-1].layout.dim[0].label == "left_to_right"


def test_the_line_follower_goes_all_the_way_round_and_stops_at_ctrl_c(machine: Machine) -> None:
    machine.open_world("world:=line")
    start = machine.model.snapshot().pose
    follower = machine.start("day6_world", "line_follower", "--ros-args", "-p", "speed:=0.35", "-p", "gain:=2.5")
    far, lost, back = 0.0, 0, False
    for _ in range(1000):
        machine.advance(0.1)
        snapshot = machine.model.snapshot()
        away = math.hypot(snapshot.pose[0] - start[0], snapshot.pose[1] - start[1])
        far = max(far, away)
        lost = lost + 1 if not sum(snapshot.line) else 0
        assert lost < 30, f"it lost the line at {snapshot.pose}"
        if far > 2.5 and away < 0.2:
            back = True
            break
    assert back
    follower.program.interrupt()
    machine.advance(1.0)
    assert machine.model.snapshot().velocity[0] == pytest.approx(0)
    assert follower.program.status == 0


def test_the_line_follower_stops_the_car_when_it_is_killed_too(machine: Machine) -> None:
    machine.open_world("world:=line")
    follower = machine.start("day6_world", "line_follower")
    machine.advance(1.0)
    assert machine.model.snapshot().velocity[0] > 0.1
    follower.program.session.terminate()
    machine.advance(1.0)
    assert machine.model.snapshot().velocity[0] == pytest.approx(0)


def test_the_same_seed_gives_the_same_world_and_another_one_does_not(machine: Machine) -> None:
    def ranges(name: str, seed: int) -> list[float]:
        scans = machine.watch(LaserScan, f"/{name}/scan")
        machine.start(
            "day6_world", "world", "--ros-args", "-r", f"__ns:=/{name}", "-p", f"seed:={seed}", "-p", "world:=walls",
            "-p", f"robot_file:={shipped_model('day6_bot_gazebo')}", screen=True,
        )  # fmt: skip
        machine.until(lambda: len(scans) >= 3)
        return list(scans[0].ranges)

    first, again, other = ranges("a", 7), ranges("b", 7), ranges("c", 8)
    assert first == again != other


def test_its_time_stands_while_it_is_paused_and_goes_by_steps(machine: Machine) -> None:
    machine.open_world(screen=False)
    clock = machine.watch(Clock, "/clock")
    machine.advance(1.0)
    assert machine.call(SetBool, "/world/pause", data=True).message == "paused"
    before = clock[-1].clock
    machine.advance(3.0)
    assert clock[-1].clock == before
    stepped = machine.call(Step, "/world/step", steps=50).clock
    assert (stepped.sec + stepped.nanosec / 1e9) - (before.sec + before.nanosec / 1e9) == pytest.approx(1.0)
    machine.call(SetBool, "/world/pause", data=False)
    machine.advance(1.0)
    assert clock[-1].clock.sec >= stepped.sec + 1


def test_many_steps_at_once_leave_the_other_programs_their_turns(machine: Machine) -> None:
    machine.open_world()
    machine.advance(0.1)
    client = machine.node.create_client(Step, "/world/step")
    first, second = (client.call_async(Step.Request(steps=steps)) for steps in (5000, 10))
    turns = 0

    async def other() -> None:
        nonlocal turns
        while not second.done():
            turns += 1
            await sleep_until(machine.clock.steady_ns() + 20_000_000)

    machine.scheduler.spawn(other())
    began = machine.model.snapshot().seconds
    machine.until(second.done, 200.0)
    assert turns > 3 and first.done()
    ends = [each.result().clock.sec + each.result().clock.nanosec / 1e9 for each in (first, second)]
    assert ends == pytest.approx([began + 100.0, began + 100.2], abs=0.2)


def test_a_node_with_use_sim_time_lives_in_the_world_s_time(machine: Machine) -> None:
    machine.open_world(screen=False)
    from rclpy.parameter import Parameter

    machine.node.set_parameters([Parameter("use_sim_time", value=True)])
    machine.advance(2.0)
    assert 1.5 < machine.node.get_clock().now().nanoseconds / 1e9 < 3.0


def test_its_time_can_pass_ten_times_as_fast_and_no_faster(machine: Machine) -> None:
    machine.open_world(screen=False)
    clock = machine.watch(Clock, "/clock", 1)
    assert machine.call(SetSpeed, "/world/set_speed", factor=10.0).success
    machine.advance(0.1)
    before = clock[-1].clock
    machine.advance(1.0)
    passed = clock[-1].clock.sec - before.sec + (clock[-1].clock.nanosec - before.nanosec) / 1e9
    assert passed == pytest.approx(10.0, abs=0.3)
    refused = machine.call(SetSpeed, "/world/set_speed", factor=100.0)
    assert not refused.success and refused.message == "the factor has to be greater than 0 and at most 10"


def test_reset_puts_the_car_and_the_time_back(machine: Machine) -> None:
    machine.open_world("world:=walls")
    drive(machine, 0.4, 0.3, seconds=3.0)
    machine.call(Empty, "/world/reset")
    machine.advance(0.02)
    snapshot = machine.model.snapshot()
    assert snapshot.pose == (-2.2, 0.0, 0.0) and snapshot.seconds < 0.3
    assert len(machine.model.trail.points) == 1


def test_another_type_on_cmd_vel_is_named_with_the_remedy(machine: Machine) -> None:
    machine.open_world()
    machine.node.create_publisher(TwistStamped, "/cmd_vel", 10)
    machine.advance(1.0)
    assert (
        "/cmd_vel has type geometry_msgs/msg/TwistStamped, but this world needs Twist: start it with stamped:=true"
        in machine.said
    )


def test_with_stamped_it_hears_twist_stamped(machine: Machine) -> None:
    machine.open_world("stamped:=true")
    message = TwistStamped()
    message.twist.linear.x = 0.5
    machine.node.create_publisher(TwistStamped, "/cmd_vel", 10).publish(message)
    machine.advance(1.0)
    assert machine.model.snapshot().pose[0] > 0.3


@pytest.mark.parametrize("wrong", [math.nan, math.inf])
def test_a_speed_that_is_no_number_changes_nothing(machine: Machine, wrong: float) -> None:
    machine.open_world()
    drive(machine, 0.3, seconds=1.0)
    drive(machine, wrong, seconds=1.0)
    assert all(math.isfinite(value) for value in machine.model.snapshot().pose)
    assert machine.model.snapshot().velocity[0] == pytest.approx(0.3)


def test_the_window_s_keys_reach_the_world(machine: Machine) -> None:
    machine.open_world()
    model: Any = machine.model
    drive(machine, 0.5, seconds=1.0)
    model.request("pause")
    machine.advance(0.1)
    stood = model.snapshot()
    machine.advance(1.0)
    assert model.snapshot() is stood and stood.paused
    model.request("step")
    machine.advance(0.1)
    assert model.snapshot().seconds == pytest.approx(stood.seconds + 0.02)
    model.request("pause")
    model.request("faster")
    machine.advance(0.1)
    assert model.snapshot().speed == 2.0
    model.request("clear")
    machine.advance(0.1)
    assert len(model.trail.points) <= 10


def test_an_unknown_world_is_refused_with_those_there_are(machine: Machine) -> None:
    running = machine.open_world("world:=moon", screen=False)
    assert running.program.status == 1
    assert running.log[-1] == (
        "[FATAL] [world]: there is no world 'moon': it is one of empty, line, maze, walls, or a file"
    )
