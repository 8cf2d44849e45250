"""No text of the catalogues is left over: for every key there is a place in the code that names it or puts it together."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator

from day6_tui.locale import catalogue
from tests.support.source_files import nodes, trees

KEY = re.compile(r"[a-z_]+(\.[\w-]+)+")


def keys_in(tree: ast.AST) -> Iterator[str]:
    """Yield patterns of what the strings of a module match: themselves, and f-strings with anything in their braces."""
    for node in nodes(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and KEY.fullmatch(node.value):
            yield re.escape(node.value)
        elif isinstance(node, ast.JoinedStr):
            parts = [re.escape(part.value) if isinstance(part, ast.Constant) else r"[\w.-]+" for part in node.values]
            fixed = "".join(part.value for part in node.values if isinstance(part, ast.Constant))
            if re.fullmatch(r"[\w.-]*[a-z][\w.-]*", fixed) and "." in fixed:
                yield "".join(parts)


def left_over(keys: set[str], modules: Iterable[ast.AST]) -> list[str]:
    """Return the keys that no module names."""
    patterns = {pattern for tree in modules for pattern in keys_in(tree)}
    exact = {re.sub(r"\\(.)", r"\1", pattern) for pattern in patterns if "[" not in pattern}
    rest = re.compile("|".join(f"(?:{pattern})" for pattern in patterns if "[" in pattern) or r"(?!)")
    return sorted(key for key in keys if key not in exact and not rest.fullmatch(key))


def test_every_text_is_used() -> None:
    keys = set(catalogue("en"))
    # In quotes, or behind the braces of an f-string.
    begins = {f"{quote}{key.partition('.')[0]}." for key in keys for quote in "\"'"}
    modules = (tree for path, tree in trees(words=(*begins, "}.")) if "locale" not in path.parts)
    assert left_over(keys, modules) == []


def test_a_text_nobody_asks_for_is_noticed() -> None:
    tree = ast.parse('texts("bar.help"); texts(f"rviz.kind.{part.kind}")')
    assert left_over({"bar.help", "rviz.kind.box", "bar.old"}, [tree]) == ["bar.old"]
