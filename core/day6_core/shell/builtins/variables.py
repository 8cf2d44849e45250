"""Variables and the shell's own settings: export, local, declare, read, let, alias, set, shopt and their like."""

from __future__ import annotations

import re
import shlex

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain_as_shell
from day6_core.shell.language.arithmetic import ArithmeticProblem, evaluate
from day6_core.shell.language.control_flow import DiscardLine
from day6_core.shell.language.interpreter import shell_of

_SHOPT = ("checkwinsize", "cmdhist", "expand_aliases", "globstar", "histappend", "login_shell", "nullglob", "autocd")


def _assign(session: Session, word: str) -> str | None:
    """Carry out `NAME`, `NAME=value` or `NAME+=value`; return the name, or None, with a message, if it is invalid."""
    shell = shell_of(session)
    name, equals, value = word.partition("=")
    append = name.endswith("+") and bool(equals)
    name = name.removesuffix("+") if append else name
    if not (name.isidentifier() and name.isascii()):
        complain_as_shell(session, f"`{word}': not a valid identifier")
        return None
    if equals:
        shell.variables[name] = shell.variables.get(name, "") + value if append else value
    return name


async def export(session: Session) -> int:
    shell = shell_of(session)
    words = session.argv[1:]
    if not words or words == ["-p"]:
        for name in sorted(shell.exported & shell.variables.keys()):
            session.print(f'declare -x {name}="{shell.variables[name]}"')
        return 0
    if words[0] == "-f":
        return 0  # functions reach the shells that this one starts anyway
    status = 0
    remove = words[0] == "-n"
    for word in words[1:] if remove else words:
        named = _assign(session, word)
        if named is None:
            status = 1
        elif remove:
            shell.exported.discard(named)
        else:
            shell.exported.add(named)
    return status


async def unset(session: Session) -> int:
    shell = shell_of(session)
    functions = "-f" in session.argv[1:]
    for name in session.argv[1:]:
        if name in ("-v", "-f"):
            continue
        if functions or name not in shell.variables:
            shell.functions.pop(name, None)
        else:
            shell.variables.pop(name)
            shell.exported.discard(name)
    return 0


async def local(session: Session) -> int:
    """`local NAME[=value] …` in a function: the old value is restored when the function ends."""
    shell = shell_of(session)
    if not shell.hidden:
        complain_as_shell(session, "can only be used in a function")
        return 1
    status = 0
    for word in session.argv[1:]:
        if word.startswith("-"):
            continue
        name = word.partition("=")[0].removesuffix("+")
        before = shell.variables.get(name)
        if _assign(session, word) is None:
            status = 1
            continue
        shell.hidden[-1].setdefault(name, before)
        if "=" not in word:
            shell.variables[name] = ""
    return status


async def declare(session: Session) -> int:
    """`declare [-xirf] NAME[=value] …`; local in a function, as in bash. `declare -f` shows functions."""
    shell = shell_of(session)
    options = "".join(word[1:] for word in session.argv[1:] if word.startswith("-"))
    words = [word for word in session.argv[1:] if not word.startswith(("-", "+"))]
    if "f" in options or "F" in options:
        return _show_functions(session, words, whole="F" not in options)
    if "p" in options or not words:
        names = words or sorted(shell.variables)
        for name in names:
            if name in shell.variables:
                flag = "-x" if name in shell.exported else "--"
                session.print(f'declare {flag} {name}="{shell.variables[name]}"')
            else:
                complain_as_shell(session, f"{name}: not found")
        return 0 if all(name in shell.variables for name in names) else 1
    if shell.hidden and session.name != "readonly" and "g" not in options:
        status = await local(session)
    else:
        status = sum(_assign(session, word) is None for word in words) and 1
    for word in words:
        name = word.partition("=")[0]
        if "x" in options:
            shell.exported.add(name)
        if "i" in options and name in shell.variables:
            try:
                shell.variables[name] = str(evaluate(shell.variables[name], shell.variables))
            except ArithmeticProblem as problem:
                complain_as_shell(session, str(problem))
                shell.wanted[session] = DiscardLine()
                return 1
    return status


def _show_functions(session: Session, names: list[str], *, whole: bool) -> int:
    functions = shell_of(session).functions
    for name in names or sorted(functions):
        if name not in functions:
            return 1
        session.print(functions[name].source if whole else f"declare -f {name}" if not names else name)
    return 0


async def let(session: Session) -> int:
    """`let EXPRESSION …`: status 0 if the value of the last one is not 0."""
    if len(session.argv) < 2:
        complain_as_shell(session, "expression expected")
        return 1
    value = 0
    for word in session.argv[1:]:
        try:
            value = evaluate(word, shell_of(session).variables)
        except ArithmeticProblem as problem:
            complain_as_shell(session, str(problem))
            return 1
    return 0 if value else 1


