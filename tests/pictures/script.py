"""The scripts of docs/pictures: what is typed into a desktop, and what has to be seen before the next key.

A script is a file NAME.yaml:

    title: {en: …, zh: …}       what the picture shows, in words
    size: [80, 24]              columns and rows
    options: [--scene, turtle]  of day6-tui
    files: {talker.py: …}       what lies in the home folder
    steps:                      what is done, one after the other
    - wait: [a, b]              both are on the screen at one moment; /…/ is a regular expression
    - gone: [a]                 none is on the screen
    - press: Up Left            keys, by the names of tests/e2e/terminal.py
    - type: ros2 node list      a line, with Enter
    - shot: 0.5                 a picture for a film, seen for so many seconds
    - film: 2                   so many seconds as they are, for a film
    others: [{options: …, …}]   scripts that are played meanwhile, each in a home of its own; no picture shows them

The picture is the screen at the end. A film of what other scripts have shot has `films: [turtle, car]` in place of steps.
A text may differ by language ({en: …, zh: …}), or be one of the program's ({text: menu.filter}).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from day6_tui.locale import Texts

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "pictures"
LANGUAGES = ("en", "zh")
DOES = ("wait", "gone", "press", "type", "shot", "film")


@dataclass(frozen=True)
class Script:
    """One file, in one language."""

    name: str
    lang: str
    title: str
    size: tuple[int, int] = (80, 24)
    options: tuple[str, ...] = ()
    files: tuple[tuple[str, str], ...] = ()
    steps: tuple[tuple[str, Any], ...] = ()
    films: tuple[str, ...] = ()
    others: tuple[Script, ...] = ()


def names() -> list[str]:
    """Every picture's name."""
    return sorted(path.stem for path in FOLDER.glob("*.yaml"))


def picture_of(name: str, lang: str) -> Path:
    return FOLDER / f"{name}.{lang}.svg"


@cache
def script(name: str, lang: str) -> Script:
    """Read a script. Raises OSError where there is none, ValueError for what it may not say."""
    return _script(name, lang, _said(yaml.safe_load((FOLDER / f"{name}.yaml").read_text("utf-8")), lang))


def _script(name: str, lang: str, told: dict[str, Any]) -> Script:
    others = tuple(_script(name, lang, {"title": "", **other}) for other in told.pop("others", ()))
    steps = tuple(pair for step in told.pop("steps", ()) for pair in step.items())
    if wrong := [does for does, _ in steps if does not in DOES]:
        raise ValueError(f"{name}.yaml: a step can't be {wrong[0]!r}")
    files = tuple(told.pop("files", {}).items())
    return Script(
        name, lang, steps=steps, files=files, others=others, **{key: _fixed(value) for key, value in told.items()}
    )


def _fixed(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _said(value: Any, lang: str) -> Any:
    """A value of a script in one language."""
    if isinstance(value, list):
        return [_said(each, lang) for each in value]
    if not isinstance(value, dict):
        return value
    if set(value) == set(LANGUAGES):
        return value[lang]
    if "text" in value:
        return Texts(lang)(value["text"], **{key: _said(each, lang) for key, each in value.items() if key != "text"})
    return {key: _said(each, lang) for key, each in value.items()}
