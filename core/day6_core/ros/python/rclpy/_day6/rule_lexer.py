"""Reads remap rules and parameter assignments as rcl does, with its error texts (rcl/lexer.c, rcl/arguments.c).

Numbers in the texts are rcl's lexeme types; users of real ROS see them too.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple, NoReturn

from day6_core.graph.names import RemapRule

NONE, EOF, TILDE_SLASH, URL_SERVICE, URL_TOPIC, COLON, NODE, NS, SEPARATOR = range(9)
BACKREFERENCE = 9
"""The first of nine: `\\1` to `\\9`."""
TOKEN, FORWARD_SLASH, WILD_ONE, WILD_MULTI, DOT = range(18, 23)

_LEXEMES: tuple[tuple[int, re.Pattern[str]], ...] = tuple(
    (kind, re.compile(pattern))
    for kind, pattern in (
        (URL_SERVICE, r"rosservice://"),
        (URL_TOPIC, r"rostopic://"),
        (TILDE_SLASH, r"~/"),
        (SEPARATOR, r":="),
        (COLON, r":"),
        (NODE, r"__(node|name)"),
        (NS, r"__ns"),
        # A second underscore in a row begins another token, and none begins with two.
        (TOKEN, r"(?!__)[A-Za-z_](?:[A-Za-z0-9]|(?<!_)_)*"),
        (FORWARD_SLASH, r"/"),
        (WILD_MULTI, r"\*\*"),
        (WILD_ONE, r"\*"),
        (DOT, r"\."),
        (BACKREFERENCE, r"\\[1-9]"),
    )
)


class RuleError(ValueError):
    """A rule that rcl would reject; the text is the one it prints after `Error: `, `warning` the one it logs before that."""

    def __init__(self, message: str, warning: str = "") -> None:
        super().__init__(message)
        self.warning = warning


class _Lexeme(NamedTuple):
    kind: int
    start: int
    text: str


def _error_at(line: int, message: str) -> RuleError:
    return RuleError(f"{message}, at /project/src/rcl/arguments.c:{line}")


class _Reader:
    """Takes a rule apart lexeme by lexeme."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.place = 0

    def peek(self, ahead: int = 0) -> _Lexeme:
        place = self.place
        while True:
            lexeme = self._at(place)
            if ahead == 0 or lexeme.kind in (NONE, EOF):
                return lexeme
            place += len(lexeme.text)
            ahead -= 1

    def _at(self, place: int) -> _Lexeme:
        if place >= len(self.text):
            return _Lexeme(EOF, place, "")
        for kind, pattern in _LEXEMES:
            match = pattern.match(self.text, place)
            if match:
                return _Lexeme(kind, place, match[0])
        return _Lexeme(NONE, place, "")

    def accept(self, *kinds: int) -> str | None:
        """Take the next lexeme if it is of one of these kinds."""
        lexeme = self.peek()
        if lexeme.kind not in kinds:
            return None
        self.place += len(lexeme.text)
        return lexeme.text

    def expect(self, kind: int) -> str:
        """Take the next lexeme; RuleError if it is of another kind."""
        lexeme = self.peek()
        if lexeme.kind == kind:
            self.place += len(lexeme.text)
            return lexeme.text
        if lexeme.kind in (NONE, EOF):
            message = f"Expected lexeme type ({kind}) not found, search ended at index {lexeme.start}"
            raise RuleError(f"{message}, at /project/src/rcl/lexer_lookahead.c:238")
        message = f"Expected lexeme type {kind}, got {lexeme.kind} at index {lexeme.start}"
        raise RuleError(f"{message}, at /project/src/rcl/lexer_lookahead.c:243")

    def node_prefix(self) -> str | None:
        """Take `node:` if the rule begins with it."""
        if self.peek().kind == TOKEN and self.peek(1).kind == COLON:
            name = self.expect(TOKEN)
            self.expect(COLON)
            return name
        return None

    def matched_token(self) -> None:
        if self.accept(TOKEN, NODE, NS) is None:
            self._refuse_wildcard((1215, 1218, 1221))

    def parameter_token(self) -> None:
        """Take the part between two dots of a parameter's name: tokens and slashes in any order."""
        if self.accept(TOKEN, FORWARD_SLASH) is None:
            self._refuse_wildcard((1321, 1324, 1327))
        while self.accept(TOKEN, FORWARD_SLASH) is not None:
            pass

    def replacement_token(self) -> None:
        if self.peek().kind == BACKREFERENCE:
            raise _error_at(1110, "Backreferences are not implemented")
        if self.accept(TOKEN) is None:
            raise RuleError("error not set")

    def _refuse_wildcard(self, wildcard_lines: tuple[int, int, int]) -> NoReturn:
        kind = self.peek().kind
        one, many, other = wildcard_lines
        if kind == WILD_ONE:
            raise _error_at(one, "Wildcard '*' is not implemented")
        if kind == WILD_MULTI:
            raise _error_at(many, "Wildcard '**' is not implemented")
        raise _error_at(other, "Expecting token or wildcard")


