"""Draws a robot from above with anything that can fill polygons and discs; every kind of pixels shows the same robot.

A wheel has an outline that never moves. Inside it the tread runs with the joint's angle, and one bright mark, the valve, goes
round: over the top and forwards while the angle grows, hidden below for the other half of a turn. The mark draws a tail as long
as the way it came in `PERSISTENCE` seconds, so a still picture shows which way a wheel turns and how fast. Where the tread
would go so far from one picture to the next that it seemed to stand, or to run backwards, it is blurred.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from day6_urdf.kinematics import Transform
from day6_urdf.topview.frame import Spot, TopFrame, Tyre
from day6_urdf.topview.plan import Body, TopPlan, flat, hull, spin_of

PERSISTENCE = 0.15
"""Seconds that the eye keeps the mark in sight."""

BLUR = 0.4
"""Part of the way from one bar of the tread to the next, gone between two pictures, from which the tread is a blur."""

BAR_DOTS = 3.0
"""Least distance of two bars of a tread."""


@dataclass(frozen=True)
class TopColours:
    """0xRRGGBB by what is drawn; `background` may be -1, the terminal's own. Bodies and tyres have the URDF's colours, if any."""

    dark: bool
    background: int
    body: int
    tyre: int
    tread: int
    mark: int
    caster: int
    axle: int
    arrow: int
    lamp: int
    missing: int


DARK = TopColours(
    True, 0x12161D, 0x4C6FE8, 0x4A4F58, 0x8A919C, 0xF0B429, 0xB9BEC6, 0x8C939E, 0x3FC9A0, 0xFFFFFF, 0xFF6A4D
)
LIGHT = TopColours(
    False, 0xFAFBFC, 0x2F55D4, 0x2B3038, 0x777E8A, 0xFFA000, 0xD0D3D8, 0x3A3F46, 0x00906A, 0xFFD966, 0xD23A1A
)


class Painter(Protocol):
    """Something that can be drawn on; points are metres in the root frame, colours 0xRRGGBB, and `edge` -1 is none."""

    def polygon(self, points: Sequence[Spot], fill: int, edge: int = -1) -> None:
        """Fill a convex polygon."""

    def disc(self, spot: Spot, radius: float, fill: int, edge: int = -1) -> None:
        """Fill a circle."""


class Turning(NamedTuple):
    """How fast wheels turn, rad/s by link, and the seconds between two pictures."""

    speeds: Mapping[str, float] = {}
    gap: float = 0.05


STANDING = Turning()


def paint_top(
    painter: Painter, frame: TopFrame, given: Mapping[str, Transform], colours: TopColours, turning: Turning
) -> None:
    """Draw the given transforms of the links (root frame); a link without one is at its rest pose, as missing."""
    plan = frame.plan
    at = {**plan.rest, **given}
    tyres = frame.tyres(at)
    shafts = [(one, two) for one, two, _ in axles(tyres) if one.straight and two.straight]
    for one, two in shafts:
        _paint_axle(painter, frame, (one.x, one.y), two.y, colours.axle)
    paint_bodies(painter, plan, at, given, colours)
    if plan.wheels:
        for body in plan.bodies:
            if body.style == "chassis" and len(body.points) > 1:
                _paint_front_and_rear(painter, frame, body, at, colours)
                within = [flat(at[body.link], point)[1] for point in body.points]
                through = mixed(body_colour(body, colours), colours.axle, 0.35)
                for one, two in shafts:
                    low, high = sorted((one.y, two.y))
                    _paint_axle(painter, frame, (one.x, max(low, min(within))), min(high, max(within)), through)
                break
    paint_casters(painter, plan, at, given, colours, 1.2 / frame.metre)
    for tyre in tyres:
        paint_tyre(painter, tyre, spin_of(tyre.wheel, at), (1 / frame.metre, 1 / frame.down), given, colours, turning)
    _paint_arrow(painter, frame, colours)


def is_known(plan: TopPlan, link: str, given: Mapping[str, Transform]) -> bool:
    """Whether it is known where a link is."""
    return link in given or link == plan.robot.root


# -- bodies ------------------------------------------------------------------------------------------------------------


def paint_bodies(
    painter: Painter,
    plan: TopPlan,
    at: Mapping[str, Transform],
    given: Mapping[str, Transform],
    colours: TopColours,
) -> None:
    """Draw everything but wheels and casters."""
    for body in plan.bodies:
        if body.style == "caster":
            continue
        fill = body_colour(body, colours) if is_known(plan, body.link, given) else colours.missing
        spots = [flat(at[body.link], point) for point in body.points]
        if len(spots) == 1:
            painter.disc(spots[0], body.radius, fill, edge_of(fill, colours))
        else:
            painter.polygon(hull(spots), fill, edge_of(fill, colours))


def body_colour(body: Body, colours: TopColours) -> int:
    """The URDF's colour, lighter or darker if it could not be told from the background."""
    return _visible(body.colour, colours) if body.colour >= 0 else colours.body


def edge_of(colour: int, colours: TopColours) -> int:
    """The colour of an outline: towards the light on dark ground, into the dark on light ground."""
    return mixed(colour, 0xFFFFFF if colours.dark else 0x000000, 0.35)


