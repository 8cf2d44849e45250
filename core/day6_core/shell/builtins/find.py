"""find."""

from __future__ import annotations

import fnmatch
import os
from collections.abc import Callable
from pathlib import Path

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain, reason

Test = Callable[[str, Path], bool]


class _Wrong(Exception):
    """The expression is wrong; the text is what find says."""


async def find(session: Session) -> int:
    words = session.argv[1:]
    starts = []
    while words and not words[0].startswith(("-", "(", "!")):
        starts.append(words.pop(0))
    try:
        wanted = _Expression(words)
    except _Wrong as error:
        complain(session, error)
        return 1
    status = 0
    for start in starts or ["."]:
        if not os.path.lexists(session.cwd / start):
            complain(session, f"‘{start}’: No such file or directory")
            status = 1
            continue
        status = await _walk(session, start, wanted, 0) or status
    return status


async def _walk(session: Session, name: str, wanted: _Expression, depth: int) -> int:
    path = session.cwd / name
    status = 0
    chosen = depth >= wanted.shallowest and wanted.matches(name, path)
    if chosen and not wanted.delete:
        session.print(name)
        await session.stdout.drain()
    # os.path returns False where pathlib raises: in /proc even reading another user's link is forbidden.
    if depth < wanted.deepest and os.path.isdir(path) and not os.path.islink(path):
        try:
            children = sorted(entry.name for entry in os.scandir(path))
        except OSError as error:
            complain(session, f"‘{name}’: {reason(error)}")
            return 1
        for child in children:
            status = await _walk(session, f"{name.rstrip('/')}/{child}", wanted, depth + 1) or status
    if chosen and wanted.delete and name != ".":  # a folder after what is in it
        try:
            path.rmdir() if path.is_dir() and not path.is_symlink() else path.unlink()
        except OSError as error:
            complain(session, f"cannot delete ‘{name}’: {reason(error)}")
            status = 1
    return status


class _Expression:
    """`-name`, `-iname`, `-path`, `-type`, `-empty`, `-size`, `-maxdepth`, `-mindepth`, `-not`/`!`, `-o`, `-print`, `-delete`."""

    def __init__(self, words: list[str]) -> None:
        self.shallowest, self.deepest, self.delete = 0, 10**6, False
        self._any: list[list[Test]] = [[]]
        words = list(words)
        negate = False
        while words:
            word = words.pop(0)
            if word in ("-not", "!"):
                negate = True
                continue
            if word in ("-o", "-or"):
                self._any.append([])
                continue
            test = self._one(word, words)
            if test is not None:
                self._any[-1].append(_not(test) if negate else test)
                negate = False

    def _one(self, word: str, words: list[str]) -> Test | None:
        if word in ("-print", "-a", "-and"):
            return None
        if word == "-delete":
            self.delete = True
            return None
        if word == "-empty":
            return lambda name, path: _is_empty(path)
        if word not in ("-name", "-iname", "-path", "-wholename", "-type", "-maxdepth", "-mindepth", "-size"):
            if word.startswith("-"):
                raise _Wrong(f"unknown predicate `{word}'")
            raise _Wrong(f"paths must precede expression: `{word}'")
        if not words:
            raise _Wrong(f"missing argument to `{word}'")
        value = words.pop(0)
        if word in ("-maxdepth", "-mindepth"):
            if not value.isdigit():
                raise _Wrong(f"Expected a positive decimal integer argument to {word}, but got ‘{value}’")
            if word == "-maxdepth":
                self.deepest = int(value)
            else:
                self.shallowest = int(value)
            return None
        if word == "-type":
            if value not in ("f", "d", "l"):
                raise _Wrong(f"Unknown argument to -type: {value}")
            return lambda name, path: _kind(path) == value
        if word == "-size":
            return _size(value)
        if word in ("-path", "-wholename"):
            return lambda name, path: fnmatch.fnmatchcase(name, value)
        if word == "-iname":
            return lambda name, path: fnmatch.fnmatchcase(_base(name).lower(), value.lower())
        return lambda name, path: fnmatch.fnmatchcase(_base(name), value)

    def matches(self, name: str, path: Path) -> bool:
        return any(all(test(name, path) for test in tests) for tests in self._any)


def _not(test: Test) -> Test:
    return lambda name, path: not test(name, path)


def _base(name: str) -> str:
    return name.rstrip("/").rpartition("/")[2] or name


def _kind(path: Path) -> str:
    return "l" if path.is_symlink() else "d" if path.is_dir() else "f" if path.is_file() else "?"


def _is_empty(path: Path) -> bool:
    if path.is_dir():
        return not any(path.iterdir())
    return path.is_file() and path.stat().st_size == 0


def _size(text: str) -> Test:
    sign, digits, unit = text[:1] if text[:1] in "+-" else "", text.lstrip("+-").rstrip("ckMG"), text[-1:]
    if not digits.isdigit():
        raise _Wrong(f"invalid -size type `{text[-1:]}'")
    block = {"c": 1, "k": 1024, "M": 1024**2, "G": 1024**3}.get(unit, 512)

    def test(name: str, path: Path) -> bool:
        blocks = -(-path.lstat().st_size // block)
        number = int(digits)
        return blocks > number if sign == "+" else blocks < number if sign == "-" else blocks == number

    return test
