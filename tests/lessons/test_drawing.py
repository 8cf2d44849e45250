"""What counts as a pentagram: the figure itself, however it was drawn, and nothing that only looks a little like it."""

from __future__ import annotations

import math
import random

import pytest

from day6_core.lessons.checks.drawing import _lines, judged
from day6_core.lessons.texts import Say
from day6_core.ros.programs.turtlesim.model.simulation import Simulation
from day6_core.ros.programs.turtlesim.model.turtle import Turtle

WANTED = Say("trail", turtle="turtle1", shape=Say("shape.pentagram"))


def figure(
    turns: list[float], lengths: list[float], pieces: int = 40, heading: float = 0.3
) -> list[tuple[float, float]]:
    """The points of a stroke: each length in small pieces, then its turn (degrees)."""
    x, y, points = 5.0, 5.0, [(5.0, 5.0)]
    for turn, length in zip(turns, lengths, strict=True):
        for _ in range(pieces):
            x, y = x + math.cos(heading) * length / pieces, y + math.sin(heading) * length / pieces
            points.append((x, y))
        heading += math.radians(turn)
    return points


def regular(sides: int, turn: float, length: float = 3.0) -> list[tuple[float, float]]:
    return figure([turn] * sides, [length] * sides)


def circle(turns: float = 1.05, radius: float = 1.5) -> list[tuple[float, float]]:
    return [(5 + radius * math.cos(each / 50), 5 + radius * math.sin(each / 50)) for each in range(int(turns * 314))]


GOOD = {
    "pentagram": regular(5, 144),
    "square": regular(4, 90),
    "triangle": regular(3, 120),
    "circle": circle(),
}


@pytest.mark.parametrize("shape", GOOD)
@pytest.mark.parametrize("drawn", GOOD)
def test_each_figure_is_itself_and_no_other(shape: str, drawn: str) -> None:
    assert judged([GOOD[drawn]], shape, WANTED).ok is (shape == drawn)


@pytest.mark.parametrize(
    ("points", "why"),
    [
        (regular(5, 72), "72"),
        (regular(4, 144), "144"),
        (figure([144] * 5, [3, 3, 2, 3, 3]), "2.0"),
        (figure([144, 144, 120, 144, 144], [3.0] * 5), "120"),
        (figure([144, -144, 144, -144, 144], [3.0] * 5), "-144"),
        (circle(0.4), "no straight line"),
        ([(5.0, 5.0)], "no straight line"),
    ],
)  # fmt: skip
def test_what_is_nearly_a_pentagram_is_refused_with_what_was_seen(points: list[tuple[float, float]], why: str) -> None:
    verdict = judged([points], "pentagram", WANTED)
    assert not verdict.ok
    assert why in verdict.text("en")
    assert verdict.text("zh")


@pytest.mark.parametrize("seed", range(20))
def test_a_pentagram_of_an_unsteady_hand_counts(seed: int) -> None:
    chance = random.Random(seed)
    turns = [144 + chance.uniform(-4, 4) for _ in range(5)]
    lengths = [3 * chance.uniform(0.96, 1.04) for _ in range(5)]
    assert judged([figure(turns, lengths, pieces=63)], "pentagram", WANTED).ok


def test_what_was_drawn_before_and_after_does_not_spoil_it() -> None:
    stroke = [*regular(2, 50), *regular(5, 144)[1:]]
    assert judged([regular(3, 30), GOOD["pentagram"], regular(1, 0)], "pentagram", WANTED).ok
    assert not judged([stroke[:100]], "pentagram", WANTED).ok


def test_a_closed_figure_comes_back() -> None:
    assert judged([regular(6, 60)], "closed", WANTED).ok
    assert not judged([regular(5, 60)], "closed", WANTED).ok


@pytest.mark.parametrize(("shape", "sides", "turn"), [("pentagram", 5, 144), ("square", 4, 90)])
def test_what_a_turtle_draws_is_one_stroke(shape: str, sides: int, turn: float) -> None:
    simulation, seconds = Simulation(lambda n: 0), 1_000_000_000
    turtle = Turtle("turtle1", 5.5, 5.5, 0.0, kind="humble", now=0)
    simulation.add(turtle)
    for press in range(2 * sides):
        began = press * 2 * seconds
        ahead, round_ = (3.0, 0.0) if press % 2 == 0 else (0.0, math.radians(turn) / 1.008)
        turtle.command(ahead, round_, began)
        for tick in range(75):
            simulation.tick(began + tick * 16_000_000)
    strokes = _lines(simulation, {})
    assert len(strokes) == 1
    assert judged(strokes, shape, WANTED).ok
