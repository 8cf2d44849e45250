"""The slider window: what stands in it at which size, and what keys and the mouse request."""

from __future__ import annotations

import asyncio
import math
from typing import Any

import pytest
from textual.geometry import Size

from day6_core.ros.programs.joint_state_publisher_gui.model import Slider
from day6_core.session.display import Display
from day6_tui.app import make_look
from day6_tui.options import Options
from day6_tui.panes.cells import cell_len
from day6_tui.windows.robot.joint_names import shortened
from day6_tui.windows.robot.joint_state_publisher import SlidersPane
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_lines, step

UTF8 = {"LANG": "C.UTF-8", "TERM": "xterm-256color", "COLORTERM": "truecolor"}


class FakeModel:
    """Sliders the test sets; remembers what was requested."""

    def __init__(self, *sliders: Slider) -> None:
        self.sliders = sliders
        self.described = True
        self.others: tuple[str, ...] = ()
        self.version = 1
        self.requests: list[tuple[str, str, float]] = []

    def request(self, kind: str, joint: str = "", number: float = 0.0) -> None:
        self.requests.append((kind, joint, number))


def wheel(name: str = "left_wheel_joint", value: float = 0.0) -> Slider:
    step = round((value + math.pi) / (2 * math.pi) * 10_000)
    return Slider(name, -math.pi, math.pi, value, step, True)


LIFT = Slider("lift", 0.0, 0.5, 0.1, 2000, False)


def pane_of(model: FakeModel, width: int = 60, height: int = 20, **options: Any) -> SlidersPane:
    window = Display().open("joint_state_publisher", "Joint State Publisher", model)
    pane = SlidersPane(window, make_look(Options(**options), UTF8))
    pane.extent = Size(width, height)
    pane.touch = lambda: None  # type: ignore[method-assign]
    return pane


def text_of(pane: SlidersPane) -> str:
    pane._shown = pane._build(pane.inner_width, pane.inner_height)
    lines = ["".join(segment.text for segment in line) for line in pane._shown]
    assert all(cell_len(line) <= pane.inner_width for line in lines), "a line is too long"
    return "\n".join(lines)


@pytest.mark.parametrize("glyphs", ["half", "cell", "ascii"])
@pytest.mark.parametrize("size", [(40, 12), (60, 20), (80, 10), (118, 36)])
def test_every_joint_has_its_name_its_value_and_its_limits(glyphs: str, size: tuple[int, int]) -> None:
    text = text_of(pane_of(FakeModel(wheel(), LIFT), *size, glyphs=glyphs))
    assert "Randomize" in text and "Center" in text
    assert "left_wheel_joint" in text and "0.000 rad" in text and "-3.14" in text
    assert "0.100 m" in text
    if glyphs == "ascii":
        assert text.isascii()


def test_more_joints_than_lines_scroll_with_the_chosen_one() -> None:
    pane = pane_of(FakeModel(*(wheel(f"joint_{number}") for number in range(64))), 80, 12)
    assert "joint_0 " in text_of(pane) and "joint_60" not in text_of(pane)
    pane._choose(60)
    assert "joint_60" in text_of(pane)


def test_degrees_are_shown_for_what_turns_and_not_for_what_slides() -> None:
    pane = pane_of(FakeModel(wheel(value=math.pi / 2), LIFT))
    pane._press("d", "d")
    text = text_of(pane)
    assert "90.0 °" in text and "-180" in text and "0.100 m" in text


def test_arrows_move_a_step_with_shift_ten_and_with_ctrl_as_little_as_possible() -> None:
    model = FakeModel(wheel(), LIFT)
    pane = pane_of(model)
    for key in ("right", "shift+left", "ctrl+right", "home", "end"):
        pane._press(key, "")
    assert model.requests == [
        ("step", "left_wheel_joint", 5100),
        ("step", "left_wheel_joint", 4000),
        ("step", "left_wheel_joint", 5001),
        ("value", "left_wheel_joint", -math.pi),
        ("value", "left_wheel_joint", math.pi),
    ]


def test_a_number_can_be_typed_in_degrees_and_taken_or_left() -> None:
    model = FakeModel(wheel())
    pane = pane_of(model)
    pane._press("d", "d")
    for character in "90":
        pane._press(character, character)
    assert "90_" in text_of(pane)
    pane._press("enter", "")
    assert model.requests == [("value", "left_wheel_joint", pytest.approx(math.pi / 2))]
    pane._press("enter", "")
    for character in "-1e":
        pane._press(character, character)
    pane._press("enter", "")  # "-1e" is no number
    pane._press("5", "5")
    pane._press("escape", "")
    assert len(model.requests) == 1


def test_letters_are_the_buttons() -> None:
    model = FakeModel(wheel())
    pane = pane_of(model)
    for key in "rcz":
        assert pane._press(key, key)
    assert model.requests == [("randomize", "", 0.0), ("center", "", 0.0), ("zero", "left_wheel_joint", 0.0)]
    assert not pane._press("q", "q")


def test_the_mouse_drags_the_knob_to_where_it_is() -> None:
    model = FakeModel(wheel(), LIFT)
    pane = pane_of(model, 80, 10)
    text_of(pane)
    column, width = pane._tracks["lift"]
    line = next(y for y in range(3, 9) if pane._at(y) is LIFT)
    assert pane._at(line) is LIFT
    pane._dragged = "lift"
    for share, expected in ((0.0, 0), (0.5, 5000), (1.0, 10_000), (2.0, 10_000)):
        pane._drag_to(pane.inner_offset + column + round(share * (width - 1)))
        assert model.requests[-1] == ("step", "lift", pytest.approx(expected, abs=200))


