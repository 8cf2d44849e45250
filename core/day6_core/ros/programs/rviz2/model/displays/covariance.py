"""How sure a pose is (rviz_rendering/objects/covariance_visual.cpp): a ball for the place, a disc on every axis for the turn.

All show one standard deviation. A pose on the ground (no variance of z, roll and pitch) has a disc for the place and, from its
middle, a slice for the heading.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import BOOL, COLOUR, ENUM, Property, floats
from day6_core.ros.programs.rviz2.model.scene import CONE, CYLINDER, SPHERE, Colour, Scene, Shape
from day6_core.ros.programs.rviz2.model.topics import all_finite
from day6_core.ros.programs.rviz2.model.turning import quaternion
from day6_urdf.kinematics import Transform, about, compose, multiply
from day6_urdf.model import Quaternion, Vector

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
RIGHT = math.pi / 2
WIDEST = math.radians(89)
THIN = 0.001
THINNEST = 1e-4

_UPRIGHT = about(X, -RIGHT)
"""The originals' cylinders and cones stand on y, ours on z."""

_AXES: tuple[tuple[Vector, Quaternion, tuple[int, int], Colour], ...] = (
    (X, multiply(about(X, RIGHT), about(Z, RIGHT)), (4, 5), (1.0, 0.0, 0.0, 1.0)),
    (Y, about(Y, RIGHT), (3, 5), (0.0, 1.0, 0.0, 1.0)),
    (Z, about(X, RIGHT), (3, 4), (0.0, 0.0, 1.0, 1.0)),
)
"""Roll, pitch, yaw: where the disc is, how it is turned, the variances that it shows, its colour in the style RGB."""


class _Disc(NamedTuple):
    """A disc on an axis: its place at a distance of 1, its turn, and twice the deviations along it, in radians."""

    place: Vector
    turn: Quaternion
    radians: tuple[float, float]
    colour: Colour


class Spread(NamedTuple):
    """A covariance taken apart: the ball's turn and size, and the discs; on the ground, the heading's radians instead."""

    turn: Quaternion
    size: Vector
    discs: tuple[_Disc, ...]
    heading: float | None


class Covariance:
    """The property `Covariance` with what is below it."""

    def __init__(self, add: Callable[[Property], Property], changed: Callable[[], object]) -> None:
        self.shown = add(Property("Covariance", BOOL, True, on_change=changed))
        self.place = place = self.shown.add(Property("Position", BOOL, True, on_change=changed))
        self.colour = place.add(Property("Color", COLOUR, (204, 51, 204), on_change=changed))
        self.alpha = place.add(floats("Alpha", 0.3, 0, 1, on_change=changed))
        self.scale = place.add(floats("Scale", 1, 0, on_change=changed))
        self.turn = turn = self.shown.add(Property("Orientation", BOOL, True, on_change=changed))
        self.frame = turn.add(Property("Frame", ENUM, "Local", options=("Local", "Fixed"), on_change=changed))
        self.style = turn.add(
            Property("Color Style", ENUM, "Unique", options=("Unique", "RGB"), on_change=self._style_changed)
        )
        self.turn_colour = turn.add(Property("Color", COLOUR, (255, 255, 127), on_change=changed))
        self.turn_alpha = turn.add(floats("Alpha", 0.5, 0, 1, on_change=changed))
        self.offset = turn.add(floats("Offset", 1, 0, on_change=changed))
        self.turn_scale = turn.add(floats("Scale", 1, 0, on_change=changed))
        self._changed = changed

    def _style_changed(self) -> None:
        self.turn_colour.hidden = self.style.value == "RGB"
        self._changed()

    def draw(self, scene: Scene, spread: Spread | None, pose: Transform, frame: Quaternion) -> None:
        """Around a pose in the Fixed Frame, whose message was given in a frame turned by `frame`."""
        if spread is None or not self.shown.value:
            return
        if self.place.value and any(spread.size):
            x, y, z = (max(THINNEST, self.scale.value * part) for part in spread.size)
            if spread.heading is not None:
                z = THIN
            at = Transform(pose.xyz, multiply(frame, spread.turn))
            scene.shapes.append(Shape(SPHERE, at, (x, y, z), rgba(self.colour, self.alpha.value)))
        if self.turn.value:
            own = self.frame.value == "Local"
            self._draw_turn(scene, spread, Transform(pose.xyz, pose.rotation if own else frame))

    def _draw_turn(self, scene: Scene, spread: Spread, pose: Transform) -> None:
        offset, factor = self.offset.value, self.turn_scale.value
        if spread.heading:
            wide = offset * _metres(spread.heading * factor)
            at = Transform((offset / 2, 0.0, 0.0), multiply(about(Z, RIGHT), _UPRIGHT))
            scene.shapes.append(Shape(CONE, compose(pose, at), (wide, THIN, offset), self._tint(_AXES[2][3])))
        for disc in spread.discs:
            if not any(disc.radians):
                continue
            x, y = (max(THINNEST, offset * _metres(part * factor)) for part in disc.radians)
            place = disc.place[0] * offset, disc.place[1] * offset, disc.place[2] * offset
            at = compose(pose, Transform(place, disc.turn))
            scene.shapes.append(Shape(CYLINDER, at, (x, y, THIN), self._tint(disc.colour)))

    def _tint(self, own: Colour) -> Colour:
        alpha = self.turn_alpha.value
        return (*own[:3], alpha) if self.style.value == "RGB" else rgba(self.turn_colour, alpha)


def spread_of(covariance: Sequence[float]) -> Spread | None:
    """Take the 36 numbers of a message apart; None if they are no covariance."""
    import numpy as np

    if not all_finite(covariance):
        return None
    rows = np.array(covariance, float).reshape(6, 6)
    flat = rows[2, 2] <= 0 and rows[3, 3] <= 0 and rows[4, 4] <= 0
    found = _principal(rows[:2, :2] if flat else rows[:3, :3])
    if found is None:
        return None
    deviations, axes = found
    turn = np.eye(3)
    turn[: len(axes), : len(axes)] = axes
    x, y, *z = (2 * float(part) for part in deviations)
    size = (x, y, z[0] if z else 0.0)
    if flat:
        heading = 2 * math.sqrt(rows[5, 5]) if rows[5, 5] > 0 else 0.0
        return Spread(quaternion(turn.tolist()), size, (), heading)
    discs = []
    for place, node, pair, colour in _AXES:
        about_it = _principal(rows[np.ix_(pair, pair)])
        if about_it is not None:
            (first, second), ((a, b), (c, d)) = about_it
            # In the originals' plane x-z.
            own = quaternion([[a, 0.0, b], [0.0, 1.0, 0.0], [c, 0.0, d]])
            turned = multiply(multiply(node, own), _UPRIGHT)
            discs.append(_Disc(place, turned, (2 * float(first), 2 * float(second)), colour))
    return Spread(quaternion(turn.tolist()), size, tuple(discs), None)


def _principal(rows: Any) -> tuple[Any, Any] | None:
    """Standard deviations along the principal axes, and these as the columns of a right-handed matrix; None of no covariance."""
    import numpy as np

    variances, axes = np.linalg.eigh(rows)
    if variances.min() < -1e-12:
        return None
    if np.linalg.det(axes) < 0:
        variances[[0, 1]], axes[:, [0, 1]] = variances[[1, 0]], axes[:, [1, 0]]
    return np.sqrt(np.maximum(variances, 0.0)), axes


def _metres(radians: float) -> float:
    """The width, at a distance of 1, of an angle."""
    return 2 * math.tan(min(radians / 2, WIDEST))
