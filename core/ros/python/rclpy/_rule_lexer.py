"""Reads remap rules and parameter assignments as rcl does, with its error texts (rcl/lexer.c, rcl/arguments.c).

Numbers in the texts are rcl's lexeme types; they are part of what a user of real ROS sees.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from day6_tui.core.graph.names import RemapRule

NONE, EOF, TILDE_SLASH, URL_SERVICE, URL_TOPIC, COLON, NODE, NS, SEPARATOR = range(9)
TOKEN, FORWARD_SLASH, WILD_ONE, WILD_MULTI, DOT = range(18, 23)

_LEXEMES: tuple[tuple[int, re.Pattern[str]], ...] = tuple(
    (kind, re.compile(pattern))
    for kind, pattern in (
        (URL_SERVICE, r"rosservice://"),
        (URL_TOPIC, r"rostopic://"),
        (TILDE_SLASH, r"~/"),
        (SEPARATOR, r":="),
        (COLON, r":"),
        (NODE, r"__(node|name)(?![A-Za-z0-9_])"),
        (NS, r"__ns(?![A-Za-z0-9_])"),
        (TOKEN, r"[A-Za-z_][A-Za-z0-9_]*"),
        (FORWARD_SLASH, r"/"),
        (WILD_MULTI, r"\*\*"),
        (WILD_ONE, r"\*"),
        (DOT, r"\."),
    )
)


class RuleError(ValueError):
    """A rule that rcl would refuse; the text is what it puts after `Error: `."""


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
        """Take `node:` if the rule begins so."""
        if self.peek().kind == TOKEN and self.peek(1).kind == COLON:
            name = self.expect(TOKEN)
            self.expect(COLON)
            return name
        return None

    def matched_token(self, wildcard_lines: tuple[int, int, int]) -> None:
        if self.accept(TOKEN, NODE, NS) is not None:
            return
        kind = self.peek().kind
        one, many, other = wildcard_lines
        if kind == WILD_ONE:
            raise _error_at(one, "Wildcard '*' is not implemented")
        if kind == WILD_MULTI:
            raise _error_at(many, "Wildcard '**' is not implemented")
        raise _error_at(other, "Expecting token or wildcard")


def read_remap_rule(text: str) -> RemapRule:
    """Read `[node:]from:=to`, `[node:]__node:=name` or `[node:]__ns:=/namespace`. Raises RuleError."""
    reader = _Reader(text)
    node = reader.node_prefix()
    start = reader.place
    kind = reader.peek().kind
    if kind == NODE:
        reader.expect(NODE)
        reader.expect(SEPARATOR)
        name = reader.expect(TOKEN)
        reader.expect(EOF)
        return RemapRule("node", "__node", name, node)
    if kind == NS:
        reader.expect(NS)
        reader.expect(SEPARATOR)
        begin = reader.place
        reader.expect(FORWARD_SLASH)
        if reader.peek().kind != EOF:
            reader.expect(TOKEN)
        while reader.peek().kind != EOF:
            reader.expect(FORWARD_SLASH)
            reader.expect(TOKEN)
        return RemapRule("namespace", "__ns", text[begin:], node)
    scheme = reader.accept(URL_SERVICE, URL_TOPIC) or ""
    reader.accept(TILDE_SLASH, FORWARD_SLASH)
    reader.matched_token((1215, 1218, 1221))
    while reader.peek().kind != SEPARATOR:
        reader.expect(FORWARD_SLASH)
        reader.matched_token((1215, 1218, 1221))
    match = text[start + len(scheme) : reader.place]
    reader.expect(SEPARATOR)
    replacement = text[reader.place :]
    if reader.accept(TILDE_SLASH, FORWARD_SLASH) is None and not replacement:
        raise RuleError("error not set")
    if reader.accept(TOKEN, NODE, NS) is None:
        raise RuleError("error not set")
    while reader.peek().kind != EOF:
        reader.expect(FORWARD_SLASH)
        if reader.accept(TOKEN, NODE, NS) is None:
            raise RuleError("error not set")
    return RemapRule("name", scheme + match, replacement, node)


def read_parameter_rule(text: str) -> tuple[str, str, str]:
    """Read `[node:]name:=value`; returns node pattern, name and the value's text. Raises RuleError."""
    reader = _Reader(text)
    node = reader.node_prefix() or "/**"
    start = reader.place
    reader.accept(FORWARD_SLASH)
    reader.matched_token((1321, 1324, 1327))
    while reader.peek().kind != SEPARATOR:
        if reader.accept(FORWARD_SLASH) is None:
            reader.expect(DOT)
            reader.accept(FORWARD_SLASH)
        reader.matched_token((1321, 1324, 1327))
    name = text[start : reader.place]
    reader.expect(SEPARATOR)
    value = text[reader.place :]
    if not value:
        raise RuleError("error not set")
    return node, name, value
