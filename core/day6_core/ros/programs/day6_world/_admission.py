"""Which robots may enter the world: what a description needs before physics can move it, and what it lacks."""

from __future__ import annotations

import math
from dataclasses import fields, is_dataclass
from typing import Any

from day6_core.ros.programs.day6_world._drive import Drive
from day6_core.ros.programs.remark import Remark
from day6_urdf.model import Limit, Robot


class AdmissionStatus(Remark):
    """One line below the world."""


status = AdmissionStatus.of


def refusals(robot: Robot, drive: Drive | None) -> list[AdmissionStatus]:
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


def warnings(robot: Robot, drive: Drive) -> list[AdmissionStatus]:
    """Return the warnings about a robot that may enter."""
    found = []
    loose = [robot.joint(wheel.joint).child for wheel in drive.wheels if not wheel.grips]
    if loose:
        found.append(status("warning", "world.wheels_without_collision", links=", ".join(loose)))
    ghosts = [link.name for link in robot.links if link.visuals and not link.collisions and link.name not in loose]
    if ghosts:
        found.append(status("warning", "world.no_collision", links=", ".join(ghosts)))
    return found


def _finite(part: Any) -> bool:
    """Whether all numbers of a link or joint are finite; a limit that was left out is not (URDF 1.2)."""
    if isinstance(part, Limit):
        return not any(math.isnan(getattr(part, item.name)) for item in fields(part))
    if isinstance(part, float):
        return math.isfinite(part)
    if isinstance(part, tuple):
        return all(_finite(item) for item in part)
    if is_dataclass(part):
        return all(_finite(getattr(part, item.name)) for item in fields(part))
    return True
