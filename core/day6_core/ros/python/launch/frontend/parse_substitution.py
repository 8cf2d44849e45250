r"""Parses texts with substitutions, from XML and YAML launch files and parameter files: `$(find-pkg-share demo)/config`.

`$(name ARGUMENT ARGUMENT)`; an argument ends at a space or a closing bracket unless it is quoted with ' or ", and may contain
substitutions (in whose arguments quotes are plain). A backslash escapes the next character. A `$` without a bracket after it
is a plain `$`.
"""

from __future__ import annotations

import re
from typing import Any

from launch.substitution import Substitution

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")


_WANTED = {
    "name": ["IDENTIFIER"],
    "end of name": ["RPAR", "SPACE"],
    "argument": ["DBLQUOTE", "DOLLAR", "QUOTE", "UNQUOTED_RSTRING"],
    "end of argument": ["DOLLAR", "RPAR", "SPACE", "UNQUOTED_RSTRING"],
    "'": ["DOLLAR", "QUOTE", "SINGLE_QUOTED_STRING"],
    '"': ["DBLQUOTE", "DOLLAR", "DOUBLE_QUOTED_STRING"],
}
"""The tokens allowed at a place, by the names in the real launch's grammar."""


class UnexpectedInput(ValueError):
    """A text that cannot be parsed."""


class UnexpectedCharacters(UnexpectedInput):
    """A character that isn't allowed at its place."""


class UnexpectedEOF(UnexpectedInput):
    """The text ends inside a substitution."""


class VisitError(RuntimeError):
    """An unknown substitution, or one that rejects its arguments."""


def replace_escaped_characters(data: str) -> str:
    """Remove each backslash that escapes a character."""
    return re.sub(r"\\(.)", r"\1", data)


def parse_substitution(string_value: str) -> list[Substitution]:
    """Return the substitutions that a text consists of. Raises UnexpectedInput, VisitError."""
    from launch.substitutions.text_substitution import TextSubstitution

    if not string_value:
        return [TextSubstitution(text=string_value)]
    return _Reader(string_value).template("")


def parse_if_substitutions(value: Any) -> Any:
    """Return a text with substitutions parsed, any other value unchanged; of a list every item.

    Raises ValueError for a list of mixed types.
    """
    from launch.substitutions.text_substitution import TextSubstitution

    kinds: set[type] = set()

    def parse(item: Any) -> Any:
        if not isinstance(item, str):
            kinds.add(type(item))
            return item
        parts = parse_substitution(item)
        if len(parts) == 1 and isinstance(parts[0], TextSubstitution):
            kinds.add(str)
            return parts[0].text
        return parts

    result = [parse(each) for each in value] if isinstance(value, list) else parse(value)
    if len(kinds) > 1:
        raise ValueError("The result is a non-uniform list")
    return result


class _Reader:
    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0
        self.quote = ""
        """The quote that the reader is within."""

    def template(self, quote: str) -> list[Substitution]:
        """Read up to the closing quote (with '': to the end)."""
        parts: list[Substitution] = []
        plain = ""
        while self.at < len(self.text):
            if quote and self.text[self.at] == quote:
                break
            if self._at_substitution():
                parts += _plain(plain)
                plain = ""
                parts.append(self.substitution())
            else:
                plain += self._character()
        parts += _plain(plain)
        return parts

    def substitution(self) -> Substitution:
        from launch.frontend.expose import instantiate_substitution

        self.at += 2
        name = _NAME.match(self.text, self.at)
        if name is None:
            raise self._problem("name")
        self.at = name.end()
        arguments: list[list[Substitution]] = []
        while self._here() == " ":
            self.at += 1
            arguments.append(self._argument())
        if self._here() != ")":
            raise self._problem("end of argument" if arguments else "end of name")
        self.at += 1
        try:
            return instantiate_substitution(name.group(), arguments)
        except Exception as error:  # the substitution's own `parse` may raise anything
            raise VisitError(f'Error trying to process rule "substitution":\n\n{error}') from error

    def _argument(self) -> list[Substitution]:
        quote = self._here()
        if quote and quote in "'\"" and not self.quote:
            self.at += 1
            self.quote = quote
            parts = self.template(quote)
            self.quote = ""
            if self._here() != quote:
                raise self._problem(quote)
            self.at += 1
            return parts or _plain(" ")[:0]
        parts, plain = [], ""
        while self.at < len(self.text) and self._here() not in f" ){self.quote}":
            if self._at_substitution():
                parts += _plain(plain)
                plain = ""
                parts.append(self.substitution())
            else:
                plain += self._character()
        parts += _plain(plain)
        if not parts:
            raise self._problem("argument")
        return parts

    def _here(self) -> str:
        return self.text[self.at : self.at + 1]

    def _at_substitution(self) -> bool:
        return self.text.startswith("$(", self.at)

    def _character(self) -> str:
        if self._here() == "\\" and self.at + 1 < len(self.text):
            self.at += 1
        self.at += 1
        return self.text[self.at - 1]

    def _problem(self, wanted: str) -> UnexpectedInput:
        """Return the error that lists the tokens allowed at the current place."""
        expected = "".join(f"\t* {each}\n" for each in _WANTED[wanted])
        if self.at >= len(self.text):
            return UnexpectedEOF(f"Unexpected end-of-input. Expected one of: \n{expected}")
        before = self.text[: self.at].rpartition("\n")[2]
        rest = self.text[self.at :].partition("\n")[0]
        place = f"line {self.text.count(chr(10), 0, self.at) + 1} col {len(before) + 1}"
        shown = f"{before[-40:]}{rest[:40]}\n{' ' * len(before[-40:])}^"
        return UnexpectedCharacters(
            f"No terminal matches {self._here()!r} in the current parser context, at {place}\n\n{shown}\n"
            f"Expected one of: \n{expected}"
        )


def _plain(text: str) -> list[Substitution]:
    from launch.substitutions.text_substitution import TextSubstitution

    return [TextSubstitution(text=text)] if text else []
