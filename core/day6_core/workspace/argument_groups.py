"""The groups of options that several verbs of `colcon` share, in the words of its help."""

from __future__ import annotations

import argparse
import os

from day6_core.workspace.handlers import HANDLERS

_SELECTION: tuple[tuple[str, str | None, str], ...] = (
    ("--packages-up-to", "PKG_NAME", "Only process a subset of packages and their recursive dependencies"),
    (
        "--packages-up-to-regex",
        "PATTERN",
        "Only process a subset of packages and their recursive dependencies, where any of the patterns match the package name",
    ),
    ("--packages-above", "PKG_NAME", "Only process a subset of packages and packages which recursively depend on them"),
    (
        "--packages-above-and-dependencies",
        "PKG_NAME",
        "Only process a subset of packages and packages which recursively depend on them "  # noqa: ISC004
        "including all their recursive dependencies",
    ),
    (
        "--packages-above-depth",
        None,
        "Only process a subset of packages and packages which recursively depend on them up to a given depth",
    ),
    ("--packages-select-by-dep", "PKG_NAME", "Only process packages which (recursively) depend on this"),
    ("--packages-skip-by-dep", "PKG_NAME", "Skip packages which (recursively) depend on this"),
    ("--packages-skip-up-to", "PKG_NAME", "Skip a subset of packages and their recursive dependencies"),
)
_BY_RESULT = (
    (
        "--packages-select-build-failed",
        "Only process a subset of packages which have failed to build previously (aborted packages are not considered errors)",
    ),
    ("--packages-skip-build-finished", "Skip a set of packages which have finished to build previously"),
    ("--packages-select-test-failures", "Only process a subset of packages which had test failures previously"),
    ("--packages-skip-test-passed", "Skip a set of packages which had no test failures previously"),
)
_BY_NAME = (
    ("--packages-select", "PKG_NAME", "Only process a subset of packages"),
    ("--packages-skip", "PKG_NAME", "Skip a set of packages"),
    (
        "--packages-select-regex",
        "PATTERN",
        "Only process a subset of packages where any of the patterns match the package name",
    ),
    ("--packages-skip-regex", "PATTERN", "Skip a set of packages where any of the patterns match the package name"),
)


def add_executor(parser: argparse.ArgumentParser) -> None:
    """Add the options for how many packages are processed at a time."""
    group = parser.add_argument_group("Executor arguments")
    group.add_argument(
        "--executor",
        choices=("parallel", "sequential"),
        help="The executor to process all packages (default: parallel)\n"
        "* parallel: Process multiple packages in parallel\n* sequential: Process one package at a time",
    )
    workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 4
    group.add_argument(
        "--parallel-workers",
        type=_counting_number,
        default=workers,
        metavar="NUMBER",
        help=f"The maximum number of packages to process in parallel, or '0' for no limit (default: {workers})",
    )


def _counting_number(text: str) -> int:
    number = int(text)
    if number < 0:
        raise ValueError
    return number


_counting_number.__name__ = "counting_number"  # argparse prints it: invalid counting_number value


def add_event_handlers(parser: argparse.ArgumentParser) -> None:
    """Add the option for what is reported while packages are processed."""
    group = parser.add_argument_group("Event handler arguments")
    defaults = " ".join(f"{name}{'+' if each.enabled else '-'}" for name, each in HANDLERS.items())
    group.add_argument(
        "--event-handlers",
        nargs="*",
        metavar=("name1+", "name2-"),
        choices=[
            *(f"{name}{'-' if each.enabled else '+'}" for name, each in HANDLERS.items()),
            *(f"{name}{'+' if each.enabled else '-'}" for name, each in HANDLERS.items()),
        ],
        help=f"Enable (+) or disable (-) event handlers (default: {defaults})\n"
        + "\n".join(f"* {name}: {each.summary}" for name, each in HANDLERS.items()),
    )


