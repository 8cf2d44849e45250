"""How wheels move a robot: a differential drive whose wheels roll on the floor without slipping sideways."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from day6_urdf.kinematics import link_transforms
from day6_urdf.model import Robot
from day6_urdf.topview.plan import Wheel, find_wheels, stand, steering_of

FASTEST = 40.0
"""Radians per second of a wheel whose joint has no velocity limit."""


@dataclass(frozen=True, slots=True)
class DrivenWheel:
    """`sign` says which way the wheel rolls when its joint's angle grows; `grips` whether it touches the floor."""

    joint: str
    x: float
    y: float
    radius: float
    sign: float
    fastest: float
    grips: bool


@dataclass(frozen=True)
class Drive:
    """The wheels of both sides, the distance between them (`track`, metres) and the position of the axle's middle."""

    left: tuple[DrivenWheel, ...]
    right: tuple[DrivenWheel, ...]
    track: float
    middle: tuple[float, float]

    @property
    def wheels(self) -> tuple[DrivenWheel, ...]:
        return (*self.left, *self.right)

    def wheel_speeds(self, linear: float, angular: float) -> dict[str, float]:
        """Return how fast each joint turns (rad/s) for a velocity of the body (m/s, rad/s)."""
        speeds = {}
        for side, wheels in ((-1.0, self.left), (1.0, self.right)):
            for wheel in wheels:
                speed = (linear + side * angular * self.track / 2) / wheel.radius * wheel.sign
                speeds[wheel.joint] = min(max(speed, -wheel.fastest), wheel.fastest)
        return speeds

    def body_speed(self, speeds: Mapping[str, float], gripping: bool = True) -> tuple[float, float]:
        """Return the body's velocity (m/s, rad/s) for these wheel speeds if no wheel slips.

        With `gripping`, wheels that do not touch the floor push nothing; a side without any gives no motion at all.
        """
        sides = []
        for wheels in (self.left, self.right):
            used = [wheel for wheel in wheels if wheel.grips or not gripping]
            if not used:
                return 0.0, 0.0
            rolled = sum(speeds.get(wheel.joint, 0.0) * wheel.radius * wheel.sign for wheel in used)
            sides.append(rolled / len(used))
        left, right = sides
        return (left + right) / 2, (right - left) / self.track

    def moved(
        self, pose: tuple[float, float, float], linear: float, angular: float, seconds: float
    ) -> tuple[float, float, float]:
        """Return the pose (x, y, yaw) of the root link after rolling along an arc about the axle's middle."""
        x, y, yaw = pose
        mx, my = self.middle
        ax = x + mx * math.cos(yaw) - my * math.sin(yaw)
        ay = y + mx * math.sin(yaw) + my * math.cos(yaw)
        turn = angular * seconds
        length = linear * seconds
        # The chord of the arc, exactly: sin(t/2)/(t/2) is 1 for a straight line.
        chord = length * (math.sin(turn / 2) / (turn / 2) if abs(turn) > 1e-9 else 1.0)
        ax += chord * math.cos(yaw + turn / 2)
        ay += chord * math.sin(yaw + turn / 2)
        yaw += turn
        return (
            ax - mx * math.cos(yaw) + my * math.sin(yaw),
            ay - mx * math.sin(yaw) - my * math.cos(yaw),
            math.remainder(yaw, 2 * math.pi),
        )


def find_drive(robot: Robot, left: Sequence[str] = (), right: Sequence[str] = ()) -> Drive | None:
    """Return the drive of a robot, None if it has no wheel on one side.

    Without joint names the driven wheels are detected: continuous joints with a wheel that looks along x, on the left
    (y > 0) and on the right. Balls, wheels in the middle and wheels behind a steering or castor joint turn freely.
    """
    rest = link_transforms(robot, {})
    sides: tuple[list[DrivenWheel], list[DrivenWheel]] = ([], [])
    for wheel in find_wheels(robot):
        (x, y), (hx, _) = stand(wheel, rest)
        name = wheel.joint.name
        if left or right:
            side = sides[0] if name in left else sides[1] if name in right else None
        elif wheel.ball or wheel.joint.type != "continuous" or abs(hx) < 0.9 or steering_of(robot, wheel) is not None:
            side = None
        else:
            side = None if abs(y) < 1e-3 else sides[0] if y > 0 else sides[1]
        if side is not None and wheel.radius > 0:
            side.append(_driven(robot, wheel, x, y, hx))
    if not (sides[0] and sides[1]):
        return None
    ys = [sum(wheel.y for wheel in side) / len(side) for side in sides]
    both = [*sides[0], *sides[1]]
    track = ys[0] - ys[1]
    if track <= 0:
        return None
    middle = (sum(wheel.x for wheel in both) / len(both), (ys[0] + ys[1]) / 2)
    return Drive(tuple(sides[0]), tuple(sides[1]), track, middle)


def _driven(robot: Robot, wheel: Wheel, x: float, y: float, hx: float) -> DrivenWheel:
    limit = wheel.joint.limit
    fastest = limit.velocity if limit is not None and 0 < limit.velocity < math.inf else FASTEST
    grips = bool(robot.link(wheel.joint.child).collisions)
    return DrivenWheel(wheel.joint.name, x, y, wheel.radius, 1.0 if hx >= 0 else -1.0, min(fastest, FASTEST), grips)
