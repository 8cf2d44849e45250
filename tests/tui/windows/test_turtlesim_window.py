"""The TurtleSim window: a square world, a turtle with a front at every size, and few cells drawn again."""

from __future__ import annotations

import itertools
import math
from itertools import product
from types import SimpleNamespace

import pytest
from textual.geometry import Size

from day6_core.ros.programs.turtlesim.model import TurtleTopics
from day6_core.session.display import Display
from day6_tui.appearance.colours import colours
from day6_tui.options import Options
from day6_tui.panes.canvas import PixelCanvas, square
from day6_tui.panes.cells import cell_len
from day6_tui.windows.turtlesim.shapes import COATS, HEADINGS, characters, heading_step, pixels
from day6_tui.windows.turtlesim.turtlesim import TurtleSimPane, _shrink
from tests.support.folded import folded
from tests.tui.fakes import FakeSimulation, turtle
from tests.tui.screens import UTF8, make_look, opened, screen_text, step

SECONDS = itertools.count(1.0)

SIZES = [(10, 5), (58, 29), (120, 60)]


@pytest.mark.parametrize(
    ("room", "shape"), [((78, 11), (22, 11)), ((58, 36), (58, 29)), ((10, 3), (6, 3)), ((1, 1), (2, 1))]
)
def test_the_world_is_as_wide_as_high(room, shape) -> None:
    assert square(*room) == shape or room == (1, 1)


@folded("size, step_", product([3, 5, 7, 9, 15, 24], range(0, HEADINGS, 4)))
def test_the_head_of_a_turtle_points_where_it_looks(size, step_) -> None:
    heads = [(dx, dy) for dx, dy, part in pixels(size, step_) if part == 3]
    assert heads
    angle = 2 * math.pi * step_ / HEADINGS
    x, y = sum(dx for dx, _ in heads) / len(heads), -sum(dy for _, dy in heads) / len(heads)
    assert math.cos(math.atan2(y, x) - angle) > 0.9


def test_without_pixels_a_neck_shows_the_heading() -> None:
    assert characters(heading_step(0.0), "@") == ((0, 0, "@"), (1, 0, "-"))
    assert characters(heading_step(math.pi / 2), "@") == ((0, 0, "@"), (0, -1, "|"))
    assert characters(heading_step(-3 * math.pi / 4), "1")[1] == (-1, 1, "/")


def test_an_undefined_heading_is_drawn_somehow() -> None:
    assert heading_step(math.nan) == 0 and heading_step(math.inf) == 0


def _pane(simulation: FakeSimulation, width: int, height: int, **options: object) -> TurtleSimPane:
    window = Display().open("turtlesim", "TurtleSim", simulation)
    pane = TurtleSimPane(window, make_look(Options(**options), UTF8))
    pane.extent = Size(width, height)
    return pane


def _touched(pane: TurtleSimPane) -> set[int]:
    """The lines that are drawn again."""
    lines: set[int] = set()
    pane.redraw_lines = lines.update  # type: ignore[method-assign, assignment]
    pane.touch_frame = lambda: None  # type: ignore[method-assign]
    pane.touch = lambda: None  # type: ignore[method-assign]
    pane.pull(next(SECONDS))
    return lines


def test_a_turtle_that_stands_still_is_not_drawn_again() -> None:
    pane = _pane(FakeSimulation(), 60, 38)
    _touched(pane)
    assert _touched(pane) == set()


def test_a_step_of_the_turtle_touches_only_the_lines_around_it() -> None:
    simulation = FakeSimulation(turtle(x=5.5))
    pane = _pane(simulation, 60, 31)
    _touched(pane)
    simulation.show(turtle(x=5.8))
    lines = _touched(pane)
    assert lines and all(10 < line < 20 for line in lines)


def test_less_than_a_pixel_and_less_than_a_direction_touches_nothing() -> None:
    simulation = FakeSimulation(turtle(x=5.50))
    pane = _pane(simulation, 60, 31)
    _touched(pane)
    simulation.show(turtle(x=5.501, theta=0.001))
    assert _touched(pane) == set()


@pytest.mark.parametrize("mode", ["half", "braille", "cell", "ascii"])
@pytest.mark.parametrize("size", SIZES)
def test_drawing_along_gives_the_same_picture_as_drawing_all_at_once(mode, size) -> None:
    """What a window that was open shows and one opened later shows is the same trail."""
    simulation, along = FakeSimulation(), _pane(FakeSimulation(), 2, 2)
    along.model = simulation
    canvas = PixelCanvas(*size, mode, 0x4556FF)
    along._canvas = canvas
    along._generation, along._drawn = 0, 0
    point = (250.0, 250.0)
    for n in range(60):
        following = (250 + 3 * n * math.cos(n / 7), 250 + 3 * n * math.sin(n / 7))
        simulation.trail.draw_line(*point, *following, 0xFF0000 if n % 20 else 0x00FF00, 1 + n % 9)
        point = following
        along._up_to_date(simulation.scene, simulation.trail)
    late = PixelCanvas(*size, mode, 0x4556FF)
    _shrink(simulation.trail.pixels, late, range(late.width), range(late.height))
    assert along._canvas is canvas and canvas.base == late.base


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("width", [1, 3])
def test_a_thin_line_is_unbroken_and_thin(size, width) -> None:
    simulation = FakeSimulation()
    simulation.trail.draw_line(20, 30, 480, 377, 0xFF0000, width)
    canvas = PixelCanvas(*size, "half", 0)
    _shrink(simulation.trail.pixels, canvas, range(canvas.width), range(canvas.height))
    columns = [[y for y in range(canvas.height) if canvas.pixel(x, y)] for x in range(canvas.width)]
    inked = [x for x, column in enumerate(columns) if column]
    assert inked == list(range(inked[0], inked[-1] + 1))
    assert max(len(column) for column in columns) <= 3
    for left, right in zip(columns[inked[0] : inked[-1]], columns[inked[0] + 1 : inked[-1] + 1], strict=True):
        assert min(abs(a - b) for a in left for b in right) <= 1


