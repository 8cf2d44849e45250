"""The folder on the stick: wheels, their sums, and how to install them. Only what an earlier run has written is replaced."""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path

from day6_tui.core.whole_file import replace_file

SUMS, GUIDE, CHECK = "SHA256SUMS", "INSTALL.txt", "check.py"


class NotOurs(Exception):
    """There is a file that no run of ours has written; the message is its name."""


def known(folder: Path) -> dict[str, str]:
    """Return the sums of what an earlier run has written, by name. Raises OSError."""
    try:
        lines = (folder / SUMS).read_text(encoding="utf-8", errors="replace").splitlines()
    except FileNotFoundError:
        return {}
    return {name: digest for digest, _, name in (line.partition("  ") for line in lines) if "/" not in name}


def sum_of(path: Path) -> str:
    """Return the SHA-256 of a file as hexadecimal digits."""
    digest = hashlib.sha256()
    with path.open("rb") as file:
        for piece in iter(lambda: file.read(1 << 20), b""):
            digest.update(piece)
    return digest.hexdigest()


def foreign(folder: Path) -> str:
    """Return the name of a file in the folder that an earlier run has not written, or has been changed since; '' if none."""
    if not folder.exists():
        return ""
    ours = known(folder)
    for path in sorted(folder.iterdir()):
        if path.name != SUMS and (not path.is_file() or path.is_symlink() or ours.get(path.name) != sum_of(path)):
            return path.name
    return ""


def fill(folder: Path, wheels: list[Path], texts: dict[str, str]) -> None:
    """Put wheels and texts into a folder that holds nothing foreign, and the sums of all. Raises NotOurs, OSError."""
    if name := foreign(folder):
        raise NotOurs(name)
    folder.mkdir(parents=True, exist_ok=True)
    old = known(folder)
    sums = {}
    for wheel in wheels:
        sums[wheel.name] = sum_of(wheel)
        if old.get(wheel.name) != sums[wheel.name]:
            part = folder / f".{wheel.name}.part"
            shutil.copyfile(wheel, part)
            part.replace(folder / wheel.name)
    for name, text in texts.items():
        replace_file(folder / name, text.encode())
        sums[name] = sum_of(folder / name)
    for name in old.keys() - sums.keys():
        (folder / name).unlink(missing_ok=True)
    lines = "".join(f"{sums[name]}  {name}\n" for name in sorted(sums))
    replace_file(folder / SUMS, lines.encode())


CHECKER = '''\
"""Compares every file of this folder with SHA256SUMS: python3 check.py"""

import hashlib
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
wrong = []
for line in (here / "SHA256SUMS").read_text(encoding="utf-8").splitlines():
    digest, _, name = line.partition("  ")
    path = here / name
    if not path.is_file() or hashlib.sha256(path.read_bytes()).hexdigest() != digest:
        wrong.append(name)
for name in wrong:
    print("missing or damaged:", name)
print("all files are whole" if not wrong else "copy the folder again")
sys.exit(bool(wrong))
'''
