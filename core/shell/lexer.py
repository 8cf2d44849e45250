"""Turns a command line into words and operators, as bash reads them: quotes, escapes, `$` expansions, comments, here-documents.

Nothing is expanded here. A word keeps its parts (plain text, text in quotes, a variable, a command substitution), so that the
expansion knows later what may be split and globbed.
"""

from __future__ import annotations

from dataclasses import dataclass, field

OPERATORS = (
    "&>>",
    "<<<",
    "<<-",
    "&&",
    "||",
    ";;",
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


class SyntaxProblem(Exception):
    """The line cannot be understood; the text is bash's, without its `bash: `."""


class Incomplete(SyntaxProblem):
    """The line goes on: a quote, a `$(`, a here-document or a compound command is still open."""


@dataclass(frozen=True)
class Text:
    text: str
    quoted: bool = False


@dataclass(frozen=True)
class Variable:
    """`$NAME`, or `${NAME<operator><argument>}` with the operators `:-` `-` `:=` `:+` `+` `#` (length, no argument)."""

    name: str
    quoted: bool = False
    operator: str = ""
    argument: str = ""


@dataclass(frozen=True)
class Substitution:
    """`$(source)`: the output of commands; `$((source))`: the value of a sum."""

    source: str
    quoted: bool = False
    arithmetic: bool = False


Part = Text | Variable | Substitution


@dataclass(frozen=True)
class Word:
    parts: tuple[Part, ...]
    source: str

    @property
    def plain(self) -> str | None:
        """The text of a word without quotes and expansions, else None; only such a word can be a keyword."""
        if all(isinstance(part, Text) and not part.quoted for part in self.parts):
            return "".join(part.text for part in self.parts if isinstance(part, Text))
        return None


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
    return _Lexer(source).tokens()


class _Lexer:
    def __init__(self, source: str) -> None:
        self.source = source
        self.at = 0
        self._documents: list[tuple[Token, str, bool, bool]] = []

    def tokens(self) -> list[Token]:
        found: list[Token] = []
        while True:
            token = self._next()
            found.append(token)
            if len(found) > 1 and found[-2].text in ("<<", "<<-") and found[-2].kind == "op" and token.word is not None:
                end = "".join(part.text for part in token.word.parts if isinstance(part, Text))
                literal = any(isinstance(part, Text) and part.quoted for part in token.word.parts)
                self._documents.append((found[-2], end, literal, found[-2].text == "<<-"))
            if token.kind == "newline":
                self._read_documents()
            if token.kind == "end":
                if self._documents:
                    raise Incomplete(f"here-document delimited by end-of-file (wanted `{self._documents[0][1]}')")
                return found

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

    def _word(self) -> Word:
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
            elif char in "$`":
                parts.append(self._dollar(quoted=False))
            elif char in _WORD_END:
                break
            else:
                end = self.at
                while end < len(source) and source[end] not in _WORD_END and source[end] not in "\\'\"$`":
                    end += 1
                parts.append(Text(source[self.at : end]))
                self.at = end
        return Word(tuple(parts), source[start : self.at])

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

        def flush() -> None:
            if text or (closing and not parts):
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
        flush()
        return parts

    def _dollar(self, quoted: bool) -> Part:
        source, start = self.source, self.at
        if source[start] == "`":
            end = self._closing("`", start + 1)
            self.at = end + 1
            return Substitution(source[start + 1 : end], quoted)
        follow = source[start + 1 : start + 2]
        if source.startswith("$((", start):
            end = source.find("))", start)
            if end < 0:
                raise Incomplete("unexpected EOF while looking for matching `)'")
            self.at = end + 2
            return Substitution(source[start + 3 : end], quoted, arithmetic=True)
        if follow == "(":
            self.at = start + 2
            end = self._matching_parenthesis()
            return Substitution(source[start + 2 : end], quoted)
        if follow == "{":
            end = self._closing("}", start)
            self.at = end + 1
            return _braced(source[start + 2 : end], quoted)
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

    def _matching_parenthesis(self) -> int:
        """Skip words and operators up to the `)` that closes a `$(`; leaves `at` behind it and returns its position."""
        depth = 1
        while True:
            token = self._next()
            if token.kind == "end":
                raise Incomplete("unexpected EOF while looking for matching `)'")
            if token.kind == "op" and token.text in "()":
                depth += 1 if token.text == "(" else -1
                if depth == 0:
                    return token.start

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
            parts: list[Part] = [Text(text, quoted=True)] if literal else _Lexer(text)._quoted("")
            token.document.append(Word(tuple(parts), text))
        self._documents.clear()


def _braced(inside: str, quoted: bool) -> Variable:
    if inside.startswith("#") and len(inside) > 1:
        return Variable(inside[1:], quoted, "#")
    end = 1 if inside[:1] in _SPECIAL_NAMES and inside else 0
    while not end or (end < len(inside) and (inside[end] == "_" or inside[end].isalnum())):
        if end >= len(inside) or not (inside[end] == "_" or inside[end].isalnum()):
            break
        end += 1
    name, rest = inside[:end], inside[end:]
    for operator in (":-", ":=", ":+", "-", "=", "+", "%%", "%", "##", "#"):
        if name and rest.startswith(operator):
            return Variable(name, quoted, operator, rest[len(operator) :])
    if not name or rest:
        raise SyntaxProblem(f"${{{inside}}}: bad substitution")
    return Variable(name, quoted)
