"""Brace expansion: `a{b,c}`, `{1..3}`. Quoted text and expansions in the braces stay as they are."""

from __future__ import annotations

import itertools
import re
from dataclasses import replace

from day6_core.shell.language.words import Part, SyntaxProblem, Text, Variable, Word

MOST_WORDS = 1_000_000
"""Most words of a brace expansion; the real shell uses up all memory for more."""

Items = list[str | Part]
"""A word: single unquoted characters, and everything else as it is."""


class TooManyWords(SyntaxProblem):
    """More words than fit into memory."""

    def __init__(self) -> None:
        super().__init__("brace expansion: cannot allocate memory")


def braces(word: Word) -> list[Word]:
    """Return the words that the braces of a word make; the word itself if it has none."""
    if not any(isinstance(part, Text) and not part.quoted and "{" in part.text for part in word.parts):
        return [word]
    items: Items = []
    for part in word.parts:
        items.extend(part.text if isinstance(part, Text) and not part.quoted else [part])
    if _count(items) > MOST_WORDS:
        raise TooManyWords
    expanded = _expanded(items)
    return [word] if expanded == [items] else [replace(word, parts=_joined(each)) for each in expanded]


def _joined(items: Items) -> tuple[Part, ...]:
    parts: list[Part] = []
    for is_text, group in itertools.groupby(items, key=lambda item: isinstance(item, str)):
        if is_text:
            text = "".join(item for item in group if isinstance(item, str))
            if parts and isinstance(last := parts[-1], Variable) and last.bare and not last.quoted:
                name = re.match(r"\w*", text, re.ASCII)  # braces are expanded before names are read
                if name is not None and name[0]:
                    parts[-1], text = replace(last, name=last.name + name[0]), text[name.end() :]
            if text:
                parts.append(Text(text))
        else:
            parts.extend(item for item in group if not isinstance(item, str))
    return tuple(parts)


def _count(items: Items) -> int:
    """An upper bound of the words: adjacent braces multiply, commas add."""
    text = "".join(item if isinstance(item, str) else "x" for item in items)
    number = 1
    for inside in re.findall(r"\{([^{}]*)\}", text):
        number *= _range_length(inside) or inside.count(",") + 1
    return number


def _expanded(items: Items) -> list[Items]:
    start = -1
    while "{" in items[start + 1 :]:
        start = items.index("{", start + 1)
        depth, commas, end = 0, [], -1
        for at in range(start, len(items)):
            if items[at] == "{":
                depth += 1
            elif items[at] == "," and depth == 1:
                commas.append(at)
            elif items[at] == "}":
                depth -= 1
                if depth == 0:
                    end = at
                    break
        if end < 0:
            continue
        choices: list[Items]
        if commas:
            bounds = [start, *commas, end]
            choices = [one for a, b in itertools.pairwise(bounds) for one in _expanded(items[a + 1 : b])]
        else:
            inside = items[start + 1 : end]
            texts = _range("".join(map(str, inside))) if all(isinstance(item, str) for item in inside) else []
            choices = [list(text) for text in texts]
        if choices:
            return [[*items[:start], *choice, *rest] for choice in choices for rest in _expanded(items[end + 1 :])]
    return [items]


_RANGE = re.compile(r"([-+]?\d+)\.\.([-+]?\d+)(?:\.\.([-+]?\d+))?", re.ASCII)
_LETTERS = re.compile(r"([A-Za-z])\.\.([A-Za-z])(?:\.\.([-+]?\d+))?", re.ASCII)


def _range_length(inside: str) -> int:
    match = _RANGE.fullmatch(inside)
    if match is None:
        return len(_range(inside))
    return abs(int(match[2]) - int(match[1])) // (abs(int(match[3] or "1")) or 1) + 1


def _range(inside: str) -> list[str]:
    """The texts of `1..3` and `a..e..2`; [] for what is neither."""
    match = _RANGE.fullmatch(inside) or _LETTERS.fullmatch(inside)
    if match is None:
        return []
    step = abs(int(match[3] or "1")) or 1
    numbers = match.re is _RANGE
    first, last = (int(match[1]), int(match[2])) if numbers else (ord(match[1]), ord(match[2]))
    values = range(first, last + 1, step) if first <= last else range(first, last - 1, -step)
    if not numbers:
        return [chr(value) for value in values]
    ends = (match[1], match[2])
    padded = any(len(end) > 1 and end.lstrip("+-").startswith("0") and len(end.lstrip("+-")) > 1 for end in ends)
    width = max(map(len, ends)) if padded else 0
    return [f"{value:0{width}}" for value in values]
