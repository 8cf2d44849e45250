"""The car's window: it shows what /tf says, and says plainly what is wrong."""

from __future__ import annotations

import math
import threading
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from std_msgs.msg import Float64MultiArray, String

from day6_core.ros.programs.day6_bot import car_view
from day6_core.ros.programs.day6_bot.model import CarModel
from day6_urdf import parse_robot, shipped_model
from day6_urdf.topview.plan import find_wheels, plan_top, spin_of
from day6_urdf.topview.view import render_top
from rclpy.qos import DurabilityPolicy, QoSProfile
from tests.support.waiting import PATIENCE

if TYPE_CHECKING:
    from tests.robot.conftest import Machine, Running

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
STAYS = "This only draws angles. To make it drive: ros2 launch day6_world world.launch.py"
NO_JOINT_STATES = "nobody publishes /joint_states: the wheels don't turn"


def open_car(machine: Machine, *args: str) -> CarModel:
    """Start car_view; if there is a description, wait until it is read."""
    machine.start("day6_bot", "car_view", *args, screen=True)
    window = machine.display.windows[-1]
    assert (window.kind, window.title) == ("car", "car_view")
    model: CarModel = window.model
    machine.until(lambda: model.waiting_description is None)
    return model


def texts(model: CarModel) -> list[str]:
    return [line.text for line in model.snapshot().status]


def angles(model: CarModel) -> list[float]:
    """How far each wheel is turned in the picture: by the transforms alone."""
    moment = model.snapshot()
    assert moment.robot is not None
    return [spin_of(wheel, moment.transforms) for wheel in find_wheels(moment.robot)]


def spin(machine: Machine, *args: str) -> Running:
    return machine.start("day6_bot", "wheel_spinner", *args)


