"""How draw_square drives: two metres ahead, a quarter turn, again for ever (turtlesim/draw_square.cpp).

Every number is a 32-bit float, as in the original. Headings are compared without going round, and each corner starts
from where the turtle really stopped, so the square drifts.
"""

from __future__ import annotations

import math

from day6_core.ros.programs.turtlesim.model.turtle import Pose, float32

PI = float32(3.141592)
SIDE = 2.0  # metres
FORWARD_SPEED = 1.0  # m/s
TURN_SPEED = float32(0.4)  # rad/s
NEAR = 0.1  # metres, along each axis
ALIGNED = 0.01  # radians
STANDING = 0.0001  # m/s and rad/s

_TURN_BY = float32(PI / 2.0)
_ROUND = float32(2.0 * PI)


class Square:
    """The plan of one turtle; feed it the latest pose at every timer call."""

    def __init__(self) -> None:
        self.goal: tuple[float, float, float] | None = None
        self._turning = False
        self._stopping = False

    def decide(self, pose: Pose) -> tuple[tuple[float, float] | None, list[str]]:
        """Return the command to publish now, (linear m/s, angular rad/s) or None, and the lines to log."""
        lines = []
        if self.goal is None:
            self.goal = _ahead(pose)
            lines.append(self._announcement())
        if not self._stopping:
            if not self._reached(pose):
                return ((0.0, TURN_SPEED) if self._turning else (FORWARD_SPEED, 0.0)), lines
            self._stopping = True
            return (0.0, 0.0), lines
        if not (pose.angular_velocity < STANDING and pose.linear_velocity < STANDING):
            return (0.0, 0.0), lines
        self._stopping = False
        self._turning = not self._turning
        self.goal = _corner(pose) if self._turning else _ahead(pose)
        return None, [*lines, "Reached goal", self._announcement()]

    def _reached(self, pose: Pose) -> bool:
        assert self.goal is not None
        off_x, off_y, off_theta = (abs(float32(now - goal)) for now, goal in zip(pose[:3], self.goal, strict=True))
        return off_x < NEAR and off_y < NEAR and off_theta < ALIGNED

    def _announcement(self) -> str:
        return "New goal [{:f} {:f}, {:f}]".format(*self.goal or ())


def _ahead(pose: Pose) -> tuple[float, float, float]:
    x = float32(math.cos(pose.theta) * SIDE + pose.x)
    y = float32(math.sin(pose.theta) * SIDE + pose.y)
    return x, y, pose.theta


def _corner(pose: Pose) -> tuple[float, float, float]:
    theta = float32(math.fmod(float32(pose.theta + _TURN_BY), _ROUND))
    return pose.x, pose.y, float32(theta - _ROUND) if theta >= PI else theta
