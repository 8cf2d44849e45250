"""The tests of `test`, `[` and `[[`: of files, texts and integers."""

from __future__ import annotations

import operator
import os
import re
import stat
from collections.abc import Callable
from pathlib import Path

UNARY = frozenset("-" + letter for letter in "abcdefghknoprstuvwxzGLNORS")
INTEGER: dict[str, Callable[[int, int], bool]] = {
    "-eq": operator.eq,
    "-ne": operator.ne,
    "-lt": operator.lt,
    "-le": operator.le,
    "-gt": operator.gt,
    "-ge": operator.ge,
}
FILES = frozenset({"-nt", "-ot", "-ef"})


def unary(question: str, text: str, cwd: Path) -> bool:
    """Apply a unary test to a text or to the file of that name. Raises ValueError (bash's text) for an unknown operator."""
    path = cwd / text
    checks: dict[str, Callable[[], bool]] = {
        "-z": lambda: not text,
        "-n": lambda: bool(text),
        "-a": path.exists,
        "-e": path.exists,
        "-f": path.is_file,
        "-d": path.is_dir,
        "-h": path.is_symlink,
        "-L": path.is_symlink,
        "-s": lambda: path.exists() and path.stat().st_size > 0,
        "-r": lambda: os.access(path, os.R_OK),
        "-w": lambda: os.access(path, os.W_OK),
        "-x": lambda: os.access(path, os.X_OK),
        "-p": path.is_fifo,
        "-S": path.is_socket,
        "-b": path.is_block_device,
        "-c": path.is_char_device,
        "-g": lambda: bool(_mode(path) & stat.S_ISGID),
        "-u": lambda: bool(_mode(path) & stat.S_ISUID),
        "-k": lambda: bool(_mode(path) & stat.S_ISVTX),
        "-O": lambda: path.exists() and path.stat().st_uid == getattr(os, "geteuid", lambda: 0)(),
        "-G": lambda: path.exists() and path.stat().st_gid == getattr(os, "getegid", lambda: 0)(),
        "-N": lambda: path.exists() and path.stat().st_mtime_ns > path.stat().st_atime_ns,
    }
    if question not in checks:
        raise ValueError(f"{question}: unary operator expected")
    return (bool(text) or question in ("-z", "-n")) and checks[question]()


def _mode(path: Path) -> int:
    return path.stat().st_mode if path.exists() else 0


def integers(left: str, comparison: str, right: str) -> bool:
    """Compare two integers. Raises ValueError (bash's text) for anything that isn't an integer."""
    for text in (left, right):
        if re.fullmatch(r"\s*[-+]?\d+\s*", text, re.ASCII) is None:
            raise ValueError(f"{text}: integer expression expected")
    return INTEGER[comparison](int(left), int(right))


def files(left: str, comparison: str, right: str, cwd: Path) -> bool:
    """`-nt`, `-ot` (a missing file is older than any) and `-ef`."""
    first, second = cwd / left, cwd / right
    if comparison == "-ef":
        return first.exists() and second.exists() and first.samefile(second)
    if comparison == "-ot":
        first, second = second, first
    return first.exists() and (not second.exists() or first.stat().st_mtime_ns > second.stat().st_mtime_ns)
