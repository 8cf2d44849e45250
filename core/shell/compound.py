"""Compound commands: `{ }` and `( )`, `if`, `for`, `while` and `until`."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import replace
from typing import TYPE_CHECKING

from day6_tui.core.session.task import let_others_run
from day6_tui.core.shell import syntax
from day6_tui.core.shell.control_flow import LoopControl
from day6_tui.core.shell.expansion import expand
from day6_tui.core.shell.redirection import Streams, redirect

if TYPE_CHECKING:
    from day6_tui.core.shell.interpreter import Shell


async def run_compound(shell: Shell, command: syntax.Command, streams: Streams) -> int:
    """Run one compound command with its redirections in `shell`; returns its status, which is the shell's then too."""
    assert not isinstance(command, syntax.Simple)
    with ExitStack() as opened:
        try:
            streams = await redirect(command.redirections, shell, streams, opened)
        except OSError as error:
            streams.stderr.write(f"{shell.name}: {error.filename}: {error.strerror}\n")
            shell.status = 1
            return 1
        if isinstance(command, syntax.Group):
            await _group(shell, command, streams)
        elif isinstance(command, syntax.If):
            await _if(shell, command, streams)
        else:
            await _loop(shell, command, streams)
    return shell.status


async def _group(shell: Shell, command: syntax.Group, streams: Streams) -> None:
    if not command.subshell:
        await shell.run_tree(command.body, streams)
        return
    inner = shell.clone()
    front = replace(streams, stdin=streams.stdin.fork())
    await shell.run_subshell(inner, lambda: inner.run_tree(command.body, front), front, streams)


async def _if(shell: Shell, command: syntax.If, streams: Streams) -> None:
    for condition, body in command.branches:
        if await _holds(shell, condition, streams):
            await shell.run_tree(body, streams)
            return
    shell.status = 0
    if command.otherwise is not None:
        await shell.run_tree(command.otherwise, streams)


async def _holds(shell: Shell, condition: syntax.Sequence, streams: Streams) -> bool:
    shell.condition_depth += 1
    try:
        return await shell.run_tree(condition, streams) == 0
    finally:
        shell.condition_depth -= 1


async def _loop(shell: Shell, command: syntax.For | syntax.While, streams: Streams) -> None:
    values: list[str] | None = None
    if isinstance(command, syntax.For):
        values = list(shell.arguments) if command.words is None else await expand(command.words, shell, streams)
    status = 0
    while True:
        if isinstance(command, syntax.For):
            if not values:
                break
            shell.variables[command.name] = values.pop(0)
        elif await _holds(shell, command.condition, streams) == command.until:
            break
        await let_others_run()
        try:
            status = await shell.run_tree(command.body, streams)
        except LoopControl as control:
            if control.levels > 1:
                raise LoopControl(control.levels - 1, control.again) from None
            status = 0
            if not control.again:
                break
    shell.status = status
