"""The actions of lesson files and scenes (writing/en.md): what may be written for each. `stage` and `scene_player` do them."""

from __future__ import annotations

import math
import re
import reprlib
from collections.abc import Collection, Mapping
from typing import Any

from day6_core.lessons.flaws import Flaw, line_of, meant, path_flaw

KEYS = {
    "up": "\x1b[A",
    "down": "\x1b[B",
    "right": "\x1b[C",
    "left": "\x1b[D",
    "enter": "\r",
    "space": " ",
    "tab": "\t",
    "esc": "\x1b",
    "backspace": "\x7f",
    **{f"ctrl+{letter}": chr(ord(letter) - 96) for letter in "abcdefghijklmnopqrstuvwxyz"},
    "ctrl+\\": "\x1c",
}
"""Names of keys and what a terminal sends for them; a single character stands for itself."""

NAMES = ("type", "terminal", "keys", "write", "replace", "wait", "pause", "rviz", "close", "answer")
MOST_PAUSE = 60.0

WINDOWS = (
    "turtlesim", "rqt_graph", "rviz2", "editor", "inspector", "rqt_plot", "rqt_console", "rqt", "topics", "car", "world",
    "rqt_bag", "rqt_tf_tree", "rqt_reconfigure", "rqt_logger_level", "rqt_image_view", "showimage", "rqt_shell",
    "rqt_py_console", "rqt_robot_steering", "service_caller", "publisher", "type_browser", "action_browser",
    "joint_state_publisher", "kitchen", "lesson",
)  # fmt: skip
"""Kinds of windows."""

_VALUE = re.compile(r"@([a-z][a-z0-9_]*)@")
_PRESSES = re.compile(r"(\S+?)(?:\*(\d{1,3}))?\Z")
_PATHS = {"write": {"file", "text"}, "replace": {"file", "old", "new"}}


def presses(text: str) -> list[str]:
    """What is sent for 'up*2 q': ['up', 'up', 'q'] as a terminal sends them. Raises KeyError for an unknown key."""
    found: list[str] = []
    for word in text.split():
        match = _PRESSES.match(word)
        name, times = (match[1], int(match[2] or 1)) if match is not None else (word, 1)
        found += [name if len(name) == 1 else KEYS[name]] * times
    return found


def filled(given: Any, values: Mapping[str, Any]) -> Any:
    """`given` with its `@name@` replaced; a text that is nothing else becomes the value itself, a number for instance."""
    if isinstance(given, str):
        whole = _VALUE.fullmatch(given)
        if whole is not None:
            return values[whole[1]]
        return _VALUE.sub(lambda found: str(values[found[1]]), given)
    if isinstance(given, list):
        return [filled(each, values) for each in given]
    if isinstance(given, dict):
        return {filled(key, values): filled(each, values) for key, each in given.items()}
    return given


def action_mistake(given: object, names: Collection[str] = NAMES) -> str:
    """What is wrong with an action of a lesson file, a Flaw with its line if that is known; '' if nothing is."""
    if not isinstance(given, dict) or len(given) != 1:
        more = isinstance(given, dict) and len(given) > 1
        why = f": does '- ' miss before '{list(given)[1]}'?" if more and isinstance(given, dict) else ""
        return Flaw(f"an action is 'name: value', not {reprlib.repr(given)}{why}", line_of(given))
    name, value = next(iter(given.items()))
    line = line_of(given, name)
    if name not in names:
        return Flaw(f"there is no action '{name}'{meant(name, names)}", line)
    if name == "wait":
        from day6_core.lessons.checks import condition_of

        made = condition_of(value)
        return made.of("wait", line) if isinstance(made, Flaw) else ""
    mistake = _judged(str(name), value)
    if not mistake:
        return ""
    return Flaw(mistake, line_of(value, "file") if name in _PATHS and "home folder" in mistake else line)


def _judged(name: str, value: object) -> str:
    if name == "keys":
        try:
            presses(str(value))
        except KeyError as unknown:
            return f"keys: there is no key {unknown}{meant(unknown.args[0], KEYS)}"
    elif name in ("pause", "look"):
        number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not number or not math.isfinite(float(str(value))) or not 0 <= float(str(value)) <= MOST_PAUSE:
            return f"{name}: a number of seconds from 0 to {MOST_PAUSE:g}"
    elif name in _PATHS:
        if not isinstance(value, dict) or value.keys() != _PATHS[name]:
            return f"{name}: needs {' and '.join(sorted(_PATHS[name]))}"
        if not all(isinstance(each, str) for each in value.values()):
            return f"{name}: every value has to be a text"
        if flaw := path_flaw(value["file"]):
            return f"{name}: {flaw}"
    elif name == "rviz":
        if not isinstance(value, dict) or value.keys() - {"fixed_frame", "add"} or not value:
            return "rviz: needs 'fixed_frame: NAME' or 'add: TYPE'"
    elif name == "terminal":
        if isinstance(value, dict):
            return _no_pattern(value)
        if value not in ("new", "idle") and not (isinstance(value, int) and not isinstance(value, bool) and value > 0):
            return "terminal: 'new', 'idle', a number from 1 or {running: PATTERN}"
    elif not isinstance(value, str):
        return f"{name}: has to be a text (quote it)"
    elif name == "close" and value not in WINDOWS:
        return f"close: there is no window '{value}'{meant(value, WINDOWS)}"
    elif name == "answer" and not (len(value) == 1 and "a" <= value <= "z"):
        return "answer: one letter, a to z"
    return ""


def _no_pattern(value: dict[object, object]) -> str:
    """What is wrong with `terminal: {running: PATTERN}`; '' if nothing is."""
    pattern = value.get("running")
    if value.keys() != {"running"} or not isinstance(pattern, str):
        return "terminal: {running: PATTERN} is what may be written in braces"
    try:
        re.compile(pattern)
    except (re.error, OverflowError, RecursionError) as error:
        return f"terminal: 'running' is not a regular expression: {error}"
    return ""
