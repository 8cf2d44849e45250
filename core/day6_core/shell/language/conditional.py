"""`[[ … ]]`: patterns and regular expressions; words in it are neither split nor globbed. See `condition_grammar`."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.session.task import in_turns
from day6_core.shell.language import file_tests
from day6_core.shell.language.arithmetic import evaluate
from day6_core.shell.language.assignments import key_of
from day6_core.shell.language.expansion import expand_pattern, expand_regular, expand_text
from day6_core.shell.language.quoting import traced
from day6_core.shell.language.settings import NAMED_OPTIONS
from day6_core.shell.language.syntax import AndOrCondition, Condition, Not, Test
from day6_core.shell.language.tracing import trace
from day6_core.shell.language.variables import Cell
from day6_core.user_pattern import user_pattern

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams


async def holds(condition: Condition, shell: Shell, streams: Streams) -> bool:
    """Whether the condition is true. Raises ValueError and OSError (bash's texts) if it cannot be evaluated."""
    if isinstance(condition, Not):
        return not await holds(condition.inner, shell, streams)
    if isinstance(condition, AndOrCondition):
        left = await holds(condition.left, shell, streams)
        return left if left == (condition.operator == "||") else await holds(condition.right, shell, streams)
    operator, operands = condition.operator, condition.operands
    left_text = await expand_text(operands[0], shell, streams)
    if "x" in shell.options:
        await trace(shell, streams, await _shown(condition, left_text, shell, streams))
    if not operator:
        return bool(left_text)
    if len(operands) == 1:
        return await shell_test(operator, left_text, shell, streams, shell.cwd)
    if operator == "=~":
        try:
            pattern = await expand_regular(operands[1], shell, streams)
        except re.error as error:
            raise ValueError(f"{operands[1].source}: {error}") from None
        return await _matches(shell, left_text, pattern)
    if operator in ("=", "==", "!="):
        wanted = await expand_pattern(operands[1], shell, streams)
        return wanted.matches(left_text) != (operator == "!=")
    right = await expand_text(operands[1], shell, streams)
    if operator in ("<", ">"):
        return left_text < right if operator == "<" else left_text > right
    if operator in file_tests.FILES:
        return file_tests.files(left_text, operator, right, shell.cwd)
    values = [evaluate(text, shell.variables, unset_is_wrong="u" in shell.options) for text in (left_text, right)]
    return file_tests.INTEGER[operator](values[0], values[1])


async def _shown(test: Test, left: str, shell: Shell, streams: Streams) -> str:
    """The test as `set -x` shows it."""
    first = traced(left) if left else "''"
    if len(test.operands) == 1:
        return f"[[ {test.operator or '-n'} {first} ]]"
    right = await expand_text(test.operands[1], shell, streams)
    return f"[[ {first} {test.operator} {right} ]]"


async def is_set(name: str, shell: Shell, streams: Streams) -> bool:
    """`-v NAME`, `-v NAME[KEY]`."""
    base, bracket, subscript = name.partition("[")
    if not bracket or not subscript.endswith("]"):
        cell = shell.variables.find(name)
        return shell.parameter(name) is not None and (cell is None or cell.items is None or "0" in cell.items)
    if subscript[:-1] in ("@", "*"):
        cell = shell.variables.find(base)
        return cell is not None and bool(cell.values())
    return shell.variables.element(base, await key_of(base, subscript[:-1], shell, streams)) is not None


async def shell_test(question: str, text: str, shell: Shell, streams: Streams, cwd: Path) -> bool:
    """A test of one operand: `-v NAME`, `-o OPTION`, `-t DESCRIPTOR`, or one of a text or a file."""
    if question == "-v":
        return await is_set(text, shell, streams)
    if question == "-o":
        return NAMED_OPTIONS.get(text, "none") in shell.options
    if question == "-R":
        cell = shell.variables.cells.get(text)
        return cell is not None and "n" in cell.attributes
    if question == "-t":
        stream = streams.table.get(int(text)) if text.isdigit() else None
        return stream is not None and stream.isatty()
    return file_tests.unary(question, text, cwd)


async def _matches(shell: Shell, text: str, pattern: str) -> bool:
    """Search a regular expression; the match and its groups become the array BASH_REMATCH."""
    try:
        flags = "(?i)" if "nocasematch" in shell.settings else ""
        match = await in_turns(user_pattern(flags + pattern).searching(text))
    except re.error as error:
        raise ValueError(f"{pattern}: {error}") from None
    groups = [] if match is None else [match[at] or "" for at in range(len(match.spans) // 2)]
    shell.variables.cells["BASH_REMATCH"] = Cell(
        items={str(at): each for at, each in enumerate(groups)}, attributes={"a"}
    )
    return match is not None
