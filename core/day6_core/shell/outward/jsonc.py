"""Sets keys of a JSON file with comments, such as VS Code's, and leaves every other character as it is."""

from __future__ import annotations

import json
import re
from typing import Any, NamedTuple

_TOKEN = re.compile(
    r"""(?P<string>"(?:[^"\\]|\\.)*")|(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<mark>[{}\[\],:])|(?P<space>\s+)|(?P<word>[^\s{}\[\],:"/]+)""",
    re.DOTALL,
)


class Span(NamedTuple):
    """The position of a key's value in the text."""

    start: int
    end: int


def parse(text: str) -> Any:
    """Return the value of a JSON text with comments and trailing commas. Raises ValueError."""
    return json.loads(_without_trailing_commas(text))


def spans(text: str) -> dict[str, Span]:
    """Return the positions of the values in the outermost object, by key. Raises ValueError if there is no object."""
    found: dict[str, Span] = {}
    depth, key, start, end = 0, "", -1, -1
    pending = ""
    for kind, token, at in _tokens(text):
        if kind in ("space", "comment"):
            continue
        if depth == 1 and token == ":" and start < 0:
            key, start = pending, len(text)
            continue
        if depth == 1 and token in (",", "}") and key:
            found[key] = Span(start, end)
            key, start = "", -1
        if token in ("{", "["):
            depth += 1
        elif token in ("}", "]"):
            depth -= 1
        if key:
            start, end = min(start, at), at + len(token)
        elif kind == "string" and depth == 1:
            pending = json.loads(token)
    if depth != 0:
        raise ValueError("brackets do not match")
    return found


def set_keys(text: str, values: dict[str, Any]) -> str:
    """Return the text with these keys of its outermost object set; an empty text is an empty object. Raises ValueError."""
    if not text.strip():
        text = "{\n}\n"
    if not isinstance(parse(text), dict):
        raise ValueError("it is no object")
    for key, value in values.items():
        where = spans(text)
        new = json.dumps(value, indent=4, ensure_ascii=False).replace("\n", "\n    ")
        if key in where:
            start, end = where[key]
            if parse(text[start:end]) != value:
                text = text[:start] + new + text[end:]
        else:
            text = _insert(text, f"{json.dumps(key, ensure_ascii=False)}: {new}")
    return text


def _insert(text: str, entry: str) -> str:
    """Put an entry before the closing bracket of the outermost object."""
    (_, last, at), (_, _, close_at) = [token for token in _tokens(text) if token[0] not in ("space", "comment")][-2:]
    end_of_last = at + len(last)
    comma = "" if last in ("{", ",") else ","
    between = text[end_of_last:close_at].rstrip()
    return f"{text[:end_of_last]}{comma}{between}\n    {entry}\n{text[close_at:]}"


def _tokens(text: str) -> list[tuple[str, str, int]]:
    found, at = [], 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError(f"not understood: {text[at : at + 20]!r}")
        found.append((str(match.lastgroup), match.group(), at))
        at = match.end()
    return found


def _without_trailing_commas(text: str) -> str:
    kept: list[str] = []
    for kind, token, _ in _tokens(text):
        if kind in ("space", "comment"):
            continue
        if token in ("}", "]") and kept and kept[-1] == ",":
            kept.pop()
        kept.append(token)
    return " ".join(kept)
