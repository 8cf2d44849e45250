"""The parts of a robot seen from above: its wheels, the outlines of everything else, and its bounds."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product

from day6_urdf.kinematics import Transform, compose, inverse, link_transforms, multiply, rotate
from day6_urdf.model import Box, Collision, Cylinder, Joint, Link, Mesh, Pose, Robot, Sphere, Vector, Visual


@dataclass(frozen=True, slots=True)
class Wheel:
    """A wheel: its joint, its radius and width in metres, whether it is a ball, and its centre in the link's frame."""

    joint: Joint
    radius: float
    width: float
    ball: bool
    center: Pose


@dataclass(frozen=True, slots=True)
class Body:
    """A shape that isn't a wheel: the points of its outline in the link's frame, or a centre and `radius`, in metres."""

    link: str
    style: str
    points: tuple[Vector, ...]
    radius: float = 0.0


@dataclass(frozen=True, slots=True)
class TopPlan:
    """The parts of a robot drawn from above, and its bounds at rest: left, bottom, right, top (metres, root frame)."""

    robot: Robot
    rest: dict[str, Transform]
    wheels: tuple[Wheel, ...]
    bodies: tuple[Body, ...]
    bounds: tuple[float, float, float, float]


def find_wheels(robot: Robot) -> list[Wheel]:
    """Return the wheels: joints that turn about a horizontal axis and carry a cylinder along that axis, or a ball.

    A cylinder on a revolute joint counts, because beginners make wheels that way; a ball on one is an elbow.
    """
    rest = link_transforms(robot, {})
    wheels = []
    for joint in robot.tree():
        if joint.type in ("continuous", "revolute"):
            axis = rotate(rest[joint.child].rotation, joint.axis)
            length = math.hypot(*axis)
            if length > 0 and abs(axis[2]) < 0.3 * length:
                wheel = _wheel_of(joint, robot.link(joint.child))
                if wheel is not None:
                    wheels.append(wheel)
    return wheels


def _wheel_of(joint: Joint, link: Link) -> Wheel | None:
    length = math.hypot(*joint.axis)
    # A wheel drawn as a mesh often has a cylinder for collisions.
    parts: list[Visual | Collision] = [*link.visuals, *link.collisions]
    for part in parts:
        shape = part.geometry
        if isinstance(shape, Sphere) and joint.type == "continuous":
            return Wheel(joint, shape.radius, 2 * shape.radius, True, part.origin)
        if isinstance(shape, Cylinder):
            along = rotate(part.origin.rotation, (0.0, 0.0, 1.0))
            if abs(sum(a * b for a, b in zip(along, joint.axis, strict=True))) > 0.9 * length:
                return Wheel(joint, shape.radius, shape.length, False, part.origin)
    return None


def steering_of(robot: Robot, wheel: Wheel) -> Joint | None:
    """Return the joint above a wheel that turns it about the vertical (a steering knuckle, a caster's fork), if any."""
    above = {joint.child: joint for joint in robot.joints}
    joint = above.get(wheel.joint.parent)
    passed: set[str] = set()
    while joint is not None and joint.name not in passed:
        passed.add(joint.name)
        length = math.hypot(*joint.axis)
        if joint.type in ("continuous", "revolute") and length > 0 and abs(joint.axis[2]) > 0.9 * length:
            return joint
        joint = above.get(joint.parent)
    return None


def spin_of(wheel: Wheel, transforms: Mapping[str, Transform]) -> float:
    """Return the wheel's rotation, radians in (-pi, pi], from the transforms of its link and its parent."""
    joint = wheel.joint
    relative = multiply(inverse(transforms[joint.parent]).rotation, transforms[joint.child].rotation)
    turn = multiply(inverse(joint.origin).rotation, relative)
    along = sum(a * b for a, b in zip(joint.axis, turn[:3], strict=True)) / math.hypot(*joint.axis)
    angle = 2 * math.atan2(along, turn[3])
    return math.remainder(angle, 2 * math.pi)


