"""What the lexer hands to the parser."""

from __future__ import annotations

from dataclasses import dataclass, field

from day6_core.shell.language.words import Word

OPERATORS = (
    ";;&", "&>>", "<<<", "<<-", "&&", "||", ";;", ";&", ">>", "<<", ">&", "<&", ">|", "&>", "|&", "<>",
    "|", "&", ";", "(", ")", "<", ">",
)  # fmt: skip
"""Longest first."""

REDIRECTIONS = frozenset({">", ">>", "<", "<<", "<<-", "<<<", ">&", "<&", ">|", "&>", "&>>", "<>"})

ENDS_OF_CHOICE = (";;", ";&", ";;&")
"""Of `case`."""


@dataclass
class Token:
    """`kind` is 'word', 'op', 'newline', 'number' (a file descriptor, or `{NAME}` for one, before a redirection) or 'end'."""

    kind: str
    text: str
    start: int
    end: int
    word: Word | None = None
    document: list[Word] = field(default_factory=list)
    """The body of a here-document, on its `<<` token, once it was read."""
