"""The languages that day6-tui explains things in, and which of them a user reads. Real ROS output is in none of them."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from itertools import pairwise

LANGUAGES = ("zh", "en")

Pair = tuple[str, str]
"""A text in English and in Chinese."""
VARIABLE = "DAY6_LANG"


def said(text: Pair, language: str) -> str:
    """Return a text in 'zh' or 'en'."""
    return text[language == "zh"]


def language_of(
    environ: Mapping[str, str], words: Sequence[str] = (), *, wide_glyphs: bool = True, platform: str = sys.platform
) -> str:
    """The language that `--lang` in the words of a command line chooses, else `DAY6_LANG`, else the locale.

    English where the terminal has no Chinese characters (`wide_glyphs` False) and nothing chooses.
    """
    chosen = [after for word, after in pairwise(words) if word == "--lang"]
    chosen += [word.partition("=")[2] for word in words if word.startswith("--lang=")]
    for name in (*chosen, environ.get(VARIABLE, "")):
        if name in LANGUAGES:
            return name
    return _language_of_locale(environ, platform) if wide_glyphs else "en"


def _language_of_locale(environ: Mapping[str, str], platform: str) -> str:
    for name in ("LC_ALL", "LC_MESSAGES", "LANGUAGE", "LANG"):
        if value := environ.get(name):
            return "zh" if value.lower().startswith("zh") else "en"
    if platform == "win32":  # which has none of these variables
        import locale

        name = locale.getlocale()[0] or ""  # zh_CN, or Chinese (Simplified)_China
        return "zh" if name.lower().startswith(("zh", "chinese")) else "en"
    return "en"
