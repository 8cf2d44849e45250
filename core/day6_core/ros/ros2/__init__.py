"""The `ros2` command. A folder or module here is a command (`topic`, `run`), a module in such a folder a verb (`topic/list.py`).

`cli` holds what they share. May import programs, `day6_core.workspace` and all of `day6_core/ros/python`; a shell that starts a
launch is seen through a Protocol (`session/host`). A verb has `SUMMARY`, `add_arguments(parser)` and `async def
main(session, args)`; modules whose names begin with an underscore are not verbs. The texts are those of ros2cli 0.36.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    """Run `ros2 …` from `session.argv`; returns the exit status."""
    from day6_core.ros.ros2.cli.run import run_command

    return await run_command(session)


async def settle(session: Session, timeout: float = 1.0) -> None:
    """Wait until the link, if there is one, has brought the other processes' entities into this process's graph."""
    from day6_core.ros.ros2.cli.node import settle as wait

    await wait(session, timeout)


async def complete(words: list[str], session: Session) -> list[str]:
    """Return the possible last words of a command line that begins with `ros2`; `words[-1]` is the part typed so far.

    They are verbs, options, nodes, topics, services, actions, types, parameters, packages, executables, default values.
    """
    from day6_core.ros.ros2.cli.completion import complete_words

    return await complete_words(words, session)
