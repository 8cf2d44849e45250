"""Advice about valid descriptions: beginners' mistakes that parsers accept.

Only near-certain mistakes are named, so that a good robot gets no advice.
"""

from __future__ import annotations

import math
import re

from day6_urdf.explain import Hint
from day6_urdf.kinematics import compose, link_transforms, rotate
from day6_urdf.model import Box, Cylinder, Joint, Link, Robot
from day6_urdf.xmlreader import Lines

_UNEVEN = 0.05
"""Part of a wheel's radius by which two wheels may differ in height."""

_BELOW = 0.2
"""Part of a wheel's radius by which a body may reach below the wheels: less is often only the drawing."""

_TEXTS = {
    "tumbles": (
        (
            "wheel {link} does not turn about its cylinder's axis, so it tumbles. A cylinder stands upright (z); "
            'rpy="1.5707963 0 0" in the origin of its <visual> lays it down for <axis xyz="0 1 0"/>'
        ),
        (
            "轮子 {link} 转的轴和圆柱的轴不是同一根，转起来会乱晃。圆柱本来是竖着的（z 轴）；"
            '在 <visual> 的 origin 里写 rpy="1.5707963 0 0"，它就躺下来，配合 <axis xyz="0 1 0"/>'
        ),
    ),
    "no_axis": (
        "joint {joint} has no axis to turn about: 0 0 0 is not a direction",
        "关节 {joint} 没有转轴：0 0 0 不是一个方向",
    ),
    "stuck": (
        "joint {joint} can only move from {low:g} to {low:g}, so it cannot move. Wheels need the type continuous",
        "关节 {joint} 只能从 {low:g} 动到 {low:g}，也就是动不了。轮子应该用 continuous 类型",
    ),
}


def advice_of(robot: Robot, text: str, language: str = "en") -> Hint | None:
    """Return the first piece of advice about an accepted robot, None if there is none."""
    for joint in robot.joints:
        key = _mistake(joint, robot.link(joint.child))
        if key:
            low = joint.limit.lower if joint.limit is not None else 0.0
            advice = _TEXTS[key][1 if language == "zh" else 0].format(joint=joint.name, link=joint.child, low=low)
            return Hint(*_place(text, joint.name), advice)
    return None


def first_mistake(robot: Robot) -> tuple[str, Joint] | None:
    """Return the key of the first mistake ('tumbles', 'no_axis', 'stuck') and its joint, None if there is none."""
    return next(((key, joint) for joint in robot.joints if (key := _mistake(joint, robot.link(joint.child)))), None)


def uneven_wheels(robot: Robot) -> tuple[tuple[str, ...], float] | None:
    """Return wheels of one size that do not stand on one floor, and by how much (metres); None if all do."""
    bottoms = _bottoms(robot)
    if len(bottoms) < 2 or len({round(radius, 4) for radius, _ in bottoms.values()}) > 1:
        return None
    heights = [bottom for _, bottom in bottoms.values()]
    difference = max(heights) - min(heights)
    smallest = min(radius for radius, _ in bottoms.values())
    return (tuple(bottoms), difference) if difference > _UNEVEN * smallest else None


def low_body(robot: Robot) -> tuple[str, tuple[str, ...], float] | None:
    """Return a link that reaches below all wheels, the wheels, and by how much (metres); None if there is none."""
    bottoms = _bottoms(robot)
    if len(bottoms) < 2:
        return None
    floor = min(bottom for _, bottom in bottoms.values())
    places = link_transforms(robot, {})
    radius = min(radius for radius, _ in bottoms.values())
    for link in robot.links:
        for visual in link.visuals if link.name not in bottoms else ():
            shape = visual.geometry
            if isinstance(shape, Box):
                place = compose(places[link.name], visual.origin)
                reach = sum(abs(rotate(place.rotation, axis)[2]) / 2 for axis in _edges(shape))
                below = floor - (place.xyz[2] - reach)
                if below > _BELOW * radius:
                    return link.name, tuple(bottoms), below
    return None


def _edges(box: Box) -> tuple[tuple[float, float, float], ...]:
    x, y, z = box.size
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


def _bottoms(robot: Robot) -> dict[str, tuple[float, float]]:
    """Return the links that look like wheels on horizontal axes: radius and lowest point (metres)."""
    places = link_transforms(robot, {})
    found = {}
    for joint in robot.joints:
        child = robot.link(joint.child)
        if joint.type != "continuous" or _disc(child) is None or not math.hypot(*joint.axis):
            continue
        place = places[joint.child]
        if abs(rotate(place.rotation, joint.axis)[2]) > 0.1 * math.hypot(*joint.axis):
            continue
        visual = child.visuals[0]
        assert isinstance(visual.geometry, Cylinder)
        radius = visual.geometry.radius
        found[joint.child] = radius, compose(place, visual.origin).xyz[2] - radius
    return found


def _mistake(joint: Joint, child: Link) -> str:
    """Return the key of the joint's mistake in `_TEXTS`, empty if it looks right."""
    if joint.type not in ("continuous", "revolute"):
        return ""
    length = math.hypot(*joint.axis)
    if length == 0:
        return "no_axis"
    wheel = _disc(child)
    if wheel is None:
        return ""
    if abs(sum(a * b for a, b in zip(wheel, joint.axis, strict=True))) < 0.5 * length:
        return "tumbles"
    if joint.type == "revolute" and joint.limit is not None and joint.limit.lower == joint.limit.upper:
        return "stuck"
    return ""


def _disc(link: Link) -> tuple[float, float, float] | None:
    """Return the axis of a link that is a single flat cylinder around its own origin, like a wheel."""
    if len(link.visuals) != 1:
        return None
    visual = link.visuals[0]
    shape = visual.geometry
    if (
        not isinstance(shape, Cylinder)
        or shape.length > 2 * shape.radius
        or math.hypot(*visual.origin.xyz) > shape.radius / 2
    ):
        return None
    return rotate(visual.origin.rotation, (0.0, 0.0, 1.0))


def _place(text: str, joint: str) -> tuple[int, int]:
    match = re.search(rf"<joint\s[^>]*name\s*=\s*[\"']{re.escape(joint)}[\"']", text)
    return Lines(text).at(match.start()) if match is not None else (0, 0)
