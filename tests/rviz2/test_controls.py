"""Controls of interactive markers by mouse and by keys alone, with a server written as in its tutorials."""

from __future__ import annotations

import math
from typing import Any

import pytest
from visualization_msgs.msg import InteractiveMarkerControl as Modes

from day6_core.ros.programs.rviz2.model.tools.tool import Hit, Pointer
from day6_urdf.kinematics import rotate
from tests.rviz2.marker_server import Controls, control, upright
from tests.rviz2.rviz_machine import RVizMachine
from tests.rviz2.rviz_walk import Walk, drag, hover, run, walking

PIXEL = 2 * 3.14 / 300
"""Radians that a pixel of the mouse turns (interactive_marker_control.cpp)."""


class Table:
    """RViz with the display InteractiveMarkers on the server `controls`, seen from above."""

    def __init__(self, machine: RVizMachine) -> None:
        self.machine = machine
        machine.fix("stand")
        machine.transform("stand", "other")
        self.controls = Controls(machine.node)
        machine.do(lambda: machine.rviz.set_view("TopDownOrtho"))

    def show(self) -> Any:
        self.display = self.machine.add("InteractiveMarkers", "/controls/update")
        self.machine.settle(3.0)
        return self.display

    def pose(self, name: str) -> Any:
        return self.display.markers[name].pose

    def facing(self, name: str, axis: tuple[float, float, float] = (1.0, 0.0, 0.0)) -> Any:
        return pytest.approx(tuple(rotate(self.pose(name).rotation, axis)), abs=1e-6)

    def act(self, act: str, pointer: Pointer) -> None:
        """Press, drag or release with the tool Interact, as the window tells it."""
        tools = self.machine.rviz.tools
        self.machine.do(lambda: tools.use(tools.current, lambda tool: getattr(tool, act)(pointer)))

    def mouse(self, x: float, y: float, *pixel: float, name: str = "", **keys: bool) -> Pointer:
        """A look straight down at a place; on the control `name` of the marker `thing`."""
        hit = Hit((x, y, 0.0), self.display, ("thing", name)) if name else None
        return Pointer((x, y, 5.0), (0.0, 0.0, -1.0), hit, pixel or (0.0, 0.0), **keys)  # type: ignore[arg-type]


@pytest.fixture
def table(machine: RVizMachine) -> Table:
    machine.open()
    return Table(machine)


# -- the mouse ----------------------------------------------------------------------------------------------------------


def test_rotate_3d_turns_with_the_mouse_about_the_axes_of_the_picture(table: Table) -> None:
    table.controls.add("thing", control("ball", Modes.ROTATE_3D, cube=1.0))
    table.show()
    table.act("press", table.mouse(0, 0, 100, 100, name="ball"))
    table.controls.taken()
    quarter = math.pi / 2 / PIXEL
    # To the right: about the picture's up, which is y here, so that x looks away from the viewer.
    table.act("drag", table.mouse(0, 0, 100 + quarter, 100))
    assert table.facing("thing") == (0.0, 0.0, -1.0)
    assert table.controls.taken() == ["POSE_UPDATE"]
    assert table.controls.last.pose.orientation.y == pytest.approx(math.sqrt(0.5))
    # Down: about the picture's right; z, which looked to the right, stays.
    table.act("drag", table.mouse(0, 0, 100 + quarter, 100 + quarter))
    assert table.facing("thing") == (0.0, 1.0, 0.0)
    # Shift: about the direction of the look, which is downwards, clockwise.
    table.act("drag", table.mouse(0, 0, 100 + quarter, 100 + quarter, shift=True))
    table.act("drag", table.mouse(0, 0, 100 + 2 * quarter, 100 + quarter, shift=True))
    assert table.facing("thing") == (1.0, 0.0, 0.0)
    table.act("release", table.mouse(0, 0, 0, 0, shift=True))
    assert table.controls.taken()[-2:] == ["POSE_UPDATE", "MOUSE_UP"]
    assert table.pose("thing").xyz == (0.0, 0.0, 0.0)


def test_move_rotate_3d_moves_and_with_ctrl_turns(table: Table) -> None:
    table.controls.add("thing", control("ball", Modes.MOVE_ROTATE_3D, cube=1.0))
    table.show()
    table.act("press", table.mouse(0, 0, 100, 100, name="ball"))
    words = "Left-Click: Move X/Y. Shift + Left-Click / Left-Click + Wheel: Move Z. "
    words += "Ctrl + Left-Click: Rotate around X/Y. Ctrl + Shift + Left-Click: Rotate around Z."
    assert table.machine.rviz.tools.current.status == words
    table.act("drag", table.mouse(2, 1, 120, 90))
    assert table.pose("thing").xyz == pytest.approx((2.0, 1.0, 0.0))
    # Ctrl goes down where the mouse is: nothing jumps, and from here it turns.
    table.act("drag", table.mouse(2, 1, 120, 90, control=True))
    table.act("drag", table.mouse(3, 1, 120 + math.pi / PIXEL, 90, control=True))
    assert table.pose("thing").xyz == pytest.approx((2.0, 1.0, 0.0))
    assert table.facing("thing") == (-1.0, 0.0, 0.0)
    # Ctrl goes up: from here it moves again.
    table.act("drag", table.mouse(3, 1, 400, 90))
    table.act("drag", table.mouse(3, 2, 400, 80))
    assert table.pose("thing").xyz == pytest.approx((2.0, 2.0, 0.0))


