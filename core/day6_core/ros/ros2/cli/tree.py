"""The command tree, read from the folders: the commands, their verbs, and the parser for one command line."""

from __future__ import annotations

import pkgutil
from collections.abc import Collection
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import has_verb, lacking_options
from day6_core.session.argument_parser import SessionParser

if TYPE_CHECKING:
    from day6_core.session.session import Session

ROOT = "day6_core.ros.ros2"
_FOLDER = Path(__file__).resolve().parents[1]

HIDDEN = frozenset({"extension_points", "extensions"})
"""Commands that the real help does not list either."""


def command_names() -> list[str]:
    """Return all commands, sorted."""
    present = {module.name for module in pkgutil.iter_modules([str(_FOLDER)]) if module.name != "cli"}
    return sorted(present)


def verb_names(command: str) -> list[str]:
    """Return the verbs of a command, sorted; empty for a command without verbs."""
    folder = _FOLDER / command
    modules = pkgutil.iter_modules([str(folder)]) if folder.is_dir() else ()
    names = sorted(module.name for module in modules if not module.name.startswith("_"))
    return [name for name in names if has_verb(f"{command} {name}")]


def load(command: str, verb: str | None = None) -> ModuleType:
    """Import the module of a command or of one of its verbs."""
    return import_module(".".join(part for part in (ROOT, command, verb) if part))


def summary(command: str, verb: str | None = None) -> str:
    """Return the one line that help shows for a command or verb."""
    return str(load(command, verb).SUMMARY)


def chosen_words(argv: list[str]) -> tuple[str | None, str | None]:
    """Return the command and the verb of a command line (without `ros2`), None where one is missing.

    No option before them takes a value, so they are the first two words that are not options.
    """
    words = [word for word in argv if not word.startswith("-")]
    return (words[0] if words else None), (words[1] if len(words) > 1 else None)


def build_parser(session: Session, argv: list[str]) -> SessionParser:
    """Return the parser for `ros2 ARGV…`. Only the modules of the chosen command and verb are imported.

    The parsed namespace has `run`, the verb's `main`, or `help_of`, the parser whose help is printed for a command line
    that stops before a verb.
    """
    command, verb = chosen_words(argv)
    root = SessionParser(session, prog="ros2", description="ros2 is an extensible command-line tool for ROS 2.")
    root.add_argument(
        "--use-python-default-buffering",
        action="store_true",
        help="Do not force line buffering in stdout and instead use the python default buffering, which might be affected "
        "by PYTHONUNBUFFERED/-u and depends on whatever stdout is interactive or not",
    )
    root.set_defaults(help_of=root)
    names = command_names()
    listed = "" if command in names else _listing({name: summary(name) for name in names if name not in HIDDEN})
    choices = root.add_commands("ros2", listed)
    for name in names:
        if name == command:
            _complete_command(choices.add_parser(name), name, verb)
        else:
            choices.choices[name] = None  # a word that is known: no line gets to its parser
    return root


def _complete_command(parser: SessionParser, command: str, verb: str | None) -> None:
    parser.description = summary(command)
    parser.set_defaults(help_of=parser)
    module: Any = load(command)
    if hasattr(module, "add_arguments"):
        module.add_arguments(parser)
        _remove(parser, lacking_options(command))
    if hasattr(module, "main"):
        parser.set_defaults(run=module.main)
    verbs = verb_names(command)
    if not verbs:
        return
    listed = "" if verb in verbs else _listing({name: summary(command, name) for name in verbs})
    choices = parser.add_commands(f"ros2 {command}", listed)
    for name in verbs:
        if name != verb:
            choices.choices[name] = None
        else:
            verb_parser = choices.add_parser(name)
            verb_module: Any = load(command, name)
            verb_parser.description = verb_module.SUMMARY
            verb_module.add_arguments(verb_parser)
            _remove(verb_parser, lacking_options(f"{command} {name}"))
            verb_parser.set_defaults(run=verb_module.main)


def _remove(parser: SessionParser, options: Collection[str]) -> None:
    """Take options of other distributions away; the verb finds their defaults."""
    for action in [each for each in parser._actions if not {*options}.isdisjoint(each.option_strings)]:
        parser.set_defaults(**{action.dest: action.default})
        parser._remove_action(action)
        for group in (*parser._action_groups, *parser._mutually_exclusive_groups):
            if action in group._group_actions:
                group._group_actions.remove(action)
        for option in action.option_strings:
            del parser._option_string_actions[option]


def _listing(summaries: dict[str, str]) -> str:
    width = max(map(len, summaries))
    return "".join(f"{name.ljust(width)}  {text}\n" for name, text in sorted(summaries.items()))
