"""The 3-D pictures: few goldens of pixels, and what must be true of every picture."""

from __future__ import annotations

import math
import os
import struct
import zlib
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from day6_core.ros.programs.rviz2.model.meshes import MeshData
from day6_core.ros.programs.rviz2.model.robot_parts import read_robot
from day6_core.ros.programs.rviz2.model.scene import (
    BOX,
    CONE,
    CYLINDER,
    SPHERE,
    Image,
    Label,
    Lines,
    Points,
    Scene,
    Shape,
    Triangles,
)
from day6_core.ros.programs.rviz2.model.views import Camera, Orbit, TopDownOrtho
from day6_tui.appearance.colours import colours
from day6_tui.render.cells import cells_of, pixel_aspect
from day6_tui.render.image_file import png, svg
from day6_tui.render.painter import QUALITIES, paint
from day6_tui.render.picture import EMPTY, RenderedPicture
from day6_tui.windows.rviz.pixels import PixelView
from day6_urdf import shipped_model
from day6_urdf.kinematics import IDENTITY, Transform, about, compose, link_transforms

GOLDEN = Path(__file__).parent / "golden"
HIGH = QUALITIES["High"]
RED, GREEN, BLUE = (1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 0.0, 1.0), (0.0, 0.0, 1.0, 1.0)


def orbit(distance: float = 5.0, yaw: float = 0.7854, pitch: float = 0.7854) -> Camera:
    view = Orbit(list, lambda: None)
    view.child("Distance").value, view.child("Yaw").value, view.child("Pitch").value = distance, yaw, pitch
    return view.camera()


def scene(*things: object) -> Scene:
    made = Scene()
    for thing in things:
        {Shape: made.shapes, Lines: made.lines, Points: made.points, Triangles: made.triangles, Image: made.images}[
            type(thing)
        ].append(thing)  # type: ignore[attr-defined]
    return made


def shape(kind: str, size: tuple[float, float, float] = (1, 1, 1), pose: Transform = IDENTITY, colour=RED) -> Shape:
    return Shape(kind, pose, size, colour)


def painted(*things: object, camera: Camera | None = None, width: int = 60, height: int = 60) -> RenderedPicture:
    return paint(scene(*things), camera or orbit(), width, height, 1.0, HIGH)


def car_scene(angle: float) -> Scene:
    """The shipped car with its wheels turned, on a grid."""
    parts = read_robot(shipped_model().read_text(encoding="utf-8"), lambda uri: MeshData([], []))
    assert parts.robot is not None
    poses = link_transforms(parts.robot, {"left_wheel_joint": angle, "right_wheel_joint": angle})
    made = Scene()
    for name, link in parts.links.items():
        for part in link.visual:
            place = compose(poses[name], part.pose)
            made.shapes.append(Shape(part.kind, place, part.size, part.colour, name, part.wheel))
    ends = [(x, y, 0.0) for x in (-1.0, 0.0, 1.0) for y in (-1.0, 1.0)]
    made.lines.append(Lines([*ends, *((y, x, z) for x, y, z in ends)], [(0.6, 0.6, 0.6, 0.5)]))
    return made


# -- goldens -----------------------------------------------------------------------------------------------------------


def compare(name: str, picture: RenderedPicture) -> None:
    """Compare with golden/<name>.txt, in which a letter stands for a colour; a pixel on an edge may differ."""
    file = GOLDEN / f"{name}.txt"
    rgb = picture.rgb(32)
    if os.environ.get("DAY6_UPDATE_GOLDEN"):
        colours = {int(colour): chr(ord("A") + index) for index, colour in enumerate(np.unique(rgb))}
        rows = ["".join(colours[int(colour)] for colour in row) for row in rgb]
        legend = [f"{letter} {colour:06x}" for colour, letter in colours.items()]
        file.write_text("\n".join([*rows, "", *legend, ""]), encoding="utf-8")
    rows, _, legend = file.read_text(encoding="utf-8").partition("\n\n")
    table = {line[0]: int(line[2:], 16) for line in legend.splitlines()}
    expected = np.array([[table[letter] for letter in row] for row in rows.splitlines()])
    assert expected.shape == rgb.shape
    channels = np.stack([np.abs((expected >> shift & 255) - (rgb.astype(int) >> shift & 255)) for shift in (16, 8, 0)])
    assert (channels.max(axis=0) > 40).mean() < 0.01, f"another picture than {file.name}"


