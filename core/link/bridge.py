"""The way to other machines: two sessions, one that meets this machine's processes and one that meets the others.

What comes in at one goes out at the other: messages that somebody there has a subscription for, questions with their answers,
and tokens. Nothing else does, so what others announce is checked and limited here, once, before any process of this user has
to do with it, and is forgotten with the machine that it came from. (A Zenoh session also shows one password to all it meets,
or none, so that where this machine's own meeting point asks for one, a single session could not do.)
"""

from __future__ import annotations

import queue
import threading
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING, Any

from day6_tui.core.graph.endpoints import EndpointKind
from day6_tui.core.link.admission import Admission, Token, token_of
from day6_tui.core.link.engine_thread import callback
from day6_tui.core.link.gid import gid_of
from day6_tui.core.link.limits import MOST_WAITING, Refusals

if TYPE_CHECKING:
    import zenoh

Report = Callable[[str, Exception], None]

_MOST_MESSAGES = 10_000
"""Messages that may wait for the bridge's thread; more are dropped, as on a slow network."""
_ANSWER_SECONDS = 3600.0
"""A question is open as long as its asker waits; the answer to a goal may take long."""
_SLICE = 0.005
_PAUSE = 0.001
"""Seconds of passing things on, and of letting the program's own threads have the interpreter in between."""
_LET_IN = 1.0
"""Seconds between looks whether there is room for what was refused."""
_INNER, _OUTER = 0, 1
_GID_BYTES = 16