async def read(session: Session) -> int:
    """`read [-r] [-s] [-p PROMPT] [NAME …]`; the line is split at the characters of IFS."""
    shell = shell_of(session)
    words = session.argv[1:]
    raw = False
    while words and words[0].startswith("-") and len(words[0]) > 1:
        option = words.pop(0)
        raw = raw or "r" in option
        if option[-1] in "pntd" and words:
            value = words.pop(0)
            if option[-1] == "p" and session.stdin.isatty():
                session.stderr.write(value)
    line = await session.stdin.read_line()
    text = line.removesuffix("\n")
    if not raw:
        text = re.sub(r"\\(.)", r"\1", text)
    names = words or ["REPLY"]
    pieces = _split(text, session.env.get("IFS", shell.variables.get("IFS", " \t\n")), len(names)) if words else [text]
    for index, name in enumerate(names):
        shell.variables[name] = pieces[index] if index < len(pieces) else ""
    return 0 if line.endswith("\n") else 1


def _split(text: str, separators: str, most: int) -> list[str]:
    """Split a line into at most `most` pieces: a run of white space is one separator, any other separator counts each time."""
    blanks = "".join(each for each in separators if each.isspace())
    others = "".join(each for each in separators if not each.isspace())
    text = text.strip(blanks) if blanks else text
    if not separators:
        return [text]
    blank, other = f"[{re.escape(blanks)}]" if blanks else "(?!)", f"[{re.escape(others)}]" if others else "(?!)"
    return re.split(f"{blank}*{other}{blank}*|{blank}+", text, maxsplit=most - 1) if most > 1 else [text]


async def alias(session: Session) -> int:
    shell = shell_of(session)
    status = 0
    words = [word for word in session.argv[1:] if word != "-p"]
    for word in words:
        name, equals, value = word.partition("=")
        if equals:
            shell.aliases[name] = value
        elif name in shell.aliases:
            session.print(f"alias {name}={_quoted(shell.aliases[name])}")
        else:
            complain_as_shell(session, f"{name}: not found")
            status = 1
    if not words:
        for name, text in sorted(shell.aliases.items()):
            session.print(f"alias {name}={_quoted(text)}")
    return status


def _quoted(text: str) -> str:
    return "'" + text.replace("'", "'\\''") + "'"


async def unalias(session: Session) -> int:
    shell = shell_of(session)
    if session.argv[1:] == ["-a"]:
        shell.aliases.clear()
        return 0
    status = 0
    for name in session.argv[1:]:
        if shell.aliases.pop(name, None) is None:
            complain_as_shell(session, f"{name}: not found")
            status = 1
    return status


async def set_(session: Session) -> int:
    shell = shell_of(session)
    words = session.argv[1:]
    if not words:
        for name, value in sorted(shell.variables.items()):
            session.print(f"{name}={shlex.quote(value)}")
    while words and words[0][:1] in "-+" and len(words[0]) > 1:
        option = words.pop(0)
        if option == "--":
            shell.arguments = words
            return 0
        letters = option[1:].replace("o", "")
        if "o" in option and words:
            letters += {"errexit": "e", "xtrace": "x", "nounset": "u"}.get(words.pop(0), "")
        for letter in letters:
            if letter not in "exufhbmBHvn":
                complain_as_shell(session, f"{option}: invalid option")
                return 2
            if option[0] == "-":
                shell.options.add(letter)
            else:
                shell.options.discard(letter)
    if words:
        shell.arguments = words
    return 0


async def shopt(session: Session) -> int:
    """`shopt [-suq] [-o] NAME …`: turns settings on or off, or prints whether they are on."""
    shell = shell_of(session)
    options = "".join(word[1:] for word in session.argv[1:] if word.startswith("-"))
    names = [word for word in session.argv[1:] if not word.startswith("-")]
    if "o" in options:
        return 0 if names and all(name[:1] in shell.options and name in ("errexit", "xtrace") for name in names) else 1
    unknown = [name for name in names if name not in _SHOPT]
    if "s" in options or "u" in options:
        change = shell.settings.update if "s" in options else shell.settings.difference_update
        change(set(names) - set(unknown))
        return 0
    if "q" not in options:
        for name in names or sorted(_SHOPT):
            session.print(f"{name:<15}\t{'on' if name in shell.settings else 'off'}")
    return 0 if all(name in shell.settings for name in names) else 1


async def accepted(session: Session) -> int:
    """`trap`, `umask`, `bind` …: accepted because a .bashrc uses them; they have no effect here."""
    return 0