def test_the_car_looks_as_it_did() -> None:
    compare("car", paint(car_scene(0.0), orbit(0.85), 72, 56, 1.0, HIGH))


def test_the_car_from_straight_above_looks_as_it_did() -> None:
    view = TopDownOrtho(list, lambda: None)
    view.child("Scale").value = 1000.0
    compare("car_above", paint(car_scene(0.6), view.camera(), 60, 48, 1.0, HIGH))


def test_the_four_solids_look_as_they_did() -> None:
    solids = [
        shape(BOX, pose=Transform((1, 0, 0))),
        shape(CYLINDER, pose=Transform((-1, 0, 0)), colour=GREEN),
        shape(SPHERE, pose=Transform((0, 1, 0)), colour=BLUE),
        shape(CONE, pose=Transform((0, -1, 0)), colour=(1.0, 1.0, 0.0, 1.0)),
    ]
    compare("solids", painted(*solids, width=64, height=48))


# -- what must be true -------------------------------------------------------------------------------------------------


def test_a_ball_is_round_and_as_large_as_it_should_be() -> None:
    picture = painted(shape(SPHERE, (2, 2, 2)), camera=orbit(10.0), width=100, height=100)
    covered = picture.kind != EMPTY
    assert covered.any(axis=0).sum() == covered.any(axis=1).sum()
    seen = 100 / (2 * math.tan(math.radians(22.5))) * math.tan(math.asin(1 / 10)) * 2
    assert covered.any(axis=0).sum() == pytest.approx(seen, abs=1.5)


@pytest.mark.parametrize("kind", [BOX, CYLINDER, CONE])
def test_solids_have_the_depth_of_their_nearest_point(kind: str) -> None:
    # Seen along -x from 5 m: the front is half a metre nearer than the middle (a cone's side not at its foot's height).
    picture = painted(shape(kind), camera=orbit(5.0, 0.0, 0.0))
    assert picture.depth.min() == pytest.approx(4.5, abs=0.02)


def test_what_is_in_front_hides_what_is_behind() -> None:
    near, far = Transform((2, 0, 0)), Transform((-2, 0, 0))
    camera = orbit(8.0, 0.0, 0.0)
    for shapes in (
        (shape(BOX, pose=near), shape(BOX, pose=far, colour=GREEN)),
        (shape(BOX, pose=far, colour=GREEN), shape(BOX, pose=near)),
    ):
        picture = painted(*shapes, camera=camera)
        red, green, _ = picture.colour[30, 30]
        assert red > 0.4 and green < 0.1


def test_a_transparent_solid_lets_through_what_is_behind() -> None:
    veil = shape(BOX, pose=Transform((2, 0, 0)), colour=(1.0, 0.0, 0.0, 0.5))
    picture = painted(veil, shape(BOX, pose=Transform((-2, 0, 0)), colour=GREEN), camera=orbit(8.0, 0.0, 0.0))
    red, green, _ = picture.colour[30, 30]
    assert red > 0.2 and green > 0.2


def test_a_turning_wheel_changes_the_picture() -> None:
    pictures = [paint(car_scene(angle), orbit(0.85), 72, 56, 1.0, HIGH).rgb() for angle in (0.0, 0.2, 0.4)]
    assert all((a != b).sum() > 5 for a, b in pairwise(pictures))


def test_lines_are_whole_and_cut_at_the_viewer() -> None:
    line = Lines([(-100.0, 0.0, 0.0), (100.0, 0.0, 0.0)], [RED])  # passes through beside the viewer
    picture = painted(line, camera=orbit(5.0, 0.0, 0.5))
    column = picture.kind[:, 30] != EMPTY
    first, last = np.flatnonzero(column)[[0, -1]]
    assert column[first : last + 1].all() and last == 59
    behind = painted(Lines([(10.0, 0.0, 20.0), (11.0, 0.0, 20.0)], [RED]))
    assert (behind.kind == EMPTY).all()


