"""What the windows' pictures show, pixel by pixel: the modules that draw, without a screen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rich.style import Style

from day6_core.ros.environment import SHARE_PATH
from day6_core.ros.programs.day6_world.model import Trail, WorldSnapshot
from day6_core.ros.programs.day6_world.scenery import read_scenery, shipped_worlds
from day6_core.ros.programs.rqt_graph.model.fit import unfitted
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge
from day6_tui.appearance.colours import background_of, colours
from day6_tui.pixels.bands import Array
from day6_tui.pixels.raster import Surface, rgb
from day6_tui.pixels.sheet import Sheet
from day6_tui.windows.graph.pixels import GraphPicture
from day6_tui.windows.images.image_cells import on_ground
from day6_tui.windows.robot.car_pixels import CarPicture
from day6_tui.windows.rqt.plot_pixels import paint_plot
from day6_tui.windows.world.picture import FIRM, LINE, TRAIL, WALL, fitting, look_of
from day6_tui.windows.world.pixels import WorldPixels
from day6_urdf import parse_robot, shipped_model
from day6_urdf.kinematics import link_transforms
from day6_urdf.topview.paint import DARK, STANDING
from day6_urdf.topview.plan import plan_top

CELL = (10, 20)
CAR = plan_top(parse_robot(shipped_model()))
COLOURS = colours("dark")
TABLE = look_of(COLOURS)
WORLDS = {name: read_scenery(path) for name, path in shipped_worlds(SHARE_PATH / "day6_world").items()}


def places(pixels: Array, colour: int, near: int = 6) -> Array:
    """Row and column of the pixels of about a colour."""
    wanted = (colour >> 16 & 255, colour >> 8 & 255, colour & 255)
    return np.argwhere(np.abs(pixels.astype(int) - wanted).max(axis=2) <= near)


def test_edges_are_smooth() -> None:
    surface = Surface(40, 40, 0)
    surface.line([(2, 3), (38, 30)], 0xFFFFFF, 2)
    assert len(np.unique(surface.pixels())) > 3


def car(angle: float, known: bool = True) -> Array:
    transforms = link_transforms(CAR.robot, {"left_wheel_joint": angle, "right_wheel_joint": angle})
    picture = CarPicture(60, 20, CELL, COLOURS)
    return picture.pixels(picture.frame(CAR, 1.0, (0, 0)), transforms if known else {}, STANDING)


def test_the_cars_wheels_lie_above_and_below_its_body_and_turn() -> None:
    wheels = places(car(0.0), 0x4C4C4C)
    assert (wheels[:, 0] < 160).any() and (wheels[:, 0] > 240).any()
    marks = [places(car(angle), DARK.mark)[:, 1].mean() for angle in (-0.6, 0.0, 0.6)]
    assert marks[0] < marks[1] < marks[2]


def test_a_wheel_without_a_transform_has_the_colour_of_what_is_wrong() -> None:
    assert len(places(car(0.0, known=False), TABLE[FIRM])) > 500
    assert not len(places(car(0.0), TABLE[FIRM]))


@pytest.mark.parametrize("size", [(20, 6), (40, 10), (90, 40)])
def test_what_stands_beside_the_car_stays_in_the_window(size: tuple[int, int]) -> None:
    picture = CarPicture(*size, CELL, COLOURS)
    transforms = link_transforms(CAR.robot, {})
    frame = picture.frame(CAR, 1.0, (0, 0))
    labels = {f"{side}_wheel": (f"{side}_wheel", "7°") for side in ("left", "right")}
    pixels = picture.pixels(frame, transforms, STANDING)
    picture.sheet.put(picture.texts(frame, transforms, labels, pixels))
    words = "".join(segment.text for row in range(size[1]) for segment in picture.sheet.line(row))
    assert words.count("7°") == 2
    assert len(words) == size[0] * size[1]


def test_words_on_the_car_stand_on_its_colour_and_those_beside_it_on_the_panes() -> None:
    picture = CarPicture(60, 20, CELL, COLOURS)
    transforms = link_transforms(CAR.robot, {})
    frame = picture.frame(CAR, 1.0, (0, 0))
    pixels = picture.pixels(frame, transforms, STANDING)
    styles = {text: style for *_, text, style in picture.texts(frame, transforms, {}, pixels)}
    grounds = {word: background_of(style) for word, style in styles.items()}
    assert (
        rgb(grounds["0.30 m"]) == tuple(pixels[frame.height // 2, frame.width // 2]) != rgb(background_of(COLOURS.text))
    )
    assert grounds["0.30 m"] != grounds["base_link"], "a plate on the chassis has a colour of its own"
    assert styles["left_wheel"] == COLOURS.text and styles["|----------| 0.1 m"] == COLOURS.muted


@pytest.mark.parametrize("name", sorted(WORLDS))
def test_the_world_has_its_walls_and_line(name: str) -> None:
    scenery = WORLDS[name]
    view = fitting(scenery, 60, 30, "half")
    pixels = WorldPixels(view, CELL, scenery, TABLE, DARK, COLOURS.text).pixels(WorldSnapshot(scenery=scenery), Trail())
    assert bool(len(places(pixels, TABLE[WALL]))) == bool(scenery.solids)
    assert bool(len(places(pixels, TABLE[LINE]))) == bool(scenery.line)


def test_the_trail_grows_and_is_wiped() -> None:
    scenery, trail = WORLDS["walls"], Trail()
    shown = WorldPixels(fitting(scenery, 60, 30, "half"), CELL, scenery, TABLE, DARK, COLOURS.text)
    snapshot = replace(WorldSnapshot(scenery=scenery), robot=None)
    lengths = []
    for points in ([(-1.0, 0.0), (-0.5, 0.0)], [(0.0, 0.3)], [(0.5, 0.0)]):
        for point in points:
            trail.add(*point)
        lengths.append(len(places(shown.pixels(snapshot, trail), TABLE[TRAIL], near=60)))
    assert 0 < lengths[0] < lengths[1] < lengths[2]
    trail.clear()
    assert not len(places(shown.pixels(snapshot, trail), TABLE[TRAIL], near=60))


def test_a_curve_passes_through_its_values() -> None:
    pixels = paint_plot((200, 100), 0x101010, (0x303030, [50], [20]), [(0x56B4E9, [(0, 99), (100, 50), (199, 0)])])
    curve = places(pixels, 0x56B4E9, near=60)
    assert np.abs(curve[:, 0] - (99 - curve[:, 1] / 2)).max() < 3
    assert len(np.argwhere(pixels[:, 50, 0] > 0x18)) > 50  # the line of the grid


def test_an_image_lies_on_the_grid_of_cells_in_the_middle() -> None:
    image = np.full((100, 155, 3), 200, np.uint8)
    whole, corner = on_ground(image, (20, 10), CELL, 0x102030)
    assert whole.shape == (200, 200, 3) and corner == (2, 2)
    assert np.argwhere(whole[..., 0] == 200).min(axis=0).tolist() == [40, 20]
    assert np.argwhere(whole[..., 0] == 200).max(axis=0).tolist() == [139, 174]
    assert whole[0, 0].tolist() == [0x10, 0x20, 0x30]


def test_the_graph_has_every_name_as_text_and_its_boxes_around_them() -> None:
    boxes = [Box("/talker", ("/talker",), "node"), Box(" /chatter", ("/chatter",), "topic")]
    picture = unfitted(boxes, [Edge("/talker", " /chatter", "", "/chatter")])
    styles = {"node": COLOURS.node, "topic": COLOURS.topic, "edge": COLOURS.muted}
    graph = GraphPicture(60, 20, CELL, COLOURS.text, lambda name: styles.get(name, COLOURS.text))
    pixels = graph.pixels(picture, (3, 4), (), None, {})
    graph.sheet.put(graph.texts(picture, (), None))
    for box, rect in picture.boxes.values():
        (row,) = [row for row in range(20) if box.lines[0] in "".join(s.text for s in graph.sheet.line(row))]
        assert rect.y + 4 <= row < rect.y + 4 + rect.height
        colour = {"node": 0x6FC3F7, "topic": 0xF0B429}[box.shape]
        frame = places(pixels, colour, near=40)
        assert (rect.x + 3) * CELL[0] <= frame[:, 1].min() and frame[:, 1].max() < (rect.x + 3 + rect.width) * CELL[0]


def test_texts_that_would_touch_are_left_out_and_changes_are_told() -> None:
    style = Style.parse("red on blue")
    sheet = Sheet(20, 3, Style())
    assert sheet.put([(2, 1, "中文", style), (4, 1, "no", style), (10, 1, "yes", style), (18, 0, "out", style)]) == [1]
    assert "".join(segment.text for segment in sheet.line(1)) == "  中文    yes       "
    assert [tuple(hole) for hole in sheet.holes] == [(2, 1, 4, 1), (10, 1, 3, 1)]
    assert sheet.put([(10, 1, "yes", style)]) == [1] and sheet.put([(10, 1, "yes", style)]) == []
