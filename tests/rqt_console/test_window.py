"""The console's window on a desktop whose frames the test draws."""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "tui"))

from fakes import FakeDesk
from screens import look_at, opened, screen_lines, screen_text, step

from day6_tui.core.ros.programs.rqt_console.model import Console


def log(text, level, node):
    stamp = SimpleNamespace(sec=5, nanosec=0)
    return SimpleNamespace(stamp=stamp, level=level, name=node, msg=text, file="talker.py", function="tick", line=7)


WALL = "Oh no! I hit the wall! (Clamping from [x=11.120889, y=5.544445])"


def look(console, keys=(), **options):
    return look_at(("rqt_console", "Console", console), "RqtConsolePane", keys, **options)


@pytest.fixture
def console():
    made = Console()
    made.receive(log("Starting turtlesim", 20, "turtlesim"))
    made.receive(log(WALL, 30, "turtlesim"))
    made.receive(log("details", 10, "talker"))
    return made


def test_the_table_has_the_columns_of_the_real_window_and_the_message_in_full(console):
    text = look(console, ["up"])
    for word in ("#", "Message", "Severity", "Node", "Stamp", "Warn", "turtlesim", "Exclude", "3 messages"):
        assert word in text
    assert WALL in text


def test_a_larger_window_shows_the_location_too(console):
    assert "talker.py:tick:7" in look(console, width=120, height=40)


def test_letters_leave_severities_out(console):
    text = look(console, ["w", "d"])
    assert "hit the wall" not in text and "details" not in text and "Starting turtlesim" in text
    assert "[x] Warn" in text and "1 of 3 messages" in text
    console.show_everything()
    assert "hit the wall" in look(console)


def test_text_is_typed_into_a_prompt(console):
    text = look(console, ["slash", *"wa", "enter"])
    assert console.choice.text == "wa" and WALL not in text
    look(console, ["h", *"st", "enter"])
    assert console.choice.highlight == "st"


def test_pause_and_clear(console):
    assert "paused" in look(console, ["p"])
    assert "No log message yet" in look(console, ["c"])


@pytest.mark.parametrize(("size", "seen"), [((40, 10), 20), ((60, 12), 28), ((120, 40), 35)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_at_every_size_the_message_has_room_and_every_severity_its_box(console, size, seen, lang):
    lines = look(console, ["f8"], width=size[0], height=size[1], lang=lang).splitlines()
    assert any(f" {WALL[:seen]}" in line for line in lines)
    boxes = next(line for line in lines if "[ ]" in line)
    assert [word[0] for word in boxes.replace("[ ] ", "[ ]").split("[ ]")[1:]] == list("DIWEF")


@pytest.mark.parametrize("size", [(40, 10), (80, 24)])
def test_a_click_on_a_severitys_box_leaves_it_out_and_one_on_a_message_chooses_it(console, size):
    async def click() -> None:
        desk = FakeDesk()
        desk.display.open("rqt_console", "Console", console)
        async with opened(desk, *size, scene="empty", lang="en") as (app, pilot):
            await step(app, pilot)
            pane = next(iter(app.query("RqtConsolePane")))
            pane.focus()
            await pilot.press("f8")
            await step(app, pilot)
            lines = screen_lines(app)
            row = next(y for y, line in enumerate(lines) if "Exclude" in line)
            await pilot.click(offset=(lines[row].index("W"), row))
            await step(app, pilot)
            assert console.choice.levels == {30} and WALL not in screen_text(app)
            await pilot.click(offset=(3, row - 1))
            await step(app, pilot)
            assert pane._chosen is None
            await pilot.click(offset=(12, next(y for y, line in enumerate(lines) if "#1" in line)))
            await step(app, pilot)
            assert pane._chosen.number == 1

    asyncio.run(click())


@pytest.mark.parametrize(
    ("size", "language", "glyphs"),
    (((40, 12), "en", "half"), ((80, 24), "zh", "ascii"), ((120, 40), "zh", "half"), ((10, 4), "en", "ascii")),
)
def test_every_size_language_and_glyph_set_is_drawn(console, language, size, glyphs):
    console.receive(log("海龟撞墙了 " * 40, 50, "a_node_with_a_very_long_name_indeed"))
    text = look(console, ["up", "end"], width=size[0], height=size[1], lang=language, glyphs=glyphs)
    assert "Error" not in text.replace("Error(", "").replace("] Error", "")


def test_an_empty_console_says_where_messages_come_from():
    assert "/rosout" in look(Console())
