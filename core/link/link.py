"""The link: one Zenoh session that joins a graph to those of the other processes."""

from __future__ import annotations

import threading
import time
from collections import defaultdict, deque
from collections.abc import Callable, Sequence
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, TypeAlias

from day6_tui.core.graph.endpoints import Client, Endpoint, Publisher, RequestId, Service
from day6_tui.core.graph.graph import Graph, GraphEvent
from day6_tui.core.graph.node import Node
from day6_tui.core.link.announcing import Announcements
from day6_tui.core.link.config import command_config, gate_config, inner_config, outer_config, process_config
from day6_tui.core.link.engine_thread import callback, inside_callback
from day6_tui.core.link.gid import gid_of
from day6_tui.core.link.keys import SIGN_PREFIX, all_tokens, endpoint_token, new_zid, sign, signs
from day6_tui.core.link.meeting import MeetingPoint
from day6_tui.core.link.paths import (
    LinkError,
    Neighbour,
    Place,
    close_inherited_sockets,
    meeting_place,
    neighbours,
    remove_dead_sockets,
    remove_if_deaf,
)
from day6_tui.core.link.remote import RemoteGraph
from day6_tui.core.link.services import Services
from day6_tui.core.link.topics import Topics

if TYPE_CHECKING:
    import zenoh

    from day6_tui.core.link.bridge import Bridge

_LOOK_AGAIN = 1.0
"""Seconds between looks whether the meeting point needs a keeper; the end of its token makes it look at once."""
_SEARCH_AGAIN = 0.05
"""The same while no meeting point is known: a killed keeper's token may end before its lock does."""
_MOST_PROBLEMS = 50


_Entry: TypeAlias = "zenoh.Sample | tuple[bool, str] | threading.Event | Node | Endpoint | None"
"""What waits for the link's thread: a token (there or gone), a mark to set, a local thing to declare or withdraw, or nothing."""


