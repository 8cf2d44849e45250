"""Compound commands: `{ }` and `( )`, `if`, `case`, `for`, `while` and `until`, `[[ ]]`, `(( ))`, and defining a function."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import replace
from typing import TYPE_CHECKING

from day6_core.reason import reason
from day6_core.session.task import let_others_run
from day6_core.shell.language import syntax
from day6_core.shell.language.arithmetic import ArithmeticProblem
from day6_core.shell.language.conditional import holds
from day6_core.shell.language.control_flow import run_body
from day6_core.shell.language.expansion import (
    ExpansionProblem,
    UnboundProblem,
    expand,
    expand_pattern,
    expand_text,
    sum_of,
)
from day6_core.shell.language.menu import run_select
from day6_core.shell.language.redirection import Streams, forked, redirect
from day6_core.shell.language.tracing import trace

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell


async def run_compound(shell: Shell, command: syntax.Command, streams: Streams) -> int:
    """Run one compound command with its redirections in `shell`; returns its status, which becomes the shell's."""
    assert not isinstance(command, syntax.SimpleCommand)
    outer = streams
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
        elif isinstance(command, syntax.Case):
            await _case(shell, command, streams)
        elif isinstance(command, (syntax.Conditional, syntax.Arithmetic)):
            await _conditional(shell, command, streams)
        elif isinstance(command, syntax.Function):
            shell.functions[command.name] = replace(command, file=shell.file)
            shell.status = 0
        else:
            await _loop(shell, command, streams)
        streams.hand_up(outer, command.redirections)
    return shell.status


async def _group(shell: Shell, command: syntax.Group, streams: Streams) -> None:
    if not command.subshell:
        await shell.run_tree(command.body, streams)
        return
    inner = shell.clone()
    front = forked(streams)
    await shell.run_subshell(inner, command.source, lambda: inner.run_tree(command.body, front), front, streams)


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


async def _case(shell: Shell, command: syntax.Case, streams: Streams) -> None:
    await trace(shell, streams, f"case {command.word.source} in")
    text = await expand_text(command.word, shell, streams)
    shell.status = 0
    fallen = found = False
    for patterns, body, end in command.choices:
        if not fallen:
            found = False
            for pattern in patterns:
                if found := (await expand_pattern(pattern, shell, streams)).matches(text):
                    break
        if fallen or found:
            await shell.run_tree(body, streams)
            if end == ";;":
                return
        fallen = (fallen or found) and end == ";&"


async def _conditional(shell: Shell, command: syntax.Conditional | syntax.Arithmetic, streams: Streams) -> None:
    """`[[ … ]]` and `(( … ))`: status 0 if it is true, 1 if not; a condition that cannot be evaluated 2, a sum 1."""
    if isinstance(command, syntax.Arithmetic):
        await trace(shell, streams, f"(( {command.source.strip()} ))")
        shell.status = 0 if await _sum(command.source, shell, streams) else 1
        return
    try:
        answer = await holds(command.condition, shell, streams)
    except (OSError, ValueError) as error:
        streams.stderr.write(f"{shell.name}: [[: {reason(error)}\n")
        shell.status = 1 if isinstance(error, ArithmeticProblem) else 2
        return
    shell.status = 0 if answer else 1


async def _sum(source: str, shell: Shell, streams: Streams) -> int | None:
    """The value of an expression in `(( ))`, None after a message if it has none."""
    try:
        return await sum_of(source, shell, streams)
    except UnboundProblem:
        raise
    except ExpansionProblem as problem:
        streams.stderr.write(f"{shell.name}: ((: {problem}\n")
        return None


async def _loop(shell: Shell, command: syntax.For | syntax.While | syntax.ArithmeticFor, streams: Streams) -> None:
    if isinstance(command, syntax.ArithmeticFor) and await _sum(command.first, shell, streams) is None:
        shell.status = 1
        return
    values: list[str] | None = None
    if isinstance(command, syntax.For):
        values = list(shell.arguments) if command.words is None else await expand(command.words, shell, streams)
        if command.asks:
            await run_select(shell, command, values, streams)
            return
    status = 0
    again = False
    while True:
        if isinstance(command, syntax.ArithmeticFor):
            if again and await _sum(command.step, shell, streams) is None:
                status = 1
                break
            again = True
            holding = await _sum(command.condition, shell, streams) if command.condition.strip() else 1
            if not holding:
                status = 1 if holding is None else status
                break
        elif isinstance(command, syntax.For):
            if not values:
                break
            listed = " ".join(word.source for word in command.words) if command.words is not None else '"$@"'
            await trace(shell, streams, f"for {command.name} in {listed}")
            shell.variables.assign(command.name, values.pop(0))
        elif await _holds(shell, command.condition, streams) == command.until:
            break
        await let_others_run()
        status, goes_on = await run_body(shell, command.body, streams)
        if not goes_on:
            break
    shell.status = status
