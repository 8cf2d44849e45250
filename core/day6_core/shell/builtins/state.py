"""Built-ins that change the shell itself: directories, history, control flow, sourcing. See `declaring` for its variables."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.places import as_on_linux
from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain_as_shell, reason
from day6_core.shell.builtins.text import script_named
from day6_core.shell.language.control_flow import ExitShell, LoopControl, ReturnFromSource
from day6_core.shell.language.functions import in_the_shell_itself
from day6_core.shell.language.interpreter import Shell, shell_of
from day6_core.shell.language.quoting import visible
from day6_core.shell.language.specials import Call
from day6_core.shell.system_files import TEXTS

if TYPE_CHECKING:
    from day6_core.language import Pair

_OTHER_DISTRIBUTION: Pair = (
    "this desktop is ROS 2 {current}; it has to start again to be {wanted}, and what is open comes back",
    "这个桌面是 ROS 2 {current}；换成 {wanted} 要重新打开桌面，打开着的都会回来",
)


async def cd(session: Session) -> int:
    shell = shell_of(session)
    flags, operands = _flags(session)
    if len(operands) > 1:
        complain_as_shell(session, "too many arguments")
        return 1
    target = operands[0] if operands else shell.variables.get("HOME", "")
    shown = False
    if target == "-":
        target = shell.variables.get("OLDPWD", "")
        if not target:
            complain_as_shell(session, "OLDPWD not set")
            return 1
        shown = True
    if not target:
        if not operands:
            complain_as_shell(session, "HOME not set")
            return 1
        target = "."
    folder = shell.cwd
    if not target.startswith(("/", "./", "../")) and target not in (".", ".."):
        for each in filter(None, shell.variables.get("CDPATH", "").split(":")):
            if (shell.cwd / each / target).is_dir():
                folder, shown = shell.cwd / each, True
                break
    # As a shell does it: `..` is taken off the text, symbolic links are kept.
    path = Path(os.path.normpath(folder / target))
    try:
        if not path.is_dir():
            os.stat(path)
            raise NotADirectoryError(20, "Not a directory")
        os.scandir(path).close()
    except OSError as error:
        complain_as_shell(session, f"{visible(target)}: {reason(error)}")
        return 1
    if "P" in flags or "P" in shell.options:
        path = path.resolve()
    if shown:
        session.print(path)
    for name, value in (("OLDPWD", shell.cwd), ("PWD", path)):
        shell.variables[name] = str(value)
        shell.variables.export(name)
    shell.cwd = path
    return 0


def _flags(session: Session) -> tuple[str, list[str]]:
    """Return the letters of the options, and the operands."""
    words = session.argv[1:]
    flags = ""
    while words and words[0].startswith("-") and len(words[0]) > 1:
        word = words.pop(0)
        if word == "--":
            break
        flags += word[1:]
    return flags, words


async def pwd(session: Session) -> int:
    shell = shell_of(session)
    flags, _ = _flags(session)
    session.print(
        shell.cwd.resolve() if flags.endswith("P") or ("P" in shell.options and "L" not in flags) else shell.cwd
    )
    return 0


async def shift(session: Session) -> int:
    shell = shell_of(session)
    count = _number(session, 1)
    if count is None:
        return 1
    if count < 0 or count > len(shell.arguments):
        if count < 0 or "shift_verbose" in shell.settings:
            complain_as_shell(session, f"{session.argv[1]}: shift count out of range")
        return 1
    shell.arguments = shell.arguments[count:]
    return 0


def _number(session: Session, default: int) -> int | None:
    """Return the numeric argument of exit, break and the like; None, with a message, if it isn't a number."""
    words = session.argv[2:] if session.argv[1:2] == ["--"] else session.argv[1:]
    if not words:
        return default
    try:
        return int(words[0])
    except ValueError:
        complain_as_shell(session, f"{words[0]}: numeric argument required")
        return None


