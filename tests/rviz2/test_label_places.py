"""Texts in the view: none over another, none lost while there is room, none cut by the edge; and braille's brightness."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import BOX, Scene, Shape
from day6_core.ros.programs.rviz2.model.views import Orbit
from day6_tui.panes.cells import cell_len
from day6_tui.render.cells import Cells, cells_of, pixel_aspect
from day6_tui.render.label_places import LabelPiece, LabelPlaces
from day6_tui.render.painter import QUALITIES, paint
from day6_urdf.kinematics import Transform


def _pieces(texts: list[tuple[float, float, str]], columns: int = 60, rows: int = 20) -> list[list[LabelPiece]]:
    return LabelPlaces().place(texts, columns, rows)


def _cells(texts: list[tuple[float, float, str]], columns: int = 60, rows: int = 20) -> list[tuple[int, int]]:
    found = []
    for pieces, (_, _, text) in zip(_pieces(texts, columns, rows), texts, strict=True):
        assert text in pieces[0].text
        for piece in pieces:
            assert piece.column >= 0 and piece.column + cell_len(piece.text) <= columns and 0 <= piece.row < rows
            found += [(piece.row, piece.column + cell) for cell in range(cell_len(piece.text))]
    return found


def test_names_at_one_point_are_all_readable() -> None:
    cells = _cells([(30, 10, f"left_wheel_{number}") for number in range(6)])
    assert len(cells) == len(set(cells))


def test_the_first_text_stands_at_its_point() -> None:
    (place, _) = _pieces([(30, 10, "base"), (30, 10, "other")])
    assert place == [(28, 10, "base")]


def test_a_name_at_the_edge_is_moved_inside() -> None:
    _cells([(0, 0, "base_link"), (59, 19, "base_link"), (59, 0, "底盘坐标系")])


def test_a_text_wider_than_the_view_has_no_place() -> None:
    assert _pieces([(5, 5, "a" * 61)]) == [[]]


def test_the_places_are_the_same_for_the_same_picture() -> None:
    texts = [(30 + number / 3, 10.0, f"frame_{number}") for number in range(6)]
    assert _pieces(texts) == _pieces(texts)


def test_a_name_two_rows_away_has_a_leader_where_nothing_stands() -> None:
    wide = [(30, 10, "a" * 9), (26, 11, "left"), (26, 9, "left")]
    assert _pieces([*wide, (33, 10, "name")])[3] == [(31, 11, "name")]
    wide[1:] = [(32, 11, "right"), (32, 9, "right")]
    assert _pieces([*wide, (30, 10, "frames")])[3] == [(27, 12, "frames")]  # the row between is full
    wide[1:] = [(26, 11, "b" * 7), (26, 9, "b" * 7)]
    assert _pieces([*wide, (32, 10, "frames")])[3] == [(29, 12, "frames"), (32, 11, "│")]


def test_a_name_that_has_no_room_over_its_point_stands_beside_with_a_hook() -> None:
    left = [(24.0, float(row), "b" * 8) for row in range(20)]  # up to column 28
    assert _pieces([*left, (31, 10, "frames")])[20] == [(32, 10, "─frames")]
    at_the_point = [*left, (30, 10, "x")]
    assert _pieces([*at_the_point, (30, 10, "frames")])[21] == [(30, 11, "╰─frames")]
    ascii_places = LabelPlaces(unicode=False)
    assert ascii_places.place([*at_the_point, (30, 10, "frames")], 60, 20)[21] == [(30, 11, "`-frames")]
    right = [(36.0, float(row), "b" * 8) for row in range(20)]  # from column 32
    assert _pieces([*right, (29, 10, "frames")])[20] == [(22, 10, "frames─")]
    assert _pieces([*right, (30, 10, "x"), (30, 10, "frames")])[21] == [(23, 11, "frames─╯")]


def test_the_lines_of_a_text_stay_together_and_in_their_order() -> None:
    (first, second) = _pieces([(30, 10, "Button\n(left click)"), (30, 10, "other\n\nlines")])
    assert first == [(27, 10, "Button"), (24, 11, "(left click)")]
    assert second == [(28, 7, "other"), (28, 9, "lines")]
    # Upwards the last line is the nearest.
    below = [(30.0, float(row), "b" * 15) for row in range(10, 16)]
    assert _pieces([*below, (30, 10, "up\nhere")])[6] == [(29, 8, "up"), (28, 9, "here")]
    assert _pieces([(30, 10, "\n"), (30, 10, "a\n" * 100)]) == [[], []]
    left = [(24.0, float(row), "b" * 8) for row in range(20)]
    assert _pieces([*left, (31, 10, "two\nlonger lines")])[20] == [(32, 10, "─two"), (33, 11, "longer lines")]


def test_a_name_keeps_its_place_until_it_must_move() -> None:
    places = LabelPlaces()
    both = [(30.5, 10.5, "base_link"), (30.5, 10.5, "base_footprint")]
    places.place(both, 60, 20)
    # The other one turns away slowly; as long as its name beside it would touch, it stays a row below.
    rows = []
    for step in range(40):
        x = 30.5 + step / 2
        (_, other) = places.place([both[0], (x, 10.5, "base_footprint")], 60, 20)
        rows.append(other[0].row)
    assert rows[:10] == [11] * 10 and rows[-1] == 10
    assert sum(a != b for a, b in pairwise(rows)) == 1


def test_a_name_at_the_edge_of_a_cell_does_not_tremble() -> None:
    places = LabelPlaces()
    shaking = [places.place([(30 + 0.1 * (-1) ** n, 10 - 0.2 * (-1) ** n, "odom")], 60, 20) for n in range(6)]
    assert all(each == shaking[0] for each in shaking)
    assert places.place([(31.5, 12.5, "odom")], 60, 20) == [[(29, 12, "odom")]]


def test_a_robot_that_turns_takes_its_names_along() -> None:
    """Four wheels and the body on a circle: names move with their points, and jump seldom."""
    places, before, jumps = LabelPlaces(), {}, 0
    names = ["base_link", "front_left", "front_right", "rear_left", "rear_right"]
    for step in range(360):
        texts = [(30.0, 10.0, names[0])]
        for corner, name in enumerate(names[1:]):
            angle = math.radians(step + 90 * corner)
            texts.append((30 + 8 * math.cos(angle), 10 + 3 * math.sin(angle), name))
        found = places.place(texts, 60, 20)
        for (x, y, name), pieces in zip(texts, found, strict=True):
            assert pieces, name
            place = pieces[0].column - x, pieces[0].row - y
            last = before.get(name, place)
            jumps += abs(place[1] - last[1]) > 1.5 or abs(place[0] - last[0]) > 3
            before[name] = place
    assert jumps <= 12


def test_only_the_cells_of_a_name_are_sent_again() -> None:
    picture = paint(Scene(), Orbit(list, lambda: None).camera(), 60, 40, pixel_aspect("half"), QUALITIES["High"])
    picture.labels = [(30.0, 20.0, "odom", (255, 255, 255))]
    before = cells_of(picture, "half")
    picture.labels = [(32.0, 20.0, "odom", (255, 255, 255))]
    assert cells_of(picture, "half").changes(before) == [(10, 28, 34)]


def test_a_name_has_one_ground_that_it_can_be_read_on() -> None:
    camera = Orbit(list, lambda: None).camera()

    def cells(under: list[float]) -> Cells:
        picture = paint(Scene(), camera, 60, 40, pixel_aspect("half"), QUALITIES["High"])
        picture.labels = [(30.0, 20.0, "odom", (255, 255, 255))]
        picture.colour[20:22, 28:32] = np.array(under)[None, :, None]
        picture.kind[20:22, 28:32] = 1
        return cells_of(picture, "half", step=1)

    before = cells([0.0, 0.0, 0.0, 0.0])
    # What most of its cells have; where that is as bright as the name, the ground of the view.
    changed = cells([0.0, 0.0, 0.0, 0.2])
    assert changed.changes(before) == []
    assert cells([0.0, 0.2, 0.2, 0.2]).changes(before) == [(10, 28, 32)]
    assert cells([1.0, 1.0, 1.0, 1.0]).labels[10] == [(28, "odom", 0xFFFFFF, 0x303030)]
    assert before.labels[10] == [(28, "odom", 0xFFFFFF, 0x000000)]


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
