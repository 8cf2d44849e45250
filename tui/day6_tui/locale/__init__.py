"""The texts of the user interface, in Chinese and English. Real ROS output never comes from here.

A folder for each language holds a module for each part of the interface, the same ones with the same keys (a test compares
them); scenes bring their own texts, and those of the command line are below it (`day6_core.command_line`). The language is a
value that is passed along and may change while the desktop runs, so a text is looked up where it is drawn, never at import.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module
from pathlib import Path

from day6_core.command_line.texts import texts_in
from day6_core.language import LANGUAGES
from day6_core.lessons.scene import scenes


@cache
def catalogue(language: str) -> Mapping[str, str]:
    """All texts of 'zh' or 'en'. Raises ValueError for another language."""
    if language not in LANGUAGES:
        raise ValueError(f"no texts in {language!r}, only in {' and '.join(LANGUAGES)}")
    texts = dict(texts_in(language))
    for part in parts(language):
        texts |= import_module(f"{__name__}.{language}.{part}").TEXTS
    return texts | dict(_texts_of_scenes(language))


def parts(language: str) -> list[str]:
    """The parts of the interface that have texts in a language: the modules of its folder."""
    return sorted(
        name.removesuffix(".py")
        for name in os.listdir(Path(__file__).parent / language)
        if name.endswith(".py") and name != "__init__.py"
    )


def _texts_of_scenes(language: str) -> Iterator[tuple[str, str]]:
    for name, scene in scenes().items():
        texts = scene.texts[language]
        yield f"welcome.{name}", texts.title
        yield f"welcome.{name}.more", texts.more
        if scene.is_action:
            yield f"action.scene.{name}", texts.title
            yield f"help.action.scene.{name}", texts.help


_ARROWS: dict[str, dict[int, str]] = {
    "en": str.maketrans({"↑": "Up", "↓": "Down", "←": "Left", "→": "Right"}),
    "zh": str.maketrans({"↑": "上", "↓": "下", "←": "左", "→": "右"}),
}


class Texts:
    """The texts of the current language: `texts("key", name=…)`. `plain`: words replace arrows, which not every font has."""

    def __init__(self, language: str, *, plain: bool = False) -> None:
        self.language = language
        self.plain = plain
        catalogue(language)

    def __call__(self, key: str, /, **values: object) -> str:
        """The text for `key` with its {fields} filled in. Raises KeyError for an unknown key."""
        text = catalogue(self.language)[key]
        if self.plain:
            text = text.translate(_ARROWS[self.language])
        return text.format(**values) if values else text

    def switch(self) -> None:
        """Go to the other language."""
        self.language = LANGUAGES[(LANGUAGES.index(self.language) + 1) % len(LANGUAGES)]
