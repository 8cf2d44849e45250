"""python3, ros2, colcon, the programs that are commands of their own, and bash."""

from __future__ import annotations

import importlib
from dataclasses import dataclass

from day6_core.ros.program_index import COMMANDS as ROS_COMMANDS
from day6_core.ros.programs import load
from day6_core.session.session import Main, Session
from day6_core.shell.builtins.options import reason
from day6_core.shell.builtins.text import script_named
from day6_core.shell.language.failures import report
from day6_core.shell.language.interpreter import Shell, shell_of
from day6_core.shell.language.parser import parse
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.settings import NAMED_OPTIONS, OBEYED, OBEYED_SETTINGS
from day6_core.shell.language.shell_state import NOT_FOUND
from day6_core.shell.language.subshells import subshell_main
from day6_core.shell.language.words import SyntaxProblem
from day6_core.shell.outside import asking


async def python3(session: Session) -> int:
    return await session.run_python(session.argv[1:])


async def pytest(session: Session) -> int:
    return await session.run_python(["-m", "pytest", *session.argv[1:]])


async def launch_test(session: Session) -> int:
    return await session.run_python(["-m", "launch_testing.launch_test", *session.argv[1:]])


@asking(lambda words: ["."] if words[:2] == ["pkg", "create"] else [])
async def ros2(session: Session) -> int:
    # Not imported at the top: the command tree is large, and most lines of a terminal do without it.
    main: Main = importlib.import_module("day6_core.ros.ros2").main
    return (await main(session)) or 0


@asking(lambda words: ["."] if words[:1] in (["build"], ["test"]) else [])
async def colcon(session: Session) -> int:
    main: Main = importlib.import_module("day6_core.workspace.command").main
    return (await main(session)) or 0


async def ros_program(session: Session) -> int:
    """A command that is an executable of one of our packages."""
    return await session.execute(load(*ROS_COMMANDS[session.name]), session.argv)


_VALUED = ("--rcfile", "--init-file")
_IGNORED = frozenset({"--norc", "--noprofile", "--login", "--noediting"})
"""Options of bash that concern only a shell that is typed into, or what it reads first."""


async def bash(session: Session) -> int:
    """`bash [OPTIONS] -c COMMANDS [NAME ARGUMENT …]`, `bash [OPTIONS] FILE [ARGUMENT …]`, in a copy of the shell."""
    shell = shell_of(session)
    words = session.argv[1:]
    options: set[str] = set()
    settings: set[str] = set()
    text_given = from_input = False
    while words and words[0][:1] in ("-", "+") and len(words[0]) > 1:
        word = words.pop(0)
        if word in ("--", "-"):
            break
        if word in _IGNORED or word in _VALUED:
            del words[: word in _VALUED]
            continue
        if word.startswith("--"):
            session.print_error(f"{session.name}: {word}: invalid option")
            return 2
        for letter in word[1:]:
            if letter in "oO" and words:
                name = words.pop(0)
                if letter == "O":
                    settings.add(name)
                elif name not in NAMED_OPTIONS:
                    session.print_error(f"{session.name}: {name}: invalid option name")
                    return 2
                else:
                    options.add(NAMED_OPTIONS[name])
            elif letter == "c":
                text_given = True
            elif letter in "lis":
                from_input = from_input or letter == "s"
            elif letter in NAMED_OPTIONS.values():
                options.add(letter)
            else:
                session.print_error(f"{session.name}: -{letter}: invalid option")
                return 2
    for name in (options - OBEYED - {"n"}) | (settings - OBEYED_SETTINGS):
        session.print_error(f"{shell.name}: {Refused(f'bash … {name}').told(shell.variables)}")
        return 2
    copy = _Copy(options, settings)
    if text_given:
        if not words:
            session.print_error(f"{session.name}: -c: option requires an argument")
            return 2
        copy.options.add("c")
        return await copy.run(session, words[0], words[1] if len(words) > 1 else session.name, words[2:])
    if words and not from_input:
        return await run_script(session, words[0], words[1:], copy)
    return await copy.run(session, await session.stdin.read_all(), session.name, words)


async def run_script(session: Session, name: str, arguments: list[str], copy: _Copy | None = None) -> int:
    """Run a file of command lines in a copy of the shell."""
    shell = shell_of(session)
    try:
        text = await script_named(session, name)
    except OSError as error:
        session.print_error(f"{shell.name}: {name}: {reason(error)}")
        return 126 if isinstance(error, (IsADirectoryError, PermissionError)) else 127
    return await (copy or _Copy(set(), set())).run(session, text, name, arguments, script=name)


@dataclass
class _Copy:
    """A new bash, with the options that it is started with."""

    options: set[str]
    settings: set[str]

    async def run(self, session: Session, text: str, zero: str, arguments: list[str], script: str = "") -> int:
        """Run command lines to their end; of the shell around it there are only the environment and exported functions."""
        shell = shell_of(session)
        inner = Shell(shell.desk, env={}, cwd=session.cwd, interactive=False, name=shell.name)
        inner.variables.adopt(session.env)
        inner.depth, inner.runs, inner.background = shell.depth + 1, shell.runs, shell.background
        inner.typed = shell.typed
        inner.unbound_status = NOT_FOUND if "c" in self.options else 1
        inner.arguments, inner.zero, inner.script = arguments, zero, script
        inner.aliases = {}
        inner.options |= self.options
        inner.settings = (inner.settings - {"expand_aliases"}) | self.settings
        inner.functions = {name: shell.functions[name] for name in shell.exported_functions if name in shell.functions}
        inner.exported_functions = set(inner.functions)
        inner.pid = session.pid
        level = inner.variables.get("SHLVL", "0")
        inner.variables["SHLVL"] = str(int(level) + 1 if level.isdigit() else 1)
        inner.variables.export("SHLVL")
        streams = Streams(session.stdin, session.stdout, session.stderr)

        async def run() -> int:
            if "n" in self.options:
                return _checked(inner, text, streams)
            return await inner.run(text, streams)

        return (await subshell_main(inner, run, streams)(session)) or 0


def _checked(shell: Shell, text: str, streams: Streams) -> int:
    """`bash -n`: only read it."""
    try:
        parse(text)
    except SyntaxProblem as problem:
        report(shell, problem, streams)
        return 2
    return 0
