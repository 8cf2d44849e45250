"""The table of environment variables: every one that the sources read has a row, and every row has a reader."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from functools import cache

import pytest

from day6_core.language import said
from day6_core.variables import GROUPS, VARIABLES, shown_value
from tests.support.source_files import PACKAGES, nodes, trees

NAME = re.compile(r"[A-Z][A-Z0-9_]+")
OURS = re.compile(r"DAY6_(?!TESTS_)[A-Z0-9_]*[A-Z0-9]")
SURROUNDINGS = re.compile(r"environ|\benv\b|_env\b|variables|getenv", re.IGNORECASE)
"""What mappings of environment variables are called."""

OF_LANGUAGES = {
    "bash's own, in the simulated shell": {
        "BASH_REMATCH",
        "CDPATH",
        "FUNCNEST",
        "IFS",
        "OLDPWD",
        "OPTARG",
        "OPTERR",
        "OPTIND",
        "PIPESTATUS",
        "PS1",
        "PS2",
        "PS3",
        "PS4",
        "PWD",
        "TZ",
        "REPLY",
        "SHLVL",
    },
    "CMake's, in a CMakeLists.txt": {
        "CMAKE_CURRENT_LIST_DIR",
        "CMAKE_CURRENT_SOURCE_DIR",
        "CMAKE_MODULE_PATH",
        "PROJECT_SOURCE_DIR",
        "UNPARSED_ARGUMENTS",
    },
}
"""Variables of the languages that are interpreted here, whose tables are called `variables`, too."""


def read_in(modules: Iterable[ast.Module]) -> set[str]:
    """The names of the environment variables that modules read, by whatever constant or loop they are named."""
    constants: dict[tuple[int, str], set[str]] = defaultdict(set)
    asked: list[tuple[int, ast.expr]] = []
    found: set[str] = set()
    for number, tree in enumerate(modules):
        for node in nodes(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and OURS.fullmatch(node.value):
                found.add(node.value)
            for name, values in _named(node):
                constants[0 if name.isupper() else -1 - number, name] |= values  # one in small letters is of its module
            asked += [(number, key) for mapping, key in _look_ups(node) if SURROUNDINGS.search(ast.unparse(mapping))]
    for number, key in asked:
        if isinstance(key, ast.Constant):
            found |= {str(key.value)}
        elif isinstance(key, (ast.Name, ast.Attribute)):
            name = key.id if isinstance(key, ast.Name) else key.attr
            found |= constants[0 if name.isupper() else -1 - number, name]
    return {name for name in found if isinstance(name, str) and NAME.fullmatch(name)}


def _named(node: ast.AST) -> Iterator[tuple[str, set[str]]]:
    """The names that a node gives to strings: a constant, the variable of a loop over some."""
    if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
        yield from ((each.id, {node.value.value}) for each in node.targets if isinstance(each, ast.Name))
    elif isinstance(node, (ast.For, ast.comprehension)) and isinstance(node.target, ast.Name):
        several = node.iter.elts if isinstance(node.iter, (ast.Tuple, ast.List)) else []
        yield (
            node.target.id,
            {each.value for each in several if isinstance(each, ast.Constant) and each.value is not None},
        )


def _look_ups(node: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """The mapping and the key of `m.get(k)`, `m[k]` and `k in m`."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.args:
        if node.func.attr in ("get", "pop", "setdefault", "getenv"):
            yield node.func.value if node.func.attr != "getenv" else node.func, node.args[0]
    elif isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Load):
        yield node.value, node.slice
    elif isinstance(node, ast.Compare) and isinstance(node.ops[0], (ast.In, ast.NotIn)):
        yield node.comparators[0], node.left


@cache
def read_here() -> frozenset[str]:
    words = ("environ", "env", "variables", "DAY6_", '= "')
    modules = (tree for path, tree in trees(*PACKAGES, "hub", words=words) if path.name != "variables.py")
    return frozenset(read_in(modules)) - set().union(*OF_LANGUAGES.values())


def test_every_variable_that_is_read_has_a_row_and_every_row_a_reader() -> None:
    assert set(read_here()) == {each.name for each in VARIABLES}


@pytest.mark.parametrize(
    "source",
    [
        'os.environ.get("NEW_ONE")',
        'os.environ["NEW_ONE"]',
        '"NEW_ONE" in environ',
        'os.getenv("NEW_ONE")',
        'VARIABLE = "NEW_ONE"\nsession.env.get(VARIABLE)',
        'VARIABLE = "NEW_ONE"\nself._environment[module.VARIABLE]',
        'for name in ("NEW_ONE", "x"):\n    environ.get(name)',
        'next(environ[each] for each in ["NEW_ONE"])',
    ],
)
def test_a_new_variable_is_noticed_however_it_is_read(source: str) -> None:
    assert read_in([ast.parse(source)]) == {"NEW_ONE"}


def test_ours_are_noticed_wherever_they_are_named() -> None:
    assert read_in([ast.parse('x = ["DAY6_NEW", "DAY6_", "DAY6_TESTS_ODD"]\nnames["OTHER"]')]) == {"DAY6_NEW"}


def test_every_row_is_in_a_group_once_and_is_said_in_both_languages() -> None:
    names = [each.name for each in VARIABLES]
    assert sorted(set(names)) == sorted(names)
    assert {each.group for each in VARIABLES} == set(GROUPS)
    assert [each.group for each in VARIABLES] == sorted((each.group for each in VARIABLES), key=list(GROUPS).index)
    for each in VARIABLES:
        assert all(each.text) and bool(each.default[0]) == bool(each.default[1]), each.name
        assert said(each.text, "zh") != said(each.text, "en"), each.name
        assert each.text[0].count("`") % 2 == each.text[1].count("`") % 2 == 0, each.name
        assert not each.name.startswith("DAY6_HUB_") or each.group == "hub"


def test_values_that_nobody_else_may_read_are_hidden() -> None:
    assert shown_value("DAY6_HUB_WORD", "chalk and sponge") == "***"
    assert shown_value("DAY6_MY_SECRET", "x") == "***"
    assert shown_value("DAY6_LANG", "zh") == "zh"
    assert shown_value("DAY6_HUB_WORD", "") == ""
