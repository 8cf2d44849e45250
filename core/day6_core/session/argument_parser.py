"""An argument parser that writes to a session, with the texts of Python 3.11's argparse on every Python.

The real `ros2` prints argparse's usage, help and error texts, and students compare them with a tutorial. Newer Pythons word
and lay them out differently, so the places where they differ are redefined here.
"""

from __future__ import annotations

import argparse
import functools
import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NoReturn

if TYPE_CHECKING:
    from day6_core.session.session import Session


class ParserExit(Exception):
    """Raised where argparse would end the process; `status` is the exit status."""

    def __init__(self, status: int) -> None:
        super().__init__(status)
        self.status = status


class SessionParser(argparse.ArgumentParser):
    """An ArgumentParser for one session. Help goes to its stdout, errors to its stderr; both raise ParserExit."""

    def __init__(self, session: Session, **keywords: Any) -> None:
        width = terminal_width(session)
        keywords.setdefault("formatter_class", functools.partial(HelpFormatter, width=width - 2))
        super().__init__(**keywords)
        self.session = session
        self.color = False  # Python 3.14 would colour the texts

    def add_commands(self, cli_name: str, description: str) -> Any:
        """Add the sub-parsers of `cli_name`, laid out as in ros2cli; returns argparse's action with `add_parser`."""
        options: dict[str, Any] = {"parser_class": functools.partial(SessionParser, self.session)}
        return self.add_subparsers(
            title="Commands",
            description=description,
            metavar=f"Call `{cli_name} <command> -h` for more detailed usage.",
            dest=" command",
            required=False,
            **options,
        )

    def _print_message(self, message: str, file: Any = None) -> None:
        stream = self.session.stdout if file is None else self.session.stderr
        stream.write(message)

    def print_help(self, file: Any = None) -> None:
        """Write the help to the session's stdout; `file` is there for argparse's signature only."""
        self._print_message(self.format_help())

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        """Write `message` to the session's stderr and raise ParserExit with `status`."""
        if message:
            self.session.stderr.write(message)
        raise ParserExit(status)

    def error(self, message: str) -> NoReturn:
        """Write the usage and `message` to the session's stderr and raise ParserExit with status 2."""
        self.exit(2, f"{self.format_usage()}{self.prog}: error: {message}\n")

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            choices = ", ".join(map(repr, action.choices))
            raise argparse.ArgumentError(action, f"invalid choice: {value!r} (choose from {choices})")


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Lays help and usage out as Python 3.11 does."""

    def _format_action_invocation(self, action: argparse.Action) -> str:
        # Since 3.13: `-t, --tag TAG`; before: the value after each option string.
        if not action.option_strings:
            return super()._format_action_invocation(action)
        if action.nargs == 0:
            return ", ".join(action.option_strings)
        value = self._format_args(action, self._get_default_metavar_for_optional(action))
        return ", ".join(f"{option} {value}" for option in action.option_strings)

    def _format_usage(
        self,
        usage: str | None,
        actions: Iterable[argparse.Action],
        groups: Iterable[Any],
        prefix: str | None,
    ) -> str:
        start = f"{'usage: ' if prefix is None else prefix}{self._prog}"
        shown = [action for action in actions if action.help is not argparse.SUPPRESS]
        options = self._option_parts([action for action in shown if action.option_strings], list(groups))
        positionals = self._positional_parts([action for action in shown if not action.option_strings])
        room = max(self._width - self._current_indent, 11)
        line = " ".join([start, *options, *positionals])
        if len(line) <= room:
            return f"{line}\n\n"
        if len(start) > 0.75 * room:
            indent = " " * len("usage: ")
            lines = _wrapped([*options, *positionals], indent, room, len(indent) - 1)
            if len(lines) > 1:
                lines = [
                    line for part in (options, positionals) for line in _wrapped(part, indent, room, len(indent) - 1)
                ]
            return "\n".join([start, *lines]) + "\n\n"
        indent = " " * (len(start) + 1)
        if not options:
            lines = _wrapped(positionals, indent, room, len(start))
        else:
            lines = _wrapped(options, indent, room, len(start)) + _wrapped(positionals, indent, room, len(indent) - 1)
        lines[0] = f"{start} {lines[0].lstrip()}"
        return "\n".join(lines) + "\n\n"

    def _option_parts(self, actions: Sequence[argparse.Action], groups: Sequence[Any]) -> list[str]:
        """Return one bracketed part per option, and one per group of mutually exclusive options."""
        parts: list[str] = []
        position = 0
        while position < len(actions):
            action = actions[position]
            group = next((each for each in groups if each._group_actions and each._group_actions[0] is action), None)
            members = group._group_actions if group is not None else []
            together = len(members) > 1 and list(actions[position : position + len(members)]) == members
            if together and group is not None:
                inside = " | ".join(map(self._option_text, members))
                parts.append(f"({inside})" if group.required else f"[{inside}]")
                position += len(members)
            else:
                text = self._option_text(action)
                parts.append(text if action.required else f"[{text}]")
                position += 1
        return _breakable(parts)

    def _option_text(self, action: argparse.Action) -> str:
        option = action.option_strings[0]
        if action.nargs == 0:
            return option
        return f"{option} {self._format_args(action, self._get_default_metavar_for_optional(action))}"

    def _positional_parts(self, actions: Sequence[argparse.Action]) -> list[str]:
        return _breakable(
            [self._format_args(action, self._get_default_metavar_for_positional(action)) for action in actions]
        )


def _breakable(parts: Sequence[str]) -> list[str]:
    """Cut the parts where a line may break: between any two words outside brackets."""
    return re.findall(r"\(.*?\)+(?=\s|$)|\[.*?\]+(?=\s|$)|\S+", " ".join(parts))


def _wrapped(parts: Sequence[str], indent: str, room: int, used: int) -> list[str]:
    """Put the parts into lines of at most `room` characters after `indent`; on the first line `used` of them are taken."""
    lines: list[str] = []
    line: list[str] = []
    for part in parts:
        if line and used + 1 + len(part) > room:
            lines.append(indent + " ".join(line))
            line, used = [], len(indent) - 1
        line.append(part)
        used += 1 + len(part)
    if line:
        lines.append(indent + " ".join(line))
    return lines


def terminal_width(session: Session) -> int:
    """Return the width for help texts: COLUMNS if it is a number, else the terminal's, 80 without one."""
    columns = session.env.get("COLUMNS", "")
    if columns.isdigit() and int(columns) > 0:
        return int(columns)
    return session.stdout.columns or 80
