"""The check of what a turtle has drawn: straight lines, their lengths and the angles between them.

It judges the trail, not the way it was made: by keys, by `ros2 topic pub`, by a program.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.texts import Say

if TYPE_CHECKING:
    from collections.abc import Sequence

    from day6_core.lessons.live import Live

Point = tuple[float, float]


class Shape(NamedTuple):
    """So many straight lines of one length, with a turn of so many degrees after each."""

    sides: int
    turn: float


SHAPES = {"pentagram": Shape(5, 144.0), "square": Shape(4, 90.0), "triangle": Shape(3, 120.0)}
OTHERS = ("circle", "closed")

STRAIGHT = 6.0
"""Degrees by which a line may bend and still be straight."""

TURN_SLACK = 9.0
"""Degrees by which a turn may be wrong."""

LENGTH_SLACK = 0.15
"""Part of their mean by which lengths may differ, and by which the ends may miss each other."""

SHORTEST = 0.3
"""Metres below which a straight line is a slip."""

MOST_POINTS = 20_000


@check("trail", one_of={"shape": (*SHAPES, *OTHERS)})
def trail(live: Live, shape: str = "pentagram", turtle: str = "turtle1") -> Verdict:
    wanted = Say("trail", turtle=turtle, shape=Say(f"shape.{shape}"))
    windows = live.windows("turtlesim")
    if not windows:
        return Verdict(False, wanted, Say("trail.saw_none"))
    simulation: Any = windows[-1].model
    points = _lines(simulation, live.remembered)
    return judged(points, shape, wanted)


def _lines(simulation: Any, memory: dict[str, Any]) -> list[list[Point]]:
    """The trail as strokes of points (metres), from what was drawn since the last `clear`."""
    from day6_core.ros.programs.turtlesim.model import PIXELS_PER_METRE

    drawn: Any = simulation.trail
    if memory.get("generation") != drawn.generation or memory.get("trail") is not drawn:
        memory.update(trail=drawn, generation=drawn.generation, seen=0, strokes=[])
    strokes: list[list[Point]] = memory["strokes"]
    new = drawn.segments_since(memory["seen"])
    if new is None:  # more was drawn than is kept since the last look
        strokes.clear()
        new = []
    memory["seen"] = drawn.drawn
    for piece in new:
        # A turtle draws from where it is to where it was.
        begin = piece.x1 / PIXELS_PER_METRE, -piece.y1 / PIXELS_PER_METRE
        end = piece.x0 / PIXELS_PER_METRE, -piece.y0 / PIXELS_PER_METRE
        if begin == end:
            continue
        if not strokes or math.dist(strokes[-1][-1], begin) > 0.02:
            strokes.append([begin])
        strokes[-1].append(end)
    while sum(map(len, strokes)) > MOST_POINTS:
        strokes.pop(0)
    return strokes


def judged(strokes: Sequence[Sequence[Point]], shape: str, wanted: Say) -> Verdict:
    """Judge strokes of points in metres (y upwards)."""
    if not any(len(stroke) > 1 for stroke in strokes):
        return Verdict(False, wanted, Say("trail.saw_little"))
    if shape == "circle":
        ok = any(_is_round(stroke) for stroke in strokes)
        return Verdict(ok, wanted, None if ok else Say("trail.saw_round"))
    if shape == "closed":
        gap = min(_gap(stroke) for stroke in strokes)
        return Verdict(gap <= 0.3, wanted, None if gap <= 0.3 else Say("trail.saw_open", gap=f"{gap:.2f}"))
    form = SHAPES[shape]
    legs: list[tuple[Point, Point]] = []
    for stroke in strokes:
        legs = straight_lines(stroke)
        for first in range(len(legs) - form.sides + 1):
            if _is_form(legs[first : first + form.sides], form):
                return Verdict(True, wanted)
    last = legs[-form.sides :]
    if not last:
        return Verdict(False, wanted, Say("trail.saw_little"))
    lengths = tuple(f"{math.dist(*leg):.1f}" for leg in last)
    turns = tuple(f"{turn:.0f}" for turn in _turns(last))
    return Verdict(False, wanted, Say("trail.saw_legs", lengths=lengths, turns=turns))


def straight_lines(points: Sequence[Point]) -> list[tuple[Point, Point]]:
    """The straight parts of a stroke, those that go on in the same direction as one; slips are left out."""
    legs: list[tuple[Point, Point]] = []
    begin = end = points[0]
    for point in points[1:]:
        if begin != end and abs(_turn(begin, end, end, point)) > STRAIGHT:
            legs.append((begin, end))
            begin = end
        end = point
    legs.append((begin, end))
    found: list[tuple[Point, Point]] = []
    for leg in legs:
        if math.dist(*leg) < SHORTEST:
            continue
        if found and abs(_turn(*found[-1], *leg)) <= STRAIGHT:
            found[-1] = (found[-1][0], leg[1])
        else:
            found.append(leg)
    return found


def _turn(a: Point, b: Point, c: Point, d: Point) -> float:
    """Degrees from the direction a→b to c→d, −180 to 180."""
    before, after = math.atan2(b[1] - a[1], b[0] - a[0]), math.atan2(d[1] - c[1], d[0] - c[0])
    return math.degrees(math.remainder(after - before, 2 * math.pi))


def _turns(legs: Sequence[tuple[Point, Point]]) -> list[float]:
    return [_turn(*one, *other) for one, other in pairwise(legs)]


def _is_form(legs: Sequence[tuple[Point, Point]], form: Shape) -> bool:
    lengths = [math.dist(*leg) for leg in legs]
    mean = sum(lengths) / len(lengths)
    slack = LENGTH_SLACK * mean
    turns = _turns(legs)
    one_way = all(turn > 0 for turn in turns) or all(turn < 0 for turn in turns)
    return (
        one_way
        and all(abs(length - mean) <= slack for length in lengths)
        and all(abs(abs(turn) - form.turn) <= TURN_SLACK for turn in turns)
        and math.dist(legs[0][0], legs[-1][1]) <= 2 * slack
    )


def _gap(stroke: Sequence[Point]) -> float:
    """How far the end of a stroke is from a point that it passed at least 2 m of way before."""
    way, best = 0.0, math.inf
    for before, point in zip(reversed(stroke), list(reversed(stroke))[1:], strict=False):
        way += math.dist(before, point)
        if way > 2.0:
            best = min(best, math.dist(point, stroke[-1]))
    return best


def _is_round(stroke: Sequence[Point]) -> bool:
    """Whether the end of a stroke is a whole circle."""
    total, used = 0.0, [stroke[-1]]
    points = list(reversed(stroke))
    for at in range(1, len(points) - 1):
        total += _turn(points[at - 1], points[at], points[at], points[at + 1])
        used.append(points[at])
        if abs(total) >= 355.0:
            break
    if abs(total) < 355.0 or len(used) < 12:
        return False
    middle = sum(x for x, _ in used) / len(used), sum(y for _, y in used) / len(used)
    radii = [math.dist(point, middle) for point in used]
    mean = sum(radii) / len(radii)
    return mean > 0.2 and all(abs(radius - mean) <= 0.1 * mean for radius in radii)
