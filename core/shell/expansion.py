"""From the words of a command line to its arguments: `~`, variables, `$(…)`, `$((…))`, splitting, file name patterns, quotes."""

from __future__ import annotations

import glob
import itertools
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_tui.core.shell.arithmetic import evaluate
from day6_tui.core.shell.lexer import Part, Substitution, SyntaxProblem, Text, Variable, Word

if TYPE_CHECKING:
    from day6_tui.core.shell.interpreter import Shell
    from day6_tui.core.shell.redirection import Streams

_PATTERN = frozenset("*?[")


class UnboundProblem(SyntaxProblem):
    """`${NAME:?text}` and bad substitutions: ends the command line with status 1."""


class _Fields:
    """Arguments being put together: each is a list of (text, quoted) pieces."""

    def __init__(self) -> None:
        self.done: list[list[tuple[str, bool]]] = []
        self._open: list[tuple[str, bool]] | None = None

    def add(self, text: str, quoted: bool) -> None:
        if self._open is None:
            if not text and not quoted:
                return
            self._open = []
        self._open.append((text, quoted))

    def end(self) -> None:
        if self._open is not None:
            self.done.append(self._open)
            self._open = None

    def add_split(self, text: str) -> None:
        """Add unquoted text from an expansion: white space in it separates arguments."""
        if not text:
            return
        if text[0].isspace():
            self.end()
        for number, piece in enumerate(text.split()):
            if number:
                self.end()
            self.add(piece, False)
        if text[-1].isspace():
            self.end()


async def expand(words: list[Word], shell: Shell, streams: Streams) -> list[str]:
    """Return the arguments that `words` stand for."""
    arguments: list[str] = []
    for word in words:
        for single in _braces(word):
            fields = _Fields()
            for part in _tilde(single.parts, shell):
                if isinstance(part, Text):
                    fields.add(part.text, part.quoted)
                elif isinstance(part, Variable) and part.name in "@*" and not part.operator:
                    for number, value in enumerate(shell.arguments):
                        if number:
                            fields.end()
                        fields.add(value, part.quoted)
                else:
                    value = await _value(part, shell, streams)
                    if part.quoted:
                        fields.add(value, True)
                    else:
                        fields.add_split(value)
            fields.end()
            for pieces in fields.done:
                arguments.extend(_files(pieces, shell.cwd))
    return arguments


async def expand_text(word: Word, shell: Shell, streams: Streams) -> str:
    """Return what `word` stands for as one text: no splitting, no patterns (assignments, redirections, here-documents)."""
    result = []
    for part in _tilde(word.parts, shell):
        if isinstance(part, Text):
            result.append(part.text)
        elif isinstance(part, Variable) and part.name in "@*" and not part.operator:
            result.append(" ".join(shell.arguments))
        else:
            result.append(await _value(part, shell, streams))
    return "".join(result)


def _tilde(parts: tuple[Part, ...], shell: Shell) -> tuple[Part, ...]:
    first = parts[0] if parts else None
    if not isinstance(first, Text) or first.quoted or not first.text.startswith("~"):
        return parts
    user, slash, rest = first.text[1:].partition("/")
    if user not in ("", shell.variables.get("USER", "")) or (not slash and len(parts) > 1):
        return parts
    home = shell.variables.get("HOME", "~")
    return (Text(home, quoted=True), Text(slash + rest), *parts[1:])


async def _value(part: Variable | Substitution, shell: Shell, streams: Streams) -> str:
    if isinstance(part, Substitution):
        if part.arithmetic:
            try:
                return str(evaluate(part.source, shell.variables))
            except (ArithmeticError, ValueError) as error:
                raise UnboundProblem(f"{part.source.strip()}: {error}") from None
        return await shell.output_of(part.source, streams)
    value = shell.parameter(part.name)
    operator = part.operator
    if not operator:
        return value or ""
    if operator == "#" and not part.argument:
        return str(len(value or ""))
    if operator in ("%", "%%", "#", "##"):
        return _trim(value or "", operator, await _argument(part, shell, streams))
    missing = value is None or (operator.startswith(":") and not value)
    if operator in (":+", "+"):
        return "" if missing else await _argument(part, shell, streams)
    if not missing:
        return value or ""
    default = await _argument(part, shell, streams)
    if operator in (":=", "="):
        shell.variables[part.name] = default
    return default


async def _argument(part: Variable, shell: Shell, streams: Streams) -> str:
    from day6_tui.core.shell.lexer import tokenize

    words = [token.word for token in tokenize(part.argument) if token.word is not None]
    return " ".join([await expand_text(word, shell, streams) for word in words])


def _trim(value: str, operator: str, pattern: str) -> str:
    """`${x%pattern}` and its relatives: cut the shortest or longest matching end or beginning."""
    from fnmatch import fnmatchcase

    lengths = range(len(value) + 1)
    cuts = lengths if len(operator) == 1 else reversed(lengths)
    for length in cuts:
        if operator[0] == "%" and fnmatchcase(value[len(value) - length :], pattern):
            return value[: len(value) - length]
        if operator[0] == "#" and fnmatchcase(value[:length], pattern):
            return value[length:]
    return value


def _files(pieces: list[tuple[str, bool]], cwd: Path) -> list[str]:
    text = "".join(piece for piece, _ in pieces)
    if not any(not quoted and _PATTERN.intersection(piece) for piece, quoted in pieces):
        return [text]
    pattern = "".join(glob.escape(piece) if quoted else piece for piece, quoted in pieces)
    return sorted(glob.glob(pattern, root_dir=cwd)) or [text]


def _braces(word: Word) -> list[Word]:
    """`a{b,c}` and `{1..3}`, where the braces stand in one unquoted piece; every other word as it is."""
    for index, part in enumerate(word.parts):
        if isinstance(part, Text) and not part.quoted and "{" in part.text:
            texts = _brace_texts(part.text)
            if texts != [part.text]:
                before, after = word.parts[:index], word.parts[index + 1 :]
                return [replace(word, parts=(*before, Text(text), *after)) for text in texts]
    return [word]


def _brace_texts(text: str) -> list[str]:
    start = text.find("{")
    while start >= 0:
        depth, commas = 0, []
        for at in range(start, len(text)):
            if text[at] == "{":
                depth += 1
            elif text[at] == "," and depth == 1:
                commas.append(at)
            elif text[at] == "}":
                depth -= 1
                if depth == 0:
                    break
        else:
            return [text]
        inside = text[start + 1 : at]
        if commas:
            bounds = [start, *commas, at]
            choices = [text[a + 1 : b] for a, b in itertools.pairwise(bounds)]
            inner = [expanded for choice in choices for expanded in _brace_texts(choice)]
        else:
            inner = _brace_range(inside)
        if inner:
            return [text[:start] + choice + rest for choice in inner for rest in _brace_texts(text[at + 1 :])]
        start = text.find("{", start + 1)
    return [text]


def _brace_range(inside: str) -> list[str]:
    first, dots, last = inside.partition("..")
    if not dots:
        return []
    try:
        low, high = int(first), int(last)
    except ValueError:
        if len(first) == len(last) == 1 and first.isalpha() and last.isalpha():
            step = 1 if first <= last else -1
            return [chr(code) for code in range(ord(first), ord(last) + step, step)]
        return []
    if abs(high - low) > 10_000:
        return []
    step = 1 if low <= high else -1
    return [str(number) for number in range(low, high + step, step)]
