"""The tools: what they publish, by the mouse and by keys, and what of them is in the .rviz file."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest
from geometry_msgs.msg import PointStamped, PoseStamped, PoseWithCovarianceStamped

from day6_core.ros.programs.rviz2.model.config import read_config, write_config
from tests.rviz2.rviz_machine import ONE_LINK, RVizMachine
from tests.rviz2.rviz_walk import drag, run, walking

if TYPE_CHECKING:
    pass

BOX = ONE_LINK.replace(
    '<link name="base_link"/>',
    '<link name="base_link"><visual><geometry><box size="2 2 1"/></geometry></visual></link>',
)


def listen(machine: RVizMachine, kind: type, topic: str) -> list[Any]:
    heard: list[Any] = []
    machine.node.create_subscription(kind, topic, heard.append, 10)
    machine.settle()
    return heard


def test_the_tools_of_the_default_file_and_their_publishers(machine: RVizMachine) -> None:
    rviz = machine.open()
    assert [tool.title for tool in rviz.tools.tools] == [
        "Interact",
        "Move Camera",
        "Select",
        "Focus Camera",
        "Measure",
        "2D Pose Estimate",
        "2D Goal Pose",
        "Publish Point",
    ]
    assert rviz.tools.current is rviz.tools.tools[0]
    published = dict(machine.node.get_publisher_names_and_types_by_node("rviz", "/"))
    assert published["/goal_pose"] == ["geometry_msgs/msg/PoseStamped"]
    assert published["/initialpose"] == ["geometry_msgs/msg/PoseWithCovarianceStamped"]
    assert published["/clicked_point"] == ["geometry_msgs/msg/PointStamped"]


def test_a_goal_by_keys_alone(machine: RVizMachine) -> None:
    async def walk() -> None:
        goals = listen(machine, PoseStamped, "/goal_pose")
        async with walking(machine) as at:
            await at.press("g")
            assert "Click and drag mouse to set position/orientation." in at.screen()
            await at.press("up")  # shows the cursor in the middle of the view
            # The camera looks along -x and -y alike; the first of the two axes is "up".
            await at.press("up", "up", "right", "enter", "left", "left", "shift+left", "enter")
            (goal,) = goals
            assert goal.header.frame_id == "map" and goal.header.stamp.sec > 0
            place = goal.pose.position
            assert {abs(place.x), abs(place.y)} == {1.0, 0.5} and place.z == 0
            angle = 2 * math.atan2(goal.pose.orientation.z, goal.pose.orientation.w)
            assert math.degrees(angle) == pytest.approx(31)
            assert machine.rviz.tools.current is machine.rviz.tools.default
            assert "Setting goal pose: Frame:map, Position(" in machine.running.errors

    run(walk())


@pytest.mark.parametrize(("width", "height"), [(120, 40), (80, 24)])
def test_a_pose_estimate_by_the_mouse(machine: RVizMachine, width: int, height: int) -> None:
    async def walk() -> None:
        poses = listen(machine, PoseWithCovarianceStamped, "/initialpose")
        async with walking(machine, width, height) as at:
            machine.do(lambda: machine.rviz.set_view("TopDownOrtho"))
            await at.press("p")
            middle = at.pane.view.columns // 2, at.pane.view.rows // 2
            await drag(at, middle, (middle[0], middle[1] - 3))
            (pose,) = poses
            assert pose.header.frame_id == "map"
            assert abs(pose.pose.pose.position.x) < 0.5 and abs(pose.pose.pose.position.y) < 0.7
            turn = pose.pose.pose.orientation
            assert 2 * math.atan2(turn.z, turn.w) == pytest.approx(math.pi / 2)
            covariance = {number: value for number, value in enumerate(pose.pose.covariance) if value}
            assert covariance == {0: 0.25, 7: 0.25, 35: pytest.approx((math.pi / 12) ** 2)}

    run(walk())


def test_esc_and_a_second_press_leave_a_tool(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            tools = machine.rviz.tools
            for keys in (("g", "g"), ("g", "escape"), ("g", "i")):
                await at.press(*keys)
                assert tools.current is not None and tools.current.type == "Interact"
            await at.press("m", "left")
            assert machine.rviz.view.child("Yaw").value > 0.79

    run(walk())


def test_the_toolbar_is_clicked(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, 80, 24) as at:
            row = at.line("Estimate")
            assert "g Goal" in row and "u Point" in row
            await at.pilot.click(at.pane, offset=(row.index("Goal"), 1))
            await at.settle()
            assert machine.rviz.tools.current.title == "2D Goal Pose"

    run(walk())


@pytest.mark.parametrize("keys", [False, True])
def test_publish_point_takes_the_surface_and_never_the_ground(machine: RVizMachine, keys: bool) -> None:
    async def walk() -> None:
        points = listen(machine, PointStamped, "/clicked_point")
        async with walking(machine) as at:
            machine.do(lambda: machine.rviz.set_view("TopDownOrtho"))
            machine.fix("base_link")
            machine.transform("base_link", "other")
            await at.press("u")
            middle = at.pane.view.columns // 2, at.pane.view.rows // 2
            await drag(at, middle)
            assert not points and "Move over an object to select the target point." in at.screen()
            machine.robot(BOX)
            await at.press("enter", "enter") if keys else await drag(at, middle)
            (point,) = points
            assert point.header.frame_id == "base_link"
            assert point.point.z == pytest.approx(0.5, abs=0.01)
            assert machine.rviz.tools.current is machine.rviz.tools.default

    run(walk())


def test_measure_says_the_distance(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.do(lambda: machine.rviz.set_view("TopDownOrtho"))
            machine.rviz.view.child("Scale").set(100)
            machine.fix("base_link")
            machine.transform("base_link", "other")
            machine.robot(BOX)
            await at.press("n")
            x, y = at.pane.view.columns // 2, at.pane.view.rows // 2
            await drag(at, (x - 6, y))
            await drag(at, (x + 6, y))
            cell = 600 / 100 / at.pane.view.rows / 2
            assert f"[Length: {12 * cell:.6g}m]" in at.screen()
            lines = len(machine.rviz.scene.lines)
            await drag(at, (x, y), button=3)
            await at.settle()
            assert len(machine.rviz.scene.lines) == lines - 1

    run(walk())


def test_select_lists_the_link_and_its_pose(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.fix("base_link")
            machine.transform("base_link", "other")
            machine.robot(BOX)
            await at.press("s")
            await drag(at, (at.pane.view.columns // 2, at.pane.view.rows // 2))
            (line,) = machine.rviz.selection.properties.children
            assert line.name == "Link base_link"
            assert [(each.name, each.text) for each in line.children] == [
                ("Position", "0; 0; 0"),
                ("Orientation", "0; 0; 0; 1"),
            ]
            assert "Link base_link, Position 0; 0; 0" in at.screen()

    run(walk())


def test_f_looks_at_what_is_selected(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.fix("base_link")
            machine.transform("base_link", "hand", (3.0, 0.0, 0.0))
            machine.robot(BOX)
            frames = machine.add("TF")
            machine.do(lambda: machine.rviz.selection.replace([(frames, "hand")]))
            await at.press("f")
            x, y, z = machine.rviz.view.child("Focal Point").value
            # About the middle of its axes, which are 0.2 m long, and of the arrow to its parent.
            assert 1.0 < x < 3.2 and (y, z) == (pytest.approx(0.0, abs=0.2), pytest.approx(0.0, abs=0.2))
            machine.do(lambda: machine.rviz.selection.replace([]))
            await at.press("f")
            assert math.dist(machine.rviz.view.child("Focal Point").value, (0.0, 0.0, 0.0)) < 0.3

    run(walk())


def test_alt_leaves_the_mouse_to_the_view_while_a_tool_is_used(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await at.press("s")
            yaw = machine.rviz.view.child("Yaw").value
            await drag(at, (10, 10), (14, 10))
            assert machine.rviz.view.child("Yaw").value == yaw
            await drag(at, (10, 10), (14, 10), alt=True)
            assert machine.rviz.view.child("Yaw").value != yaw

    run(walk())


def test_focus_camera_looks_at_what_was_clicked(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.fix("base_link")
            machine.transform("base_link", "other")
            machine.robot(BOX)
            await at.settle()
            before = machine.rviz.view.camera().position
            await at.press("c")
            await drag(at, (at.pane.view.columns // 2, at.pane.view.rows // 2))
            focus = machine.rviz.view.child("Focal Point").value
            assert 0.4 < focus[2] < 0.6
            assert machine.rviz.view.camera().position == pytest.approx(before)

    run(walk())


CONFIG = """\
Visualization Manager:
  Tools:
    - Class: rviz_default_plugins/MoveCamera
    - Class: rviz_default_plugins/SetInitialPose
      Covariance x: 1
      Covariance y: 0.25
      Covariance yaw: 0.06853892
      Topic:
        Depth: 7
        Durability Policy: Transient Local
        History Policy: Keep Last
        Reliability Policy: Reliable
        Value: /here
    - Class: somebodys_plugins/Broom
      Strength: 3
"""


def test_tools_of_a_file_are_kept(machine: RVizMachine) -> None:
    rviz = machine.open()
    machine.do(lambda: rviz.load_text(CONFIG))
    saved = read_config(write_config(rviz.save()))["Visualization Manager"]["Tools"]
    wanted = read_config(CONFIG)["Visualization Manager"]["Tools"]
    saved[1]["Covariance yaw"] = pytest.approx(saved[1]["Covariance yaw"])
    assert wanted == saved
    published = dict(machine.node.get_publisher_names_and_types_by_node("rviz", "/"))
    assert "/here" in published and "/goal_pose" not in published and "/initialpose" not in published


def test_a_name_that_is_no_topic_is_told(machine: RVizMachine) -> None:
    rviz = machine.open()
    topic = rviz.tools.properties.child("2D Goal Pose", "Topic")
    rviz.edit(topic, "my goal")
    machine.settle()
    assert rviz.message is not None and rviz.message[0] == "rviz.tool.bad_topic"
    rviz.edit(topic, "/mine")
    machine.settle()
    assert "/mine" in dict(machine.node.get_publisher_names_and_types_by_node("rviz", "/"))
