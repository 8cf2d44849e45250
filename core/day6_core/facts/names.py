"""Names that are nearly right."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import SequenceMatcher, get_close_matches

CLOSE = 0.75
"""How alike two names are of which one is taken for a slip of the other (difflib's ratio)."""

CLOSE_AMONG_FEW = 0.6
CLOSE_UNASKED = 0.8
"""How alike they have to be where nobody has complained of either name."""


def nearest(name: str, names: Sequence[str], close: float = CLOSE_AMONG_FEW) -> str:
    """Return which of some names was probably meant, '' if none is so near."""
    return next(iter(get_close_matches(name, names, 1, close)), "")


def last_part(name: str) -> str:
    """Return a name without its namespace."""
    return name.rpartition("/")[2]


def are_alike(one: str, other: str) -> bool:
    """Return whether two full names differ only by a typo: a letter or two, or the namespace."""
    if last_part(one) == last_part(other):
        return True
    return SequenceMatcher(None, one, other, autojunk=False).ratio() >= CLOSE_UNASKED


def absolute(name: str) -> str:
    """Return a name as one that begins with a slash."""
    return name if name.startswith("/") else f"/{name}"
