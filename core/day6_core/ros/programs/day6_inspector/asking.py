"""Asks the other processes for their reports, again and again, without ever waiting."""

from __future__ import annotations

import time
from collections import deque
from typing import TYPE_CHECKING

from day6_core.link import link_of
from day6_core.ros.programs.day6_inspector.process_reports import ReportedProcess, read_process

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph
    from day6_core.link.process_reports import Question

OPEN = 4
"""Questions whose answers are still read: a busy process may take its time."""

DEAF_S = 2.0
"""A program that does not answer for so long is named."""


class Asking:
    """Keeps the newest answers. On the program's thread."""

    def __init__(self, graph: Graph) -> None:
        self._graph = graph
        self._questions: deque[Question] = deque(maxlen=OPEN)
        self.processes: tuple[ReportedProcess, ...] = ()
        self._answered: dict[str, float] = {}
        """Session -> when it answered last (monotonic seconds)."""

    def ask(self) -> None:
        """Ask all processes, without waiting for the answers."""
        link = link_of(self._graph)
        if link is not None and (asked := link.ask_for_reports()) is not None:
            self._questions.append(asked)

    def hear(self) -> None:
        """Take the answers that have come."""
        link = link_of(self._graph)
        if link is None:
            return
        now = time.monotonic()
        told = {each.zid: each for each in self.processes}
        for question in self._questions:
            while question.answers:
                zid, answer = question.answers.popitem()
                process = read_process(zid, answer)
                if process is not None:
                    told[zid], self._answered[zid] = process, now
        present = link.present()
        self._answered = {zid: at for zid, at in self._answered.items() if zid in present}
        self.processes = tuple(each for zid, each in told.items() if now - self._answered.get(zid, -DEAF_S) < DEAF_S)

    def silent(self) -> tuple[str, ...]:
        """Return nodes of processes that once sent reports and do not answer any more: stopped, for instance."""
        now = time.monotonic()
        link = link_of(self._graph)
        if link is None:
            return ()
        deaf = {zid for zid, at in self._answered.items() if now - at > DEAF_S}
        return tuple(
            node.full_name
            for node in self._graph.nodes
            if getattr(node.origin, "zid", None) in deaf and not node.name.startswith("_")
        )
