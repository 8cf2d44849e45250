"""Where a command reads and writes: `<` `>` `>>` `2>&1` `&>` `3>` `{fd}>` here-documents."""

from __future__ import annotations

import errno
import os
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.reason import reason
from day6_core.session.streams import FileInput, FileOutput, InputStream, OutputStream, TextInput
from day6_core.shell.language import syntax
from day6_core.shell.language.expansion import expand, expand_text
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.words import ProcessSubstitution
from day6_core.shell.outside import agreed, is_outside, keys_of
from day6_core.shell.own_streams import Table, own_input, own_output

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell

_FIRST_NAMED = 10
"""The first descriptor that `{NAME}>` gives."""
_NETWORK = ("/dev/tcp/", "/dev/udp/")


@dataclass
class Streams:
    """Where a command reads and writes. `exec` changes it in place, for all that follows."""

    stdin: InputStream
    stdout: OutputStream
    stderr: OutputStream
    more: dict[int, InputStream | OutputStream] = field(default_factory=dict)
    """By descriptor, from 3."""
    changed: set[int] = field(default_factory=set)
    """Descriptors that `exec` has changed."""

    @property
    def table(self) -> dict[int, InputStream | OutputStream]:
        return {0: self.stdin, 1: self.stdout, 2: self.stderr, **self.more}

    def take(self, other: Streams, descriptors: set[int]) -> None:
        """Take over some descriptors of others, for good."""
        table = other.table
        for number in descriptors:
            stream = table.get(number)
            if number == 0 and isinstance(stream, InputStream):
                self.stdin = stream
            elif number == 1 and isinstance(stream, OutputStream):
                self.stdout = stream
            elif number == 2 and isinstance(stream, OutputStream):
                self.stderr = stream
            elif number > 2 and stream is not None:
                self.more[number] = stream
            elif number > 2:
                self.more.pop(number, None)
        self.changed |= descriptors

    def hand_up(self, outer: Streams, redirected: list[syntax.Redirection]) -> None:
        """After a command with `redirected`: what `exec` changed in it stays changed, unless it was redirected."""
        if self is not outer and self.changed:
            outer.take(self, self.changed - descriptors_of(redirected))


def descriptors_of(redirections: list[syntax.Redirection]) -> set[int]:
    """The descriptors that they change."""
    found: set[int] = set()
    for redirection in redirections:
        if isinstance(redirection.fd, str):
            continue
        operator = redirection.operator
        found.add(redirection.fd if redirection.fd is not None else 0 if operator.startswith("<") else 1)
        if operator in ("&>", "&>>") or (operator == ">&" and redirection.fd is None):
            found.add(2)
    return found


async def redirect(
    redirections: list[syntax.Redirection], shell: Shell, streams: Streams, opened: ExitStack
) -> Streams:
    """Return `streams` with the redirections applied; files are closed with `opened`. Raises OSError with the name in it.

    Without redirections `streams` itself is returned.
    """
    if not redirections:
        return streams
    from day6_core.shell.language.substitution import stream_of

    table = streams.table
    closed: set[int] = set()
    lasting: set[int] = set()
    for redirection in redirections:
        operator = redirection.operator
        named = isinstance(redirection.fd, str)
        fd = _descriptor(redirection, table, shell)
        stream: InputStream | OutputStream | None
        if not redirection.document and (process := _process(redirection)) is not None:
            stream = stream_of(shell, process, streams, opened)
            target = ""
        else:
            target = await _target(redirection, shell, streams)
            if operator in (">&", "<&") and (target.rstrip("-").isdigit() or target == "-"):
                stream = _copied(target, table)
                if target.endswith("-") and target != "-":
                    closed.add(int(target[:-1]))
            else:
                kept = shell.kept if named else opened
                stream = await _opened(redirection, target, table, shell, streams, kept)
        if stream is None:
            table.pop(fd, None)
            closed.add(fd)
        else:
            table[fd] = stream
            closed.discard(fd)
        if stream is not None and (
            operator in ("&>", "&>>")
            or (operator == ">&" and redirection.fd is None and not target.rstrip("-").isdigit())
        ):
            table[2] = stream
        if named:
            lasting.add(fd)
            if stream is not None and isinstance(redirection.fd, str):
                shell.variables.assign(redirection.fd, str(fd))
    for number in closed - descriptors_of(redirections):
        table.pop(number, None)
    stdin, stdout, stderr = table.get(0, InputStream()), table.get(1, OutputStream()), table.get(2, OutputStream())
    if (
        not isinstance(stdin, InputStream)
        or not isinstance(stdout, OutputStream)
        or not isinstance(stderr, OutputStream)
    ):
        raise OSError(9, "Bad file descriptor", str(fd))
    more = {number: stream for number, stream in table.items() if number > 2}
    return Streams(stdin, stdout, stderr, more, lasting)


