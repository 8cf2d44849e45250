"""Helpers of tests are found by their plain names, so two of the same name would be mixed up."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]


def test_no_two_test_folders_have_a_helper_module_of_the_same_name() -> None:
    folders = defaultdict(list)
    for path in TESTS.glob("*/*.py"):
        if not path.name.startswith("test_") and path.name not in ("conftest.py", "__init__.py"):
            folders[path.name].append(path.parent.name)
    assert {name: found for name, found in folders.items() if len(found) > 1} == {}


def test_nobody_imports_a_conftest_by_name() -> None:
    assert [
        path.name for path in TESTS.rglob("*.py") if "\nfrom conftest import" in path.read_text(encoding="utf-8")
    ] == []