class Link:
    """Keeps one graph joined until `close()`. Made by `day6_tui.core.link.join`.

    `problem` says why there is no link (None if there is); `problems` are the last things that went wrong on it.
    """

    def __init__(
        self,
        graph: Graph,
        *,
        listen: Sequence[str] = (),
        connect: Sequence[str] = (),
        one_shot: bool = False,
        never_wait: bool = False,
    ) -> None:
        self.graph = graph
        self.zid = new_zid()
        self.problem: str | None = None
        self.problems: deque[str] = deque(maxlen=_MOST_PROBLEMS)
        self._one_shot = one_shot
        self._never_wait = never_wait
        self._listen, self._connect = tuple(listen), tuple(connect)
        self._remote = RemoteGraph(graph, self.zid)
        self._place: Place | None = None
        self._meeting: MeetingPoint | None = None
        self._session: zenoh.Session | None = None
        self._gate: zenoh.Session | Bridge | None = None
        self._topics: Topics | None = None
        self._services: Services | None = None
        self._announcements: Announcements | None = None
        self._listeners: list[Any] = []
        self._end_listening: Callable[[], None] | None = None
        # All that Zenoh's threads ever do with the graph's structure is to put something here: they may hold locks of theirs.
        self._inbox: SimpleQueue[_Entry] = SimpleQueue()
        self._changed = threading.Condition()
        self._signs: defaultdict[str, set[str]] = defaultdict(set)
        self._closed = False
        self._thread = threading.Thread(target=self._run, name="day6-link", daemon=True)

    # life

    def open(self) -> None:
        """Open the session and start the thread that follows the others. Raises LinkError."""
        try:
            import zenoh
        except ImportError as error:
            raise LinkError(f"no Zenoh here: {error}") from error
        self._place = place = meeting_place(self.graph.domain_id)
        try:
            remove_dead_sockets(place)
            if self._one_shot:
                self._try_as_client()
            else:
                self._meeting = MeetingPoint(place, self.graph.domain_id)
                self._meeting.try_to_keep()
                self._attach(zenoh.open(process_config(place, self.zid)))
                if self._listen or self._connect:
                    self._open_gate(place)
        except LinkError:
            self.close()
            raise
        except (zenoh.ZError, OSError) as error:
            self.close()
            raise LinkError(f"{place.folder}: {error}") from error
        self._thread.start()

    def close(self) -> None:
        """Leave: tell the others, remove remote nodes from the graph. A second call does nothing."""
        with self._changed:
            if self._closed:
                return
            self._closed = True
            self._changed.notify_all()
        self._inbox.put(None)
        if self._thread.is_alive() and threading.current_thread() is not self._thread:
            self._thread.join(timeout=2.0)
        if self._end_listening is not None:
            self._end_listening()
            self.graph.transport = None
            self.graph.identify = lambda _: self.graph.new_gid()
        self._close_sessions()
        if self._place is not None and self._place.tcp:
            self._place.own_socket(self.zid).unlink(missing_ok=True)
        self._remote.clear()

    def _close_sessions(self) -> None:
        """Close them and let go of every object of Zenoh's, here and now.

        Their destructors wait for Zenoh's threads; a garbage collection may run on one of those.
        """
        if self._session is None and self._gate is None and self._meeting is None:
            return
        import zenoh

        sessions = [session for session in (self._session, self._gate) if session is not None]
        for closing in (*(session.close for session in sessions), *((self._meeting.close,) if self._meeting else ())):
            try:
                closing()
            except zenoh.ZError as error:
                self._report("not closed in an orderly way", error)
        announcements, self._announcements = self._announcements, None
        if announcements is not None:
            announcements.clear()
        self._listeners.clear()
        for carrier in (self._topics, self._services):
            if carrier is not None:
                carrier.close()
        self._session = self._gate = None

    @property
    def closed(self) -> bool:
        """Say whether the link was closed."""
        return self._closed

    @property
    def connected(self) -> bool:
        """Say whether a session is open (a one-shot command has none until it finds a meeting point)."""
        return self._session is not None and not self._closed

    # what the graph asks (Transport)

    def publish(self, publisher: Publisher, message: Any, source_timestamp: int, number: int) -> None:
        """Send a message of a local publisher to its remote subscriptions."""
        if self._topics is not None:
            self._sending(self._topics.publish, publisher, message, source_timestamp, number)

    def send_request(self, client: Client, request: Any, number: int) -> None:
        """Send a request of a local client to the remote servers."""
        if self._services is not None:
            self._sending(self._services.send_request, client, request, number)

    def send_response(self, service: Service, request_id: RequestId, response: Any) -> None:
        """Send the response of a local server to a remote client."""
        if self._services is not None:
            self._sending(self._services.send_response, service, request_id, response)

    def _sending(self, send: Callable[..., None], *arguments: object) -> None:
        import zenoh

        try:
            send(*arguments)
        except zenoh.ZError as error:
            # A program goes on when its network does not, as in ROS.
            if not self._closed:
                self._report("not sent", error)

    # waiting

    def wait_settled(self, timeout: float) -> bool:
        """Wait until the graph holds what the processes of this machine announced; False if not within `timeout` s.

        Processes are known by their sockets; each says by a token that it has announced what it had.
        """
        deadline = time.monotonic() + timeout
        if self._place is None or self.problem is not None:
            return True
        while True:
            missing = self._missing()
            if not missing and (self._session is not None or not self._others()):
                break
            left = deadline - time.monotonic()
            if left <= 0:
                return False
            with self._changed:
                self._changed.wait(min(left, 0.02))
        if self._session is None:
            return True
        return self._read_all_tokens(deadline)

    def _others(self) -> list[Neighbour]:
        assert self._place is not None
        return [each for each in neighbours(self._place) if each.zid != self.zid]

    def _missing(self) -> bool:
        return any(each.zid not in self._signs["here"] and not remove_if_deaf(each) for each in self._others())

    def _read_all_tokens(self, deadline: float) -> bool:
        import zenoh

        read, taken = threading.Event(), threading.Event()
        assert self._session is not None
        handler = zenoh.handlers.Callback(callback(self._on_reply), read.set, indirect=False)
        self._session.liveliness().get(all_tokens(self.graph.domain_id), handler, timeout=5.0)
        if not read.wait(max(0.0, deadline - time.monotonic())):
            return False
        self._inbox.put(taken)
        return taken.wait(max(0.05, deadline - time.monotonic()))

    # the session

    def _open_gate(self, place: Place) -> None:
        """Join the meeting point to other machines."""
        import zenoh

        if not place.tcp:
            self._gate = zenoh.open(gate_config(place, self._listen, self._connect))
            return
        from day6_tui.core.link.bridge import Bridge

        inner = zenoh.open(inner_config(place))
        try:
            outer = zenoh.open(outer_config(self._listen, self._connect))
        except zenoh.ZError:
            inner.close()
            raise
        self._gate = Bridge(inner, outer, self.graph.domain_id, self._report)

    def _try_as_client(self) -> None:
        import zenoh

        assert self._place is not None
        if not self._place.tcp and not (self._place.folder / "meet").exists():
            return
        try:
            session = zenoh.open(command_config(self._place, self.zid))
        except zenoh.ZError as error:
            self._report("no meeting point", error)
            return
        if self._closed:
            session.close()
            return
        self._attach(session)

    def _attach(self, session: zenoh.Session) -> None:
        """Join the graph to an open session."""
        import zenoh

        domain_id = self.graph.domain_id
        self._topics = Topics(session, self.zid, self._remote, self._report, never_wait=self._never_wait)
        self._services = Services(session, self.zid, self._report)
        self._announcements = Announcements(session, self.zid, self._topics, self._services)
        self._session = session
        liveliness = session.liveliness()
        for key in (signs(domain_id), all_tokens(domain_id)):
            # Zenoh calls on this thread too, from within a declaration. A function of ours there would take a Ctrl-C, which
            # Zenoh would swallow; in one of Python's own it waits until the program's code goes on.
            handler = zenoh.handlers.Callback(self._inbox.put, indirect=False)
            self._listeners.append(liveliness.declare_subscriber(key, handler, history=True))
        self.graph.identify = self._identify
        self.graph.transport = self
        self._end_listening = self.graph.add_listener(self._on_graph_event)
        for node in self.graph.nodes:
            self._follow(node)
            for endpoint in node.endpoints:
                self._follow(endpoint)
        assert self._place is not None
        if not self._one_shot:
            if self._place.tcp:
                self._place.own_socket(self.zid).touch()
            self._listeners.append(liveliness.declare_token(sign(domain_id, "here", self.zid)))

    def _identify(self, endpoint: Endpoint) -> bytes:
        return gid_of(endpoint_token(endpoint, self.zid))

    # from the local graph to the others

    def _on_graph_event(self, event: GraphEvent) -> None:
        if event.subject.origin is not None or self._closed:
            return
        if inside_callback():
            self._inbox.put(event.subject)
        else:
            self._follow(event.subject)

    def _follow(self, subject: Node | Endpoint) -> None:
        """Declare or withdraw a local node or endpoint, whatever it is now: events may come in any order."""
        import zenoh

        announcements = self._announcements
        if subject.origin is not None or announcements is None:
            return
        try:
            announcements.follow(subject)
        except zenoh.ZError as error:
            if not self._closed:
                self._report("not announced", error)

    # from the others to the local graph

    def _on_reply(self, reply: zenoh.Reply) -> None:
        if reply.ok is not None:
            self._inbox.put((True, str(reply.ok.key_expr)))

    def _run(self) -> None:
        """Take what came in, look after the meeting point; the body of the link's thread."""
        while True:
            entry: _Entry = None
            with suppress(Empty):
                entry = self._inbox.get(timeout=self._patience())
            if self._closed:
                return
            try:
                self._take(entry)
                while not self._inbox.empty():
                    self._take(self._inbox.get())
                self._look_after_connection()
            except Exception as error:
                # A listener of the graph failed, or the system refused a socket: the link goes on.
                self._report("the link's thread", error)

    def _take(self, entry: _Entry) -> None:
        import zenoh

        if entry is None:
            return
        if isinstance(entry, threading.Event):
            entry.set()
            return
        if isinstance(entry, (Node, Endpoint)):
            self._follow(entry)
            return
        if isinstance(entry, zenoh.Sample):
            entry = entry.kind == zenoh.SampleKind.PUT, str(entry.key_expr)
        present, key = entry
        if not key.startswith(SIGN_PREFIX):
            if present:
                self._remote.appear(key)
            else:
                self._remote.vanish(key)
            return
        _, _, kind, zid = key.split("/")
        with self._changed:
            if present:
                self._signs[kind].add(zid)
            else:
                self._signs[kind].discard(zid)
            self._changed.notify_all()

    def _patience(self) -> float | None:
        if self._meeting is not None:
            if self._meeting.kept_here:
                return None
            return _LOOK_AGAIN if self._signs["meeting"] else _SEARCH_AGAIN
        return _SEARCH_AGAIN if self._session is None else None

    def _look_after_connection(self) -> None:
        if self._meeting is not None:
            self._meeting.try_to_keep()
        elif self._session is None:
            self._try_as_client()

    # trouble

    def abandon(self) -> None:
        """In a forked child: let go without touching Zenoh, whose threads stayed in the parent."""
        self._closed = True
        if self._meeting is not None:
            self._meeting.release_copy()
        self.graph.transport = None
        self.graph.identify = lambda _: self.graph.new_gid()
        self.graph.renew_lock()
        if self._place is not None and not self._place.tcp:
            close_inherited_sockets(self._place)

    def _report(self, what: str, error: Exception) -> None:
        self.problems.append(f"{what}: {error}")
