"""Maps command names to programs."""

from __future__ import annotations

import importlib
import os
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.ros.executables import are_on
from day6_core.ros.home_python import activated, scripts_of
from day6_core.ros.program_index import COMMANDS, named_by, place_of_command
from day6_core.ros.programs import load
from day6_core.session.session import Main, Session
from day6_core.shell.language.quoting import visible
from day6_core.shell.process.real_tools import find_tool, running
from day6_core.shell.text_tools import TOOLS, chosen

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell

_PACKAGE = "day6_core.shell.builtins"

MODULES: dict[str, dict[str, str]] = {
    module: {name: function or name for name, _, function in (word.partition("=") for word in names.split())}
    for module, names in {
        "state": "cd pwd shift exit=exit_ logout=exit_ break=break_ continue=break_ return=return_ source .=source "
        "eval=eval_ history",
        "declaring": "export unset local declare typeset=declare readonly",
        "reading": "read mapfile readarray=mapfile",
        "switches": "alias unalias set=set_ shopt",
        "shell_itself": "trap exec=exec_ builtin hash=hash_ let getopts caller compgen umask ulimit bind "
        "complete compopt=accepted enable=refused fc=refused suspend=refused times=refused",
        "output": "echo printf",
        "jobs": "jobs fg bg wait kill disown ps pkill killall=pkill",
        "files": "cat mkdir rmdir touch rm tee chmod",
        "transfer": "cp mv",
        "listing": "ls tree",
        "text": "head tail wc sort uniq",
        "search": "grep egrep fgrep=egrep",
        "paths": "ln readlink realpath pushd popd dirs",
        "repeated": "xargs watch",
        "download": "wget curl",
        "machine": "nproc lsb_release locale",
        "display": "tput stty dircolors lesspipe",
        "find": "find",
        "columns": "cut tr rev sed",
        "compare": "diff",
        "pager": "less more=less man",
        "packages": "sudo apt apt-get=apt rosdep pip pip3=pip",
        "edit": "nano=edit gedit=edit vim=edit vi=edit code=edit mousepad=edit gnome-text-editor=edit",
        "terminals": "xterm gnome-terminal=gnome_terminal x-terminal-emulator=xterm",
        "times": "sleep timeout date",
        "why": "why explain",
        "about": "help=help_ clear reset=clear which type=type_ command whoami hostname uname id=id_ env printenv "
        "true false :=true test [=test basename dirname seq",
        "programs": "python3 python=python3 pytest launch_test ros2 colcon bash sh=bash "
        + " ".join(f"{name}=ros_program" for name in COMMANDS),
    }.items()
}
"""The module of `builtins` in which each command is, and the function there, which has its name if `=` gives no other."""

_PLACES = {name: (module, function) for module, names in MODULES.items() for name, function in names.items()}

_OF_THE_SHELL = ("state", "declaring", "reading", "switches", "shell_itself", "output")
_ALSO_BUILTIN = "pushd popd dirs jobs fg bg wait kill disown help type command true false : test ["
SHELL_BUILTINS = frozenset((*(name for each in _OF_THE_SHELL for name in MODULES[each]), *_ALSO_BUILTIN.split()))
"""Built-ins of bash itself; all other commands have a place in /usr/bin or /opt/ros."""


def command_names() -> list[str]:
    """Every command there is, sorted."""
    return sorted(_PLACES)


def builtin(name: str) -> Main | None:
    """The command of that name among ours, None if there is none."""
    if name not in _PLACES:
        return None
    module, function = _PLACES[name]
    main: Main = getattr(importlib.import_module(f"{_PACKAGE}.{module}"), function)
    return main


def place_of(name: str) -> str:
    """The path that `which` prints for a command; '' for a built-in of the shell."""
    if name not in _PLACES or name in SHELL_BUILTINS - {"echo", "printf", "kill", "test", "[", "true", "false"}:
        return ""
    return place_of_command(name) or f"/usr/bin/{name}"


def where(name: str, shell: Shell) -> str:
    """The path of any program: ours, else one of the real machine; '' for what is not one."""
    environment = activated(shell.variables)
    if environment is not None and (own := shutil.which(name, path=str(scripts_of(environment)))):
        return own
    if name in _PLACES:
        return "" if _is_unsourced(name, shell.variables) else place_of(name)
    return find_tool(name, shell.variables, shell.cwd)


