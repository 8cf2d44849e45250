"""find."""

from __future__ import annotations

import fnmatch
import os
import stat
from collections.abc import Callable

from day6_core import deep
from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain, reason

Test = Callable[[str, str], bool]
"""Of a name as it is printed, and its whole path."""


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
        status = await _walk(session, start, wanted) or status
    return status


async def _walk(session: Session, start: str, wanted: _Expression) -> int:
    status = 0
    waiting = [(start, 0, False)]  # no recursion: a tree may be deeper than Python's stack
    while waiting:
        name, depth, emptied = waiting.pop()
        path = os.path.join(session.cwd, name)
        if emptied:
            status = _delete(session, name) or status
            continue
        chosen = depth >= wanted.shallowest and wanted.matches(name, path)
        if chosen and not wanted.delete:
            session.print(name)
        if chosen and wanted.delete and name != ".":
            waiting.append((name, depth, True))  # a folder after what is in it
        if depth < wanted.deepest and deep.is_folder(path):
            try:
                children = sorted(deep.names_in(path), reverse=True)
            except OSError as error:
                complain(session, f"‘{name}’: {reason(error)}")
                status = 1
                continue
            waiting += [(f"{name.rstrip('/')}/{child}", depth + 1, False) for child in children]
        await session.stdout.drain()
    return status


def _delete(session: Session, name: str) -> int:
    path = os.path.join(session.cwd, name)
    try:
        deep.remove(path, folder=deep.is_folder(path))
    except OSError as error:
        complain(session, f"cannot delete ‘{name}’: {reason(error)}")
        return 1
    return 0


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

    def matches(self, name: str, path: str) -> bool:
        return any(all(test(name, path) for test in tests) for tests in self._any)


def _not(test: Test) -> Test:
    return lambda name, path: not test(name, path)


def _base(name: str) -> str:
    return name.rstrip("/").rpartition("/")[2] or name


def _kind(path: str) -> str:
    mode = deep.mode(path)
    return "l" if stat.S_ISLNK(mode) else "d" if stat.S_ISDIR(mode) else "f" if stat.S_ISREG(mode) else "?"


def _is_empty(path: str) -> bool:
    try:
        found = deep.status(path)
        return (
            not deep.names_in(path)
            if stat.S_ISDIR(found.st_mode)
            else stat.S_ISREG(found.st_mode) and not found.st_size
        )
    except OSError:
        return False


def _size(text: str) -> Test:
    sign, digits, unit = text[:1] if text[:1] in "+-" else "", text.lstrip("+-").rstrip("ckMG"), text[-1:]
    if not digits.isdigit():
        raise _Wrong(f"invalid -size type `{text[-1:]}'")
    block = {"c": 1, "k": 1024, "M": 1024**2, "G": 1024**3}.get(unit, 512)

    def test(name: str, path: str) -> bool:
        blocks = -(-deep.status(path).st_size // block)
        number = int(digits)
        return blocks > number if sign == "+" else blocks < number if sign == "-" else blocks == number

    return test
