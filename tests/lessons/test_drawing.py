"""What counts as a pentagram: the figure itself, however it was drawn, and nothing that only looks a little like it."""

from __future__ import annotations

import math
import random
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.lessons.checks import Verdict
from day6_core.lessons.checks.drawing import _strokes, judged, trail
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
    strokes = [stroke.points for stroke in _strokes(simulation, {})]
    assert len(strokes) == 1
    assert judged(strokes, shape, WANTED).ok


class Driver:
    """Drives a turtle in a world of its own and looks at it as a check does, now and then."""

    def __init__(self) -> None:
        self.simulation, self.now, self.memory = Simulation(lambda n: 0), 0, dict[str, Any]()
        self.turtle = Turtle("turtle1", 5.5, 5.5, 0.7, kind="humble", now=0)
        self.simulation.add(self.turtle)
        self.simulation.tick(0)

    def press(self, ahead: float, turn: float) -> None:
        """Press a key, and wait until the turtle stands."""
        self.turtle.command(ahead, turn, self.now)
        self.wait()

    def side(self, length: float = 3.0, angle: float = 144.0) -> None:
        self.press(length, 0.0)
        self.press(0.0, math.radians(angle) / 1.008)

    def wait(self, ticks: int = 80) -> None:
        for _ in range(ticks):
            self.now += 16_000_000
            self.simulation.tick(self.now)
        self.look()

    def look(self, *, driven: bool = True, later: float = 0.0) -> Verdict:
        live: Any = SimpleNamespace(
            windows=lambda _: [SimpleNamespace(model=self.simulation)], now_ns=lambda: self.now + int(later * 1e9),
            step_began_ns=0, remembered=self.memory,
        )  # fmt: skip
        return trail(live, driven=driven)


def test_what_is_driven_is_driven_wherever_the_turtle_was_put_before() -> None:
    driver = Driver()
    driver.turtle.set_pen(0, 0, 0, 1, 1)
    driver.turtle.teleport_absolute(4.0, 5.0, 1.0)
    driver.wait(2)
    driver.turtle.set_pen(0, 0, 0, 1, 0)
    for _ in range(5):
        driver.side()
    assert driver.look().ok


def from_corner_to_corner(driver: Driver) -> None:
    for corner in range(6):
        angle = corner * math.radians(144)
        driver.turtle.teleport_absolute(5.5 + 2 * math.cos(angle), 5.5 + 2 * math.sin(angle), 0.0)
        driver.wait(2)


def little_by_little(driver: Driver) -> None:
    for _ in range(5):
        for _ in range(60):
            driver.turtle.teleport_relative(0.05, 0.0)
            driver.wait(1)
        driver.turtle.teleport_relative(0.0, math.radians(144))
        driver.wait(1)


def turned_by_teleport(driver: Driver) -> None:
    for _ in range(5):
        driver.press(3.0, 0.0)
        driver.turtle.teleport_relative(0.0, math.radians(144))
        driver.wait(1)


def last_side_by_teleport(driver: Driver) -> None:
    for _ in range(4):
        driver.side()
    driver.turtle.teleport_relative(3.0, 0.0)
    driver.wait(2)


@pytest.mark.parametrize("cheat", [from_corner_to_corner, little_by_little, turned_by_teleport, last_side_by_teleport])
def test_what_was_made_with_teleports_looks_right_and_is_not_driven(cheat: Any) -> None:
    driver = Driver()
    cheat(driver)
    verdict = driver.look()
    assert (verdict.ok, verdict.cheated, verdict.part) == (False, True, 0.0)
    assert "by a teleport service" in verdict.text("en")
    driver.memory.clear()
    assert driver.look(driven=False).ok  # a lesson asks for the figure only


@pytest.mark.parametrize(("sides", "part"), [(1, 0.0), (2, 0.2), (4, 0.6)])
def test_what_is_right_so_far_may_still_become_a_pentagram(sides: int, part: float) -> None:
    driver = Driver()
    for _ in range(sides):
        driver.side()
    verdict = driver.look()
    assert (verdict.ok, verdict.going, round(verdict.part, 2)) == (False, True, part)
    assert not driver.look(later=30.0).going  # it has stood still for too long
    assert verdict.where is not None and f"corner {sides + 2 if sides < 4 else 1}: " in verdict.where.text("en")
    assert "ends before it" in verdict.where.text("en")


def test_the_first_corner_that_is_not_there_is_told_with_both_places_and_the_time() -> None:
    driver = Driver()
    for length in (3.0, 3.0, 2.0, 3.0):
        driver.side(length)
    verdict = driver.look()
    assert (verdict.ok, verdict.going, verdict.part) == (False, False, 0.2)
    assert verdict.where is not None
    wanted, seen = verdict.where.values, (verdict.where.values["seen_x"], verdict.where.values["seen_y"])
    assert (wanted["corner"], wanted["slack"]) == (4, "0.4")
    # Two sides on from (5.5, 5.5), heading 0.7 rad, each after a turn of 144 degrees.
    x, y = 5.5, 5.5
    for number in range(3):
        heading = 0.7 + number * math.radians(144)
        x, y = x + 3.024 * math.cos(heading), y + 3.024 * math.sin(heading)
    assert (float(wanted["x"]), float(wanted["y"])) == pytest.approx((x, y), abs=0.12)
    assert tuple(map(float, seen)) == pytest.approx(
        (x - 1.008 * math.cos(heading), y - 1.008 * math.sin(heading)), abs=0.12
    )
    assert float(wanted["seconds"]) == pytest.approx(5 * 80 * 0.016, abs=0.1)
