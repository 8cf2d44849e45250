"""What changes the shell itself: directories, variables, history, control flow, sourcing."""

from __future__ import annotations

import os
import shlex
from pathlib import Path

from day6_tui.core.session.session import Main, Session
from day6_tui.core.shell.builtins.options import reason
from day6_tui.core.shell.control_flow import ExitShell, Interrupted, LoopControl, ReturnFromSource
from day6_tui.core.shell.interpreter import Shell
from day6_tui.core.shell.redirection import Streams


def _complain(session: Session, text: object) -> None:
    session.print_error(f"{session.shell.name}: {session.name}: {text}")


async def cd(session: Session) -> int:
    shell: Shell = session.shell
    operands = [word for word in session.argv[1:] if word not in ("-L", "-P", "--")]
    if len(operands) > 1:
        _complain(session, "too many arguments")
        return 1
    target = operands[0] if operands else shell.variables.get("HOME", "")
    if target == "-":
        target = shell.variables.get("OLDPWD", "")
        if not target:
            _complain(session, "OLDPWD not set")
            return 1
        session.print(target)
    if not target:
        if operands:
            return 0
        _complain(session, "HOME not set")
        return 1
    # As a shell does it: `..` is taken off the text, symbolic links are kept.
    path = Path(os.path.normpath(shell.cwd / target))
    try:
        if not path.is_dir():
            os.stat(path)
            raise NotADirectoryError(20, "Not a directory")
        os.scandir(path).close()
    except OSError as error:
        _complain(session, f"{target}: {reason(error)}")
        return 1
    shell.variables["OLDPWD"] = str(shell.cwd)
    shell.variables["PWD"] = str(path)
    shell.exported.update(("OLDPWD", "PWD"))
    shell.cwd = path
    return 0


async def pwd(session: Session) -> int:
    session.print(session.shell.cwd)
    return 0


async def export(session: Session) -> int:
    shell: Shell = session.shell
    words = session.argv[1:]
    if not words or words == ["-p"]:
        for name in sorted(shell.exported & shell.variables.keys()):
            session.print(f'declare -x {name}="{shell.variables[name]}"')
        return 0
    status = 0
    remove = words[0] == "-n"
    for word in words[1:] if remove else words:
        name, equals, value = word.partition("=")
        append = name.endswith("+")
        name = name.removesuffix("+") if append else name
        if not name.isidentifier():
            _complain(session, f"`{word}': not a valid identifier")
            status = 1
            continue
        if equals:
            shell.variables[name] = shell.variables.get(name, "") + value if append else value
        if remove:
            shell.exported.discard(name)
        else:
            shell.exported.add(name)
    return status


async def unset(session: Session) -> int:
    shell: Shell = session.shell
    for name in session.argv[1:]:
        if name not in ("-v", "-f"):
            shell.variables.pop(name, None)
            shell.exported.discard(name)
    return 0


async def set_(session: Session) -> int:
    shell: Shell = session.shell
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
            letters += {"errexit": "e", "xtrace": "x"}.get(words.pop(0), "")
        for letter in letters:
            if letter not in "exuf":
                _complain(session, f"{option}: invalid option")
                return 2
            if option[0] == "-":
                shell.options.add(letter)
            else:
                shell.options.discard(letter)
    if words:
        shell.arguments = words
    return 0


async def shift(session: Session) -> int:
    shell: Shell = session.shell
    count = int(session.argv[1]) if len(session.argv) > 1 and session.argv[1].isdigit() else 1
    if count > len(shell.arguments):
        return 1
    shell.arguments = shell.arguments[count:]
    return 0


async def read(session: Session) -> int:
    """`read [-r] [-p PROMPT] [NAME …]`."""
    shell: Shell = session.shell
    words = [word for word in session.argv[1:] if word != "-r"]
    if len(words) > 1 and words[0] == "-p":
        session.stderr.write(words[1])
        words = words[2:]
    line = await session.stdin.read_line()
    names = words or ["REPLY"]
    pieces = line.strip().split(None, len(names) - 1)
    for index, name in enumerate(names):
        shell.variables[name] = pieces[index] if index < len(pieces) else ""
    return 0 if line else 1


