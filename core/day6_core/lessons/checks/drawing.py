"""The check of what a turtle has drawn: straight lines, their lengths and the angles between them.

It judges the trail, not the way it was made: by keys, by `ros2 topic pub`, by a program. `driven` rules out teleports only.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.texts import Say

if TYPE_CHECKING:
    from collections.abc import Sequence

    from day6_core.lessons.live import Live

Point = tuple[float, float]
Leg = tuple[Point, Point]


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

NEAR = 0.02
"""Metres from the end of a stroke within which another piece goes on with it."""

STANDS = 10.0
"""Seconds after which a turtle that drew nothing more is not about to finish."""

MOST_POINTS = 20_000


@dataclass
class Stroke:
    """One line without a break: its points, in metres, y upwards from the upper edge.

    `jumped`: a teleport drew it; `cut`: a teleport came before it, so it does not go on from the one before. `seen` is how many
    points there were at each look that found more, with the seconds of the step.
    """

    points: list[Point]
    jumped: bool = False
    cut: bool = False
    seen: list[tuple[int, float]] = field(default_factory=list)

    def when(self, point: Point) -> float:
        """The seconds of the look that saw a point first."""
        at = self.points.index(point)
        return next((seconds for count, seconds in self.seen if count > at), 0.0)


@check("trail", one_of={"shape": (*SHAPES, *OTHERS)})
def trail(live: Live, shape: str = "pentagram", turtle: str = "turtle1", driven: bool = False) -> Verdict:
    wanted = Say("trail.driven" if driven else "trail", turtle=turtle, shape=Say(f"shape.{shape}"))
    windows = live.windows("turtlesim")
    if not windows:
        return Verdict(False, wanted, Say("trail.saw_none"))
    simulation: Any = windows[-1].model
    seconds = (live.now_ns() - live.step_began_ns) / 1e9
    strokes = _strokes(simulation, live.remembered, seconds)
    if not driven:
        return judged(_joined(strokes), shape, wanted)
    by_driving = [stroke for stroke in strokes if not stroke.jumped]
    verdict = judged([stroke.points for stroke in by_driving], shape, wanted)
    if verdict.ok:
        return verdict
    jumps = [at for at, each in enumerate(strokes) if each.jumped or (each.cut and at)]
    if jumps:
        return Verdict(False, wanted, Say("trail.saw_jumps", count=len(jumps)), cheated=True)
    form = SHAPES.get(shape)
    return verdict if form is None else _so_far(verdict, by_driving, form, seconds)


def _strokes(simulation: Any, memory: dict[str, Any], seconds: float = 0.0) -> list[Stroke]:
    """The trail as strokes, from what was drawn since the last `clear`."""
    from day6_core.ros.programs.turtlesim.model import PIXELS_PER_METRE

    drawn: Any = simulation.trail
    if memory.get("generation") != drawn.generation or memory.get("trail") is not drawn:
        memory.update(trail=drawn, generation=drawn.generation, seen=0, strokes=[])
    strokes: list[Stroke] = memory["strokes"]
    before = memory["seen"]
    new = drawn.segments_since(before)
    if new is None:  # more was drawn than is kept since the last look
        strokes.clear()
        new = []
    memory["seen"] = drawn.drawn
    jumps = list(drawn.jumps)
    own = {number for begin, end in jumps for number in range(begin, end)}
    after = {end for _, end in jumps}
    for number, piece in enumerate(new, before):
        # A turtle draws from where it is to where it was.
        begin = piece.x1 / PIXELS_PER_METRE, -piece.y1 / PIXELS_PER_METRE
        end = piece.x0 / PIXELS_PER_METRE, -piece.y0 / PIXELS_PER_METRE
        if begin == end:
            continue
        jumped, cut = number in own, number in after
        if not strokes or jumped or cut or math.dist(strokes[-1].points[-1], begin) > NEAR:
            strokes.append(Stroke([begin], jumped, cut))
        strokes[-1].points.append(end)
    if strokes and new:
        strokes[-1].seen.append((len(strokes[-1].points), seconds))
    while sum(len(stroke.points) for stroke in strokes) > MOST_POINTS:
        strokes.pop(0)
    return strokes


def _joined(strokes: Sequence[Stroke]) -> list[list[Point]]:
    """The points of strokes, however they were drawn: what goes on where another one ends is one with it."""
    if not any(stroke.jumped or stroke.cut for stroke in strokes):
        return [stroke.points for stroke in strokes]
    found: list[list[Point]] = []
    for stroke in strokes:
        if found and math.dist(found[-1][-1], stroke.points[0]) <= NEAR:
            found[-1].extend(stroke.points[1:])
        else:
            found.append(list(stroke.points))
    return found


def _so_far(verdict: Verdict, strokes: Sequence[Stroke], form: Shape, seconds: float) -> Verdict:
    """The verdict on an unfinished or wrong figure, with what of it is right and where the first corner is that is not."""
    lines = [straight_lines(stroke.points) for stroke in strokes]
    best = max((_longest(legs, form) for legs in lines), default=0)
    if not lines or not lines[-1]:
        return verdict
    stroke, legs = strokes[-1], lines[-1]
    # The last line may still grow; before the first corner nothing can be said.
    so_far = len(legs) <= form.sides and _fits(legs[:-1], form) and _fits(legs[-2:], form, growing=True)
    moves = bool(stroke.seen) and seconds - stroke.seen[-1][1] < STANDS
    return replace(
        verdict,
        part=max(0, min(best, form.sides) - 1) / form.sides,
        going=so_far and moves,
        where=_where(stroke, legs[-form.sides :], form),
    )


def _longest(legs: Sequence[Leg], form: Shape) -> int:
    """How many lines one after the other belong to such a figure."""
    return max(
        (end - begin for begin in range(len(legs)) for end in range(begin + 1, min(len(legs), begin + form.sides) + 1)
         if _fits(legs[begin:end], form)),
        default=0,
    )  # fmt: skip


def _where(stroke: Stroke, legs: Sequence[Leg], form: Shape) -> Say | None:
    """The first corner that is not where the first line and the figure put it, in the coordinates of turtlesim."""
    from day6_core.ros.programs.turtlesim.model.turtle import HEIGHT

    (begin, corner), length = legs[0], math.dist(*legs[0])
    heading = math.atan2(corner[1] - begin[1], corner[0] - begin[0])
    turns = _turns(legs)
    turn = math.radians(form.turn) * (-1 if turns and turns[0] < 0 else 1)
    for number in range(1, form.sides):
        heading += turn
        corner = corner[0] + length * math.cos(heading), corner[1] + length * math.sin(heading)
        values = {"corner": (number + 1) % form.sides + 1, "x": f"{corner[0]:.1f}", "y": f"{corner[1] + HEIGHT:.1f}"}
        values["slack"] = f"{LENGTH_SLACK * length:.1f}"
        if number >= len(legs):
            return Say("trail.where_none", **values)
        seen = legs[number][1]
        if math.dist(seen, corner) > LENGTH_SLACK * length:
            when = f"{stroke.when(seen):.1f}"
            return Say(
                "trail.where", **values, seen_x=f"{seen[0]:.1f}", seen_y=f"{seen[1] + HEIGHT:.1f}", seconds=when
            )  # fmt: skip
    return None


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
    legs: list[Leg] = []
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


def straight_lines(points: Sequence[Point]) -> list[Leg]:
    """The straight parts of a stroke, those that go on in the same direction as one; slips are left out."""
    legs: list[Leg] = []
    begin = end = points[0]
    for point in points[1:]:
        if begin != end and abs(_turn(begin, end, end, point)) > STRAIGHT:
            legs.append((begin, end))
            begin = end
        end = point
    legs.append((begin, end))
    found: list[Leg] = []
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


def _turns(legs: Sequence[Leg]) -> list[float]:
    return [_turn(*one, *other) for one, other in pairwise(legs)]


def _is_form(legs: Sequence[Leg], form: Shape) -> bool:
    slack = LENGTH_SLACK * sum(math.dist(*leg) for leg in legs) / len(legs)
    return _fits(legs, form) and math.dist(legs[0][0], legs[-1][1]) <= 2 * slack


def _fits(legs: Sequence[Leg], form: Shape, *, growing: bool = False) -> bool:
    """Whether lines one after the other are alike and turn as the figure's do; the last one may be short while it grows."""
    lengths = [math.dist(*leg) for leg in legs]
    whole = lengths[:-1] if growing and len(lengths) > 1 else lengths
    mean = sum(whole) / len(whole) if whole else 0.0
    slack = LENGTH_SLACK * mean
    turns = _turns(legs)
    one_way = all(turn > 0 for turn in turns) or all(turn < 0 for turn in turns)
    return (
        one_way
        and all(abs(length - mean) <= slack for length in whole)
        and all(length <= mean + slack for length in lengths)
        and all(abs(abs(turn) - form.turn) <= TURN_SLACK for turn in turns)
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
