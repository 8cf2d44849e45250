"""python3, ros2, colcon, the programs that are commands of their own, and bash."""

from __future__ import annotations

import importlib

from day6_core.ros.program_index import COMMANDS as ROS_COMMANDS
from day6_core.ros.programs import load
from day6_core.session.session import Main, Session
from day6_core.shell.builtins.options import reason
from day6_core.shell.builtins.text import text_named
from day6_core.shell.language.interpreter import shell_of, subshell_main
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.shell_state import NOT_FOUND
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


async def bash(session: Session) -> int:
    """`bash -c COMMANDS` and `bash FILE`, in a copy of the shell."""
    words = session.argv[1:]
    if words and words[0] == "-c":
        if len(words) < 2:
            session.print_error(f"{session.name}: -c: option requires an argument")
            return 2
        name = words[2] if len(words) > 2 else session.name
        return await _run_copy(session, words[1], name, words[3:], unbound_status=NOT_FOUND)
    if words and not words[0].startswith("-"):
        return await run_script(session, words[0], words[1:])
    if words:
        session.print_error(f"{session.name}: {words[0]}: invalid option")
        return 2
    return await _run_copy(session, await session.stdin.read_all(), session.name, [])


async def run_script(session: Session, name: str, arguments: list[str]) -> int:
    """Run a file of command lines in a copy of the shell."""
    try:
        text = await text_named(session, name)
    except OSError as error:
        session.print_error(f"{shell_of(session).name}: {name}: {reason(error)}")
        return 126 if isinstance(error, (IsADirectoryError, PermissionError)) else 127
    return await _run_copy(session, text, name, arguments)


async def _run_copy(session: Session, text: str, zero: str, arguments: list[str], *, unbound_status: int = 1) -> int:
    shell = shell_of(session)
    inner = shell.clone()
    inner.unbound_status = unbound_status
    inner.arguments, inner.zero = arguments, zero
    inner.options = set()
    inner.cwd = session.cwd
    inner.variables = dict(session.env)
    inner.exported = set(session.env)
    streams = Streams(session.stdin, session.stdout, session.stderr)
    return (await subshell_main(inner, lambda: inner.run(text, streams))(session)) or 0
