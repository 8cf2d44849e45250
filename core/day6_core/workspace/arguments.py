"""The command lines of `colcon`: verbs and options as in colcon-core 0.21 and the extensions that ROS installs."""

from __future__ import annotations

import argparse
import functools
from argparse import Namespace
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from day6_core.session.argument_parser import HelpFormatter, SessionParser, terminal_width
from day6_core.workspace.argument_groups import (
    add_build_base,
    add_cmake,
    add_discovery,
    add_event_handlers,
    add_executor,
    add_selection,
)

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
    root.add_argument(
        "--log-base", help="The base path for all log directories (default: `./log`, to disable: `/dev/null`)"
    )
    root.add_argument(
        "--log-level",
        help="Set log level for the console output, either by numeric or string value (default: `warning`)",
    )
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
        _ARGUMENTS.get(name, lambda each: None)(parser)
    return root


def _rows(texts: dict[str, str]) -> list[str]:
    import textwrap

    lines = []
    for name, text in texts.items():
        first, *rest = textwrap.wrap(text, 56)
        lines += [f"{name:<22}{first}", *(" " * 22 + line for line in rest)]
    return lines


def _add_build(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--build-base", default="build", help="The base path for all build directories (default: build)")
    add("--install-base", default="install", help="The base path for all install prefixes (default: install)")
    add("--merge-install", action="store_true", help="Merge all install prefixes into a single location")
    add("--symlink-install", action="store_true", help="Use symlinks instead of copying files where possible")
    add("--test-result-base", help="The base path for all test results (default: same as `--build-base`)")
    add(
        "--continue-on-error",
        action="store_true",
        help="Continue other packages when a package fails to build (packages recursively depending on the failed package "
        "are skipped)",
    )
    add_executor(parser)
    add_event_handlers(parser)
    add_discovery(parser)
    add_selection(parser)
    parser.add_argument(
        "--allow-overriding",
        action="extend",
        default=[],
        metavar="PKG_NAME",
        nargs="+",
        help="Allow building packages that exist in underlay workspaces",
    )
    add_cmake(parser)


def _add_test(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--build-base", default="build", help="The base path for all build directories (default: build)")
    add("--install-base", default="install", help="The base path for all install prefixes (default: install)")
    add("--merge-install", action="store_true", help="Merge all install prefixes into a single location")
    add("--test-result-base", help="The base path for all test results (default: same as `--build-base`)")
    again = parser.add_mutually_exclusive_group()
    again.add_argument(
        "--retest-until-fail", type=int, default=0, metavar="N", help="Rerun tests up to N times if they pass"
    )
    again.add_argument(
        "--retest-until-pass", type=int, default=0, metavar="N", help="Rerun failing tests up to N times"
    )
    add(
        "--abort-on-error",
        action="store_true",
        help="Abort after the first package with any errors (failing tests are not considered errors in this context)",
    )
    add(
        "--return-code-on-test-failure",
        action="store_true",
        help="Use a non-zero return code to indicate any test failure",
    )
    add_executor(parser)
    add_event_handlers(parser)
    add_discovery(parser)
    add_selection(parser)
    group = parser.add_argument_group("Arguments for 'cmake' packages")
    group.add_argument(
        "--ctest-args",
        nargs="*",
        metavar="*",
        type=str.lstrip,
        help="Pass arguments to CTest projects. Arguments matching other options must be prefixed by a space,\n"
        'e.g. --ctest-args " --help" (stdout might not be shown by default, e.g. add `--event-handlers console_cohesion+`)',
    )
    group = parser.add_argument_group("Arguments for 'python' packages")
    group.add_argument(
        "--python-testing", choices=("pytest", "setuppy_test"), help="The Python testing framework to use"
    )
    group.add_argument(
        "--pytest-args",
        nargs="*",
        metavar="*",
        type=str.lstrip,
        help="Pass arguments to pytests. Arguments matching other options must be prefixed by a space",
    )
    group.add_argument("--pytest-with-coverage", action="store_true", help="Generate coverage information")
    group.add_argument("--unittest-args", nargs="*", metavar="*", type=str.lstrip, help="Pass arguments to unittest")


_OBSOLETE = {
    "topological-graph": "",
    "topological-graph-dot": " --dot",
    "topological-graph-density": " --density",
    "topological-graph-legend": " --legend",
    "topological-graph-dot-cluster": " --dot --dot-cluster",
    "topological-graph-dot-include-skipped": " --dot --dot-include-skipped",
}


def _add_list(parser: argparse.ArgumentParser) -> None:
    add_build_base(parser)
    add_discovery(parser)
    add_selection(parser)
    parser.add_argument(
        "--topological-order",
        "-t",
        action="store_true",
        help="Order output based on topological ordering (breadth-first)",
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "--names-only", "-n", action="store_true", help="Output only the name of each package but not the path"
    )
    group.add_argument(
        "--paths-only", "-p", action="store_true", help="Output only the path of each package but not the name"
    )
    obsolete = parser.add_argument_group("Obsolete arguments")
    for name, new in _OBSOLETE.items():
        short = ["-g"] if name == "topological-graph" else []
        obsolete.add_argument(f"--{name}", *short, action="store_true", help=f"Instead use `colcon graph{new}`")


def _add_info(parser: argparse.ArgumentParser) -> None:
    add_build_base(parser)
    add_discovery(parser)
    parser.add_argument(
        "package_names", nargs="*", metavar="PKG_NAME", help="Only show the information of a subset of packages"
    )
    add_selection(parser)


def _add_graph(parser: argparse.ArgumentParser) -> None:
    add_build_base(parser)
    add_discovery(parser)
    add_selection(parser)
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "--dot",
        action="store_true",
        help="Output topological graph in DOT (e.g. pass the output to dot: ` | dot -Tpng -o graph.png`), legend: blue=build, "
        "red=run, tan=test, dashed=indirect",
    )
    group.add_argument("--density", action="store_true", help="Output density of the graph (only without --dot)")
    parser.add_argument("--legend", action="store_true", help="Output legend for the graph")
    parser.add_argument(
        "--dot-cluster", action="store_true", help="Cluster packages by their filesystem path (only affects --dot)"
    )
    parser.add_argument(
        "--dot-include-skipped", action="store_true", help="Also output skipped packages (only affects --dot)"
    )


def _add_test_result(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--test-result-base", default="build", help="The base path for all test results (default: build)"
    )
    parser.add_argument(
        "--all", action="store_true", help="Show all test result files (even without errors / failures)"
    )
    parser.add_argument("--result-files-only", action="store_true", help="Print only the paths of the result files")
    parser.add_argument("--verbose", action="store_true", help="Show additional information for errors / failures")
    parser.add_argument(
        "--delete", action="store_true", help="Delete all result files. An interactive prompt will ask for confirmation"
    )
    parser.add_argument(
        "--delete-yes", action="store_true", help="Same as --delete without an interactive confirmation"
    )


_ARGUMENTS = {
    "build": _add_build,
    "test": _add_test,
    "list": _add_list,
    "info": _add_info,
    "graph": _add_graph,
    "test-result": _add_test_result,
}


def parse(session: Session, words: list[str]) -> Namespace:
    """Parse the words after `colcon`.

    Raises:
        ParserExit: after an error, or after `--help`.
    """
    parser = build_parser(session)
    # Options with several values also accept values that begin with a dash where the real colcon does.
    args: Namespace
    args, unknown = parser.parse_known_args(words)
    if unknown:
        for option in ("--packages-select", "--packages-skip", "--packages-up-to", "--base-paths", "--paths"):
            at = words.index(unknown[0])
            if option in words[:at] and not any(word.startswith("--") for word in words[words.index(option) + 1 : at]):
                prog = f"colcon {args.verb_name}"
                verb = next(action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
                session.stderr.write(verb.choices[args.verb_name].format_usage())
                parser.exit(2, f"{prog}: error: argument {option}: unrecognized argument: {unknown[0]}\n")
        parser.error(f"unrecognized arguments: {' '.join(unknown)}")
    return args