def test_shift_and_the_wheel_move_away_and_nearer(table: Table) -> None:
    table.controls.add("thing", control("ball", Modes.MOVE_3D, upright(), cube=1.0))
    table.show()
    metres = 1 / table.machine.rviz.view.child("Scale").value  # of a pixel
    table.act("press", table.mouse(0, 0, 100, 100, name="ball", shift=True))
    table.act("drag", table.mouse(0, 0, 100, 90, shift=True))
    assert table.pose("thing").xyz == pytest.approx((0.0, 0.0, -10 * metres))
    tools = table.machine.rviz.tools
    table.machine.do(lambda: tools.use(tools.current, lambda tool: tool.wheel(-10)))
    assert table.pose("thing").xyz == pytest.approx((0.0, 0.0, 10 * metres))
    assert table.controls.taken() == ["POSE_UPDATE", "MOUSE_DOWN", "POSE_UPDATE", "POSE_UPDATE"]


def test_while_a_control_is_held_the_others_are_hidden_and_its_axis_can_be_shown(table: Table) -> None:
    table.controls.add("thing", control("along", Modes.MOVE_AXIS), control("ring", Modes.ROTATE_AXIS))
    display = table.show()
    scene = lambda: table.machine.rviz.scene  # noqa: E731
    assert scene().triangles and len(scene().lines) == 1  # the grid
    table.machine.rviz.edit(display.aids, True)
    table.act("press", table.mouse(0.7, 0, 0, 0, name="along"))
    assert scene().shapes and not scene().triangles
    aid = scene().lines[-1]
    assert aid.vertices[0][0] > 1000 and aid.vertices[0][1:] == pytest.approx((0.0, 0.0))
    assert scene().shapes[0].colour == (1.0, 0.5, 0.5, 1.0)  # as bright as what is in use
    table.act("release", table.mouse(0.7, 0, 0, 0))
    assert scene().triangles and len(scene().lines) == 1
    assert scene().shapes[0].colour == (1.0, 0.0, 0.0, 0.5)


