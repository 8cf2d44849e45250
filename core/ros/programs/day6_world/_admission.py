"""Who may enter the world: what a robot's description has to say before physics can move it, and what it lacks."""

from __future__ import annotations

import math
from dataclasses import fields, is_dataclass
from typing import Any

from day6_tui.core.ros.programs._remark import Remark
from day6_tui.core.ros.programs.day6_world._drive import Drive
from day6_tui.urdf.model import Robot

TEXTS = {
    "world.waiting_for_robot": "the world is empty: nobody has published /robot_description yet",
    "world.refused": "{robot} may not enter this world:",
    "world.bad_description": "the robot description is broken: {text}",
    "world.left_away": "parts of the robot could not be read: {text}",
    "world.no_inertial": "{links}: no <inertial>. What has no mass cannot be moved by forces; it would be a ghost",
    "world.bad_mass": "{link}: a mass of {mass} kg is none",
    "world.bad_inertia": "{link}: the inertia is not greater than 0 about every axis",
    "world.bad_number": "{link}: a size or place is no number",
    "world.no_drive": "no two wheels, left and right, that could drive it",
    "world.stands_in_wall": "at ({x:.2f}, {y:.2f}) it would stand in a wall",
    "world.no_collision": "{links}: no <collision>. They go through walls like ghosts",
    "world.wheels_without_collision": "{links}: wheels without <collision> do not touch the floor. They turn and push nothing",
    "world.nobody_drives": "nobody publishes {topic}: ros2 run teleop_twist_keyboard teleop_twist_keyboard drives",
    "world.keeps_going": "nobody publishes {topic} any more: the last order goes on until another one comes",
    "world.wrong_type": "{topic} has type {type}, this world hears {wanted}: start it with stamped:={stamped}",
    "world.two_joint_states": (
        "{nodes} publishes {topic} as well. That topic tells where wheels are, it is no order; so nothing rolls. With "
        "-r joint_states:=joint_commands it becomes one"
    ),
    "world.bumped": "it touches a wall: the wheels slip, and /odom does not notice",
    "world.sideways": "linear.y is ignored: two wheels cannot go sideways",
}
"""English texts by id; names of links, topics and types stand in the parameters as they are."""


class Status(Remark):
    """One line below the world."""

    TEXTS = TEXTS


status = Status.of


def refusals(robot: Robot, drive: Drive | None) -> list[Status]:
    """Return why a robot may not enter; empty if it may.

    A link with nothing to see and nothing to touch is only a frame and needs no mass (as a base_footprint).
    """
    found = []
    bodies = [link for link in robot.links if link.visuals or link.collisions]
    massless = [link.name for link in bodies if link.inertial is None]
    if massless:
        found.append(status("error", "world.no_inertial", links=", ".join(massless)))
    for link in bodies:
        inertial = link.inertial
        if inertial is None:
            continue
        if not inertial.mass > 0 or not math.isfinite(inertial.mass):
            found.append(status("error", "world.bad_mass", link=link.name, mass=f"{inertial.mass:g}"))
        elif not min(inertial.inertia[0], inertial.inertia[3], inertial.inertia[5]) > 0:
            found.append(status("error", "world.bad_inertia", link=link.name))
    found += [status("error", "world.bad_number", link=link.name) for link in robot.links if not _finite(link)]
    found += [status("error", "world.bad_number", link=joint.name) for joint in robot.joints if not _finite(joint)]
    if drive is None:
        found.append(status("error", "world.no_drive"))
    return found


def warnings(robot: Robot, drive: Drive) -> list[Status]:
    """Return what a robot that may enter lacks."""
    found = []
    loose = [robot.joint(wheel.joint).child for wheel in drive.wheels if not wheel.grips]
    if loose:
        found.append(status("warning", "world.wheels_without_collision", links=", ".join(loose)))
    ghosts = [link.name for link in robot.links if link.visuals and not link.collisions and link.name not in loose]
    if ghosts:
        found.append(status("warning", "world.no_collision", links=", ".join(ghosts)))
    return found


def _finite(part: Any) -> bool:
    """Say whether all numbers of a link or joint are finite."""
    if isinstance(part, float):
        return math.isfinite(part)
    if isinstance(part, tuple):
        return all(_finite(item) for item in part)
    if is_dataclass(part):
        return all(_finite(getattr(part, item.name)) for item in fields(part))
    return True