def add_discovery(parser: argparse.ArgumentParser) -> None:
    """Add the options for where packages are searched for."""
    group = parser.add_argument_group("Discovery arguments")
    group.add_argument(
        "--ignore-user-meta",
        action="store_true",
        help="Ignore `*.meta` files in the user config directory `~/.colcon/metadata`",
    )
    group.add_argument(
        "--metas",
        nargs="*",
        metavar="PATH",
        default=["./colcon.meta"],
        help="The directories containing a `colcon.meta` file or paths to arbitrary files containing the same meta "
        "information (default: ./colcon.meta)",
    )
    group.add_argument(
        "--base-paths",
        nargs="*",
        metavar="PATH",
        help="The base paths to recursively crawl for packages (default: .)",
    )
    group.add_argument(
        "--packages-ignore", nargs="*", metavar="PKG_NAME", help="Ignore packages as if they were not discovered"
    )
    group.add_argument(
        "--packages-ignore-regex",
        nargs="*",
        metavar="PATTERN",
        help="Ignore packages where any of the patterns match the package name",
    )
    group.add_argument(
        "--paths",
        nargs="*",
        metavar="PATH",
        help="The paths to check for a package. Use shell wildcards (e.g. `src/*`) to select all direct subdirectories",
    )


def add_selection(parser: argparse.ArgumentParser) -> None:
    """Add the options for which of the packages found are processed."""
    group = parser.add_argument_group("Package selection arguments")
    for option, metavar, text in _SELECTION:
        if metavar is None:
            group.add_argument(option, nargs="+", metavar=("DEPTH", "PKG_NAME"), help=text)
        else:
            group.add_argument(option, nargs="*", metavar=metavar, help=text)
    exclusive = group.add_mutually_exclusive_group()
    for option, text in _BY_RESULT:
        exclusive.add_argument(option, action="store_true", help=text)
    for option, metavar, text in _BY_NAME:
        group.add_argument(option, nargs="*", metavar=metavar, help=text)
    for option, word in (("--packages-start", "before"), ("--packages-end", "after")):
        group.add_argument(option, metavar="PKG_NAME", help=f"Skip packages {word} this in flat topological ordering")


def add_build_base(parser: argparse.ArgumentParser) -> None:
    """Add the option for where the build directories are."""
    parser.add_argument(
        "--build-base", default="build", help="The base path for all build directories (default: build)"
    )


def add_cmake(parser: argparse.ArgumentParser) -> None:
    """Add the options that are passed to CMake."""
    group = parser.add_argument_group("Arguments for 'cmake' packages")
    group.add_argument(
        "--cmake-args",
        nargs="*",
        metavar="*",
        type=str.lstrip,
        help="Pass arguments to CMake projects. Arguments matching other options must be prefixed by a space,\n"
        'e.g. --cmake-args " --help" (stdout might not be shown by default, e.g. add `--event-handlers console_cohesion+`)',
    )
    group.add_argument("--cmake-target", help="Build a specific target instead of the default target")
    for name, text in (
        ("target-skip-unavailable", "Skip building packages which don't have the target passed to --cmake-target"),
        ("clean-cache", "Remove CMake cache before the build (implicitly forcing CMake configure step)"),
        ("clean-first", "Build target 'clean' first, then build (to only clean use '--cmake-target clean')"),
        ("force-configure", "Force CMake configure step"),
    ):
        group.add_argument(f"--cmake-{name}", action="store_true", help=text)
    for kind in ("ament", "catkin"):
        group = parser.add_argument_group(f"Arguments for 'ros.{kind if kind == 'catkin' else 'ament_cmake'}' packages")
        group.add_argument(
            f"--{kind}-cmake-args",
            nargs="*",
            metavar="*",
            type=str.lstrip,
            help=f"Pass arguments to '{kind if kind == 'catkin' else 'ament_cmake'}' packages. Arguments matching other "
            "options must be prefixed by a space",
        )
    group.add_argument(
        "--catkin-skip-building-tests",
        action="store_true",
        help="By default the 'tests' target of 'catkin' packages is invoked. If running 'colcon test' later isn't intended "
        "this can be skipped",
    )
