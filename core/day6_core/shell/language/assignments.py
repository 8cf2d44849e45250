"""Assignments: `name=value`, `name[subscript]+=value`, `name=(…)`, as commands and as arguments of `declare` and the like."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from day6_core.shell.language.lexer import Lexer, single_word
from day6_core.shell.language.quoting import Compound, literal
from day6_core.shell.language.syntax import Assignment
from day6_core.shell.language.words import ArrayLiteral, SyntaxProblem, Text, Word, end_of_subscript

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
LONGEST_VALUE = 16 * 1024 * 1024
"""Characters of a variable. A bash that keeps doubling one ends with this message too, once memory is used up."""

Items = list[tuple[str | None, str, bool]]
"""Elements of an array: a key or None, a value, whether it is appended."""


def assignment(word: Word) -> Assignment | None:
    """Return what a word assigns, None if it is not an assignment."""
    first = word.parts[0] if word.parts else None
    if not isinstance(first, Text) or first.quoted:
        return None
    target = split_target(word.source)
    if target is None:
        return None
    name, subscript, append, rest = target
    last = word.parts[-1]
    if isinstance(last, ArrayLiteral):
        return Assignment(name, subscript, append, last)
    if subscript is not None:
        return Assignment(name, subscript, append, single_word(rest))
    length = len(word.source) - len(rest)
    text = first.text[length:]
    return Assignment(name, None, append, Word((Text(text), *word.parts[1:]) if text else word.parts[1:], rest))


def split_target(source: str) -> tuple[str, str | None, bool, str] | None:
    """Return name, subscript, whether it is `+=`, and the value of a text `name[subscript]=value`; None if it is none."""
    match = _NAME.match(source)
    if match is None:
        return None
    at, subscript = match.end(), None
    if source.startswith("[", at):
        end = end_of_subscript(source, at)
        if end < at + 2:
            return None
        subscript, at = source[at + 1 : end], end + 1
    append = source.startswith("+=", at)
    if not append and not source.startswith("=", at):
        return None
    return match[0], subscript, append, source[at + 1 + append :]


async def key_of(name: str, subscript: str, shell: Shell, streams: Streams) -> str:
    """The key that a subscript means: a text for an associative array, else the value of an expression."""
    from day6_core.shell.language.expansion import expand_text, sum_of

    cell = shell.variables.find(name)
    if cell is not None and cell.keyed:
        return await expand_text(single_word(subscript), shell, streams)
    if not subscript.strip():
        raise SyntaxProblem(f"{name}[{subscript}]: bad array subscript")
    return subscript if subscript.isdigit() and subscript[0] != "0" else str(await sum_of(subscript, shell, streams))


async def items_of(array: ArrayLiteral, shell: Shell, streams: Streams, *, keyed: bool) -> Items:
    """Expand the elements of `(…)`."""
    from day6_core.shell.language.expansion import expand, expand_text, sum_of

    items: Items = []
    if keyed and array.elements and not array.elements[0].source.startswith("["):
        texts = [await expand_text(word, shell, streams) for word in array.elements]
        return [(key, value, False) for key, value in zip(texts[::2], [*texts[1::2], ""], strict=False)]
    for word in array.elements:
        end = end_of_subscript(word.source, 0) if word.source.startswith("[") else -1
        rest = word.source[end + 1 :] if end > 0 else ""
        if not rest.startswith(("=", "+=")):
            items.extend((None, text, False) for text in await expand([word], shell, streams))
            continue
        subscript, extends = word.source[1:end], rest.startswith("+")
        value = await expand_text(single_word(rest[1 + extends :]), shell, streams, assigned=True)
        if keyed:
            key = await expand_text(single_word(subscript), shell, streams)
        else:
            key = str(await sum_of(subscript, shell, streams))
        items.append((key, value, extends))
    return items


async def value_of(assigned: Assignment, shell: Shell, streams: Streams) -> str | Items:
    """Expand the right side."""
    from day6_core.shell.language.expansion import expand_text

    if isinstance(assigned.value, ArrayLiteral):
        if assigned.subscript is not None:
            raise SyntaxProblem(f"{assigned.name}[{assigned.subscript}]: cannot assign list to array member")
        cell = shell.variables.find(assigned.name)
        if cell is None:  # the array is there, and empty, while its elements are expanded
            cell = shell.variables.changeable(assigned.name)
            shell.variables.make_array(cell)
        return await items_of(assigned.value, shell, streams, keyed=cell.keyed)
    return await expand_text(assigned.value, shell, streams, assigned=True)


async def assign(assigned: Assignment, value: str | Items, shell: Shell, streams: Streams) -> None:
    """Carry it out. Raises ReadOnlyProblem and SyntaxProblem."""
    if isinstance(value, list):
        shell.variables.assign_array(assigned.name, value, append=assigned.append)
        return
    key = None
    if assigned.subscript is not None:
        key = await key_of(assigned.name, assigned.subscript, shell, streams)
    shell.variables.assign(assigned.name, value, key=key, append=assigned.append)
    cell = shell.variables.cells.get(assigned.name)
    kept = (cell.value if cell is not None else "") or ""
    if len(kept) > LONGEST_VALUE:
        from day6_core.shell.language.control_flow import ExitShell

        streams.stderr.write(f"{shell.name}: xrealloc: cannot allocate {len(kept)} bytes\n")
        raise ExitShell(2)


async def argument_of(assigned: Assignment, word: Word, shell: Shell, streams: Streams, *, keyed: bool) -> str:
    """An argument of `declare` that is an assignment: one text, of an array a `Compound` with its elements quoted."""
    from day6_core.shell.language.expansion import expand_text

    subscript = "" if assigned.subscript is None else f"[{assigned.subscript}]"
    head = f"{assigned.name}{subscript}{'+' * assigned.append}="
    if isinstance(assigned.value, ArrayLiteral):
        cell = shell.variables.find(assigned.name)
        keyed = keyed or (cell is not None and cell.keyed)
        return Compound(head + literal(await items_of(assigned.value, shell, streams, keyed=keyed)))
    return head + await expand_text(assigned.value, shell, streams, assigned=True)


def array_literal(text: str) -> ArrayLiteral:
    """Read `(…)` again. Raises SyntaxProblem."""
    lexer = Lexer(f"x={text}")
    parts = lexer._word().parts
    if not isinstance(parts[-1], ArrayLiteral):
        raise SyntaxProblem(f"{text}: not an array")
    return parts[-1]
