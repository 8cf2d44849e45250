"""The parts of a robot seen from above: its wheels, the outlines of everything else, and its bounds."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

from day6_urdf.kinematics import Transform, compose, inverse, link_transforms, multiply, rotate
from day6_urdf.model import (
    MOVING_TYPES,
    Box,
    Capsule,
    Collision,
    Cylinder,
    Joint,
    Link,
    Mesh,
    Pose,
    Robot,
    Sphere,
    Vector,
    Visual,
)


@dataclass(frozen=True, slots=True)
class Wheel:
    """A wheel: its joint, radius and width in metres, whether it is a ball, its centre in the link's frame, 0xRRGGBB or -1."""

    joint: Joint
    radius: float
    width: float
    ball: bool
    center: Pose
    colour: int = -1


@dataclass(frozen=True, slots=True)
class Body:
    """A shape that isn't a wheel: the points of its outline in the link's frame, or a centre and `radius`, in metres.

    `style` is 'chassis' for the largest one, 'caster' for balls, else 'body'. `colour` is the URDF's, 0xRRGGBB, or -1.
    """

    link: str
    style: str
    points: tuple[Vector, ...]
    radius: float = 0.0
    colour: int = -1


@dataclass(frozen=True, slots=True)
class TopPlan:
    """The parts of a robot drawn from above, and its bounds: left, bottom, right, top (metres, root frame).

    The bodies are in the order in which they are drawn, the chassis below all others.
    The bounds hold the robot at rest and, for the first few joints that carry no wheel, at their limits.
    """

    robot: Robot
    rest: dict[str, Transform]
    wheels: tuple[Wheel, ...]
    bodies: tuple[Body, ...]
    bounds: tuple[float, float, float, float]


MeshPoints = Callable[[str], Sequence[Vector]]
"""The corners of a mesh by the name that the URDF has for it, unscaled (metres, the shape's frame); none if it can't be read."""

_SWEPT_JOINTS = 8
"""So many joints of an arm are tried out for the bounds; each costs two poses of the whole robot."""


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
            return Wheel(joint, shape.radius, 2 * shape.radius, True, part.origin, _colour(part))
        if isinstance(shape, Cylinder):
            along = rotate(part.origin.rotation, (0.0, 0.0, 1.0))
            if abs(sum(a * b for a, b in zip(along, joint.axis, strict=True))) > 0.9 * length:
                return Wheel(joint, shape.radius, shape.length, False, part.origin, _colour(part))
    return None


def _colour(part: Visual | Collision) -> int:
    """0xRRGGBB of a visual's material, -1 if it has none."""
    color = part.material.color if isinstance(part, Visual) and part.material is not None else None
    if color is None:
        return -1
    red, green, blue = (round(255 * min(max(share, 0.0), 1.0)) for share in color[:3])
    return red << 16 | green << 8 | blue


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


def plan_top(robot: Robot, mesh_points: MeshPoints = lambda name: ()) -> TopPlan:
    """Return the parts of a robot to draw: once per robot, not for every picture."""
    rest = link_transforms(robot, {})
    wheels = tuple(find_wheels(robot))
    rolling = {wheel.joint.child for wheel in wheels}
    bodies = [
        body
        for link in robot.links
        if link.name in rest and link.name not in rolling
        for visual in link.visuals
        for body in _bodies(link.name, visual, mesh_points)
    ]
    if bodies:
        largest = max(bodies, key=lambda body: _area(body, rest[body.link]))
        chassis = largest.link
        bodies = [replace(b, style="chassis") if b.link == chassis and b.style == "body" else b for b in bodies]
        bodies.sort(key=lambda body: body.style != "chassis")
    poses = (rest, *_swept(robot, rolling))
    sides = list(zip(*(_bounds(wheels, bodies, pose) for pose in poses), strict=True))
    return TopPlan(robot, rest, wheels, tuple(bodies), (min(sides[0]), min(sides[1]), max(sides[2]), max(sides[3])))


def _bodies(link: str, visual: Visual, mesh_points: MeshPoints) -> Iterator[Body]:
    shape, origin, colour = visual.geometry, visual.origin, _colour(visual)
    if isinstance(shape, Sphere):
        yield Body(link, "caster", (origin.xyz,), shape.radius, colour)
    elif isinstance(shape, Cylinder | Capsule) and abs(rotate(origin.rotation, (0.0, 0.0, 1.0))[2]) > 0.9:
        yield Body(link, "body", (origin.xyz,), shape.radius, colour)
    elif isinstance(shape, Mesh):
        points = [_scaled(point, shape.scale) for point in mesh_points(shape.filename)]
        # Without its file a mesh is where it would be: a point.
        yield Body(
            link, "body", tuple(compose(origin, Pose(point)).xyz for point in points) or (origin.xyz,), 0.0, colour
        )
    else:
        size = shape.size if isinstance(shape, Box) else (2 * shape.radius, 2 * shape.radius, overall_length(shape))
        corners = [_scaled(signs, size) for signs in product((-0.5, 0.5), repeat=3)]
        yield Body(link, "body", tuple(compose(origin, Pose(corner)).xyz for corner in corners), 0.0, colour)


def overall_length(shape: Capsule | Cylinder) -> float:
    """Return how long it is, a capsule with its ends (metres)."""
    return shape.length + (2 * shape.radius if isinstance(shape, Capsule) else 0.0)


def _scaled(point: Sequence[float], scale: Vector) -> Vector:
    return point[0] * scale[0], point[1] * scale[1], point[2] * scale[2]


def _swept(robot: Robot, rolling: set[str]) -> Iterator[Mapping[str, Transform]]:
    """The robot with each of its first joints that carry no wheel at either end of its way."""
    moving = [joint for joint in robot.joints if joint.type in MOVING_TYPES and joint.child not in rolling]
    for joint in moving[:_SWEPT_JOINTS]:
        ends = (joint.limit.lower, joint.limit.upper) if joint.limit is not None else (-math.pi / 2, math.pi / 2)
        for end in ends:
            yield link_transforms(robot, {joint.name: min(max(end, -math.pi), math.pi)})


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
