"""The parser of every sub-command of `day6-tui`: argparse in the user's language.

Each has `--help` and `--lang`. Help is folded by terminal cells, an error is one line on standard error, with status 2. Long
options are never abbreviated: what names one option today would name two tomorrow. A mistyped one is answered with the nearest.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any, NoReturn

from day6_core.command_line.texts import CommandTexts, Wording
from day6_core.language import LANGUAGES
from day6_core.session.harmless import one_line
from day6_core.width import text_width
from day6_core.wrapping import wrap


def command_parser(name: str, language: str) -> CommandParser:
    """The parser of a sub-command that explains itself with the text `cli.<name>`, still without arguments of its own."""
    texts = CommandTexts(language)
    return CommandParser(f"day6-tui {name}", texts=texts, description=texts(f"cli.{name}"))


Known = Callable[[], Iterable[str]]


class CommandParser(argparse.ArgumentParser):
    """`add_argument` puts arguments and options into groups with headings in the language."""

    def __init__(self, prog: str, *, texts: Wording, description: str = "", **others: Any) -> None:
        formatter = partial(HelpFormatter, texts=texts)
        super().__init__(
            prog, description=description, formatter_class=formatter, add_help=False, allow_abbrev=False, **others
        )
        self.color = False  # Python 3.14 would colour headings that the formatter looks for
        self.texts = texts
        self._verbs: argparse._SubParsersAction[CommandParser] | None = None
        self.known: dict[str, Known] = {}
        self.arguments = self.add_argument_group(texts("cli.arguments"))
        self.options = self.add_argument_group(texts("cli.options"))
        self.add_argument("-h", "--help", action="help", help=texts("cli.options.help"))
        self.add_argument("--lang", choices=LANGUAGES, help=texts("cli.options.lang"))

    def add_argument(self, *names: Any, known: Known | None = None, **settings: Any) -> argparse.Action:
        """Add an option, or an argument, to its group. `known`: what Tab offers for its value, which others may be, too."""
        group = self.options if names[0].startswith("-") else self.arguments
        added = group.add_argument(*names, **settings)
        if known is not None:
            self.known[added.dest] = known
        return added

    def used_as(self, *forms: str) -> None:
        """Show these words behind its name as its usage, one form a line, in place of every option."""
        self.usage = f"\n{' ' * len(self.texts('cli.usage'))}".join(f"%(prog)s {form}" for form in forms)

    def add_verb(self, name: str) -> CommandParser:
        """Add a verb that explains itself with the text `cli.<command>.<name>`; return its parser. One must be given then."""
        texts, command = self.texts, self.prog.rpartition(" ")[2]
        if self._verbs is None:
            self._verbs = self.add_subparsers(
                title=texts("cli.verbs"),
                dest="verb",
                metavar="VERB",
                required=True,
                help=texts("cli.verb", command=command),
            )
        text = texts(f"cli.{command}.{name}")
        return self._verbs.add_parser(name, texts=texts, help=text, description=text[:1].upper() + text[1:])

    def refuse(self, option: str, problem: str) -> NoReturn:
        """End with a message about a value, as argparse does for those it finds wrong itself."""
        self.error(f"argument {option}: {problem}")

    def refuse_unknown(self, words: list[str]) -> NoReturn:
        """End with a message about words that are no arguments of this command, as argparse does."""
        self.error(f"unrecognized arguments: {' '.join(words)}")

    def error(self, message: str) -> NoReturn:
        """End with the message in the user's language, in one line on standard error, and status 2."""
        problem = said_in(message, self.texts, self.known_options())
        self.exit(2, f"{one_line(self.texts('cli.error', prog=self.prog, problem=problem))}\n")

    @property
    def actions(self) -> list[argparse.Action]:
        """All its arguments and options, in their order."""
        return self._actions

    @property
    def verbs(self) -> dict[str, CommandParser]:
        """The parsers of its verbs."""
        return {} if self._verbs is None else dict(self._verbs.choices)

    def known_options(self) -> list[str]:
        """Its options and those of its verbs."""
        known = [option for action in self._actions for option in action.option_strings]
        return known + [option for verb in self.verbs.values() for option in verb.known_options()]


