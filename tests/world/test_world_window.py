"""The world's window: everything to scale and in its place, for every set of characters, with few lines drawn again."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest
from textual.geometry import Size

from day6_core.ros.environment import SHARE_PATH
from day6_core.ros.programs.day6_world._admission import status
from day6_core.ros.programs.day6_world.model import Scan, Trail, WorldModel, WorldSnapshot
from day6_core.ros.programs.day6_world.scenery import read_scenery, shipped_worlds
from day6_core.ros.remark_texts import TEXTS
from day6_core.session.display import Display
from day6_tui.app import make_look
from day6_tui.locale import catalogue
from day6_tui.options import Options
from day6_tui.panes.cells import cell_len
from day6_tui.windows.world import picture
from day6_tui.windows.world.world import WorldPane
from day6_urdf import parse_robot, shipped_model

UTF8 = {"LANG": "C.UTF-8", "TERM": "xterm-256color", "COLORTERM": "truecolor"}
CAR = parse_robot(shipped_model("day6_bot_gazebo"))
WORLDS = {name: read_scenery(path) for name, path in shipped_worlds(SHARE_PATH / "day6_world").items()}


def model_of(world: str = "walls", **fields: Any) -> WorldModel:
    model = WorldModel()
    model.show(replace(WorldSnapshot(version=1, scenery=WORLDS[world], robot=CAR, pose=(-2.2, 0.0, 0.0)), **fields))
    return model


def pane_of(model: WorldModel, width: int = 80, height: int = 30, **options: Any) -> WorldPane:
    window = Display().open("world", "world", model)
    pane = WorldPane(window, make_look(Options(**options), UTF8))
    pane.extent = Size(width, height)
    pane.touch = lambda: None  # type: ignore[method-assign]
    pane.touched = []  # type: ignore[attr-defined]
    pane.redraw_lines = lambda lines: pane.touched.extend(lines)  # type: ignore[method-assign, attr-defined]
    pane.touch_status = lambda: None  # type: ignore[method-assign]
    return pane


def text_of(pane: WorldPane) -> list[str]:
    pane.pull(1e9)
    lines = [
        "".join(segment.text for segment in pane.content_line(y, pane.inner_width)) for y in range(pane.inner_height)
    ]
    assert all(cell_len(line) <= pane.inner_width for line in lines)
    return lines


def kinds_of(pane: WorldPane) -> dict[int, list[tuple[int, int]]]:
    """Where the pixels of each kind are: (column, row)."""
    pane.pull(1e9)
    found: dict[int, list[tuple[int, int]]] = {}
    for y, row in enumerate(pane._rows):
        for x, kind in enumerate(row):
            found.setdefault(kind, []).append((x, y))
    return found


@pytest.mark.parametrize("glyphs", ["half", "braille", "cell", "ascii"])
@pytest.mark.parametrize("world", sorted(WORLDS))
def test_every_world_is_drawn_with_every_set_of_characters(glyphs: str, world: str) -> None:
    pane = pane_of(model_of(world, pose=WORLDS[world].start), glyphs=glyphs)
    text = "\n".join(text_of(pane))
    kinds = kinds_of(pane)
    assert picture.CHASSIS in kinds and (picture.LINE in kinds) == (world == "line")
    assert (picture.WALL in kinds) == (world != "empty")
    if glyphs == "ascii":
        assert text.isascii()


def test_the_car_is_as_large_as_it_is() -> None:
    pane = pane_of(model_of("empty", pose=(0.0, 0.0, 0.0)), 122, 62, glyphs="half")
    spots = kinds_of(pane)[picture.CHASSIS]
    view = pane._view
    assert view is not None
    length = (max(x for x, _ in spots) - min(x for x, _ in spots) + 1) * view.scale
    width = (max(y for _, y in spots) - min(y for _, y in spots) + 1) * view.scale_y
    assert length == pytest.approx(0.4, abs=2 * view.scale) and width == pytest.approx(0.25, abs=2 * view.scale)


@pytest.mark.parametrize("yaw", [0.0, 1.0, math.pi / 2, 2.5, -2.0])
def test_the_nose_is_where_it_drives_to(yaw: float) -> None:
    pane = pane_of(model_of("empty", pose=(0.0, 0.0, yaw)), 122, 62, glyphs="half")
    for _ in range(6):
        pane._press("plus", "+")
    kinds = kinds_of(pane)
    nose, body = kinds[picture.NOSE], kinds[picture.CHASSIS]

    def middle(spots: list[tuple[int, int]]) -> tuple[float, float]:
        return sum(x for x, _ in spots) / len(spots), sum(y for _, y in spots) / len(spots)

    (nx, ny), (bx, by) = middle(nose), middle(body)
    assert math.remainder(math.atan2(by - ny, nx - bx) - yaw, 2 * math.pi) == pytest.approx(0, abs=0.25)


def test_in_ascii_the_nose_is_an_arrow() -> None:
    for yaw, arrow in ((0.0, ">"), (math.pi / 2, "^"), (math.pi, "<"), (-math.pi / 2, "v")):
        text = "".join(text_of(pane_of(model_of("empty", pose=(0.0, 0.0, yaw)), 120, 40, glyphs="ascii")))
        assert arrow in text


@pytest.mark.parametrize("size", [(40, 14), (60, 38), (120, 40)])
def test_the_line_has_no_gaps_however_small_it_is_drawn(size: tuple[int, int]) -> None:
    pane = pane_of(model_of("line", robot=None), *size, glyphs="half")
    spots = set(kinds_of(pane)[picture.LINE])
    reached, waiting = set(), [next(iter(spots))]
    while waiting:
        x, y = waiting.pop()
        if (x, y) in spots and (x, y) not in reached:
            reached.add((x, y))
            waiting += [(x + dx, y + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
    assert reached == spots


def test_the_trail_stays_behind_the_car() -> None:
    model = model_of("empty", pose=(1.0, 0.0, 0.0))
    for step in range(60):
        model.trail.add(-2 + step * 0.05, 0.0)
    trail = kinds_of(pane_of(model, 100, 30, glyphs="half"))[picture.TRAIL]
    assert len({x for x, _ in trail}) > 20 and len({y for _, y in trail}) == 1


def test_a_long_trail_stays_bounded_and_whole() -> None:
    trail = Trail()
    for step in range(20_000):
        trail.add(step * 0.03, 0.0)
    assert len(trail.points) <= 4000 and trail.points[0] == (0.0, 0.0) and trail.generation > 0


def test_rays_end_at_what_they_hit() -> None:
    scan = Scan(-2.2, 0.0, 0.0, math.pi / 2, (1.0, math.inf, 0.5, 0.8))
    kinds = kinds_of(pane_of(model_of(scan=scan), glyphs="half"))
    assert len(kinds[picture.HIT]) == 3


def test_a_new_scan_and_a_new_spot_of_the_trail_are_seen_under_a_car_that_stands() -> None:
    model = model_of("empty", pose=(2.0, 0.0, 0.0), scan=Scan(-2.2, 0.0, 0.0, math.pi / 2, (1.0,)))
    pane = pane_of(model, glyphs="half")
    first = kinds_of(pane)
    model.trail.add(-1.0, -1.0)
    model.show(replace(model.snapshot(), version=2))
    pane.pull(2e9)
    second = kinds_of(pane)
    assert picture.TRAIL not in first and len(second[picture.TRAIL]) == 1 and second[picture.HIT] == first[picture.HIT]
    model.show(replace(model.snapshot(), version=3, scan=Scan(-2.2, 0.0, 0.0, math.pi / 2, (1.5,))))
    pane.pull(3e9)
    assert kinds_of(pane)[picture.HIT] != first[picture.HIT]
    model.show(replace(model.snapshot(), version=4, scan=None))
    pane.pull(4e9)
    assert picture.HIT not in kinds_of(pane)


def test_only_the_lines_of_the_car_are_drawn_again_when_it_moves() -> None:
    model = model_of("walls", pose=(-1.0, 0.0, 0.0))
    pane = pane_of(model, 120, 40, glyphs="half")
    pane.pull(1.0)
    pane.touched.clear()  # type: ignore[attr-defined]
    model.show(replace(model.snapshot(), version=2, pose=(-0.95, 0.0, 0.0)))
    pane.pull(2.0)
    assert 0 < len(pane.touched) <= 6  # type: ignore[attr-defined]


def test_the_same_moment_is_drawn_once() -> None:
    pane = pane_of(model_of())
    assert pane.pull(1.0) is False
    rows = pane._rows
    assert pane.pull(2.0) is False and pane._rows is rows


def test_followed_the_car_stays_in_the_picture_and_unfollowed_too() -> None:
    for keys in ("", "f", "++++", "f++++++"):
        pane = pane_of(model := model_of("empty"), 60, 20, glyphs="half")
        pane.pull(1.0)
        for key in keys:
            pane._press(key, key)
        for step in range(40):
            pose = (step * 0.5, step * -0.3, 0.1)
            model.show(replace(model.snapshot(), version=step + 2, pose=pose))
            pane.pull(2.0 + step)
            assert pane._view is not None and pane._view.holds(*pose[:2], 0.0)


def test_keys_zoom_pan_and_make_requests() -> None:
    model = model_of()
    pane = pane_of(model)
    pane.pull(1.0)
    assert pane._view is not None
    before = pane._view.scale
    pane._press("plus", "+")
    assert pane._view.scale < before
    pane._press("right", "")
    assert not pane._follow
    pane._press("0", "0")
    pane.pull(2.0)
    for key, character in (("space", " "), ("n", "n"), ("right_square_bracket", "]"), ("r", "r"), ("t", "t")):
        assert pane._press(key, character)
    assert model.take_requests() == ["pause", "step", "faster", "reset", "clear"]
    assert not pane._press("x", "x")
    pane._press("l", "l")
    assert model.wants_rays


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_everything_the_world_says_fits_under_the_picture(lang: str) -> None:
    values: Any = dict.fromkeys(
        ["robot", "text", "links", "link", "mass", "topic", "type", "wanted", "stamped", "nodes"], "/joint_states"
    )
    for key in (key for key in TEXTS if key.startswith("world.")):
        line = status("error", key, **values, x=1.0, y=2.0)
        lines = text_of(pane_of(model_of(status=(line,)), 50, 20, lang=lang))
        said = catalogue(lang)[key].format(**dict(line.parameters))
        assert said.split()[0][:4] in "".join(lines)


def test_any_size_can_be_drawn() -> None:
    for width in (12, 20, 41, 80, 200):
        for height in (3, 5, 12, 60):
            for glyphs in ("half", "ascii"):
                text_of(pane_of(model_of("maze"), width, height, glyphs=glyphs))


def test_a_window_that_opens_before_its_world_is_read_is_empty_and_takes_keys() -> None:
    pane = pane_of(WorldModel())
    assert text_of(pane) == [""] * pane.inner_height
    pane.restyle()
    pane.title()
    pane.status()
    pane.status_right()


def test_the_frame_tells_the_world_s_seconds_and_how_fast_they_really_pass() -> None:
    model = model_of(seconds=12.34, speed=1.0, real_time_factor=1.984)
    pane = pane_of(model, lang="en")
    text_of(pane)
    assert [piece.text for piece in pane.status_right()] == [" 12.3 s  RTF 1.98 "]
    heads: list[None] = []
    pane.touch_status = lambda: heads.append(None)  # type: ignore[method-assign]
    model.is_held = lambda: True
    pane.pull(2e9)
    assert heads, "a pause of the whole desktop brings no new snapshot, but the frame has to tell it"
    assert [piece.text for piece in pane.status_right()] == [" 12.3 s  paused "]
