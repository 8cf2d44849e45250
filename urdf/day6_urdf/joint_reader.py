"""Reads <joint> with urdfdom 4.0.1's messages; the numbers are line numbers in its joint.cpp."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import TypeVar

from day6_urdf.diagnostics import WIDER_LIMITS, Diagnostics, Refused
from day6_urdf.model import JOINT_TYPES, Calibration, Dynamics, Joint, Limit, Mimic, Pose, Safety, Vector
from day6_urdf.values import ParseError, to_double, to_vector
from day6_urdf.xmlreader import Element

Part = TypeVar("Part")


def read_joint(element: Element, diagnostics: Diagnostics) -> Joint:
    """Return the joint.

    Raises:
        Refused: the joint is malformed, for which urdfdom refuses the robot.
    """
    name = element.attributes.get("name")
    if name is None:
        raise diagnostics.refuse("joint", 345, "unnamed joint found", element)
    origin = _read_origin(element, name, diagnostics)
    parent, child = _link_of(element.first("parent")), _link_of(element.first("child"))
    kind = element.attributes.get("type")
    if kind is None:
        raise diagnostics.refuse(
            "joint", 401, f"joint [{name}] has no type, check to see if it's a reference.", element
        )
    if kind not in JOINT_TYPES:
        raise diagnostics.refuse("joint", 420, f"Joint [{name}] has no known type [{kind}]", element)
    axis = _read_axis(element, name, diagnostics) if kind not in ("floating", "fixed") else (0.0, 0.0, 0.0)
    read_limit = partial(_read_limit, joint=name, kind=kind)
    limit = _part(element, "limit", read_limit, diagnostics, 454, f"Could not parse limit element for joint [{name}]")
    if limit is None and kind == "revolute":
        text = f"Joint [{name}] is of type REVOLUTE but it does not specify limits"
        raise diagnostics.refuse("joint", 461, text, element)
    if limit is None and kind == "prismatic":
        raise diagnostics.refuse("joint", 466, f"Joint [{name}] is of type PRISMATIC without limits", element)
    # The double spaces in two of these texts are urdfdom's.
    safety = _part(
        element,
        "safety_controller",
        _read_safety,
        diagnostics,
        477,
        f"Could not parse safety element for joint [{name}]",
    )
    calibration = _part(
        element,
        "calibration",
        _read_calibration,
        diagnostics,
        490,
        f"Could not parse calibration element for joint  [{name}]",
    )
    mimic = _part(element, "mimic", _read_mimic, diagnostics, 503, f"Could not parse mimic element for joint  [{name}]")
    dynamics = _part(
        element,
        "dynamics",
        _read_dynamics,
        diagnostics,
        516,
        f"Could not parse joint_dynamics element for joint [{name}]",
    )
    return Joint(name, kind, parent, child, origin, axis, limit, mimic, dynamics, safety, calibration)


def _read_origin(element: Element, name: str, diagnostics: Diagnostics) -> Pose:
    origin = element.first("origin")
    if origin is None:
        return Pose()
    try:
        return diagnostics.pose(origin)
    except Refused:
        raise diagnostics.refuse("joint", 362, f"Malformed parent origin element for joint [{name}]", origin) from None


def _link_of(element: Element | None) -> str:
    return "" if element is None else element.attributes.get("link", "")


def _read_axis(element: Element, name: str, diagnostics: Diagnostics) -> Vector:
    axis = element.first("axis")
    if axis is None:
        return 1.0, 0.0, 0.0
    text = axis.attributes.get("xyz")
    if text is None:
        return 0.0, 0.0, 0.0
    try:
        return to_vector(text)
    except ParseError as error:
        raise diagnostics.refuse("joint", 440, f"Malformed axis element for joint [{name}]: {error}", axis) from error


def _part(
    element: Element,
    tag: str,
    read: Callable[[Element, Diagnostics], Part],
    diagnostics: Diagnostics,
    source_line: int,
    text: str,
) -> Part | None:
    child = element.first(tag)
    if child is None:
        return None
    try:
        return read(child, diagnostics)
    except Refused:
        raise diagnostics.refuse("joint", source_line, text, child) from None


def _read_limit(element: Element, diagnostics: Diagnostics, joint: str, kind: str) -> Limit:
    wider = diagnostics.version >= WIDER_LIMITS
    whose = f"joint [{joint}]: " if diagnostics.newest >= WIDER_LIMITS else ""
    given = element.attributes
    lower = _number(element, "lower", 112, diagnostics, -math.inf if wider else 0.0, whose)
    upper = _number(element, "upper", 128, diagnostics, math.inf if wider else 0.0, whose)
    if wider and kind in ("revolute", "prismatic") and not {"lower", "upper"} <= given.keys():
        text = f"{whose}revolute and prismatic joints must have both lower and upper position limits specified"
        raise diagnostics.refuse("joint", 128, f"{text} in URDF version 1.2 or later", element)
    if wider and upper < lower:
        text = f"upper position limit ({upper:f}) cannot be smaller than lower position limit ({lower:f})"
        raise diagnostics.refuse("joint", 128, f"{whose}{text}", element)
    numbers = {}
    for name, missing_line, source_line in (("effort", 136, 144), ("velocity", 152, 160)):
        if name not in given and not wider:
            text = f"{whose}limit has no {name}" if whose else f"joint limit: no {name}"
            raise diagnostics.refuse("joint", missing_line, text, element)
        numbers[name] = _limit(element, name, source_line, diagnostics, math.inf, whose)
    farther: dict[str, float] = {}
    for name in ("acceleration", "deceleration", "jerk"):
        if name in given and not wider and whose:
            major, minor = diagnostics.version
            text = f"Required atleast URDF version 1.2, but the specified version is {major}.{minor}."
            diagnostics.warning("joint", 160, f"{whose}Ignoring {name} attribute. {text}", element)
        default = farther["acceleration"] if name == "deceleration" else math.inf
        farther[name] = _limit(element, name, 160, diagnostics, default, whose) if wider else math.inf
    return Limit(lower, upper, **numbers, **farther)


def _limit(
    element: Element, name: str, source_line: int, diagnostics: Diagnostics, default: float, whose: str
) -> float:
    """A limit that URDF 1.2 wants not to be negative."""
    value = _number(element, name, source_line, diagnostics, default, whose)
    if value < 0 and diagnostics.version >= WIDER_LIMITS:
        text = f"{whose}{name} value ({element.attributes[name]}) is negative"
        raise diagnostics.refuse("joint", source_line, text, element)
    return value


def _read_safety(element: Element, diagnostics: Diagnostics) -> Safety:
    lower = _number(element, "soft_lower_limit", 184, diagnostics)
    upper = _number(element, "soft_upper_limit", 201, diagnostics)
    k_position = _number(element, "k_position", 218, diagnostics)
    k_velocity = _required(element, "k_velocity", 234, diagnostics, 226, "joint safety: no k_velocity")
    return Safety(lower, upper, k_position, k_velocity)


def _read_calibration(element: Element, diagnostics: Diagnostics) -> Calibration:
    given = element.attributes
    rising = _number(element, "rising", 258, diagnostics) if "rising" in given else None
    return Calibration(rising, _number(element, "falling", 275, diagnostics) if "falling" in given else None)


def _read_mimic(element: Element, diagnostics: Diagnostics) -> Mimic:
    joint = element.attributes.get("joint")
    if joint is None:
        raise diagnostics.refuse("joint", 292, "joint mimic: no mimic joint specified", element)
    multiplier = _number(element, "multiplier", 311, diagnostics, 1.0)
    return Mimic(joint, multiplier, _number(element, "offset", 329, diagnostics))


def _read_dynamics(element: Element, diagnostics: Diagnostics) -> Dynamics:
    damping = _number(element, "damping", 65, diagnostics)
    friction = _number(element, "friction", 81, diagnostics)
    if "damping" not in element.attributes and "friction" not in element.attributes:
        raise diagnostics.refuse(
            "joint", 88, "joint dynamics element specified with no damping and no friction", element
        )
    return Dynamics(damping, friction)


def _number(
    element: Element, name: str, source_line: int, diagnostics: Diagnostics, default: float = 0.0, whose: str = ""
) -> float:
    text = element.attributes.get(name)
    if text is None:
        return default
    try:
        return to_double(text)
    except ParseError as error:
        raise diagnostics.refuse(
            "joint", source_line, f"{whose}{name} value ({text}) is not a valid float", element
        ) from error


def _required(
    element: Element, name: str, source_line: int, diagnostics: Diagnostics, missing_line: int, missing: str
) -> float:
    if name not in element.attributes:
        raise diagnostics.refuse("joint", missing_line, missing, element)
    return _number(element, name, source_line, diagnostics)
