"""The grammar of `[[ … ]]`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.shell.language import file_tests
from day6_core.shell.language.syntax import AndOrCondition, Condition, Not, Test
from day6_core.shell.language.words import Incomplete, SyntaxProblem, Text, Word

if TYPE_CHECKING:
    from day6_core.shell.language.parser import Parser

_BINARY = frozenset({"=", "==", "!=", "=~", *file_tests.INTEGER, *file_tests.FILES})


def parse_condition(parser: Parser) -> Condition:
    """Read a condition up to its `]]`, which is not consumed."""
    return _both(parser, "||")


def _both(parser: Parser, operator: str) -> Condition:
    def operand() -> Condition:
        return _both(parser, "&&") if operator == "||" else _single(parser)

    condition = operand()
    while True:
        parser.skip_newlines()
        if not parser.is_op(operator):
            return condition
        parser.take()
        condition = AndOrCondition(operator, condition, operand())


def _single(parser: Parser) -> Condition:
    parser.skip_newlines()
    if parser.is_keyword("!"):
        parser.take()
        return Not(_single(parser))
    if parser.is_op("("):
        parser.take()
        inner = parse_condition(parser)
        if not parser.is_op(")"):
            parser.unexpected()
        parser.take()
        return inner
    first = _operand(parser)
    if first.plain in file_tests.UNARY and not _is_end(parser):
        return Test(first.plain, (_operand(parser),))
    if _is_end(parser):
        return Test("", (first,))
    operator = parser.take().text
    if operator == "=~":
        return Test(operator, (first, parser.pattern()))
    if operator not in _BINARY and operator not in ("<", ">"):
        raise SyntaxProblem("conditional binary operator expected")
    return Test(operator, (first, _operand(parser, extglob=operator in ("=", "==", "!="))))


def _is_end(parser: Parser) -> bool:
    return parser.is_keyword("]]") or parser.is_op("&&", "||", ")") or parser.token.kind in ("newline", "end")


def _operand(parser: Parser, *, extglob: bool = False) -> Word:
    with parser.extended(extglob):
        token = parser.token
    if token.kind == "end":
        raise Incomplete("unexpected EOF while looking for `]]'")
    if token.kind == "number":
        parser.take()
        return Word((Text(token.text),), token.text)
    return parser.word()
