"""Which files of tests need not be imported when `-m` chooses some layers: those in which nothing has one of its marks.

Every process of pytest-xdist collects all tests for itself; more than half of the files have tests of the default layer only.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest
from _pytest.mark.expression import Expression

from tests.support.one_process import LAYERS

TESTS = Path(__file__).resolve().parents[1]


@cache
def _told(path: Path) -> frozenset[str]:
    """The marks that a file names."""
    return frozenset(re.findall(r"\bmark\.(\w+)", path.read_text(encoding="utf-8"))) if path.is_file() else frozenset()


@cache
def marks_in(path: Path) -> frozenset[str]:
    """The marks that tests of a file can have: it names them, or a conftest.py of its folders does."""
    folders = [folder for folder in path.parents if TESTS in folder.parents]
    return _told(path).union(*(_told(folder / "conftest.py") for folder in folders))


def _has_none(name: str, /, **_: object) -> bool:
    """Match a test without any mark."""
    return False


def left_out(path: Path, expression: str) -> bool:
    """Return whether `-m expression` chooses no test of a file, as far as its text says."""
    if not path.match("test_*.py") or Expression.compile(expression or "not none").evaluate(_has_none):
        return False  # it chooses tests without any mark
    return marks_in(path).isdisjoint(re.findall(r"\w+", expression))


def judge(items: list[pytest.Item]) -> None:
    """Fail a collection with a test that `left_out` would overlook."""
    for item in items:
        if unsaid := {mark.name for mark in item.iter_markers() if mark.name in LAYERS} - marks_in(item.path):
            raise pytest.UsageError(
                f"{item.nodeid}: neither its file nor a conftest.py beside it says mark.{unsaid.pop()}"
            )
