"""Names that look alike, as "mаllory" with a Cyrillic а does beside "mallory"; after Unicode's technical standard 39.

Chinese, Japanese and Korean names are always fine, also beside Latin letters. Only who chooses a name is judged, not a
list that a teacher has written.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

_WITH_ALL = (
    "CJK",
    "IDEOGRAPHIC",
    "HIRAGANA",
    "KATAKANA",
    "KATAKANA-HIRAGANA",
    "BOPOMOFO",
    "HANGUL",
    "HALFWIDTH",
    "MODIFIER",
)
"""First words of the Unicode names of letters that stand beside those of any alphabet."""

_PAIRS = (
    ("АВЕЗІЈКМНОРЅСТУХҮԚԜҺӀ", "ABE3IJKMHOPSCTYXYQWhl"),
    ("асеһіјкорѕухѵԁԛԝүӏгп", "acehijkopsyxvdqwylrn"),
    ("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧϹϳ", "ABEZHIKMNOPTYXCj"),
    ("αγηικνορτυχωϲ", "aynikvoptuxwc"),
    ("ıɑɡɩʋǀǃ", "iagiulI"),
    ("エオカタトニハヘリロー一", "工才力夕卜二八へり口一一"),
    ("〇", "o"),
)
"""Letters, and what they look like."""

_LOOK = {ord(mine): other for letters, others in _PAIRS for mine, other in zip(letters, others, strict=True)}
_STROKES = str.maketrans({"I": "l", "1": "l", "0": "o", "O": "o"})
_DRAWN_AS_TWO = (("rn", "m"), ("vv", "w"))
_BETWEEN_NUMBERS = re.compile(r"(?<=\d)[\W_]+(?=\d)")
_SMALL_CAPITAL = re.compile(r"LATIN LETTER SMALL CAPITAL ([A-Z])")


def mixes_alphabets(name: str) -> bool:
    """Whether a word of the name has letters of several alphabets: who writes it so wants to be taken for another."""
    words = "".join(
        letter if unicodedata.category(letter)[0] in "LM" else " " for letter in unicodedata.normalize("NFKD", name)
    ).split()
    return any(len(_alphabets(word)) > 1 for word in words)


def _alphabets(word: str) -> set[str]:
    found = {unicodedata.name(letter, "?").split()[0] for letter in word if unicodedata.category(letter)[0] == "L"}
    return found.difference(_WITH_ALL)


def looks_like(name: str, others: Iterable[str]) -> str | None:
    """Return the first of the others that this name could be taken for; None if there is none."""
    own = _looks(name)
    return next((other for other in others if own & _looks(other)), None)


def _looks(name: str) -> set[tuple[bool, str]]:
    """What somebody sees who does not look closely: as it is written, and without regard to capitals."""
    plain = _plain(name).translate(_LOOK)
    drawn = plain.translate(_STROKES)
    for two, one in _DRAWN_AS_TWO:
        drawn = drawn.replace(two, one)
    return {(True, drawn), (False, plain.casefold().translate(_LOOK).translate(_STROKES))}


def _plain(name: str) -> str:
    """Letters, their accents and digits in their plain forms; of what stands between them only what parts two numbers."""
    pieces = _BETWEEN_NUMBERS.split(unicodedata.normalize("NFKD", name))
    return "-".join(
        "".join(_small_capital(each) for each in piece if unicodedata.category(each)[0] in "LMN") for piece in pieces
    )


def _small_capital(letter: str) -> str:
    found = _SMALL_CAPITAL.fullmatch(unicodedata.name(letter, ""))
    return letter if found is None else found[1].lower()
