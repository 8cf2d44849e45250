"""The joints of an SDF model and of COLLADA kinematics, which the original reads beside URDF."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from day6_core.plain_xml import plain_xml

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_SDF_WITHOUT = ("gearbox", "revolute2", "ball", "screw", "universal", "fixed")
"""Joints of SDF that have no position to publish (joint_state_publisher.py: init_sdf)."""


class DescriptionError(Exception):
    """A description or parameter that cannot be used, in the original's words."""


class OtherJoint(NamedTuple):
    """A joint with its limits in radians or metres."""

    name: str
    kind: str
    minimum: float
    maximum: float


def limit_value(text: str | None, side: str, name: str, kind: str) -> float:
    """Return a limit. Raises DescriptionError for one that is missing or isn't a number."""
    if text is None:
        raise DescriptionError(f'"{side}" limit must be specified for joint "{name}" of type "{kind}"')
    try:
        return float(text)
    except ValueError as error:
        raise DescriptionError(f'"{side}" limit must be a float for joint "{name}" of type "{kind}"') from error


def missing_limits(name: str, kind: str) -> DescriptionError:
    """Return the error for a joint without limits."""
    return DescriptionError(f'Limits must be specified for joint "{name}" of type "{kind}"')


def read_sdf(text: str) -> Iterator[OtherJoint]:
    """Yield the joints of the first model. Raises DescriptionError."""
    model = _first(_root(text), "model")
    if model is None:
        raise DescriptionError('SDF must have a "model" tag')
    for joint in _children(model, "joint"):
        name, kind = joint.get("name", ""), joint.get("type", "")
        if kind in _SDF_WITHOUT:
            continue
        if kind == "continuous":
            yield OtherJoint(name, kind, -math.pi, math.pi)
        else:
            yield OtherJoint(name, kind, *_limits(_first(joint, "limit"), ("lower", "upper"), name, kind))


def read_collada(text: str) -> Iterator[OtherJoint]:
    """Yield the joints that turn, of the first kinematics model. Raises DescriptionError."""
    root = _root(text)
    version = root.get("version")
    if version is None:
        raise DescriptionError("COLLADA must have a version tag")
    if [int(part) for part in version.split(".") if part.isdecimal()] < [1, 5]:
        raise DescriptionError("COLLADA must be at least version 1.5.0")
    found = root
    for tag in ("kinematics_model", "technique_common"):
        inner = _first(found, tag)
        if inner is None:
            raise DescriptionError(f'COLLADA must have a "{tag}" tag')
        found = inner
    for joint in _children(found, "joint"):
        turning = _first(joint, "revolute")
        if turning is None:
            continue
        name = joint.get("name", "")
        minimum, maximum = _limits(_first(turning, "limits"), ("min", "max"), name, "revolute")
        if minimum != maximum:  # a joint that can't turn is a fixed one
            yield OtherJoint(name, "revolute", math.radians(minimum), math.radians(maximum))


def _root(text: str) -> Element:
    try:
        return plain_xml(text.encode("utf-8", "replace"))
    except ValueError as error:
        raise DescriptionError(str(error)) from error


def _limits(limits: Element | None, sides: tuple[str, str], name: str, kind: str) -> tuple[float, float]:
    if limits is None:
        raise missing_limits(name, kind)
    found = [_first(limits, side) for side in sides]
    low, high = (
        limit_value(None if each is None else each.text or "", side, name, kind)
        for each, side in zip(found, sides, strict=True)
    )
    return low, high


def _tag(element: Element) -> str:
    return element.tag.rpartition("}")[2]  # without its namespace


def _children(element: Element, tag: str) -> list[Element]:
    return [child for child in element if _tag(child) == tag]


def _first(element: Element, tag: str) -> Element | None:
    return next((each for each in element.iter() if each is not element and _tag(each) == tag), None)
