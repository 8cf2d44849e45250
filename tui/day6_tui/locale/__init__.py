"""The texts of the user interface, in Chinese and English. Real ROS output never comes from here.

`zh.py` and `en.py` hold one mapping each with the same keys (a test compares them); scenes bring their own texts. The language is
a value that is passed along and may change while the desktop runs, so a text is looked up where it is drawn, never at import.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from importlib import import_module

from day6_core.lessons.scene import scenes

LANGUAGES = ("zh", "en")
_catalogues: dict[str, Mapping[str, str]] = {}


def catalogue(language: str) -> Mapping[str, str]:
    """All texts of 'zh' or 'en'. Raises ValueError for another language."""
    if language not in LANGUAGES:
        raise ValueError(f"no texts in {language!r}, only in {' and '.join(LANGUAGES)}")
    if language not in _catalogues:
        _catalogues[language] = {**import_module(f"{__name__}.{language}").TEXTS, **dict(_texts_of_scenes(language))}
    return _catalogues[language]


def _texts_of_scenes(language: str) -> Iterator[tuple[str, str]]:
    for name, scene in scenes().items():
        texts = scene.texts[language]
        yield f"welcome.{name}", texts.title
        yield f"welcome.{name}.more", texts.more
        if scene.is_action:
            yield f"action.scene.{name}", texts.title
            yield f"help.action.scene.{name}", texts.help


_ARROWS = str.maketrans({"↑": "Up", "↓": "Down", "←": "Left", "→": "Right"})


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
            text = text.translate(_ARROWS)
        return text.format(**values) if values else text

    def switch(self) -> None:
        """Go to the other language."""
        self.language = LANGUAGES[(LANGUAGES.index(self.language) + 1) % len(LANGUAGES)]


def detect(environ: Mapping[str, str], *, wide_glyphs: bool = True, platform: str = sys.platform) -> str:
    """The language of the locale; English where the terminal has no Chinese characters (`wide_glyphs` False)."""
    if wide_glyphs:
        for name in ("LC_ALL", "LC_MESSAGES", "LANGUAGE", "LANG"):
            if value := environ.get(name):
                return "zh" if value.lower().startswith("zh") else "en"
        if platform == "win32":  # which has none of these variables
            import locale

            name = locale.getlocale()[0] or ""  # zh_CN, or Chinese (Simplified)_China
            return "zh" if name.lower().startswith(("zh", "chinese")) else "en"
    return "en"