def test_cleared_trails_and_a_new_background_are_drawn() -> None:
    simulation = FakeSimulation()
    simulation.trail.draw_line(0, 250, 499, 250, 0xFF0000, 9)
    pane = _pane(simulation, 60, 31)
    _touched(pane)
    assert any(pixel == 0xFF0000 for pixel in pane._canvas.base)
    simulation.trail.clear()
    assert _touched(pane)
    assert set(pane._canvas.base) == {0x4556FF}
    simulation.background = (10, 20, 30)
    simulation.show(turtle())
    _touched(pane)
    assert set(pane._canvas.base) == {0x0A141E}


def test_turtles_keep_their_coat_and_differ_from_each_other() -> None:
    simulation = FakeSimulation(turtle("turtle1"), turtle("turtle2", 2.0))
    pane = _pane(simulation, 60, 31)
    _touched(pane)
    first = dict(pane._coats)
    simulation.show(turtle("turtle2", 2.0), turtle("zoe", 9.0))
    _touched(pane)
    assert pane._coats["turtle2"] == first["turtle2"] != first["turtle1"]
    assert pane._coats["zoe"] != pane._coats["turtle2"]


def test_more_turtles_than_coats_are_drawn_too() -> None:
    simulation = FakeSimulation(*[turtle(f"t{n}", 0.5 * n, 0.5 * n) for n in range(len(COATS) + 5)])
    pane = _pane(simulation, 60, 31)
    _touched(pane)
    assert len(pane._coats) == len(COATS) + 5


@pytest.mark.parametrize("place", [(-5.0, 3.0), (11.08, 11.08), (0.0, 0.0), (math.nan, 2.0), (1e30, -1e30)])
def test_a_turtle_at_or_beyond_the_edge_is_still_drawn(place) -> None:
    pane = _pane(FakeSimulation(turtle(x=place[0], y=place[1])), 60, 31)
    _touched(pane)
    assert pane._canvas.sprites


def test_without_colour_trail_and_turtle_are_still_there() -> None:
    canvas = PixelCanvas(10, 5, "half", 0x4556FF, colourless=True)
    canvas.set_base(2, 2, 0xFF0000)
    canvas.set_sprites({5 * 10 + 4: 0x00FF00})
    text = "\n".join("".join(segment.text for segment in canvas.line(row)) for row in range(5))
    assert text.count("▀") + text.count("▄") == 2
    assert all(segment.style.color is None for segment in canvas.line(1))


def test_braille_has_eight_dots_to_a_cell() -> None:
    canvas = PixelCanvas(2, 1, "braille", 0)
    canvas.set_base(0, 0, 0xFFFFFF)
    canvas.set_base(1, 3, 0xFFFFFF)
    assert "".join(segment.text for segment in canvas.line(0)) == "\u2881 "


def test_equal_colours_share_one_style_object() -> None:
    canvas = PixelCanvas(4, 1, "half", 0x123456)
    canvas.set_base(1, 0, 0xFF0000)
    canvas.set_base(3, 0, 0xFF0000)
    styles = [segment.style for segment in canvas.line(0)]
    assert len(styles) == 4 and styles[1] is styles[3] and styles[0] is styles[2]


