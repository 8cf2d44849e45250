"""One turtle: where it is, what it was told, and what one tick of 16 ms makes of that (turtlesim/turtle.cpp).

Inside, a turtle lives on the canvas: metres, x to the right, y down from the top edge, in double precision as Qt keeps
them. What it reports is a ROS pose: y up from the bottom edge, 32-bit floats.
"""

from __future__ import annotations

import math
from array import array
from typing import NamedTuple

from day6_core.ros.programs.turtlesim.model.trail import PIXELS_PER_METRE, SIZE, Trail


def float32(value: float) -> float:
    """Round to the nearest 32-bit float, as C++ does when it stores a `float` (too large becomes infinite)."""
    return array("f", (value,))[0]


PI = 3.14159265
"""turtlesim's own constant, a little short of π."""

TICK = 0.016
"""Seconds a tick moves a turtle. The original takes the timer's period, not the time that passed."""

COMMAND_TIMEOUT_NS = 1_000_000_000
"""A velocity command older than this (strictly) stops the turtle."""

WIDTH = HEIGHT = float32((SIZE - 1) / PIXELS_PER_METRE)
"""Size of the world in metres."""

DEFAULT_PEN_RGB = 0xB3B8FF
DEFAULT_PEN_WIDTH = 3

ROTATION_SPEED = 1.0  # rad/s, of rotate_absolute
ROTATION_TOLERANCE = 0.02  # rad


class Pose(NamedTuple):
    """What turtlesim/msg/Pose carries: metres, radians, m/s, rad/s; every number a 32-bit float."""

    x: float
    y: float
    theta: float
    linear_velocity: float
    angular_velocity: float


class TurtleStep(NamedTuple):
    """What one tick did to a turtle."""

    pose: Pose
    colour: tuple[int, int, int]  # red, green, blue under the turtle, before this tick's line
    wall: tuple[float, float] | None  # canvas position outside the world from which it was put back
    rotation: Rotation | None  # the rotation this tick worked on, perhaps just finished
    changed: bool  # the picture differs from before


class Rotation:
    """A goal of rotate_absolute on its way.

    `remaining` (radians, updated every tick) is the feedback, `delta` the result: start minus end, so turning left
    gives a negative number. `outcome` is None as long as the turtle turns, then 'succeeded', 'canceled' or 'aborted'.
    """

    __slots__ = ("canceling", "delta", "goal", "outcome", "remaining", "start")

    def __init__(self, goal: float, start: float) -> None:
        self.goal = goal
        self.start = start
        self.remaining = 0.0
        self.delta = 0.0
        self.canceling = False
        self.outcome: str | None = None

    def advance(self, theta: float) -> float:
        """Note the heading `theta`; return the angular velocity to turn with, or 0.0 when the goal is reached."""
        goal = normalize(self.goal)
        seen = float32(theta)
        remaining = normalize(goal - seen)
        self.delta = float32(normalize(float32(self.start - theta)))
        self.remaining = float32(remaining)
        if abs(normalize(seen - goal)) < ROTATION_TOLERANCE:
            self.outcome = "succeeded"
            return 0.0
        return -ROTATION_SPEED if remaining < 0.0 else ROTATION_SPEED


