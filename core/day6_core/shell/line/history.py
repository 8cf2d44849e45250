"""The lines typed so far, kept in `~/.bash_history` as bash does."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from day6_core.shell.language.lexer import tokenize
from day6_core.shell.language.tokens import Token
from day6_core.shell.language.words import SyntaxProblem
from day6_core.whole_file import append_private

KEPT = 1000

_COMMAND_BEGINS = frozenset({";", "&", "&&", "||", "|", "|&", "(", ";;", ";&", ";;&"})
_GOES_ON = frozenset({"do", "then", "else", "elif", "if", "while", "until", "case", "{", "!"})
"""Keywords after which a command begins, on the same line or on the next."""


def in_one_line(source: str) -> str:
    """Return a command of several lines as bash's history keeps it (cmdhist): in one line if that means the same.

    Newlines in quotes and the bodies of here-documents stay.
    """
    if "\n" not in source or "<<" in source:
        return source
    try:
        tokens = tokenize(source)
    except SyntaxProblem:
        return source
    parts, at = [], 0
    for index, token in enumerate(tokens):
        gap = source[at : token.start]
        comment = "#" in gap
        parts.append(gap if comment else gap.replace("\\\n", ""))
        at = token.end
        if token.kind != "newline":
            parts.append(source[token.start : token.end])
        elif tokens[index - 1].kind != "newline" and tokens[index + 1].kind != "end":
            parts.append("\n" if comment else _between(tokens[:index]))
    return "".join(parts)


def _between(tokens: list[Token]) -> str:
    """Return what replaces the newline after these tokens."""
    if not tokens:
        return ""
    last, before = tokens[-1], tokens[-2] if len(tokens) > 1 else None
    if last.kind == "op":
        if last.text == ")":  # of a function, of a pattern in `case`, or the end of a subshell
            in_case = _times(tokens, "case") > _times(tokens, "esac")
            return " " if in_case or (before is not None and before.text == "(") else "; "
        return " " if last.text in _COMMAND_BEGINS else "; "
    if before is not None and before.text in ("for", "case", "select") and _at_command(tokens[:-2]):
        return " "  # `in` follows
    if last.text == "in" and len(tokens) > 2:
        return " " if tokens[-3].text in ("for", "case", "select") else "; "
    return " " if last.text in _GOES_ON and _at_command(tokens[:-1]) else "; "


def _at_command(tokens: list[Token]) -> bool:
    """Whether a command begins after these tokens, so that a keyword counts as one."""
    if not tokens or tokens[-1].kind == "newline":
        return True
    last = tokens[-1]
    if last.kind == "op":
        return last.text in _COMMAND_BEGINS or last.text == ")"
    return last.text in _GOES_ON and _at_command(tokens[:-1])


def _times(tokens: list[Token], keyword: str) -> int:
    return sum(token.text == keyword and _at_command(tokens[:index]) for index, token in enumerate(tokens))


class History:
    """`lines`, oldest first; repeated lines and lines that begin with a space are not kept (HISTCONTROL=ignoreboth)."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self.lines: list[str] = []
        self._unwritten = b""
        """Lines that a full or read-only disk did not take: they go there before the next one."""
        try:
            self.lines = file.read_text(encoding="utf-8", errors="surrogateescape").splitlines()[-KEPT:]
        except OSError:
            return  # a first start, or an unreadable home folder: there is no history

    def add(self, source: str) -> None:
        """Remember a command; a command of several lines becomes one if that means the same."""
        line = in_one_line(source)
        if line.startswith(" ") or (self.lines and self.lines[-1] == line):
            return
        self.lines.append(line)
        if len(self.lines) > KEPT:
            del self.lines[0]
        self._unwritten += (line + "\n").encode("utf-8", "surrogateescape")
        with suppress(OSError):  # as in bash, which says nothing of it either
            append_private(self._file, self._unwritten)
            self._unwritten = b""

    def search(self, text: str, before: int) -> int | None:
        """Index of the last line before index `before` that contains `text`; None if there is none."""
        for index in range(min(before, len(self.lines)) - 1, -1, -1):
            if text in self.lines[index]:
                return index
        return None
