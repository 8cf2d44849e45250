"""The Views panel of the user guide: the follower, the focal point, views that are kept."""

from __future__ import annotations

import math
from typing import Any

import pytest
from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster

from day6_core.ros.programs.rviz2.model.scene import SPHERE
from day6_core.ros.programs.rviz2.model.views import ThirdPersonFollower
from tests.rviz2.rviz_machine import RVizMachine
from tests.rviz2.rviz_walk import drag, run, walking

FOCUS = (0.05, 0.05, 0.01)
"""The size of what marks the focal point."""


def turned(machine: RVizMachine, heading: float) -> None:
    """`base` stands at x = 3 and looks somewhere."""
    stamped = TransformStamped(child_frame_id="base")
    stamped.header.frame_id, stamped.header.stamp = "map", machine.stamp()
    stamped.transform.translation.x = 3.0
    stamped.transform.rotation.z, stamped.transform.rotation.w = math.sin(heading / 2), math.cos(heading / 2)
    TransformBroadcaster(machine.node).sendTransform(stamped)
    machine.settle()


def behind(machine: RVizMachine) -> Any:
    """The view ThirdPersonFollower, five metres behind `base`."""
    machine.do(lambda: machine.rviz.set_view("ThirdPersonFollower"))
    view = machine.rviz.view
    machine.rviz.edit(view.target, "base")
    view.child("Yaw").set(math.pi)
    view.child("Pitch").set(0.0)
    view.child("Distance").set(5.0)
    machine.settle()
    return view


def test_the_follower_stays_behind_a_frame_that_turns(machine: RVizMachine) -> None:
    machine.open()
    machine.fix("map")
    turned(machine, 0.0)
    view = behind(machine)
    assert view.camera().position == pytest.approx((-2.0, 0.0, 1.0))  # lifted by a fifth of the distance
    assert view.camera().forward == pytest.approx((1.0, 0.0, 0.0))
    turned(machine, math.pi / 2)
    assert view.camera().position == pytest.approx((3.0, -5.0, 1.0))
    assert view.camera().forward == pytest.approx((0.0, 1.0, 0.0), abs=1e-9)
    assert view.camera().right == pytest.approx((1.0, 0.0, 0.0), abs=1e-9)
    # XYOrbit keeps its direction.
    machine.do(lambda: machine.rviz.set_view("XYOrbit"))
    assert machine.rviz.view.camera().forward == pytest.approx((1.0, 0.0, 0.0))


def test_the_follower_pans_and_looks_at_things_in_its_turned_frame(machine: RVizMachine) -> None:
    machine.open()
    machine.fix("map")
    turned(machine, math.pi / 2)
    view = behind(machine)
    view.child("Pitch").set(math.pi / 4)
    before = view.camera().position
    view.pan(0.1, 0.0)
    moved = [b - a for a, b in zip(before, view.camera().position, strict=True)]
    assert moved[0] < -0.1 and moved[1:] == pytest.approx([0.0, 0.0], abs=1e-9)
    view.look_at((3.0, 4.0, 0.0), 1.0)
    assert view.child("Focal Point").value == pytest.approx((4.0, 0.0, 0.0))
    assert view.focal_shape.pose.xyz == pytest.approx((3.0, 4.0, 0.0))
    view.turn_to((3.0, 6.0, 0.0))
    assert view.focal_shape.pose.xyz == pytest.approx((3.0, 6.0, 0.0))


def test_a_file_with_the_follower_is_loaded(machine: RVizMachine) -> None:
    machine.open()
    machine.do(
        lambda: machine.rviz.load_text(
            "Visualization Manager:\n  Views:\n    Current:\n      Class: rviz_default_plugins/ThirdPersonFollower\n"
            "      Distance: 7\n"
        )
    )
    assert isinstance(machine.rviz.view, ThirdPersonFollower) and machine.rviz.view.child("Distance").value == 7.0


def test_the_focal_point_is_marked_while_the_camera_is_moved(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:

            def marked() -> bool:
                shape = at.pane.view.focus
                return shape is not None and (shape.kind, shape.size) == (SPHERE, FOCUS)

            assert not marked()
            await at.press("tab", "left")
            assert marked()
            await at.until(lambda: not marked())
            seen: list[bool] = []
            move = at.pane._mouse.dragging.move
            at.pane._mouse.dragging.move = lambda *args: (move(*args), seen.append(at.pane.view.dragging))
            await drag(at, (10, 10), (12, 10))
            assert seen == [True]
            machine.rviz.view.child("Focal Shape Fixed Size").set(False)
            assert machine.rviz.view.focal_shape.size[0] == pytest.approx(0.5)

    run(walk())


def test_a_view_is_kept_left_and_found_again(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            rviz = machine.rviz
            await at.press("tab", "left", "plus", "k")
            await at.until(lambda: "view saved as Orbit" in at.screen())
            kept = rviz.view.camera()
            (saved,) = rviz.saved_views
            await at.press("v", "v")
            assert rviz.view.type == "TopDownOrtho"
            at.pane.to_panel()
            at.pane.choose(saved)
            await at.press("ctrl+r", "ctrl+u")
            await at.type("front")
            await at.press("enter")
            assert saved.name == "front"
            at.pane.choose(saved)
            await at.press("enter")
            assert rviz.view.type == "Orbit" and rviz.view.camera().position == pytest.approx(kept.position, abs=1e-4)
            # It is part of what a file holds, as the original writes it.
            config = rviz.save()["Visualization Manager"]["Views"]
            (entry,) = config["Saved"]
            assert (entry["Class"], entry["Name"]) == ("rviz_default_plugins/Orbit", "front")
            assert config["Current"]["Name"] == "Current View"
            at.pane.choose(saved)
            await at.press("ctrl+x")
            assert not rviz.saved_views and rviz.save()["Visualization Manager"]["Views"]["Saved"] is None

    run(walk())


def test_views_of_a_file_come_back_and_a_foreign_one_is_kept(machine: RVizMachine) -> None:
    machine.open()
    text = (
        "Visualization Manager:\n  Views:\n    Current:\n      Class: rviz_default_plugins/Orbit\n    Saved:\n"
        "      - Class: rviz_default_plugins/TopDownOrtho\n        Name: map\n        Scale: 20\n"
        "        Value: TopDownOrtho (rviz_default_plugins)\n      - Class: other/Strange\n        Name: odd\n"
    )
    machine.do(lambda: machine.rviz.load_text(text))
    first, odd = machine.rviz.saved_views
    machine.do(lambda: machine.rviz.use_view(first))
    assert machine.rviz.view.type == "TopDownOrtho" and machine.rviz.view.child("Scale").value == 20.0
    machine.do(lambda: machine.rviz.use_view(odd))
    assert machine.rviz.view.type == "TopDownOrtho"
    saved = machine.rviz.save()["Visualization Manager"]["Views"]["Saved"]
    assert [entry["Name"] for entry in saved] == ["map", "odd"] and saved[1]["Class"] == "other/Strange"
    machine.do(lambda: machine.rviz.load_text(text))
    assert len(machine.rviz.saved_views) == 2
