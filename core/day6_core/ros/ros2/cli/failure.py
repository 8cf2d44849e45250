"""Turns an exception into the lines that the user reads: Python's own last lines, never our traceback."""

from __future__ import annotations

import traceback

_GUESS = "Did you mean"


def failure_text(error: BaseException) -> str:
    """Return what Python prints below the traceback of an uncaught exception, with the hint `Did you mean`."""
    text = "".join(traceback.format_exception_only(type(error), error))
    # Python 3.12 and later, and a backport that some packages install, have put it behind the message already.
    hint = "" if text.count(_GUESS) > str(error).count(_GUESS) else _hint(error)
    return f"{text.rstrip()}{hint}\n" if hint else text


def _hint(error: BaseException) -> str:
    if not isinstance(error, AttributeError) or not isinstance(error.name, str) or error.obj is None:
        return ""
    guess = nearest_name(error.name, dir(error.obj))
    return f". {_GUESS}: {guess!r}?" if guess else ""


def nearest_name(wrong: str, names: list[str]) -> str | None:
    """Return the name that Python 3.11 would suggest for a misspelt attribute, None if nothing is near enough.

    CPython, Python/suggestions.c: two points for an inserted, removed or changed letter, one for a change of case, and at
    most (both lengths + 3) / 3 points.
    """
    best: tuple[int, str] | None = None
    for name in names:
        if name == wrong or (name.startswith("_") and not wrong.startswith("_")):
            continue
        limit = (len(wrong) + len(name) + 3) * 2 // 6
        if best is not None:
            limit = min(limit, best[0] - 1)
        distance = _distance(wrong, name)
        if distance <= limit:
            best = (distance, name)
    return best[1] if best else None


def _distance(wrong: str, right: str) -> int:
    row = [2 * number for number in range(len(right) + 1)]
    for number, letter in enumerate(wrong, 1):
        left, row[0] = row[0], 2 * number
        for position, candidate in enumerate(right, 1):
            change = 0 if letter == candidate else 1 if letter.lower() == candidate.lower() else 2
            left, row[position] = row[position], min(left + change, row[position] + 2, row[position - 1] + 2)
    return row[-1]
