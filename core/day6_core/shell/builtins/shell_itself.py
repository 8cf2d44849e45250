"""trap, exec, builtin, hash, getopts, let, caller, compgen, umask, ulimit, and what a .bashrc uses that has no effect here."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from day6_core.session.session import Session
from day6_core.session.signals import NUMBERS
from day6_core.shell.builtins.options import UsageError, complain_as_shell, parse
from day6_core.shell.language.arithmetic import ArithmeticProblem, evaluate
from day6_core.shell.language.control_flow import ExitShell
from day6_core.shell.language.interpreter import shell_of
from day6_core.shell.language.quoting import single_quoted
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.traps import SIGNALS, signal_name
from day6_core.shell.language.words import SyntaxProblem


def _refuse(session: Session, what: str) -> int:
    shell = shell_of(session)
    session.print_error(f"{shell.name}: {Refused(what).told(shell.variables)}")
    return 2


async def trap(session: Session) -> int:
    """`trap COMMAND SIGNAL …`, `trap - SIGNAL …`, `trap [-p] [SIGNAL …]`."""
    shell = shell_of(session)
    words = session.argv[1:]
    if words[:1] == ["-l"]:
        session.print(" ".join(f"{number}) SIG{name}" for name, number in NUMBERS.items()))
        return 0
    show = not words or words[0] == "-p"
    words = [word for word in words if word not in ("-p", "--")] if words[:1] in (["-p"], ["--"]) else words
    if show or not words:
        for name in sorted(shell.traps, key=_order):
            if not words or name in map(signal_name, words):
                shown = name if name in ("EXIT", "ERR") else f"SIG{name}"
                session.print(f"trap -- {single_quoted(shell.traps[name])} {shown}")
        return 0
    reset = words[0] == "-" or (len(words) == 1 and signal_name(words[0]) is not None) or words[0].isdigit()
    command, names = words[0], words[1:]
    if reset and command != "-":
        names = words
    if not reset and not names:
        session.print_error("trap: usage: trap [-lp] [[arg] signal_spec ...]")
        return 2
    status = 0
    for word in names:
        found = signal_name(word)
        if found is None:
            complain_as_shell(session, f"{word}: invalid signal specification")
            status = 1
        elif reset:
            shell.traps.pop(found, None)
        elif found not in SIGNALS:
            return _refuse(session, f"trap … {word}")
        else:
            shell.traps[found] = command
    return status


def _order(name: str) -> int:
    return {"EXIT": 0, "ERR": 100}.get(name) or NUMBERS.get(name, 0)


async def exec_(session: Session) -> int:
    """`exec COMMAND …` ends the shell with the command's status; the redirections of `exec` alone are the interpreter's."""
    from day6_core.shell.commands import find_command

    shell = shell_of(session)
    words = session.argv[1:]
    if words[:1] == ["-a"]:
        words = words[2:]
    if words[:1] == ["--"]:
        words = words[1:]
    if not words:
        return 0
    before = dict(shell.traps)
    shell.traps.pop("EXIT", None)
    status = await session.execute(find_command(words[0], shell, functions=False), words)
    if status in (126, 127) and shell.interactive:
        shell.traps.update(before)
        return status
    shell.wanted[session] = ExitShell(status)
    return status


async def builtin(session: Session) -> int:
    from day6_core.shell.commands import SHELL_BUILTINS, find_command

    words = session.argv[1:]
    if not words:
        return 0
    if words[0] not in SHELL_BUILTINS:
        complain_as_shell(session, f"{words[0]}: not a shell builtin")
        return 1
    return await session.execute(find_command(words[0], shell_of(session), functions=False), words)


async def hash_(session: Session) -> int:
    """`hash -r`, `hash NAME …`: programs are looked for anew each time, so there is nothing to remember."""
    from day6_core.shell.commands import where

    status = 0
    for name in session.argv[1:]:
        if not name.startswith("-") and not where(name, shell_of(session)):
            complain_as_shell(session, f"{name}: not found")
            status = 1
    if len(session.argv) == 1:
        session.print("hash: hash table empty")
    return status


async def let(session: Session) -> int:
    """`let EXPRESSION …`: status 0 if the value of the last one is not 0."""
    shell = shell_of(session)
    words = [word for word in session.argv[1:] if word != "--"]
    if not words:
        complain_as_shell(session, "expression expected")
        return 1
    value = 0
    for word in words:
        try:
            value = evaluate(word, shell.variables, unset_is_wrong="u" in shell.options)
        except (ArithmeticProblem, SyntaxProblem) as problem:
            complain_as_shell(session, problem)
            return 1
    return 0 if value else 1


async def getopts(session: Session) -> int:
    """`getopts LETTERS NAME [ARGUMENT …]`: the next option, by OPTIND."""
    shell = shell_of(session)
    variables = shell.variables
    if len(session.argv) < 3:
        session.print_error("getopts: usage: getopts optstring name [arg ...]")
        return 2
    letters, name = session.argv[1:3]
    words = session.argv[3:] or shell.arguments
    silent = letters.startswith(":")
    index = int(variables.get("OPTIND") or 1)
    if index != shell.option_index:
        shell.option_place = 1
    place = shell.option_place
    word = words[index - 1] if 0 < index <= len(words) else ""
    if place == 1 and (not word.startswith("-") or len(word) < 2 or word == "--"):
        index += word == "--"
        return _after(session, name, "?", index, 1, ended=True)
    letter, place = word[place], place + 1
    wrong = letter == ":" or letter not in letters.removeprefix(":")
    takes_value = not wrong and letters[letters.index(letter, silent) + 1 : letters.index(letter, silent) + 2] == ":"
    variables.cells.pop("OPTARG", None)
    if takes_value:
        if place < len(word):
            variables["OPTARG"] = word[place:]
        elif index < len(words):
            variables["OPTARG"] = words[index]
            index += 1
        else:
            if silent:
                variables["OPTARG"] = letter
            else:
                session.print_error(f"{shell.zero}: option requires an argument -- {letter}")
            return _after(session, name, ":" if silent else "?", index + 1, 1)
        return _after(session, name, letter, index + 1, 1)
    if place >= len(word):
        index, place = index + 1, 1
    if wrong:
        if silent:
            variables["OPTARG"] = letter
        elif variables.get("OPTERR", "1") != "0":
            session.print_error(f"{shell.zero}: illegal option -- {letter}")
        letter = "?"
    return _after(session, name, letter, index, place)


def _after(session: Session, name: str, found: str, index: int, place: int, *, ended: bool = False) -> int:
    shell = shell_of(session)
    shell.option_index, shell.option_place = index, place
    shell.variables["OPTIND"] = str(index)
    if ended:
        shell.variables.cells.pop("OPTARG", None)
    shell.variables[name] = found
    return 1 if ended else 0


async def caller(session: Session) -> int:
    """`caller [N]`: from where a function was called."""
    shell = shell_of(session)
    frames = shell.frames()
    at = int(session.argv[1]) if session.argv[1:] and session.argv[1].isdigit() else 0
    if not shell.calls or at + 1 >= len(frames):
        return 1
    line, outer = frames[at].line, frames[at + 1]
    session.print(f"{line} {outer.name} {outer.file}" if session.argv[1:] else f"{line} {outer.file}")
    return 0


async def compgen(session: Session) -> int:
    """`compgen -W WORDS [PREFIX]`, `-f`, `-d`, `-v`, `-A function`, `-b`, `-k`, `-a`, `-c`."""
    from day6_core.shell.builtins.about import KEYWORDS
    from day6_core.shell.commands import SHELL_BUILTINS, command_names
    from day6_core.shell.language.assignments import array_literal, items_of

    shell = shell_of(session)
    try:
        options, operands = parse(session.argv, "abcdefgjksuv", "oAGWFCXPS")
    except UsageError as problem:
        complain_as_shell(session, str(problem).partition("\n")[0])
        return 2
    prefix = operands[0] if operands else ""
    kinds = {"function": "F", "alias": "a", "builtin": "b", "command": "c", "directory": "d", "file": "f", "keyword": "k",
             "variable": "v"}  # fmt: skip
    asked = {kinds.get(options["A"], options["A"])} if "A" in options else set(options) & set("abcdfkv")
    if not asked <= set("abcdfkvF") or set(options) & set("oGFCXPSegjsu"):
        return _refuse(session, "compgen " + " ".join(session.argv[1:]))
    found: list[str] = []
    if "W" in options:
        items = await items_of(array_literal(f"({options['W']})"), shell, shell.all_streams(session), keyed=False)
        found.extend(text for _, text, _ in items)
    lists = {"a": shell.aliases, "b": SHELL_BUILTINS, "k": KEYWORDS, "v": shell.variable_names(), "F": shell.functions}
    for letter, names in lists.items():
        if letter in asked:
            found.extend(sorted(names))
    if "c" in asked:
        found.extend(sorted({*command_names(), *shell.functions, *shell.aliases}))
    if asked & {"f", "d"}:
        folder, slash, start = prefix.rpartition("/")
        entries = sorted(Path(shell.cwd, folder + slash).iterdir()) if Path(shell.cwd, folder + slash).is_dir() else []
        found.extend(folder + slash + entry.name for entry in entries if entry.name.startswith(start)
                     and (start or not entry.name.startswith(".")) and ("f" in asked or entry.is_dir()))  # fmt: skip
    found = [name for name in found if name.startswith(prefix)]
    for name in found:
        session.print(name)
    return 0 if found else 1


async def umask(session: Session) -> int:
    """`umask` prints the mask, which is that of the whole desktop: it can only be set to what it is."""
    words = [word for word in session.argv[1:] if word not in ("-S", "-p")]
    before = os.umask(0o022)
    os.umask(before)
    if words:
        wanted = int(words[0], 8) if words[0].isdigit() and not set(words[0]) & set("89") else None
        return 0 if wanted == before else _refuse(session, f"umask {words[0]}")
    if "-S" in session.argv:
        rights = [("u", before >> 6), ("g", before >> 3), ("o", before)]
        shown = (
            f"{who}={''.join(r for bit, r in ((4, 'r'), (2, 'w'), (1, 'x')) if not mask & bit)}" for who, mask in rights
        )
        session.print(",".join(shown))
    else:
        session.print(f"{'umask ' * ('-p' in session.argv)}{before:04o}")
    return 0


async def ulimit(session: Session) -> int:
    """`ulimit -n` and the like print a limit, which is that of the whole desktop; none can be set."""
    letters = {"n": "NOFILE", "c": "CORE", "t": "CPU", "d": "DATA", "f": "FSIZE", "s": "STACK", "u": "NPROC", "v": "AS"}
    words = session.argv[1:]
    flags = "".join(word[1:] for word in words if word.startswith("-")).translate({ord("S"): None, ord("H"): None})
    if len(flags) > 1 or any(not word.startswith("-") for word in words) or (flags or "f") not in letters:
        return _refuse(session, "ulimit " + " ".join(words))
    if sys.platform == "win32":
        return _refuse(session, "ulimit")
    import resource

    hard = any("H" in word for word in words)
    limit = resource.getrlimit(getattr(resource, f"RLIMIT_{letters[flags or 'f']}"))[hard]
    unit = 1024 if flags in ("s", "v", "d", "", "f") else 1
    session.print("unlimited" if limit == resource.RLIM_INFINITY else limit // unit)
    return 0


async def refused(session: Session) -> int:
    """A built-in of bash that is not there."""
    return _refuse(session, session.name)


async def bind(session: Session) -> int:
    """Keys of readline, which is not the editor of this shell: accepted, because a .bashrc uses it."""
    if not shell_of(session).interactive:
        complain_as_shell(session, "warning: line editing not enabled")
    return 0


async def complete(session: Session) -> int:
    """`complete OPTIONS NAME …` is remembered, and shown by `complete -p`; what Tab completes here is not changed by it."""
    shell = shell_of(session)
    try:
        options, names = parse(session.argv, "abcdefgjksuvprDEI", "oAGWFCXPS", joined="o")
    except UsageError as problem:
        complain_as_shell(session, str(problem).partition("\n")[0])
        return 2
    if "r" in options or ("p" not in options and len(session.argv) > 1):
        flags = [f"-{letter}" for letter in "abcdefgjksuv" if letter in options]
        valued = [(letter, value) for letter in "oAGWPSXFC" for value in options.get(letter, "").splitlines()]
        shown = " ".join([*(f"-o {value}" for letter, value in valued if letter == "o"), *flags,
                          *(f"-{letter} {single_quoted(value) if letter in 'GWPSX' else value}"
                            for letter, value in valued if letter != "o")])  # fmt: skip
        for name in names or list(shell.completions):
            if "r" in options:
                shell.completions.pop(name, None)
            else:
                shell.completions[name] = shown
        return 0
    status = 0
    for name in names or sorted(shell.completions):
        if name in shell.completions:
            session.print(f"complete {shell.completions[name]} {name}")
        else:
            complain_as_shell(session, f"{name}: no completion specification")
            status = 1
    return status


async def accepted(session: Session) -> int:
    """`compopt`: accepted because a .bashrc uses them; they change nothing that can be seen here."""
    return 0
