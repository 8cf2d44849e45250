"""The keys that the desktop's last line names while RViz has the keyboard: what they do to the tool or the view in use."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.displays.control_drag import FREE
from day6_core.ros.programs.rviz2.model.displays.control_keys import BOTH, turns
from day6_core.ros.programs.rviz2.model.displays.control_shapes import BUTTON, MENU
from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.tools.interact import Interact, Thing
from day6_core.ros.programs.rviz2.model.tools.pose import PoseTool
from day6_core.ros.programs.rviz2.model.tools.tool import CAMERA, GROUND, Tool
from day6_tui.windows.rviz.buttons import ADD
from day6_tui.windows.rviz.control_keys import ControlKeys

ARROWS = "arrows"
"""Stands for the arrow keys, whose signs not every terminal has."""

Hints = list[tuple[str, str]]
"""Keys, and what they do, as a key of the catalogue."""


def panel_hints() -> Hints:
    """While the panel has the keyboard."""
    return [
        ("Tab", "rviz.key.view"),
        ("Enter", "rviz.key.edit"),
        (ADD.shown, "rviz.key.add"),
        ("f", "rviz.key.focus"),
    ]


def view_hints(rviz: RViz, keys: ControlKeys) -> Hints:
    """While the view has the keyboard."""
    tool = rviz.tools.current
    if keys.at is not None:
        return _control_hints(keys, keys.at)
    if tool is None or tool.arrows == CAMERA:
        return _camera_hints(controls=isinstance(tool, Interact) and bool(tool.things))
    return _tool_hints(tool)


def _camera_hints(*, controls: bool) -> Hints:
    hints = [("Tab", "rviz.key.panel"), (ARROWS, "rviz.key.turn"), ("+ -", "rviz.key.zoom")]
    if controls:
        hints.append(("x", "rviz.key.control"))
    return [*hints, ("f", "rviz.key.focus"), ("4", "rviz.key.above")]


def _tool_hints(tool: Tool) -> Hints:
    turning = isinstance(tool, PoseTool) and tool.placed
    enter = "rviz.key.send" if turning else "rviz.key.place" if tool.arrows == GROUND else "rviz.key.click"
    return [
        (ARROWS, "rviz.key.direction" if turning else "rviz.key.cursor"),
        ("Shift", "rviz.key.fine"),
        ("Enter", enter),
        ("Esc", "rviz.key.leave_tool"),
    ]


def _control_hints(keys: ControlKeys, thing: Thing) -> Hints:
    """While the keys are at a control of an interactive marker."""
    mode = thing.mode
    if mode is None:
        return [("x", "rviz.key.next_control"), ("Esc", "question.back")]
    if not keys.holds:
        enter = {BUTTON: "rviz.key.click", MENU: "rviz.key.menu"}.get(mode, "rviz.key.grasp")
        hints = [("Enter", enter), ("x", "rviz.key.next_control")]
        if thing.has_menu and mode != MENU:
            hints.append(("Space", "rviz.key.menu"))
        return [*hints, ("Esc", "question.back")]
    turning = turns(mode, keys.turning)
    hints = [(ARROWS, "rviz.key.direction" if turning else "rviz.key.move"), ("Enter", "rviz.key.let_go")]
    if mode in FREE:
        hints.append(("PgUp PgDn", "rviz.key.roll" if turning else "rviz.key.away"))
    if mode in BOTH:
        hints.append(("Space", "rviz.key.move" if turning else "rviz.key.direction"))
    return [*hints, ("Shift", "rviz.key.fine")]
