"""The route to other machines: an inner session for this machine's processes and an outer one for other machines.

Messages that the other side subscribes to, queries with their replies, and tokens are forwarded between the two. Nothing
else is, so announcements from outside are checked and limited here, once, before any process of this user sees them, and are
dropped together with the machine they came from. A `Naming` says how keys are written outside; everything in here is about
inner keys. (A Zenoh session presents the same password, or none, to every peer, so one session cannot serve both where this
machine's own meeting point requires a password.)
"""

from __future__ import annotations

import threading
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from queue import Empty
from typing import TYPE_CHECKING, Any

from day6_core.graph.endpoints import EndpointKind
from day6_core.inbox import Inbox
from day6_core.link.admission import Admission, Token, token_of
from day6_core.link.engine_thread import callback
from day6_core.link.gid import gid_of
from day6_core.link.limits import MOST_WAITING, Refusals
from day6_core.link.naming import Naming, Plain
from day6_core.link.pace import WorkSlices

if TYPE_CHECKING:
    import zenoh

Report = Callable[[str, Exception], None]

_MOST_MESSAGES = 10_000
"""Messages queued for the bridge's thread; more are dropped, as on a slow network."""
_QUERY_SECONDS = 3600.0
"""A query stays open as long as its client waits; the result of a goal may take long."""
_RETRY_SECONDS = 1.0
"""Seconds between attempts to admit tokens that were refused because a limit was reached."""
_INNER, _OUTER = 0, 1
_GID_BYTES = 16