async def exit_(session: Session) -> int:
    shell = shell_of(session)
    number = _number(session, shell.status)
    if number is not None and len(session.argv) > 2 and session.argv[1] != "--":
        complain_as_shell(session, "too many arguments")
        return 1
    status = 2 if number is None else number & 0xFF
    if shell.interactive and session.name == "exit":
        session.stderr.write("exit\n")
        if not shell.may_leave(session.stderr):
            return 1
    shell.wanted[session] = ExitShell(status)
    return status


async def break_(session: Session) -> int:
    shell = shell_of(session)
    number = _number(session, 1)
    if not shell.loops:
        complain_as_shell(session, "only meaningful in a `for', `while', or `until' loop")
        return 0
    if number is None:
        shell.wanted[session] = ExitShell(128)
        return 128
    if number < 1:
        complain_as_shell(session, f"{session.argv[1]}: loop count out of range")
        shell.wanted[session] = LoopControl(shell.loops, again=False)
        return 1
    shell.wanted[session] = LoopControl(min(number, shell.loops), again=session.name == "continue")
    return 0


async def return_(session: Session) -> int:
    shell = shell_of(session)
    number = _number(session, shell.status)
    status = 2 if number is None else number & 0xFF
    if not shell.calls:
        complain_as_shell(session, "can only `return' from a function or sourced script")
        return 2
    shell.wanted[session] = ReturnFromSource(status)
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
    if _wanted_distribution(session, name):
        return 1
    path = _found(shell, name)
    try:
        text = TEXTS.get(as_on_linux(path))
        if text is None:
            text = await script_named(session, str(path))
    except OSError as error:
        if isinstance(error, IsADirectoryError):
            complain_as_shell(session, f"{name}: is a directory")
        else:
            session.print_error(f"{shell.name}: {name}: {reason(error)}")
        return 1
    before = shell.arguments
    if session.argv[2:]:
        shell.arguments = session.argv[2:]
    shell.calls.append(
        Call("source", name if "/" in name else str(path) if path.parent != shell.cwd else name, shell.line)
    )
    try:
        shell.status = 0
        return await _run_here(session, text, first_line=1)
    finally:
        shell.calls.pop()
        if session.argv[2:]:
            shell.arguments = before


def _found(shell: Shell, name: str) -> Path:
    """The file to source: a name without `/` is looked for in the folders of PATH, then in the working directory."""
    if "/" not in name:
        for folder in filter(None, shell.variables.get("PATH", "").split(os.pathsep)):
            path = shell.cwd / folder / name
            if path.is_file():
                return path
    return shell.cwd / name


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
    for each, value in changed.items():
        shell.variables[each] = value
        shell.variables.export(each)
    import_interfaces(changed)
    return True


def _wanted_distribution(session: Session, name: str) -> bool:
    """Note that `name` is the setup script of another distribution, which the desktop can become when the line has ended."""
    from day6_core.language import language_of, said
    from day6_core.ros import distribution
    from day6_core.ros.setup_lines import distribution_of

    shell = shell_of(session)
    wanted = distribution_of(as_on_linux(Path(os.path.normpath(shell.cwd / name))))
    if wanted not in distribution.NAMES or shell.wanted_distribution is None:
        return False
    shell.wanted_distribution = wanted
    words = said(_OTHER_DISTRIBUTION, language_of(session.env))
    session.print_error(f"day6-tui: {words.format(wanted=wanted, current=distribution.current())}")
    return True


async def eval_(session: Session) -> int:
    words = session.argv[2:] if session.argv[1:2] == ["--"] else session.argv[1:]
    text = " ".join(words)
    if not text.strip():
        return 0
    return await _run_here(session, text, first_line=shell_of(session).line)


async def _run_here(session: Session, text: str, first_line: int) -> int:
    """Run command lines in the shell itself, on this command's streams."""
    shell = shell_of(session)
    return await in_the_shell_itself(
        session, lambda streams: shell.run(text, streams, first_line=first_line), "maximum nesting level exceeded"
    )


async def history(session: Session) -> int:
    shell = shell_of(session)
    if session.argv[1:] == ["-c"]:
        shell.history.clear()
        return 0
    if session.argv[1:] and session.argv[1] in ("-a", "-n", "-r", "-w"):
        return 0  # a terminal keeps each line as it is typed
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