def test_a_line_behind_a_box_is_hidden_and_one_on_it_is_seen() -> None:
    camera = orbit(8.0, 0.0, 0.0)
    hidden = painted(shape(BOX), Lines([(-2.0, -0.3, 0.0), (-2.0, 0.3, 0.0)], [GREEN]), camera=camera)
    assert not (hidden.colour[..., 1] > 0.5).any()
    seen = painted(shape(BOX), Lines([(0.5, -0.3, 0.0), (0.5, 0.3, 0.0)], [GREEN]), camera=camera)
    assert (seen.colour[..., 1] > 0.5).sum() >= 4


def test_points_are_where_they_are() -> None:
    picture = painted(Points([(0.0, 0.0, 0.0), (0.0, 0.0, math.nan)], [GREEN]))
    assert np.argwhere(picture.kind != EMPTY).tolist() in ([[30, 30]], [[29, 29]], [[29, 30]], [[30, 29]])


def _cube_mesh(size: float = 1.0) -> MeshData:
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float32) * size / 2
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
    return MeshData(corners, np.array(faces))


def test_a_mesh_of_a_cube_covers_what_a_box_covers() -> None:
    mesh = _cube_mesh()
    box = painted(shape(BOX))
    triangles = painted(Triangles(mesh.vertices, mesh.faces, IDENTITY, (1, 1, 1), RED))
    assert ((box.kind != EMPTY) != (triangles.kind != EMPTY)).mean() < 0.01
    both = (box.kind != EMPTY) & (triangles.kind != EMPTY)
    assert np.abs(box.depth - triangles.depth)[both].max() < 0.05
    assert np.abs(box.colour - triangles.colour)[both].mean() < 0.02


def test_a_map_lies_on_the_ground() -> None:
    pixels = np.zeros((2, 2, 4), np.uint8)
    pixels[..., 3] = 255
    pixels[0, 0] = (255, 0, 0, 255)  # the corner at the origin
    view = TopDownOrtho(list, lambda: None)
    view.child("Scale").value = 200.0  # three metres high
    picture = paint(scene(Image(pixels, IDENTITY, 1.0)), view.camera(), 60, 60, 1.0, HIGH)
    assert picture.colour[25, 35].tolist() == [1.0, 0.0, 0.0]  # right of and above the middle
    assert picture.colour[5, 55].tolist() == [0.0, 0.0, 0.0]
    assert picture.kind[35, 25] == EMPTY


@pytest.mark.parametrize(
    "size", [(math.nan, 1, 1), (math.inf, 1, 1), (0, 0, 0), (1e30, 1e30, 1e30), (-1, 1, 1), (1e-30, 1, 1)]
)
@pytest.mark.parametrize("kind", [BOX, CYLINDER, SPHERE, CONE])
def test_sizes_that_make_no_sense_do_no_harm(kind: str, size: tuple[float, float, float]) -> None:
    picture = painted(shape(kind, size), shape(BOX, colour=GREEN))
    assert np.isfinite(picture.colour).all()


def test_inside_a_box_its_inner_sides_are_seen() -> None:
    picture = painted(shape(BOX, (20, 20, 20)))
    assert (picture.kind != EMPTY).all()


def test_every_quality_shows_the_same_thing() -> None:
    covered = []
    for quality in QUALITIES.values():
        picture = paint(car_scene(0.0), orbit(0.85), 72, 56, 1.0, quality)
        assert picture.colour.shape == (56, 72, 3)
        covered.append((picture.kind != EMPTY).mean())
    assert max(covered) - min(covered) < 0.03


@pytest.mark.parametrize("mode", ["half", "braille", "cell", "ascii"])
@pytest.mark.parametrize("colourless", [False, True])
def test_every_set_of_characters_shows_the_robot_in_its_place(mode: str, colourless: bool) -> None:
    from day6_tui.panes.canvas import PIXELS_PER_CELL

    across, down = PIXELS_PER_CELL[mode]
    picture = paint(car_scene(0.0), orbit(0.85), 40 * across, 20 * down, pixel_aspect(mode), HIGH)
    cells = cells_of(picture, mode, colourless=colourless)
    assert cells.size == (40, 20)
    ground = (cells.chars[0, 20], cells.front[0, 20], cells.back[0, 20])
    differs = np.array(
        [[(cells.chars[y, x], cells.front[y, x], cells.back[y, x]) != ground for x in range(40)] for y in range(20)]
    )
    if mode == "cell" and colourless:
        return  # coloured spaces without colour: the desktop never chooses that
    assert differs[10, 20] and differs[8:12, 15:25].mean() > 0.8 and not differs[0, 20]
    for row in range(20):
        assert sum(len(segment.text) for segment in cells.line(row)) == 40
    assert cells.changes(None) == list(range(20)) and cells.changes(cells) == []


