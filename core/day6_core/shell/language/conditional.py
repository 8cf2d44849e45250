"""`[[ … ]]`: its own little grammar, patterns and regular expressions; words in it are neither split nor globbed."""

from __future__ import annotations

import re
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from day6_core.session.task import in_turns
from day6_core.shell.language import file_tests
from day6_core.shell.language.arithmetic import evaluate
from day6_core.shell.language.expansion import expand_pattern, expand_regular, expand_text
from day6_core.shell.language.syntax import AndOrCondition, Condition, Not, Test
from day6_core.shell.language.words import Incomplete, SyntaxProblem, Text, Word
from day6_core.user_pattern import user_pattern

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.parser import Parser
    from day6_core.shell.language.redirection import Streams

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
    return Test(operator, (first, _operand(parser)))


def _is_end(parser: Parser) -> bool:
    return parser.is_keyword("]]") or parser.is_op("&&", "||", ")") or parser.token.kind in ("newline", "end")


def _operand(parser: Parser) -> Word:
    token = parser.token
    if token.kind == "end":
        raise Incomplete("unexpected EOF while looking for `]]'")
    if token.kind == "number":
        parser.take()
        return Word((Text(token.text),), token.text)
    return parser.word()


async def holds(condition: Condition, shell: Shell, streams: Streams) -> bool:
    """Whether the condition is true. Raises ValueError and OSError (bash's texts) if it cannot be evaluated."""
    if isinstance(condition, Not):
        return not await holds(condition.inner, shell, streams)
    if isinstance(condition, AndOrCondition):
        left = await holds(condition.left, shell, streams)
        return left if left == (condition.operator == "||") else await holds(condition.right, shell, streams)
    operator, operands = condition.operator, condition.operands
    left_text = await expand_text(operands[0], shell, streams)
    if not operator:
        return bool(left_text)
    if operator in ("-v", "-o"):
        return shell.parameter(left_text) is not None if operator == "-v" else left_text[:1] in shell.options
    if len(operands) == 1:
        return file_tests.unary(operator, left_text, shell.cwd)
    if operator == "=~":
        return await _matches(shell, left_text, await expand_regular(operands[1], shell, streams))
    if operator in ("=", "==", "!="):
        pattern = await expand_pattern(operands[1], shell, streams)
        return fnmatchcase(left_text, pattern) != (operator == "!=")
    right = await expand_text(operands[1], shell, streams)
    if operator in ("<", ">"):
        return left_text < right if operator == "<" else left_text > right
    if operator in file_tests.FILES:
        return file_tests.files(left_text, operator, right, shell.cwd)
    values = [evaluate(text, shell.variables) for text in (left_text, right)]
    return file_tests.INTEGER[operator](values[0], values[1])


async def _matches(shell: Shell, text: str, pattern: str) -> bool:
    """Search a regular expression; the match becomes `$BASH_REMATCH`, which is the first element of that array."""
    try:
        match = await in_turns(user_pattern(pattern).searching(text))
    except re.error as error:
        raise ValueError(f"{pattern}: {error}") from None
    shell.variables["BASH_REMATCH"] = match.whole if match is not None else ""
    return match is not None
