"""Processes of this user ask each other for reports: who spins, which callback does not come back.

A question is a query to all sessions of a domain, which no gate to other machines forwards. It is answered on the link's thread,
so that a process answers while its own threads are blocked.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.link.engine import engine_of
from day6_core.link.engine_thread import callback
from day6_core.link.keys import report_key

if TYPE_CHECKING:
    import zenoh

    from day6_core.graph.graph import Graph

PATIENCE_S = 2.0
LONGEST = 1_000_000
"""Bytes of an answer that are read."""

MOST = 500
"""Processes whose answers are read."""


def offer(session: zenoh.Session, graph: Graph, zid: str, put: Callable[[zenoh.Query], None]) -> zenoh.Queryable[None]:
    """Answer from now on: every question is given to `put`, on a thread of Zenoh's, which must hand it on to `answer`."""
    engine = engine_of(session)
    handler = engine.handlers.Callback(put, indirect=False)
    remote = engine.Locality.REMOTE
    return session.declare_queryable(report_key(graph.domain_id, zid), handler, complete=True, allowed_origin=remote)


def answer(query: zenoh.Query, graph: Graph, zid: str) -> None:
    """Answer a question, on the link's thread."""
    with query:
        if graph.report_process is not None:
            query.reply(report_key(graph.domain_id, zid), graph.report_process())


class Question:
    """One question to all processes; `answers` are complete when `over`. Any thread may read."""

    def __init__(self, session: zenoh.Session, domain_id: int) -> None:
        engine = engine_of(session)
        self.answers: dict[str, bytes] = {}
        """Session -> what it told."""
        self._over = threading.Event()

        def receive(reply: zenoh.Reply) -> None:
            sample = reply.ok
            if sample is None or len(self.answers) >= MOST:
                return
            payload = sample.payload.to_bytes()
            if len(payload) <= LONGEST:
                self.answers[str(sample.key_expr).rpartition("/")[2]] = payload

        session.get(
            report_key(domain_id, "*"),
            engine.handlers.Callback(callback(receive), callback(self._over.set), indirect=False),
            target=engine.QueryTarget.ALL,
            consolidation=engine.ConsolidationMode.NONE,
            timeout=PATIENCE_S,
            allowed_destination=engine.Locality.REMOTE,
        )

    @property
    def over(self) -> bool:
        """Whether everybody has answered, or time is up."""
        return self._over.is_set()
