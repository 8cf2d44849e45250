"""`ros2 run`."""

from __future__ import annotations

import logging
import shlex
from argparse import REMAINDER, ArgumentParser, Namespace
from typing import TYPE_CHECKING

from day6_core.ros.ros2.cli.choice import NothingChosen, choose, may_be_left_out
from day6_core.ros.ros2.cli.completion import executable_names, package_names
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.ros.ros2.cli.packages import Executable
    from day6_core.session.session import Session

SUMMARY = "Run a package specific executable"
_PREFIX = "[ros2run]:"
_log = logging.getLogger(__name__)


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--prefix",
        help="Prefix command, which should go before the executable. Command must be wrapped in quotes if it contains spaces "
        "(e.g. --prefix 'gdb -ex run --args').",
    )
    chosen = may_be_left_out()
    completed(parser.add_argument("package_name", nargs=chosen, help="Name of the ROS package"), package_names)
    completed(parser.add_argument("executable_name", nargs=chosen, help="Name of the executable"), executable_names)
    rest = parser.add_argument("argv", nargs=REMAINDER, help="Pass arbitrary arguments to the executable")
    rest.required = chosen is None  # Python before 3.13 lists it among the missing arguments


async def main(session: Session, args: Namespace) -> int | str:
    from day6_core.ros.ros2.cli.packages import executables

    if args.executable_name is None and (refusal := await _choose(session, args)) is not None:
        return refusal
    found = executables(session, args.package_name)
    if found is None:
        raise RuntimeError(f"Package '{args.package_name}' not found")
    fitting = [each for each in found if each.name == args.executable_name]
    if not fitting:
        from ament_index_python.packages import get_package_prefix

        from day6_core.ros.left_out import why_not

        prefix = get_package_prefix(args.package_name, session.env)
        return "No executable found" + why_not(prefix, args.package_name, args.executable_name)
    if len(fitting) > 1:
        raise RuntimeError("\n- ".join(["Multiple executables found:", *(str(each.path) for each in fitting)]))
    if args.prefix is not None:
        return await _run_prefixed(session, shlex.split(args.prefix), fitting[0], args.argv)
    if fitting[0].built_in:
        return await _run_built_in(session, args.package_name, fitting[0], args.argv)
    return await _run_process(session, [str(fitting[0].path), *args.argv])


async def _choose(session: Session, args: Namespace) -> str | None:
    """Let the user choose what was left out, the package and its executable; return what is wrong."""
    from day6_core.ros.ros2.cli.packages import executables, packages

    try:
        if args.package_name is None:
            args.package_name = await choose(session, packages(session), "Select package:")
    except NothingChosen:
        return "No package selected"
    found = executables(session, args.package_name)
    if found is None:
        raise RuntimeError(f"Package '{args.package_name}' not found")
    if not found:
        return f"No executables found in package '{args.package_name}'"
    try:
        args.executable_name = await choose(session, sorted(each.name for each in found), "Select executable:")
    except NothingChosen:
        return "No executable selected"
    return None


async def _run_process(session: Session, argv: list[str]) -> int:
    """Run a file of a workspace. If a signal kills it, the signal is printed and the status is minus its number."""
    from day6_core.ros.environment import as_program
    from day6_core.session.session import KilledBySignal

    session.env = as_program(session.env)
    try:
        return _report_failure(session, await session.run_python(argv))
    except KeyboardInterrupt:
        number = 2
    except KilledBySignal as end:
        number = end.number
    return _report_failure(session, -number)


async def _run_built_in(session: Session, package: str, executable: Executable, argv: list[str]) -> int:
    from day6_core.ros.programs import load
    from day6_core.session.session import Crash, Terminated
    from day6_core.session.streams import WriteError

    try:
        status = await session.execute(load(package, executable.name), [str(executable.path), *argv])
        if session.terminated:
            raise Terminated  # the node has ended well, but `ros2 run`, which got the signal too, does not
    except KeyboardInterrupt:
        return 0  # a well-written node exits cleanly on Ctrl-C, so nothing is printed here
    except (BrokenPipeError, WriteError):
        raise
    except Crash as crash:
        session.print_error(crash.report)
        status = -crash.number
    except Exception as error:
        from day6_core.ros.ros2.cli.failure import failure_text

        _log.debug("%s ended by an exception", executable.path, exc_info=True)
        session.stderr.write(failure_text(error))
        status = 1
    return _report_failure(session, status)


async def _run_prefixed(session: Session, prefix: list[str], executable: Executable, argv: list[str]) -> int | str:
    """Run `PREFIX PATH ARGV` as a line of the shell that started this command."""
    line = shlex.join([*prefix, str(executable.path), *argv])
    if session.host is None:
        return f"--prefix needs the shell of day6-tui, which did not start this command: {line}"
    status = await session.host.run_line(line, session)
    return _report_failure(session, 128 - status if status > 128 else status)


def _report_failure(session: Session, status: int) -> int:
    """Print how a program failed, if it did; `status` is subprocess's, the returned one is the shell's."""
    if status:
        from day6_core.session.signals import TEXTS

        session.print(_PREFIX, TEXTS.get(-status) or f"Process exited with failure {status}")
    return status & 0xFF
