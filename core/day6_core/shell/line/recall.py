"""History expansion: `!!`, `!12`, `!-2`, `!ros2`, `!$` are replaced in a typed line before anything else is done with it."""

from __future__ import annotations

import re

_EVENT = re.compile(r"!(?:(!)|(-?\d+)|\?([^?]+)\??|([$^*])|([^\s=(\"';&|<>]+))")
_SWAP = re.compile(r"\^([^^]+)\^([^^]*)\^?$")


class NoSuchLine(Exception):
    """Nothing in the history fits; the text is bash's."""


def recalled(line: str, history: list[str]) -> str:
    """Return `line` with its history expansions replaced (`history`: oldest first). Raises NoSuchLine.

    Between `'`, after a backslash, and before white space, `=` and `(`, `!` is an ordinary character.
    """
    swap = _SWAP.match(line)
    if swap is not None:
        last = _find(history, -1, line)
        if swap[1] not in last:
            raise NoSuchLine(f":s{line}: substitution failed")
        return last.replace(swap[1], swap[2], 1)
    result: list[str] = []
    at = 0
    quoted = False
    while at < len(line):
        char = line[at]
        if char == "\\" and not quoted:
            result.append(line[at : at + 2])
            at += 2
            continue
        if char == "'" and '"' not in "".join(result):
            quoted = not quoted
        match = _EVENT.match(line, at) if char == "!" and not quoted else None
        result.append(_meaning(match, history) if match is not None else char)
        at = match.end() if match is not None else at + 1
    return "".join(result)


def _meaning(match: re.Match[str], history: list[str]) -> str:
    bang, number, inside, word, begin = match.groups()
    if bang:
        return _find(history, -1, "!!")
    if number:
        index = int(number)
        if index == 0:
            raise NoSuchLine(f"{match[0]}: event not found")
        return _find(history, index - 1 if index > 0 else index, match[0])
    if word:
        words = _find(history, -1, match[0]).split()
        return {"$": words[-1], "^": words[1] if len(words) > 1 else "", "*": " ".join(words[1:])}[word]
    for line in reversed(history):
        if (inside and inside in line) or (begin and line.startswith(begin)):
            return line
    raise NoSuchLine(f"{match[0]}: event not found")


def _find(history: list[str], index: int, asked: str) -> str:
    try:
        return history[index]
    except IndexError:
        raise NoSuchLine(f"{asked}: event not found") from None