def plan_top(robot: Robot) -> TopPlan:
    """Return the parts of a robot to draw; `render_top` calls it once per robot, not for every frame."""
    rest = link_transforms(robot, {})
    wheels = tuple(find_wheels(robot))
    rolling = {wheel.joint.child for wheel in wheels}
    bodies = [body for link in robot.links if link.name in rest and link.name not in rolling for body in _bodies(link)]
    if bodies:
        largest = max(bodies, key=lambda body: _area(body, rest[body.link]))
        bodies = [_as_chassis(body) if body.link == largest.link and body.style == "body" else body for body in bodies]
    return TopPlan(robot, rest, wheels, tuple(bodies), _bounds(wheels, bodies, rest))


def _bodies(link: Link) -> list[Body]:
    bodies = []
    for visual in link.visuals:
        shape, origin = visual.geometry, visual.origin
        if isinstance(shape, Sphere):
            bodies.append(Body(link.name, "caster", (origin.xyz,), shape.radius))
        elif isinstance(shape, Cylinder) and abs(rotate(origin.rotation, (0.0, 0.0, 1.0))[2]) > 0.9:
            bodies.append(Body(link.name, "body", (origin.xyz,), shape.radius))
        elif isinstance(shape, (Box, Cylinder)):
            size = shape.size if isinstance(shape, Box) else (2 * shape.radius, 2 * shape.radius, shape.length)
            signs = product((-0.5, 0.5), repeat=3)
            corners = [(x * size[0], y * size[1], z * size[2]) for x, y, z in signs]
            bodies.append(Body(link.name, "body", tuple(compose(origin, Pose(corner)).xyz for corner in corners)))
        elif isinstance(shape, Mesh):
            bodies.append(Body(link.name, "body", (origin.xyz,)))  # its size is in another file: a point
    return bodies


def _as_chassis(body: Body) -> Body:
    return Body(body.link, "chassis", body.points, body.radius)


def _area(body: Body, transform: Transform) -> float:
    if len(body.points) == 1:
        return math.pi * body.radius**2
    outline = hull([flat(transform, point) for point in body.points])
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1], strict=True))) / 2


def _bounds(
    wheels: tuple[Wheel, ...], bodies: list[Body], rest: Mapping[str, Transform]
) -> tuple[float, float, float, float]:
    xs, ys = [0.0], [0.0]
    reach = [(body.link, point, body.radius) for body in bodies for point in body.points]
    reach += [(wheel.joint.child, wheel.center.xyz, 0.0) for wheel in wheels]
    for link, point, radius in reach:
        x, y = flat(rest[link], point)
        xs += (x - radius, x + radius)
        ys += (y - radius, y + radius)
    for wheel in wheels:
        (x, y), (hx, hy) = stand(wheel, rest)
        half_x = abs(hx) * wheel.radius + abs(hy) * wheel.width / 2
        half_y = abs(hy) * wheel.radius + abs(hx) * wheel.width / 2
        xs += (x - half_x, x + half_x)
        ys += (y - half_y, y + half_y)
    return min(xs), min(ys), max(xs), max(ys)


def flat(transform: Transform, point: Vector) -> tuple[float, float]:
    """Return a point of a link (metres, link frame) as seen from above: x, y in the root frame."""
    x, y, _ = compose(transform, Pose(point)).xyz
    return x, y


def stand(wheel: Wheel, transforms: Mapping[str, Transform]) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the wheel's centre (metres, root frame) and the unit direction its top moves in as the joint's angle grows."""
    transform = transforms[wheel.joint.child]
    ax, ay, _ = rotate(transform.rotation, wheel.joint.axis)
    length = math.hypot(ax, ay)
    heading = (ay / length, -ax / length) if length > 0 else (1.0, 0.0)  # axis x up
    return flat(transform, wheel.center.xyz), heading


def hull(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the convex hull, anticlockwise (Andrew's monotone chain)."""
    ordered = sorted({(round(x, 9), round(y, 9)) for x, y in points})
    if len(ordered) < 3:
        return ordered

    def half(run: list[tuple[float, float]]) -> list[tuple[float, float]]:
        chain: list[tuple[float, float]] = []
        for x, y in run:
            while len(chain) > 1:
                (ax, ay), (bx, by) = chain[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 1e-12:
                    break
                chain.pop()
            chain.append((x, y))
        return chain[:-1]

    return half(ordered) + half(ordered[::-1])
