"""The Grid of RViz at every distance: lines where they can be told apart, nothing of them where they would run together."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import numpy as np
import pytest

from day6_core.ros.programs.rviz2.model.scene import BOX, Lines, Points, Scene, Shape
from day6_core.ros.programs.rviz2.model.views import Orbit, TopDownOrtho
from day6_tui.panes.canvas import PIXELS_PER_CELL
from day6_tui.render import lattice
from day6_tui.render.cells import cells_of, pixel_aspect
from day6_tui.render.painter import QUALITIES, paint
from day6_tui.render.picture import EMPTY
from day6_urdf.kinematics import Transform

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.views import Camera
    from day6_tui.render.picture import RenderedPicture
    from tests.rviz2.rviz_machine import RVizMachine

GROUND = 48 / 255


@pytest.fixture
def grid(machine: RVizMachine) -> Lines:
    """The lines of the Grid that RViz starts with."""
    rviz = machine.open()
    machine.transform("map", "base_link")
    machine.until(lambda: rviz.scene.lines)
    (lines,) = rviz.scene.lines
    return lines


def orbit(distance: float = 10.0, yaw: float = 0.785, pitch: float = 0.785) -> Camera:
    view = Orbit(list, lambda: None)
    for name, value in (("Distance", distance), ("Yaw", yaw), ("Pitch", pitch)):
        view.child(name).value = value
    return view.camera()


def pictured(
    grid: Lines, camera: Camera, columns: int, rows: int, mode: str = "half", *shapes: Shape
) -> RenderedPicture:
    across, down = PIXELS_PER_CELL[mode]
    scene = Scene(lines=[grid], shapes=list(shapes))
    return paint(scene, camera, columns * across, rows * down, pixel_aspect(mode), QUALITIES["High"])


@pytest.mark.parametrize("mode", ["half", "braille", "cell", "ascii"])
@pytest.mark.parametrize("size", [(27, 16), (47, 16), (58, 34), (110, 36)])
@pytest.mark.parametrize("distance", [10.0, 25.0, 80.0])
def test_the_grid_never_runs_together_into_a_patch(
    grid: Lines, mode: str, size: tuple[int, int], distance: float
) -> None:
    picture = pictured(grid, orbit(distance), *size, mode)
    lit = picture.kind != EMPTY
    rows, columns = np.flatnonzero(lit.any(axis=1)), np.flatnonzero(lit.any(axis=0))
    if len(rows) < 8 or len(columns) < 8:
        return  # the grid is as small as a few lines are thick
    assert lit[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].mean() < 0.4
    # No place of seven by seven pixels is full of lines.
    sums = np.pad(lit.astype(int).cumsum(0).cumsum(1), ((1, 0), (1, 0)))
    assert (sums[7:, 7:] - sums[:-7, 7:] - sums[7:, :-7] + sums[:-7, :-7]).max() < 0.75 * 49


@pytest.mark.parametrize("pixels_per_metre", [1.0, 3.0, 10.0])
def test_the_border_of_the_grid_is_there_at_every_distance(grid: Lines, pixels_per_metre: float) -> None:
    view = TopDownOrtho(list, lambda: None)
    view.child("Scale").value = 600 / 120 * pixels_per_metre
    picture = pictured(grid, view.camera(), 120, 60)
    half = round(5 * pixels_per_metre)
    for row in (60 - half, 60 + half):
        strip = picture.colour[row - 1 : row + 1, 60 - half + 1 : 60 + half - 1, 0]
        assert (strip.max(axis=0) > GROUND + 0.08).all()


def test_every_line_is_there_where_there_is_room(grid: Lines) -> None:
    view = TopDownOrtho(list, lambda: None)
    view.child("Scale").value = 600 / 120 * 10  # 10 pixels for a metre
    picture = pictured(grid, view.camera(), 140, 60)
    row = picture.colour[65, :, 0] > GROUND + 0.08  # between two lines that lie across
    starts = np.flatnonzero(row[1:] & ~row[:-1])
    assert len(starts) == 11 and set(np.diff(starts)) == {10}


def test_a_slanted_line_is_equally_bright_all_along() -> None:
    corners = [(-5, -5), (5, -5), (-5, -5), (-5, 5), (-5, 5), (5, 5), (5, -5), (5, 5)]
    frame = Lines([(float(x), float(y), 0.0) for x, y in corners], [(1.0, 1.0, 1.0, 1.0)], lattice=True)
    view = TopDownOrtho(list, lambda: None)
    view.child("Scale").value, view.child("Angle").value = 50.0, 0.2
    light = pictured(frame, view.camera(), 120, 60).colour[:60, 30:90, 0] - GROUND
    columns = light.sum(axis=0)
    assert columns.min() > 0.7 * columns.max() and light.max() > light[light > 0.01].min() * 2


def test_the_grid_hides_nothing_and_is_hidden(grid: Lines) -> None:
    red = (1.0, 0.0, 0.0, 1.0)
    above, below = (Shape(BOX, Transform((0, 0, z)), (2.0, 2.0, 0.2), red) for z in (0.3, -0.3))
    camera = orbit(10.0, 0.785, 1.5)
    assert pictured(grid, camera, 60, 30, "half", above).colour[29, 30, 2] < 0.05
    crossed = pictured(grid, camera, 60, 30, "half", below).colour[20:40, 20:40]
    assert ((crossed[..., 0] > 0.3) & (crossed[..., 2] > 0.1)).any()


def test_a_grid_is_sampled_once_for_each_place_from_which_it_is_seen(
    grid: Lines, monkeypatch: pytest.MonkeyPatch
) -> None:
    box = [Shape(BOX, Transform((x, 0.0, 0.3)), (2.0, 2.0, 0.2), (1.0, 0.0, 0.0, 1.0)) for x in (0.0, 1.0)]
    fresh = []
    for shape in box:
        lattice._samples.cache_clear()
        fresh.append(pictured(grid, orbit(), 60, 30, "half", shape))
    asked: list[int] = []
    sampled = lattice.ends_of
    monkeypatch.setattr(lattice, "ends_of", lambda lines: asked.append(1) or sampled(lines))
    lattice._samples.cache_clear()
    for shape, expected in zip(box, fresh, strict=True):
        assert np.array_equal(pictured(grid, orbit(), 60, 30, "half", shape).colour, expected.colour)
    assert len(asked) == 1
    pictured(grid, orbit(yaw=0.8), 60, 30, "half")
    pictured(grid, orbit(), 61, 30, "half")
    assert len(asked) == 3


def test_a_picture_has_few_colours(grid: Lines) -> None:
    picture = pictured(grid, orbit(), 110, 36)
    assert len(np.unique(picture.rgb(4))) <= 8


def test_any_camera_is_good_enough(grid: Lines) -> None:
    chance = random.Random(7)
    for _ in range(60):
        camera = orbit(10 ** chance.uniform(-3, 4), chance.uniform(0, 6.3), chance.uniform(-1.57, 1.57))
        picture = pictured(grid, camera, 40, 20, chance.choice(["half", "ascii"]))
        assert np.isfinite(picture.colour).all() and picture.colour.max() <= 1.0
        cells_of(picture, "half")


@pytest.mark.parametrize("place", [(0.0, 3.0), (3.0, 3.0), (-2.0, 1.0), (0.5, 2.0), (-4.0, -4.0)])
@pytest.mark.parametrize("mode", ["half", "braille", "ascii"])
def test_a_point_on_a_line_of_the_grid_is_seen(grid: Lines, mode: str, place: tuple[float, float]) -> None:
    across, down = PIXELS_PER_CELL[mode]
    red = Points([(*place, 0.0)], [(1.0, 0.0, 0.0, 1.0)], 0.01)
    scene = Scene(lines=[grid], points=[red])
    picture = paint(scene, orbit(14.0), 73 * across, 34 * down, pixel_aspect(mode), QUALITIES["High"])
    assert ((picture.colour[..., 0] > 0.9) & (picture.colour[..., 1] < 0.1)).any()
