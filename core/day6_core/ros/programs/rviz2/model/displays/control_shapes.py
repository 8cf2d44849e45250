"""What the controls of interactive markers look like that say nothing of it: arrows, rings and titles.

The sizes are those of the package interactive_markers (tools.cpp).
"""

from __future__ import annotations

import copy
import math
from typing import Any

from day6_core.ros.programs.rviz2.model.displays.marker_shapes import ARROW, TEXT, TRIANGLES
from day6_urdf.kinematics import rotate
from day6_urdf.model import Vector

NONE, MENU, BUTTON, MOVE_AXIS, MOVE_PLANE, ROTATE_AXIS, MOVE_ROTATE, MOVE_3D, ROTATE_3D, MOVE_ROTATE_3D = range(10)
INHERIT, FIXED, VIEW_FACING = range(3)

STEPS = 36
"""Corners of a ring."""
DARK = 0.6


def completed(message: Any, transparent: bool) -> Any:
    """A copy of an InteractiveMarker in which every control has a name of its own, an orientation and markers."""
    message = copy.deepcopy(message)
    message.scale = message.scale or 1.0
    names: set[str] = set()
    number = 0
    for control in message.controls:
        name = control.name
        while name in names:
            name, number = f"{name}_u{number}", number + 1
        names.add(name)
        control.name = name
        _complete(message, control, transparent)
    return message


def title_of(message: Any) -> Any:
    """The Marker with the description, above an InteractiveMarker."""
    title = _marker(TEXT, (message.scale * 0.15,) * 3, (1.0, 1.0, 1.0, 1.0))
    title.pose.position.z = message.scale * 1.4
    title.text = message.description
    return title


def _complete(message: Any, control: Any, transparent: bool) -> None:
    turn = control.orientation
    if not (turn.x or turn.y or turn.z or turn.w):
        turn.w = 1.0
    if not control.markers:
        mode = control.interaction_mode
        if mode == MOVE_AXIS:
            control.markers = [_arrow(message.scale, control, way) for way in (1, -1)]
        elif mode in (MOVE_PLANE, ROTATE_AXIS, MOVE_ROTATE):
            control.markers = [_ring(message.scale, control)]
        elif mode == MENU:
            control.orientation_mode, control.independent_marker_orientation = VIEW_FACING, False
            size = 0.25 * message.scale
            text = _marker(TEXT, (size, size, size), (1.0, 1.0, 1.0, 1.0))
            text.pose.position.x, text.pose.position.z = -0.1 * size, 1.2 * message.scale - 0.1 * size
            text.text = control.description
            control.markers = [text]
    for marker in control.markers:
        for axis in "xyz":
            setattr(marker.scale, axis, getattr(marker.scale, axis) or 1.0)
        if not transparent and marker.color.a > 0:
            marker.color.a = 1.0


def _marker(kind: int, size: Vector, colour: tuple[float, float, float, float]) -> Any:
    from visualization_msgs.msg import Marker

    marker = Marker(type=kind)
    marker.scale.x, marker.scale.y, marker.scale.z = size
    marker.color.r, marker.color.g, marker.color.b, marker.color.a = colour
    return marker


def _handle(kind: int, size: Vector, control: Any) -> Any:
    """A Marker along the control's x axis, in the colour of the axis of the marker nearest to it."""
    turn = control.orientation
    norm = math.sqrt(turn.x**2 + turn.y**2 + turn.z**2 + turn.w**2)
    parts = [
        abs(part) for part in rotate((turn.x / norm, turn.y / norm, turn.z / norm, turn.w / norm), (1.0, 0.0, 0.0))
    ]
    red, green, blue = (part / max(parts) for part in parts)
    marker = _marker(kind, size, (red, green, blue, 0.5))
    marker.pose.orientation = copy.deepcopy(turn)
    return marker


def _arrow(scale: float, control: Any, way: int) -> Any:
    from geometry_msgs.msg import Point

    arrow = _handle(ARROW, (scale * 0.15, scale * 0.25, scale * 0.2), control)
    arrow.points = [Point(x=way * scale * 0.5), Point(x=way * scale * 0.9)]
    return arrow


def _ring(scale: float, control: Any) -> Any:
    from geometry_msgs.msg import Point
    from std_msgs.msg import ColorRGBA

    ring = _handle(TRIANGLES, (scale, scale, scale), control)
    angles = [math.tau * step / STEPS for step in range(STEPS)]
    inner = [Point(y=0.5 * math.cos(angle), z=0.5 * math.sin(angle)) for angle in angles]
    outer = [Point(y=2 * point.y, z=2 * point.z) for point in inner]
    for step in range(STEPS):
        following = (step + 1) % STEPS
        ring.points += [inner[step], outer[step], inner[following]]
        ring.points += [outer[step], outer[following], inner[following]]
        if control.interaction_mode in (ROTATE_AXIS, MOVE_ROTATE):
            # Light and dark by turns, so that its turning is seen.
            light = DARK + (1 - DARK) * (step % 2)
            shade = ColorRGBA(r=ring.color.r * light, g=ring.color.g * light, b=ring.color.b * light, a=1.0)
            ring.colors += [shade, shade]
    return ring