@contextmanager
def _warning(text: str) -> Iterator[None]:
    try:
        yield
    except RuleError as error:
        raise RuleError(str(error), text) from None


def read_remap_rule(text: str) -> RemapRule:
    """Read `[node:]from:=to`, `[node:]__node:=name` or `[node:]__ns:=/namespace`. Raises RuleError."""
    reader = _Reader(text)
    node = reader.node_prefix()
    start = reader.place
    kind = reader.peek().kind
    if kind == NODE:
        reader.expect(NODE)
        reader.expect(SEPARATOR)
        with _warning(f"Node name not remapped to invalid name: '{text[reader.place :]}'"):
            name = reader.expect(TOKEN)
        reader.expect(EOF)
        return RemapRule("node", "__node", name, node)
    if kind == NS:
        reader.expect(NS)
        reader.expect(SEPARATOR)
        namespace = text[reader.place :]
        with _warning(f"Namespace not remapped to a fully qualified name (found: {namespace})"):
            reader.expect(FORWARD_SLASH)
            # A slash at the end is accepted here; the name is rejected when a node is made.
            while reader.accept(TOKEN) is not None and reader.accept(FORWARD_SLASH) is not None:
                pass
            reader.expect(EOF)
        return RemapRule("namespace", "__ns", namespace, node)
    scheme = reader.accept(URL_SERVICE, URL_TOPIC) or ""
    reader.accept(TILDE_SLASH, FORWARD_SLASH)
    reader.matched_token()
    while reader.peek().kind != SEPARATOR:
        reader.expect(FORWARD_SLASH)
        reader.matched_token()
    match = text[start + len(scheme) : reader.place]
    reader.expect(SEPARATOR)
    replacement = text[reader.place :]
    if reader.accept(TILDE_SLASH, FORWARD_SLASH) is None and not replacement:
        raise RuleError("error not set")
    reader.replacement_token()
    while reader.peek().kind != EOF:
        reader.expect(FORWARD_SLASH)
        reader.replacement_token()
    return RemapRule("name", scheme + match, replacement, node)


def read_parameter_rule(text: str) -> tuple[str, str, str]:
    """Read `[node:]name:=value`; returns node pattern, name and the value's text. Raises RuleError."""
    reader = _Reader(text)
    node = reader.node_prefix() or "/**"
    start = reader.place
    reader.parameter_token()
    while reader.peek().kind != SEPARATOR:
        reader.expect(DOT)
        reader.parameter_token()
    name = text[start : reader.place]
    reader.expect(SEPARATOR)
    value = text[reader.place :]
    if not value:
        raise RuleError("error not set")
    return node, name, value


def read_level_rule(text: str) -> str:
    """Check `logger:=level`; returns the word for the level. Raises RuleError."""
    reader = _Reader(text)
    reader.place = text.index(":=")
    reader.expect(SEPARATOR)
    level = reader.expect(TOKEN)
    reader.expect(EOF)
    return level
