"""Pipelines: each command in a copy of the shell, writing into the next; and `time`."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import TYPE_CHECKING

from day6_core.session.program import Program
from day6_core.session.session import Main, Session
from day6_core.session.streams import Pipe
from day6_core.shell.language import syntax
from day6_core.shell.language.compound import run_compound
from day6_core.shell.language.control_flow import ExitShell
from day6_core.shell.language.failures import report
from day6_core.shell.language.parameters import UnboundProblem
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.simple import prepare
from day6_core.shell.language.subshells import subshell_main
from day6_core.shell.language.variables import Cell
from day6_core.shell.language.words import SyntaxProblem

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell


async def run_timed(shell: Shell, node: syntax.Pipeline, streams: Streams) -> None:
    """`time …`: how long it really took, and what the processor did meanwhile."""
    began, before = shell.desk.clock.wall_ns(), os.times()
    try:
        await shell.run_pipeline(replace(node, timed=""), streams)
    finally:
        after = os.times()
        user = after.user + after.children_user - before.user - before.children_user
        system = after.system + after.children_system - before.system - before.children_system
        seconds = (shell.desk.clock.wall_ns() - began) / 1e9
        streams.stderr.write("" if node.timed == "-p" else "\n")
        for name, value in (("real", seconds), ("user", max(0.0, user)), ("sys", max(0.0, system))):
            long = f"{name}\t{int(value // 60)}m{value % 60:.3f}s\n"
            streams.stderr.write(f"{name} {value:.2f}\n" if node.timed == "-p" else long)


def start_stages(shell: Shell, node: syntax.Pipeline, streams: Streams) -> list[Program]:
    """Start every command of a pipeline in a copy of the shell, each writing into the next."""
    programs: list[Program] = []
    stdin = streams.stdin
    for index, command in enumerate(node.commands):
        last = index == len(node.commands) - 1
        pipe = None if last else Pipe()
        stdout = streams.stdout if pipe is None else pipe.writer
        stage = Streams(stdin, stdout, streams.stderr, dict(streams.more))
        try:
            program = shell.start([node.source], _stage_main(shell, command, stage), stage)
        except (
            SyntaxProblem
        ):  # too many programs: those already started would be in no job, and Ctrl-C would not reach them
            for started in programs:
                started.kill()
            raise
        if index:
            program.session.defer(stdin.close)
        if pipe is not None:
            program.session.defer(pipe.writer.close)
            stdin = pipe.reader
        programs.append(program)
    return programs


def _stage_main(shell: Shell, command: syntax.Command, streams: Streams) -> Main:
    inner = shell.clone()
    if not isinstance(command, syntax.SimpleCommand):
        return subshell_main(inner, lambda: run_compound(inner, command, streams), streams)

    async def become(session: Session) -> int:
        try:
            prepared = await prepare(inner, command, streams)
        except SyntaxProblem as problem:
            report(inner, problem, streams)
            return shell.unbound_status if isinstance(problem, UnboundProblem) else 1
        if prepared is None:
            return 1
        session.host = inner
        inner.program = session
        session.env = prepared.env
        session.cwd = inner.cwd
        session.stdin, session.stdout, session.stderr = (
            prepared.streams.stdin,
            prepared.streams.stdout,
            prepared.streams.stderr,
        )
        inner.streams_of[session] = prepared.streams
        session.defer(prepared.opened.close)
        status = await session.execute(prepared.main, prepared.argv)
        end = inner.wanted.pop(session, None)
        return end.status if isinstance(end, ExitShell) else status

    return become


def take_statuses(shell: Shell, statuses: list[int]) -> None:
    """Set PIPESTATUS and, for `set -o pipefail`, the status."""
    cell = shell.variables.cells.setdefault("PIPESTATUS", Cell(attributes={"a"}))
    cell.items = {str(at): str(status) for at, status in enumerate(statuses)}
    if "pipefail" in shell.options and len(statuses) > 1 and (failed := [status for status in statuses if status]):
        shell.status = failed[-1]
