"""The world of turtles without ROS: names, order, reset, and the scene a window draws."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from day6_core.ros.distribution import NAMES
from day6_core.ros.programs.turtlesim.model import CENTRE, Simulation, kinds

TICK_NS = 16_000_000


def simulation(*names: str) -> Simulation:
    world = Simulation(lambda count: count - 1)
    for name in names:
        put(world, name)
    return world


def put(world: Simulation, name: str = "") -> str:
    free = world.free_name(name)
    assert free is not None
    world.add(world.create(free, *CENTRE, 0.0, 0))
    return free


def test_turtles_without_a_name_are_numbered_and_skip_taken_names() -> None:
    world = simulation("", "turtle2", "")
    assert list(world.turtles) == ["turtle1", "turtle2", "turtle3"]


def test_a_killed_turtles_number_is_not_given_again() -> None:
    world = simulation("")
    world.remove("turtle1")
    assert put(world) == "turtle2"


def test_a_taken_name_is_refused() -> None:
    world = simulation("leonardo")
    assert world.free_name("leonardo") is None


def test_turtles_move_in_the_order_of_their_names() -> None:
    world = simulation("b", "a", "Z")
    world.tick(0)
    assert [turtle.name for turtle, _ in world.tick(TICK_NS)] == ["Z", "a", "b"]


def test_a_turtle_reads_what_another_drew_in_the_same_tick() -> None:
    world = simulation("a", "b")
    world.tick(0)
    world.turtles["a"].command(2.0, 0.0, TICK_NS)
    (_, first), (_, second) = world.tick(TICK_NS)
    assert first.colour == (255, 255, 255)
    assert second.colour == (179, 184, 255)


def test_the_first_tick_only_starts_the_clock() -> None:
    world = simulation("")
    world.turtles["turtle1"].command(2.0, 0.0, 0)
    assert world.tick(0) == []
    assert world.tick(TICK_NS)[0][1].changed


def test_reset_counts_from_one_again_and_keeps_the_background() -> None:
    world = simulation("", "")
    world.set_background(1, 2, 3)
    world.remove_all()
    world.clear()
    assert put(world) == "turtle1"
    assert world.scene.background == (1, 2, 3)
    assert [turtle.name for turtle in world.scene.turtles] == ["turtle1"]


def test_a_killed_turtle_leaves_its_trail() -> None:
    world = simulation("")
    world.tick(0)
    world.turtles["turtle1"].command(2.0, 0.0, TICK_NS)
    world.tick(TICK_NS)
    world.remove("turtle1")
    assert world.trail.drawn == 1
    assert world.remove("turtle1") is False


def test_a_scene_is_a_new_one_only_when_the_picture_changed() -> None:
    world = simulation("")
    world.tick(0)
    world.tick(TICK_NS)
    still = world.scene
    world.tick(2 * TICK_NS)
    assert world.scene is still
    world.turtles["turtle1"].command(2.0, 0.0, 3 * TICK_NS)
    world.tick(3 * TICK_NS)
    assert world.scene is not still
    assert still.turtles[0].x == 5.544444561004639
    assert world.scene.turtles[0].kind == "rolling"


@pytest.mark.parametrize("name", NAMES)
def test_each_distribution_has_a_picture_more(name: str, in_distribution: Callable[[str], None]) -> None:
    in_distribution(name)
    newest = "lyrical" if name == "rolling" else name
    assert kinds()[-2:] == (newest, "rolling")
    count = {"humble": 9, "jazzy": 11, "kilted": 12, "lyrical": 13}[newest]
    world = Simulation(lambda choices: choices - 2 if choices == count else 0)
    assert world.create("a", 0.0, 0.0, 0.0, 0).kind == newest
