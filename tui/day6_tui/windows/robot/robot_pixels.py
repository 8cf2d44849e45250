"""A robot from above on a surface of real pixels: bodies, axles, and wheels whose treads run with their angle."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

from day6_tui.pixels.raster import Surface
from day6_tui.windows.world.picture import FIRM, FIRST_TREAD, TREAD, WHEEL, bodies_of
from day6_urdf.kinematics import Transform
from day6_urdf.topplan import Body, TopPlan, Wheel, flat, hull, spin_of, stand
from day6_urdf.topview import tread_marks

TREAD_PIXELS = 3.0
"""Across one mark of a tread."""

Spot = tuple[float, float]


def paint_robot(
    surface: Surface,
    plan: TopPlan,
    given: Mapping[str, Transform],
    place: Callable[[Spot], Spot],
    scale: float,
    colours: Sequence[int],
) -> None:
    """Draw the given transforms of the links; `place` turns metres of the root frame into pixels, `scale` of them a metre.

    A link without a transform is at its rest pose, in the colour of what is wrong. `colours` are by the kinds of `world_picture`.
    """
    at = {**plan.rest, **given}

    def colour_of(link: str, kind: int) -> int:
        return colours[kind if link in given or link == plan.robot.root else FIRM]

    for body, kind in bodies_of(plan):
        _paint_body(surface, body, at, place, scale, colour_of(body.link, kind))
    for wheel in plan.wheels:
        _paint_wheel(surface, wheel, at, place, scale, colours, colour_of(wheel.joint.child, WHEEL))


def darker(colour: int) -> int:
    """The colour of an outline."""
    return sum(int((colour >> shift & 255) * 0.6) << shift for shift in (0, 8, 16))


def _paint_body(
    surface: Surface, body: Body, at: Mapping[str, Transform], place: Callable[[Spot], Spot], scale: float, colour: int
) -> None:
    spots = [flat(at[body.link], point) for point in body.points]
    if len(spots) == 1:
        x, y = place(spots[0])
        radius = max(2.0, body.radius * scale)
        surface.disc(x, y, radius, darker(colour))
        surface.disc(x, y, radius - 1.5, colour)
    else:
        surface.polygon([place(spot) for spot in hull(spots)], colour, darker(colour), 1.5)


def _paint_wheel(
    surface: Surface,
    wheel: Wheel,
    at: Mapping[str, Transform],
    place: Callable[[Spot], Spot],
    scale: float,
    colours: Sequence[int],
    colour: int,
) -> None:
    (x, y), (hx, hy) = stand(wheel, at)
    half = wheel.width / 2

    def strip(start: float, end: float, side: float) -> list[Spot]:
        """A part of the wheel, between two distances along it from its centre."""
        corners = ((start, -side), (end, -side), (end, side), (start, side))
        return [place((x + hx * a - hy * b, y + hy * a + hx * b)) for a, b in corners]

    if wheel.ball:
        surface.disc(*place((x, y)), wheel.radius * scale, colour)
    else:
        surface.polygon(strip(-wheel.radius, wheel.radius, half), colour, darker(colour), 1.5)
    pixel = 1 / scale
    if wheel.radius < 4 * pixel:
        return
    for along, first in reversed(tread_marks(wheel.radius, spin_of(wheel, at), TREAD_PIXELS * pixel)):
        # A mark near the rim is seen from the side.
        thick = TREAD_PIXELS * pixel / 2 * max(0.3, math.sqrt(max(0.0, 1 - (along / wheel.radius) ** 2)))
        ends = max(-wheel.radius, along - thick), min(wheel.radius, along + thick)
        surface.polygon(strip(*ends, half * 0.86), colours[FIRST_TREAD if first else TREAD])
