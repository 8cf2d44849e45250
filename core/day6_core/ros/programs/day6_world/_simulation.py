"""The world itself, without ROS: one robot, its wheels, what it may hit, and what its sensors see. Time goes in steps.

The same steps with the same seed and the same commands give the same world, bit for bit.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from itertools import product

from day6_core.ros.programs.day6_world._drive import Drive
from day6_core.ros.programs.day6_world.scenery import Scenery
from day6_core.ros.programs.day6_world.shapes import Outline, RayCaster, clearance, distance, touch, within_reach
from day6_urdf.kinematics import Transform, compose, link_transforms, rotate
from day6_urdf.model import Box, Capsule, Collision, Cylinder, Pose, Robot, Sphere
from day6_urdf.topview.plan import hull, overall_length

STEP = 0.02
"""Seconds of one step: 50 a second."""

ACCELERATION = 30.0
"""Maximum acceleration of a wheel, rad/s²: from rest to 1 m/s in less than a second."""

SERVO = 10.0
"""1/s: a wheel commanded to an angle turns at this gain times the remaining angle."""

LONGEST_MOVE = 0.02
"""Metres the robot moves between two collision checks."""

Place = tuple[float, float, float]


class LostGround(Exception):
    """The robot would be inside a wall: it cannot enter there."""


class Simulation:
    """One robot in one scenery. `pose` is where it is (x, y, yaw), `odometry` where its wheels say it is."""

    def __init__(self, scenery: Scenery, seed: int = 0) -> None:
        self.scenery = scenery
        self._seed = seed
        self._random = random.Random(seed)
        self._rays = RayCaster(scenery.solids)
        self.robot: Robot | None = None
        self.drive: Drive | None = None
        self._shapes: tuple[Outline, ...] = ()
        self._free = (0.0, 0.0, 0.0)
        """Where nothing was hit, and how far the robot may be from there, turned anyhow, until something can be."""
        self._rest: dict[str, Transform] = {}
        self.steps = 0
        self.pose: Place = scenery.start
        self._start: Place = scenery.start
        self.odometry: Place = (0.0, 0.0, 0.0)
        self.velocity = (0.0, 0.0)
        """Of the body: metres and radians per second, as it really moved in the last step."""
        self.wheel_velocity = (0.0, 0.0)
        """The body's velocity as the wheels' encoders say: metres and radians per second."""
        self.angles: dict[str, float] = {}
        """Of all joints that move, radians or metres."""
        self.speeds: dict[str, float] = {}
        self.bumped = False
        self._wanted: dict[str, tuple[str, float]] = {}

    @property
    def time_ns(self) -> int:
        return self.steps * round(STEP * 1e9)

    def enter(self, robot: Robot, drive: Drive, start: Place | None = None) -> None:
        """Put a robot at its start, standing still. Raises LostGround."""
        place = self.scenery.start if start is None else start
        rest = link_transforms(robot, {})
        shapes = collision_shapes(robot, rest)
        self._free = (0.0, 0.0, 0.0)
        if self._hits(place, shapes):
            raise LostGround
        self.robot, self.drive, self._rest, self._shapes = robot, drive, rest, shapes
        moving = [j.name for j in robot.joints if j.type in ("continuous", "revolute", "prismatic") and j.mimic is None]
        self.angles = dict.fromkeys(moving, 0.0)
        self.speeds = dict.fromkeys(moving, 0.0)
        self._put_back(place)

    def reset(self) -> None:
        """Restore the initial state, including the time."""
        self._random = random.Random(self._seed)
        self.steps = 0
        if self.robot is not None:
            self.angles = dict.fromkeys(self.angles, 0.0)
            self.speeds = dict.fromkeys(self.speeds, 0.0)
            self._put_back(self._start)

    def _put_back(self, place: Place) -> None:
        self._start = self.pose = place
        self.odometry = (0.0, 0.0, 0.0)
        self.velocity = self.wheel_velocity = (0.0, 0.0)
        self.bumped = False
        self._wanted = {}

    # -- commands ------------------------------------------------------------------------------------------------------

    def order_velocity(self, linear: float, angular: float) -> None:
        """Drive at this velocity (m/s, rad/s), as far as the wheels can."""
        if self.drive is not None:
            for joint, speed in self.drive.wheel_speeds(linear, angular).items():
                self._wanted[joint] = ("speed", speed)

    def order_speed(self, joint: str, speed: float) -> None:
        """Turn a joint at this speed (rad/s or m/s)."""
        if joint in self.angles:
            self._wanted[joint] = ("speed", speed)

    def order_angle(self, joint: str, angle: float) -> None:
        """Turn a joint to this angle; a wheel goes the shorter way round."""
        if joint in self.angles:
            self._wanted[joint] = ("angle", angle)

    # -- one step ------------------------------------------------------------------------------------------------------

    def step(self) -> None:
        """Advance by `STEP` seconds."""
        self.steps += 1
        if self.robot is None or self.drive is None:
            return
        self._turn_joints()
        measured = self.drive.body_speed(self.speeds, gripping=False)
        self.odometry = self.drive.moved(self.odometry, *measured, STEP)
        self.wheel_velocity = measured
        linear, angular = self.drive.body_speed(self.speeds)
        before = self.pose
        self.bumped = False
        if linear or angular:
            self._move(linear, angular)
        forward = (self.pose[0] - before[0]) * math.cos(before[2]) + (self.pose[1] - before[1]) * math.sin(before[2])
        moved = math.remainder(self.pose[2] - before[2], 2 * math.pi)
        self.velocity = (linear, angular) if not self.bumped else (forward / STEP, moved / STEP)

    def _turn_joints(self) -> None:
        assert self.drive is not None
        limits = {wheel.joint: wheel.fastest for wheel in self.drive.wheels}
        for joint, angle in self.angles.items():
            kind, value = self._wanted.get(joint, ("speed", 0.0))
            if kind == "speed":
                wanted = value
            else:
                away = value - angle
                wanted = SERVO * (math.remainder(away, 2 * math.pi) if joint in limits else away)
            fastest = limits.get(joint, 10.0)
            wanted = min(max(wanted, -fastest), fastest)
            change = min(max(wanted - self.speeds[joint], -ACCELERATION * STEP), ACCELERATION * STEP)
            self.speeds[joint] += change
            self.angles[joint] = angle + self.speeds[joint] * STEP

    def _move(self, linear: float, angular: float) -> None:
        """Roll in short moves; at a wall, turn on the spot or slide along as far as possible."""
        assert self.drive is not None
        reach = max((shape.reach[2] for shape in self._shapes), default=0.3)
        count = max(1, math.ceil((abs(linear) + abs(angular) * reach) * STEP / LONGEST_MOVE))
        for _ in range(count):
            part = STEP / count
            for share in ((linear, angular), (0.0, angular), (linear, 0.0)):
                place = self.drive.moved(self.pose, *share, part)
                if any(share) and not self._hits(place, self._shapes):
                    self.pose = place
                    break
            else:
                self.bumped = True
                return
            self.bumped |= share != (linear, angular)

    def _hits(self, place: Place, shapes: tuple[Outline, ...]) -> bool:
        x, y, yaw = place
        from_x, from_y, free = self._free
        if math.hypot(x - from_x, y - from_y) < free:
            return False
        cosine, sine = math.cos(yaw), math.sin(yaw)
        for shape in shapes:
            mx, my, reach = shape.reach
            mx, my = x + mx * cosine - my * sine, y + mx * sine + my * cosine
            near = [solid for solid in self.scenery.solids if within_reach(mx, my, reach, solid)]
            if near:
                moved = shape.moved(x, y, cosine, sine)
                if any(touch(moved, solid) for solid in near):
                    return True
        around = max((math.hypot(mx, my) + reach for mx, my, reach in (shape.reach for shape in shapes)), default=0.0)
        self._free = x, y, clearance(x, y, self.scenery.solids, around)
        return False

    # -- sensors -------------------------------------------------------------------------------------------------------

    def mounted_at(self, link: str) -> Place:
        """Return the pose (x, y, yaw) of a link in the world."""
        x, y, yaw = self.pose
        at = self._rest.get(link)
        if at is None:
            return self.pose
        ax, ay, _ = rotate(at.rotation, (1.0, 0.0, 0.0))
        lx, ly, _ = at.xyz
        cosine, sine = math.cos(yaw), math.sin(yaw)
        return x + lx * cosine - ly * sine, y + lx * sine + ly * cosine, yaw + math.atan2(ay, ax)

    def scan(self, link: str, first: float, step: float, count: int, longest: float, noise: float) -> list[float]:
        """Return what a lidar on that link measures: metres to the nearest thing, inf where there is none."""
        x, y, yaw = self.mounted_at(link)
        ranges = self._rays.cast(x, y, yaw + first, step, count, longest)
        if noise > 0:
            gauss = self._random.gauss
            ranges = [value if math.isinf(value) else max(value + gauss(0.0, noise), 0.0) for value in ranges]
        return ranges

    def line_darkness(self, places: Mapping[str, tuple[float, float]] | list[tuple[float, float]]) -> list[float]:
        """Return how much of the line each sensor sees, 0 to 1; `places` are in the root link's frame."""
        x, y, yaw = self.pose
        cosine, sine = math.cos(yaw), math.sin(yaw)
        half, blur = self.scenery.line_width / 2, 0.01
        seen = []
        for px, py in places.values() if isinstance(places, Mapping) else places:
            wx, wy = x + px * cosine - py * sine, y + px * sine + py * cosine
            away = min((distance(wx, wy, piece) for piece in self.scenery.line), default=math.inf)
            seen.append(min(max((half - away) / blur + 0.5, 0.0), 1.0))
        return seen


