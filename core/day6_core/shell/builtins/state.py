"""Built-ins that change the shell itself: directories, history, control flow, sourcing. See `variables` for its variables."""

from __future__ import annotations

import os
from pathlib import Path

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain_as_shell, reason
from day6_core.shell.builtins.text import text_named
from day6_core.shell.language.control_flow import ExitShell, LoopControl, ReturnFromSource
from day6_core.shell.language.functions import in_the_shell_itself
from day6_core.shell.language.interpreter import shell_of
from day6_core.shell.system_files import TEXTS


async def cd(session: Session) -> int:
    shell = shell_of(session)
    operands = [word for word in session.argv[1:] if word not in ("-L", "-P", "--")]
    if len(operands) > 1:
        complain_as_shell(session, "too many arguments")
        return 1
    target = operands[0] if operands else shell.variables.get("HOME", "")
    if target == "-":
        target = shell.variables.get("OLDPWD", "")
        if not target:
            complain_as_shell(session, "OLDPWD not set")
            return 1
        session.print(target)
    if not target:
        if not operands:
            complain_as_shell(session, "HOME not set")
            return 1
        target = "."
    # As a shell does it: `..` is taken off the text, symbolic links are kept.
    path = Path(os.path.normpath(shell.cwd / target))
    try:
        if not path.is_dir():
            os.stat(path)
            raise NotADirectoryError(20, "Not a directory")
        os.scandir(path).close()
    except OSError as error:
        complain_as_shell(session, f"{target}: {reason(error)}")
        return 1
    shell.variables["OLDPWD"] = str(shell.cwd)
    shell.variables["PWD"] = str(path)
    shell.exported.update(("OLDPWD", "PWD"))
    shell.cwd = path
    return 0


async def pwd(session: Session) -> int:
    session.print(shell_of(session).cwd)
    return 0


async def shift(session: Session) -> int:
    shell = shell_of(session)
    count = int(session.argv[1]) if len(session.argv) > 1 and session.argv[1].isdigit() else 1
    if count > len(shell.arguments):
        return 1
    shell.arguments = shell.arguments[count:]
    return 0


def _number(session: Session, default: int) -> int | None:
    """Return the numeric argument of exit, break and the like; None, with a message, if it isn't a number."""
    if len(session.argv) < 2:
        return default
    try:
        return int(session.argv[1])
    except ValueError:
        complain_as_shell(session, f"{session.argv[1]}: numeric argument required")
        return None


async def exit_(session: Session) -> int:
    number = _number(session, shell_of(session).status)
    status = 2 if number is None else number & 0xFF
    if shell_of(session).interactive and session.name == "exit":
        session.stderr.write("exit\n")
    shell_of(session).wanted[session] = ExitShell(status)
    return status


async def break_(session: Session) -> int:
    shell_of(session).wanted[session] = LoopControl(max(_number(session, 1) or 1, 1), again=session.name == "continue")
    return 0


async def return_(session: Session) -> int:
    number = _number(session, shell_of(session).status)
    status = 2 if number is None else number & 0xFF
    shell_of(session).wanted[session] = ReturnFromSource(status)
    return status


async def source(session: Session) -> int:
    shell = shell_of(session)
    if len(session.argv) < 2:
        complain_as_shell(session, "filename argument required")
        session.print_error(f"{session.name}: usage: {session.name} filename [arguments]")
        return 2
    name = session.argv[1]
    if _sourced_setup(session, name):
        return 0
    path = shell.cwd / name
    try:
        text = TEXTS[path.as_posix()] if path.as_posix() in TEXTS else await text_named(session, name)
    except OSError as error:
        if isinstance(error, IsADirectoryError):
            complain_as_shell(session, f"{name}: is a directory")
        else:
            session.print_error(f"{shell.name}: {name}: {reason(error)}")
        return 1
    before = shell.arguments
    if session.argv[2:]:
        shell.arguments = session.argv[2:]
    try:
        return await _run_here(session, text)
    finally:
        shell.arguments = before


def _sourced_setup(session: Session, name: str) -> bool:
    """Source the setup script of a workspace or of ROS; return False if `name` isn't one or is missing."""
    from day6_core.workspace.sourcing import import_interfaces, source_setup

    shell = shell_of(session)
    try:
        changed = source_setup(Path(os.path.normpath(shell.cwd / name)), shell.environment)
    except (OSError, ValueError):
        return False
    if changed is None:
        return False
    shell.variables.update(changed)
    shell.exported.update(changed)
    import_interfaces(changed)
    return True


async def eval_(session: Session) -> int:
    return await _run_here(session, " ".join(session.argv[1:]))


async def _run_here(session: Session, text: str) -> int:
    """Run command lines in the shell itself, on this command's streams."""
    shell = shell_of(session)
    return await in_the_shell_itself(
        session, lambda streams: shell.run(text, streams), "maximum nesting level exceeded"
    )


async def history(session: Session) -> int:
    shell = shell_of(session)
    if session.argv[1:] == ["-c"]:
        shell.history.clear()
        return 0
    count = len(shell.history)
    if len(session.argv) > 1:
        if not session.argv[1].isdigit():
            complain_as_shell(session, f"{session.argv[1]}: numeric argument required")
            return 1
        count = int(session.argv[1])
    first = max(len(shell.history) - count, 0)
    for number, line in enumerate(shell.history[first:], first + 1):
        session.print(f"{number:>5}  {line}")
    return 0
