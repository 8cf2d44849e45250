"""`$( )`, `<( )` and `>( )`: commands whose output or input becomes part of a line."""

from __future__ import annotations

import os
import tempfile
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.session.streams import CAPTURE_LIMIT, Captured, InputStream, OutputStream, Pipe
from day6_core.shell.language import parser, syntax
from day6_core.shell.language.control_flow import Interrupted
from day6_core.shell.language.jobs import Job
from day6_core.shell.language.redirection import Streams, redirect
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.subshells import subshell_main
from day6_core.shell.language.words import ProcessSubstitution, SyntaxProblem

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell


def _inner(shell: Shell) -> Shell:
    """The copy of a shell that runs a substitution, in which `set -e` does not apply."""
    inner = shell.clone()
    inner.substitutions = shell.substitutions + 1
    if "inherit_errexit" not in shell.settings:
        inner.options.discard("e")
    return inner


async def captured_output(shell: Shell, source: str, streams: Streams) -> str:
    """`$(source)`: what the commands print."""
    captured = Captured()
    inner = _inner(shell)
    inner_streams = Streams(streams.stdin.fork(), captured, streams.stderr, dict(streams.more))

    async def run() -> int:
        if (file := _only_a_file(source, shell)) is not None:
            return await _copied(inner, file, inner_streams)
        return await inner.run(source, inner_streams, first_line=shell.line)

    program = shell.start(["$()"], subshell_main(inner, run, inner_streams), inner_streams)
    job = Job([program], source, inner_streams.stdin)
    await shell.wait_front(job)
    if job.stopped:
        shell.put_aside(job, streams)
        raise Interrupted
    shell.status = shell.substitution_status = job.status
    if job.interrupted:
        raise Interrupted
    if captured.is_cut:
        streams.stderr.write(
            f"{shell.name}: warning: command substitution: more than {CAPTURE_LIMIT >> 20} MB of output, the rest is lost\n"
        )
    text = captured.text
    if "\0" in text:
        streams.stderr.write(f"{shell.name}: warning: command substitution: ignored null byte in input\n")
        text = text.replace("\0", "")
    return text


def _only_a_file(source: str, shell: Shell) -> syntax.Redirection | None:
    """The redirection of `$(< FILE)`; None for anything else."""
    if not source.lstrip().startswith("<"):
        return None
    try:
        items = parser.parse(source, shell.aliases).items
    except SyntaxProblem:
        return None
    commands = [command for item in items for _, pipeline in item.items for command in pipeline.commands]
    command = commands[0] if len(commands) == 1 else None
    if not isinstance(command, syntax.SimpleCommand) or command.words or command.assignments:
        return None
    only = command.redirections[0] if len(command.redirections) == 1 else None
    return only if only is not None and only.operator in ("<", "<<<", "<<") and only.fd in (None, 0) else None


async def _copied(shell: Shell, file: syntax.Redirection, streams: Streams) -> int:
    with ExitStack() as opened:
        try:
            stdin = (await redirect([file], shell, streams, opened)).stdin
        except OSError as error:
            streams.stderr.write(f"{shell.name}: {error.filename}: {error.strerror}\n")
            return 1
        while line := await stdin.read_line():
            streams.stdout.write(line)
            await streams.stdout.drain()
    return 0


async def file_of(shell: Shell, part: ProcessSubstitution, streams: Streams) -> str:
    """`<(source)` as an argument: the path of a file with what the commands print, which goes with the command.

    They have ended before the command begins: other programs read this file, which a pipe in this process could not serve.
    """
    if part.writes:
        raise Refused(f">({part.source})")
    text = await captured_output(shell, part.source, streams)
    number, name = tempfile.mkstemp(prefix="day6-output-")
    with os.fdopen(number, "wb") as file:
        file.write(text.encode("utf-8", "surrogateescape"))
    shell.made_files.append(Path(name))
    return name


def stream_of(
    shell: Shell, part: ProcessSubstitution, streams: Streams, opened: ExitStack
) -> InputStream | OutputStream:
    """`< <(source)` and `> >(source)`: the end of a pipe whose other end a program has that runs meanwhile."""
    pipe = Pipe()
    inner = _inner(shell)
    if part.writes:
        inner_streams = Streams(pipe.reader, streams.stdout, streams.stderr, dict(streams.more))
    else:
        inner_streams = Streams(streams.stdin.fork(), pipe.writer, streams.stderr, dict(streams.more))
    main = subshell_main(inner, lambda: inner.run(part.source, inner_streams, first_line=shell.line), inner_streams)
    program = shell.start([f"{'>' if part.writes else '<'}()"], main, inner_streams)
    program.session.defer(pipe.reader.close if part.writes else pipe.writer.close)
    shell.last_background = program.pid
    if part.writes:
        shell.listeners.append(program)
        opened.callback(pipe.writer.close)
        return pipe.writer
    opened.callback(pipe.reader.close)
    return pipe.reader
