"""What a robot description makes: for every link the solids it shows, read and loaded in a thread."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from day6_core.ros.programs.rviz2.model.scene import BOX, CYLINDER, SPHERE, Colour
from day6_core.ros.robot_check import newest_urdf
from day6_urdf.kinematics import IDENTITY, Transform, compose
from day6_urdf.load import RobotError, parse_robot
from day6_urdf.model import Box, Capsule, Cylinder, Inertial, Link, Mesh, Robot, Sphere, Vector

RED: Colour = (1.0, 0.0, 0.0, 1.0)
"""Of a link without material (RVIZ/ShadedRed), of masses and inertias."""

LEAD = 11340.0
"""kg/m³; a mass is shown as a ball of lead (robot_link.cpp)."""

MOST_MESH_TEXT = 256
"""Longest mesh error, as in the original's buffer."""


@dataclass(frozen=True, slots=True)
class RobotPart:
    """One solid of a link, in the link's frame; `mesh` has the data of kind 'mesh'."""

    kind: str
    pose: Transform
    size: Vector
    colour: Colour
    wheel: bool = False
    mesh: Any = None


@dataclass(slots=True)
class LinkParts:
    visual: list[RobotPart] = field(default_factory=list)
    collision: list[RobotPart] = field(default_factory=list)
    mass: RobotPart | None = None
    inertia: RobotPart | None = None
    errors: list[str] = field(default_factory=list)


@dataclass(slots=True)
class RobotParts:
    """A robot, or the reason why there is none."""

    robot: Robot | None = None
    problem: str = ""
    links: dict[str, LinkParts] = field(default_factory=dict)
    log: list[str] = field(default_factory=list)
    """Lines for the error log."""

    @property
    def geometry_errors(self) -> str:
        """The text of the status `URDF` when meshes are missing, '' when none is (robot_model_display.cpp)."""
        found = ""
        for name in sorted(self.links):
            if errors := self.links[name].errors:
                found += f"\n• for link '{name}':\n" + "\n".join(errors)
        return "Errors loading geometries:" + found if found else ""


MeshReader = Callable[[str], Any]
"""Returns the data of a mesh by its URI. Raises OSError or ValueError."""


def read_robot(text: str, read_mesh: MeshReader) -> RobotParts:
    """Read a description and load its meshes. Takes long: call it in a thread."""
    try:
        # Our own parser: the same robot as yourdfpy's, without the 20 MB and the half second that library takes.
        robot = parse_robot(text if "<" in text else f"<{text}", newest_urdf())
    except RobotError as error:
        return RobotParts(problem=str(error))
    if robot.loop:
        return RobotParts(problem=f"the links form a loop: {' -> '.join(robot.loop)}")
    parts = RobotParts(robot)
    turning = {joint.child for joint in robot.joints if joint.type == "continuous"}
    movable = {joint.child for joint in robot.joints if joint.type != "fixed"}
    for link in robot.links:
        parts.links[link.name] = _link_parts(link, link.name in turning, read_mesh)
        if link.inertial is not None and parts.links[link.name].inertia is None and link.name in movable:
            parts.log.append(
                f"The link {link.name} has unrealistic inertia, so the equivalent inertia box will not be shown.\n"
            )
    return parts


def _link_parts(link: Link, turns: bool, read_mesh: MeshReader) -> LinkParts:
    parts = LinkParts()
    for visual in link.visuals:
        colour = visual.material.color if visual.material is not None else None
        _add(parts.visual, visual.geometry, visual.origin, colour or RED, turns, read_mesh, parts.errors, colour)
    for collision in link.collisions:
        _add(parts.collision, collision.geometry, collision.origin, RED, turns, read_mesh, parts.errors, RED)
    if link.inertial is not None:
        parts.mass = _mass(link.inertial)
        parts.inertia = _inertia(link.inertial)
    return parts


def _add(
    into: list[RobotPart],
    geometry: Any,
    pose: Transform,
    colour: Colour,
    turns: bool,
    read_mesh: MeshReader,
    errors: list[str],
    given: Colour | None,
) -> None:
    part: RobotPart | None = None
    if isinstance(geometry, Box):
        part = RobotPart(BOX, pose, geometry.size, colour)
    elif isinstance(geometry, Sphere):
        part = RobotPart(SPHERE, pose, (2 * geometry.radius,) * 3, colour)
    elif isinstance(geometry, Cylinder):
        size = (2 * geometry.radius, 2 * geometry.radius, geometry.length)
        part = RobotPart(CYLINDER, pose, size, colour, turns)
    elif isinstance(geometry, Capsule):
        # RViz of Lyrical draws none (ros2/rviz#1734).
        width = 2 * geometry.radius
        for along in (-geometry.length / 2, geometry.length / 2):
            end = compose(pose, Transform((0.0, 0.0, along)))
            into.append(RobotPart(SPHERE, end, (width,) * 3, colour))
        part = RobotPart(CYLINDER, pose, (width, width, geometry.length), colour, turns)
    elif isinstance(geometry, Mesh) and geometry.filename:
        try:
            mesh = read_mesh(geometry.filename)
        except (OSError, ValueError, MemoryError):
            errors.append(f"Could not load mesh resource '{geometry.filename}'"[: MOST_MESH_TEXT - 1])
            return
        # A mesh without material in the URDF has its own colours, grey if it has none.
        part = RobotPart("mesh", pose, geometry.scale, given or (0.7, 0.7, 0.7, 1.0), turns, mesh)
    if part is not None and all(map(math.isfinite, (*part.size, *part.pose.xyz, *part.pose.rotation))):
        into.append(part)


def _mass(inertial: Inertial) -> RobotPart | None:
    if not math.isfinite(inertial.mass) or inertial.mass <= 0:
        return None
    diameter = 2 * (0.75 * inertial.mass / (math.pi * LEAD)) ** (1 / 3)
    return RobotPart(SPHERE, Transform(inertial.origin.xyz), (diameter,) * 3, RED)


def _inertia(inertial: Inertial) -> RobotPart | None:
    """The box of even density with this mass and inertia; None where there can be none."""
    import numpy as np

    ixx, ixy, ixz, iyy, iyz, izz = inertial.inertia
    if inertial.mass <= 0 or not all(map(math.isfinite, (inertial.mass, *inertial.inertia))):
        return None
    moments, turn = np.linalg.eigh(np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]))
    a, b, c = (float(moment) for moment in moments)
    squares = [6 / inertial.mass * each for each in (b + c - a, a + c - b, a + b - c)]
    if min(a, b, c) <= 0 or min(squares) <= 0:
        return None
    if np.linalg.det(turn) < 0:
        turn[:, 0] = -turn[:, 0]
    from day6_core.ros.programs.rviz2.model.turning import quaternion

    x, y, z = (square**0.5 for square in squares)
    place = compose(inertial.origin, Transform(IDENTITY.xyz, quaternion(turn.tolist())))
    return RobotPart(BOX, place, (x, y, z), RED)
