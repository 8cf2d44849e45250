"""The program `colcon`, as started by the terminals."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.session.task import Signal, wait_for

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    """Run `colcon …` from `session.argv` in a thread; Ctrl-C ends its commands, then it ends. Returns the exit status."""
    from day6_core.interfaces import forget
    from day6_core.ros import environment
    from day6_core.session.argument_parser import ParserExit
    from day6_core.session.folder import LOST
    from day6_core.workspace.arguments import build_parser, parse
    from day6_core.workspace.colcon import Colcon
    from day6_core.workspace.events import LOG_LEVELS, Console

    environment.activate()
    try:
        args = parse(session, session.argv[1:])
    except ParserExit as end:
        return end.status
    if args.verb_name is None:
        session.stdout.write(build_parser(session).format_usage() + "\n")
        session.print_error("Error: No verb provided")
        return 1
    if not session.cwd.is_dir():  # creating `build` would create it again
        session.print_error(f"colcon: {LOST}")
        return 1
    level = LOG_LEVELS.get(args.log_level.upper()) or int(args.log_level)
    console = Console(session.stdout, session.stderr, environment=session.env, log_level=level)
    colcon = Colcon(args, console, session.cwd, environment.as_program(session.env))
    status = await in_thread(colcon.run, colcon.interrupt)
    for name in colcon.selected:
        forget(name)  # a rebuilt message has a new class now
    return status


async def in_thread(run: Callable[[], int], interrupt: Callable[[], None]) -> int:
    """Run `run` in a thread until it ends, whatever happens; Ctrl-C and anything else that ends the program call `interrupt`."""
    done = Signal()
    results: list[int] = []
    errors: list[BaseException] = []

    def live() -> None:
        try:
            results.append(run())
        except BaseException as error:  # raised again where the program waits
            errors.append(error)
        finally:
            done.set()

    threading.Thread(target=live, name="day6-colcon", daemon=True).start()
    try:
        while not done.is_set():
            try:
                await wait_for(done)
            except KeyboardInterrupt:
                interrupt()
    finally:
        if not done.is_set():
            interrupt()
    if errors:
        raise errors[0]
    return results[0]
