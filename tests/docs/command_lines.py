"""`day6-tui …` in lines for a real shell: whether this command is there, and takes these arguments and options."""

from __future__ import annotations

import argparse
import contextlib
import io
import re
import shlex
from collections.abc import Iterator

from day6_core.command_line.leading import BEFORE_A_PROGRAM, DISTRIBUTION, LANGUAGE, leading
from day6_tui.commands.table import command_named

_OPERATORS = re.compile(r"[;&|()<>]+")


def own(line: str) -> Iterator[list[str]]:
    """Yield what follows each `day6-tui` of a line: `uv run day6-tui --scene turtle | cat` has ["--scene", "turtle"]."""
    unquoted = re.sub(r'"\$\((.*?)\)"', r"$(\1)", line.replace("\\", "/"))
    lexer = shlex.shlex(unquoted, posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    found: list[str] | None = None
    for word in [*lexer, ";"]:
        if _OPERATORS.fullmatch(word):
            if found is not None:
                yield found
            found = None
        elif found is not None:
            found.append(word)
        elif word.rpartition("/")[2] in ("day6-tui", "day6-tui.exe"):
            found = []


def mistake(words: list[str]) -> str:
    """Return what is wrong with the words after `day6-tui`; '' if nothing is. No file has to be there."""
    front, rest = leading(words, (LANGUAGE, DISTRIBUTION))
    if not rest or rest[0].startswith("-"):
        front, rest = [], ["", *words]  # the desktop's
    name, *rest = rest
    if (command := command_named(name)) is None:
        return f"there is no command {name}"
    if (parser := command.parser("en")) is None:  # ros2, colcon …: their own tests judge their arguments
        return ""
    if name == "python":  # the rest is the program's
        before, after = leading(rest, BEFORE_A_PROGRAM)
        rest = [*before, *after[:1]]
    for each in (parser, *parser.verbs.values()):
        for action in each.actions:
            action.type = None if action.choices is None else action.type
    said = io.StringIO()
    try:
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
            parser.parse_args([*front, *rest], argparse.Namespace())
    except SystemExit as ended:
        return said.getvalue() if ended.code else ""
    return ""
