"""The RViz window: the article's three settings by keys alone, editing, dialogs, the mouse, and pictures as files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from textual import events

from day6_urdf import shipped_model
from tests.rviz2.rviz_machine import lines
from tests.rviz2.rviz_walk import Walk, mouse, run, walking
from tests.tui.screens import is_drawn_in_ascii

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine


def test_the_three_settings_by_keys_alone(machine: RVizMachine) -> None:
    async def walk() -> None:
        machine.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()))
        async with walking(machine) as at:
            assert "Global Status: Error" in at.screen() and "Frame [map] does not" in at.screen()
            await at.press("down", "enter")  # Fixed Frame: choices from /tf
            assert "caster" in at.screen()
            await at.type("base")
            await at.press("enter")
            assert machine.rviz.fixed_frame == "base_link" and "Global Status: Ok" in at.screen()
            await at.press("ctrl+n")
            await at.type("robotm")
            await at.press("enter")
            await at.settle()
            (robot,) = [display for display in machine.rviz.displays if display.type == "RobotModel"]
            assert at.pane.panel.properties.prop is robot
            assert "Enter on Description Topic lets you choose: /robot_description" in " ".join(at.screen().split())
            for _ in range(20):
                if at.pane.panel.properties.prop is not robot.topic:
                    await at.press("down")
            await at.press("enter", "enter")
            machine.until(lambda: robot.status("URDF") is not None)
            await at.settle()
            assert robot.topic.value == "/robot_description"
            await at.press("tab", "f")
            at.pane.status_bar.hurry()
            await at.settle()
            assert "blue box base_link 0.4×0.25×0.08 m" in " ".join(at.screen().split())
            at.app.look.texts.language = "zh"
            at.app.looks.redraw()
            await at.settle()
            assert "蓝色长方体 base_link 0.4×0.25×0.08 米" in " ".join(at.screen().split())
            await at.until(lambda: sum(colour & 255 > 2 * (colour >> 16) for colour in _colours(at)) > 200)

    run(walk())


def _colours(at: Walk) -> list[int]:
    cells = at.pane.view.cells
    return [int(colour) for row in cells.back for colour in row]


def test_add_by_topic_rename_duplicate_move_and_remove(machine: RVizMachine) -> None:
    async def walk() -> None:
        from sensor_msgs.msg import LaserScan

        machine.node.create_publisher(LaserScan, "/scan", 10)
        async with walking(machine) as at:
            rviz = machine.rviz
            await at.press("a")
            await at.type("scan")
            assert "by topic" in at.line("▸ /scan")
            await at.press("enter")
            await at.settle()
            assert [(each.type, each.name) for each in rviz.displays] == [("Grid", "Grid"), ("LaserScan", "LaserScan")]
            assert rviz.displays[1].topic.value == "/scan"
            await at.press("ctrl+r", "ctrl+u")
            await at.type("lidar")
            await at.press("enter")
            assert rviz.displays[1].name == "lidar" and "[x] lidar" in at.screen()
            await at.press("ctrl+d")
            assert [each.name for each in rviz.displays] == ["Grid", "lidar", "lidar"]
            assert rviz.displays[2].topic.value == "/scan"
            await at.press("shift+up")
            assert [each.name for each in rviz.displays] == ["lidar", "Grid", "lidar"]
            await at.press("ctrl+x")
            assert [each.name for each in rviz.displays] == ["Grid", "lidar"]
            at.pane.choose(rviz.displays[0])
            await at.press("space")
            assert not rviz.displays[0].enabled and "[ ] Grid" in at.screen()
            assert not rviz.scene.lines

    run(walk())


def test_a_wrong_value_is_explained_and_the_old_one_stays(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            at.pane.choose(machine.rviz.displays[0].child("Cell Size"))
            await at.press("enter", "ctrl+u")
            await at.type("wide")
            await at.press("enter")
            assert "enter a number" in at.screen()
            await at.press("ctrl+u", "2", "enter")
            assert machine.rviz.displays[0].child("Cell Size").value == 2.0

    run(walk())


def test_keys_of_the_view(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            rviz = machine.rviz
            assert "RViz is ready." in at.screen()
            before = at.screen()
            await at.press("tab", "left")
            assert "Left-Click: Rotate." in at.screen() and at.screen() != before
            yaw = rviz.view.child("Yaw").value
            assert yaw > 0.785398
            await at.press("plus")
            assert rviz.view.child("Distance").value == pytest.approx(8.8)
            await at.press("shift+right")
            assert rviz.view.child("Focal Point").value != (0, 0, 0)
            await at.press("4")
            assert rviz.view.child("Yaw").value == pytest.approx(0.785398)
            await at.press("z")
            assert rviz.view.child("Distance").value == 10.0
            for name in ("XYOrbit", "TopDownOrtho", "FPS", "ThirdPersonFollower", "Orbit"):
                await at.press("v")
                assert rviz.view.type == name
                # The longest name has no room beside what the mouse does.
                assert f" {name} " in at.screen() or name == "ThirdPersonFollower"
            await at.press("l")
            assert rviz.quality.value == "Medium" and "Medium" in at.screen()

    run(walk())


@pytest.mark.parametrize(
    ("button", "shift", "ctrl", "changed"),
    [
        (1, False, False, "Yaw"),
        (1, True, False, "Focal Point"),
        (1, False, True, "Focal Point"),
        (2, False, False, "Focal Point"),
    ],
)
def test_drags_of_themouse(machine: RVizMachine, button: int, shift: bool, ctrl: bool, changed: str) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            rviz = machine.rviz
            start = {name: rviz.view.child(name).value for name in ("Yaw", "Focal Point", "Distance")}
            for kind, x in ((events.MouseDown, 80), (events.MouseMove, 88), (events.MouseUp, 88)):
                at.pane.post_message(mouse(at.pane, kind, x, 15, button, shift, ctrl))
                await at.pilot.pause()
            now = {name: rviz.view.child(name).value for name in start}
            assert [name for name in start if start[name] != now[name]] == [changed]

    run(walk())


def test_the_wheel_zooms_over_the_view_and_scrolls_over_the_panel(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            at.pane.post_message(mouse(at.pane, events.MouseScrollUp, 80, 10, 0, False, False))
            await at.pilot.pause()
            assert machine.rviz.view.child("Distance").value == pytest.approx(8.8)
            at.pane.post_message(mouse(at.pane, events.MouseScrollUp, 5, 10, 0, False, False))
            await at.pilot.pause()
            assert machine.rviz.view.child("Distance").value == pytest.approx(8.8)

    run(walk())


def test_a_click_opens_branches_and_sets_boxes(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            row = at.pane.panel.properties.node_of(machine.rviz.displays[0]).line
            await at.pilot.click(at.pane, offset=(1, row + 1 + at.pane.top))
            await at.settle()
            assert "Cell Size" in at.screen()
            await at.pilot.click(at.pane, offset=(4, row + 1 + at.pane.top))
            await at.settle()
            assert not machine.rviz.displays[0].enabled

    run(walk())


def test_saving_loading_and_pictures(machine: RVizMachine, tmp_path: Path) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            rviz = machine.rviz
            rviz.path = lambda name: tmp_path / name
            at.pane.set(rviz.fixed, "odom")
            await at.settle()
            await at.press("w", "ctrl+u")
            await at.type("mine")
            await at.press("enter")
            assert "Fixed Frame: odom" in (tmp_path / "mine.rviz").read_text() and not rviz.modified
            at.pane.set(rviz.fixed, "other")
            await at.settle()
            await at.press("ctrl+s")
            assert "Fixed Frame: other" in (tmp_path / "mine.rviz").read_text()
            at.pane.set(rviz.fixed, "third")
            await at.settle()
            await at.press("ctrl+o", "ctrl+u")
            await at.type("no.rviz")
            await at.press("enter")
            assert "no.rviz could not be loaded" in at.screen()
            await at.press("ctrl+u")
            await at.type("mine.rviz")
            await at.press("enter")
            await at.settle()
            assert rviz.fixed_frame == "other"
            for name, start in (("a.png", b"\x89PNG"), ("a.svg", b"<svg")):
                await at.press("e", "ctrl+u")
                await at.type(name)
                await at.press("enter")
                assert (tmp_path / name).read_bytes().startswith(start)

    run(walk())


def test_long_statuses_are_told_in_full_below(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            at.pane.choose(machine.rviz.statuses.children[0])
            at.pane.status_bar.hurry()
            await at.settle()
            assert "No tf data.  Actual error: Frame [map] does not exist" in at.screen()

    run(walk())


def test_chinese_and_ascii(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, 80, 24, glyphs="ascii") as at:
            await at.press("tab")
            assert is_drawn_in_ascii(at.screen())
            assert "a grid of 10x10 cells of 1 m" in at.screen()

    run(walk())


def test_a_still_robot_costs_no_picture(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await at.settle()
            painted = at.pane.view._painted_at
            spans, due = at.pane.view.pull(painted + 100.0)
            machine.advance(5.0)
            spans, due = at.pane.view.pull(painted + 200.0)
            assert spans == [] and not due

    run(walk())


def test_every_status_line_has_its_word_and_colour(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.add("RobotModel")
            await at.settle()
            (robot,) = [display for display in machine.rviz.displays if display.type == "RobotModel"]
            assert lines(robot)["Topic"][0] == "Error"
            at.pane.choose(robot.statuses.children[0])
            await at.settle()
            assert "Status: Error" in at.screen() and "▲ Topic" in at.screen()
            assert "▲ Global Status: Warn" in at.screen()

    run(walk())


def test_f1_on_a_status_explains_it_and_elsewhere_is_the_manual(machine: RVizMachine) -> None:
    from day6_tui.overlays.card import CardModal
    from day6_tui.overlays.manual import Manual

    async def walk() -> None:
        async with walking(machine) as at:
            tree = at.pane.panel.properties
            await at.until(lambda: "No tf data." in at.screen())
            await at.press("f1")
            assert isinstance(at.app.desktop.overlay, Manual)
            await at.press("f1")
            tree.choose(machine.rviz.statuses)
            await at.press("f1")
            overlay = at.app.desktop.overlay
            assert isinstance(overlay, CardModal) and overlay._shown.line.startswith(
                "No tf data.  Actual error: Frame [map]"
            )
            assert "Nobody publishes /tf or /tf_static" in overlay._shown.here  # of the terminal's own graph
            await at.press("f1")
            assert isinstance(at.app.desktop.overlay, Manual)

    run(walk())
