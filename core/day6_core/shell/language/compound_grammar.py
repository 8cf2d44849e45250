"""The grammar of `for`, `select`, `while`, `until`, `case` and `if`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.shell.language.syntax import ArithmeticFor, Case, For, If, Sequence, While
from day6_core.shell.language.tokens import ENDS_OF_CHOICE
from day6_core.shell.language.words import SyntaxProblem, Word

if TYPE_CHECKING:
    from day6_core.shell.language.parser import Parser


def for_loop(parser: Parser) -> For | ArithmeticFor:
    asks = parser.take().text == "select"
    if parser.is_op("(") and not asks:
        return arithmetic_for(parser)
    name = parser.take()
    if name.word is None or not (name.word.plain or "").isidentifier():
        raise SyntaxProblem(f"`{name.text}': not a valid identifier")
    words: list[Word] | None = None
    parser.skip_newlines()
    if parser.is_keyword("in"):
        parser.take()
        words = []
        while parser.token.word is not None:
            words.append(parser.token.word)
            parser.take()
    return For(name.text, words, loop_body(parser), asks)


def arithmetic_for(parser: Parser) -> ArithmeticFor:
    bracket = parser.take()
    parts = (parser.arithmetic(bracket) or "").split(";")
    if len(parts) != 3:
        raise SyntaxProblem("syntax error: arithmetic expression required")
    return ArithmeticFor(parts[0], parts[1], parts[2], loop_body(parser))


def loop_body(parser: Parser) -> Sequence:
    if parser.is_op(";"):
        parser.take()
    parser.skip_newlines()
    braces = parser.is_keyword("{")
    parser.expect_keyword("{" if braces else "do")
    body = parser.body()
    parser.expect_keyword("}" if braces else "done")
    return body


def case(parser: Parser) -> Case:
    parser.take()
    command = Case(parser.word(), [])
    parser.skip_newlines()
    parser.expect_keyword("in")
    parser.skip_newlines()
    while not parser.is_keyword("esac"):
        if parser.is_op("("):
            parser.take()
        patterns = [parser.word()]
        while parser.is_op("|"):
            parser.take()
            patterns.append(parser.word())
        if not parser.is_op(")"):
            parser.unexpected()
        parser.take()
        body = parser.sequence()
        end = parser.take().text if parser.is_op(*ENDS_OF_CHOICE) else ";;"
        command.choices.append((patterns, body, end))
        parser.skip_newlines()
    parser.take()
    return command


def if_command(parser: Parser) -> If:
    branches: list[tuple[Sequence, Sequence]] = []
    otherwise = None
    while True:
        parser.take()  # if, elif
        condition = parser.body()
        parser.expect_keyword("then")
        branches.append((condition, parser.body()))
        if not parser.is_keyword("elif"):
            break
    if parser.is_keyword("else"):
        parser.take()
        otherwise = parser.body()
    parser.expect_keyword("fi")
    return If(branches, otherwise)


def while_loop(parser: Parser) -> While:
    until = parser.take().text == "until"
    condition = parser.body()
    parser.expect_keyword("do")
    command = While(condition, parser.body(), until)
    parser.expect_keyword("done")
    return command