class Bridge:
    """Joins two open sessions for one domain until `close`; it owns them.

    `is_neighbour` says whether a session id is one of this user's processes on this machine. That a machine was not let in
    for want of the secret is not known here: Zenoh has no event for it, and its log cannot be read from Python.
    """

    def __init__(
        self,
        inner: zenoh.Session,
        outer: zenoh.Session,
        domain_id: int,
        report: Report,
        refusals: Refusals,
        is_neighbour: Callable[[str], bool],
    ) -> None:
        self._sessions = (inner, outer)
        self._domain_id = domain_id
        self._report = report
        self._refusals = refusals
        self._is_neighbour = is_neighbour
        self._work: queue.SimpleQueue[Callable[[], object] | None] = queue.SimpleQueue()
        self._tokens: tuple[dict[str, Any], dict[str, Any]] = {}, {}
        """By the side on which we declared it, for what is on the other."""
        self._routes: dict[tuple[int, str, str], tuple[Any, Counter[str]]] = {}
        """What takes messages or questions for an endpoint of the other side, and the tokens of those it is there for."""
        self._admission = Admission(self._lives_here, refusals)
        self._here: Counter[str] = Counter()
        """The sessions of this machine that have announced anything, processes without a socket included."""
        self._own_gids: set[bytes] = set()
        """Of this machine's publishers and clients: nobody else speaks in their names."""
        self._links: Counter[str] = Counter()
        """How many links there are to each session that is joined to the outer one."""
        self._flooded = False
        self._let_in = 0.0
        self._declared: list[Any] = []
        self._hearing: list[Any] = []
        """What hears the tokens of other machines."""
        self._thread = threading.Thread(target=self._run, name="day6-bridge", daemon=True)
        self._thread.start()
        self._follow_links()
        for side in (_INNER, _OUTER):
            self._listen(side)

    def close(self) -> None:
        """Take down what was mirrored and close both sessions, that of this machine's processes first."""
        import zenoh

        self._work.put(None)
        self._thread.join(timeout=1.0)
        for session in self._sessions:
            with suppress(zenoh.ZError):
                session.close()
        for declared in (*self._tokens, self._routes):
            declared.clear()
        self._declared.clear()
        self._hearing.clear()
        self._sessions = ()  # type: ignore[assignment]

    def _follow_links(self) -> None:
        import zenoh

        def on_event(event: zenoh.LinkEvent) -> None:
            there = event.kind == zenoh.SampleKind.PUT
            self._work.put(partial(self._take_link, str(event.link.zid), there))

        # The event of a transport comes only after all its tokens are withdrawn.
        handler = zenoh.handlers.Callback(callback(on_event), indirect=False)
        outer = self._sessions[_OUTER]
        self._declared.append(outer.info.declare_link_events_listener(handler, history=True))

    def _listen(self, side: int) -> None:
        # A chunk that begins with @, as of the caches of transient-local publishers, is matched by no wildcard.
        caches = f"{self._domain_id}/**/@adv/**"
        self._declared += [self._hear_messages(side, caches), self._hear_questions(side, caches)]
        hearing = self._declared if side == _INNER else self._hearing
        hearing += [self._hear_tokens(side, key) for key in (f"@ros2_lv/{self._domain_id}/**", caches)]

    def _hear_tokens(self, side: int, key: str) -> Any:
        import zenoh

        handler = zenoh.handlers.Callback(callback(partial(self._on_token, side)), indirect=False)
        return self._sessions[side].liveliness().declare_subscriber(key, handler, history=True)

    def _hear_messages(self, side: int, key: str) -> Any:
        import zenoh

        handler = zenoh.handlers.Callback(callback(partial(self._on_sample, side)), indirect=False)
        return self._sessions[side].declare_subscriber(key, handler, allowed_origin=zenoh.Locality.REMOTE)

    def _hear_questions(self, side: int, key: str) -> Any:
        import zenoh

        handler = zenoh.handlers.Callback(callback(partial(self._on_query, side)), indirect=False)
        return self._sessions[side].declare_queryable(key, handler, complete=True, allowed_origin=zenoh.Locality.REMOTE)

    # on Zenoh's threads: nothing here may wait

    def _on_sample(self, side: int, sample: zenoh.Sample) -> None:
        if side == _OUTER and self._is_forged(sample.attachment):
            self._refusals.add("sessions")
        elif self._work.qsize() < _MOST_MESSAGES:
            self._work.put(partial(self._pass_sample, 1 - side, sample))

    def _on_query(self, side: int, query: zenoh.Query) -> None:
        if side == _OUTER and self._is_forged(query.attachment):
            self._refusals.add("sessions")
            query.drop()
        elif side == _OUTER and self._work.qsize() >= _MOST_MESSAGES:
            query.drop()
        else:
            self._work.put(partial(self._pass_query, 1 - side, query))

    def _on_token(self, side: int, sample: zenoh.Sample) -> None:
        import zenoh

        if side == _OUTER and self._work.qsize() >= MOST_WAITING:
            self._flooded = True
            return
        present = sample.kind == zenoh.SampleKind.PUT
        self._work.put(partial(self._take_token, side, str(sample.key_expr), present))

    def _is_forged(self, attachment: zenoh.ZBytes | None) -> bool:
        return attachment is not None and attachment.to_bytes()[-_GID_BYTES:] in self._own_gids

    # on the bridge's thread

    def _run(self) -> None:
        end = time.monotonic() + _SLICE
        while True:
            try:
                work = self._work.get(timeout=_LET_IN)
            except queue.Empty:
                work = self._look_after
            if work is None:
                return
            try:
                work()
                self._look_after()
            except Exception as error:
                # One thing could not be passed on (the other side is gone at this moment, say): the others can.
                self._report("the bridge to other machines", error)
            if time.monotonic() > end:
                time.sleep(_PAUSE)
                end = time.monotonic() + _SLICE

    def _look_after(self) -> None:
        if self._flooded and self._work.empty():
            self._begin_anew()
        now = time.monotonic()
        if now - self._let_in > _LET_IN:
            self._let_in = now
            for key, token in self._admission.let_in():
                self._mirror(_INNER, key, token)

    def _begin_anew(self) -> None:
        """After a flood, of which not all was heard: forget what other machines announced, and hear it again."""
        self._flooded = False
        self._refusals.add("floods")
        self._forget(None)
        for _ in range(len(self._hearing)):
            self._hearing.pop().undeclare()
        for key in (f"@ros2_lv/{self._domain_id}/**", f"{self._domain_id}/**/@adv/**"):
            self._hearing.append(self._hear_tokens(_OUTER, key))

    def _take_link(self, zid: str, there: bool) -> None:
        self._links[zid] += 1 if there else -1
        if self._links[zid] > 0:
            return
        del self._links[zid]
        # Zenoh withdraws its tokens one by one, which takes long when they are many. Behind a router there may be more
        # sessions than that one; of these we hear by and by.
        self._forget(zid if self._links else None)

    def _forget(self, zid: str | None) -> None:
        for key in self._admission.of(zid):
            self._take_foreign(key, False)

    def _take_token(self, side: int, key: str, present: bool) -> None:
        if key in self._tokens[side]:
            return  # our own, for what is on the other side
        if side == _INNER:
            self._take_own(key, present)
        else:
            self._take_foreign(key, present)

    def _take_own(self, key: str, present: bool) -> None:
        token = token_of(key)
        if token is None or present == (key in self._tokens[_OUTER]):
            return
        speaks = token.kind in (EndpointKind.PUBLISHER.value, EndpointKind.CLIENT.value)
        if present:
            self._here[token.zid] += 1
            if speaks:
                self._own_gids.add(gid_of(key))
            self._mirror(_OUTER, key, token)
            return
        self._here[token.zid] -= 1
        if not self._here[token.zid]:
            del self._here[token.zid]
        if speaks:
            self._own_gids.discard(gid_of(key))
        self._unmirror(_OUTER, key, token)

    def _take_foreign(self, key: str, present: bool) -> None:
        token = self._admission.come(key) if present else self._admission.go(key)
        if token is None:
            return
        if present:
            self._mirror(_INNER, key, token)
        else:
            self._unmirror(_INNER, key, token)

    def _lives_here(self, zid: str) -> bool:
        return zid in self._here or self._is_neighbour(zid)

    def _mirror(self, side: int, key: str, token: Token) -> None:
        # First what receives, then the token: who sees the token may send at once.
        hear = {EndpointKind.SUBSCRIPTION.value: self._hear_messages, EndpointKind.SERVICE.value: self._hear_questions}
        if token.kind in hear:
            way = side, token.kind, token.data_key
            if way not in self._routes:
                self._routes[way] = hear[token.kind](side, token.data_key), Counter()
            self._routes[way][1][key] += 1
        self._tokens[side][key] = self._sessions[side].liveliness().declare_token(key)

    def _unmirror(self, side: int, key: str, token: Token) -> None:
        if (declared := self._tokens[side].pop(key, None)) is not None:
            declared.undeclare()
        way = side, token.kind, token.data_key
        if way in self._routes:
            receiver, users = self._routes[way]
            users.pop(key, None)
            if not users:
                del self._routes[way]
                receiver.undeclare()

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


def _answer(query: zenoh.Query, answer: zenoh.Sample) -> None:
    # By its time a late joiner knows a message that it has been given before.
    query.reply(
        answer.key_expr,
        answer.payload,
        encoding=answer.encoding,
        attachment=answer.attachment,
        timestamp=answer.timestamp,
    )
