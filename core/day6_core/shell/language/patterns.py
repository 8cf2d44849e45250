"""Patterns of the shell (`*`, `?`, `[…]`, and with `extglob` `@(a|b)` and its relatives) as regular expressions."""

from __future__ import annotations

import functools
import re
from dataclasses import dataclass

CLASSES = {
    "alpha": "a-zA-Z", "digit": "0-9", "alnum": "a-zA-Z0-9", "upper": "A-Z", "lower": "a-z", "xdigit": "0-9A-Fa-f",
    "space": r" \t\n\r\v\f", "blank": r" \t", "cntrl": r"\x00-\x1f\x7f", "print": r"\x20-\x7e", "graph": r"\x21-\x7e",
    "punct": r"!-/:-@\[-`{-~", "word": r"a-zA-Z0-9_", "ascii": r"\x00-\x7f",
}  # fmt: skip
_EXTENDED = "?*+@!"
_CHOICE = re.compile(r"[?*+@!]\(")
_SPECIAL = re.compile(r"[*?\[]")
_SPECIAL_EXTENDED = re.compile(r"[*?\[]|[+@!]\(")
Pieces = list[tuple[str, bool]]
"""Texts, each with whether it was quoted, and so is literal."""


@dataclass(frozen=True)
class Pattern:
    """A compiled pattern; `negated` ones of extglob need a look ahead, which `re` has."""

    expression: re.Pattern[str]
    simple: bool = True
    """Whether it has no pattern of extglob: then `match` finds the longest beginning."""

    def matches(self, text: str) -> bool:
        return self.expression.fullmatch(text) is not None


def special(pieces: Pieces, *, extended: bool = False) -> bool:
    """Whether there is something to match in it, rather than a plain text."""
    wanted = _SPECIAL_EXTENDED if extended else _SPECIAL
    return any(not quoted and wanted.search(text) for text, quoted in pieces)


def pattern(pieces: Pieces, *, extended: bool = True, ignore_case: bool = False, names: bool = False) -> Pattern:
    """Compile a pattern; `names`: of one part of a file name, in which nothing matches a `/`."""
    source = "".join(_escaped(text) if quoted else text for text, quoted in pieces)
    return _compiled(source, extended, ignore_case, names)


def _escaped(text: str) -> str:
    return "".join("\\" + char for char in text)


@functools.lru_cache(maxsize=512)
def _compiled(source: str, extended: bool, ignore_case: bool, names: bool) -> Pattern:
    translated = _Translator(source, extended).translated()
    simple = not extended or _CHOICE.search(source) is None
    return Pattern(re.compile(translated, re.DOTALL | (re.IGNORECASE if ignore_case else 0)), simple)


class _Translator:
    def __init__(self, source: str, extended: bool) -> None:
        self.source = source
        self.extended = extended
        self.at = 0

    def translated(self, closing: bool = False) -> str:
        found: list[str] = []
        source = self.source
        while self.at < len(source):
            char = source[self.at]
            if closing and char in "|)":
                break
            if self.extended and char in _EXTENDED and source.startswith("(", self.at + 1):
                found.append(self._choice(char, closing))
                continue
            self.at += 1
            if char == "\\":
                found.append(re.escape(source[self.at : self.at + 1] or "\\"))
                self.at += 1
            elif char == "*":
                if not found or found[-1] != ".*":
                    found.append(".*")
            elif char == "?":
                found.append(".")
            elif char == "[":
                found.append(self._bracket())
            else:
                found.append(re.escape(char))
        return "".join(found)

    def _choice(self, kind: str, nested: bool) -> str:
        """`?(a|b)` and so on; a plain text if its parenthesis is never closed."""
        start = self.at
        self.at += 2
        choices = [self.translated(closing=True)]
        while self.source.startswith("|", self.at):
            self.at += 1
            choices.append(self.translated(closing=True))
        if not self.source.startswith(")", self.at):
            self.at = start + 1
            return {"*": ".*", "?": "."}.get(kind, re.escape(kind))
        self.at += 1
        inner = "|".join(choices)
        if kind != "!":
            return f"(?:{inner})" + {"?": "?", "*": "*", "+": "+", "@": ""}[kind]
        # What is not one of them: any text up to where the rest of the pattern matches.
        rest = _Translator(self.source, self.extended)
        rest.at = self.at
        following = rest.translated(closing=nested)
        return f"(?!(?:{inner}){following}\\Z).*"

    def _bracket(self) -> str:
        """`[abc]`, `[!a-z]`, `[[:digit:]]`; a plain `[` if it is never closed."""
        source, start = self.source, self.at
        at = start
        negated = source[at : at + 1] in ("!", "^") and bool(source[at : at + 1])
        at += negated
        found: list[str] = []
        first = True
        while at < len(source):
            char = source[at]
            if char == "]" and not first:
                self.at = at + 1
                inside = "".join(found)
                if not inside:
                    return "(?!)" if not negated else "."
                return f"[{'^' if negated else ''}{inside}]"
            first = False
            if named := re.compile(r"\[:(\w+):\]").match(source, at):
                found.append(CLASSES.get(named[1], ""))
                at = named.end()
                continue
            char, at = self._member(at)
            if source[at : at + 1] == "-" and source[at + 1 : at + 2] not in ("", "]"):
                last, at = self._member(at + 1)
                if char <= last:
                    found.append(f"{_member(char)}-{_member(last)}")
            else:
                found.append(_member(char))
        self.at = start
        return re.escape("[")

    def _member(self, at: int) -> tuple[str, int]:
        if self.source[at] == "\\" and at + 1 < len(self.source):
            return self.source[at + 1], at + 2
        return self.source[at], at + 1


def _member(char: str) -> str:
    return "\\" + char if char in r"\]^-[&|~" else char
