"""What our documents say of files: each one they name is there."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

import pytest

from tests.docs.pages import Page, documents
from tests.support.source_files import ROOT

OF_USERS = {"setup.py", "package.xml", "CMakeLists.txt", "INSTALL.txt", "README.txt", "sin(i/10)"}
"""What isn't ours, or no file."""
OURS = re.compile(r"(\.ci|\.github|core|docs|hub|requirements|tests|tui|urdf|day6_core|day6_tui|day6_urdf)/")
"""How a path of ours begins; pages for users name their own files, too (`talker.py`)."""


@functools.cache
def ours() -> set[str]:
    """Return every file and folder by each end of its path: 'core/day6_core/elide.py', 'day6_core/elide.py', 'elide.py'."""
    names = ".ci .github CHANGELOG.md core docs hub pyproject.toml requirements tests tui urdf"
    paths = [Path(name) for name in names.split()]
    found = {inner.relative_to(ROOT) for path in paths for inner in ((ROOT / path), *(ROOT / path).rglob("*"))}
    return {"/".join(path.parts[start:]) for path in found for start in range(len(path.parts))}


def named(document: Page) -> Iterator[str]:
    """Yield what looks like a path, or like the name of a module or another text, in a document."""
    for_users = document.name.startswith(("docs/", "hub/")) and "/contributing/" not in document.name
    for word in document.code_words():
        is_elsewhere = not OURS.match(word) and (for_users or word.startswith(("/", "~", "$", ".", "-")))
        if (
            "/" in word
            or PurePosixPath(word).suffix in (".py", ".toml", ".jsonl", ".json", ".md", ".txt", ".js", ".tcss")
        ) and not (is_elsewhere or re.search(r"\s|://|<|…", word)):
            yield word.rstrip("/")


@pytest.mark.parametrize("document", documents(), ids=lambda document: document.name)
def test_every_file_that_a_document_names_is_there(document: Page) -> None:
    patterns = [name for name in named(document) if "*" in name]
    missing = {name for name in named(document) if "*" not in name} - ours() - OF_USERS
    missing |= {pattern for pattern in patterns if not any(PurePosixPath(path).match(pattern) for path in ours())}
    assert sorted(missing) == []
