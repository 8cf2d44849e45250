"""Chinese punctuation and wide characters where a file needs the ones of English: typed with the input method still on."""

from __future__ import annotations

import re
import unicodedata

PUNCTUATION = {"“": '"', "”": '"', "‘": "'", "’": "'", "。": ".", "、": ",", "【": "[", "】": "]", "《": "<", "》": ">",
               "—": "-", "–": "-", "−": "-", "×": "*", "÷": "/", "…": "..."}  # fmt: skip
"""Characters whose counterpart in code Unicode does not know."""

_NUMBERS = re.compile(r"[-+.\deE\s]*")
_QUOTED = re.compile(r"\"[^\"“”]*\"|'[^']*'")


def english(text: str) -> str:
    """Return a text with what code has in the place of such signs and of wide digits and letters."""
    return "".join(char if char.isascii() else _counterpart(char) or char for char in text)


def _counterpart(char: str) -> str:
    right = PUNCTUATION.get(char) or unicodedata.normalize("NFKC", char)
    return right if right.isascii() else ""


def sign_in(text: str) -> str:
    """Return the first such character, '' if there is none."""
    return next((char for char in text if not char.isascii() and _counterpart(char)), "")


def numbers(value: str) -> str:
    """Return a value of numbers put right: `0，1，0` is `0 1 0`; '' if no such sign is what is wrong with it."""
    right = " ".join(english(value).replace(",", " ").split())
    return right if sign_in(value) and _NUMBERS.fullmatch(right) else ""


def sign_outside_quotes(tag: str) -> str:
    """Return the first such character of a tag that is not in the value of an attribute, '' if there is none."""
    return sign_in(_QUOTED.sub("", tag))
