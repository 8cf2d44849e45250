"""From `/turtle1/pose/x` to a topic and a number in its messages; `/joint_states/position[0]` and `/pose/x:y` too."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from day6_core.interfaces import get_message
from day6_core.ros.programs.rqt_topic.fields import element_type

_STEP = re.compile(r"^([A-Za-z_]\w*)((?:\[\d+\])*)$")
_SIZED = (f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64))
_NUMBERS = frozenset(("bool", "boolean", "byte", "octet", "char", "float", "double", "float32", "float64", *_SIZED))
_LISTS = ("]", ">")
DEEPEST = 6
"""Messages in messages that are looked into for numbers, when a path names no single one."""


class NoField(Exception):
    """The path cannot be plotted; the text says why, in the words of rqt_plot (plot_widget.py, get_plot_fields)."""


def split_paths(word: str) -> list[str]:
    """Return the paths that one word of the command line means: '/turtle1/pose/x:y' is '/turtle1/pose/x' and '…/y'."""
    base, *more = word.split(":")
    parent = base.rpartition("/")[0]
    return [base, *(f"{parent}/{name}" for name in more if name)]


def find_topic(path: str, topics: Mapping[str, Sequence[str]]) -> tuple[str, str, str] | None:
    """Return topic, type and the rest of the path, for the longest topic that the path begins with; None without one."""
    full = path if path.startswith("/") else f"/{path}"
    fitting = [name for name in topics if full == name or full.startswith(f"{name}/")]
    if not fitting:
        return None
    name = max(fitting, key=len)
    return name, topics[name][0], full[len(name) + 1 :]


def plottable(topic: str, type_name: str, rest: str) -> list[str]:
    """Return the fields that a path into the messages of a topic means: itself if it is a number, else all numbers inside.

    NoField if there is no such field, or nothing to plot in it.
    """
    steps = [step for step in rest.split("/") if step]
    word = _walk(topic, type_name, steps)
    if word in _NUMBERS:
        return ["/".join(steps)]
    found = list(_numbers(word, steps, DEEPEST)) if "/" in word else []
    if not found:
        path = "/".join([topic, *steps])
        raise NoField(
            f"'{path}' is a string, which cannot be plotted" if "string" in word else f"{path} cannot be plotted"
        )
    return found


def _fields(kind: Any) -> Mapping[str, str]:
    fields: Mapping[str, str] = kind.get_fields_and_field_types()
    return fields


def _walk(topic: str, type_name: str, steps: list[str]) -> str:
    """Return the type of the field that the steps lead to."""
    word = _slashed(type_name)
    for number, step in enumerate(steps):
        if "/" not in word:
            raise NoField(f"'{'.'.join(steps[:number])}' is a primitive type with no field named '{step}'")
        where = f"trying to parse field '{'.'.join(steps[: number + 1])}' of topic {topic}: "
        fields = _fields(get_message(_full(word)))
        match = _STEP.match(step)
        name = match.group(1) if match is not None else step
        if match is None or name not in fields:
            raise NoField(f"{where}'{name}' is not a field of '{_full(word)}' ({', '.join(fields)})")
        word, indexes = fields[name], match.group(2)
        if word.endswith(_LISTS) and not indexes:
            raise NoField(f"{where}{name} is a nested type but no index provided")
        for _ in re.findall(r"\[\d+\]", indexes):
            if not word.endswith(_LISTS):
                raise NoField(f"{where}{name} is not an array or sequence")
            word = element_type(word)
    return word


def _slashed(name: str) -> str:
    return name.replace("/msg/", "/")


def _full(word: str) -> str:
    package, _, name = word.partition("/")
    return f"{package}/msg/{name}"


def _numbers(word: str, steps: list[str], depth: int) -> list[str]:
    found: list[str] = []
    for name, inner in _fields(get_message(_full(word))).items():
        if inner in _NUMBERS:
            found.append("/".join([*steps, name]))
        elif "/" in inner and not inner.endswith(("]", ">")) and depth and name != "header":
            found += _numbers(inner, [*steps, name], depth - 1)
    return found


def reader(rest: str) -> Callable[[Any], float | None]:
    """Return what takes the number out of a message; None where a list is too short, or it is not a number."""
    steps: list[str | int] = []
    for part in rest.split("/"):
        name, *indexes = re.findall(r"\w+", part)
        steps += [name, *map(int, indexes)]

    def read(message: Any) -> float | None:
        value = message
        for step in steps:
            if isinstance(step, int):
                if step >= len(value):
                    return None
                value = value[step]
            else:
                value = getattr(value, step)
        number = float(value[0] if isinstance(value, bytes) else value)
        return number if math.isfinite(number) else None

    return read
