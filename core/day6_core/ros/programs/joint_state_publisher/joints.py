"""The joints of a description that can be set, their limits, and the joints that follow others. Pure data.

As the original, this reads the XML by itself and is stricter than urdfdom about limits. SDF and COLLADA are read by
`other_formats`. URDF is read by our own reader, which expands no entities; expat first checks that the text is
well-formed, because the original reports expat's messages.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat

from day6_core.ros.programs.joint_state_publisher.other_formats import (
    DescriptionError,
    limit_value,
    missing_limits,
    read_collada,
    read_sdf,
)
from day6_urdf.check import MAX_BYTES
from day6_urdf.xmlreader import Element, XmlError, read_xml

FIXED_TYPES = ("fixed", "floating", "planar")


class MimicCycle(Exception):
    """Joints that follow each other in a ring: the original ends with status 1."""


@dataclass(slots=True)
class FreeJoint:
    """A joint that can be set: limits and values in radians or metres; a value that is None is not published."""

    name: str
    minimum: float
    maximum: float
    zero: float
    position: float | None = None
    velocity: float | None = None
    effort: float | None = None
    continuous: bool = False
    turns: bool = True
    """Whether its position is an angle (False for a prismatic joint)."""
    forward: bool = True
    """The direction in which `advance` moves it."""


@dataclass(frozen=True, slots=True)
class Follower:
    """position = factor * position of `parent` + offset."""

    parent: str
    factor: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True)
class JointOptions:
    """The parameters that decide what is read out of a description."""

    zeros: Mapping[str, float] = field(default_factory=dict)
    dependent_joints: Mapping[str, Follower] = field(default_factory=dict)
    use_mimic_tags: bool = True
    use_smallest_joint_limits: bool = True
    publish_default_positions: bool = True
    publish_default_velocities: bool = False
    publish_default_efforts: bool = False


@dataclass
class Joints:
    """All joints of one robot: `names` in the order of the file, each either free or a follower."""

    names: list[str] = field(default_factory=list)
    free: dict[str, FreeJoint] = field(default_factory=dict)
    followers: dict[str, Follower] = field(default_factory=dict)

    def values(self) -> tuple[list[str], list[float], list[float], list[float]]:
        """Return names, positions, velocities and efforts as they are published; empty lists for what no joint has.

        Raises MimicCycle, and KeyError when a joint follows one that does not exist.
        """
        free = self.free.values()
        count = len(self.free) + len(self.followers)
        positions = [0.0] * count if self.followers or any(joint.position is not None for joint in free) else []
        velocities = [0.0] * count if any(joint.velocity is not None for joint in free) else []
        efforts = [0.0] * count if any(joint.effort is not None for joint in free) else []
        for index, name in enumerate(self.names):
            joint, factor, offset = self._source(name)
            if positions and joint.position is not None:
                positions[index] = joint.position * factor + offset
            if velocities and joint.velocity is not None:
                velocities[index] = joint.velocity * factor
            if efforts and joint.effort is not None:
                efforts[index] = joint.effort
        return list(self.names), positions, velocities, efforts

    def _source(self, name: str) -> tuple[FreeJoint, float, float]:
        """Return the free joint that moves this one, and the factor and offset on the way."""
        factor, offset = 1.0, 0.0
        chain = []
        while name in self.followers and name not in self.free:
            chain.append(name)
            follower = self.followers[name]
            offset += factor * follower.offset
            factor *= follower.factor
            name = follower.parent
            if name in chain:
                raise MimicCycle(f"Found an infinite recursive mimic chain: {[*chain, name]}")
        return self.free[name], factor, offset

    def advance(self, delta: float) -> None:
        """Move every joint by `delta`: a continuous one round and round, any other back and forth between its limits."""
        for joint in self.free.values():
            position = (joint.position or 0.0) + (delta if joint.forward else -delta)
            if joint.forward and position > joint.maximum:
                joint.forward = joint.continuous
                position = joint.minimum if joint.continuous else joint.maximum
            elif not joint.forward and position < joint.minimum:
                joint.forward = True
                position = joint.minimum
            joint.position = position


def read_followers(parameters: Mapping[str, Any]) -> dict[str, Follower]:
    """Return the followers given by parameters ('JOINT.parent', 'JOINT.factor', 'JOINT.offset'). Raises DescriptionError."""
    found: dict[str, dict[str, Any]] = {}
    for name, value in parameters.items():
        joint, dot, key = name.partition(".")
        if not dot or "." in key:
            raise DescriptionError(f"Invalid dependent_joint name '{name}'")
        if key not in ("parent", "factor", "offset"):
            allowed = "(allowed values are 'parent', 'factor', 'offset')"
            raise DescriptionError(f"Invalid dependent_joint name '{key}' {allowed}")
        found.setdefault(joint, {})[key] = value
    if any(entry.get("parent") is None for entry in found.values()):
        raise DescriptionError("All dependent_joints must at least have a parent")
    return {joint: Follower(**entry) for joint, entry in found.items()}


def read_joints(text: str, options: JointOptions) -> Joints:
    """Return the joints of a URDF, an SDF model or COLLADA kinematics. Raises DescriptionError."""
    if len(text) > MAX_BYTES:
        raise DescriptionError(f"The description is too large: more than {MAX_BYTES // 1_000_000} MB are not read")
    _check_well_formed(text)
    try:
        elements = read_xml(text)
    except XmlError as error:
        raise DescriptionError(str(error)) from error
    joints = Joints()
    top = elements[0].tag if elements else ""
    if top in ("sdf", "COLLADA"):
        for name, kind, minimum, maximum in read_sdf(text) if top == "sdf" else read_collada(text):
            zero = _zero(name, minimum, maximum, options) if top == "sdf" else 0.0
            joints.names.append(name)
            _add_free(joints, options, name, kind, minimum, maximum, zero)
        return joints
    robot = next(_robots(elements), None)
    if robot is None:
        raise DescriptionError('URDF must have a "robot" tag')
    for element in robot.all("joint"):
        _add(element, joints, options)
    return joints


def _robots(elements: Sequence[Element]) -> Iterator[Element]:
    """Yield the elements <robot>, in the order of the file: one may be inside of another element."""
    for element in elements:
        if element.tag == "robot":
            yield element
        yield from _robots(element.children)


def _check_well_formed(text: str) -> None:
    """Raise DescriptionError with expat's message for text that isn't XML, and for entity definitions, which can only do harm."""
    parser = expat.ParserCreate()

    def refuse(*_: object) -> None:
        raise DescriptionError("entity definitions are not allowed in a robot description")

    parser.EntityDeclHandler = refuse
    try:
        parser.Parse(text.encode("utf-8", "replace"), True)
    except expat.ExpatError as error:
        raise DescriptionError(str(error)) from error


def _add(element: Element, joints: Joints, options: JointOptions) -> None:
    kind, name = element.attributes.get("type", ""), element.attributes.get("name", "")
    if kind in FIXED_TYPES:
        return
    if kind == "continuous":
        minimum, maximum = -math.pi, math.pi
    else:
        minimum, maximum = _limits(element, name, kind)
    safety = element.all("safety_controller")
    if options.use_smallest_joint_limits and len(safety) == 1:
        given = safety[0].attributes
        minimum = max(minimum, _float(given.get("soft_lower_limit"), minimum))
        maximum = min(maximum, _float(given.get("soft_upper_limit"), maximum))
    joints.names.append(name)
    mimics = element.all("mimic")
    if options.use_mimic_tags and len(mimics) == 1:
        given = mimics[0].attributes
        factor, offset = _float(given.get("multiplier"), 1.0), _float(given.get("offset"), 0.0)
        joints.followers[name] = Follower(given.get("joint", ""), factor, offset)
        return
    if name in options.dependent_joints:
        joints.followers[name] = options.dependent_joints[name]
        return
    _add_free(joints, options, name, kind, minimum, maximum, _zero(name, minimum, maximum, options))


def _zero(name: str, minimum: float, maximum: float, options: JointOptions) -> float:
    return options.zeros.get(name, (maximum + minimum) / 2 if minimum > 0 or maximum < 0 else 0.0)


def _add_free(
    joints: Joints, options: JointOptions, name: str, kind: str, minimum: float, maximum: float, zero: float
) -> None:
    joints.free[name] = FreeJoint(
        name,
        minimum,
        maximum,
        zero,
        float(zero) if options.publish_default_positions else None,
        0.0 if options.publish_default_velocities else None,
        0.0 if options.publish_default_efforts else None,
        kind == "continuous",
        kind != "prismatic",
    )


def _limits(element: Element, name: str, kind: str) -> tuple[float, float]:
    limit = element.first("limit")
    if limit is None:
        raise missing_limits(name, kind)
    low, high = (limit_value(limit.attributes.get(side), side, name, kind) for side in ("lower", "upper"))
    return low, high


def _float(text: str | None, default: float) -> float:
    if text is None:
        return default
    try:
        return float(text)
    except ValueError as error:
        raise DescriptionError(str(error)) from error