def _paint_front_and_rear(
    painter: Painter, frame: TopFrame, body: Body, at: Mapping[str, Transform], colours: TopColours
) -> None:
    """A deck over the rear of a car and two lamps in front: which end is which is seen without reading."""
    outline = hull([flat(at[body.link], point) for point in body.points])
    left, right = min(x for x, _ in outline), max(x for x, _ in outline)
    low, high = min(y for _, y in outline), max(y for _, y in outline)
    long, wide = right - left, high - low
    if len(outline) != 4 or any(min(x - left, right - x) > 0.02 * long for x, _ in outline):
        return  # a slanted or round body has no corners to put lamps in
    fill = body_colour(body, colours)
    dot, row = 1 / frame.metre, 1 / frame.down
    if long > 12 * dot and wide > 8 * row:
        deck = mixed(fill, 0x000000, 0.25) if colours.dark else mixed(fill, 0xFFFFFF, 0.25)
        inset = max(2 * row, wide * 0.1)
        start = left + max(2 * dot, long * 0.08)
        painter.polygon(_box(start, low + inset, left + long * 0.4, high - inset), deck, deck)
    deep, broad = max(2 * dot, long * 0.05), max(2 * row, wide * 0.16)
    if long > 8 * dot and wide > 6 * row:
        painter.polygon(_box(right - deep, high - broad, right, high), colours.lamp)
        painter.polygon(_box(right - deep, low, right, low + broad), colours.lamp)


def paint_casters(
    painter: Painter,
    plan: TopPlan,
    at: Mapping[str, Transform],
    given: Mapping[str, Transform],
    colours: TopColours,
    least: float = 0.0,
) -> None:
    """Draw the balls below the body, seen through it, with a radius of `least` metres or more."""
    ground = max((body.colour for body in plan.bodies if body.style == "chassis"), default=-1)
    for body in plan.bodies:
        if body.style == "caster":
            own = body.colour if body.colour >= 0 and _distance(body.colour, ground) > 90 else colours.caster
            fill = own if is_known(plan, body.link, given) else colours.missing
            painter.disc(flat(at[body.link], body.points[0]), max(body.radius, least), fill)


def _box(left: float, low: float, right: float, high: float) -> list[Spot]:
    return [(left, low), (right, low), (right, high), (left, high)]


# -- wheels ------------------------------------------------------------------------------------------------------------


def paint_tyre(
    painter: Painter,
    tyre: Tyre,
    spin: float,
    dot: tuple[float, float],
    given: Mapping[str, Transform],
    colours: TopColours,
    turning: Turning,
) -> None:
    """Draw a wheel turned by `spin` radians; `dot` is the size of a dot along the wheel and across it, in metres."""
    long, deep = dot
    link, half, thickness = tyre.wheel.joint.child, tyre.half_length, 2 * tyre.half_width / deep
    base = _visible(tyre.wheel.colour, colours) if tyre.wheel.colour >= 0 else colours.tyre
    if link not in given:
        base = colours.missing
    speed = turning.speeds.get(link, 0.0)
    marks = tread_marks(half, spin, long)
    blurred = abs(speed) * turning.gap > BLUR * 2 * math.pi / bars_of(half, long)
    tread = colours.tread if _distance(base, colours.tread) > 60 else mixed(base, 0xFFFFFF, 0.4)
    if blurred and link in given:
        base = mixed(base, tread, 0.3)
    wall = mixed(base, colours.tread, 0.45) if colours.dark else mixed(base, 0x000000, 0.5)
    if tyre.wheel.ball:
        painter.disc((tyre.x, tyre.y), half, base, wall)
    else:
        painter.polygon(tyre.strip(-half, half), base, wall)
    if link not in given or half < 1.5 * long:
        return
    inside = 1.0 if thickness < 4.5 else 1 - 2.2 / thickness
    if not blurred:
        for along, first in marks:
            if not first:
                width = _seen_width(along, half, long) / 2
                painter.polygon(_within(tyre, along - width, along + width, inside), tread)
    for start, end in tail(half, spin, speed):
        painter.polygon(_within(tyre, start, end, inside), mixed(base, colours.mark, 0.45))
    for along, first in marks:
        if first:
            width = max(2 * _seen_width(along, half, long), 2 * long, half * 0.22) / 2
            painter.polygon(_within(tyre, along - width, along + width, inside), colours.mark)


def _within(tyre: Tyre, start: float, end: float, share: float) -> list[Spot]:
    half = tyre.half_length
    if end - start < 2 * half:  # moved rather than cut: a mark at the rim stays as wide as it is
        push = max(-half - start, 0.0) + min(half - end, 0.0)
        start, end = start + push, end + push
    return tyre.strip(max(start, -half), min(end, half), share * (0.6 if tyre.wheel.ball else 1.0))


def _seen_width(along: float, half: float, dot: float) -> float:
    """How wide a bar of the tread looks: near the rim it is seen from the side."""
    return max(dot, half * 0.11 * math.sqrt(max(0.0, 1 - (along / half) ** 2)))


