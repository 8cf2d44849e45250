"""Tab completion: commands, files, variables and, from the `ros2` command, packages, executables, nodes, topics, types."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.session.session import Session
from day6_core.shell.commands import command_names
from day6_core.shell.language.lexer import tokenize
from day6_core.shell.language.tokens import Token
from day6_core.shell.language.words import Incomplete, SyntaxProblem, Text
from day6_core.shell.process.real_tools import tools_beginning_with

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell

_ONLY_FOLDERS = frozenset({"cd", "rmdir", "mkdir"})
_BEFORE_A_COMMAND = frozenset({"sudo", "command", "which", "type", "man", "env"})
_NEEDS_BACKSLASH = frozenset(" \t'\"\\$&;|()<>*?[]{}`!#")


COMPLETED = ("ros2", "colcon")
"""The commands that complete their own arguments."""


async def own_words(
    words: list[str], session: Session, cwd: Path, environment: Mapping[str, str]
) -> Iterable[str] | None:
    """Return the completions that one of `COMPLETED` offers for the last of `words`; None where a file is expected."""
    if words[0] == "colcon":
        from day6_core.workspace.completion import complete

        return complete(words, session, cwd, environment)
    from day6_core.ros import ros2

    return await ros2.complete(words, session) or (None if _wants_file(words) else [])


class Completer:
    """Finds completions for the text before the cursor."""

    def __init__(self, shell: Shell, session: Session) -> None:
        self._shell = shell
        self._session = session

    async def complete(self, before: str) -> tuple[list[str], int]:
        """For the line up to the cursor return (sorted texts that could replace its last word, where that word begins)."""
        words, start, quote = current_words(before)
        typed = words[-1]
        if typed.startswith("$") and "/" not in typed:
            names = [f"${name}" for name in self._shell.variables]
            return sorted(name for name in names if name.startswith(typed)), start
        if len(words) == 1 or (words[-2] in _BEFORE_A_COMMAND and len(words) == 2):
            if "/" not in typed and not typed.startswith("~"):
                commands = {*command_names(), *self._shell.aliases, *self._shell.functions}
                if typed:
                    commands |= tools_beginning_with(typed, self._shell.variables, self._shell.cwd)
                return sorted(name for name in commands - {".", ":", "["} if name.startswith(typed)), start
        elif words[0] in COMPLETED:
            offered = await own_words(words, self._session, self._shell.cwd, self._shell.environment)
            if offered is not None:
                return sorted({quoted(choice, quote) for choice in offered if choice.startswith(typed)}), start
        elif words[0] in ("kill", "fg", "bg", "wait") and typed.startswith("%"):
            return sorted(f"%{job.number}" for job in self._shell.jobs.jobs), start
        return self._files(typed, quote, folders_only=words[0] in _ONLY_FOLDERS), start

    def _files(self, typed: str, quote: str, *, folders_only: bool) -> list[str]:
        head, slash, tail = typed.rpartition("/")
        folder = self._folder(head + slash)
        try:
            entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
        except OSError:
            return []
        choices = []
        for entry in entries:
            is_folder = entry.is_dir()
            if not entry.name.startswith(tail) or (entry.name.startswith(".") and not tail.startswith(".")):
                continue
            if is_folder or not folders_only:
                choices.append(quoted(head + slash + entry.name + ("/" if is_folder else ""), quote))
        return choices

    def _folder(self, head: str) -> Path:
        if head == "~/" or head.startswith("~/"):
            return Path(self._shell.variables.get("HOME", "/")) / head[2:]
        return self._shell.cwd / head if head else self._shell.cwd


def current_words(before: str) -> tuple[list[str], int, str]:
    """Return (words of the command being typed, the last one maybe empty; where the last begins; the quote it is in, or '')."""
    quote = ""
    for closing in ("", "'", '"'):
        try:
            tokens = tokenize(before + closing)
        except Incomplete:
            continue
        except SyntaxProblem:
            break
        quote = closing
        break
    else:
        tokens = []
    if not tokens:
        start = before.rfind(" ") + 1
        return [*before[:start].split(), before[start:]] if before[:start].split() else [before[start:]], start, ""
    command: list[Token] = []
    skip = False
    for token in tokens[:-1]:
        if (token.kind == "op" and token.text not in ("<", ">", ">>", ">&", "&>")) or token.kind == "newline":
            command = []
        elif token.kind == "op":
            skip = True
        elif token.word is not None:
            if not skip:
                command.append(token)
            elif token.end >= len(before):
                return ["", _plain(token)], token.start, quote
            skip = False
    if skip:
        return ["", ""], len(before), ""
    while len(command) > 1 and command[0].text.partition("=")[0].isidentifier() and "=" in command[0].text:
        command = command[1:]
    if command and command[-1].end >= len(before) and not (before.endswith(" ") and not quote):
        return [_plain(token) for token in command], command[-1].start, quote
    return [*(_plain(token) for token in command), ""], len(before), ""


def _plain(token: Token) -> str:
    """A word without its quotes; variables stay as they were typed."""
    assert token.word is not None
    if all(isinstance(part, Text) for part in token.word.parts):
        return "".join(part.text for part in token.word.parts if isinstance(part, Text))
    return token.word.source


def quoted(text: str, quote: str) -> str:
    """Return a word as it must be typed: in the quotes that were begun, message values in double ones, else with backslashes."""
    if not quote and text.startswith("{"):
        quote = '"'
    if not quote:
        return "".join("\\" + char if char in _NEEDS_BACKSLASH else char for char in text)
    if quote == "'":
        inside = text.replace("'", "'\\''")
    else:
        inside = "".join("\\" + char if char in '\\"$`' else char for char in text)
    return quote + inside + ("" if text.endswith("/") else quote)


def _wants_file(words: list[str]) -> bool:
    """Whether a `ros2` argument can be a file: after --params-file and its like, or what is being typed looks like a path."""
    return words[-2] in ("--params-file", "load", "play", "-o", "--output-dir") or words[-1].startswith(
        ("./", "../", "~/")
    )
