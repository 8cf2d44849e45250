"""The grammar: tokens to a tree of commands, by recursive descent. What each node does is in `interpreter` and `compound`."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Generator, Iterator, Mapping
from contextlib import contextmanager
from typing import NoReturn

from day6_core.shell.language.assignments import assignment
from day6_core.shell.language.compound_grammar import case, for_loop, if_command, while_loop
from day6_core.shell.language.condition_grammar import parse_condition
from day6_core.shell.language.lexer import Lexer, tokenize
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.syntax import (
    AndOr,
    Arithmetic,
    Command,
    Conditional,
    Function,
    Group,
    Pipeline,
    Redirection,
    Sequence,
    SimpleCommand,
)
from day6_core.shell.language.tokens import ENDS_OF_CHOICE, REDIRECTIONS, Token
from day6_core.shell.language.words import DECLARATIONS, ArrayLiteral, Incomplete, SyntaxProblem, Text, Word

_CLOSERS = frozenset({"then", "do", "done", "fi", "elif", "else", "}", "esac"})
_COMPOUND = frozenset({"{", "if", "for", "while", "until", "case", "select", "[["})
_REFUSED = frozenset({"coproc"})


def parse(source: str, aliases: Mapping[str, str] | None = None) -> Sequence:
    """Return the tree of `source`. Raises Incomplete when more lines are needed, SyntaxProblem when it is wrong.

    `aliases` are texts that stand for the command they are written as.
    """
    return Sequence([item for line in lines(source, aliases) for item in line.items])


def lines(
    source: str, aliases: Mapping[str, str] | None = None, settings: Collection[str] = ("extglob",), first_line: int = 1
) -> Generator[Sequence, int | None, None]:
    """Parse as much as makes whole lines, one after the other, so that each can be run before the next is looked at.

    `settings` are those of `shopt`; `first_line` is the number of the first line in the file it is from. Sent is the number of
    the line at which what was parsed last was given up: bash counts on from there, not from its end.
    """
    try:
        parser = Parser(source, aliases or {}, first_line)
        while True:
            parser.lexer.extglob = "extglob" in settings
            parser.skip_newlines()
            if parser.token.kind == "end":
                return
            failed_at = yield parser.line()
            if failed_at is not None:
                parser.first_line += failed_at - parser.line_number(parser.token.start)
                yield Sequence([])  # to whoever sent that
    except RecursionError:
        raise SyntaxProblem("memory exhausted") from None  # bison's message: its stack is limited too


class Parser:
    """Parses one text; holds the position in it."""

    def __init__(self, source: str, aliases: Mapping[str, str], first_line: int = 1) -> None:
        self.source = source
        self.first_line = first_line
        self._newlines: list[int] | None = None
        self.lexer = Lexer(source)
        self.rest = self.lexer.tokens()
        self.tokens: list[Token] = []
        """Tokens read ahead: at most the current one, unless an alias was replaced by several."""
        self.index = 0
        self.aliases = aliases
        self.replaced: dict[int, frozenset[str]] = {}
        """By token (its id): the aliases it came from, which are not expanded again in their own text."""

    @property
    def token(self) -> Token:
        if self.index >= len(self.tokens):
            self.tokens.append(next(self.rest))
        return self.tokens[self.index]

    def line_number(self, at: int) -> int:
        if self._newlines is None:
            self._newlines = [place for place, char in enumerate(self.source) if char == "\n"]
        return bisect_left(self._newlines, at) + self.first_line

    def unexpected(self) -> NoReturn:
        raise SyntaxProblem(f"syntax error near unexpected token `{self.token.text}'")

    def take(self) -> Token:
        token = self.token
        self.index += 1
        return token

    def is_op(self, *texts: str) -> bool:
        return self.token.kind == "op" and self.token.text in texts

    def is_keyword(self, *texts: str) -> bool:
        return self.token.kind == "word" and self.token.word is not None and self.token.word.plain in texts

    def expect_keyword(self, text: str) -> None:
        if self.token.kind == "end":
            raise Incomplete("syntax error: unexpected end of file")
        if not self.is_keyword(text):
            self.unexpected()
        self.take()

    def skip_newlines(self) -> None:
        while self.token.kind == "newline":
            self.take()

    def sequence(self) -> Sequence:
        """Commands up to the end, a `)`, the end of a choice or a closing keyword."""
        items: list[AndOr] = []
        self.skip_newlines()
        while self.token.kind != "end" and not self.is_op(")", *ENDS_OF_CHOICE) and not self.is_keyword(*_CLOSERS):
            item = self.and_or()
            items.append(item)
            if self.is_op("&", ";"):
                item.background = self.take().text == "&"
                self.skip_newlines()
            elif self.token.kind == "newline":
                self.skip_newlines()
            else:
                break
        return Sequence(items)

    def line(self) -> Sequence:
        """Commands up to the end of the line."""
        items: list[AndOr] = []
        while self.token.kind not in ("end", "newline"):
            if self.is_keyword(*_CLOSERS):
                self.unexpected()
            item = self.and_or()
            items.append(item)
            if self.is_op("&", ";"):
                item.background = self.take().text == "&"
            elif self.token.kind not in ("end", "newline"):
                self.unexpected()
        return Sequence(items)

    def body(self) -> Sequence:
        sequence = self.sequence()
        if self.token.kind == "end":
            raise Incomplete("syntax error: unexpected end of file")
        if not sequence.items:
            self.unexpected()
        return sequence

    def and_or(self) -> AndOr:
        start = self.token.start
        items = [("&&", self.pipeline())]
        while self.is_op("&&", "||"):
            operator = self.take().text
            self.skip_newlines()
            items.append((operator, self.pipeline()))
        return AndOr(items, False, self.slice(start))

    def pipeline(self) -> Pipeline:
        start = self.token.start
        negated, timed = False, ""
        while self.is_keyword("!", "time"):
            word = self.take().text
            negated, timed = negated != (word == "!"), timed or word.replace("!", "")
            if timed and self.is_keyword("-p"):
                timed = self.take().text
        if timed and (self.token.kind in ("newline", "end") or self.is_op(";", "&", ")")):
            return Pipeline([SimpleCommand()], negated, self.slice(start), timed, self.line_number(start))
        first = self.index
        commands = [self.command()]
        line = self.line_number(start)
        if isinstance(commands[0], SimpleCommand):  # bash has read one token more when it notes the line
            second = self.tokens[first + 1]
            line = self.line_number(second.end if second.kind == "word" else second.start)
        while self.is_op("|", "|&"):
            if self.take().text == "|&":
                commands[-1].redirections.append(Redirection(2, ">&", Word((Text("1"),), "1")))
            self.skip_newlines()
            commands.append(self.command())
        source = self.slice(start)
        if len(commands) == 1 and isinstance(commands[0], Group):
            commands[0].source = source
        return Pipeline(commands, negated, source, timed, line)

    def slice(self, start: int) -> str:
        return self.source[start : self.tokens[self.index - 1].end].strip()

    def command(self) -> Command:
        if self.token.kind == "end":
            if self.index and self.tokens[self.index - 1].kind in ("op", "newline"):
                raise Incomplete("syntax error: unexpected end of file")
            self.unexpected()
        self.replace_alias()
        start = self.token.start
        command: Command
        if self.is_keyword("in"):
            self.unexpected()
        if self.is_keyword(*_REFUSED):
            raise Refused(self.token.text)
        if self.is_op("("):
            bracket = self.take()
            value = self.arithmetic(bracket)
            command = Arithmetic(value) if value is not None else self.subshell()
        elif self.is_keyword("[["):
            self.take()
            command = Conditional(parse_condition(self))
            self.expect_keyword("]]")
        elif self.is_keyword("case"):
            command = case(self)
        elif self.is_keyword("function"):
            command = self.function()
        elif self.is_keyword("{"):
            self.take()
            command = Group(self.body(), subshell=False)
            self.expect_keyword("}")
        elif self.is_keyword("for", "select"):
            command = for_loop(self)
        elif self.is_keyword("while", "until"):
            command = while_loop(self)
        elif self.is_keyword("if"):
            command = if_command(self)
        else:
            return self.simple()
        while self.token.kind == "number" or self.is_op(*REDIRECTIONS):
            command.redirections.append(self.redirection())
        if isinstance(command, Group):
            command.source = self.slice(start)
        return command

    def subshell(self) -> Group:
        group = Group(self.body(), subshell=True)
        if not self.is_op(")"):
            self.unexpected()
        self.take()
        return group

    def arithmetic(self, bracket: Token) -> str | None:
        """Return the expression in `((…))` if `bracket` is its first parenthesis, and consume all of it; else None."""
        if self.index != len(self.tokens):
            return None
        value = self.lexer.arithmetic()
        if value is not None:
            bracket.end = self.lexer.at
        return value

    def pattern(self) -> Word:
        """The regular expression after `=~`."""
        return self.lexer.pattern() if self.index == len(self.tokens) else self.word()

    @contextmanager
    def extended(self, always: bool) -> Iterator[None]:
        """Inside, a word may have patterns of extglob, whatever `shopt` says, if `always`."""
        before, self.lexer.extglob = self.lexer.extglob, self.lexer.extglob or always
        yield
        self.lexer.extglob = before

    def word(self) -> Word:
        if self.token.kind == "end":
            raise Incomplete("syntax error: unexpected end of file")
        word = self.token.word
        if word is None:
            self.unexpected()
        self.take()
        return word

    def function(self) -> Function:
        """`function name body`."""
        start = self.take().start
        name = self.word().source
        if self.is_op("("):
            self.take()
            if not self.is_op(")"):
                self.unexpected()
            self.take()
        return self.function_body(name, start)

    def function_body(self, name: str, start: int) -> Function:
        self.skip_newlines()
        if self.token.kind == "end":
            raise Incomplete("syntax error: unexpected end of file")
        if not (self.is_op("(") or self.is_keyword(*_COMPOUND)):
            self.unexpected()
        body = self.command()
        return Function(name, body, self.slice(start))

    def replace_alias(self) -> None:
        """Replace an alias by its tokens."""
        while self.token.word is not None:
            name = self.token.word.plain or ""
            known = self.replaced.get(id(self.token), frozenset())
            if name in known or name not in self.aliases:
                return
            before = self.token
            tokens = tokenize(self.aliases[name])[:-1]
            for token in tokens:
                token.start, token.end = before.start, before.end
                self.replaced[id(token)] = known | {name}
            self.tokens[self.index : self.index + 1] = tokens

    def simple(self) -> SimpleCommand | Function:
        command = SimpleCommand()
        start = self.token.start
        while True:
            if not command.words:
                self.replace_alias()
            token = self.token
            if token.kind == "number" or self.is_op(*REDIRECTIONS):
                command.redirections.append(self.redirection())
            elif token.word is not None:
                self.take()
                assigned = None if command.words else assignment(token.word)
                if assigned is not None:
                    command.assignments.append(assigned)
                else:
                    has_array = any(isinstance(part, ArrayLiteral) for part in token.word.parts)
                    if has_array and (not command.words or command.words[0].plain not in DECLARATIONS):
                        raise SyntaxProblem("syntax error near unexpected token `('")
                    command.words.append(token.word)
            else:
                break
        if not (command.words or command.assignments or command.redirections):
            self.unexpected()
        if self.is_op("("):
            name = command.words[0].plain if len(command.words) == 1 and not command.assignments else None
            if name is None or command.redirections:
                self.unexpected()
            self.take()
            if not self.is_op(")"):
                self.unexpected()
            self.take()
            return self.function_body(name, start)
        return command

    def redirection(self) -> Redirection:
        fd: int | str | None = None
        if self.token.kind == "number":
            text = self.take().text
            fd = int(text) if text.isdigit() else text
        operator = self.take()
        if operator.text == "<>":
            raise Refused(operator.text)
        target = self.token
        if target.word is None:
            self.unexpected()
        self.take()
        return Redirection(fd, operator.text, target.word, operator.document)