class Bridge:
    """Joins two open sessions for one domain until `close`; it owns them.

    `is_neighbour(zid)` is whether a session is one of this user's processes on this machine. Machines rejected because of
    the secret are not known here: Zenoh has no event for it, and its log cannot be read from Python.
    """

    def __init__(
        self,
        inner: zenoh.Session,
        outer: zenoh.Session,
        domain_id: int,
        report: Report,
        refusals: Refusals,
        is_neighbour: Callable[[str], bool],
        naming: Naming | None = None,
    ) -> None:
        self._naming = naming if naming is not None else Plain(domain_id)
        self._sessions = (inner, outer)
        self._domain_id = domain_id
        self._report = report
        self._refusals = refusals
        self._is_neighbour = is_neighbour
        self._work: Inbox[Callable[[], object] | None] = Inbox()
        self._tokens: tuple[dict[str, Any], dict[str, Any]] = {}, {}
        """The tokens we declared, by side; each mirrors one of the other side."""
        self._routes: dict[tuple[int, str, str], tuple[Any, Counter[str]]] = {}
        """The subscriber or queryable that receives for endpoints of the other side, and the tokens of those endpoints."""
        self._admission = Admission(self._lives_here, refusals)
        self._here: Counter[str] = Counter()
        """The sessions of this machine that have announced anything, including processes without a socket."""
        self._own_gids: set[bytes] = set()
        """Outer GIDs of this machine's publishers and clients: nobody else may send in their names."""
        self._foreign: dict[str, str] = {}
        """inner -> outer key of the tokens of other machines, if the naming renames"""
        self._gids: tuple[dict[bytes, bytes], dict[bytes, bytes]] = {}, {}
        """GIDs as that side knows them, by those of the other side, if the naming renames."""
        self._links: Counter[str] = Counter()
        """Number of links to each session connected to the outer one."""
        self._flooded = False
        self._last_retry = 0.0
        self._declared: list[Any] = []
        self._token_subscribers: list[Any] = []
        """The subscribers for the tokens of other machines."""
        self._thread = threading.Thread(target=self._run, name="day6-bridge", daemon=True)
        self._thread.start()
        self._follow_links()
        for side in (_INNER, _OUTER):
            self._listen(side)

    def close(self) -> None:
        """Remove all mirrored tokens and close both sessions, the inner one first."""
        import zenoh

        self._work.put(None)
        self._thread.join(timeout=1.0)
        for session in self._sessions:
            with suppress(zenoh.ZError):
                session.close()
        for declared in (*self._tokens, self._routes):
            declared.clear()
        self._declared.clear()
        self._token_subscribers.clear()
        self._sessions = ()  # type: ignore[assignment]

    def _follow_links(self) -> None:
        import zenoh

        def on_event(event: zenoh.LinkEvent) -> None:
            present = event.kind == zenoh.SampleKind.PUT
            self._work.put(partial(self._take_link, str(event.link.zid), present))

        # A transport's event comes only after all its tokens are undeclared.
        handler = zenoh.handlers.Callback(callback(on_event), indirect=False)
        outer = self._sessions[_OUTER]
        self._declared.append(outer.info.declare_link_events_listener(handler, history=True))

    def _listen(self, side: int) -> None:
        naming = self._naming if side == _OUTER else Plain(self._domain_id)
        self._declared += [self._receive_messages(side, naming.caches()), self._receive_queries(side, naming.caches())]
        subscribers = self._declared if side == _INNER else self._token_subscribers
        subscribers += [self._subscribe_tokens(side, key) for key in naming.tokens()]

    def _subscribe_tokens(self, side: int, key: str) -> Any:
        import zenoh

        handler = zenoh.handlers.Callback(callback(partial(self._on_token, side)), indirect=False)
        return self._sessions[side].liveliness().declare_subscriber(key, handler, history=True)

    def _receive_messages(self, side: int, key: str) -> Any:
        import zenoh

        handler = zenoh.handlers.Callback(callback(partial(self._on_sample, side)), indirect=False)
        return self._sessions[side].declare_subscriber(key, handler, allowed_origin=zenoh.Locality.REMOTE)

    def _receive_queries(self, side: int, key: str) -> Any:
        import zenoh

        handler = zenoh.handlers.Callback(callback(partial(self._on_query, side)), indirect=False)
        return self._sessions[side].declare_queryable(key, handler, complete=True, allowed_origin=zenoh.Locality.REMOTE)

    # -- on Zenoh's threads: nothing here may block --------------------------------------------------------------------

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
        key = str(sample.key_expr)
        inner = self._naming.heard(key) if side == _OUTER else key
        if inner is None:
            self._refusals.add("names")
            return
        self._work.put(partial(self._take_token, side, inner, present, key))

    def _is_forged(self, attachment: zenoh.ZBytes | None) -> bool:
        return attachment is not None and attachment.to_bytes()[-_GID_BYTES:] in self._own_gids

    # -- on the bridge's thread ----------------------------------------------------------------------------------------

    def _run(self) -> None:
        pace = WorkSlices()
        while True:
            try:
                work = self._work.get(timeout=_RETRY_SECONDS)
            except Empty:
                work = self._do_upkeep
            if work is None:
                return
            try:
                work()
                self._do_upkeep()
            except Exception as error:
                # One item could not be forwarded (the other side has just gone, say): the others can.
                self._report("the bridge to other machines", error)
            pace.keep()

    def _do_upkeep(self) -> None:
        if self._flooded and self._work.empty():
            self._start_over()
        now = time.monotonic()
        if now - self._last_retry > _RETRY_SECONDS:
            self._last_retry = now
            for key, token in self._admission.admit_waiting():
                self._mirror(_INNER, key, token)

    def _start_over(self) -> None:
        """After a flood, part of which was dropped: forget what other machines announced, and subscribe again."""
        self._flooded = False
        self._refusals.add("floods")
        self._forget(None)
        for _ in range(len(self._token_subscribers)):
            self._token_subscribers.pop().undeclare()
        for key in self._naming.tokens():
            self._token_subscribers.append(self._subscribe_tokens(_OUTER, key))

    def _take_link(self, zid: str, present: bool) -> None:
        self._links[zid] += 1 if present else -1
        if self._links[zid] > 0:
            return
        del self._links[zid]
        # Zenoh undeclares its tokens one by one, which takes long when there are many. Behind a router there may be more
        # sessions than that one; we hear of their end later.
        self._forget(zid if self._links else None)

    def _forget(self, zid: str | None) -> None:
        for key in self._admission.tokens_of(zid):
            self._take_foreign(key, False)

    def _take_token(self, side: int, key: str, present: bool, written: str) -> None:
        if key in self._tokens[side]:
            return  # our own mirror of a token on the other side
        if side == _INNER:
            self._take_own(key, present)
        else:
            if present and self._naming.renames:
                self._foreign[key] = written
            self._take_foreign(key, present)
            if not present:
                self._foreign.pop(key, None)

    def _take_own(self, key: str, present: bool) -> None:
        token = token_of(key)
        if token is None or present == (key in self._tokens[_OUTER]):
            return
        sends = token.kind in (EndpointKind.PUBLISHER.value, EndpointKind.CLIENT.value)
        if present:
            self._here[token.zid] += 1
            if sends and (sent := self._naming.sent(key)) is not None:
                self._own_gids.add(gid_of(sent))
            self._mirror(_OUTER, key, token)
            return
        self._here[token.zid] -= 1
        if not self._here[token.zid]:
            del self._here[token.zid]
        if sends and (sent := self._naming.sent(key)) is not None:
            self._own_gids.discard(gid_of(sent))
        self._unmirror(_OUTER, key, token)

    def _take_foreign(self, key: str, present: bool) -> None:
        token = self._admission.admit(key) if present else self._admission.remove(key)
        if token is None:
            return
        if present:
            self._mirror(_INNER, key, token)
        else:
            self._unmirror(_INNER, key, token)

    def _lives_here(self, zid: str) -> bool:
        return zid in self._here or self._is_neighbour(zid)

    def _mirror(self, side: int, key: str, token: Token) -> None:
        written = self._naming.sent(key) if side == _OUTER else key
        if written is None:
            return
        # The receiver before the token: whoever sees the token may send at once.
        declare = {
            EndpointKind.SUBSCRIPTION.value: self._receive_messages,
            EndpointKind.SERVICE.value: self._receive_queries,
        }
        if token.kind in declare:
            route = side, token.kind, token.data_key
            awaited = self._naming.awaited(token.data_key) if side == _OUTER else token.data_key
            if route not in self._routes:
                assert awaited is not None  # as for the token of the same topic
                self._routes[route] = declare[token.kind](side, awaited), Counter()
            self._routes[route][1][key] += 1
        self._pair_gids(side, key, written)
        self._tokens[side][key] = self._sessions[side].liveliness().declare_token(written)

    def _pair_gids(self, side: int, key: str, written: str) -> None:
        """An endpoint's GID is the hash of its token, so it has another one on each side."""
        if self._naming.renames:
            inner, outer = gid_of(key), gid_of(written if side == _OUTER else self._foreign.get(key, key))
            self._gids[_INNER][outer], self._gids[_OUTER][inner] = inner, outer

    def _unmirror(self, side: int, key: str, token: Token) -> None:
        if (declared := self._tokens[side].pop(key, None)) is not None:
            declared.undeclare()
        if (outer := self._gids[_OUTER].pop(gid_of(key), None)) is not None:
            self._gids[_INNER].pop(outer, None)
        route = side, token.kind, token.data_key
        if route in self._routes:
            receiver, users = self._routes[route]
            users.pop(key, None)
            if not users:
                del self._routes[route]
                receiver.undeclare()

    def _attachment(self, to: int, attachment: zenoh.ZBytes | None) -> zenoh.ZBytes | bytes | None:
        """Return an attachment with the sender's GID as the side knows it to which it goes."""
        if attachment is None or not self._naming.renames:
            return attachment
        data = attachment.to_bytes()
        gid = data[-_GID_BYTES:]
        return data[:-_GID_BYTES] + self._gids[to].get(gid, gid)

    def _pass_sample(self, to: int, sample: zenoh.Sample) -> None:
        import zenoh

        key = str(sample.key_expr)
        if (written := self._naming.sent(key) if to == _OUTER else self._naming.heard(key)) is None:
            return
        self._sessions[to].put(
            written,
            sample.payload,
            encoding=sample.encoding,
            attachment=self._attachment(to, sample.attachment),
            congestion_control=sample.congestion_control,
            priority=sample.priority,
            timestamp=sample.timestamp,
            allowed_destination=zenoh.Locality.REMOTE,
        )

    def _pass_query(self, to: int, query: zenoh.Query) -> None:
        import zenoh

        def on_reply(reply: zenoh.Reply) -> None:
            if (sample := reply.ok) is not None:
                self._work.put(partial(self._pass_reply, 1 - to, query, sample))

        key = str(query.key_expr)
        if (written := self._naming.sent(key) if to == _OUTER else self._naming.heard(key)) is None:
            query.drop()
            return
        # The query ends when nobody holds it any more: after the last reply has been forwarded.
        self._sessions[to].get(
            zenoh.Selector(written, query.parameters),
            zenoh.handlers.Callback(callback(on_reply), lambda: self._work.put(query.drop), indirect=False),
            target=zenoh.QueryTarget.ALL_COMPLETE if query.payload is not None else zenoh.QueryTarget.ALL,
            consolidation=zenoh.ConsolidationMode.NONE,
            # A cache replies with the keys of its messages, which differ from the key it is queried by.
            accept_replies=query.accepts_replies(),
            timeout=_QUERY_SECONDS,
            payload=query.payload,
            encoding=query.encoding,
            attachment=self._attachment(to, query.attachment),
            allowed_destination=zenoh.Locality.REMOTE,
        )

    def _pass_reply(self, to: int, query: zenoh.Query, sample: zenoh.Sample) -> None:
        key = str(sample.key_expr)
        if (written := self._naming.awaited(key) if to == _OUTER else self._naming.answered(key)) is None:
            return
        # A late joiner recognises a message it already has by its timestamp.
        query.reply(
            written,
            sample.payload,
            encoding=sample.encoding,
            attachment=self._attachment(to, sample.attachment),
            timestamp=sample.timestamp,
        )
