"""Selects the packages to process: `--packages-select`, `--packages-up-to` and similar options."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from day6_core.user_pattern import user_pattern
from day6_core.workspace.order import Planned
from day6_core.workspace.packages import Package

LOGGER = "colcon.colcon_core.package_selection"


class SelectionError(Exception):
    """A package that must exist does not; the text is colcon's."""


def without_ignored(packages: Iterable[Package], args: Namespace) -> list[Package]:
    """Return the packages without those matched by `--packages-ignore` and `--packages-ignore-regex`."""
    names = set(args.packages_ignore or ())
    patterns = args.packages_ignore_regex or ()
    return [
        package
        for package in packages
        if package.name not in names and not any(user_pattern(pattern).match(package.name) for pattern in patterns)
    ]


def select(planned: list[Planned], args: Namespace, build_base: Path, warn: Callable[[str, str], None]) -> None:
    """Set `selected` of every package by the options.

    Raises:
        SelectionError: a package named by an option does not exist.
    """
    names = {each.package.name for each in planned}
    for option in (
        "packages_select",
        "packages_skip",
        "packages_select_by_dep",
        "packages_skip_by_dep",
        "allow_overriding",
    ):
        for name in getattr(args, option) or ():
            if name not in names:
                warn(LOGGER, f"ignoring unknown package '{name}' in --{option.replace('_', '-')}")
    _select_by_dependencies(planned, args)
    _select_by_result(planned, args, build_base)
    _keep(planned, args.packages_select, lambda each, wanted: each.package.name in wanted)
    _keep(planned, args.packages_select_regex, _matches)
    _drop(planned, args.packages_skip, lambda each, skipped: each.package.name in skipped)
    _drop(planned, args.packages_skip_regex, _matches)
    _select_range(planned, args)


Test = Callable[[Planned, list[str]], bool]


def _matches(each: Planned, patterns: list[str]) -> bool:
    return any(user_pattern(pattern).match(each.package.name) for pattern in patterns)


def _keep(planned: list[Planned], values: list[str] | None, test: Test) -> None:
    if values is not None:
        for each in planned:
            each.selected = each.selected and test(each, values)


def _drop(planned: list[Planned], values: list[str] | None, test: Test) -> None:
    if values is not None:
        for each in planned:
            each.selected = each.selected and not test(each, values)


def _known(planned: list[Planned], values: list[str], option: str) -> None:
    names = {each.package.name for each in planned}
    for name in values:
        if name not in names:
            raise SelectionError(f"Package '{name}' specified with --packages-{option} was not found")


def _select_by_dependencies(planned: list[Planned], args: Namespace) -> None:
    needs = {each.package.name: set(each.needs) for each in planned}
    if args.packages_up_to is not None:
        _known(planned, args.packages_up_to, "up-to")
        wanted = set(args.packages_up_to).union(*(needs[name] for name in args.packages_up_to))
        _keep(planned, sorted(wanted), lambda each, names: each.package.name in names)
    if args.packages_up_to_regex is not None:
        roots = [each.package.name for each in planned if _matches(each, args.packages_up_to_regex)]
        wanted = set(roots).union(*(needs[name] for name in roots))
        _keep(planned, sorted(wanted), lambda each, names: each.package.name in names)
    if args.packages_above is not None:
        _known(planned, args.packages_above, "above")
        _keep(
            planned,
            args.packages_above,
            lambda each, names: each.package.name in names or bool(needs[each.package.name] & {*names}),
        )
    if args.packages_above_and_dependencies is not None:
        _known(planned, args.packages_above_and_dependencies, "above-and-dependencies")
        roots = [
            name
            for name in needs
            if name in args.packages_above_and_dependencies or needs[name] & {*args.packages_above_and_dependencies}
        ]
        wanted = set(roots).union(*(needs[name] for name in roots))
        _keep(planned, sorted(wanted), lambda each, names: each.package.name in names)
    if args.packages_above_depth:
        depth, *roots = args.packages_above_depth
        _known(planned, roots, "above-depth")
        _keep(planned, sorted(_above(planned, roots, depth)), lambda each, names: each.package.name in names)
    _keep(planned, args.packages_select_by_dep, lambda each, names: bool(needs[each.package.name] & {*names}))
    _drop(planned, args.packages_skip_by_dep, lambda each, names: bool(needs[each.package.name] & {*names}))
    if args.packages_skip_up_to is not None:
        _known(planned, args.packages_skip_up_to, "skip-up-to")
        skipped = set(args.packages_skip_up_to).union(*(needs[name] for name in args.packages_skip_up_to))
        _drop(planned, sorted(skipped), lambda each, names: each.package.name in names)


def _above(planned: list[Planned], roots: list[str], depth: str) -> set[str]:
    if not depth.isdigit():
        raise SelectionError("the first argument of --packages-above-depth must be a non-negative number")
    found = set(roots)
    for _ in range(int(depth)):
        found |= {each.package.name for each in planned if each.package.dependencies() & found}
    return found


def _select_by_result(planned: list[Planned], args: Namespace, build_base: Path) -> None:
    def result(each: Planned, verb: str) -> str | None:
        try:
            return (build_base / each.package.name / f"colcon_{verb}.rc").read_text(encoding="utf-8").strip()
        except OSError:
            return None

    tests: Mapping[str, Callable[[Planned], bool]] = {
        "packages_select_build_failed": lambda each: result(each, "build") not in (None, "0", "SIGINT"),
        "packages_skip_build_finished": lambda each: result(each, "build") != "0",
        "packages_select_test_failures": lambda each: result(each, "test") not in (None, "0", "SIGINT"),
        "packages_skip_test_passed": lambda each: result(each, "test") != "0",
    }
    for option, test in tests.items():
        if getattr(args, option):
            for each in planned:
                each.selected = each.selected and test(each)


def _select_range(planned: list[Planned], args: Namespace) -> None:
    names = [each.package.name for each in planned]
    for name, option in ((args.packages_start, "start"), (args.packages_end, "end")):
        if name is None:
            continue
        if name not in names:
            raise SelectionError(f"Package '{name}' specified with --packages-{option} was not found")
        at = names.index(name)
        for each in planned[:at] if option == "start" else planned[at + 1 :]:
            each.selected = False