_ARGUMENT = re.compile(r"argument (?P<name>\S.*?): (?P<problem>.+)", re.DOTALL)
_MESSAGES = tuple(
    (re.compile(pattern, re.DOTALL), key)
    for pattern, key in (
        (r"the following arguments are required: (?P<names>.+)", "required"),
        (r"one of the arguments (?P<names>.+) is required", "one_of"),
        (r"unrecognized arguments: (?P<words>.+)", "unrecognized"),
        (r"not allowed with argument (?P<other>.+)", "not_with"),
        (r"expected one argument", "one_value"),
        (r"expected at most one argument", "at_most_one"),
        (r"expected at least one argument", "at_least_one"),
        (r"expected (?P<count>\d+) arguments?", "count"),
        (r"ignored explicit argument (?P<value>.+)", "no_value"),
        (r"invalid choice: (?P<value>.+?)(?:, maybe you meant .+\?)? \(choose from (?P<choices>.+)\)", "choice"),
        (r"invalid .+ value: (?P<value>.+)", "kind"),
    )
)
"""What argparse says, in the words of all of Python 3.10 to 3.14, and the text `cli.error.<key>` that stands for it here."""


def said_in(message: str, texts: Wording, options: Iterable[str] = ()) -> str:
    """Say a message of argparse in the language of `texts`, with the nearest option or choice; others stay as they are."""
    if (about := _ARGUMENT.fullmatch(message)) is not None:
        name = about["name"]
        return texts("cli.error.argument", name=name, problem=said_in(about["problem"], texts))
    for pattern, key in _MESSAGES:
        if (found := pattern.fullmatch(message)) is None:
            continue
        values: dict[str, Any] = found.groupdict()
        near = None
        if key == "choice":
            choices = [each.strip("'\"") for each in values["choices"].split(", ")]
            values["choices"] = ", ".join(choices)
            near = nearest(values["value"].strip("'\""), choices)
        elif key == "unrecognized":
            wrong = next((word for word in values["words"].split(" ") if word.startswith("-")), "")
            near = nearest(wrong.partition("=")[0], options)
        problem = texts(f"cli.error.{key}", **values)
        return problem if near is None else texts("cli.error.close", problem=problem, name=near)
    return message


def nearest(word: str, known: Iterable[str], likeness: float = 0.6) -> str | None:
    """Return the name that was probably meant, None if none is as near as `likeness` (1: the same)."""
    from difflib import get_close_matches

    bare = {each.lstrip("-"): each for each in known}  # two dashes are no likeness
    return next((bare[each] for each in get_close_matches(word.lstrip("-"), list(bare), 1, likeness)), None)


def two_columns(rows: Iterable[tuple[str, str]], width: int, column: int) -> list[str]:
    """Return the lines of a list: names, and beside them from a column on what they are."""
    lines = []
    for name, text in rows:
        folded = wrap(text, width - column)
        if text_width(name) + 4 > column:
            lines.append(f"  {name}")
        else:
            lines.append(f"  {name}{' ' * (column - 2 - text_width(name))}{folded.pop(0)}")
        lines += [" " * column + each for each in folded]
    return lines


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Folds by terminal cells, of which a Chinese character takes two, under headings of the language."""

    def __init__(self, prog: str, *, texts: Wording) -> None:
        super().__init__(prog)
        self._usage = texts("cli.usage")
        self._headings: list[str] = []

    def add_usage(
        self,
        usage: str | None,
        actions: Iterable[argparse.Action],
        groups: Iterable[argparse._MutuallyExclusiveGroup],
        prefix: str | None = None,
    ) -> None:
        """Begin it with the word of the language."""
        super().add_usage(usage, actions, groups, self._usage if prefix is None else prefix)

    def _format_usage(self, *arguments: Any, **settings: Any) -> str:
        """Align what goes on in further lines by cells, where argparse counts characters."""
        excess = text_width(self._usage) - len(self._usage)
        self._width -= excess
        first, *others = super()._format_usage(*arguments, **settings).split("\n")
        self._width += excess
        return "\n".join([first, *(" " * excess + line if line else line for line in others)])

    def start_section(self, heading: str | None) -> None:
        """Begin a group."""
        self._headings.append(heading or "")
        super().start_section(heading)

    def format_help(self) -> str:
        """Put the colon of the language behind the headings, where argparse has its own."""
        text, colon = super().format_help(), self._usage.rstrip()[-1:]
        for heading in filter(None, self._headings):
            text = text.replace(f"\n{heading}:\n", f"\n{heading}{colon}\n")
        return text

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        return "\n".join(f"{indent}{line}".rstrip() for line in wrap(text, width - len(indent)))

    def _split_lines(self, text: str, width: int) -> list[str]:
        return wrap(text, width)
