"""The rows of the table: what this machine is, and runs.json, in which everything that was ever claimed stands."""

from __future__ import annotations

import ctypes
import datetime
import json
import os
import platform
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from day6_core.parts import PROJECTS, has_part
from tests.support.source_files import ROOT

RUNS = Path(__file__).with_name("runs.json")


UNTRIED = ("macOS", "Windows x86_64", "Linux aarch64")
"""Systems for which day6-tui is written; each is in the table also while it was never run there."""


class Row(NamedTuple):
    """One run: where it was, and what came of each feature (`play`)."""

    system: str
    """`Linux x86_64`; Wine is named."""
    release: str
    python: str
    lacks: str
    """The packages that are left out (core/day6_core/parts.py), and DAY6_LINK where it isn't what holds without it."""
    date: str
    commit: str
    """The last one that changed the program; "" where there is no git."""
    cells: Mapping[str, str]

    @property
    def label(self) -> tuple[str, str, str]:
        """What a later run of the same takes the place of: the system, 3.12, what is left out."""
        return self.system, self.python.rpartition(".")[0], self.lacks

    @property
    def name(self) -> str:
        """The same in few words, for the head of a table."""
        system = {"Linux x86_64": "Linux", "Windows under Wine": "Wine"}.get(self.system, self.system)
        kind = ", local" if "DAY6_LINK=" in self.lacks else ", lean" if self.lacks else ""
        return f"{system} {self.label[1]}{kind}"


def here(cells: Mapping[str, str]) -> Row:
    """Return the row of this machine and this Python."""
    lacks = [PROJECTS[name] for name in PROJECTS if not has_part(name)]
    if "DAY6_LINK" in os.environ:
        lacks.append(f"DAY6_LINK={os.environ['DAY6_LINK']}")
    python = platform.python_version()
    return Row(*_system(), python, ", ".join(lacks), datetime.date.today().isoformat(), _commit(), cells)


def _commit() -> str:
    """Ask git; Wine has no git, tests/windows/run tells it."""
    if "COMMIT" in os.environ:
        return os.environ["COMMIT"]
    command = ["git", "log", "-1", "--format=%h", "--abbrev=8", "--", "core", "tui", "urdf"]
    try:
        return subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout.strip()
    except FileNotFoundError:
        return ""


def _system() -> tuple[str, str]:
    machine = platform.machine()
    if sys.platform == "win32":
        wine = getattr(ctypes.CDLL("ntdll"), "wine_get_version", None)
        if wine is not None:
            wine.restype = ctypes.c_char_p
            return "Windows under Wine", f"Wine {wine().decode()}"
        return f"Windows {machine.replace('AMD64', 'x86_64')}", platform.platform()
    if sys.platform == "darwin":
        return f"macOS {machine}", f"macOS {platform.mac_ver()[0]}"
    try:
        release = platform.freedesktop_os_release()["PRETTY_NAME"]
    except (OSError, KeyError):
        release = platform.platform()
    return f"{platform.system()} {machine}", release


def recorded() -> list[Row]:
    """Return all rows."""
    return [Row(**row) for row in json.loads(RUNS.read_text(encoding="utf-8"))]


def record(row: Row) -> None:
    """Put a row in the place of the one with the same label, of which cells of the same commit stay that weren't played again."""
    rows = {each.label: each for each in recorded()}
    before = rows.get(row.label)
    rows[row.label] = (
        row._replace(cells={**before.cells, **row.cells}) if before and before.commit == row.commit else row
    )
    text = json.dumps([rows[label]._asdict() for label in sorted(rows)], indent=1, ensure_ascii=False)
    RUNS.write_text(f"{text}\n", encoding="utf-8", newline="\n")
