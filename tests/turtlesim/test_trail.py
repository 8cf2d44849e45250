"""The path image: which pixels a line covers (pictures made by Qt 5.15's painter), and how a window follows it."""

from __future__ import annotations

import pytest

from day6_core.ros.programs.turtlesim.model import SIZE, Trail
from day6_core.ros.programs.turtlesim.model.trail import RECENT

QT = [
    ("one tick at 2 m/s", (250.9, 249.5, 249.5, 249.5, 3), (248, 248), "#### #### ####"),
    (
        "a slope",
        (110, 103, 100, 100, 3),
        (98, 98),
        ".#............ .#####........ #########..... ..##########.. .....######### ........#####. ............#.",
    ),
    ("one pixel wide", (100.2, 100.7, 105.2, 102.9, 1), (100, 100), "#..... .##... ...##. .....#"),
    (
        "steep and wide",
        (60.3, 40.9, 57.1, 49.2, 5),
        (54, 38),
        (
            ".....##... ....###### ....#####. ...######. ...#####.. ...#####.. ..######.. ..#####... .######..."
            " .#####.... .#####.... ######.... #####..... ..###....."
        ),
    ),
    ("over the edge", (3, 3, -5, 1, 3), (0, 1), "###.. ##### ####. ...#."),
    ("a dot", (20.5, 20.5, 20.5, 20.5, 3), (19, 19), "### ### ###"),
    ("a thin dot", (20.2, 20.7, 20.2, 20.7, 1), (20, 21), "#"),
]


def covered(trail: Trail) -> set[tuple[int, int]]:
    return {(index % SIZE, index // SIZE) for index, value in enumerate(trail.pixels) if value}


@pytest.mark.parametrize(("line", "corner", "rows"), [entry[1:] for entry in QT], ids=[entry[0] for entry in QT])
def test_a_line_covers_the_pixels_that_qt_covers(
    line: tuple[float, float, float, float, int], corner: tuple[int, int], rows: str
) -> None:
    trail = Trail()
    *ends, width = line
    trail.draw_line(*ends, 0x123456, width)
    left, top = corner
    expected = {(left + x, top + y) for y, row in enumerate(rows.split()) for x, mark in enumerate(row) if mark == "#"}
    assert covered(trail) == expected


def test_a_later_line_covers_an_earlier_one() -> None:
    trail = Trail()
    trail.draw_line(10, 10.5, 50, 10.5, 0xFF0000, 3)
    trail.draw_line(30.5, 5, 30.5, 20, 0x0000FF, 3)
    assert trail.colour_at(20, 10) == (255, 0, 0)
    assert trail.colour_at(30, 10) == (0, 0, 255)


def test_the_corners_of_the_world_lie_on_the_image_and_nothing_beyond() -> None:
    trail = Trail()
    assert trail.colour_at(499.0, 499.0) == (255, 255, 255)
    assert trail.colour_at(float("nan"), 0.0) == (0, 48, 57)
    assert trail.colour_at(500.0, 0.0) == (0, 48, 57)


@pytest.mark.parametrize("far", [float("inf"), float("nan"), 1e30])
def test_a_line_without_an_end_draws_nothing(far: float) -> None:
    trail = Trail()
    trail.draw_line(250, 250, far, 250, 0, 3)
    assert trail.drawn == 0
    assert not covered(trail)


def test_clear_wipes_everything_and_begins_a_generation() -> None:
    trail = Trail()
    trail.draw_line(10, 10, 50, 10, 0xFF0000, 3)
    held = trail.pixels
    trail.clear()
    assert not covered(trail)
    assert (trail.generation, trail.drawn) == (1, 0)
    assert any(held), "a window that was drawing the old picture may finish it"


def test_a_window_gets_the_segments_it_has_not_seen() -> None:
    trail = Trail()
    for x in range(5):
        trail.draw_line(x, 1, x + 1, 1, x, 3)
    new = trail.segments_since(3)
    assert new is not None
    assert [segment.rgb for segment in new] == [3, 4]
    assert trail.segments_since(5) == []


def test_a_window_that_was_away_too_long_has_to_rebuild() -> None:
    trail = Trail()
    for number in range(RECENT + 1):
        trail.draw_line(1, 1, 2, 1, number, 3)
    assert trail.segments_since(0) is None
    new = trail.segments_since(1)
    assert new is not None
    assert len(new) == RECENT
    assert trail.segments_since(RECENT + 2) is None