def bars_of(half: float, dot: float) -> int:
    """How many bars the tread of a wheel has, of which half are above: 6 to 12, as many as can be told apart."""
    return min(max(int(2 * math.pi * half / (BAR_DOTS * dot)), 6), 12) if dot > 0 else 6


def tread_marks(half: float, spin: float, dot: float) -> list[tuple[float, bool]]:
    """Return the bars on the upper half of a wheel: metres along it from its centre, and True for the mark.

    `half` is half the wheel's length and `dot` the size of a dot, both in metres; `spin` is the joint's angle.
    """
    count = bars_of(half, dot)
    marks = []
    for number in range(count):
        angle = math.remainder(2 * math.pi * number / count + spin, 2 * math.pi)
        if abs(angle) < math.pi / 2:
            marks.append((half * math.sin(angle), number == 0))
    return sorted(marks, key=lambda mark: not mark[1])


def tail(half: float, spin: float, speed: float) -> Iterator[tuple[float, float]]:
    """Yield what is seen of the way the mark came in the last moment: from and to, metres along the wheel from its centre."""
    way = math.copysign(min(abs(speed) * PERSISTENCE, 1.9 * math.pi), speed)
    low, high = sorted((spin - way, spin))
    for turn in (-2 * math.pi, 0.0, 2 * math.pi):
        start, end = max(low + turn, -math.pi / 2), min(high + turn, math.pi / 2)
        if end - start > 0.05:
            yield half * math.sin(start), half * math.sin(end)


# -- axles and the arrow -----------------------------------------------------------------------------------------------


def axles(tyres: Sequence[Tyre]) -> Iterator[tuple[Tyre, Tyre, float]]:
    """Yield the pairs of wheels that share an axis, with the distance of their centres in life (metres)."""
    for number, one in enumerate(tyres):
        for two in tyres[number + 1 :]:
            if one.wheel.joint.parent != two.wheel.joint.parent:
                continue
            heading, other, reach = one.heading, two.heading, (two.x - one.x, two.y - one.y)
            across = math.hypot(*reach)
            alike = abs(heading[0] * other[0] + heading[1] * other[1]) > 0.98
            if alike and abs(reach[0] * heading[0] + reach[1] * heading[1]) < 0.05 * across:
                a, b = one.wheel.joint.origin.xyz, two.wheel.joint.origin.xyz
                yield one, two, math.dist(a, b)


def _paint_axle(painter: Painter, frame: TopFrame, start: Spot, end: float, colour: int) -> None:
    """A shaft along y from a point to the height `end`."""
    half = max(1.0, round(0.006 * frame.metre)) / frame.metre / 2
    low, high = sorted((start[1], end))
    painter.polygon(_box(start[0] - half, low, start[0] + half, high), colour)


def _paint_arrow(painter: Painter, frame: TopFrame, colours: TopColours) -> None:
    """An arrow in front, on the line through the root's origin, of whole dots."""
    dot, row = 1 / frame.metre, 1 / frame.down
    x, _ = frame.place((frame.front, 0.0))
    start = frame.front + (math.ceil(x) - x + max(1, frame.dots[0] // 2)) * dot
    long = 5 * frame.dots[0] * dot
    upright = frame.squash > 1.5  # two such dots would be too thick
    middle, thick = (row / 2, row / 2) if upright else (0.0, max(1, round(0.02 * frame.height)) * row)
    wide = thick + max(row, thick)
    neck = start + long - min(math.ceil(1.5 * wide / dot), long / dot * 0.7) * dot
    painter.polygon(_box(start, middle - thick, neck, middle + thick), colours.arrow)
    painter.polygon([(neck, middle - wide), (start + long, middle), (neck, middle + wide)], colours.arrow)


# -- colours -----------------------------------------------------------------------------------------------------------


def mixed(colour: int, other: int, share: float) -> int:
    """A colour with `share` of another."""
    parts = (
        round((colour >> shift & 255) * (1 - share) + (other >> shift & 255) * share) << shift for shift in (0, 8, 16)
    )
    return sum(parts)


def contrasting(colour: int) -> int:
    """White or black, whichever is read on it."""
    return 0x000000 if _light(colour) > 140 else 0xFFFFFF


def _visible(colour: int, colours: TopColours) -> int:
    ground = colours.background if colours.background >= 0 else (0x000000 if colours.dark else 0xFFFFFF)
    aim = 0xFFFFFF if colours.dark else 0x000000
    for share in (0.0, 0.12, 0.24, 0.36):
        seen = mixed(colour, aim, share)
        if abs(_light(seen) - _light(ground)) > 45:
            return seen
    return seen


def _light(colour: int) -> float:
    """How light a colour is, 0 to 255 (Rec. 601)."""
    return 0.299 * (colour >> 16 & 255) + 0.587 * (colour >> 8 & 255) + 0.114 * (colour & 255)


def _distance(one: int, two: int) -> int:
    if min(one, two) < 0:
        return 765
    return sum(abs((one >> shift & 255) - (two >> shift & 255)) for shift in (0, 8, 16))
