"""The parts of a word of a command line, and the expansions `${…}` and `$'…'` in it."""

from __future__ import annotations

import re
from dataclasses import dataclass

from day6_core.shell.byte_text import joined, of_byte, of_code

_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{1,2}|u[0-9a-fA-F]{1,4}|U[0-9a-fA-F]{1,8}|[0-7]{1,3}|.)", re.DOTALL)
_NAMED = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "e": "\x1b", "E": "\x1b", "f": "\f", "v": "\v",
          "\\": "\\", "'": "'", '"': '"', "?": "?"}  # fmt: skip
_NAME = r"[A-Za-z_]\w*|\d+|[?!$#@*-]"
_PARAMETER = re.compile(rf"#(?P<length>{_NAME})$|!(?P<indirect>[A-Za-z_]\w*)$|(?P<name>{_NAME})", re.ASCII)
HAS_PATTERN = re.compile(rf"(?:{_NAME})[%#/]", re.ASCII)
"""Matches the inside of a `${…}` whose operator takes a pattern, in which quotes are special even between quotes."""
_BEHIND_A_NAME = (
    ":-", ":=", ":+", ":?", "-", "=", "+", "?", "%%", "%", "##", "#", "//", "/", "^^", "^", ",,", ",", ":",
)  # fmt: skip
"""Operators of `${NAME…}`, a longer one before its beginning."""


class SyntaxProblem(Exception):
    """The line cannot be understood; the text is bash's, without its `bash: `."""


class Incomplete(SyntaxProblem):
    """The line goes on: a quote, a `$(`, a here-document or a compound command is still open."""


@dataclass(frozen=True)
class Text:
    text: str
    quoted: bool = False


@dataclass(frozen=True)
class Variable:
    """`$NAME`, or `${NAME<operator><argument>}`; `#` without an argument is the length, `!` the value of what it names."""

    name: str
    quoted: bool = False
    operator: str = ""
    argument: str = ""


@dataclass(frozen=True)
class Substitution:
    """`$(source)`: the output of commands; `$((source))`: the value of an arithmetic expression."""

    source: str
    quoted: bool = False
    arithmetic: bool = False


Part = Text | Variable | Substitution


@dataclass(frozen=True)
class Word:
    parts: tuple[Part, ...]
    source: str

    @property
    def plain(self) -> str | None:
        """The text of a word that has no quotes or expansions, else None; only such a word can be a keyword."""
        if all(isinstance(part, Text) and not part.quoted for part in self.parts):
            return "".join(part.text for part in self.parts if isinstance(part, Text))
        return None


def unescaped(text: str) -> str:
    """Return the text of `$'…'`: backslash escapes are C's."""
    return joined(_ESCAPE.sub(_character, text))


def _character(match: re.Match[str]) -> str:
    """What an escape of `$'…'` stands for."""
    code = match[1]
    if code in _NAMED:
        return _NAMED[code]
    if code[0] == "x" and len(code) > 1:
        return of_byte(int(code[1:], 16))
    if code[0] in "uU" and len(code) > 1:
        return of_code(int(code[1:], 16))
    if code[0] in "01234567":
        return of_byte(int(code, 8) & 0xFF)
    return "\\" + code


def braced(inside: str, quoted: bool) -> Variable:
    """Return the expansion `${inside}`. Raises SyntaxProblem."""
    match = _PARAMETER.match(inside)
    if match is None:
        raise SyntaxProblem(f"${{{inside}}}: bad substitution")
    if match["length"]:
        return Variable(match["length"], quoted, "#")
    if match["indirect"]:
        return Variable(match["indirect"], quoted, "!")
    name, rest = match["name"], inside[match.end("name") :]
    if not rest:
        return Variable(name, quoted)
    for operator in _BEHIND_A_NAME:
        if rest.startswith(operator):
            return Variable(name, quoted, operator, rest[len(operator) :])
    raise SyntaxProblem(f"${{{inside}}}: bad substitution")
