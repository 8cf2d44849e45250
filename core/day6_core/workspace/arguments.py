"""The command lines of `colcon`: verbs and options as in colcon-core 0.21 and the extensions that ROS installs."""

from __future__ import annotations

import argparse
import functools
from argparse import Namespace
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from day6_core.session.argument_parser import HelpFormatter, SessionParser, terminal_width
from day6_core.workspace.defaults import default_values
from day6_core.workspace.events import LOG_LEVELS
from day6_core.workspace.option import Group, Treated
from day6_core.workspace.options import BEFORE_VERB, OPTIONS, options_of

if TYPE_CHECKING:
    from day6_core.session.session import Session

VERBS = {
    "build": "Build a set of packages",
    "extension-points": "List extension points",
    "extensions": "List extensions",
    "graph": "Generate a visual representation of the dependency graph",
    "info": "Package information",
    "list": "List packages, optionally in topological ordering",
    "metadata": "Manage metadata of packages",
    "test": "Test a set of packages",
    "test-result": "Show the test results generated when testing a set of packages",
    "version-check": "Compare local package versions with PyPI",
}

_ENVIRONMENT = """\
Environment variables:
  COLCON_DEFAULT_EXECUTOR
                        Select the default executor extension
  COLCON_LOG_PATH       The base path for all log directories

For more help and usage tips, see https://colcon.readthedocs.io"""


class _Formatter(HelpFormatter):
    """Keeps the lines that begin with `* ` in a help text."""

    def _split_lines(self, text: str, width: int) -> list[str]:
        return [line for part in text.split("\n") for line in super(_Formatter, self)._split_lines(part, width)]


class ColconParser(SessionParser):
    """A parser with colcon's help format; the parser of `colcon` itself reports unknown options.

    Words after an option such as `--cmake-args` belong to it even if they begin with a dash, except the verb's own options.
    """

    def __init__(self, session: Session, **keywords: Any) -> None:
        formatter = functools.partial(_Formatter, width=terminal_width(session) - 2)
        super().__init__(session, **{"formatter_class": formatter, **keywords})

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """See argparse."""
        return super().parse_known_args(None if args is None else self._with_passed_on(args), namespace)

    def _with_passed_on(self, args: Sequence[str]) -> list[str]:
        """Put a space before passed-on words that look like options; the option's type strips it again."""
        found: list[str] = []
        passing_on = False
        for word in args:
            option = self._option_string_actions.get(word.partition("=")[0])
            if option is not None:
                passing_on = option.type is str.lstrip
            elif passing_on and word.startswith("-") and word != "--":
                word = f" {word}"
            found.append(word)
        return found


def build_parser(session: Session) -> ColconParser:
    """Return the parser of `colcon`; the namespace has `verb_name`, None if no verb was given."""
    root = ColconParser(session, prog="colcon", epilog=_ENVIRONMENT)
    _add(root, BEFORE_VERB)
    options: dict[str, Any] = {"parser_class": functools.partial(ColconParser, session)}
    verbs = root.add_subparsers(
        title="colcon verbs",
        description="\n".join(_rows(VERBS)),
        dest="verb_name",
        help="call `colcon VERB -h` for specific help",
        **options,
    )
    verbs.choices = verbs._name_parser_map
    for name, summary in VERBS.items():
        parser = verbs.add_parser(name, description=f"{summary}.")
        for group in OPTIONS.get(name, ()):
            _add(parser, group)
    return root


def _rows(texts: dict[str, str]) -> list[str]:
    import textwrap

    lines = []
    for name, text in texts.items():
        first, *rest = textwrap.wrap(text, 56)
        lines += [f"{name:<22}{first}", *(" " * 22 + line for line in rest)]
    return lines


def _add(parser: argparse.ArgumentParser, group: Group) -> None:
    """Add the options of a group; those of which only one may be given stand together."""
    where: Any = parser.add_argument_group(group.title) if group.title else parser
    apart: dict[str, Any] = {}
    for option in group.options:
        if option.apart and option.apart not in apart:
            apart[option.apart] = where.add_mutually_exclusive_group()
        apart.get(option.apart, where).add_argument(*option.names.split(), help=option.help, **option.keywords)


def parse(session: Session, words: list[str]) -> Namespace:
    """Parse the words after `colcon`. In the result `remarks` are what is to be said of them.

    Raises:
        ParserExit: after an error, or after `--help`.
    """
    parser = build_parser(session)
    before = dict(zip(words[1:], words, strict=False))
    verb_name = next((word for word in words if word in VERBS and not before.get(word, "").startswith("--log-")), "")
    if verb_name:
        found = default_values(verb_name, session.cwd, session.env, session.stderr.write)
        _verb_parser(parser, verb_name).set_defaults(**found)
    # Options with several values also accept values that begin with a dash where the real colcon does.
    args: Namespace
    args, unknown = parser.parse_known_args(words)
    if unknown:
        for option in ("--packages-select", "--packages-skip", "--packages-up-to", "--base-paths", "--paths"):
            at = words.index(unknown[0])
            if option in words[:at] and not any(word.startswith("--") for word in words[words.index(option) + 1 : at]):
                session.stderr.write(_verb_parser(parser, args.verb_name).format_usage())
                prog = f"colcon {args.verb_name}"
                parser.exit(2, f"{prog}: error: argument {option}: unrecognized argument: {unknown[0]}\n")
        parser.error(f"unrecognized arguments: {' '.join(unknown)}")
    args.log_level = args.log_level or session.env.get("COLCON_LOG_LEVEL") or "warning"
    if args.log_level.upper() not in LOG_LEVELS and not args.log_level.isdigit():
        names = ", ".join(LOG_LEVELS)
        parser.error(f"--log-level has unsupported value, valid names are: {names} (case-insensitive)")
    args.remarks = []
    for each in (*BEFORE_VERB.options, *options_of(args.verb_name)):
        if not each.has_effect(getattr(args, each.destination)):
            if each.treated is Treated.REFUSED:
                session.stderr.write(_verb_parser(parser, args.verb_name).format_usage())
                parser.exit(
                    2, f"colcon {args.verb_name}: error: argument {each.name}: not possible here: {each.why[0]}\n"
                )
            args.remarks.append(f"{each.name} has no effect here: {each.why[0]}")
    return args


def _verb_parser(parser: ColconParser, verb: str) -> argparse.ArgumentParser:
    verbs = next(action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
    found: argparse.ArgumentParser = verbs.choices[verb]
    return found
