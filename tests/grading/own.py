"""A teacher's own hidden scenarios, for tests that don't need those of the lessons."""

from __future__ import annotations

from pathlib import Path

_PRINTS = (
    "---\ngrading: own\ntitle: {zh: 自己的, en: My own}\n---\n\n# prints\n\n~~~yaml\nvalues:\n  word: word\n"
    "run:\n  - type: python3 ~/echo.py @word@\n"
    "check:\n  - ran: {line: echo.py, status: 0, prints: 'heard @word@'}\nstall: 60\n~~~\n\n"
    "## zh 说出听到的词\n## en It says the word\n"
)
"""What is typed behind `echo.py` has to be printed."""


def own_gradings(beside: Path) -> Path:
    """Return a new folder with them."""
    folder = beside / "own"
    folder.mkdir()
    (folder / "own.md").write_text(_PRINTS, encoding="utf-8")
    return folder
