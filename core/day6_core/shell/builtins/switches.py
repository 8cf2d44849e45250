"""The shell's own settings: set, shopt, alias, unalias."""

from __future__ import annotations

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain_as_shell
from day6_core.shell.language.interpreter import Shell, shell_of
from day6_core.shell.language.quoting import array_text, listed, single_quoted
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.settings import NAMED_OPTIONS, OBEYED, OBEYED_SETTINGS, SHOPT

_SINGLE = frozenset(letter for letter in NAMED_OPTIONS.values() if len(letter) == 1)


async def set_(session: Session) -> int:
    shell = shell_of(session)
    words = session.argv[1:]
    if not words:
        _list_variables(session)
        return 0
    while words and words[0][:1] in ("-", "+") and words[0] not in ("-", "+"):
        option = words.pop(0)
        if option == "--":
            shell.arguments = words
            return 0
        for letter in option[1:]:
            if letter == "o" and not words:
                _list_options(session, as_commands=option[0] == "+")
                return 0
            name = NAMED_OPTIONS.get(words[0]) if letter == "o" else letter if letter in _SINGLE else None
            if name is None:
                wrong = f"{words[0]}: invalid option name" if letter == "o" else f"{option[0]}{letter}: invalid option"
                complain_as_shell(session, wrong)
                return 2
            if letter == "o":
                words.pop(0)
            if not _switch(session, name, on=option[0] == "-"):
                return 2
    if words and words[0] in ("-", "+"):
        words.pop(0)
        shell.options -= {"x", "v"}
        if not words:
            return 0
    if words:
        shell.arguments = words
    return 0


def _switch(session: Session, name: str, *, on: bool) -> bool:
    shell = shell_of(session)
    if not on:
        shell.options.discard(name)
    elif name in OBEYED:
        shell.options.add(name)
    else:
        session.print_error(f"{shell.name}: {Refused(f'set -{name}').told(shell.variables)}")
        return False
    return True


def _list_variables(session: Session) -> None:
    shell = shell_of(session)
    for name in sorted({*shell.variables.cells, *shell.variables.dynamic}):
        cell = shell.variables.find(name)
        if cell is not None and cell.items is not None:
            session.print(f"{name}={array_text(cell)}")
        elif cell is not None and cell.text is not None:
            session.print(f"{name}={listed(cell.text)}")
    for name in sorted(shell.functions):
        session.print(shell.functions[name].source)


def _list_options(session: Session, *, as_commands: bool) -> None:
    shell = shell_of(session)
    for name, letter in NAMED_OPTIONS.items():
        on = letter in shell.options
        session.print(f"set {'-' if on else '+'}o {name}" if as_commands else f"{name:<15}\t{'on' if on else 'off'}")


async def shopt(session: Session) -> int:
    """`shopt [-suqpo] NAME …`: turns settings on or off, or prints whether they are on."""
    shell = shell_of(session)
    options = "".join(word[1:] for word in session.argv[1:] if word.startswith("-"))
    names = [word for word in session.argv[1:] if not word.startswith("-")]
    if wrong := [letter for letter in options if letter not in "suqpo"]:
        complain_as_shell(session, f"-{wrong[0]}: invalid option")
        return 2
    known = list(NAMED_OPTIONS) if "o" in options else SHOPT
    status = 0
    for name in names:
        if name not in known:
            complain_as_shell(session, f"{name}: invalid {'option' if 'o' in options else 'shell option'} name")
            status = 1
        elif "s" in options or "u" in options:
            status = status or _change(session, name, on="s" in options, of_set="o" in options)
    if names and ("s" in options or "u" in options):
        return status
    shown = [name for name in (names or known) if name in known]
    on = {
        name for name in shown if (NAMED_OPTIONS[name] in shell.options if "o" in options else name in shell.settings)
    }
    for name in shown:
        if "q" not in options and (not ("s" in options or "u" in options) or (name in on) == ("s" in options)):
            session.print(_line(name, name in on, options))
    return status or (0 if not names or on == set(shown) else 1)


def _line(name: str, on: bool, options: str) -> str:
    if "p" not in options:
        return f"{name:<15}\t{'on' if on else 'off'}"
    return f"set {'-' if on else '+'}o {name}" if "o" in options else f"shopt -{'s' if on else 'u'} {name}"


def _change(session: Session, name: str, *, on: bool, of_set: bool) -> int:
    shell: Shell = shell_of(session)
    if of_set:
        return 0 if _switch(session, NAMED_OPTIONS[name], on=on) else 1
    if on and name not in OBEYED_SETTINGS:
        session.print_error(f"{shell.name}: {Refused(f'shopt -s {name}').told(shell.variables)}")
        return 1
    (shell.settings.add if on else shell.settings.discard)(name)
    return 0


async def alias(session: Session) -> int:
    shell = shell_of(session)
    status = 0
    words = [word for word in session.argv[1:] if word != "-p"]
    for word in words:
        name, equals, value = word.partition("=")
        if equals and name:
            shell.aliases[name] = value
        elif name in shell.aliases:
            session.print(f"alias {name}={single_quoted(shell.aliases[name])}")
        else:
            complain_as_shell(session, f"{name}: not found")
            status = 1
    if not words:
        for name, text in sorted(shell.aliases.items()):
            session.print(f"alias {name}={single_quoted(text)}")
    return status


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
