"""A robot as plain, frozen data: links, joints, shapes, materials. Metres, radians, kilograms; quaternions x, y, z, w.

Field names are those of URDF and of urdfdom's classes (urdf_model/*.h).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

JOINT_TYPES = ("planar", "floating", "revolute", "continuous", "prismatic", "fixed")
MOVING_TYPES = ("revolute", "continuous", "prismatic")
"""Joints with a single position, which robot_state_publisher moves."""


def unit(rotation: Quaternion) -> Quaternion:
    """Return the unit quaternion of the same rotation; zeros are none (urdf_model/pose.h)."""
    x, y, z, w = rotation
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    return (x / norm, y / norm, z / norm, w / norm) if norm > 0 else (0.0, 0.0, 0.0, 1.0)


def quaternion_from_rpy(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the unit quaternion of fixed-axis roll, pitch, yaw (radians), as urdfdom computes it (urdf_model/pose.h)."""
    sr, cr = math.sin(roll / 2), math.cos(roll / 2)
    sp, cp = math.sin(pitch / 2), math.cos(pitch / 2)
    sy, cy = math.sin(yaw / 2), math.cos(yaw / 2)
    x = sr * cp * cy - cr * sp * sy
    y = cr * sp * cy + sr * cp * sy
    z = cr * cp * sy - sr * sp * cy
    w = cr * cp * cy + sr * sp * sy
    return unit((x, y, z, w))


@dataclass(frozen=True, slots=True)
class Pose:
    """Position in metres and rotation (unit quaternion x, y, z, w) in the parent's frame."""

    xyz: Vector = (0.0, 0.0, 0.0)
    rotation: Quaternion = (0.0, 0.0, 0.0, 1.0)

    @staticmethod
    def from_rpy(xyz: Vector, rpy: Vector) -> Pose:
        """Return the pose of an <origin>: metres, and fixed-axis roll, pitch, yaw in radians."""
        return Pose(xyz, quaternion_from_rpy(*rpy))

    @property
    def rpy(self) -> Vector:
        """Roll, pitch, yaw in radians, as urdfdom computes them (roll 0 at a pitch of ±90°)."""
        x, y, z, w = self.rotation
        sine = -2 * (x * z - w * y)
        if sine <= -0.99999:
            return 0.0, -math.pi / 2, 2 * math.atan2(x, -y)
        if sine >= 0.99999:
            return 0.0, math.pi / 2, 2 * math.atan2(-x, y)
        return (
            math.atan2(2 * (y * z + w * x), w * w - x * x - y * y + z * z),
            math.asin(sine),
            math.atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z),
        )


@dataclass(frozen=True, slots=True)
class Box:
    """`size` is the three side lengths in metres; the origin is at the centre."""

    size: Vector


@dataclass(frozen=True, slots=True)
class Cylinder:
    """Radius and length in metres; the origin is at the centre, the axis is z of the frame."""

    radius: float
    length: float


@dataclass(frozen=True, slots=True)
class Sphere:
    """`radius` in metres; the origin is at the centre."""

    radius: float


@dataclass(frozen=True, slots=True)
class Mesh:
    """`filename` is as written (`package://…`, `file://…` or a path); `scale` has one factor per axis."""

    filename: str
    scale: Vector = (1.0, 1.0, 1.0)


@dataclass(frozen=True, slots=True)
class Capsule:
    """A cylinder along z with half a sphere at either end (URDF 1.1): radius, and length without the ends, in metres."""

    radius: float
    length: float


Geometry = Box | Capsule | Cylinder | Sphere | Mesh


@dataclass(frozen=True, slots=True)
class Material:
    """`color` is red, green, blue, alpha in 0..1; None if there is only a texture."""

    name: str
    color: tuple[float, float, float, float] | None = None
    texture: str | None = None


@dataclass(frozen=True, slots=True)
class Visual:
    """A shape that is drawn. `material` is resolved by name, wherever it is defined; None if there is none or it is undefined."""

    geometry: Geometry
    origin: Pose = Pose()
    name: str = ""
    material_name: str = ""
    material: Material | None = None


@dataclass(frozen=True, slots=True)
class Collision:
    """A shape for collisions, and its pose in the frame of the link."""

    geometry: Geometry
    origin: Pose = Pose()
    name: str = ""


@dataclass(frozen=True, slots=True)
class Inertial:
    """Mass in kg and inertia in kg m² (ixx, ixy, ixz, iyy, iyz, izz) about `origin`."""

    mass: float = 0.0
    inertia: tuple[float, float, float, float, float, float] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    origin: Pose = Pose()


@dataclass(frozen=True, slots=True)
class Link:
    """A rigid part. `inertial` is None if the file has none: then forces cannot move it."""

    name: str
    visuals: tuple[Visual, ...] = ()
    collisions: tuple[Collision, ...] = ()
    inertial: Inertial | None = None


