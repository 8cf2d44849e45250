"""No text of the catalogues is left over: for every key there is a place in the code that names it or puts it together."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from day6_tui.tui.locale import catalogue

ROOT = Path(__file__).resolve().parents[2]
KEY = re.compile(r"[a-z_]+(\.\w+)+")


def keys_in(source: str) -> Iterator[re.Pattern[str]]:
    """Yield what the strings of a module match: themselves, and f-strings with anything in their braces."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and KEY.fullmatch(node.value):
            yield re.compile(re.escape(node.value))
        elif isinstance(node, ast.JoinedStr):
            parts = [re.escape(part.value) if isinstance(part, ast.Constant) else r"[\w.]+" for part in node.values]
            fixed = "".join(part.value for part in node.values if isinstance(part, ast.Constant))
            if re.fullmatch(r"[\w.]*[a-z][\w.]*", fixed) and "." in fixed:
                yield re.compile("".join(parts))


def left_over(keys: set[str], sources: list[str]) -> list[str]:
    """Return the keys that no source names."""
    patterns = {pattern.pattern for source in sources for pattern in keys_in(source)}
    exact = {re.sub(r"\\(.)", r"\1", pattern) for pattern in patterns if "[" not in pattern}
    rest = re.compile("|".join(f"(?:{pattern})" for pattern in patterns if "[" in pattern) or r"(?!)")
    return sorted(key for key in keys if key not in exact and not rest.fullmatch(key))


def test_every_text_is_used() -> None:
    sources = [
        path.read_text(encoding="utf-8")
        for top in ("core", "tui", "urdf")
        for path in (ROOT / top).rglob("*.py")
        if path.parent.name != "locale"
    ]
    assert left_over(set(catalogue("en")), sources) == []


def test_a_text_nobody_asks_for_is_noticed() -> None:
    source = 'texts("bar.help"); texts(f"rviz.kind.{part.kind}")'
    assert left_over({"bar.help", "rviz.kind.box", "bar.old"}, [source]) == ["bar.old"]
