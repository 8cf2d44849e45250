"""Runs a verb inside a program of its own, which imported one of the `ros2…` packages."""

from __future__ import annotations

import os
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TypeVar

from day6_core.ros.ros2.cli.tree import load

if TYPE_CHECKING:
    from day6_core.graph import Graph
    from day6_core.session.session import Session

_Result = TypeVar("_Result")


@contextmanager
def joined_graph() -> Iterator[Graph]:
    """Yield the graph of this process's domain, joined to those of the other processes and settled."""
    from day6_core.graph import graph_for_domain
    from day6_core.graph.domain import domain_from_text
    from day6_core.link import join, leave, link_of

    graph = graph_for_domain(domain_from_text(os.environ.get("ROS_DOMAIN_ID", "")))
    joins = os.environ.get("DAY6_LINK") != "off" and link_of(graph) is None
    if joins:
        join(graph, one_shot=True)
    try:
        if (link := link_of(graph)) is not None:
            link.wait_settled(1.0)
        yield graph
    finally:
        if joins:
            leave(graph)


def run(words: list[str], work: Callable[[Session], Awaitable[_Result]]) -> _Result:
    """Run `work` in a session on this process's streams and return its result, or raise what it raised."""
    from day6_core.session.clock import WorldClock
    from day6_core.session.folder import working_folder
    from day6_core.session.program import Program
    from day6_core.session.real_streams import RealInput, RealOutput
    from day6_core.session.scheduler import Scheduler
    from day6_core.session.session import Session

    results: list[_Result] = []
    errors: list[BaseException] = []

    async def main(session: Session) -> int:
        try:
            results.append(await work(session))
        except BaseException as error:
            errors.append(error)
        return 0

    with joined_graph() as graph:
        scheduler = Scheduler(WorldClock(), may_wait=True)
        session = Session(
            scheduler,
            graph,
            ["ros2", *words],
            env=dict(os.environ),
            cwd=working_folder(),
            pid=os.getpid(),
            stdin=RealInput(),
            stdout=RealOutput(sys.stdout),
            stderr=RealOutput(sys.stderr),
        )
        program = Program(session, main)
        try:
            scheduler.run(lambda: program.status is not None)
        finally:
            session.close()
    if errors:
        raise errors[0]
    return results[0]


def run_verb(command: str, verb: str | None, args: Namespace) -> str | int | None:
    """Run a verb, or a command without verbs, and return what it returns: None, a status, or the text of an error.

    Options that `args` lacks have their defaults.
    """
    modules = [load(command), *([load(command, verb)] if verb is not None else [])]
    given = vars(args)
    args = Namespace()
    for module in modules:
        if hasattr(module, "add_arguments"):
            parser = ArgumentParser(add_help=False)
            module.add_arguments(parser)
            vars(args).update({action.dest: action.default for action in parser._actions})
    vars(args).update(given)
    words = [word for word in (command, verb) if word is not None]

    async def main(session: Session) -> str | int | None:
        outcome: str | int | None = await modules[-1].main(session, args)
        return outcome

    return run(words, main)
