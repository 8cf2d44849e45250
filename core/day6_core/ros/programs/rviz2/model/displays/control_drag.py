"""How a control of an interactive marker follows the mouse (interactive_marker_control.cpp), in the marker's reference frame."""

from __future__ import annotations

import math
from typing import NamedTuple

from day6_core.ros.programs.rviz2.model.displays.control_shapes import (
    MOVE_3D,
    MOVE_AXIS,
    MOVE_PLANE,
    MOVE_ROTATE,
    MOVE_ROTATE_3D,
    ROTATE_3D,
    ROTATE_AXIS,
)
from day6_urdf.kinematics import Transform, about, multiply, rotate
from day6_urdf.model import Quaternion, Vector

FREE = (MOVE_3D, ROTATE_3D, MOVE_ROTATE_3D)
"""Those that Shift and Ctrl make do something else."""
DRAGGABLE = (MOVE_AXIS, MOVE_PLANE, ROTATE_AXIS, MOVE_ROTATE, *FREE)
EPSILON = 1e-6

RADIANS = 2 * 3.14 / 300
"""What a pixel turns."""
METRES = 0.001
"""What a pixel moves away or nearer where the control says nothing else."""


class Ray(NamedTuple):
    """A start and a direction."""

    start: Vector
    along: Vector

    def beside(self, point: Vector) -> Vector:
        """Its point nearest to a point."""
        return plus(self.start, self.along, dot(minus(point, self.start), self.along) / dot(self.along, self.along))

    def on_plane(self, point: Vector, normal: Vector) -> Vector | None:
        """Where it meets a plane; None if it does not."""
        slope = dot(self.along, normal)
        if abs(slope) < EPSILON or (distance := dot(minus(point, self.start), normal) / slope) <= 0:
            return None
        return plus(self.start, self.along, distance)

    def nearest_on_line(self, point: Vector, axis: Vector) -> Vector | None:
        """The point of a line (`axis` is a unit vector) that lies nearest to the ray; None if they are parallel."""
        apart = minus(point, self.start)
        mixed, square = dot(axis, self.along), dot(self.along, self.along)
        bottom = square - mixed * mixed
        if bottom < EPSILON * square:
            return None
        return plus(point, axis, (mixed * dot(self.along, apart) - square * dot(axis, apart)) / bottom)


class Eye(NamedTuple):
    """The camera's axes."""

    right: Vector
    up: Vector
    forward: Vector


class Grab(NamedTuple):
    """A control that was taken: the mode, where, its axis, the camera and the marker's pose then."""

    mode: int
    point: Vector
    axis: Vector
    eye: Eye
    pose: Transform

    def again(self, ray: Ray, pose: Transform) -> Grab:
        """The control taken anew where the mouse is, as a key that changes the meaning of dragging went down or up."""
        point = ray.on_plane(plus(self.point, minus(pose.xyz, self.pose.xyz), 1.0), self.eye.forward)
        return self._replace(point=point or self.point, pose=pose)

    def metres(self, ray: Ray, lower: Ray, pixels: float) -> float:
        """What a pixel is in the control's plane, seen from a ray to one that is some pixels lower."""
        places = [each.on_plane(self.point, self.axis) for each in (ray, lower)]
        if places[0] is None or places[1] is None:
            return METRES
        apart = minus(places[0], places[1])
        return math.sqrt(dot(apart, apart)) / pixels or METRES

    def follow(self, ray: Ray) -> tuple[Transform, float] | None:
        """The marker's new pose and the radians turned about the axis; None where the mouse means nothing."""
        if self.mode == MOVE_AXIS:
            return self._moved(ray.nearest_on_line(self.point, self.axis))
        if self.mode == MOVE_PLANE:
            return self._moved(ray.on_plane(self.point, self.axis))
        if self.mode in (MOVE_3D, MOVE_ROTATE_3D):
            return self._moved(ray.on_plane(self.point, self.eye.forward))
        middle = plus(self.pose.xyz, self.axis, dot(minus(self.point, self.pose.xyz), self.axis))
        place = ray.on_plane(middle, self.axis)
        if place is None:
            return None
        before, now = minus(self.point, middle), minus(place, middle)
        angle = math.atan2(dot(cross(before, now), self.axis), dot(before, now))
        turn: Quaternion = about(self.axis, angle)
        xyz = self.pose.xyz
        if self.mode == MOVE_ROTATE:
            # The point that was taken stays under the mouse.
            length = math.sqrt(dot(now, now))
            if length > EPSILON:
                xyz = plus(xyz, now, 1 - math.sqrt(dot(before, before)) / length)
        return Transform(xyz, multiply(turn, self.pose.rotation)), angle

    def _moved(self, place: Vector | None) -> tuple[Transform, float] | None:
        if place is None:
            return None
        return Transform(plus(self.pose.xyz, minus(place, self.point), 1.0), self.pose.rotation), 0.0


def turned(pose: Transform, eye: Eye, dx: float, dy: float) -> Transform:
    """A pose turned by pixels of the mouse about the camera's axes up and right."""
    turn = multiply(about(eye.up, dx * RADIANS), about(eye.right, dy * RADIANS))
    return Transform(pose.xyz, multiply(turn, pose.rotation))


def rolled(pose: Transform, eye: Eye, dx: float, dy: float) -> Transform:
    """A pose turned about the direction in which the camera looks."""
    pixels = dy if abs(dy) > abs(dx) else dx
    return Transform(pose.xyz, multiply(about(eye.forward, pixels * RADIANS), pose.rotation))


def pushed(pose: Transform, along: Vector, dx: float, dy: float, metres: float) -> Transform:
    """A pose moved away (up, or to the right) along a ray, `metres` for each pixel."""
    pixels = dx if abs(dx) > abs(dy) else -dy
    return Transform(plus(pose.xyz, along, pixels * metres / math.sqrt(dot(along, along))), pose.rotation)


def turn_between(a: Vector, b: Vector) -> Quaternion:
    """The shortest rotation of one unit vector onto another."""
    axis = cross(a, b)
    if dot(axis, axis) < EPSILON**2:
        if dot(a, b) > 0:
            return 0.0, 0.0, 0.0, 1.0
        axis = cross(a, (0.0, 0.0, 1.0) if abs(a[2]) < 0.9 else (1.0, 0.0, 0.0))
    return about(axis, math.acos(max(-1.0, min(1.0, dot(a, b)))))


def facing(orientation: Quaternion, forward: Vector, up: Vector, angle: float) -> Quaternion:
    """The rotation of a control that faces the view: its x looks along the view, its z upwards, turned by an angle."""
    x, z = rotate(orientation, (1.0, 0.0, 0.0)), rotate(orientation, (0.0, 0.0, 1.0))
    first = turn_between(x, forward)
    return multiply(about(forward, angle), multiply(turn_between(rotate(first, z), up), first))


def plus(a: Vector, b: Vector, factor: float) -> Vector:
    return a[0] + b[0] * factor, a[1] + b[1] * factor, a[2] + b[2] * factor


def minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
