"""Turns a command line into words and operators, as bash reads them: quotes, escapes, `$` expansions, comments, here-documents.

Nothing is expanded here. A word keeps its parts (plain text, text in quotes, a variable, a command substitution), so that the
expansion knows later what may be split and globbed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from day6_core.shell.language.words import (
    HAS_PATTERN,
    Incomplete,
    Part,
    Substitution,
    Text,
    Variable,
    Word,
    braced,
    unescaped,
)

OPERATORS = (
    ";;&",
    "&>>",
    "<<<",
    "<<-",
    "&&",
    "||",
    ";;",
    ";&",
    ">>",
    "<<",
    ">&",
    "<&",
    ">|",
    "&>",
    "|&",
    "|",
    "&",
    ";",
    "(",
    ")",
    "<",
    ">",
)
"""Longest first."""

REDIRECTIONS = frozenset({">", ">>", "<", "<<", "<<-", "<<<", ">&", "<&", ">|", "&>", "&>>"})
_WORD_END = frozenset(" \t\n|&;()<>")
_SPECIAL_NAMES = frozenset("?!$#@*-0123456789")
_BACKQUOTED = re.compile(r"`((?:[^`\\]|\\.)*)`", re.DOTALL)
_ESCAPED_IN_BACKQUOTES = re.compile(r"\\([`$\\])")
_BEFORE_A_COMMAND = frozenset({"then", "do", "else", "elif", "if", "while", "until", "!", "{"})


@dataclass
class Token:
    """`kind` is 'word', 'op', 'newline', 'number' (a file descriptor before a redirection) or 'end'."""

    kind: str
    text: str
    start: int
    end: int
    word: Word | None = None
    document: list[Word] = field(default_factory=list)
    """The body of a here-document, on its `<<` token, once it was read."""


def tokenize(source: str) -> list[Token]:
    """Return the tokens of `source`, the last one of kind 'end'. Raises Incomplete and SyntaxProblem."""
    return list(Lexer(source).tokens())


def single_word(source: str, quoted: bool = False) -> Word:
    """Return all of `source` as one word, white space and operators included; `quoted`: as if it were between `"`."""
    lexer = Lexer(source)
    return Word(tuple(lexer._quoted("")), source) if quoted else lexer._word(frozenset())


class Lexer:
    """Reads one text, one token at a time, because some tokens are not followed by a list of words."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.at = 0
        self._documents: list[tuple[Token, str, bool, bool]] = []

    def tokens(self) -> Iterator[Token]:
        """The tokens up to that of kind 'end'. The body of a here-document is on its token once the line has ended."""
        last = None
        while last is None or last.kind != "end":
            token = self._next()
            if last is not None and last.kind == "op" and last.text in ("<<", "<<-") and token.word is not None:
                end = "".join(part.text for part in token.word.parts if isinstance(part, Text))
                literal = any(isinstance(part, Text) and part.quoted for part in token.word.parts)
                self._documents.append((last, end, literal, last.text == "<<-"))
            if token.kind == "newline":
                self._read_documents()
            if token.kind == "end" and self._documents:
                raise Incomplete(f"here-document delimited by end-of-file (wanted `{self._documents[0][1]}')")
            yield token
            last = token

    def arithmetic(self) -> str | None:
        """After a `(`: if it begins `((…))`, return the expression between them and move `at` past it; else None."""
        if not self.source.startswith("(", self.at):
            return None
        end = _end_of_arithmetic(self.source, self.at + 1)
        if end < 0:
            return None
        start, self.at = self.at + 1, end + 2
        return self.source[start:end]

    def pattern(self) -> Word:
        """The regular expression after `=~`, in which `(`, `)` and `|` are ordinary characters."""
        while self.at < len(self.source) and self.source[self.at] in " \t":
            self.at += 1
        return self._word(frozenset(" \t\n"))

    def _next(self) -> Token:
        source = self.source
        while True:
            if source.startswith("\\\n", self.at):
                self.at += 2
            elif self.at < len(source) and source[self.at] in " \t\r":
                self.at += 1
            elif self.at < len(source) and source[self.at] == "#":
                end = source.find("\n", self.at)
                self.at = len(source) if end < 0 else end
            else:
                break
        start = self.at
        if start >= len(source):
            return Token("end", "newline", start, start)
        if source[start] == "\n":
            self.at += 1
            return Token("newline", "newline", start, self.at)
        for operator in OPERATORS:
            if source.startswith(operator, start):
                self.at += len(operator)
                return Token("op", operator, start, self.at)
        word = self._word()
        if word.source.isdigit() and self.at < len(source) and source[self.at] in "<>":
            return Token("number", word.source, start, self.at)
        return Token("word", word.source, start, self.at, word)

    def _word(self, ends: frozenset[str] = _WORD_END) -> Word:
        start = self.at
        parts: list[Part] = []
        source = self.source
        while self.at < len(source):
            char = source[self.at]
            if char == "\\":
                if self.at + 1 >= len(source):
                    raise Incomplete("unexpected end of file after `\\'")
                if source[self.at + 1] != "\n":
                    parts.append(Text(source[self.at + 1], quoted=True))
                self.at += 2
            elif char == "'":
                end = self._closing("'", self.at + 1)
                parts.append(Text(source[self.at + 1 : end], quoted=True))
                self.at = end + 1
            elif char == '"':
                self.at += 1
                parts.extend(self._quoted('"'))
            elif source.startswith("$'", self.at):
                parts.append(self._escaped())
            elif char in "$`":
                parts.append(self._dollar(quoted=False))
            elif char in ends:
                break
            else:
                end = self.at
                while end < len(source) and source[end] not in ends and source[end] not in "\\'\"$`":
                    end += 1
                parts.append(Text(source[self.at : end]))
                self.at = end
        return Word(tuple(parts), source[start : self.at])

    def _escaped(self) -> Text:
        """`$'…'`, in which backslashes mean what they mean in C."""
        end = self.at + 2
        while end < len(self.source) and self.source[end] != "'":
            end += 2 if self.source[end] == "\\" else 1
        if end >= len(self.source):
            raise Incomplete("unexpected EOF while looking for matching `''")
        text = unescaped(self.source[self.at + 2 : end])
        self.at = end + 1
        return Text(text, quoted=True)

    def _closing(self, quote: str, start: int) -> int:
        end = self.source.find(quote, start)
        if end < 0:
            raise Incomplete(f"unexpected EOF while looking for matching `{quote}'")
        return end

    def _quoted(self, closing: str) -> list[Part]:
        """The parts up to `closing` ('"', or '' for a here-document), in which only `$`, backquote and backslash are special."""
        source = self.source
        parts: list[Part] = []
        text: list[str] = []

        def flush(*, empty: bool = False) -> None:
            if text or (empty and not parts):
                parts.append(Text("".join(text), quoted=True))
                text.clear()

        while True:
            if self.at >= len(source):
                if closing:
                    raise Incomplete(f"unexpected EOF while looking for matching `{closing}'")
                break
            char = source[self.at]
            if char == closing:
                self.at += 1
                break
            if char == "\\" and self.at + 1 < len(source) and source[self.at + 1] in '$`"\\\n':
                if source[self.at + 1] == '"' and not closing:
                    text.append("\\")
                if source[self.at + 1] != "\n":
                    text.append(source[self.at + 1])
                self.at += 2
            elif char in "$`":
                flush()
                parts.append(self._dollar(quoted=True))
            else:
                text.append(char)
                self.at += 1
        flush(empty=bool(closing))
        return parts

    def _dollar(self, quoted: bool) -> Part:
        source, start = self.source, self.at
        if source[start] == "`":
            match = _BACKQUOTED.match(source, start)
            if match is None:
                raise Incomplete("unexpected EOF while looking for matching ``'")
            self.at = match.end()
            return Substitution(_ESCAPED_IN_BACKQUOTES.sub(r"\1", match[1]), quoted)
        follow = source[start + 1 : start + 2]
        if source.startswith("$((", start):
            end = _end_of_arithmetic(source, start + 3)
            if end >= 0:
                self.at = end + 2
                return Substitution(source[start + 3 : end], quoted, arithmetic=True)
        if follow == "(":
            self.at = start + 2
            end = self._matching_parenthesis()
            return Substitution(source[start + 2 : end], quoted)
        if follow == "{":
            self.at = start + 2
            end = self._matching_brace(quoted and not HAS_PATTERN.match(source, start + 2))
            return braced(source[start + 2 : end], quoted)
        if follow in _SPECIAL_NAMES and follow:
            self.at = start + 2
            return Variable(follow, quoted)
        end = start + 1
        while end < len(source) and (source[end] == "_" or (source[end].isascii() and source[end].isalnum())):
            end += 1
        self.at = end
        if end == start + 1:
            return Text("$", quoted)
        return Variable(source[start + 1 : end], quoted)

    def _matching_brace(self, quoted: bool) -> int:
        """Skip quotes and expansions up to the `}` that closes a `${`; leaves `at` after it and returns its position."""
        while self.at < len(self.source):
            char = self.source[self.at]
            if char == "}":
                self.at += 1
                return self.at - 1
            if char == "\\":
                self.at += 2
            elif char == "'" and not quoted:
                self.at = self._closing("'", self.at + 1) + 1
            elif char == '"':
                self.at += 1
                self._quoted('"')
            elif char in "$`":
                self._dollar(quoted=False)
            else:
                self.at += 1
        raise Incomplete("unexpected EOF while looking for matching `}'")

    def _matching_parenthesis(self) -> int:
        """Skip words and operators up to the `)` that closes a `$(`; leaves `at` after it and returns its position.

        The `)` after a pattern of `case` closes nothing.
        """
        open_ones = ["("]
        begins = True
        while True:
            token = self._next()
            if token.kind == "end":
                raise Incomplete("unexpected EOF while looking for matching `)'")
            if token.kind == "op" and token.text == "(":
                open_ones.append("(")
            elif token.kind == "op" and token.text == ")" and open_ones[-1] == "(":
                open_ones.pop()
                if not open_ones:
                    return token.start
            elif begins and token.text == "case":
                open_ones.append("case")
            elif begins and token.text == "esac" and open_ones[-1] == "case":
                open_ones.pop()
            begins = token.kind in ("op", "newline") or token.text in _BEFORE_A_COMMAND

    def _read_documents(self) -> None:
        for token, end, literal, strip_tabs in self._documents:
            lines: list[str] = []
            while True:
                if self.at >= len(self.source):
                    raise Incomplete(f"here-document delimited by end-of-file (wanted `{end}')")
                stop = self.source.find("\n", self.at)
                stop = len(self.source) if stop < 0 else stop
                line = self.source[self.at : stop]
                self.at = min(stop + 1, len(self.source))
                if strip_tabs:
                    line = line.lstrip("\t")
                if line == end:
                    break
                lines.append(line + "\n")
            text = "".join(lines)
            parts: list[Part] = [Text(text, quoted=True)] if literal else Lexer(text)._quoted("")
            token.document.append(Word(tuple(parts), text))
        self._documents.clear()


def _end_of_arithmetic(source: str, start: int) -> int:
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
