#!/usr/bin/env python3
"""Writes docs/man/day6-tui.1 from the table of commands and their parsers: `python .ci/man_page.py`."""

from __future__ import annotations

import argparse
import os
import re
from collections.abc import Container, Iterator
from pathlib import Path

from day6_core.command_line.parser import CommandParser
from day6_core.command_line.texts import CommandTexts
from day6_tui.commands.table import GROUPS, commands

PAGE = Path(__file__).resolve().parents[1] / "docs" / "man" / "day6-tui.1"
LANGUAGE = "en"


def page() -> str:
    """Return the whole page; only ASCII, and the same on every machine."""
    before = os.environ.get("COLUMNS")
    os.environ["COLUMNS"] = "10000"  # usages in one line
    try:
        return "\n".join([*_lines(), ""])
    finally:
        os.environ.pop("COLUMNS")
        if before is not None:
            os.environ["COLUMNS"] = before


def _lines() -> Iterator[str]:
    desktop, *others = commands()
    parser = desktop.parser(LANGUAGE)
    assert parser is not None
    texts = CommandTexts(LANGUAGE)
    yield '.\\" Made by .ci/man_page.py from the parsers; change the texts in core/day6_core/command_line/locale.'
    yield '.TH DAY6\\-TUI 1 "" "day6\\-tui"'
    yield from (".nh", ".ad l")
    yield from (".SH NAME", f"day6\\-tui \\- {_text(desktop.summary(LANGUAGE))}")
    yield ".SH SYNOPSIS"
    for count, usage in enumerate(("[OPTION ...]", "COMMAND [ARG ...]")):
        yield from ([".br"] if count else [])
        yield f".B day6\\-tui\n{_text(usage)}"
    yield from (".SH DESCRIPTION", _text(parser.description or ""))
    yield ".SH OPTIONS"
    yield from _arguments(parser)
    for group in GROUPS:
        yield f'.SH "{_text(texts(f"cli.group.{group}").upper())}"'
        for command in others:
            if command.group == group:
                explained = command.parser(LANGUAGE)
                if explained is None:
                    yield from (".TP", f".B {_text(command.name)}", f"{_text(command.summary(LANGUAGE))}.")
                else:
                    yield from _section(explained, parser.known_options() if command.is_desktop else ())
    yield ".SH EXIT STATUS"
    yield "2 for a command line that is wrong, with the reason on standard error; else that of the command."


def _section(parser: CommandParser, told: Container[str] = ()) -> Iterator[str]:
    """A command or verb, without the options that were told already."""
    yield f'.SS "{_text(parser.prog)}"'
    for count, usage in enumerate(parser.format_usage().partition(": ")[2].strip().split("\n")):
        yield from ([".br"] if count else [])
        yield _text(usage.strip())
    for line in (parser.description or "").split("\n"):
        yield from (".PP", _text(line[:1].upper() + line[1:]))
    yield from _arguments(parser, told)
    if told:
        yield from (".PP", "The options of the desktop (see OPTIONS) go with it.")
    for verb in parser.verbs.values():
        yield from _section(verb)
    for paragraph in filter(None, (parser.epilog or "").split("\n\n")):
        yield from (".PP", ".nf", *(_text(line) for line in paragraph.split("\n")), ".fi")


def _arguments(parser: CommandParser, told: Container[str] = ()) -> Iterator[str]:
    """What it takes, without what every command has, if this is not the desktop itself."""
    for action in parser.actions:
        if isinstance(action, argparse._SubParsersAction):
            continue
        if (" " in parser.prog and {"-h", "--lang"} & {*action.option_strings}) or any(
            option in told for option in action.option_strings
        ):
            continue
        value = "" if action.nargs == 0 else _value(action)
        yield ".TP"
        if action.option_strings:
            names = ", ".join(f"\\fB{_text(name)}\\fR" for name in action.option_strings)
            yield f"{names} \\fI{_text(value)}\\fR".removesuffix(" \\fI\\fR")
        else:
            yield f"\\fI{_text(value)}\\fR"
        yield _text(action.help or "")


def _value(action: argparse.Action) -> str:
    return str(action.metavar or "{" + ",".join(map(str, action.choices or ())) + "}")


def _text(text: str) -> str:
    """Return a text as roff writes it."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    text = re.sub(r"[^\x00-\x7f]", lambda found: f"\\[u{ord(found[0]):04X}]", text)
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.MULTILINE)


if __name__ == "__main__":
    PAGE.parent.mkdir(parents=True, exist_ok=True)
    PAGE.write_text(page(), encoding="ascii")
    print(PAGE)