@dataclass(frozen=True, slots=True)
class Limit:
    """Limits of a joint: position in radians or metres, effort in N m or N, velocity in rad/s or m/s.

    Since URDF 1.2 also acceleration and deceleration (rad/s² or m/s²) and jerk (rad/s³ or m/s³).
    """

    lower: float = 0.0
    upper: float = 0.0
    effort: float = 0.0
    velocity: float = 0.0
    acceleration: float = math.inf
    deceleration: float = math.inf
    jerk: float = math.inf


@dataclass(frozen=True, slots=True)
class Mimic:
    """position = multiplier * position of `joint` + offset (radians or metres)."""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True, slots=True)
class Dynamics:
    """Damping in N m s/rad or N s/m, friction in N m or N."""

    damping: float = 0.0
    friction: float = 0.0


@dataclass(frozen=True, slots=True)
class Safety:
    """Soft limits in radians or metres; `k_position` and `k_velocity` limit velocity and effort near them (safety_controller)."""

    soft_lower_limit: float = 0.0
    soft_upper_limit: float = 0.0
    k_position: float = 0.0
    k_velocity: float = 0.0


@dataclass(frozen=True, slots=True)
class Calibration:
    """Positions, in radians or metres, at which a reference signal rises or falls."""

    rising: float | None = None
    falling: float | None = None


@dataclass(frozen=True, slots=True)
class Joint:
    """`origin` is the pose of the joint, and of the child at position 0, in the parent; `axis` is not normalised."""

    name: str
    type: str
    parent: str
    child: str
    origin: Pose = Pose()
    axis: Vector = (1.0, 0.0, 0.0)
    limit: Limit | None = None
    mimic: Mimic | None = None
    dynamics: Dynamics | None = None
    safety: Safety | None = None
    calibration: Calibration | None = None


@dataclass(frozen=True)
class Robot:
    """A checked robot: names are unique, every joint's links exist, there is exactly one root.

    `links`, `joints` and `materials` are in the order of the file; urdfdom iterates them sorted by name, as `children_of` does.
    A link may have two parents and links may form a loop (urdfdom accepts both): see `loop`.
    """

    name: str
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    materials: tuple[Material, ...] = ()
    _links: dict[str, Link] = field(init=False, repr=False, compare=False)
    _joints: dict[str, Joint] = field(init=False, repr=False, compare=False)
    _children: dict[str, tuple[Joint, ...]] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        children: dict[str, list[Joint]] = {}
        for joint in sorted(self.joints, key=lambda joint: joint.name):
            children.setdefault(joint.parent, []).append(joint)
        object.__setattr__(self, "_links", {link.name: link for link in self.links})
        object.__setattr__(self, "_joints", {joint.name: joint for joint in self.joints})
        object.__setattr__(self, "_children", {name: tuple(joints) for name, joints in children.items()})

    def link(self, name: str) -> Link:
        """Return the link of this name. Raises KeyError."""
        return self._links[name]

    def joint(self, name: str) -> Joint:
        """Return the joint of this name. Raises KeyError."""
        return self._joints[name]

    def has_joint(self, name: str) -> bool:
        """Return whether there is a joint of this name."""
        return name in self._joints

    def children_of(self, link: str) -> tuple[Joint, ...]:
        """Return the joints whose parent is this link, sorted by name as in urdfdom's maps."""
        return self._children.get(link, ())

    @property
    def root(self) -> str:
        """The name of the link that is not a child."""
        children = {joint.child for joint in self.joints}
        for link in sorted(self._links):
            if link not in children:
                return link
        raise ValueError("No root link found. The robot xml is not a valid tree.")

    def tree(self) -> Iterator[Joint]:
        """Yield the joints from the root down, parents before children; every link is visited once."""
        entered = {self.root}
        waiting = list(reversed(self.children_of(self.root)))
        while waiting:
            joint = waiting.pop()
            if joint.child in entered:
                continue
            entered.add(joint.child)
            yield joint
            waiting.extend(reversed(self.children_of(joint.child)))

    @property
    def loop(self) -> tuple[str, ...]:
        """A loop of links, `('a', 'b', 'a')`, if one can be reached from the root, else `()`; the real tools crash on one."""
        path: list[str] = []
        on_path: set[str] = set()
        done: set[str] = set()
        steps: list[tuple[str, bool]] = [(self.root, False)]
        while steps:
            link, leaving = steps.pop()
            if leaving:
                path.pop()
                on_path.discard(link)
                done.add(link)
            elif link in on_path:
                return (*path[path.index(link) :], link)
            elif link not in done:
                path.append(link)
                on_path.add(link)
                steps.append((link, True))
                steps.extend((joint.child, False) for joint in reversed(self.children_of(link)))
        return ()
