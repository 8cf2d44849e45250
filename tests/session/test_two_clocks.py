"""Programs on a machine whose real clock goes its own way: what moves follows the world's, what is told the real one."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import pytest
from geometry_msgs.msg import TransformStamped, Twist
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose

from day6_core.session.clock import WorldClock
from day6_urdf import shipped_model
from tests.support.stepped_machine import EPOCH_NS, SteppedMachine

SECOND = 1_000_000_000
STEP = 0.01


class Machine(SteppedMachine):
    """`go` moves both clocks, the real one by `real` seconds for every second of the world."""

    def __init__(self) -> None:
        self.real_ns = 0
        super().__init__(WorldClock(wall=lambda: self.real_ns, system=lambda: EPOCH_NS + self.real_ns))
        self.clock.pause()
        self.graph.now_ns = self.clock.now_ns

    def go(self, seconds: float, real: float) -> None:
        for _ in range(round(seconds / STEP)):
            self.real_ns += round(STEP * real * SECOND)
            self.advance(STEP)

    def pause_for(self, seconds: float) -> None:
        """Real time passes, the world stands."""
        self.real_ns += round(seconds * SECOND)
        self.advance()

    def window(self) -> Any:
        self.until(lambda: self.display.windows)
        return self.display.windows[-1].model


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    machine.WHILE_WAITING = 0.0
    yield machine
    machine.end()


@pytest.mark.parametrize("real", [0.0, 0.1, 1.0, 10.0])
def test_a_command_moves_the_turtle_for_63_ticks_however_much_real_time_passes(machine: Machine, real: float) -> None:
    machine.start("turtlesim", "turtlesim_node")
    poses = machine.watch(Pose, "/turtle1/pose", 200)
    machine.go(0.1, real)
    machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10).publish(_ahead())
    machine.go(0.5, real)
    machine.pause_for(60.0)
    machine.go(1.0, real)
    assert sum(pose.linear_velocity > 0 for pose in poses) == 63


def _ahead() -> Twist:
    twist = Twist()
    twist.linear.x = 2.0
    return twist


def test_stamps_tell_real_time_like_those_of_a_student_s_process(machine: Machine) -> None:
    machine.start("day6_bot", "wheel_spinner")
    states = machine.watch(JointState, "/joint_states", 100)
    machine.go(2.0, 5.0)
    stamps = [state.header.stamp.sec * SECOND + state.header.stamp.nanosec for state in states]
    # 50 a second of the world, so every 0.1 real seconds
    assert {after - before for before, after in pairwise(stamps)} == {SECOND // 10}
    assert machine.node.get_clock().now().nanoseconds == stamps[-1] == EPOCH_NS + 10 * SECOND


def test_the_car_window_measures_real_rates_and_a_pause_lets_no_joint_fall_silent(machine: Machine) -> None:
    machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
    machine.start("day6_bot", "car_view", screen=True)
    machine.start("day6_bot", "wheel_spinner")
    car = machine.window()
    machine.until(lambda: car.snapshot().robot is not None)
    machine.go(3.0, 2.0)
    assert car.snapshot().rate == pytest.approx(25.0)
    assert car.snapshot().joints[0].speed == pytest.approx(0.5)
    before = car.snapshot().status
    machine.pause_for(60.0)
    car.refresh()
    assert car.snapshot().status == before
    assert [reading.name for reading in car.snapshot().joints] == ["left_wheel_joint", "right_wheel_joint"]


def test_frames_do_not_fade_in_a_pause_although_rviz_draws(machine: Machine) -> None:
    machine.start("rviz2", "rviz2", screen=True)
    rviz = machine.window()
    stamped = TransformStamped(child_frame_id="arm")
    stamped.header.frame_id = "base_link"
    stamped.header.stamp = machine.node.get_clock().now().to_msg()
    stamped.transform.rotation.w = 1.0
    TransformBroadcaster(machine.node).sendTransform(stamped)
    rviz.edit(rviz.fixed, "base_link")
    rviz.request(lambda: rviz.add_display("TF", ""))
    machine.go(0.5, 1.0)
    drawn = len(rviz.scene.shapes)
    assert drawn
    machine.pause_for(60.0)
    rviz.tick()
    assert len(rviz.scene.shapes) == drawn


def test_the_simulated_world_tells_how_many_of_its_seconds_pass_in_a_real_one(machine: Machine) -> None:
    machine.start("day6_world", "world", screen=True)
    world = machine.window()
    machine.go(1.0, 0.5)
    assert world.snapshot().real_time_factor == pytest.approx(2.0)
    world.request("faster")
    machine.go(4.0, 0.5)
    assert (world.snapshot().speed, world.snapshot().real_time_factor) == (2.0, pytest.approx(4.0))
    world.request("pause")
    machine.go(0.1, 1.0)
    assert world.snapshot().real_time_factor is None


def test_a_turtle_with_simulated_time_stops_by_that(machine: Machine) -> None:
    machine.start("turtlesim", "turtlesim_node", "--ros-args", "-p", "use_sim_time:=true")
    poses = machine.watch(Pose, "/turtle1/pose", 500)
    clock = machine.node.create_publisher(Clock, "/clock", 10)
    clock.publish(_clock(1))
    machine.go(0.1, 1.0)
    machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10).publish(_ahead())
    machine.go(5.0, 1.0)
    assert poses[-1].linear_velocity == 2.0
    clock.publish(_clock(3))
    machine.go(0.1, 1.0)
    assert poses[-1].linear_velocity == 0.0


def _clock(seconds: int) -> Clock:
    message = Clock()
    message.clock.sec = seconds
    return message
