"""The grammar: tokens to a tree of commands, by recursive descent. What each node does is in `interpreter.py`."""

from __future__ import annotations

from dataclasses import dataclass, field

from day6_tui.core.shell.lexer import REDIRECTIONS, Incomplete, SyntaxProblem, Text, Token, Word, tokenize


@dataclass
class Redirection:
    """`fd` is the descriptor to change, None for the operator's own; `target` is a file, a descriptor or a document."""

    fd: int | None
    operator: str
    target: Word


@dataclass
class Simple:
    """`A=1 command word … > file`."""

    assignments: list[tuple[str, Word]] = field(default_factory=list)
    words: list[Word] = field(default_factory=list)
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class Group:
    """`( list )` in a copy of the shell, or `{ list; }` in the shell itself."""

    body: Sequence
    subshell: bool
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class For:
    name: str
    words: list[Word] | None
    body: Sequence
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class While:
    condition: Sequence
    body: Sequence
    until: bool
    redirections: list[Redirection] = field(default_factory=list)


@dataclass
class If:
    branches: list[tuple[Sequence, Sequence]]
    otherwise: Sequence | None
    redirections: list[Redirection] = field(default_factory=list)


Command = Simple | Group | For | While | If


@dataclass
class Pipeline:
    commands: list[Command]
    negated: bool
    source: str


@dataclass
class AndOr:
    """`first && second || third`: operators and pipelines in turn; the first operator is always '&&'."""

    items: list[tuple[str, Pipeline]]
    background: bool
    source: str


@dataclass
class Sequence:
    items: list[AndOr]


_CLOSERS = frozenset({"then", "do", "done", "fi", "elif", "else", "}"})


def parse(source: str) -> Sequence:
    """Return the tree of `source`. Raises Incomplete when more lines are needed, SyntaxProblem when it is wrong."""
    parser = _Parser(source)
    sequence = parser.sequence()
    if parser.token.kind != "end":
        parser.unexpected()
    return sequence


class _Parser:
    def __init__(self, source: str) -> None:
        self.source = source
        self.tokens = tokenize(source)
        self.index = 0

    @property
    def token(self) -> Token:
        return self.tokens[self.index]

    def unexpected(self) -> None:
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
        """Commands up to the end, a `)` or a closing keyword."""
        items: list[AndOr] = []
        self.skip_newlines()
        while self.token.kind != "end" and not self.is_op(")") and not self.is_keyword(*_CLOSERS):
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
        negated = False
        while self.is_keyword("!"):
            self.take()
            negated = not negated
        commands = [self.command()]
        while self.is_op("|", "|&"):
            if self.take().text == "|&":
                commands[-1].redirections.append(Redirection(2, ">&", Word((Text("1"),), "1")))
            self.skip_newlines()
            commands.append(self.command())
        return Pipeline(commands, negated, self.slice(start))

    def slice(self, start: int) -> str:
        return self.source[start : self.tokens[self.index - 1].end].strip()

    def command(self) -> Command:
        if self.token.kind == "end":
            if self.index and self.tokens[self.index - 1].kind in ("op", "newline"):
                raise Incomplete("syntax error: unexpected end of file")
            self.unexpected()
        command: Command
        if self.is_op("("):
            self.take()
            command = Group(self.body(), subshell=True)
            if not self.is_op(")"):
                self.unexpected()
            self.take()
        elif self.is_keyword("{"):
            self.take()
            command = Group(self.body(), subshell=False)
            self.expect_keyword("}")
        elif self.is_keyword("for"):
            command = self.for_loop()
        elif self.is_keyword("while", "until"):
            until = self.take().text == "until"
            condition = self.body()
            self.expect_keyword("do")
            command = While(condition, self.body(), until)
            self.expect_keyword("done")
        elif self.is_keyword("if"):
            command = self.conditional()
        else:
            return self.simple()
        while self.token.kind == "number" or self.is_op(*REDIRECTIONS):
            command.redirections.append(self.redirection())
        return command

    def for_loop(self) -> For:
        self.take()
        name = self.take()
        if name.word is None or not (name.word.plain or "").isidentifier():
            raise SyntaxProblem(f"`{name.text}': not a valid identifier")
        words: list[Word] | None = None
        self.skip_newlines()
        if self.is_keyword("in"):
            self.take()
            words = []
            while self.token.word is not None:
                words.append(self.token.word)
                self.take()
        if self.is_op(";"):
            self.take()
        self.skip_newlines()
        self.expect_keyword("do")
        loop = For(name.text, words, self.body())
        self.expect_keyword("done")
        return loop

    def conditional(self) -> If:
        branches: list[tuple[Sequence, Sequence]] = []
        otherwise = None
        while True:
            self.take()  # if, elif
            condition = self.body()
            self.expect_keyword("then")
            branches.append((condition, self.body()))
            if not self.is_keyword("elif"):
                break
        if self.is_keyword("else"):
            self.take()
            otherwise = self.body()
        self.expect_keyword("fi")
        return If(branches, otherwise)

    def simple(self) -> Simple:
        command = Simple()
        while True:
            token = self.token
            if token.kind == "number" or self.is_op(*REDIRECTIONS):
                command.redirections.append(self.redirection())
            elif token.word is not None:
                self.take()
                assignment = None if command.words else _assignment(token.word)
                if assignment is not None:
                    command.assignments.append(assignment)
                else:
                    command.words.append(token.word)
            else:
                break
        if not (command.words or command.assignments or command.redirections):
            self.unexpected()
        if self.is_op("("):
            self.unexpected()
        return command

    def redirection(self) -> Redirection:
        fd = int(self.take().text) if self.token.kind == "number" else None
        operator = self.take()
        target = self.token
        if target.word is None:
            self.unexpected()
        self.take()
        if operator.text in ("<<", "<<-"):
            return Redirection(fd, operator.text, operator.document[0])
        assert target.word is not None
        return Redirection(fd, operator.text, target.word)


def _assignment(word: Word) -> tuple[str, Word] | None:
    """Split `NAME=value`; None if the word is not an assignment."""
    first = word.parts[0] if word.parts else None
    if not isinstance(first, Text) or first.quoted:
        return None
    name, equals, rest = first.text.partition("=")
    if not equals or not name.isidentifier() or not name.isascii():
        return None
    parts = (Text(rest), *word.parts[1:]) if rest else word.parts[1:]
    return name, Word(parts, word.source[len(name) + 1 :])
