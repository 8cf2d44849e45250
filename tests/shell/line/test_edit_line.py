"""readline's commands on a line: where the cursor goes, what is killed, what comes back."""

from __future__ import annotations

import pytest

from day6_core.shell.line.edit_line import KEYS, EditLine


def edited(keys: list[str], text: str) -> str:
    """Return the line after the keys, with `|` where the cursor is."""
    line = EditLine()
    line.set(text)
    for key in keys:
        KEYS[key](line)
    return f"{line.before}|{line.text[line.at :]}"


@pytest.mark.parametrize(
    ("keys", "after"),
    [
        (["\x01"], "|ros2 topic list"),
        (["\x01", "\x1bf"], "ros2| topic list"),
        (["\x1bb", "\x1bb"], "ros2 |topic list"),
        (["\x1b[D", "\x7f"], "ros2 topic li|t"),
        (["\x01", "\x04"], "|os2 topic list"),
        (["\x14"], "ros2 topic lits|"),
    ],
)
def test_a_key_moves_or_changes_the_line_as_in_bash(keys: list[str], after: str) -> None:
    assert edited(keys, "ros2 topic list") == after


def test_ctrl_w_takes_a_whole_path_and_alt_backspace_only_its_last_name() -> None:
    assert edited(["\x17"], "ls src/my_package") == "ls |"
    assert edited(["\x1b\x7f"], "ls src/my-package") == "ls src/my-|"


def test_what_was_killed_comes_back_with_ctrl_y_also_in_the_next_line() -> None:
    line = EditLine()
    line.set("ros2 topic list")
    KEYS["\x15"](line)
    assert line.text == ""
    line.set("echo ")
    KEYS["\x19"](line)
    assert line.text == "echo ros2 topic list"


def test_a_deleted_character_is_not_what_ctrl_y_brings_back() -> None:
    line = EditLine()
    line.set("abc def")
    KEYS["\x17"](line)
    KEYS["\x7f"](line)
    KEYS["\x19"](line)
    assert line.text == "abcdef"
