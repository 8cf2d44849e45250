"""From the words of a command line to its arguments: `~`, variables, `$(…)`, `$((…))`, splitting, file name patterns, quotes."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

from day6_core.shell.language.arithmetic import ArithmeticProblem, evaluate
from day6_core.shell.language.assignments import argument_of, assignment
from day6_core.shell.language.braces import braces
from day6_core.shell.language.file_names import files
from day6_core.shell.language.lexer import single_word
from day6_core.shell.language.parameters import ExpansionProblem, UnboundProblem, value_of
from day6_core.shell.language.patterns import Pattern, Pieces, pattern
from day6_core.shell.language.regular import regular
from day6_core.shell.language.words import (
    DECLARATIONS,
    ArrayLiteral,
    Part,
    ProcessSubstitution,
    Substitution,
    SyntaxProblem,
    Text,
    Variable,
    Word,
)

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams

__all__ = ["ExpansionProblem", "UnboundProblem", "expand", "expand_pattern", "expand_regular", "expand_text", "sum_of"]

_NAMED = re.compile(r"[A-Za-z_]\w*\+?=")
"""What makes an argument look like an assignment: bash looks for `~` in its value, as in `export A=~/a` so in `echo A=~/a`."""
_BLANK = " \t\n"


class _Fields:
    """Arguments being put together: each is a list of (text, quoted) pieces. `separators` is IFS."""

    def __init__(self, separators: str) -> None:
        self.done: list[Pieces] = []
        self._open: Pieces | None = None
        self._blanks = "".join(char for char in separators if char in _BLANK)
        self._others = "".join(char for char in separators if char not in _BLANK)

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
        """Add unquoted text of an expansion, in which IFS separates arguments: a run of white space, or each other character."""
        if (
            self._blanks == _BLANK
            and not self._others
            and not text.isspace()
            and text.isascii()
            and not set(text) & set("\r\v\f")
        ):
            self._add_words(text)
            return
        at = 0
        while at < len(text):
            start = at
            while at < len(text) and text[at] in self._blanks:
                at += 1
            if at < len(text) and text[at] in self._others:
                self._open = self._open or []
                self.end()
                at += 1
                while at < len(text) and text[at] in self._blanks:
                    at += 1
            elif at > start:
                self.end()
            start = at
            while at < len(text) and text[at] not in self._blanks and text[at] not in self._others:
                at += 1
            self.add(text[start:at], False)

    def _add_words(self, text: str) -> None:
        if text[:1] in _BLANK and text:
            self.end()
        for number, piece in enumerate(text.split()):
            if number:
                self.end()
            self.add(piece, False)
        if text[-1:] in _BLANK and text:
            self.end()


async def expand(words: list[Word], shell: Shell, streams: Streams) -> list[str]:
    """Return the arguments that `words` expand to."""
    arguments: list[str] = []
    for word in words:
        for single in braces(word) if "B" in shell.options else [word]:
            fields = _Fields(shell.separators)
            await _fill(fields, _tilde(single.parts, shell, argument=True), shell, streams)
            fields.end()
            for pieces in fields.done:
                arguments.extend(await _named_files(pieces, shell))
    return arguments


async def expand_command(words: list[Word], shell: Shell, streams: Streams) -> list[str]:
    """Return the arguments of a command: those of `declare` and its relatives that are assignments are not split."""
    if not words or words[0].plain not in DECLARATIONS:
        return await expand(words, shell, streams)
    arguments: list[str] = []
    for word in words:
        assigned = assignment(word)
        if assigned is None or (isinstance(word.parts[0], Text) and word.parts[0].quoted):
            arguments.extend(await expand([word], shell, streams))
        else:
            keyed = any(each.startswith("-") and "A" in each for each in arguments)
            arguments.append(await argument_of(assigned, word, shell, streams, keyed=keyed))
    return arguments


async def _named_files(pieces: Pieces, shell: Shell) -> list[str]:
    """The files that an argument names, or the argument."""
    text = "".join(piece for piece, _ in pieces)
    if "f" in shell.options:
        return [text]
    found = await files(pieces, shell.cwd, shell.settings)
    if found is None or (not found and not shell.settings & {"nullglob", "failglob"}):
        return [text]
    if not found and "failglob" in shell.settings:
        raise ExpansionProblem(f"no match: {text}")
    return found


async def _fill(
    fields: _Fields, parts: tuple[Part, ...], shell: Shell, streams: Streams, *, nested: bool = False
) -> None:
    """Add the parts of a word; `nested`: they stand in a `${x:-…}`, whose plain text is split, too."""
    for part in parts:
        if isinstance(part, Text):
            if nested and not part.quoted:
                fields.add_split(part.text)
            else:
                fields.add(part.text, part.quoted)
        elif isinstance(part, Variable):
            value = await value_of(part, shell, streams)
            if isinstance(value, Word):
                if part.quoted and not value.parts:
                    fields.add("", True)
                await _fill(fields, _tilde(value.parts, shell), shell, streams, nested=True)
            elif part.quoted and value.star:
                fields.add(shell.separators[:1].join(value.texts), True)
            elif part.quoted and not value.many:
                fields.add(value.text or "", True)
            else:
                for number, text in enumerate(value.texts):
                    if number:
                        fields.end()
                    if part.quoted:
                        fields.add(text, True)
                    else:
                        fields.add_split(text)
        else:
            text = await _output(part, shell, streams)
            if part.quoted or isinstance(part, ProcessSubstitution):
                fields.add(text, True)
            else:
                fields.add_split(text)


async def expand_text(word: Word, shell: Shell, streams: Streams, *, assigned: bool = False) -> str:
    """Expand `word` to one text: no splitting, no patterns (assignments, redirections, here-documents)."""
    parts = _tildes_of_value(word.parts, shell) if assigned else _tilde(word.parts, shell)
    return "".join([text for text, _ in await _texts(parts, shell, streams)])


async def pieces_of(word: Word, shell: Shell, streams: Streams) -> Pieces:
    """Expand to texts, each with whether it was quoted."""
    return await _texts(_tilde(word.parts, shell), shell, streams)


async def _texts(parts: tuple[Part, ...], shell: Shell, streams: Streams) -> Pieces:
    found: Pieces = []
    for part in parts:
        if isinstance(part, Text):
            found.append((part.text, part.quoted))
        elif isinstance(part, Variable):
            value = await value_of(part, shell, streams)
            if isinstance(value, Word):
                found.extend(await _texts(_tilde(value.parts, shell), shell, streams))
            else:
                separator = shell.separators[:1] if value.star else " "
                found.append((separator.join(value.texts), part.quoted))
        else:
            found.append((await _output(part, shell, streams), part.quoted))
    return found


async def _output(part: Substitution | ProcessSubstitution | ArrayLiteral, shell: Shell, streams: Streams) -> str:
    if isinstance(part, ArrayLiteral):
        raise SyntaxProblem("syntax error near unexpected token `('")
    if isinstance(part, ProcessSubstitution):
        from day6_core.shell.language.substitution import file_of

        return await file_of(shell, part, streams)
    if part.arithmetic:
        return str(await sum_of(part.source, shell, streams))
    return await shell.output_of(part.source, streams)


def _tilde(parts: tuple[Part, ...], shell: Shell, *, argument: bool = False) -> tuple[Part, ...]:
    first = parts[0] if parts else None
    if not isinstance(first, Text) or first.quoted:
        return parts
    if argument and (name := _NAMED.match(first.text)):
        return (Text(name[0]), *_tildes_of_value((Text(first.text[name.end() :]), *parts[1:]), shell))
    if not first.text.startswith("~"):
        return parts
    user, slash, rest = first.text[1:].partition("/")
    if not slash and len(parts) > 1:
        return parts
    variable = {"": "HOME", shell.desk.user: "HOME", "+": "PWD", "-": "OLDPWD"}.get(user)
    home = shell.variables.get(variable, f"~{user}") if variable else os.path.expanduser(f"~{user}")
    if home == f"~{user}":
        return parts
    return (Text(home, quoted=True), Text(slash + rest), *parts[1:])


def _tildes_of_value(parts: tuple[Part, ...], shell: Shell) -> tuple[Part, ...]:
    """Expand tildes in a value that is assigned: at its beginning and after each colon (`PATH=$PATH:~/bin`)."""
    found: list[Part] = []
    begins = True
    for number, part in enumerate(parts):
        if not isinstance(part, Text) or part.quoted:
            found.append(part)
            begins = False
            continue
        pieces = part.text.split(":")
        for at, piece in enumerate(pieces):
            if at:
                found.append(Text(":"))
                begins = True
            rest = parts[number + 1 :] if at == len(pieces) - 1 else ()
            head = _tilde((Text(piece), *rest), shell) if begins else (Text(piece), *rest)
            found.extend(head[: len(head) - len(rest)])
            begins = begins and not piece
    return tuple(found)


async def sum_of(source: str, shell: Shell, streams: Streams) -> int:
    """The value of `$((source))`. Raises ExpansionProblem with bash's text."""
    text = source
    if any(char in source for char in "$`\"\\'"):
        text = await expand_text(single_word(source, quoted=True, toggling=True), shell, streams)
    try:
        return evaluate(text, shell.variables, unset_is_wrong="u" in shell.options)
    except ArithmeticProblem as problem:
        raise (UnboundProblem if problem.unbound else ExpansionProblem)(str(problem)) from None


async def expand_pattern(word: Word, shell: Shell, streams: Streams, *, extended: bool = True) -> Pattern:
    """Return a word as a pattern: quoted text is literal."""
    pieces = await pieces_of(word, shell, streams)
    return pattern(pieces, extended=extended, ignore_case="nocasematch" in shell.settings)


async def expand_regular(word: Word, shell: Shell, streams: Streams) -> str:
    """Return a word as a regular expression for `re`: quoted text is literal. Raises re.error."""
    pieces = await pieces_of(word, shell, streams)
    return regular(
        "".join(re.sub(r"([][\\.*+?{}()|^$])", r"\\\1", text) if quoted else text for text, quoted in pieces)
    )
