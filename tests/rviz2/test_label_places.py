"""Texts in the view: none over another, none lost while there is room, none cut by the edge; and braille's brightness."""

from __future__ import annotations

import numpy as np

from day6_tui.core.ros.programs.rviz2.model.scene import BOX, Scene, Shape
from day6_tui.core.ros.programs.rviz2.model.views import Orbit
from day6_tui.tui.cells import cell_len
from day6_tui.tui.render.cells import cells_of, pixel_aspect
from day6_tui.tui.render.label_places import label_places
from day6_tui.tui.render.painter import QUALITIES, paint
from day6_tui.urdf.kinematics import Transform


def _cells(texts: list[tuple[float, float, str]], columns: int = 60, rows: int = 20) -> list[tuple[int, int]]:
    found = []
    for place, (_, _, text) in zip(label_places(texts, columns, rows), texts, strict=True):
        assert place is not None, text
        assert place.column >= 0 and place.column + cell_len(text) <= columns and 0 <= place.row < rows
        found += [(place.row, place.column + cell) for cell in range(cell_len(text))]
    return found


def test_names_at_one_point_are_all_readable() -> None:
    cells = _cells([(30, 10, f"left_wheel_{number}") for number in range(6)])
    assert len(cells) == len(set(cells))


def test_the_first_text_stands_at_its_point() -> None:
    (place, _) = label_places([(30, 10, "base"), (30, 10, "other")], 60, 20)
    assert place == (28, 10)


def test_a_name_at_the_edge_is_moved_inside() -> None:
    _cells([(0, 0, "base_link"), (59, 19, "base_link"), (59, 0, "底盘坐标系")])


def test_a_text_wider_than_the_view_has_no_place() -> None:
    assert label_places([(5, 5, "a" * 61)], 60, 20) == [None]


def test_the_places_are_the_same_for_the_same_picture() -> None:
    texts = [(30 + number / 3, 10.0, f"frame_{number}") for number in range(6)]
    assert label_places(texts, 60, 20) == label_places(texts, 60, 20)


def _brightness(mode: str, across: int, down: int) -> float:
    """The mean brightness of a red box's cells, with a dot or half a cell counted as what it covers."""
    scene = Scene()
    scene.shapes.append(Shape(BOX, Transform((0.0, 0.0, 0.0)), (4.0, 4.0, 4.0), (1.0, 0.2, 0.2, 1.0)))
    view = Orbit(list, lambda: None)
    picture = paint(scene, view.camera(), 60 * across, 20 * down, pixel_aspect(mode), QUALITIES["High"])
    cells = cells_of(picture, mode)
    share = np.where(cells.chars == ord("▀"), 0.5, 0.0)
    dots = np.array([bin(char - 0x2800).count("1") if char >= 0x2800 else 0 for char in cells.chars.reshape(-1)])
    share = share + dots.reshape(share.shape) / 8 * 0.4
    red = np.where(cells.front >= 0, cells.front >> 16, 0) * share + (cells.back >> 16) * (1 - share)
    return float(red.mean())


def test_braille_is_as_bright_as_half_blocks() -> None:
    half, braille = _brightness("half", 1, 2), _brightness("braille", 2, 4)
    assert abs(braille - half) < 0.1 * half
