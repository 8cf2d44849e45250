"""The program `colcon`: what the terminals start."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from day6_tui.core.session.scheduler import Signal, TaskCancelled, wait_for

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session


async def main(session: Session) -> int:
    """Run `colcon …` from `session.argv` in a thread; Ctrl-C ends its commands, and then it. Returns the exit status."""
    from day6_tui.core.interfaces import forget
    from day6_tui.core.ros import environment
    from day6_tui.core.ros.ros2.cli.parser import ParserExit
    from day6_tui.core.workspace.arguments import build_parser, parse
    from day6_tui.core.workspace.colcon import Colcon
    from day6_tui.core.workspace.events import Console

    environment.activate()
    try:
        args = parse(session, session.argv[1:])
    except ParserExit as end:
        return end.status
    if args.verb_name is None:
        session.stdout.write(build_parser(session).format_usage())
        session.print_error("Error: No verb provided")
        return 1
    colcon = Colcon(args, Console(session.stdout, session.stderr), session.cwd, session.env)
    status = await _in_thread(colcon.run, colcon.interrupt)
    if args.verb_name == "build":
        for name in _built_interfaces(colcon):
            forget(name)
    return status


def _built_interfaces(colcon: object) -> list[str]:
    return list(getattr(colcon, "built_interfaces", ()))


async def _in_thread(run: object, interrupt: object) -> int:
    assert callable(run) and callable(interrupt)
    done = Signal()
    results: list[int] = []
    errors: list[BaseException] = []

    def live() -> None:
        try:
            results.append(run())
        except BaseException as error:  # it comes out where the program waits
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
    except (TaskCancelled, BaseException):
        interrupt()
        raise
    if errors:
        raise errors[0]
    return results[0]
