"""The first robot: the picture comes first, the panel folds away, the camera looks at it, and what is wrong is told."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from day6_core.ros.programs.rviz2.model.config import read_config
from day6_core.ros.programs.rviz2.model.scene import BOX, Lines, Points, Scene, Shape
from day6_core.ros.programs.rviz2.model.status import ERROR
from day6_tui.render.picture import RenderedPicture
from day6_tui.windows.rviz.extent import ball, outline
from day6_urdf import shipped_model
from day6_urdf.kinematics import Transform
from tests.rviz2.rviz_walk import Walk, run, walking

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.rviz2.rviz_machine import RVizMachine

OFFER = "see the robot up close"
PANES = [(38, 21), (58, 11), (78, 11), (118, 36), (20, 9)]
"""Columns and rows of RViz's window, with its frame."""

FAR_AWAY = """\
Visualization Manager:
  Displays:
    - {Class: rviz_default_plugins/RobotModel, Name: RobotModel, Description Topic: {Value: /robot_description}}
  Global Options: {Fixed Frame: base_link}
  Views:
    Current: {Class: rviz_default_plugins/Orbit, Distance: %s, Pitch: 0.5, Yaw: 0.5}
"""


def in_pane(size: tuple[int, int]) -> tuple[int, int]:
    """The desktop in which the enlarged window has this size."""
    return size[0], size[1] + 3


async def with_the_car(at: Walk, machine: RVizMachine) -> Any:
    """What the article does: the program that reads the plan, the Fixed Frame, the display."""
    machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
    machine.settle()
    machine.fix("base_link")
    robot = machine.add("RobotModel", "/robot_description")
    machine.until(lambda: robot.status("URDF") is not None)
    await at.settle()
    return robot


def blue_part(at: Walk) -> tuple[float, float]:
    """How much of the picture's width and height the blue chassis takes."""
    cells = at.pane.view.cells
    blue = np.zeros(cells.back.shape, bool)
    for colours in (cells.back, cells.front):
        blue |= (colours >= 0) & ((colours & 255) > 2 * (colours >> 16))
    rows, columns = blue.shape
    return blue.any(axis=0).sum() / columns, blue.any(axis=1).sum() / rows


def is_whole(at: Walk) -> bool:
    """Whether all of the robot is in the picture."""
    view, rviz = at.pane.view, at.machine.rviz
    picture = RenderedPicture(view.columns, view.rows, 0.5, rviz.view.camera(), (0, 0, 0))
    x, y = picture.project(picture.seen(np.array(outline(rviz.scene))))
    return bool(((x >= 0) & (x <= view.columns) & (y >= 0) & (y <= view.rows)).all())


# -- the camera --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("size", PANES)
def test_the_first_robot_fills_the_picture_whatever_its_size(machine: RVizMachine, size: tuple[int, int]) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane(size)) as at:
            assert max(blue_part(at)) == 0
            await with_the_car(at, machine)
            await at.until(lambda: max(blue_part(at)) > 0.5)
            assert OFFER not in at.screen() and is_whole(at)

    run(walk())


def test_it_is_framed_again_when_the_window_changes_until_somebody_moves_the_camera(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, 120, 40) as at:
            await with_the_car(at, machine)
            await at.pilot.resize_terminal(30, 36)
            await at.until(lambda: blue_part(at)[0] > 0.5 and is_whole(at))
            await at.press("tab", "plus", "plus", "left")
            camera = machine.rviz.view.camera()
            await at.pilot.resize_terminal(120, 40)
            await at.settle()
            assert machine.rviz.view.camera() == camera

    run(walk())


