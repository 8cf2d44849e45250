"""Variables: declare, typeset, local, readonly, export, unset."""

from __future__ import annotations

import re

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain_as_shell
from day6_core.shell.language.arithmetic import ArithmeticProblem
from day6_core.shell.language.assignments import array_literal, items_of, key_of, split_target
from day6_core.shell.language.control_flow import DiscardLine
from day6_core.shell.language.interpreter import Shell, shell_of
from day6_core.shell.language.quoting import Compound, declared
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.variables import Cell
from day6_core.shell.language.words import SyntaxProblem

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_CHANGEABLE = frozenset("aAilnrux")


def _options(words: list[str], known: str) -> tuple[set[str], set[str], list[str], str]:
    """Return the letters after `-`, those after `+`, the operands, and the first letter that is not one of them."""
    on: set[str] = set()
    off: set[str] = set()
    words = list(words)
    while words and words[0][:1] in ("-", "+") and len(words[0]) > 1:
        word = words.pop(0)
        if word == "--":
            break
        for letter in word[1:]:
            if letter not in known:
                return on, off, words, word[0] + letter
        (on if word[0] == "-" else off).update(word[1:])
    return on, off, words, ""


def _wrong_option(session: Session, option: str) -> int:
    complain_as_shell(session, f"{option}: invalid option")
    return 2


async def declare(session: Session) -> int:
    """`declare [-aAilnruxfFgp] NAME[=value] …`; local in a function, as in bash."""
    shell = shell_of(session)
    on, off, words, wrong = _options(session.argv[1:], "aAfFgilnprux")
    if wrong:
        return _wrong_option(session, wrong)
    if on & {"f", "F"}:
        return _functions(session, on, words)
    if "p" in on or not words:
        return _show(session, on, words, plain="p" not in on and not on)
    is_local = bool(shell.hidden) and "g" not in on
    return await _declare(session, words, on, off, is_local=is_local)


async def local(session: Session) -> int:
    """`local NAME[=value] …` in a function: the old value is restored when the function ends."""
    shell = shell_of(session)
    if not shell.hidden:
        complain_as_shell(session, "can only be used in a function")
        return 1
    on, off, words, wrong = _options(session.argv[1:], "aAgilnprux")
    if wrong:
        return _wrong_option(session, wrong)
    if not words:
        for name in sorted(shell.hidden[-1]):
            if (cell := shell.variables.find(name)) is not None:
                session.print(declared(name, cell) if "p" in on else f"{name}={cell.value or ''}")
        return 0
    return await _declare(session, words, on, off, is_local=True)


async def readonly(session: Session) -> int:
    on, off, words, wrong = _options(session.argv[1:], "aAfp")
    if wrong:
        return _wrong_option(session, wrong)
    if "f" in on:
        return 0 if all(name in shell_of(session).functions for name in words) else 1
    if not words:
        return _show(session, {"r"}, [])
    return await _declare(session, words, (on | {"r"}) - {"p"}, off, is_local=False)


async def export(session: Session) -> int:
    shell = shell_of(session)
    on, off, words, wrong = _options(session.argv[1:], "fnp")
    if wrong:
        return _wrong_option(session, wrong)
    if "f" in on:
        missing = [name for name in words if name not in shell.functions]
        for name in missing:
            complain_as_shell(session, f"{name}: not a function")
        change = shell.exported_functions.difference_update if "n" in on else shell.exported_functions.update
        change(set(words) - set(missing))
        return 1 if missing else 0
    if not words:
        return _show(session, {"x"}, [])
    if "n" in on:
        return await _declare(session, words, set(), {"x"}, is_local=False)
    return await _declare(session, words, {"x"}, off, is_local=False)


async def _declare(session: Session, words: list[str], on: set[str], off: set[str], *, is_local: bool) -> int:
    status = 0
    for word in words:
        try:
            if not await _declare_one(session, word, on, off, is_local=is_local):
                status = 1
        except ArithmeticProblem as problem:
            complain_as_shell(session, problem)
            shell_of(session).wanted[session] = DiscardLine()
            return 1
        except Refused as problem:
            session.print_error(f"{shell_of(session).name}: {problem.told(shell_of(session).variables)}")
            return 2
        except SyntaxProblem as problem:
            complain_as_shell(session, problem)
            status = 1
    return status


