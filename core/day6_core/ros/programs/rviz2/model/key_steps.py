"""How far one press of an arrow key goes, where keys move things in the view: round numbers that fit the distance."""

from __future__ import annotations

import math

from day6_core.ros.programs.rviz2.model.views import Camera
from day6_urdf.model import Vector

TURN, FINE_TURN = math.radians(15), math.radians(1)
"""What an arrow key turns a direction, without and with Shift."""

STEPS = 20
"""How many steps of an arrow key the view is far away, about."""

FINE = 0.1
"""The part of a step that Shift makes of it."""


def step_at(camera: Camera, point: Vector) -> float:
    """Metres that an arrow key moves what is at a point."""
    return round_step((camera.metres or math.dist(camera.position, point)) / STEPS)


def round_step(metres: float) -> float:
    """The nearest of …, 0.1, 0.2, 0.5, 1, 2, 5, …"""
    power = 10.0 ** math.floor(math.log10(max(metres, 1e-6)))
    return min((power * factor for factor in (1, 2, 5, 10)), key=lambda step: abs(step - metres))
