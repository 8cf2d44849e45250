"""The texts of the command line in one language; the desktop's catalogue has them, too."""

from __future__ import annotations

from importlib import import_module
from typing import Protocol


class Wording(Protocol):
    """Texts in a language, by key."""

    language: str

    def __call__(self, key: str, /, **values: object) -> str:
        """Return the text with its {fields} filled in. Raises KeyError for an unknown key."""


class CommandTexts:
    """Those of `locale/<language>.py`. Only this language is read."""

    def __init__(self, language: str) -> None:
        self.language = language
        self._texts = texts_in(language)

    def __call__(self, key: str, /, **values: object) -> str:
        """Return the text with its {fields} filled in. Raises KeyError for an unknown key."""
        text = self._texts[key]
        return text.format(**values) if values else text


def texts_in(language: str) -> dict[str, str]:
    """Return all of them, by key."""
    found: dict[str, str] = import_module(f"day6_core.command_line.locale.{language}").TEXTS
    return found
