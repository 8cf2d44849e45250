"""What our documents say of files: each one they name is there."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

import pytest

from tests.support.source_files import ROOT

PAGES = tuple(
    path.relative_to(ROOT).as_posix()
    for part in ("developers", "trust", "contributing")
    for path in sorted((ROOT / "docs").glob(f"*/{part}/*.md"))
)
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "tests/README.md", "core/day6_core/lessons/WRITING.md", *PAGES)
OF_USERS = {"setup.py", "package.xml", "CMakeLists.txt", "INSTALL.txt", "README.txt", "sin(i/10)"}
"""What isn't ours, or no file."""


@functools.cache
def ours() -> set[str]:
    """Return every file and folder by each end of its path: 'core/day6_core/elide.py', 'day6_core/elide.py', 'elide.py'."""
    paths = [
        Path(folder) for folder in ("core", "tui", "urdf", "tests", "hub", "docs", "pyproject.toml", "CHANGELOG.md")
    ]
    found = {inner.relative_to(ROOT) for path in paths for inner in ((ROOT / path), *(ROOT / path).rglob("*"))}
    return {"/".join(path.parts[start:]) for path in found for start in range(len(path.parts))}


def named(document: str) -> Iterator[str]:
    """Yield what looks like a path, or like the name of a module or another text, in a document."""
    for word in re.findall(r"`([^`\s]+)`", (ROOT / document).read_text(encoding="utf-8")):
        is_elsewhere = word.startswith(("/", "~", "$", ".", "-")) or re.search(r"://|<|…", word)
        if (
            "/" in word
            or PurePosixPath(word).suffix in (".py", ".toml", ".jsonl", ".json", ".md", ".txt", ".js", ".tcss")
        ) and not is_elsewhere:
            yield word.rstrip("/")


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_file_that_a_document_names_is_there(document: str) -> None:
    patterns = [name for name in named(document) if "*" in name]
    missing = {name for name in named(document) if "*" not in name} - ours() - OF_USERS
    missing |= {pattern for pattern in patterns if not any(PurePosixPath(path).match(pattern) for path in ours())}
    assert sorted(missing) == []
