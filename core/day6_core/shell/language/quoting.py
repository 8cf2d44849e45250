"""Texts as they could be typed again: `${x@Q}`, `printf %q`, `declare -p`, `set -x`."""

from __future__ import annotations

import re
from collections.abc import Iterable

from day6_core.shell.language.variables import ATTRIBUTES, Cell

_PLAIN = re.compile(r"[\w@%+=:,./\-\x80-\U0010ffff]+")
_CONTROL = re.compile(r"[\x00-\x1f\x7f\ud800-\udfff]")
_ESCAPES = {"\n": r"\n", "\t": r"\t", "\r": r"\r", "\a": r"\a", "\b": r"\b", "\x1b": r"\E", "\f": r"\f", "\v": r"\v",
            "\\": r"\\", "'": r"\'"}  # fmt: skip
_NEEDS_BACKSLASH = re.compile(r"[ !\"$&'()*,;<>?\[\\\]^`{|}~#\t]")
_META = re.compile(r"[ \t\n'\"\\|&;()<>!{}*\[\]?^$`]|^~|[:=]~|(?:^|\s)#")


class Compound(str):
    """An argument of `declare` and its relatives that is an array: `name=(…)`, its elements quoted."""


def dollar_quoted(text: str) -> str:
    """`$'…'`."""
    return "$'" + "".join(_ESCAPES.get(char) or _byte(char) for char in text) + "'"


def _byte(char: str) -> str:
    code = ord(char)
    if 0xDC80 <= code <= 0xDCFF:
        return f"\\{code - 0xDC00:03o}"
    return f"\\{code:03o}" if code < 32 or code == 127 else char


def single_quoted(text: str) -> str:
    """`'…'`, or `$'…'` where there are characters that cannot be seen."""
    if _CONTROL.search(text):
        return dollar_quoted(text)
    return "'" + text.replace("'", "'\\''") + "'"


def double_quoted(text: str) -> str:
    """`"…"`, as `declare -p` shows a value."""
    if _CONTROL.search(text):
        return dollar_quoted(text)
    return '"' + re.sub(r'([$`"\\])', r"\\\1", text) + '"'


def backslashed(text: str) -> str:
    """As `printf %q`: backslashes before what is special."""
    if not text:
        return "''"
    if _CONTROL.search(text):
        return dollar_quoted(text)
    text = re.sub(r"[ !\"$&'()*,;<>?\[\\\]^`{|}\t]", lambda match: "\\" + match[0], text)
    return re.sub(r"^[#~]|(?<=[:=])~", lambda match: "\\" + match[0], text)


def traced(word: str) -> str:
    """A word as `set -x` shows it."""
    if _META.search(word) or not word:
        return "'" + word.replace("'", "'\\''") + "'"
    return visible(word)


def visible(text: str) -> str:
    """A name as messages show it."""
    return dollar_quoted(text) if _CONTROL.search(text) else text


def listed(text: str) -> str:
    """A value as `set` without arguments shows it: quoted only where it must be."""
    if text and not _CONTROL.search(text) and not _META.search(text):
        return text
    return single_quoted(text) if text else ""


def array_text(cell: Cell, *, quote: str = "double") -> str:
    """`([0]="a" [1]="b")`."""
    quoted = double_quoted if quote == "double" else single_quoted
    keys = cell.keys()
    values = cell.items or {}
    items = [f"[{_key(key) if cell.keyed else key}]={quoted(values[key])}" for key in keys]
    return "(" + " ".join(items) + (" )" if cell.keyed and items else ")")


def _key(key: str) -> str:
    return key if _PLAIN.fullmatch(key) else double_quoted(key)


def literal(items: Iterable[tuple[str | None, str, bool]]) -> str:
    """The elements of an array with their quotes, to be read again."""
    return (
        "("
        + " ".join(
            single_quoted(value)
            if key is None
            else f"[{key if key.isdigit() else single_quoted(key)}]{'+' if extends else ''}={single_quoted(value)}"
            for key, value, extends in items
        )
        + ")"
    )


def declared(name: str, cell: Cell) -> str:
    """The line of `declare -p`."""
    flags = "".join(letter for letter in ATTRIBUTES if letter in cell.attributes)
    head = f"declare -{flags or '-'} {name}"
    if cell.items is not None:
        return f"{head}={array_text(cell)}" if cell.items or not cell.keyed else f"{head}=()"
    return head if cell.text is None else f"{head}={double_quoted(cell.text)}"
