"""Turns a command line into words and operators, as bash reads them: quotes, escapes, `$` expansions, comments, here-documents.

Nothing is expanded here. A word keeps its parts (plain text, text in quotes, a variable, a command substitution), so that the
expansion knows later what may be split and globbed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from day6_core.shell.language.tokens import OPERATORS, Token
from day6_core.shell.language.words import (
    HAS_PATTERN,
    ArrayLiteral,
    Incomplete,
    Part,
    ProcessSubstitution,
    Substitution,
    SyntaxProblem,
    Text,
    Variable,
    Word,
    braced,
    end_of_arithmetic,
    end_of_subscript,
    unescaped,
)

_WORD_END = frozenset(" \t\n|&;()<>")
_SPECIAL_NAMES = frozenset("?!$#@*-0123456789")
_BACKQUOTED = re.compile(r"`((?:[^`\\]|\\.)*)`", re.DOTALL)
_ESCAPED_IN_BACKQUOTES = re.compile(r"\\([`$\\])")
_ESCAPED_IN_QUOTED_BACKQUOTES = re.compile(r"\\([`$\\\"])")
_BEFORE_AN_ARRAY = re.compile(r"[A-Za-z_]\w*(?:\[.*\])?\+?=", re.ASCII | re.DOTALL)
_ELEMENT = re.compile(r"(?:[A-Za-z_]\w*)?\[", re.ASCII)
_NAME = re.compile(r"\w+", re.ASCII)
_FD_NAME = re.compile(r"\{[A-Za-z_]\w*\}", re.ASCII)
_EXTENDED = "?*+@!"
"""Before a `(`: a pattern of `extglob`."""
_BEFORE_A_COMMAND = frozenset({"then", "do", "else", "elif", "if", "while", "until", "!", "{"})


def tokenize(source: str) -> list[Token]:
    """Return the tokens of `source`, the last one of kind 'end'. Raises Incomplete and SyntaxProblem."""
    return list(Lexer(source).tokens())


def single_word(source: str, quoted: bool = False, *, toggling: bool = False, extglob: bool = False) -> Word:
    """Return all of `source` as one word, white space and operators included.

    `quoted`: as if it were between `"`, and with `toggling` a `"` in it is dropped, as in `"${x:-…}"` and in expressions.
    """
    lexer = Lexer(source, extglob=extglob)
    return Word(tuple(lexer._quoted("", toggling=toggling)), source) if quoted else lexer._word(frozenset())


class Lexer:
    """Reads one text, one token at a time, because some tokens are not followed by a list of words."""

    def __init__(self, source: str, *, extglob: bool = False) -> None:
        self.source = source
        self.extglob = extglob
        self.at = 0
        self._in_array = False
        self._documents: list[tuple[Token, str, bool, bool]] = []

    def tokens(self) -> Iterator[Token]:
        """The tokens up to that of kind 'end'. The body of a here-document is on its token once the line has ended."""
        last = None
        while last is None or last.kind != "end":
            token = self._next()
            self._note_document(last, token)
            if token.kind == "end" and self._documents:
                raise Incomplete(f"here-document delimited by end-of-file (wanted `{self._documents[0][1]}')")
            yield token
            last = token

    def _note_document(self, last: Token | None, token: Token) -> None:
        """Remember a here-document at its delimiter, and read those of a line at its end."""
        if last is not None and last.kind == "op" and last.text in ("<<", "<<-") and token.word is not None:
            end = "".join(part.text for part in token.word.parts if isinstance(part, Text))
            literal = any(isinstance(part, Text) and part.quoted for part in token.word.parts)
            self._documents.append((last, end, literal, last.text == "<<-"))
        if token.kind == "newline":
            self._read_documents()

    def arithmetic(self) -> str | None:
        """After a `(`: if it begins `((…))`, return the expression between them and move `at` past it; else None."""
        if not self.source.startswith("(", self.at):
            return None
        end = end_of_arithmetic(self.source, self.at + 1)
        if end < 0:
            return None
        start, self.at = self.at + 1, end + 2
        return self.source[start:end]

    def pattern(self) -> Word:
        """The regular expression after `=~`: `(`, `)` and `|` are ordinary characters in it, between parentheses blanks, too."""
        self.at += len(self.source[self.at :]) - len(self.source[self.at :].lstrip(" \t"))
        start, depth = self.at, 0
        parts: list[Part] = []
        while True:
            parts.extend(self._word(frozenset("()") if depth else frozenset(" \t\n()")).parts)
            char = self.source[self.at : self.at + 1]
            depth += {"(": 1, ")": -1}.get(char, 0)
            if char not in ("(", ")") or depth < 0:
                return Word(tuple(parts), self.source[start : self.at])
            parts.append(Text(char))
            self.at += 1

    def _next(self) -> Token:
        source = self.source
        while True:
            if source.startswith("\\\n", self.at):
                self.at += 2
            elif self.at < len(source) and source[self.at] in " \t":
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
        for operator in () if self._at_process() else OPERATORS:
            if source.startswith(operator, start):
                self.at += len(operator)
                return Token("op", operator, start, self.at)
        word = self._word()
        if self.at < len(source) and source[self.at] in "<>" and not self._at_process():
            if word.source.isdigit():
                return Token("number", word.source, start, self.at)
            if _FD_NAME.fullmatch(word.source):
                return Token("number", word.source[1:-1], start, self.at)
        return Token("word", word.source, start, self.at, word)

    def _word(self, ends: frozenset[str] = _WORD_END) -> Word:
        start = self.at
        parts: list[Part] = []
        source = self.source
        if ends is _WORD_END and (subscript := self._odd_subscript()):
            parts.append(Text(subscript))
        while self.at < len(source):
            char = source[self.at]
            if self.extglob and char in _EXTENDED and source.startswith("(", self.at + 1) and ends:
                parts.extend(self._extended())
            elif char in "<>" and ends and self._at_process():
                parts.append(self._process())
            elif char == "(" and ends and parts and _BEFORE_AN_ARRAY.fullmatch(source, start, self.at):
                try:
                    parts.append(self._array())
                except SyntaxProblem as problem:
                    problem.status = 1  # as bash, which reads an array by itself
                    raise
            elif char == "\\":
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
            elif source.startswith('$"', self.at):
                self.at += 1  # a text to be translated, and there are no translations
            elif char in "$`":
                parts.append(self._dollar(quoted=False))
            elif char in ends:
                break
            else:
                end = self.at + 1
                while end < len(source) and source[end] not in ends and source[end] not in "\\'\"$`":
                    if self.extglob and source[end] in _EXTENDED and source.startswith("(", end + 1):
                        break
                    end += 1
                parts.append(Text(source[self.at : end]))
                self.at = end
        return Word(tuple(parts), source[start : self.at])

    def _at_process(self) -> bool:
        return self.source.startswith(("<(", ">("), self.at)

    def _process(self) -> ProcessSubstitution:
        """`<(…)`, `>(…)`."""
        writes = self.source[self.at] == ">"
        self.at += 2
        start = self.at
        return ProcessSubstitution(self.source[start : self._matching_parenthesis()], writes)

    def _array(self) -> ArrayLiteral:
        """`(…)` behind `NAME=`: words, on any number of lines."""
        self.at += 1
        elements: list[Word] = []
        while True:
            self._in_array = True
            token = self._next()
            self._in_array = False
            if token.kind == "end":
                raise Incomplete("unexpected EOF while looking for matching `)'")
            if token.kind == "op" and token.text == ")":
                return ArrayLiteral(tuple(elements))
            if token.word is not None:
                elements.append(token.word)
            elif token.kind != "newline":
                raise SyntaxProblem(f"syntax error near unexpected token `{token.text}'")

    def _odd_subscript(self) -> str:
        """`NAME[` … `]` before a `=`, with blanks or operators in the subscript; '' where a word begins in another way."""
        match = _ELEMENT.match(self.source, self.at)
        if match is not None and len(match[0]) == 1 and not self._in_array:
            match = None
        end = end_of_subscript(self.source, match.end() - 1) if match else -1
        if match is None or end < 0 or not self.source.startswith(("=", "+="), end + 1):
            return ""
        subscript = self.source[match.end() : end]
        if not any(char in _WORD_END for char in subscript) or "\n" in subscript or "$(" in subscript:
            return ""
        found, self.at = self.source[self.at : end + 1], end + 1
        return found

    def _extended(self) -> list[Part]:
        """`@(…)` and its relatives, in which blanks and `|` are ordinary characters; quotes and `$` keep their meaning."""
        parts: list[Part] = [Text(self.source[self.at : self.at + 2])]
        self.at += 2
        while True:
            parts.extend(self._word(frozenset("()")).parts)
            if self.at >= len(self.source):
                raise Incomplete("unexpected EOF while looking for matching `)'")
            parts.append(Text(self.source[self.at]))
            self.at += 1
            if self.source[self.at - 1] == ")":
                return parts

    def _escaped(self) -> Text:
        """`$'…'`, in which backslashes mean what they mean in C."""
        end = self.at + 2
        while end < len(self.source) and self.source[end] != "'":
            end += 2 if self.source[end] == "\\" else 1
        if end >= len(self.source):
            raise Incomplete("unexpected EOF while looking for matching `''")
        start, self.at = self.at, end + 1
        return Text(unescaped(self.source[start + 2 : end]), quoted=True)

    def _closing(self, quote: str, start: int) -> int:
        end = self.source.find(quote, start)
        if end < 0:
            raise Incomplete(f"unexpected EOF while looking for matching `{quote}'")
        return end

    def _quoted(self, closing: str, *, toggling: bool = False) -> list[Part]:
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
            if char == '"' and toggling:
                self.at += 1
                continue
            special = '$`"\\\n}' if toggling else '$`"\\\n'
            if char == "\\" and self.at + 1 < len(source) and source[self.at + 1] in special:
                if source[self.at + 1] == '"' and not closing and not toggling:
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
            escaped = _ESCAPED_IN_QUOTED_BACKQUOTES if quoted else _ESCAPED_IN_BACKQUOTES
            return Substitution(escaped.sub(r"\1", match[1]), quoted, backquoted=True)
        follow = source[start + 1 : start + 2]
        if source.startswith("$((", start):
            end = end_of_arithmetic(source, start + 3)
            if end >= 0:
                self.at = end + 2
                return Substitution(source[start + 3 : end], quoted, arithmetic=True)
        if follow == "(":
            self.at = start + 2
            end = self._matching_parenthesis()
            return Substitution(source[start + 2 : end], quoted)
        if follow == "[":
            end = end_of_subscript(source, start + 1)
            if end > 0:
                self.at = end + 1
                return Substitution(source[start + 2 : end], quoted, arithmetic=True)
        if follow == "{":
            self.at = start + 2
            end = self._matching_brace(quoted and not HAS_PATTERN.match(source, start + 2))
            return braced(source[start + 2 : end], quoted)
        if follow in _SPECIAL_NAMES and follow:
            self.at = start + 2
            return Variable(follow, quoted)
        name = _NAME.match(source, start + 1)
        self.at = start + 1 if name is None else name.end()
        return Text("$", quoted) if name is None else Variable(name[0], quoted, bare=True)

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
        outer, self._documents = self._documents, []
        last = None
        while True:
            token = self._next()
            self._note_document(last, token)
            last = token
            if token.kind == "end":
                raise Incomplete("unexpected EOF while looking for matching `)'")
            if token.kind == "op" and token.text == "(":
                open_ones.append("(")
            elif token.kind == "op" and token.text == ")" and open_ones[-1] == "(":
                open_ones.pop()
                if not open_ones:
                    self._documents = outer
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