def _is_unsourced(name: str, variables: Mapping[str, str]) -> bool:
    """Whether it is a command of ROS, and PATH has lost the folder that sourcing /opt/ros puts there."""
    return bool(place_of_command(name)) and not are_on(variables.get("PATH", ""))


LONGEST_ARGUMENT = 128 * 1024
LONGEST_ARGUMENTS = 2 * 1024 * 1024
"""Bytes that Linux passes to a program, its variables included (execve(2): MAX_ARG_STRLEN, a quarter of an 8 MB stack)."""


def too_long(argv: list[str], environment: Mapping[str, str]) -> bool:
    """Whether these arguments are too long for a program; built-ins of the shell take any."""
    if not argv or argv[0] in SHELL_BUILTINS:
        return False
    texts = [*argv, *(f"{name}={value}" for name, value in environment.items())]
    if sum(map(len, texts)) < LONGEST_ARGUMENT // 4:
        return False
    sizes = [len(text.encode("utf-8", "surrogateescape")) + 1 for text in texts]
    return max(sizes) > LONGEST_ARGUMENT or sum(sizes) + 8 * len(sizes) > LONGEST_ARGUMENTS


def list_too_long(name: str, shell: Shell) -> Main:
    """Return a program that reports that, as bash does."""
    return _saying(f"{shell.name}: {where(name, shell) or name}: Argument list too long", 126)


def find_command(name: str, shell: Shell, *, functions: bool = True) -> Main:
    """Return the program for `name`: a function, one of ours, a file (with a / in it), one of the real machine.

    If there is none, it is one that prints `command not found`.
    """
    if functions and name in shell.functions:
        from day6_core.shell.language.functions import calling

        return calling(shell.functions[name])
    if "/" in name:
        return _file(name, shell)
    if name in _PLACES and not _is_unsourced(name, shell.variables):
        return _ours(name)
    if name.startswith("%") and shell.interactive and shell.jobs.find(name):
        return _to_the_front
    if tool := find_tool(name, shell.variables, shell.cwd):
        return running(tool)
    return _saying(f"{shell.name}: {visible(name)}: command not found", 127)


async def _to_the_front(session: Session) -> int:
    """`%1` is `fg %1`."""
    return await session.execute(_ours("fg"), ["fg", session.argv[0]])


def _ours(name: str) -> Main:
    main = builtin(name) or _nothing
    return chosen(name, main) if name in TOOLS else main


def _file(name: str, shell: Shell) -> Main:
    path = shell.cwd / name
    ours = place_of(path.name)
    if ours == name or (name.startswith(("/bin/", "/usr/bin/")) and ours.startswith("/usr/bin/")):
        return _ours(path.name)
    program = named_by(path)
    if program is not None:
        return load(*program)
    if path.is_dir():
        return _saying(f"{shell.name}: {name}: Is a directory", 126)
    if not path.exists():
        return _saying(f"{shell.name}: {name}: No such file or directory", 127)
    if os.name != "nt" and not os.access(path, os.X_OK):
        return _saying(f"{shell.name}: {name}: Permission denied", 126)
    interpreter = _interpreter(path)
    if interpreter is None or (interpreter and not interpreter.endswith("sh") and "python" not in interpreter):
        return running(str(path))
    return _run_python([name]) if "python" in interpreter else _run_script(name)


def _interpreter(path: Path) -> str | None:
    """What is after `#!`; '' for a text that begins with something else, None for a file that is not text."""
    try:
        with path.open("rb") as file:
            line = file.readline(256)
    except OSError:
        return ""
    if b"\0" in line:
        return None
    return line[2:].decode("utf-8", "replace").strip() if line.startswith(b"#!") else ""


def _saying(text: str, status: int) -> Main:
    async def main(session: Session) -> int:
        session.print_error(text)
        return status

    return main


def _run_python(arguments: list[str]) -> Main:
    async def main(session: Session) -> int:
        return await session.run_python([*arguments, *session.argv[1:]])

    return main


def _run_script(name: str) -> Main:
    async def main(session: Session) -> int:
        from day6_core.shell.builtins.programs import run_script

        return await run_script(session, name, session.argv[1:])

    return main


async def _nothing(session: Session) -> int:
    return 0