@pytest.mark.parametrize("size", [(50, 12), (80, 24), (80, 8)])
def test_a_click_on_a_number_begins_another_one(size: tuple[int, int]) -> None:
    model = FakeModel(wheel(), LIFT)

    async def click() -> None:
        desk = FakeDesk()
        desk.display.open("joint_state_publisher", "Joint State Publisher", model)
        async with opened(desk, *size, scene="empty", lang="en") as (app, pilot):
            await step(app, pilot)
            app.query_one(SlidersPane).focus()
            await pilot.press("f8")
            await step(app, pilot)
            row = next(y for y, line in enumerate(screen_lines(app)) if "0.100 m" in line)
            await pilot.click(offset=(screen_lines(app)[row].index("0.100 m"), row))
            await pilot.press(".", "3", "enter")

    asyncio.run(click())
    assert model.requests == [("value", "lift", 0.3)]


@pytest.mark.parametrize(("lang", "word"), [("en", "jitters"), ("zh", "抖动")])
def test_another_publisher_is_named_and_the_jitter_explained(lang: str, word: str) -> None:
    model = FakeModel(wheel())
    model.others = ("wheel_spinner",)
    text = text_of(pane_of(model, 50, 14, lang=lang))
    assert "wheel_spinner" in text and word in text


@pytest.mark.parametrize(("described", "word"), [(False, "/robot_description"), (True, "no movable joints")])
def test_without_joints_it_says_why(described: bool, word: str) -> None:
    model = FakeModel()
    model.described = described
    assert word in text_of(pane_of(model, lang="en"))


def test_hundreds_of_sizes_break_nothing() -> None:
    model = FakeModel(wheel(), LIFT, wheel("一个名字很长很长很长很长的关节"))
    model.others = ("wheel_spinner", "another_node")
    for width in range(36, 130, 7):
        for height in (3, 4, 6, 11, 30):
            text_of(pane_of(model, width, height))


# -- in few rows -------------------------------------------------------------------------------------------------------

CORNERS = [f"{end}_{side}_wheel_joint" for end in ("front", "rear") for side in ("left", "right")]


@pytest.mark.parametrize("glyphs", ["half", "ascii"])
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize(("size", "shown"), [((40, 8), 4), ((60, 12), 4), ((30, 6), 1)])
def test_in_few_rows_every_shown_joint_has_its_value_and_a_name_of_its_own(
    size: tuple[int, int], shown: int, glyphs: str, lang: str
) -> None:
    model = FakeModel(*(wheel(name, number / 2) for number, name in enumerate(CORNERS)))
    text = text_of(pane_of(model, *size, glyphs=glyphs, lang=lang))
    lines = [line for line in text.splitlines() if " rad" in line]
    assert len(lines) >= shown and len({line[2:].split()[0] for line in lines}) == len(lines)
    for number, line in enumerate(lines):
        assert f"{number / 2:.3f} rad" in line
    tracks = [line for line in text.splitlines() if ("O" if glyphs == "ascii" else "●") in line]
    assert len(tracks) >= shown


def test_in_few_rows_the_list_scrolls_and_the_mouse_finds_what_is_shown() -> None:
    model = FakeModel(*(wheel(f"joint_{number}") for number in range(12)))
    pane = pane_of(model, 40, 8)
    assert [line.split()[0] for line in text_of(pane).splitlines()[1:] if line][1:] == [
        f"joint_{n}" for n in range(1, 5)
    ]
    pane._choose(11)
    assert "joint_11" in text_of(pane) and "joint_7 " in text_of(pane) and "joint_6 " not in text_of(pane)
    slider = pane._at(pane.inner_offset + 1)
    assert slider is not None and slider.name == "joint_7"


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_second_publisher_leaves_room_for_the_sliders(lang: str) -> None:
    model = FakeModel(wheel("left_wheel_joint"), wheel("right_wheel_joint"))
    model.others = ("/wheel_spinner",)
    text = text_of(pane_of(model, 40, 8, lang=lang))
    assert "/wheel_spinner" in text and "left_wheel_joint" in text and "right_wheel_joint" in text
    assert len([line for line in text.splitlines() if "▲" in line]) == 1


@pytest.mark.parametrize("width", range(10, 30))
def test_shortened_names_keep_their_ends_and_stay_different(width: int) -> None:
    for names in (CORNERS, ["left_wheel_joint", "right_wheel_joint"], [f"left_arm_{n}_joint" for n in range(6)]):
        short = shortened(names, width, "…")
        assert all(cell_len(each) <= width for each in short)
        assert len(set(short)) == len(names), short
        for name, each in zip(names, short, strict=True):
            head, _, tail = each.partition("…")
            assert name.startswith(head) and name.endswith(tail) and (each == name or (head and tail))


def test_names_that_cannot_be_shortened_in_their_middle_are_cut() -> None:
    assert shortened(["左轮关节" * 4], 9, "…") == ["左轮关节…"]
    assert shortened(["abcdef"], 2, "…") == ["a…"]