def test_names_stand_over_the_picture() -> None:
    made = Scene()
    made.labels.append(Label("base_link", (0.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0)))
    picture = paint(made, orbit(), 40, 40, 1.0, HIGH)
    cells = cells_of(picture, "half")
    text = "".join(segment.text for segment in cells.line(10))
    assert text.strip() == "base_link" and len(text) == 40


def test_names_of_frames_in_one_place_stand_below_and_above_each_other() -> None:
    made = Scene()
    names = ("base_link", "caster", "laser", "camera", "imu", "one_too_many")
    for name in names:
        made.labels.append(Label(name, (0.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0)))
    cells = cells_of(paint(made, orbit(), 40, 40, 1.0, HIGH), "half")
    lines = ["".join(segment.text for segment in cells.line(row)).strip() for row in range(8, 13)]
    assert lines == ["imu", "laser", "base_link", "caster", "camera"]


def test_a_png_holds_the_pixels() -> None:
    rgb = np.array([[0xFF0000, 0x00FF00], [0x0000FF, 0x123456]])
    data = png(rgb)
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", data[16:24])
    assert (width, height) == (2, 2)
    start = data.index(b"IDAT") + 4
    length = struct.unpack(">I", data[start - 8 : start - 4])[0]
    raw = zlib.decompress(data[start : start + length])
    assert raw == bytes([0, 255, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0x12, 0x34, 0x56])


def test_an_svg_has_a_rectangle_for_every_run() -> None:
    text = svg(np.array([[1, 1, 2, 2], [1, 1, 1, 3]]))
    assert text.count("<rect") == 3 and 'fill="#000001"' in text and 'x="2" y="0" width="2"' in text


def test_rotation_about_the_vertical_turns_the_picture_of_a_box() -> None:
    turned = Transform((0, 0, 0), about((0, 0, 1), 0.5))
    assert (painted(shape(BOX)).rgb() != painted(shape(BOX, pose=turned)).rgb()).sum() > 50


def test_an_offset_of_a_whole_pixel_moves_the_picture_by_one() -> None:
    whole = paint(car_scene(0.3), orbit(0.85), 72, 56, 1.0, HIGH).rgb(1)
    moved = paint(car_scene(0.3), orbit(0.85), 72, 56, 1.0, HIGH, (1.0, 2.0)).rgb(1)
    assert (moved[2:, 1:] == whole[:-2, :-1]).mean() > 0.99


def test_real_pixels_are_quick_while_the_robot_moves_and_smooth_once_it_stands_still() -> None:
    look = SimpleNamespace(colours=colours("dark"))
    view = SimpleNamespace(camera=lambda: orbit(0.85))
    rviz = SimpleNamespace(scene=car_scene(0.0), view=view, quality=SimpleNamespace(value="High"))
    pictures = SimpleNamespace(cell=lambda columns, rows, most: (4, 8) if most < 200_000 else (8, 16))
    shown = PixelView(rviz, look, 20, 8)  # type: ignore[arg-type]
    shown.draft(pictures, 1.0)  # type: ignore[arg-type]
    quick = len(np.unique(shown.pixels.reshape(-1, 3), axis=0))
    assert shown.pixels.shape == (64, 80, 3)
    assert shown.smooth(pictures, 1.1) == (False, True)  # type: ignore[arg-type]
    told = [shown.smooth(pictures, 2.0) for _ in range(5)]  # type: ignore[arg-type]
    assert told == [(False, True)] * 3 + [(True, False), (False, False)]
    smooth = shown.pixels
    assert smooth.shape == (128, 160, 3) and len(np.unique(smooth.reshape(-1, 3), axis=0)) > quick
    shown.draft(pictures, 3.0)  # type: ignore[arg-type]
    assert shown.pixels is smooth  # a message said the same again
    rviz.scene = car_scene(0.5)
    shown.draft(pictures, 4.0)  # type: ignore[arg-type]
    assert shown.pixels.shape == (64, 80, 3)
