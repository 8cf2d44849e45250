"""The plot's window on a desktop whose frames the test draws."""

from __future__ import annotations

import asyncio
import math

import pytest

from day6_core.ros.programs.rqt_plot.model.plot import Curve, Plot
from tests.tui.fakes import FakeDesk
from tests.tui.screens import look_at, opened, screen_lines, step

NOW = 100.0


class FakeNode:
    """A graph with one topic."""

    def get_topic_names_and_types(self):
        return [("/turtle1/pose", ["turtlesim/msg/Pose"])]


def make_plot(*curves):
    plot = Plot(FakeNode(), lambda: round(NOW * 1e9))
    plot.curves = curves
    return plot


def curve(path, number, function):
    made = Curve(path, number)
    made.topic = "/topic"
    for tick in range(500):
        time = NOW - 10 + tick / 50
        made.add(time, function(time))
    return made


def look(plot, keys=(), **options):
    return look_at(("rqt_plot", "MatPlot", plot), "RqtPlotPane", keys, **options)


@pytest.fixture
def waves():
    return make_plot(curve("/wave/data", 0, math.sin), curve("/line/data", 1, lambda time: (time - NOW) / 10))


def test_a_wave_and_a_ramp_are_drawn_with_axes_and_legend(waves):
    text = look(waves, width=100, height=40, glyphs="ascii")
    picture = [line.partition("+")[2] or line.partition("|")[2] for line in text.splitlines()]
    assert any("*" in line for line in picture) and any("+" in line for line in picture)
    for word in ("/wave/data", "/line/data", "10 s", "-1.0", "1.0", "0 s"):
        assert word in text
    assert f"{math.sin(NOW - 0.02):.5g}"[:6] in text


def test_braille_is_the_finer_picture_and_g_makes_it_coarser(waves):
    fine = look(waves, glyphs="half")
    assert any(0x2801 <= ord(char) <= 0x28FF for char in fine)
    coarse = look(waves, ["g"], glyphs="half")
    assert "▀" in coarse and not any(0x2801 <= ord(char) <= 0x28FF for char in coarse)


def test_a_level_line_is_drawn_in_the_middle():
    text = look(make_plot(curve("/flat/data", 0, lambda time: 7.0)), glyphs="ascii")
    rows = [line for line in text.splitlines() if "*****" in line]
    assert len(rows) == 1 and "7" in rows[0][:12]


def test_without_curves_the_window_says_what_to_do():
    assert "Nothing is plotted yet" in look(make_plot())


def test_a_field_is_chosen_from_the_list_or_typed():
    plot = make_plot()
    text = look(plot, ["a"])
    assert "/turtle1/pose/theta" in text
    look(plot, ["a", *"the", "enter"])
    assert len(plot._requests) == 1
    look(plot, ["e", *"/p/x:y", "enter"])
    while plot._requests:
        plot._requests.pop(0)()
    assert [each.path for each in plot.curves] == ["/turtle1/pose/theta", "/p/x", "/p/y"]


def test_keys_pause_zoom_and_remove(waves):
    text = look(waves, ["p", "minus", "down", "delete"])
    assert "paused" in text and "20 s" in text
    waves._node.destroy_subscription = lambda ear: None
    waves._subscriptions = {"/topic": None}
    waves.handle_requests()
    assert [each.path for each in waves.curves] == ["/wave/data"]


@pytest.mark.parametrize(("size", "least"), [((40, 10), 3), ((60, 12), 5), ((120, 40), 20)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_at_every_size_the_picture_has_rows_and_the_chosen_curve_its_name_and_value(size, least, lang):
    plot = make_plot(*(curve(f"/turtle{number}/pose/x", number, math.sin) for number in range(3)))
    lines = look(plot, ["f8", "down"], width=size[0], height=size[1], lang=lang).splitlines()
    assert sum("┤" in line or "│" in line for line in lines) >= least
    legend = next(line for line in lines if "▸ ━━" in line)
    assert "/turtle1/pose/x " in legend and f"{math.sin(NOW - 0.02):.5g} " in legend
    assert ("2/3" in lines[-2]) is (size[1] < 40)


def test_a_click_on_a_scrolled_legend_chooses_the_curve_that_is_there():
    plot = make_plot(*(curve(f"/c{number}/x", number, math.sin) for number in range(9)))

    async def click() -> None:
        desk = FakeDesk()
        desk.display.open("rqt_plot", "MatPlot", plot)
        async with opened(desk, 120, 40, scene="empty", lang="en") as (app, pilot):
            await step(app, pilot)
            next(iter(app.query("RqtPlotPane"))).focus()
            for key in ("f8", *["down"] * 8):
                await pilot.press(key)
                await step(app, pilot)
            lines = screen_lines(app)
            row = next(y for y, line in enumerate(lines) if "/c4/x" in line)
            await pilot.click(offset=(lines[row].index("/c4/x"), row))
            await step(app, pilot)
            assert any("▸ ━━ /c4/x" in line for line in screen_lines(app))

    asyncio.run(click())


@pytest.mark.parametrize(
    ("size", "language", "glyphs"),
    (((40, 12), "en", "half"), ((80, 24), "zh", "braille"), ((120, 40), "zh", "cell"), ((12, 5), "en", "ascii")),
)
def test_every_size_language_and_glyph_set_is_drawn(waves, language, size, glyphs):
    waiting, wrong = Curve("/not/there", 2), Curve("/turtle1/pose/z", 3)
    wrong.problem = "turtlesim/Pose has no field 'z'"
    waves.curves = (*waves.curves, waiting, wrong, curve("/huge/data", 4, lambda time: 1e300 * math.sin(time)))
    text = look(waves, ["down", "g", "plus"], width=size[0], height=size[1], lang=language, glyphs=glyphs)
    assert "Error" not in text and "drawn" not in text


def test_in_a_low_window_the_other_curves_share_the_line_of_the_chosen_one(waves):
    text = look(waves, ["down"], width=80, height=12)
    (line,) = (line for line in text.splitlines() if "/line/data" in line)
    assert "/wave/data" in line and line.index("/line/data") < line.index("/wave/data")