async def _declare_one(session: Session, word: str, on: set[str], off: set[str], *, is_local: bool) -> bool:
    """Carry out one argument; False, with a message, if it is invalid. Raises SyntaxProblem."""
    shell = shell_of(session)
    variables = shell.variables
    target = split_target(word)
    name, subscript, append, value = target or (word, None, False, "")
    if target is None and word.endswith("]") and (bracket := word.find("[")) > 0:
        name = word[:bracket]  # `declare a[3]` declares the array
        on = on | {"a"}
    if _NAME.fullmatch(name) is None:
        complain_as_shell(session, f"`{word}': not a valid identifier")
        return False
    if is_local:
        _hide(shell, name)
    if "n" not in on and "n" not in off:
        name = variables.resolved(name)
    cell = variables.cells.get(name)
    if (
        cell is not None
        and "r" in cell.attributes
        and (target is not None or "r" in off or on & {"a", "A"} - cell.attributes)
    ):
        raise SyntaxProblem(f"{name}: readonly variable")
    if cell is None:
        cell = variables.cells[name] = Cell()
    if on & {"a", "A"} and cell.items is None:
        if "A" in on and cell.text is not None:
            cell.text = None
        if name in variables.dynamic:
            variables.dynamic.pop(name)
        had = cell.text
        variables.make_array(cell, keyed="A" in on)
        if had is None and target is None:
            cell.items = {}
    elif ("A" in on) != cell.keyed and on & {"a", "A"}:
        wanted, is_now = ("associative", "indexed") if "A" in on else ("indexed", "associative")
        complain_as_shell(session, f"{name}: cannot convert {is_now} to {wanted} array")
        return False
    for pair in ({"u", "l"},):
        if on & pair:
            cell.attributes -= pair - on
    cell.attributes |= on & _CHANGEABLE - {"a", "A", "r"}
    cell.attributes -= off & _CHANGEABLE
    if target is not None:
        await _give_value(
            session, name, subscript, append, value, is_array=isinstance(word, Compound) or bool(on & {"a", "A"})
        )
    if "r" in on:
        cell = variables.cells[name]
        cell.attributes.add("r")
    return True


async def _give_value(
    session: Session, name: str, subscript: str | None, append: bool, value: str, *, is_array: bool
) -> None:
    shell = shell_of(session)
    streams = shell.all_streams(session)
    variables = shell.variables
    cell = variables.cells[name]
    if is_array and subscript is None and value.startswith("(") and value.endswith(")"):
        items = await items_of(array_literal(value), shell, streams, keyed=cell.keyed)
        variables.assign_array(name, items, append=append)
        return
    if "n" in cell.attributes:
        if value.partition("[")[0] == name:
            raise Refused(f"{session.name} -n {name}={value}")
        cell.text = value
        return
    key = None if subscript is None else await key_of(name, subscript, shell, streams)
    variables.assign(name, value, key=key, append=append)


def _hide(shell: Shell, name: str) -> None:
    """Make a variable of this function, which hides one of the same name."""
    mine = shell.hidden[-1]
    if name in mine:
        return
    before = shell.variables.cells.get(name)
    if before is not None and "r" in before.attributes:
        raise SyntaxProblem(f"{name}: readonly variable")
    mine[name] = before
    shell.variables.cells[name] = Cell(attributes=set(before.attributes & {"x"}) if before is not None else set())


def _show(session: Session, wanted: set[str], names: list[str], *, plain: bool = False) -> int:
    """`declare -p`: lines that would declare the variables again."""
    shell = shell_of(session)
    status = 0
    wanted = wanted & _CHANGEABLE
    for name in names or sorted({*shell.variables.cells, *shell.variables.dynamic}):
        cell = shell.variables.cells.get(name) if name not in shell.variables.dynamic else shell.variables.find(name)
        if cell is None:
            complain_as_shell(session, f"{name}: not found")
            status = 1
        elif names or wanted <= cell.attributes:
            if plain:
                if cell.value is not None or cell.items:
                    session.print(declared(name, Cell(cell.text, cell.items)).removeprefix("declare -- "))
            else:
                session.print(declared(name, cell))
    return status


def _functions(session: Session, options: set[str], names: list[str]) -> int:
    functions = shell_of(session).functions
    status = 0
    for name in names or sorted(functions):
        if name not in functions:
            status = 1
        elif "F" in options:
            session.print(name if names else f"declare -f {name}")
        else:
            session.print(functions[name].source)
    return status


async def unset(session: Session) -> int:
    shell = shell_of(session)
    on, _, words, wrong = _options(session.argv[1:], "fnv")
    if wrong:
        return _wrong_option(session, wrong)
    status = 0
    for word in words:
        try:
            target = split_target(f"{word}=")
            if "f" in on or (target is None and "v" not in on):
                shell.functions.pop(word, None)
            elif target is None:
                complain_as_shell(session, f"`{word}': not a valid identifier")
                status = 1
            else:
                await _unset_one(session, target[0], target[1], on)
        except SyntaxProblem as problem:
            complain_as_shell(session, problem)
            status = 1
    return status


async def _unset_one(session: Session, name: str, subscript: str | None, options: set[str]) -> None:
    shell = shell_of(session)
    variables = shell.variables
    if "n" not in options:
        name = variables.resolved(name)
    if subscript is None:
        if "v" not in options and name not in variables.cells and name not in variables.dynamic:
            shell.functions.pop(name, None)
        variables.unset(name)
    elif subscript in ("@", "*"):
        variables.unset(name)
    else:
        key = await key_of(name, subscript, shell, shell.all_streams(session))
        variables.unset(name, key)