def _process(redirection: syntax.Redirection) -> ProcessSubstitution | None:
    parts = redirection.target.parts
    return parts[0] if len(parts) == 1 and isinstance(parts[0], ProcessSubstitution) else None


def _descriptor(redirection: syntax.Redirection, table: Table, shell: Shell) -> int:
    if redirection.fd is None:
        return 0 if redirection.operator.startswith("<") else 1
    if isinstance(redirection.fd, int):
        return redirection.fd
    if redirection.operator in (">&", "<&") and redirection.target.plain == "-":
        text = shell.variables.get(redirection.fd, "")
        if not text.isdigit():
            raise OSError(errno.EBADF, "Bad file descriptor", text)
        return int(text)
    return next(number for number in range(_FIRST_NAMED, 10_000) if number not in table)


async def _target(redirection: syntax.Redirection, shell: Shell, streams: Streams) -> str:
    if redirection.document:
        return await expand_text(redirection.document[0], shell, streams)
    if redirection.operator == "<<<":
        return await expand_text(redirection.target, shell, streams)
    words = await expand([redirection.target], shell, streams)
    if len(words) != 1:
        raise OSError(errno.EINVAL, "ambiguous redirect", redirection.target.source)
    return words[0]


def _copied(target: str, table: Table) -> InputStream | OutputStream | None:
    """`>&2`, `<&3`, `>&-`, `3>&1-`."""
    if target == "-":
        return None
    number = int(target.rstrip("-"))
    if number not in table:
        raise OSError(errno.EBADF, "Bad file descriptor", str(number))
    return table[number]


async def _opened(
    redirection: syntax.Redirection, target: str, table: Table, shell: Shell, streams: Streams, opened: ExitStack
) -> InputStream | OutputStream:
    operator = redirection.operator
    if operator in ("<<", "<<-"):
        return TextInput(target)
    if operator == "<<<":
        return TextInput(target + "\n")
    if target.startswith(_NETWORK):
        raise Refused(f"{operator} {target}")
    if operator == "<":
        own = _own_input(shell.cwd / target, target, table)
        stream = own or _open_input(shell.cwd / target, target)
        if own is None:
            opened.callback(stream.close)
        return stream
    path = shell.cwd / target
    mine = _own_output(path, target, table)
    if mine is not None:
        return mine
    if "C" in shell.options and operator in (">", "&>", ">&") and path.is_file():
        raise OSError(errno.EEXIST, "cannot overwrite existing file", target)
    if not await _may_write(path, shell, streams):
        raise OSError(errno.ECANCELED, "not changed", target)
    output = _open_output(path, target, append=operator in (">>", "&>>"))
    opened.callback(output.close)
    return output


async def _may_write(path: Path, shell: Shell, streams: Streams) -> bool:
    """Ask, in the shell's name, before a file outside the home folder is written."""
    keys = keys_of(streams.stdin)
    if keys is None or not is_outside(path, Path(shell.environment.get("HOME", "/"))):
        return True
    keys.focus()  # the command that would own them does not run yet
    try:
        return await agreed(shell.name, [path], keys, streams.stderr, shell.environment)
    finally:
        keys.unfocus()


def _own_input(path: Path, name: str, table: Table) -> InputStream | None:
    try:
        return own_input(path, table)
    except OSError as error:
        raise OSError(error.errno, error.strerror, name) from None


def _own_output(path: Path, name: str, table: Table) -> OutputStream | None:
    try:
        return own_output(path, table)
    except OSError as error:
        raise OSError(error.errno, error.strerror, name) from None


def _open_input(path: Path, name: str) -> InputStream:
    if name == "/dev/null":
        return InputStream()
    if path.is_dir():
        raise IsADirectoryError(21, "Is a directory", name)
    try:
        return FileInput(path)
    except OSError as error:
        raise OSError(error.errno, reason(error), name) from None


def _open_output(path: Path, name: str, *, append: bool) -> OutputStream:
    if name == "/dev/null":
        return OutputStream()
    try:
        if not name:
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
        if name.endswith("/"):  # which a Path forgets
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        return FileOutput(path, append=append)
    except OSError as error:
        if path.is_dir():  # which Windows refuses to whoever opens it
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), name) from None
        raise OSError(error.errno, reason(error), name) from None


def forked(streams: Streams) -> Streams:
    """The streams for a job of its own, which has the terminal's keys while it is in front."""
    return Streams(streams.stdin.fork(), streams.stdout, streams.stderr, dict(streams.more))