def test_the_wheels_turn_one_radian_a_second_while_wheel_spinner_runs(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    spin(machine)
    machine.advance(1.0)
    first = angles(model)
    machine.advance(0.9)  # robot_state_publisher lets every third message through: 0.06 s
    second = angles(model)
    assert [b - a for a, b in zip(first, second, strict=True)] == pytest.approx([0.9, 0.9], abs=1e-9)
    assert texts(model) == [STAYS]


def test_joint_angles_and_speeds_stand_beside_it(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    spin(machine)
    machine.advance(3.0)
    left, right = model.snapshot().joints
    assert (left.name, right.name, left.known) == ("left_wheel_joint", "right_wheel_joint", True)
    assert left.position == pytest.approx(3.0)
    assert left.speed == pytest.approx(1.0)
    assert model.snapshot().rate == pytest.approx(50.0)
    assert model.snapshot().labels()["left_wheel"] == ("left_wheel", "172 deg", "+1.00 rad/s")


def test_stop_the_node_and_they_stop_and_nothing_is_drawn_again(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    running = spin(machine)
    machine.advance(2.0)
    running.program.interrupt()
    machine.advance(3.0)
    stopped, version = angles(model), model.version
    assert texts(model) == [NO_JOINT_STATES]
    assert [reading.speed for reading in model.snapshot().joints] == [0.0, 0.0]
    machine.advance(5.0)
    assert (angles(model), model.version) == (stopped, version)


def test_two_publishers_make_the_wheels_jitter_and_are_named(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    spin(machine)
    machine.advance(0.01)  # nobody starts two programs in the same millisecond
    spin(machine, "--ros-args", "-r", "__node:=joint_state_publisher_gui", "-p", "step:=0.0")
    seen = []
    for _ in range(100):
        machine.advance(0.02)
        seen.append(angles(model)[0])
    back = sum(b < a - 0.01 for a, b in zip(seen, seen[1:], strict=False))  # noqa: RUF007
    assert back > 3
    assert "2 publishers on /joint_states: joint_state_publisher_gui, wheel_spinner" in texts(model)


def test_a_wrong_joint_name_moves_nothing_and_the_right_one_is_suggested(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    spin(machine, "--ros-args", "-p", "joints:=[wheel_left_joint, wheel_right_joint]")
    machine.advance(2.0)
    assert sorted(model.snapshot().transforms) == ["base_link", "caster"]
    assert texts(model) == [
        "joint wheel_left_joint is not in the URDF; did you mean left_wheel_joint?",
        "joint wheel_right_joint is not in the URDF; did you mean right_wheel_joint?",
        "no transform from left_wheel to base_link",
        "no transform from right_wheel to base_link",
    ]


def test_it_says_step_by_step_what_is_missing(machine: Machine) -> None:
    model = open_car(machine)
    machine.advance(0.6)
    assert texts(model) == ["nobody has published /robot_description yet: is robot_state_publisher running?"]
    machine.publish_robot()
    machine.until(lambda: model.snapshot().robot is not None)
    assert texts(model) == [
        NO_JOINT_STATES,
        "no transform from left_wheel to base_link",
        "no transform from right_wheel to base_link",
    ]
    spin(machine)
    machine.advance(1.0)
    assert texts(model) == [STAYS]


def test_while_the_description_is_read_it_says_so(machine: Machine) -> None:
    model = CarModel(machine.node, machine.clock.steady_ns)
    machine.publish_robot()
    assert texts(model) == ["reading the robot description"]
    assert model.waiting_description is not None
    model.show(plan_top(parse_robot(model.waiting_description)))
    assert texts(model)[0] == NO_JOINT_STATES


def test_another_type_on_joint_states_is_named(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    machine.node.create_publisher(Float64MultiArray, "/joint_states", 10)
    machine.advance(1.0)
    assert "/joint_states has type std_msgs/msg/Float64MultiArray, but it must be sensor_msgs/msg/JointState" in texts(
        model
    )


def test_one_message_a_second_is_called_slow_and_none_silent(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    for step in range(5):
        machine.joint_states(["left_wheel_joint", "right_wheel_joint"], [0.02 * step] * 2, after=1.0)
    machine.advance(0.4)
    assert "/joint_states arrives only 1.0 times a second: the eye needs about 20" in texts(model)
    machine.advance(2.6)
    assert "nothing on /joint_states for 3 s" in texts(model)


def test_a_broken_description_is_explained_and_a_good_one_after_it_is_shown(machine: Machine) -> None:
    model = open_car(machine)
    publisher = machine.node.create_publisher(String, "/robot_description", LATCHED)
    publisher.publish(String(data='<robot name="r"><link name="a"/><link name="b"/></robot>'))
    machine.until(lambda: texts(model)[0].startswith("the robot description is broken"))
    assert texts(model) == [
        "the robot description is broken: Failed to find root link: Two root links found: [a] and [b]"
    ]
    publisher.publish(String(data='<robot name="r"><link name="a"/></robot>'))
    machine.until(lambda: model.snapshot().robot is not None)
    assert texts(model)[0].startswith("this robot has no wheels")


def test_a_prefix_before_the_frames_is_a_parameter(machine: Machine) -> None:
    machine.publish_robot("--ros-args", "-p", "frame_prefix:=robot1/")
    model = open_car(machine, "--ros-args", "-p", "tf_prefix:=robot1/")
    spin(machine)
    machine.advance(1.0)
    assert len(model.snapshot().transforms) == 4
    other = open_car(machine, "--ros-args", "-r", "__node:=without_prefix")
    machine.advance(1.0)
    assert "no transform from caster to base_link" in texts(other)


def test_closing_the_window_ends_the_program(machine: Machine) -> None:
    running = machine.start("day6_bot", "car_view", screen=True)
    machine.display.windows[0].close_by_user()
    machine.advance(0.1)
    assert running.program.status == 130
    assert machine.display.windows == []
    assert "car_view" not in machine.node.get_node_names()


def test_without_a_screen_the_car_is_printed_once(machine: Machine) -> None:
    machine.publish_robot()
    spin(machine)
    running = machine.start("day6_bot", "car_view")
    machine.until(lambda: machine.advance(0.05) or running.program.status is not None)
    assert running.program.status == 0
    rows = running.output.splitlines()
    assert any("==>" in row for row in rows) and any("+1.00 rad/s" in row for row in rows)
    assert all(len(row) <= 80 for row in rows)


def test_without_a_screen_a_description_that_takes_long_to_read_is_waited_for(
    machine: Machine, monkeypatch: pytest.MonkeyPatch
) -> None:
    may_go_on = threading.Event()
    monkeypatch.setattr(car_view, "load_robot", lambda *of: may_go_on.wait(PATIENCE) and parse_robot(*of))
    machine.publish_robot()
    running = machine.start("day6_bot", "car_view")
    machine.advance(5.0)
    assert running.program.status is None
    may_go_on.set()
    machine.until(lambda: machine.advance(0.05) or running.program.status is not None)
    assert running.program.status == 0


def test_without_a_screen_and_without_a_robot_it_says_why_and_fails(machine: Machine) -> None:
    running = machine.start("day6_bot", "car_view")
    machine.advance(3.0)
    assert running.program.status == 1
    said = "nobody has published /robot_description yet: is robot_state_publisher running?"
    assert " ".join(running.output.split()) == said


def test_a_snapshot_does_not_change_under_whoever_reads_it(machine: Machine) -> None:
    machine.publish_robot()
    model = open_car(machine)
    spin(machine)
    machine.advance(1.0)
    moment = model.snapshot()
    before = (moment.version, dict(moment.transforms), moment.joints)
    machine.advance(1.0)
    assert (moment.version, dict(moment.transforms), moment.joints) == before
    assert model.snapshot().version > moment.version
    assert math.isclose(sum(n * n for n in moment.transforms["left_wheel"].rotation), 1.0)


def test_a_users_own_car_is_shown_too(machine: Machine, tmp_path: Path) -> None:
    file = tmp_path / "own.urdf"
    wheel = (
        '<link name="{0}"><visual><origin rpy="1.5707963 0 0"/><geometry><cylinder radius="0.1" length="0.05"/></geometry>'
        '</visual></link><joint name="{0}轴" type="continuous"><parent link="底盘"/><child link="{0}"/>'
        '<origin xyz="0 {1} 0"/><axis xyz="0 1 0"/></joint>'
    )
    body = '<link name="底盘"><visual><geometry><box size="0.5 0.3 0.1"/></geometry></visual></link>'
    file.write_text(
        f'<robot name="小车">{body}{wheel.format("左轮", 0.2)}{wheel.format("右轮", -0.2)}</robot>', encoding="utf-8"
    )
    machine.start("robot_state_publisher", "robot_state_publisher", str(file))
    model = open_car(machine)
    machine.joint_states(["左轮轴", "右轮轴"], [0.5, -0.5])
    assert angles(model) == pytest.approx([-0.5, 0.5])  # sorted by name: 右 comes before 左


ACKERMANN = """<robot name="truck">
  <link name="chassis"><visual><geometry><box size="1.0 0.5 0.2"/></geometry></visual></link>
  {wheels}
</robot>"""
WHEEL = """<link name="{0}"><visual><origin rpy="1.5707963 0 0"/><geometry><cylinder radius="0.15" length="0.08"/></geometry>
  </visual></link><joint name="{0}_spin" type="continuous"><parent link="{1}"/><child link="{0}"/>
  <origin xyz="{2} {3} 0"/><axis xyz="0 1 0"/></joint>"""
KNUCKLE = """<link name="{0}"/><joint name="{0}_steer" type="revolute"><parent link="chassis"/><child link="{0}"/>
  <origin xyz="0.35 {1} 0"/><axis xyz="0 0 1"/><limit lower="-0.6" upper="0.6" effort="1" velocity="1"/></joint>"""


def test_steered_wheels_are_drawn_turned_and_say_how_far(machine: Machine, tmp_path: Path) -> None:
    parts = [KNUCKLE.format(side, y) for side, y in (("left", 0.3), ("right", -0.3))]
    parts += [WHEEL.format(f"{side}_front", side, 0, 0) for side in ("left", "right")]
    parts += [WHEEL.format(f"{side}_rear", "chassis", -0.35, y) for side, y in (("left", 0.3), ("right", -0.3))]
    file = tmp_path / "truck.urdf"
    file.write_text(ACKERMANN.format(wheels="".join(parts)), encoding="utf-8")
    machine.start("robot_state_publisher", "robot_state_publisher", str(file))
    model = open_car(machine)
    names = ["left_steer", "right_steer", *(f"{a}_{b}_spin" for a in ("left", "right") for b in ("front", "rear"))]
    machine.joint_states(names, [0.5, 0.5, 0.0, 0.0, 0.0, 0.0])
    moment = model.snapshot()
    assert moment.labels()["left_front"] == ("left_front", "0 deg", "+0.00 rad/s", "<+29 deg>")
    assert moment.labels()["left_rear"] == ("left_rear", "0 deg", "+0.00 rad/s")
    assert moment.plan is not None
    turned = render_top(moment.plan, moment.transforms, 100, 40, labels=moment.labels())
    straight = render_top(moment.plan, {}, 100, 40)
    assert [["".join(t for t, _ in row)] for row in turned] != [["".join(t for t, _ in row)] for row in straight]


def test_the_picture_can_be_enlarged(machine: Machine) -> None:
    car = plan_top(parse_robot(shipped_model()))

    def wide(zoom: float) -> int:
        rows = ["".join(text for text, _ in row) for row in render_top(car, {}, 120, 50, zoom=zoom)]
        assert all(len(row) == 120 for row in rows)
        return max(row.rstrip().rfind("+") - row.find("+") for row in rows if "+" in row)

    assert wide(0.3) < wide(0.6) < wide(1.0)


def test_the_picture_can_be_moved() -> None:
    car = plan_top(parse_robot(shipped_model()))
    lines = []
    for down in (0, 5):
        rows = ["".join(text for text, _ in row) for row in render_top(car, {}, 90, 30, shift=(0, down))]
        lines.append(next(number for number, row in enumerate(rows) if "base_link" in row))
    assert lines[0] + 5 == lines[1]
