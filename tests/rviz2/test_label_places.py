"""Texts in the view: none over another, none lost while there is room, none cut by the edge; and braille's brightness."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from day6_core.ros.programs.rviz2.model.scene import BOX, Label, Scene, Shape
from day6_core.ros.programs.rviz2.model.views import Orbit
from day6_tui.panes.canvas import PIXELS_PER_CELL
from day6_tui.panes.cells import cell_len
from day6_tui.render.cells import Cells, cells_covered, cells_of, pixel_aspect
from day6_tui.render.label_places import LabelPiece, LabelPlaces
from day6_tui.render.painter import QUALITIES, paint, paint_grids
from day6_tui.render.picture import PictureText
from day6_urdf.kinematics import Transform

WHITE = (255, 255, 255)


def _placed(places: LabelPlaces, texts: list[tuple[float, float, str]], *size: int) -> list[list[LabelPiece]]:
    return places.place([PictureText(*text, WHITE) for text in texts], *size)


def _pieces(texts: list[tuple[float, float, str]], columns: int = 60, rows: int = 20) -> list[list[LabelPiece]]:
    return _placed(LabelPlaces(), texts, columns, rows)


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
    assert _placed(ascii_places, [*at_the_point, (30, 10, "frames")], 60, 20)[21] == [(30, 11, "`-frames")]
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
    _placed(places, both, 60, 20)
    # The other one turns away slowly; as long as its name beside it would touch, it stays a row below.
    rows = []
    for step in range(40):
        x = 30.5 + step / 2
        (_, other) = _placed(places, [both[0], (x, 10.5, "base_footprint")], 60, 20)
        rows.append(other[0].row)
    assert rows[:10] == [11] * 10 and rows[-1] == 10
    assert sum(a != b for a, b in pairwise(rows)) == 1


def test_a_name_at_the_edge_of_a_cell_does_not_tremble() -> None:
    places = LabelPlaces()
    shaking = [_placed(places, [(30 + 0.1 * (-1) ** n, 10 - 0.2 * (-1) ** n, "odom")], 60, 20) for n in range(6)]
    assert all(each == shaking[0] for each in shaking)
    assert _placed(places, [(31.5, 12.5, "odom")], 60, 20) == [[(29, 12, "odom")]]


def test_a_robot_that_turns_takes_its_names_along() -> None:
    """Four wheels and the body on a circle: names move with their points, and jump seldom."""
    places, before, jumps = LabelPlaces(), {}, 0
    names = ["base_link", "front_left", "front_right", "rear_left", "rear_right"]
    for step in range(360):
        texts = [(30.0, 10.0, names[0])]
        for corner, name in enumerate(names[1:]):
            angle = math.radians(step + 90 * corner)
            texts.append((30 + 8 * math.cos(angle), 10 + 3 * math.sin(angle), name))
        found = _placed(places, texts, 60, 20)
        for (x, y, name), pieces in zip(texts, found, strict=True):
            assert pieces, name
            place = pieces[0].column - x, pieces[0].row - y
            last = before.get(name, place)
            jumps += abs(place[1] - last[1]) > 1.5 or abs(place[0] - last[0]) > 3
            before[name] = place
    assert jumps <= 12


def test_only_the_line_of_a_name_is_drawn_again() -> None:
    picture = paint(Scene(), Orbit(list, lambda: None).camera(), 60, 40, pixel_aspect("half"), QUALITIES["High"])
    picture.labels = [PictureText(30.0, 20.0, "odom", WHITE)]
    before = cells_of(picture, "half")
    picture.labels = [PictureText(32.0, 20.0, "odom", WHITE)]
    assert cells_of(picture, "half").changes(before) == [10]


def test_a_name_has_one_ground_that_it_can_be_read_on() -> None:
    camera = Orbit(list, lambda: None).camera()

    def cells(under: list[float]) -> Cells:
        picture = paint(Scene(), camera, 60, 40, pixel_aspect("half"), QUALITIES["High"])
        picture.labels = [PictureText(30.0, 20.0, "odom", WHITE)]
        picture.colour[20:22, 28:32] = np.array(under)[None, :, None]
        picture.kind[20:22, 28:32] = 1
        return cells_of(picture, "half", step=1)

    before = cells([0.0, 0.0, 0.0, 0.0])
    # What most of its cells have; where that is as bright as the name, the ground of the view.
    changed = cells([0.0, 0.0, 0.0, 0.2])
    assert changed.changes(before) == []
    assert cells([0.0, 0.2, 0.2, 0.2]).changes(before) == [10]
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


# -- beside a robot ----------------------------------------------------------------------------------------------------


def _named_car(
    columns: int, rows: int, mode: str, *, fine: bool = False, colourless: bool = False
) -> tuple[Cells, np.ndarray]:
    """The car as large as it can be, with the names of its frames, and the cells it covers."""
    from day6_tui.windows.rviz.extent import frame, outline
    from tests.rviz2.test_pictures import car_scene

    scene = car_scene(0.3)
    scene.lines = [replace(lines, lattice=True) for lines in scene.lines]
    for name, place in CAR_FRAMES:
        scene.labels.append(Label(name, place, (1.0, 1.0, 1.0, 1.0), is_name=True))
    view = Orbit(list, lambda: None)
    frame(view, outline(scene), columns / rows / 2)
    across, down = PIXELS_PER_CELL[mode]
    size = columns * across, rows * down
    picture = paint(scene, view.camera(), *size, pixel_aspect(mode), QUALITIES["High"], grids=not fine)
    grids = paint_grids(picture, scene, 2) if fine else None
    return cells_of(picture, mode, colourless=colourless, grids=grids), cells_covered(picture.robot, across, down)


CAR_FRAMES = [
    ("base_link", (0.0, 0.0, 0.0)),
    ("caster", (0.1, 0.0, 0.02)),
    ("left_wheel", (0.0, 0.15, 0.05)),
    ("right_wheel", (0.0, -0.15, 0.05)),
]
SIZES = [(36, 17), (47, 10), (56, 8), (75, 10), (74, 34)]


@pytest.mark.parametrize("mode", ["half", "braille", "cell", "ascii"])
@pytest.mark.parametrize("size", SIZES)
def test_no_name_covers_the_robot_and_all_have_room_beside_it(mode: str, size: tuple[int, int]) -> None:
    cells, robot = _named_car(*size, mode)
    names = [(row, column, words.strip("─-")) for row, labels in cells.labels.items() for column, words, *_ in labels]
    longest = size[0] / 3
    assert {words for _, _, words in names} == {name for name, _ in CAR_FRAMES if len(name) <= longest}
    assert robot.mean() > 0.15
    for row, labels in cells.labels.items():
        for column, words, *_ in labels:
            assert not robot[row, column : column + cell_len(words)].any(), words


def test_names_stand_on_a_dark_chip_but_for_terminals_without_colour() -> None:
    cells, _ = _named_car(47, 10, "half", fine=True)
    assert {ground for labels in cells.labels.values() for *_, ground in labels} == {0x181818}
    cells, _ = _named_car(47, 10, "half", fine=True, colourless=True)
    assert {ground for labels in cells.labels.values() for *_, ground in labels} == {-1}


def test_a_name_too_long_for_the_picture_or_without_room_is_left_out() -> None:
    robot = np.zeros((6, 30), bool)
    robot[2:4, 10:20] = True
    name = PictureText(15.0, 3.0, "a" * 10, WHITE, is_name=True)
    assert LabelPlaces().place([name], 30, 6, robot) == [[(10, 4, "a" * 10)]]
    assert LabelPlaces().place([name._replace(words="a" * 11)], 30, 6, robot) == [[]]
    robot[:, 5:25] = True
    assert LabelPlaces().place([name], 30, 6, robot) == [[]]
    # What a program writes there is no name, and stays at its place.
    assert LabelPlaces().place([name._replace(is_name=False)], 30, 6, robot) == [[(10, 3, "a" * 10)]]


def test_a_name_in_the_row_of_its_point_touches_the_robot() -> None:
    robot = np.zeros((6, 40), bool)
    robot[:, 10:20] = True
    name = PictureText(18.0, 3.0, "wheel", WHITE, is_name=True)
    assert LabelPlaces().place([name, name._replace(x=11.0)], 40, 6, robot) == [[(20, 3, "─wheel")], [(4, 3, "wheel─")]]
    assert LabelPlaces(unicode=False).place([name], 40, 6, robot) == [[(20, 3, "-wheel")]]


def test_a_name_beside_a_robot_does_not_change_sides_for_little() -> None:
    places, robot = LabelPlaces(), np.zeros((1, 40), bool)
    robot[:, 10:20] = True
    columns = []
    for x in (17.0, 15.5, 14.5, 13.5, 10.5, 13.5, 15.5):
        ((piece,),) = places.place([PictureText(x, 0.0, "wheel", WHITE, is_name=True)], 40, 1, robot)
        columns.append(piece.column)
    assert columns == [20, 20, 20, 20, 4, 4, 4]


# -- small pictures ----------------------------------------------------------------------------------------------------


def test_a_small_picture_has_its_grid_in_dots_and_its_solids_in_half_blocks() -> None:
    cells, robot = _named_car(47, 10, "half", fine=True)
    is_dots = (cells.chars >= 0x2800) & (cells.chars < 0x2900)
    assert is_dots.sum() > 20 and not is_dots[robot].any()
    coarse, same_robot = _named_car(47, 10, "half")
    assert (robot == same_robot).all() and not ((coarse.chars >= 0x2800) & (coarse.chars < 0x2900)).any()
    plain, _ = _named_car(47, 10, "half", fine=True, colourless=True)
    assert ((plain.chars >= 0x2800) == is_dots).all()
    assert {chr(char) for char in plain.chars[robot]} >= set("▄▀█")