async def test_the_window_closes_and_gives_the_keyboard_back(desk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    interrupted = []
    window.on_close = lambda: interrupted.append(True)
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        await step(app, pilot)
        app.desktop.focus_pane(app.desktop.panes[window.number])
        await pilot.pause()
        app.actions["close"]()
        await step(app, pilot)
        assert interrupted == [True]
        assert app.desktop.panes == {} and app.screen.focused is app.terminals.current
        assert "TurtleSim" not in screen_text(app)


async def test_no_turtle_at_all_is_a_picture_too(desk) -> None:
    simulation = FakeSimulation()
    simulation.scene = SimpleNamespace(turtles=(), background=(69, 86, 255))
    desk.display.open("turtlesim", "TurtleSim", simulation)
    async with opened(desk, 80, 24, lang="zh") as (app, pilot):
        await step(app, pilot)
        assert "没有海龟" in screen_text(app)


def test_the_colours_of_the_world_are_not_those_of_the_theme() -> None:
    assert colours("dark").text.bgcolor != colours("light").text.bgcolor
    pane = _pane(FakeSimulation(), 60, 31)
    _touched(pane)
    assert pane._canvas.background == 0x4556FF


# -- what stands beside the world --------------------------------------------------------------------------------------


def _topics(*senders: str) -> dict[str, TurtleTopics]:
    return {"turtle1": TurtleTopics("/turtle1/pose", "/turtle1/cmd_vel", senders)}


def _lines(pane: TurtleSimPane) -> list[str]:
    _touched(pane)
    return _text(pane)


def _text(pane: TurtleSimPane) -> list[str]:
    width = pane.inner_width
    lines = ["".join(segment.text for segment in pane.content_line(y, width)) for y in range(pane.inner_height)]
    assert max(map(cell_len, lines)) <= width
    return lines


@pytest.mark.parametrize("glyphs", ["half", "ascii"])
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize(
    ("size", "columns"), [((80, 14), 24), ((58, 20), 36), ((40, 22), 38), ((60, 38), 58), ((80, 13), 22)]
)
def test_the_world_is_as_large_as_it_can_be_and_what_is_left_over_says_where_the_turtle_is_and_who_drives_it(
    size, columns, lang, glyphs
) -> None:
    simulation = FakeSimulation(turtle(x=1.25, theta=-0.5, v=2.0))
    simulation.topics = _topics("/teleop_turtle")
    pane = _pane(simulation, *size, lang=lang, glyphs=glyphs)
    text = "\n".join(_lines(pane))
    assert pane._world_place()[2] == columns
    if size == (40, 22):  # one line below a world that is as wide as the window
        assert "turtle1" in text
        return
    words = ("/turtle1/pose", "x  1.25", "theta -0.50", "/turtle1/cmd_vel", "/teleop_turtle")
    assert all(each in text for each in words), text
    assert ("linear_velocity  2.00" in text) or size == (58, 20)
    assert glyphs != "ascii" or text.isascii() or lang == "zh"


def test_a_turtle_that_nobody_drives_says_how_to_drive_it() -> None:
    simulation = FakeSimulation()
    simulation.topics = _topics()
    assert "ros2 run turtlesim turtle_teleop_key" in "\n".join(_lines(_pane(simulation, 80, 14, lang="en")))


def test_a_new_driver_is_named_though_the_turtle_stands_still() -> None:
    simulation = FakeSimulation()
    simulation.topics = _topics()
    pane = _pane(simulation, 80, 14)
    assert "/draw_square" not in "\n".join(_lines(pane))
    simulation.topics = _topics("/draw_square", "/teleop_turtle")
    text = "\n".join(_lines(pane))
    assert "/draw_square" in text and "/teleop_turtle" in text


def test_many_turtles_come_before_the_card_of_one() -> None:
    simulation = FakeSimulation(*[turtle(f"turtle{n}", float(n)) for n in range(1, 10)])
    simulation.topics = _topics("/teleop_turtle")
    lines = _lines(_pane(simulation, 80, 12, lang="en"))
    assert all(any(f" turtle{n} " in line for line in lines) for n in range(1, 10))
    assert not any("linear_velocity" in line for line in lines)
    assert any("linear_velocity" in line for line in _lines(_pane(simulation, 80, 16, lang="en")))
    few = _lines(_pane(simulation, 80, 9, lang="en"))
    assert "turtle6" in "\n".join(few) and "3 more" in few[-1]


def test_the_numbers_change_ten_times_a_second_and_the_last_ones_are_shown() -> None:
    simulation = FakeSimulation(turtle(x=5.0))
    simulation.topics = _topics("/teleop_turtle")
    pane = _pane(simulation, 80, 14)
    _lines(pane)
    now = next(SECONDS)
    simulation.show(turtle(x=5.2))
    assert not pane.pull(now)
    simulation.show(turtle(x=5.4))
    assert pane.pull(now + 0.03) and not any("x  5.40" in line[25:] for line in _text(pane))
    assert not pane.pull(now + 0.11) and any("x  5.40" in line[25:] for line in _text(pane))
    assert not pane.pull(now + 0.3)


def test_only_the_numbers_that_change_are_drawn_again() -> None:
    simulation = FakeSimulation(turtle(x=5.0))
    simulation.topics = _topics("/teleop_turtle")
    pane = _pane(simulation, 80, 14)
    _lines(pane)
    compared: list[int] = []
    pane.touch_lines = lambda lines: compared.extend(lines)  # type: ignore[method-assign]
    simulation.show(turtle(x=5.2))
    _touched(pane)
    assert len(compared) == 2  # the turtle's own line, and x


@pytest.mark.parametrize("name", ["a" * 200, "龟" * 60, "\x1b]0;T\a"])
@pytest.mark.parametrize("size", [(80, 14), (58, 20), (60, 38), (30, 8)])
def test_names_of_any_length_keep_their_place(name, size) -> None:
    simulation = FakeSimulation(turtle(name))
    simulation.topics = {name: TurtleTopics(f"/{name}/pose", f"/{name}/cmd_vel", (f"/{name}",))}
    _lines(_pane(simulation, *size))
