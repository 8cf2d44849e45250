"""Where a command reads and writes: `<` `>` `>>` `2>&1` `&>` here-documents."""

from __future__ import annotations

import errno
import os
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.session.streams import FileInput, FileOutput, InputStream, OutputStream, TextInput
from day6_core.shell.language import syntax
from day6_core.shell.language.expansion import expand_text
from day6_core.shell.outside import agreed, is_outside, keys_of
from day6_core.shell.own_streams import Table, own_input, own_output

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell


@dataclass(frozen=True)
class Streams:
    """Where a command reads and writes."""

    stdin: InputStream
    stdout: OutputStream
    stderr: OutputStream


async def redirect(
    redirections: list[syntax.Redirection], shell: Shell, streams: Streams, opened: ExitStack
) -> Streams:
    """Return `streams` with the redirections applied; files are closed with `opened`. Raises OSError with the name in it."""
    table: dict[int, InputStream | OutputStream] = {0: streams.stdin, 1: streams.stdout, 2: streams.stderr}
    for redirection in redirections:
        operator = redirection.operator
        word = redirection.document[0] if redirection.document else redirection.target
        target = await expand_text(word, shell, streams)
        fd = redirection.fd if redirection.fd is not None else (0 if operator.startswith("<") else 1)
        stream: InputStream | OutputStream
        if operator in ("<<", "<<-"):
            stream = TextInput(target)
        elif operator == "<<<":
            stream = TextInput(target + "\n")
        elif operator in (">&", "<&") and (target.isdigit() or target == "-"):
            if target == "-":
                stream = InputStream() if fd == 0 else OutputStream()
            elif int(target) in table:
                stream = table[int(target)]
            else:
                raise OSError(9, "Bad file descriptor", target)
        elif operator == "<":
            own = _own_input(shell.cwd / target, target, table)
            stream = own or _open_input(shell.cwd / target, target)
            if own is None:
                opened.callback(stream.close)
        else:
            path = shell.cwd / target
            mine = _own_output(path, target, table)
            if mine is None and not await _may_write(path, shell, streams):
                raise OSError(errno.ECANCELED, "not changed", target)
            stream = mine or _open_output(path, target, append=operator in (">>", "&>>"))
            if mine is None:
                opened.callback(stream.close)
        table[fd] = stream
        if operator in ("&>", "&>>") or (operator == ">&" and redirection.fd is None and not target.isdigit()):
            table[2] = stream
    stdin, stdout, stderr = table[0], table[1], table[2]
    if (
        not isinstance(stdin, InputStream)
        or not isinstance(stdout, OutputStream)
        or not isinstance(stderr, OutputStream)
    ):
        raise OSError(9, "Bad file descriptor", str(fd))
    return Streams(stdin, stdout, stderr)


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
        raise OSError(error.errno, error.strerror, name) from None


def _open_output(path: Path, name: str, *, append: bool) -> OutputStream:
    if name == "/dev/null":
        return OutputStream()
    try:
        if name.endswith("/"):  # which a Path forgets
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        return FileOutput(path, append=append)
    except OSError as error:
        raise OSError(error.errno, error.strerror, name) from None