def collision_shapes(robot: Robot, rest: Mapping[str, Transform]) -> tuple[Outline, ...]:
    """Return the parts of a robot that can touch a wall, seen from above: the outlines of its <collision> shapes."""
    shapes = (
        _shape(collision, compose(rest[link.name], collision.origin))
        for link in robot.links
        if link.name in rest
        for collision in link.collisions
    )
    return tuple(shape for shape in shapes if shape is not None)


def _shape(collision: Collision, at: Transform) -> Outline | None:
    shape = collision.geometry
    if isinstance(shape, Sphere):
        return Outline((at.xyz[:2],), shape.radius)
    if isinstance(shape, Box):
        size = shape.size
    elif isinstance(shape, Cylinder | Capsule):
        if abs(rotate(at.rotation, (0.0, 0.0, 1.0))[2]) > 0.99:
            return Outline((at.xyz[:2],), shape.radius)
        size = (2 * shape.radius, 2 * shape.radius, overall_length(shape))
    else:
        return None  # a mesh: its size is in another file
    corners = (Pose((x * size[0], y * size[1], z * size[2])) for x, y, z in product((-0.5, 0.5), repeat=3))
    outline = hull([compose(at, corner).xyz[:2] for corner in corners])
    return Outline(tuple(outline)) if len(outline) >= 3 else None
