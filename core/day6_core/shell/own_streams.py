"""The names of a command's own streams: `/dev/stdout` is the command's output, never the desktop's.

To the system these names mean the streams of the process that opens them, which here is the whole desktop.
"""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from day6_core.session.streams import InputStream, OutputStream, TerminalSide

TTY = -1
"""Means the terminal, whatever the streams are (`/dev/tty`)."""

Table = Mapping[int, InputStream | OutputStream]

_NAMED = {"/dev/stdin": 0, "/dev/stdout": 1, "/dev/stderr": 2, "/dev/tty": TTY}
_NUMBERED = re.compile(r"(?:/dev|/proc/(?:self|thread-self|self/task/\d+|(?P<process>\d+)))/fd/(?P<number>\d{1,9})")
_MOST_LINKS = 40


class HasStreams(Protocol):
    """A session, or the streams of one."""

    @property
    def stdin(self) -> InputStream: ...

    @property
    def stdout(self) -> OutputStream: ...

    @property
    def stderr(self) -> OutputStream: ...


def table_of(streams: HasStreams) -> Table:
    """Return the streams of a command by their numbers."""
    return {0: streams.stdin, 1: streams.stdout, 2: streams.stderr}


def stream_number(path: Path) -> int | None:
    """Return which stream `path` (absolute, links are followed) names: a number, TTY, or None for an ordinary file."""
    if os.name != "posix":
        return None
    text = os.path.normpath(path)
    for _ in range(_MOST_LINKS):
        if text in _NAMED:
            return _NAMED[text]
        found = _NUMBERED.fullmatch(text)
        if found is not None and found["process"] in (None, str(os.getpid())):
            return int(found["number"])
        try:
            text = os.path.normpath(os.path.join(os.path.dirname(text), os.readlink(text)))
        except OSError:
            return None
    return None


def own_input(path: Path, table: Table) -> InputStream | None:
    """Return the stream to read that `path` names, None for an ordinary file. Raises OSError if it is not readable."""
    number = stream_number(path)
    if number is None:
        return None
    stream = table.get(number)
    if isinstance(stream, InputStream):
        return stream
    outputs = [each for each in table.values() if isinstance(each, OutputStream)]
    for keys in (
        table.get(0),
        *(each.keyboard() for each in ([stream] if isinstance(stream, OutputStream) else outputs)),
    ):
        if isinstance(keys, InputStream) and keys.isatty():
            return keys
    raise _no_such(number)


def own_output(path: Path, table: Table) -> OutputStream | None:
    """Return the stream to write that `path` names, None for an ordinary file. Raises OSError if it is not writable."""
    number = stream_number(path)
    if number is None:
        return None
    stream = table.get(number)
    if isinstance(stream, OutputStream):
        return stream
    if number in (TTY, 0):
        for output in table.values():
            if isinstance(output, OutputStream) and output.isatty():
                return output
        keys = table.get(0)
        terminal = keys.terminal_of() if isinstance(keys, InputStream) else None
        if terminal is not None:
            return _Terminal(terminal)
    raise _no_such(number)


def _no_such(number: int) -> OSError:
    code = errno.ENXIO if number == TTY else errno.EACCES if number in (0, 1, 2) else errno.ENOENT
    return OSError(code, os.strerror(code))


class _Terminal(OutputStream):
    """The terminal of a command whose own output goes elsewhere."""

    def __init__(self, terminal: TerminalSide) -> None:
        self._terminal = terminal

    @property
    def columns(self) -> int:
        return self._terminal.columns

    def write(self, text: str) -> int:
        self._terminal.output.write(text.replace("\n", "\r\n"))
        return len(text)

    async def drain(self) -> None:
        await self._terminal.output.drain()

    def isatty(self) -> bool:
        return True
