"""From `/turtle1/pose/x` to a topic and a number in its messages; `/joint_states/position[0]` and `/pose/x:y` too."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from day6_tui.core.interfaces import get_message

_STEP = re.compile(r"^([A-Za-z_]\w*)((?:\[\d+\])*)$")
_SIZED = (f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64))
_NUMBERS = frozenset(("bool", "boolean", "byte", "octet", "char", "float", "double", "float32", "float64", *_SIZED))
DEEPEST = 6
"""Messages in messages that are looked into for numbers, when a path names no single one."""


class NoField(Exception):
    """The path cannot be plotted; the text says why, in English."""


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


def plottable(type_name: str, rest: str) -> list[str]:
    """Return the fields that a path into a message type means: itself if it is a number, else all numbers inside.

    NoField if there is no such field, or nothing to plot in it.
    """
    kind = get_message(type_name)
    steps = [step for step in rest.split("/") if step]
    word = _walk(kind, type_name, steps)
    if word in _NUMBERS:
        return ["/".join(steps)]
    found = list(_numbers(word, steps, DEEPEST)) if "/" in word and not word.endswith("]") else []
    if not found:
        what = f"a list: choose one with {steps[-1]}[0]" if word.endswith(("]", ">")) else f"no number but {word}"
        raise NoField(f"{'/'.join(steps) or type_name} is {what}")
    return found


def _fields(kind: Any) -> Mapping[str, str]:
    fields: Mapping[str, str] = kind.get_fields_and_field_types()
    return fields


def _walk(kind: Any, type_name: str, steps: list[str]) -> str:
    """Return the type of the field that the steps lead to."""
    word = _slashed(type_name)
    for number, step in enumerate(steps):
        match = _STEP.match(step)
        if "/" not in word or word.endswith(("]", ">")):
            raise NoField(f"{'/'.join(steps[:number])} has no fields")
        fields = _fields(get_message(_full(word)))
        if match is None or match.group(1) not in fields:
            raise NoField(f"{_slashed(word)} has no field '{step}'; it has {', '.join(fields)}")
        word = fields[match.group(1)]
        for _ in re.findall(r"\[\d+\]", match.group(2)):
            word = _element(word, step)
    return word


def _slashed(name: str) -> str:
    return name.replace("/msg/", "/")


def _full(word: str) -> str:
    package, _, name = word.partition("/")
    return f"{package}/msg/{name}"


def _element(word: str, step: str) -> str:
    """The type of the elements of a list."""
    match = re.fullmatch(r"sequence<(.*?)(?:, \d+)?>|(.*)\[\d+\]", word)
    if match is None:
        raise NoField(f"{step.partition('[')[0]} is no list")
    return match.group(1) or match.group(2)


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