def test_the_mouse_turns_a_ball_in_the_window(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            table = await shown(at, control("ball", Modes.MOVE_ROTATE_3D, cube=4.0))
            middle = at.pane.view.columns // 2, at.pane.view.rows // 2
            await drag(at, middle, (middle[0] + 6, middle[1]), (middle[0] + 12, middle[1]), ctrl=True)
            pixels = 12 * 600 / at.pane.view.rows / 2
            cosine, sine = math.cos(pixels * PIXEL), math.sin(pixels * PIXEL)
            assert table.facing("thing") == (cosine, 0.0, -sine)
            assert table.pose("thing").xyz == (0.0, 0.0, 0.0)

    run(walk())


def test_a_control_under_the_mouse_is_lit_and_says_what_it_does(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await shown(at, control("ball", Modes.ROTATE_3D, cube=4.0))
            middle = at.pane.view.columns // 2, at.pane.view.rows // 2
            await hover(at, middle)
            (cube,) = machine.rviz.scene.shapes
            assert cube.colour == pytest.approx((0.8, 0.8, 0.8, 1.0))
            assert "Left-Click: Rotate around X/Y. Shift-Left-Click: Rotate around Z." in at.screen()
            await hover(at, (1, 1))
            assert machine.rviz.scene.shapes[0].colour == (0.5, 0.5, 0.5, 1.0)
            assert "Left-Click: Rotate around X/Y." not in at.screen()

    run(walk())


# -- keys alone ---------------------------------------------------------------------------------------------------------


async def shown(at: Walk, *controls: Any) -> Table:
    """The window on a server with the marker `thing`; the view has the keys."""
    table = Table(at.machine)
    table.controls.add("thing", *controls)
    table.show()
    await at.until(lambda: at.machine.rviz.scene.shapes or at.machine.rviz.scene.triangles)
    if at.pane.on_panel:
        await at.press("tab")
    table.controls.taken()
    return table


def test_a_control_is_chosen_held_moved_and_let_go_by_keys(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            table = await shown(at, control("along", Modes.MOVE_AXIS), control("ring", Modes.ROTATE_AXIS, upright()))
            assert ("x", "grasp a control") in at.pane.key_hints()
            await at.press("x")
            assert machine.rviz.scene.shapes[0].colour == pytest.approx((1.0, 0.3, 0.3, 1.0))
            assert ("Enter", "hold it") in at.pane.key_hints()
            assert "Left-Click: Move." in at.screen()
            angle = machine.rviz.view.child("Angle").value
            await at.press("right")  # the view's, until the control is held
            assert machine.rviz.view.child("Angle").value != angle and not table.controls.events
            await at.press("z", "enter")
            assert table.controls.taken() == ["POSE_UPDATE", "MOUSE_DOWN"]
            last = table.controls.last
            assert (last.marker_name, last.control_name, last.client_id) == ("thing", "along", "/rviz")
            assert last.mouse_point_valid and abs(last.mouse_point.x) > 0.5
            await at.press("right", "right", "left", "shift+right")
            assert table.controls.taken() == ["POSE_UPDATE"] * 4
            step = 5.0 if machine.rviz.view.camera().metres > 70 else 2.0
            assert table.pose("thing").xyz == (pytest.approx(1.1 * step), 0.0, 0.0)
            await at.press("enter")
            assert table.controls.taken() == ["POSE_UPDATE", "MOUSE_UP"]
            # The next one turns: to the right is clockwise as it is seen.
            await at.press("x", "enter")
            assert table.controls.last.control_name == "ring"
            await at.press("right")
            assert table.facing("thing") == (math.cos(math.radians(15)), -math.sin(math.radians(15)), 0.0)
            await at.press("escape")
            assert table.controls.taken()[-1] == "MOUSE_UP"
            await at.press("escape")
            assert ("x", "grasp a control") in at.pane.key_hints() and not at.pane.on_panel

    run(walk())


def test_keys_move_in_a_plane_and_in_space_along_round_numbers(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            plane = control("plane", Modes.MOVE_PLANE, upright(), cube=1.0)
            table = await shown(at, plane, control("space", Modes.MOVE_3D, cube=0.5))
            machine.do(lambda: machine.rviz.set_view("Orbit"))
            machine.rviz.view.look_at((0.0, 0.0, 0.0), 4.0)
            await at.press("x", "enter", "right", "up", "up", "enter")
            # From over the corner x, y: what is right of the picture is nearest to y there, up is away: -x.
            assert table.pose("thing").xyz == (-1.0, 0.5, 0.0)
            await at.press("x", "enter", "right", "up", "pageup", "pagedown", "pagedown", "enter")
            assert table.pose("thing").xyz == (-0.5, 1.0, 0.5)
            assert table.controls.taken().count("MOUSE_UP") == 2

    run(walk())


def test_keys_turn_in_space(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            table = await shown(at, control("ball", Modes.MOVE_ROTATE_3D, cube=1.0))
            await at.press("x", "enter")
            assert ("Space", "turn") in at.pane.key_hints()
            await at.press("right", "space")
            moved = table.pose("thing").xyz
            assert moved[0] > 0 and moved[1:] == (0.0, 0.0)
            await at.press(*["right"] * 6)
            assert table.pose("thing").xyz == moved and table.facing("thing") == (0.0, 0.0, -1.0)
            await at.press(*["up"] * 6)
            assert table.facing("thing") == (0.0, -1.0, 0.0)
            await at.press(*["pageup"] * 6, "enter")
            assert table.facing("thing") == (-1.0, 0.0, 0.0)

    run(walk())


def test_a_button_is_clicked_and_a_menu_chosen_by_keys(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            knob, list_ = control("knob", Modes.BUTTON, cube=1.0), control("list", Modes.MENU, cube=0.5)
            table = await shown(at, knob, list_)
            table.controls.give_menu("thing")
            await at.settle()
            await at.press("x", "enter")
            kinds = ["POSE_UPDATE", "MOUSE_DOWN", "BUTTON_CLICK", "POSE_UPDATE", "MOUSE_UP"]
            assert table.controls.taken() == kinds
            # Any control of a marker with a menu has it, as by the right button …
            await at.press("space")
            await at.until(lambda: "☐ lamp" in at.screen())
            await at.press("enter")
            assert table.controls.chosen == ["lamp on"]
            # … and one that is a menu opens it, as by the left.
            await at.press("x", "enter")
            await at.until(lambda: "☑ lamp" in at.screen())
            await at.press("down", "enter")
            assert table.controls.chosen == ["lamp on", "home"]

    run(walk())


def test_what_goes_while_it_is_held_is_let_go(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            table = await shown(at, control("along", Modes.MOVE_AXIS))
            await at.press("x", "enter")
            table.controls.server.erase("thing")
            table.controls.server.applyChanges()
            await at.settle()
            await at.press("right", "space", "enter", "enter", "x")
            await at.until(lambda: "There are no interactive markers" in at.screen())

    run(walk())


def test_another_tool_lets_go(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            table = await shown(at, control("along", Modes.MOVE_AXIS))
            await at.press("x", "enter", "m")
            assert table.controls.taken()[-1] == "MOUSE_UP"
            await at.press("x")  # and this one brings Interact back
            assert machine.rviz.tools.current.type == "Interact"
            await at.press("m")
            await at.press("x", "enter")
            assert table.controls.taken()[-2:] == ["POSE_UPDATE", "MOUSE_DOWN"]

    run(walk())
