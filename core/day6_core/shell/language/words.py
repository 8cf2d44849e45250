"""The parts of a word of a command line, and the expansions `${…}` and `$'…'` in it."""

from __future__ import annotations

import re
from dataclasses import dataclass

from day6_core.shell.byte_text import joined, of_byte, of_code

_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{1,2}|u[0-9a-fA-F]{1,4}|U[0-9a-fA-F]{1,8}|[0-7]{1,3}|.)", re.DOTALL)
_NAMED = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "e": "\x1b", "E": "\x1b", "f": "\f", "v": "\v",
          "\\": "\\", "'": "'", '"': '"', "?": "?"}  # fmt: skip
_NAME = r"[A-Za-z_]\w*|\d+|[?!$#@*-]"
_PARAMETER = re.compile(rf"(?P<prefix>#(?=(?:{_NAME})(?:\[|$))|!(?=[A-Za-z_0-9@*#]))?(?P<name>{_NAME})", re.ASCII)
HAS_PATTERN = re.compile(rf"!?(?:{_NAME})(?:\[[^]]*\])?[%#/^,]", re.ASCII)
"""Matches the inside of a `${…}` whose operator takes a pattern, in which quotes are special even between quotes."""
TRANSFORMATIONS = frozenset("QEPAKakuUL")
"""Letters of `${NAME@Q}`."""
_BEHIND_A_NAME = (
    ":-", ":=", ":+", ":?", "-", "=", "+", "?", "%%", "%", "##", "#", "//", "/", "^^", "^", ",,", ",", "~~", "~", ":", "@",
)  # fmt: skip
"""Operators of `${NAME…}`, a longer one before its beginning."""

DECLARATIONS = frozenset({"declare", "typeset", "local", "export", "readonly"})
"""Commands whose arguments may be assignments, with arrays and without being split."""


class SyntaxProblem(Exception):
    """The line cannot be understood; the text is bash's, without its `bash: `."""

    status = 2


class Incomplete(SyntaxProblem):
    """The line goes on: a quote, a `$(`, a here-document or a compound command is still open."""


@dataclass(frozen=True)
class Text:
    text: str
    quoted: bool = False


@dataclass(frozen=True)
class Variable:
    """`$NAME`, or `${<prefix>NAME[<subscript>]<operator><argument>}`; the prefix is `#` (length) or `!` (keys, reference)."""

    name: str
    quoted: bool = False
    operator: str = ""
    argument: str = ""
    subscript: str | None = None
    prefix: str = ""
    bare: bool = False
    """Whether it is written without braces, and goes on where a brace expansion puts letters behind it."""


@dataclass(frozen=True)
class Substitution:
    """`$(source)`: the output of commands; `$((source))`: the value of an arithmetic expression."""

    source: str
    quoted: bool = False
    arithmetic: bool = False
    backquoted: bool = False

    @property
    def unread(self) -> bool:
        """Whether bash does not read it before it runs it."""
        return self.arithmetic or self.backquoted


@dataclass(frozen=True)
class ProcessSubstitution:
    """`<(source)` and `>(source)`."""

    source: str
    writes: bool
    """Whether it is `>(…)`, to be written to."""
    quoted: bool = False


@dataclass(frozen=True)
class ArrayLiteral:
    """`(…)` behind `NAME=`."""

    elements: tuple[Word, ...]
    quoted: bool = False


Part = Text | Variable | Substitution | ProcessSubstitution | ArrayLiteral


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


def end_of_arithmetic(source: str, start: int) -> int:
    """Where the `))` is that closes the `((` before `start`; -1 if its parentheses do not close together."""
    depth = 0
    for at in range(start, len(source)):
        if source[at] == "(":
            depth += 1
        elif source[at] == ")":
            if depth == 0:
                return at if source.startswith("))", at) else -1
            depth -= 1
    raise Incomplete("unexpected EOF while looking for matching `)'")


def end_of_subscript(text: str, start: int) -> int:
    """Where the `]` is that closes the `[` at `start`; -1 if there is none. Quotes and brackets inside it are skipped."""
    depth, at = 0, start
    while at < len(text):
        char = text[at]
        if char == "\\":
            at += 1
        elif char in "'\"":
            at = text.find(char, at + 1)
            if at < 0:
                return -1
        elif char == "[":
            depth += 1
        elif char == "]":
            depth -= 1
            if not depth:
                return at
        at += 1
    return -1


def braced(inside: str, quoted: bool) -> Variable:
    """Return the expansion `${inside}`; one that is wrong has the operator `bad`, because it is found out when it is expanded."""
    bad = Variable("", quoted, "bad", inside)
    match = _PARAMETER.match(inside)
    if match is None:
        return bad
    prefix, name, rest = match["prefix"] or "", match["name"], inside[match.end("name") :]
    subscript = None
    if rest.startswith("[") and (name[0].isalpha() or name[0] == "_"):
        end = end_of_subscript(rest, 0)
        if end < 2:
            return bad
        subscript, rest = rest[1:end], rest[end + 1 :]
    if prefix == "!" and rest in ("*", "@") and subscript is None:
        return Variable(name, quoted, "names", rest, prefix="!")
    if not rest:
        return Variable(name, quoted, subscript=subscript, prefix=prefix)
    for operator in _BEHIND_A_NAME:
        argument = rest[len(operator) :]
        if rest.startswith(operator) and prefix != "#" and (operator != "@" or argument in TRANSFORMATIONS):
            return Variable(name, quoted, operator, argument, subscript, prefix)
    return bad
