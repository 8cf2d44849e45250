"""The way to other machines where the meeting point is on TCP and asks for a password.

A Zenoh session shows one password to all it meets, or none. So two sessions are opened, one that knows this machine's and one
that knows none, and what comes in at one goes out at the other: messages, questions with their answers, and tokens.
"""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from day6_tui.core.link.engine_thread import callback

if TYPE_CHECKING:
    import zenoh

Report = Callable[[str, Exception], None]

_MOST_WAITING = 10_000
"""Messages that may wait for the bridge's thread; more are dropped, as on a slow network."""
_ANSWER_SECONDS = 3600.0
"""A question is open as long as its asker waits; the answer to a goal may take long."""


class Bridge:
    """Joins two open sessions for one domain until `close`; it owns them."""

    def __init__(self, inner: zenoh.Session, outer: zenoh.Session, domain_id: int, report: Report) -> None:
        self._sessions = (inner, outer)
        self._report = report
        self._work: queue.SimpleQueue[Callable[[], object] | None] = queue.SimpleQueue()
        self._tokens: dict[tuple[int, str], Any] = {}
        """By the side (0 inner, 1 outer) on which we declared it for the other."""
        self._declared: list[Any] = []
        self._thread = threading.Thread(target=self._run, name="day6-bridge", daemon=True)
        self._thread.start()
        for side in (0, 1):
            self._listen(side, domain_id)

    def close(self) -> None:
        """Take down what was mirrored and close both sessions."""
        self._work.put(None)
        self._thread.join(timeout=2.0)
        self._tokens.clear()
        self._declared.clear()
        for session in self._sessions:
            session.close()
        self._sessions = ()  # type: ignore[assignment]

    def _listen(self, side: int, domain_id: int) -> None:
        import zenoh

        session = self._sessions[side]
        # A chunk that begins with @, as of the caches of transient-local publishers, is matched by no wildcard.
        data = (f"{domain_id}/**", f"{domain_id}/**/@adv/**")
        tokens = (f"@ros2_lv/{domain_id}/**", f"{domain_id}/**/@adv/**")
        remote = zenoh.Locality.REMOTE
        for key in data:
            on_sample = zenoh.handlers.Callback(callback(partial(self._on_sample, side)), indirect=False)
            self._declared.append(session.declare_subscriber(key, on_sample, allowed_origin=remote))
            on_query = zenoh.handlers.Callback(callback(partial(self._on_query, side)), indirect=False)
            self._declared.append(session.declare_queryable(key, on_query, complete=True, allowed_origin=remote))
        for key in tokens:
            on_token = zenoh.handlers.Callback(callback(partial(self._on_token, side)), indirect=False)
            self._declared.append(session.liveliness().declare_subscriber(key, on_token, history=True))

    # on Zenoh's threads: nothing here may wait

    def _on_sample(self, side: int, sample: zenoh.Sample) -> None:
        if self._work.qsize() < _MOST_WAITING:
            self._work.put(partial(self._pass_sample, 1 - side, sample))

    def _on_query(self, side: int, query: zenoh.Query) -> None:
        self._work.put(partial(self._pass_query, 1 - side, query))

    def _on_token(self, side: int, sample: zenoh.Sample) -> None:
        import zenoh

        present = sample.kind == zenoh.SampleKind.PUT
        self._work.put(partial(self._pass_token, side, str(sample.key_expr), present))

    # on the bridge's thread

    def _run(self) -> None:
        while (work := self._work.get()) is not None:
            try:
                work()
            except Exception as error:
                # One thing could not be passed on (the other side is gone at this moment, say): the others can.
                self._report("the bridge to other machines", error)

    def _pass_sample(self, to: int, sample: zenoh.Sample) -> None:
        import zenoh

        self._sessions[to].put(
            sample.key_expr,
            sample.payload,
            encoding=sample.encoding,
            attachment=sample.attachment,
            congestion_control=sample.congestion_control,
            priority=sample.priority,
            timestamp=sample.timestamp,
            allowed_destination=zenoh.Locality.REMOTE,
        )

    def _pass_query(self, to: int, query: zenoh.Query) -> None:
        import zenoh

        def on_reply(reply: zenoh.Reply) -> None:
            if (answer := reply.ok) is not None:
                self._work.put(partial(_answer, query, answer))

        # The question is over when nobody holds it any more: after the last answer has been passed on.
        self._sessions[to].get(
            query.selector,
            zenoh.handlers.Callback(callback(on_reply), lambda: self._work.put(query.drop), indirect=False),
            target=zenoh.QueryTarget.ALL_COMPLETE if query.payload is not None else zenoh.QueryTarget.ALL,
            consolidation=zenoh.ConsolidationMode.NONE,
            # A cache answers with the keys of its messages, which are not the key that it is asked by.
            accept_replies=query.accepts_replies(),
            timeout=_ANSWER_SECONDS,
            payload=query.payload,
            encoding=query.encoding,
            attachment=query.attachment,
            allowed_destination=zenoh.Locality.REMOTE,
        )

    def _pass_token(self, side: int, key: str, present: bool) -> None:
        if (side, key) in self._tokens:
            return  # our own, for what is on the other side
        if present:
            if (1 - side, key) not in self._tokens:
                self._tokens[1 - side, key] = self._sessions[1 - side].liveliness().declare_token(key)
        elif (token := self._tokens.pop((1 - side, key), None)) is not None:
            token.undeclare()


def _answer(query: zenoh.Query, answer: zenoh.Sample) -> None:
    # By its time a late joiner knows a message that it has been given before.
    query.reply(
        answer.key_expr,
        answer.payload,
        encoding=answer.encoding,
        attachment=answer.attachment,
        timestamp=answer.timestamp,
    )
