"""Texts of the catalogue whose values may be texts, too."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from day6_core.isolation.cell import Phrase
from day6_tui.locale import Texts


class News(NamedTuple):
    """Something to be told: which one it is (from 1), the key of a text, and what fills it."""

    number: int
    key: str
    values: Mapping[str, object]


def told(texts: Texts, key: str, values: Mapping[str, object]) -> str:
    """Return the text in that language."""
    inner = {
        name: texts(each.key, **each.values) if isinstance(each, Phrase) else each for name, each in values.items()
    }
    return texts(key, **inner)
