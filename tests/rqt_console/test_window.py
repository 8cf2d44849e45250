"""The console's window on a desktop whose frames the test draws."""

from __future__ import annotations

import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "tui"))

from screens import look_at

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
