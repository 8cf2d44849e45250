"""File name patterns: `*.py`, `src/*/package.xml`, `**/*.yaml` with `globstar`."""

from __future__ import annotations

import itertools
import os
import threading
from collections.abc import Callable, Collection, Iterator
from pathlib import Path

from day6_core.session.threads import in_thread
from day6_core.shell.language.braces import MOST_WORDS
from day6_core.shell.language.patterns import Pattern, Pieces, pattern, special


class _Part:
    """One part of a path: a plain name, or a pattern; with `deep` it is `**`."""

    def __init__(self, pieces: Pieces, settings: Collection[str]) -> None:
        extended = "extglob" in settings
        self.text = "".join(text if quoted else text.replace("\\", "") for text, quoted in pieces)
        self.deep = "globstar" in settings and [text for text, quoted in pieces if not quoted] == ["**"] == [self.text]
        self.pattern: Pattern | None = None
        if special(pieces, extended=extended):
            self.pattern = pattern(pieces, extended=extended, ignore_case="nocaseglob" in settings, names=True)
        self.hidden = "dotglob" in settings or self.text.startswith(".")

    def matches(self, name: str) -> bool:
        assert self.pattern is not None
        return (self.hidden or not name.startswith(".")) and self.pattern.matches(name)


async def files(pieces: Pieces, cwd: Path, settings: Collection[str]) -> list[str] | None:
    """Return the file names that a pattern matches, sorted; None for a text that isn't a pattern."""
    if not special(pieces, extended="extglob" in settings):
        return None
    parts = [_Part(each, settings) for each in _split(pieces)]
    if sum(part.pattern is not None for part in parts) == 1 and parts[-1].pattern is not None and not parts[-1].deep:
        return sorted(_walk(parts, cwd, lambda: False))
    abandoned = threading.Event()  # folders of any number: others go on, and Ctrl-C ends it

    def found() -> list[str]:
        return sorted(itertools.islice(_walk(parts, cwd, abandoned.is_set), MOST_WORDS))

    try:
        return await in_thread(found)
    finally:
        abandoned.set()


def _split(pieces: Pieces) -> list[Pieces]:
    """Split at each `/`."""
    parts: list[Pieces] = [[]]
    for text, quoted in pieces:
        for number, piece in enumerate(text.split("/")):
            if number:
                parts.append([])
            if piece:
                parts[-1].append((piece, quoted))
    return parts


def _walk(parts: list[_Part], cwd: Path, abandoned: Callable[[], bool]) -> Iterator[str]:
    def below(prefix: str, rest: list[_Part]) -> Iterator[str]:
        if abandoned():
            return
        part, rest = rest[0], rest[1:]
        if part.deep:
            yield from _deep(prefix, rest)
            return
        if part.pattern is None:
            path = prefix + part.text
            if rest:
                yield from below(path + "/", rest)
            elif os.path.lexists(os.path.join(cwd, path)) and (part.text or prefix):
                yield path
            return
        for name, is_folder in _entries(os.path.join(cwd, prefix or ".")):
            if not part.matches(name):
                continue
            if not rest:
                yield prefix + name
            elif is_folder():
                yield from below(f"{prefix}{name}/", rest)

    def _deep(prefix: str, rest: list[_Part]) -> Iterator[str]:
        """`**`: every folder below, and as the last part every file."""
        if not rest and prefix:
            yield prefix
        if rest and (rest[0].text or rest[0].pattern):
            yield from below(prefix, rest)
        elif rest and prefix:
            yield prefix
        for name, is_folder in _entries(os.path.join(cwd, prefix or "."), links=False):
            if name.startswith(".") and not parts[0].hidden:
                continue
            if is_folder():
                if not rest:
                    yield prefix + name
                yield from (each for each in _deep(f"{prefix}{name}/", rest) if rest or each != f"{prefix}{name}/")
            elif not rest:
                yield prefix + name

    return below("", parts)


def _entries(folder: str, *, links: bool = True) -> list[tuple[str, Callable[[], bool]]]:
    try:
        with os.scandir(folder) as entries:
            return [(entry.name, lambda entry=entry: _is_folder(entry, links)) for entry in entries]  # type: ignore[misc]
    except OSError:
        return []


def _is_folder(entry: os.DirEntry[str], links: bool) -> bool:
    try:
        return entry.is_dir(follow_symlinks=links)
    except OSError:
        return False