def _number(session: Session, default: int) -> int | None:
    """The numeric argument of exit, break and their like; None (and a message) if it is none."""
    if len(session.argv) < 2:
        return default
    try:
        return int(session.argv[1])
    except ValueError:
        _complain(session, f"{session.argv[1]}: numeric argument required")
        return None


async def exit_(session: Session) -> int:
    number = _number(session, session.shell.status)
    status = 2 if number is None else number & 0xFF
    if session.shell.interactive and session.name == "exit":
        session.stderr.write("exit\n")
    session.shell_end = ExitShell(status)
    return status


async def break_(session: Session) -> int:
    session.shell_end = LoopControl(max(_number(session, 1) or 1, 1), again=session.name == "continue")
    return 0


async def return_(session: Session) -> int:
    number = _number(session, session.shell.status)
    status = 2 if number is None else number & 0xFF
    session.shell_end = ReturnFromSource(status)
    return status


async def source(session: Session) -> int:
    shell: Shell = session.shell
    if len(session.argv) < 2:
        _complain(session, "filename argument required")
        session.print_error(f"{session.name}: usage: {session.name} filename [arguments]")
        return 2
    name = session.argv[1]
    if _sourced_setup(session, name):
        return 0
    try:
        text = (shell.cwd / name).read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        if isinstance(error, IsADirectoryError):
            _complain(session, f"{name}: is a directory")
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
    """Source the setup script of a workspace or of ROS; False if `name` is none (or is missing: then the caller says so)."""
    from day6_tui.core.workspace.sourcing import make_known, source_setup

    shell: Shell = session.shell
    try:
        changed = source_setup(Path(os.path.normpath(shell.cwd / name)), shell.environment)
    except (OSError, ValueError):
        return False
    if changed is None:
        return False
    shell.variables.update(changed)
    shell.exported.update(changed)
    make_known(changed)
    return True


async def eval_(session: Session) -> int:
    return await _run_here(session, " ".join(session.argv[1:]))


async def _run_here(session: Session, text: str) -> int:
    """Run command lines in the shell itself, on this command's streams."""
    from day6_tui.core.shell.shell_state import MAX_DEPTH

    shell: Shell = session.shell
    if shell.depth >= MAX_DEPTH:
        _complain(session, f"maximum nesting level exceeded ({MAX_DEPTH})")
        return 1
    shell.depth += 1
    shell.status = 0
    try:
        return await shell.run(text, Streams(session.stdin, session.stdout, session.stderr))
    except ReturnFromSource as end:
        return end.status
    except (ExitShell, LoopControl, Interrupted) as end:
        session.shell_end = end
        return shell.status
    finally:
        shell.depth -= 1


async def history(session: Session) -> int:
    shell: Shell = session.shell
    if session.argv[1:] == ["-c"]:
        shell.history.clear()
        return 0
    count = len(shell.history)
    if len(session.argv) > 1:
        if not session.argv[1].isdigit():
            _complain(session, f"{session.argv[1]}: numeric argument required")
            return 1
        count = int(session.argv[1])
    first = max(len(shell.history) - count, 0)
    for number, line in enumerate(shell.history[first:], first + 1):
        session.print(f"{number:>5}  {line}")
    return 0


async def alias(session: Session) -> int:
    shell: Shell = session.shell
    status = 0
    for word in session.argv[1:]:
        name, equals, value = word.partition("=")
        if equals:
            shell.aliases = {**shell.aliases, name: value.split()}
        elif name in shell.aliases:
            session.print(f"alias {name}='{' '.join(shell.aliases[name])}'")
        else:
            _complain(session, f"{name}: not found")
            status = 1
    if len(session.argv) == 1:
        for name, words in sorted(shell.aliases.items()):
            session.print(f"alias {name}='{' '.join(words)}'")
    return status


COMMANDS: dict[str, Main] = {
    "cd": cd,
    "pwd": pwd,
    "export": export,
    "unset": unset,
    "set": set_,
    "shift": shift,
    "read": read,
    "exit": exit_,
    "logout": exit_,
    "break": break_,
    "continue": break_,
    "return": return_,
    "source": source,
    ".": source,
    "eval": eval_,
    "history": history,
    "alias": alias,
}