def test_the_desktop_keeps_a_camera_that_somebody_moved_and_no_other(machine: RVizMachine) -> None:
    def kept(at: Walk) -> Any:
        config = read_config(json.loads(at.pane.kept_view())["config"])
        return config["Visualization Manager"]["Views"]["Current"]["Distance"]

    async def walk() -> None:
        async with walking(machine) as at:
            await with_the_car(at, machine)
            distance = machine.rviz.view.child("Distance").value
            assert distance < 1 and kept(at) == 10
            await at.press("tab", "plus")
            assert kept(at) == pytest.approx(0.88 * distance, abs=1e-3)
            # What is saved in a file is what is seen.
            assert machine.rviz.save()["Visualization Manager"]["Views"]["Current"]["Distance"] < 1

    run(walk())


def test_a_wheel_that_gets_its_place_is_in_the_picture_too(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await with_the_car(at, machine)
            distance = machine.rviz.view.child("Distance").value
            for side, y in (("left", 0.6), ("right", -0.6)):
                machine.transform("base_link", f"{side}_wheel", (0.0, y, 0.05))
            await at.settle()
            assert machine.rviz.view.child("Distance").value > 1.5 * distance

    run(walk())


@pytest.mark.parametrize(("keys", "offered"), [(["tab", "left"], True), (["tab", *["plus"] * 16], False)])
def test_a_camera_that_was_moved_stays_and_to_frame_a_speck_is_offered(
    machine: RVizMachine, keys: list[str], offered: bool
) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await at.press(*keys)
            camera = machine.rviz.view.camera()
            await with_the_car(at, machine)
            assert machine.rviz.view.camera() == camera and (f"f  {OFFER}" in at.screen()) is offered
            await at.press("f")
            assert OFFER not in at.screen()
            await at.until(lambda: max(blue_part(at)) > 0.5)
            await at.press("z")
            assert OFFER not in at.screen()

    run(walk())


@pytest.mark.parametrize(("distance", "offered"), [("8.0", True), ("0.9", False)])
def test_what_a_file_says_of_the_view_stays(machine: RVizMachine, tmp_path: Path, distance: str, offered: bool) -> None:
    async def walk() -> None:
        file = tmp_path / "robot.rviz"
        file.write_text(FAR_AWAY % distance, encoding="utf-8")
        machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
        async with walking(machine, args=("-d", str(file))) as at:
            (robot,) = machine.rviz.displays
            machine.until(lambda: robot.status("URDF") is not None)
            await at.settle()
            assert machine.rviz.view.child("Distance").value == float(distance)
            assert (OFFER in at.screen()) is offered

    run(walk())


def test_another_file_is_another_beginning(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await with_the_car(at, machine)
            await at.press("tab", "left", "minus")
            for distance, offered in (("8.0", True), ("10", False)):
                text = FAR_AWAY % distance
                start = text.replace("0.5", "0.785398") if distance == "10" else text
                machine.do(lambda text=start: machine.rviz.load_text(text))
                (robot,) = machine.rviz.displays
                machine.until(lambda robot=robot: robot.status("URDF") is not None)
                await at.settle()
                assert (OFFER in at.screen()) is offered
            await at.until(lambda: max(blue_part(at)) > 0.5)

    run(walk())


def test_a_click_takes_the_offer_and_a_moved_camera_ends_it(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await at.press("tab", "left")
            await with_the_car(at, machine)
            row = next(y for y, line in enumerate(at.screen().splitlines()) if OFFER in line)
            await at.pilot.click(at.pane, offset=(at.screen().splitlines()[row].index(OFFER), row - 1))
            await at.settle()
            assert OFFER not in at.screen() and machine.rviz.view.child("Distance").value < 2.0

    run(walk())

    async def moved() -> None:
        async with walking(machine) as at:
            await at.press("tab", "right")
            machine.fix("base_link")
            machine.add("RobotModel", "/robot_description")
            machine.until(lambda: machine.rviz.scene.shapes)
            await at.settle()
            assert OFFER in at.screen()
            await at.press("minus")
            assert OFFER not in at.screen()

    run(moved())


def test_a_wrong_fixed_frame_frames_nothing(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane((58, 20))) as at:
            machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
            robot = machine.add("RobotModel", "/robot_description")
            machine.until(lambda: robot.status("URDF") is not None)
            await at.settle()
            assert machine.rviz.statuses.level == ERROR
            assert machine.rviz.view.at_start and "Fixed Frame" in at.screen() and at.pane.panel_open

    run(walk())


def test_f_looks_at_whatever_there_is_without_a_robot() -> None:
    scene = Scene(lines=[Lines([(-50.0, 0.0, 0.0), (50.0, 0.0, 0.0)], [(1.0, 1.0, 1.0, 1.0)], lattice=True)])
    assert not outline(scene)
    scene.points.append(Points([(2.0, 0.0, 0.0)], [(1.0, 0.0, 0.0, 1.0)]))
    assert ball(outline(scene)) == ((2.0, 0.0, 0.0), 1e-3)
    scene.lines.append(Lines([(0.0, 0.0, 0.0), (4.0, 0.0, 0.0)], [(1.0, 1.0, 1.0, 1.0)]))
    scene.shapes.append(Shape(BOX, Transform((2.0, 0.0, 0.0)), (1.0, 6.0, 0.0), (1.0, 1.0, 1.0, 1.0)))
    assert ball(outline(scene)) == ((2.0, 0.0, 0.0), math.hypot(2.0, 3.0))
    scene.shapes.append(Shape(BOX, Transform((9.0, 0.0, 0.0)), (2.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0), "base_link"))
    assert ball(outline(scene)) == ((9.0, 0.0, 0.0), 1.0)


# -- the panel ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("width", "panel"), [(62, False), (100, True)])
def test_a_saved_view_of_a_robot_opens_with_the_picture_in_a_narrow_window(
    machine: RVizMachine, tmp_path: Path, width: int, panel: bool
) -> None:
    async def walk() -> None:
        file = tmp_path / "robot.rviz"
        file.write_text(
            "Visualization Manager:\n  Displays:\n    - {Class: rviz_default_plugins/RobotModel, Name: RobotModel}\n",
            encoding="utf-8",
        )
        async with walking(machine, width, 20, args=("-d", str(file))) as at:
            assert ("Frame Rate" in at.screen()) is panel

    run(walk())


NARROW = [(38, 21), (58, 11)]


@pytest.mark.parametrize("size", NARROW)
def test_a_new_narrow_window_shows_the_tree_and_a_picture_and_the_robot_gets_all_of_it(
    machine: RVizMachine, size: tuple[int, int]
) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane(size)) as at:
            assert "Global Options" in at.screen() and at.pane.on_panel
            assert at.pane.view.columns >= 20 and at.pane.view.rows >= 7
            await with_the_car(at, machine)
            assert "Global Options" not in at.screen() and at.pane.view.columns == size[0] - 3
            # The keys follow to what is seen.
            yaw = machine.rviz.view.child("Yaw").value
            await at.press("left")
            assert machine.rviz.view.child("Yaw").value > yaw

    run(walk())


@pytest.mark.parametrize("size", NARROW)
@pytest.mark.parametrize("key", ["d", "tab"])
def test_who_opens_the_panel_by_hand_keeps_it(machine: RVizMachine, size: tuple[int, int], key: str) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane(size)) as at:
            await at.press("tab", key)  # folded, and opened again
            assert at.pane.on_panel
            await with_the_car(at, machine)
            assert "Global Options" in at.screen() and at.pane.view.columns >= 20
            await at.press(key)
            assert "Global Options" not in at.screen()

    run(walk())


@pytest.mark.parametrize("size", [*NARROW, (78, 11)])
def test_when_the_wheels_start_the_car_is_on_the_screen_and_they_turn(
    machine: RVizMachine, size: tuple[int, int]
) -> None:
    from sensor_msgs.msg import JointState

    async def walk() -> None:
        async with walking(machine, *in_pane(size)) as at:
            await with_the_car(at, machine)
            pictures = set()
            for step in range(6):
                message = JointState(name=["left_wheel_joint", "right_wheel_joint"], position=[0.4 * step] * 2)
                message.header.stamp = machine.stamp()
                machine.publish("/joint_states", message)
                await at.until(lambda: at.pane.view._painted[:1] == (machine.rviz.version,))
                cells = at.pane.view.cells
                pictures.add((cells.front.tobytes(), cells.back.tobytes(), cells.chars.tobytes()))
                assert is_whole(at) and max(blue_part(at)) > 0.5
            assert len(pictures) > 3
            assert "▲" not in at.screen() and at.pane.panel_open is (size[0] > 72)

    run(walk())


def test_a_value_being_typed_is_not_taken_away(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane((58, 20))) as at:
            at.pane.choose(machine.rviz.options.child("Frame Rate"))
            await at.press("enter", "backspace")
            await with_the_car(at, machine)
            await at.type("5")
            assert at.pane.panel_open
            await at.press("enter")
            await at.settle()
            assert machine.rviz.options.child("Frame Rate").value == 35 and not at.pane.panel_open

    run(walk())


def test_a_wide_window_keeps_both(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane((78, 11))) as at:
            await with_the_car(at, machine)
            assert "Global Options" in at.screen() and at.pane.view.columns > 40

    run(walk())


# -- what is wrong -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("size", [*NARROW, (118, 36), (20, 6)])
def test_while_the_panel_is_folded_one_line_says_what_is_wrong(machine: RVizMachine, size: tuple[int, int]) -> None:
    async def walk() -> None:
        async with walking(machine, *in_pane(size)) as at:
            await at.press("d")
            assert "▲ Fixed F" in at.screen() and not at.pane.panel_open
            await with_the_car(at, machine)
            line = at.line("▲ RobotModel")
            assert "+1" in line  # both wheels
            assert size[0] < 100 or "No transform from [left_wheel] to [base_link]" in line
            for side in ("left", "right"):
                machine.transform("base_link", f"{side}_wheel")
            await at.settle()
            assert "▲" not in at.screen()
            machine.fix("map")
            await at.settle()
            assert "▲ Fixed F" in at.screen()

    run(walk())


def test_a_click_on_that_line_leads_to_the_tree_and_f1_explains_it(machine: RVizMachine) -> None:
    from day6_tui.overlays.card import CardModal

    async def walk() -> None:
        async with walking(machine, *in_pane((58, 20))) as at:
            await at.press("d")
            await at.press("f1")
            assert isinstance(at.app.desktop.overlay, CardModal)
            await at.press("escape")
            row = next(y for y, line in enumerate(at.screen().splitlines()) if "▲ Fixed Frame" in line)
            await at.pilot.click(offset=(10, row))
            await at.settle()
            assert at.pane.panel.properties.prop is machine.rviz.statuses.lines[0] and at.pane.on_panel

    run(walk())


def test_a_capsule_is_a_cylinder_with_round_ends(machine: RVizMachine, in_distribution: Callable[[str], None]) -> None:
    in_distribution("lyrical")
    machine.open()
    capsule = '<origin xyz="1 0 0"/><geometry><capsule radius="0.1" length="0.4"/></geometry>'
    robot = f'<robot name="r" version="1.1"><link name="base_link"><visual>{capsule}</visual></link></robot>'
    display = machine.robot(robot)
    assert display.status("URDF")[0] == "Ok"
    shapes = [(shape.kind, shape.size, shape.pose.xyz) for shape in machine.rviz.scene.shapes]
    assert sorted(shapes) == [
        ("cylinder", (0.2, 0.2, 0.4), (1.0, 0.0, 0.0)),
        ("sphere", (0.2, 0.2, 0.2), (1.0, 0.0, -0.2)),
        ("sphere", (0.2, 0.2, 0.2), (1.0, 0.0, 0.2)),
    ]