class Turtle:
    """A turtle at pose (x, y, theta), in metres and radians, born at `now` (nanoseconds).

    Poses come in messages of 32-bit floats, so they are rounded to those.

    `kind` says which picture it wears. Commands change what the next `step()` does; nothing moves before it.
    """

    def __init__(self, name: str, x: float, y: float, theta: float, *, kind: str, now: int) -> None:
        self.name = name
        self.kind = kind
        self.x = float32(x)
        self.y = float32(HEIGHT - float32(y))
        self.theta = float32(theta)
        self.velocity_x = 0.0
        self.velocity_y = 0.0
        self.velocity_angular = 0.0
        self.pen_on = True
        self.pen_rgb = DEFAULT_PEN_RGB
        self.pen_width = DEFAULT_PEN_WIDTH
        self.rotation: Rotation | None = None
        self._commanded = now
        self._teleports: list[tuple[float, float, float] | tuple[float, float]] = []
        self.pose = self._pose()

    def command(self, linear_x: float, angular: float, now: int, *, linear_y: float | None = None) -> Rotation | None:
        """Drive with these velocities (m/s, rad/s) for a second; return the rotation that this aborted, if any.

        `linear_y` is given for holonomic turtles only; without it the sideways velocity stays what it was.
        """
        self._commanded = now
        self.velocity_x = linear_x
        if linear_y is not None:
            self.velocity_y = linear_y
        self.velocity_angular = angular
        return self.abort()

    def rotate(self, theta: float) -> Rotation:
        """Begin to turn to the heading `theta` at 1 rad/s the shorter way round; a rotation under way is aborted."""
        self.abort()
        self.rotation = Rotation(float32(theta), self.theta)
        return self.rotation

    def abort(self) -> Rotation | None:
        """End the rotation under way as aborted and return it."""
        rotation, self.rotation = self.rotation, None
        if rotation is not None:
            rotation.outcome = "aborted"
        return rotation

    def set_pen(self, r: int, g: int, b: int, width: int, off: int) -> None:
        """Take up another pen (0..255 each, width in pixels, 0 means 1). `off` lifts the pen and keeps its colour."""
        self.pen_on = not off
        if not off:
            self.pen_rgb = r << 16 | g << 8 | b
            self.pen_width = width or 1

    def teleport_absolute(self, x: float, y: float, theta: float) -> None:
        """Be at this pose (metres, radians) from the next tick on; the pen draws the way there."""
        self._teleports.append((float32(x), float32(y), float32(theta)))

    def teleport_relative(self, linear: float, angular: float) -> None:
        """At the next tick turn by `angular`, then go `linear` metres that way; the pen draws the way."""
        self._teleports.append((float32(linear), float32(angular)))

    @property
    def stands(self) -> bool:
        """Whether nothing moves it: no velocity, no rotation, no teleport that waits for the next tick."""
        driven = self.velocity_x or self.velocity_y or self.velocity_angular
        return not (driven or self._teleports or self.rotation is not None)

    def glides(self, ticks: int) -> bool:
        """Whether so many ticks can do no more than move it: it stays away from the walls and does not turn to a goal."""
        way = (abs(self.velocity_x) + abs(self.velocity_y)) * TICK * ticks
        inside = way < self.x < WIDTH - way and way < self.y < HEIGHT - way
        return inside and self.rotation is None and not self._teleports

    def step(self, now: int, trail: Trail) -> TurtleStep:
        """Live through one tick that ends at `now` (nanoseconds), drawing on `trail`."""
        changed = bool(self._teleports)
        if changed:
            self._teleport(trail)
        rotation = self.rotation
        if rotation is not None:
            self._turn(rotation, now)
        if now - self._commanded > COMMAND_TIMEOUT_NS:
            self._stop()

        old_x, old_y = self.x, self.y
        self.theta = theta = normalize(self.theta + self.velocity_angular * TICK)
        cos, sin = (math.cos(theta), math.sin(theta)) if math.isfinite(theta) else (math.nan, math.nan)
        vx, vy = self.velocity_x, self.velocity_y
        x = old_x + (cos * vx * TICK - sin * vy * TICK)
        y = old_y - (cos * vy * TICK + sin * vx * TICK)
        wall = (x, y) if x < 0 or x > WIDTH or y < 0 or y > HEIGHT else None
        self.x = x = _clamp(x, WIDTH)
        self.y = y = _clamp(y, HEIGHT)

        before = self.pose
        self.pose = pose = self._pose()
        colour = trail.colour_at(x * PIXELS_PER_METRE, y * PIXELS_PER_METRE)
        if abs(x - old_x) > 1e-12 or abs(y - old_y) > 1e-12:  # Qt compares points with that much tolerance
            self._draw(trail, old_x, old_y)
        return TurtleStep(pose, colour, wall, rotation, changed or pose != before)

    def _teleport(self, trail: Trail) -> None:
        for request in self._teleports:
            old_x, old_y, begin = self.x, self.y, trail.drawn
            if len(request) == 2:
                linear, angular = request
                self.theta += angular
                if math.isfinite(self.theta):
                    self.x += math.cos(self.theta) * linear
                    self.y += -math.sin(self.theta) * linear
                else:
                    self.x = self.y = math.nan
            else:
                self.x, up, self.theta = request
                self.y = max(0.0, HEIGHT - up)
            self._draw(trail, old_x, old_y)
            trail.jumps.append((begin, trail.drawn))
        self._teleports.clear()

    def _turn(self, rotation: Rotation, now: int) -> None:
        if rotation.canceling:
            rotation.outcome = "canceled"
            self._stop()
        else:
            angular = rotation.advance(self.theta)
            self._stop()
            self.velocity_angular = angular
            if rotation.outcome is None:
                self._commanded = now
        if rotation.outcome is not None:
            self.rotation = None

    def _stop(self) -> None:
        self.velocity_x = self.velocity_y = self.velocity_angular = 0.0

    def _draw(self, trail: Trail, old_x: float, old_y: float) -> None:
        if self.pen_on:
            m = PIXELS_PER_METRE
            trail.draw_line(self.x * m, self.y * m, old_x * m, old_y * m, self.pen_rgb, self.pen_width)

    def _pose(self) -> Pose:
        vx, vy = self.velocity_x, self.velocity_y
        # The speed is a length: driving backward it is positive too.
        values = (self.x, HEIGHT - self.y, self.theta, math.sqrt(vx * vx + vy * vy), self.velocity_angular)
        return Pose._make(array("f", values))


def normalize(angle: float) -> float:
    """Return the angle in radians brought into [-π, π), with turtlesim's π; not a number for an infinite angle."""
    if not math.isfinite(angle):
        return math.nan
    return angle - 2.0 * PI * math.floor((angle + PI) / (2.0 * PI))


def _clamp(value: float, high: float) -> float:
    # In this order a value that is not a number stays one, as with std::min(std::max(value, 0.0), high).
    value = 0.0 if value < 0.0 else value
    return high if high < value else value
