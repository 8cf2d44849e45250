"""The link: one Zenoh session that joins a graph to those of the other processes."""

from __future__ import annotations

import threading
import time
from collections import Counter, defaultdict, deque
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from queue import Empty
from typing import TYPE_CHECKING, Any, TypeAlias

from day6_core.graph.endpoints import Client, Endpoint, Publisher, RequestId, Service
from day6_core.graph.graph import Graph, GraphEvent
from day6_core.graph.node import Node
from day6_core.inbox import Inbox
from day6_core.interrupts import DEFERRED, unsignalled
from day6_core.link.announcing import Announcements
from day6_core.link.config import command_config, process_config
from day6_core.link.engine import chosen, engine_of, is_local, why_no_zenoh
from day6_core.link.engine_thread import callback, inside_callback, open_session
from day6_core.link.gid import gid_of
from day6_core.link.kept_files import KeptFiles
from day6_core.link.keys import (
    PRESENCE_PREFIX,
    all_presence_tokens,
    all_tokens,
    endpoint_token,
    new_zid,
    presence_token,
)
from day6_core.link.limits import MOST_PRESENCE_TOKENS, MOST_WAITING, Refusals
from day6_core.link.meeting import MeetingPoint
from day6_core.link.pace import WorkSlices
from day6_core.link.passing import Passing
from day6_core.link.paths import (
    LinkError,
    MeetingPlace,
    Neighbour,
    Neighbourhood,
    close_inherited_sockets,
    count_with_zenoh,
    meeting_place,
    neighbours,
    remove_dead_sockets,
    remove_if_deaf,
    remove_socket,
)
from day6_core.link.process_reports import Question, answer, offer
from day6_core.link.remote import RemoteGraph
from day6_core.link.services import Services
from day6_core.link.topics import Topics
from day6_core.reason import named_reason, reason
from day6_core.virtual.surroundings import is_virtual

if TYPE_CHECKING:
    import zenoh

    from day6_core.link.classroom.part import ClassPart
    from day6_core.link.gateway import Gateway
    from day6_core.link.state import Door, LinkState

_CHECK_SECONDS = 1.0
"""Seconds between attempts to become the meeting point's holder; the end of its token triggers one at once."""
_SEARCH_SECONDS = 0.05
"""Seconds between them while no meeting point is known: a killed holder's token may end before its lock does."""
_ALONE_SECONDS = 5.0
"""After so long without anybody, a session is opened anew. Where a cleaner had taken the files of all and the meeting
point went to another process, one in a hundred stayed alone; one cause was found since (see `kept_files.spared`)."""
_MOST_PROBLEMS = 50
_LONGEST_PROBLEM = 500
_PRESENCE_PARTS = 4
_LONGEST_ZID = 32
_GATE_PATIENCE = 1.0
"""Seconds that joining waits for the doors to other machines, which open in the background."""
_RETRY_SECONDS = 1.0
"""Seconds between attempts to admit what was refused because a limit was reached."""


_Entry: TypeAlias = "zenoh.Sample | zenoh.Query | tuple[bool, str] | threading.Event | Node | Endpoint | None"
"""An entry of the link thread's inbox: a token (present or gone), a question, an event, a local node or endpoint, or None."""


class Link:
    """Keeps one graph joined until `close()`. Made by `day6_core.link.join`.

    `problem` is the reason why there is no link (None if there is one); `problems` are the latest errors on it.
    """

    def __init__(
        self,
        graph: Graph,
        *,
        listen: Sequence[str] = (),
        connect: Sequence[str] = (),
        one_shot: bool = False,
        never_wait: bool = False,
        secret: str | None = None,
        part: ClassPart | None = None,
    ) -> None:
        self.graph = graph
        self.zid = new_zid()
        self.problem: str | None = None
        self.problems: deque[str] = deque(maxlen=_MOST_PROBLEMS)
        self._one_shot = one_shot
        self._never_wait = never_wait
        self._listen, self._connect = tuple(listen), tuple(connect)
        self._secret = secret
        self._part = part
        self.refusals = Refusals()
        self._remote = RemoteGraph(graph, self.zid, self.refusals, self._is_neighbour)
        self._neighbourhood: Neighbourhood | None = None
        self._kept = KeptFiles()
        self._met_at = 0.0
        """When somebody was there last."""
        self._last_retry = 0.0
        self._place: MeetingPlace | None = None
        self._meeting: MeetingPoint | None = None
        self._session: zenoh.Session | None = None
        self._gate: Gateway | None = None
        self._topics: Topics | None = None
        self._services: Services | None = None
        self._announcements: Announcements | None = None
        self._listeners: list[Passing] = []
        self._token_subscribers: list[zenoh.Subscriber[None]] = []
        self._presence_token: zenoh.LivelinessToken | None = None
        self._reports: zenoh.Queryable[None] | None = None
        self._remove_listener: Callable[[], None] | None = None
        # Zenoh's threads never touch the graph's structure, they only put entries here: they may hold locks of Zenoh's.
        self._inbox: Inbox[_Entry] = Inbox()
        self._changed = threading.Condition()
        self._presence: defaultdict[str, set[str]] = defaultdict(set)
        self._closed = False
        self._thread = threading.Thread(target=self._run, name="day6-link", daemon=True)

    # -- opening and closing -------------------------------------------------------------------------------------------

    def open(self) -> None:
        """Open the session and start the thread that follows the others.

        Raises:
            LinkError: the other processes cannot be reached; the message gives the reason.
        """
        chosen()  # first: only who has tried to import Zenoh knows whether it can be had, and so where to meet
        place = meeting_place(self.graph.domain_id)
        try:
            self._meet(place)
        except LinkError:
            self.close()
            raise
        except (self._engine.ZError, OSError) as error:
            self.close()
            raise LinkError(f"{place.folder}: {reason(error)}") from error
        with unsignalled():
            self._thread.start()
        self._open_gate(place, _GATE_PATIENCE)

    def _meet(self, place: MeetingPlace) -> None:
        """Join the others in a meeting place. Raises the engine's ZError, OSError."""
        self._place, self._neighbourhood, self._kept = place, Neighbourhood(place), KeptFiles()
        self._met_at = time.monotonic()
        remove_dead_sockets(place)
        if is_local():
            self._one_shot = False  # being a member costs nothing more than being a client
            engine = chosen()
            self._attach_unless_closed(engine.Session(engine.Config(place, self.zid)))
            return
        if self._one_shot:
            self._try_as_client()
            return
        self._meeting = MeetingPoint(place, self.graph.domain_id)
        self._meeting.try_to_hold()
        self._attach_unless_closed(open_session(process_config(place, self.zid)))

    def _open_gate(self, place: MeetingPlace, patience: float) -> None:
        if (self._listen or self._connect) and not is_local():
            from day6_core.link.gateway import Gateway

            self._gate = Gateway(
                place,
                self.graph.domain_id,
                self._listen,
                self._connect,
                self._secret,
                self._report,
                self._is_neighbour,
                self._part,
            )
            self._gate.start(patience)

    def close(self, *, ending: bool = False) -> None:
        """Leave: undeclare everything, remove remote nodes from the graph. A second call does nothing.

        `ending`: this process is done; a meeting point it holds is kept until then (see `MeetingPoint.keep`).
        """
        with self._changed:
            if self._closed:
                return
            self._closed = True
            self._changed.notify_all()
        self._inbox.put(None)
        if self._thread.is_alive() and threading.current_thread() is not self._thread:
            self._thread.join(timeout=2.0)
        for listener in self._listeners:
            listener.close()
        self._detach()
        if ending and self._meeting is not None:
            self._meeting.keep()
            self._meeting = None
        self._close_sessions()
        if self._place is not None and self._place.tcp:
            self._place.own_socket(self.zid).unlink(missing_ok=True)
        self._remote.clear()

    @DEFERRED
    def _close_sessions(self) -> None:
        """Close the sessions and drop every Zenoh object at once.

        Their destructors wait for Zenoh's threads; a garbage collection may run on one of those.
        """
        if self._session is None and self._gate is None and self._meeting is None:
            return
        # The processes of this machine first: a gate flooded by other machines takes long.
        owners = [owner for owner in (self._session, self._gate, self._meeting) if owner is not None]
        for closing in (owner.close for owner in owners):
            try:
                closing()
            except self._engine.ZError as error:
                self._report("not closed in an orderly way", error)
        announcements, self._announcements = self._announcements, None
        if announcements is not None:
            announcements.clear()
        self._token_subscribers.clear()
        self._presence_token = self._reports = None
        for carrier in (self._topics, self._services):
            if carrier is not None:
                carrier.close()
        self._session = self._gate = None

    @property
    def closed(self) -> bool:
        """Whether the link has been closed."""
        return self._closed

    @property
    def connected(self) -> bool:
        """Whether a session is open (a one-shot command has none until it finds a meeting point)."""
        return self._session is not None and not self._closed

    def listen_in(self) -> Passing:
        """Return a counter of what other processes send each other; it is closed with the link at the latest."""
        listener = Passing(lambda: self._session, self._is_neighbour)
        self._listeners = [*(each for each in self._listeners if not each.closed), listener]
        return listener

    # -- the graph's Transport -----------------------------------------------------------------------------------------

    def publish(self, publisher: Publisher, message: Any, source_timestamp: int, number: int) -> None:
        """Send a message of a local publisher to its remote subscriptions."""
        if self._topics is not None:
            self._send(self._topics.publish, publisher, message, source_timestamp, number)

    def send_request(self, client: Client, request: Any, number: int) -> None:
        """Send a request of a local client to the remote servers."""
        if self._services is not None:
            with DEFERRED:
                self._send(self._services.send_request, client, request, number)

    def send_response(self, service: Service, request_id: RequestId, response: Any) -> None:
        """Send the response of a local server to a remote client."""
        if self._services is not None:
            self._send(self._services.send_response, service, request_id, response)

    def _send(self, send: Callable[..., None], *arguments: object) -> None:
        try:
            send(*arguments)
        except (self._engine.ZError, LinkError) as error:
            # A program goes on without its network, as in ROS.
            if not self._closed:
                self._report("not sent", error)

    # -- waiting -------------------------------------------------------------------------------------------------------

    def wait_settled(self, timeout: float) -> bool:
        """Wait until the graph holds everything the processes of this machine announced; False after `timeout` seconds.

        Processes are known by their sockets; each declares a presence token once it has announced all it has.
        """
        deadline = time.monotonic() + timeout
        if self._place is None or self.problem is not None:
            return True
        while True:
            if not self._is_anyone_missing() and (self._session is not None or not self._others()):
                break
            left = deadline - time.monotonic()
            if left <= 0:
                return False
            with self._changed:
                self._changed.wait(min(left, 0.02))
        session = self._session
        return session is None or self._read_all_tokens(session, deadline)

    def _others(self) -> list[Neighbour]:
        assert self._place is not None
        return [each for each in neighbours(self._place) if each.zid != self.zid]

    def _is_anyone_missing(self) -> bool:
        return any(each.zid not in self._presence["here"] and not remove_if_deaf(each) for each in self._others())

    def _read_all_tokens(self, session: zenoh.Session, deadline: float) -> bool:
        read, taken = threading.Event(), threading.Event()
        handler = self._engine.handlers.Callback(callback(self._on_reply), read.set, indirect=False)
        try:
            with DEFERRED:
                session.liveliness().get(all_tokens(self.graph.domain_id), handler, timeout=5.0)
        except self._engine.ZError:  # the link is being closed
            return False
        if not read.wait(max(0.0, deadline - time.monotonic())):
            return False
        self._inbox.put(taken)
        return taken.wait(max(0.05, deadline - time.monotonic()))

    # -- the session ---------------------------------------------------------------------------------------------------

    @property
    def _engine(self) -> Any:
        return engine_of(self._session)

    def _try_as_client(self) -> None:
        assert self._place is not None
        if not self._place.tcp and not self._place.meeting_socket.exists():
            return
        try:
            session = open_session(command_config(self._place, self.zid))
        except self._engine.ZError as error:
            self._report("no meeting point", error)
            return
        self._attach_unless_closed(session)

    def _attach_unless_closed(self, session: zenoh.Session) -> None:
        if self._closed:
            session.close()
        else:
            self._attach(session)

    @DEFERRED
    def _attach(self, session: zenoh.Session) -> None:
        """Join the graph to an open session."""

        domain_id = self.graph.domain_id
        self._topics = Topics(session, self.zid, self._remote, self._report, self.refusals, never_wait=self._never_wait)
        self._services = Services(session, self.zid, self._report, self.refusals)
        self._announcements = Announcements(session, self.zid, self._topics, self._services)
        self._session = session
        self._subscribe_tokens(session)
        self.graph.identify = self._identify
        self.graph.transport = self
        self._remove_listener = self.graph.add_listener(self._on_graph_event)
        for node in (*self.graph.nodes, *self.graph.observers):
            self._follow(node)
            for endpoint in node.endpoints:
                self._follow(endpoint)
        assert self._place is not None
        if not self._one_shot:
            if self._place.tcp:
                self._place.own_socket(self.zid).touch()
            if self.graph.report_process is not None:
                self._reports = offer(session, self.graph, self.zid, self._inbox.put)
            self._presence_token = session.liveliness().declare_token(presence_token(domain_id, "here", self.zid))

    def _detach(self) -> None:
        """Part the graph from the session, which is open still."""
        if self._remove_listener is not None:
            self._remove_listener()
            self._remove_listener = None
            self.graph.transport = None
            self.graph.identify = lambda _: self.graph.new_gid()

    def _subscribe_tokens(self, session: zenoh.Session) -> None:
        """Subscribe to all announcements of others; they go to the inbox."""
        for key in (all_presence_tokens(self.graph.domain_id), all_tokens(self.graph.domain_id)):
            handler = self._engine.handlers.Callback(self._inbox.put, indirect=False)
            self._token_subscribers.append(session.liveliness().declare_subscriber(key, handler, history=True))

    def _identify(self, endpoint: Endpoint) -> bytes:
        return gid_of(endpoint_token(endpoint, self.zid))

    # -- from the local graph to the others ----------------------------------------------------------------------------

    def _on_graph_event(self, event: GraphEvent) -> None:
        if event.subject.origin is not None or self._closed:
            return
        if inside_callback():
            self._inbox.put(event.subject)
        else:
            self._follow(event.subject)

    def _follow(self, subject: Node | Endpoint) -> None:
        """Declare or undeclare a local node or endpoint, by whether it exists now: events may come in any order."""
        announcements = self._announcements
        if subject.origin is not None or announcements is None:
            return
        try:
            with DEFERRED:
                announcements.follow(subject)
        except self._engine.ZError as error:
            if not self._closed:
                self._report("not announced", error)

    # -- from the others to the local graph ----------------------------------------------------------------------------

    def _on_reply(self, reply: zenoh.Reply) -> None:
        if reply.ok is not None:
            self._inbox.put((True, str(reply.ok.key_expr)))

    def _run(self) -> None:
        """Process the inbox and maintain the connection; the body of the link's thread."""
        while True:
            entry: _Entry = None
            with suppress(Empty):
                entry = self._inbox.get(timeout=self._patience())
            if self._closed:
                return
            try:
                self._take(entry)
                self._take_backlog()
                self._maintain_connection()
            except Exception as error:
                # A fault of ours, or the system refused a socket: the link goes on.
                self._report("the link's thread", error)

    def _take_backlog(self) -> None:
        pace = WorkSlices()
        while not self._inbox.empty() and not self._closed:
            if self._inbox.qsize() > MOST_WAITING:
                self._start_over()
            self._take(self._inbox.get())
            pace.keep()

    def _start_over(self) -> None:
        """Drop the announcements in the inbox, of which there are too many, and subscribe again, which replays all tokens."""
        for _ in range(self._inbox.qsize()):
            entry = self._inbox.get()
            if not isinstance(entry, (self._engine.Sample, tuple)):
                self._take(entry)
        self.refusals.add("floods")
        self._remote.clear()
        if self._session is not None:
            for _ in range(len(self._token_subscribers)):
                self._token_subscribers.pop().undeclare()
            self._subscribe_tokens(self._session)

    def _take(self, entry: Any) -> None:
        """Take an `_Entry`; which class is whose depends on the engine."""
        if entry is None:
            return
        if isinstance(entry, threading.Event):
            entry.set()
            return
        if isinstance(entry, (Node, Endpoint)):
            self._follow(entry)
            return
        engine = self._engine
        if isinstance(entry, engine.Query):
            answer(entry, self.graph, self.zid)
            return
        if isinstance(entry, engine.Sample):
            entry = entry.kind == engine.SampleKind.PUT, str(entry.key_expr)
        present, key = entry
        if not key.startswith(PRESENCE_PREFIX):
            if present:
                self._remote.appear(key)
            else:
                self._remote.vanish(key)
            return
        parts = key.split("/")
        if len(parts) != _PRESENCE_PARTS or parts[2] not in ("here", "meeting") or len(parts[3]) > _LONGEST_ZID:
            self.refusals.add("names")
            return
        _, _, kind, zid = parts
        with self._changed:
            if not present:
                self._presence[kind].discard(zid)
            elif len(self._presence[kind]) < MOST_PRESENCE_TOKENS or self._is_neighbour(zid):
                self._presence[kind].add(zid)
            else:
                self.refusals.add("processes")
            self._changed.notify_all()

    def _is_neighbour(self, zid: str) -> bool:
        """Return whether a session is a process of this user on this machine: nobody else can be in the meeting place."""
        return self._neighbourhood is not None and zid in self._neighbourhood

    def _patience(self) -> float | None:
        if self._remote.has_room:
            return _RETRY_SECONDS
        if self._one_shot:
            return _SEARCH_SECONDS if self._session is None else None
        if self._session is not None and is_virtual():
            return None  # nobody takes the files of a world, and time would go on for nothing else than these looks
        has_met = self._meeting is None or self._meeting.held_here or self._presence["meeting"]
        return _CHECK_SECONDS if has_met else _SEARCH_SECONDS

    def _maintain_connection(self) -> None:
        if not self._one_shot:
            if self._session is None or self._kept.are_gone(self._own_files()) or self._is_left_alone():
                self._meet_again()
            if self._meeting is not None:
                self._meeting.try_to_hold()
        elif self._session is None:
            self._try_as_client()
        now = time.monotonic()
        if now - self._last_retry > _RETRY_SECONDS:
            self._last_retry = now
            self._remote.admit_waiting()

    def _is_left_alone(self) -> bool:
        """Whether nobody has been found for long, although another process runs the meeting point."""
        others = self._presence["here"] - {self.zid}
        if self._meeting is None or self._meeting.held_here or self._presence["meeting"] or others:
            self._met_at = time.monotonic()
        return time.monotonic() - self._met_at > _ALONE_SECONDS

    def _own_files(self) -> list[Path]:
        assert self._place is not None
        files = [self._place.own_socket(self.zid)]
        if self._meeting is not None and self._meeting.held_here:
            files += self._meeting.files
        return files

    def _meet_again(self) -> None:
        """Begin anew: with our files gone, nobody finds this process any more. Raises the engine's ZError, OSError."""
        place = meeting_place(self.graph.domain_id)  # while there is none, those who have met stay together
        self._detach()
        self._close_sessions()
        if self._place is not None:
            with suppress(OSError):
                remove_socket(self._place.own_socket(self.zid))
        with self._changed:
            self._presence.clear()
        self._remote.clear()
        # A new name: others may not have noticed yet that the former session has ended.
        self.zid = self._remote.own_zid = new_zid()
        self.graph.renew_gids()
        self._meet(place)
        self._open_gate(place, 0.0)

    # -- the reports of other processes --------------------------------------------------------------------------------

    def ask_for_reports(self) -> Question | None:
        """Ask all processes of this machine for their reports; None while there is no session."""
        session = self._session
        return Question(session, self.graph.domain_id) if session is not None and not self._closed else None

    def present(self) -> frozenset[str]:
        """Return the sessions of this user's processes on this machine, without this one."""
        return frozenset(zid for zid in set(self._presence["here"]) if zid != self.zid and self._is_neighbour(zid))

    # -- state and errors ----------------------------------------------------------------------------------------------

    @property
    def doors(self) -> tuple[Door, ...]:
        """The state of each endpoint of `listen` and `connect`."""
        if self._gate is not None:
            return self._gate.doors
        from day6_core.link.state import Door, DoorState

        # Reached when the link itself could not be opened, or without Zenoh.
        kinds = [(endpoint, True) for endpoint in self._listen] + [(endpoint, False) for endpoint in self._connect]
        why = why_no_zenoh("en") or ""
        state = DoorState.FAILED if why else DoorState.OPENING
        secret = self._secret is not None
        return tuple(Door(endpoint, listening, state, secret, reason=why) for endpoint, listening in kinds)

    @property
    def state(self) -> LinkState:
        """The state to show to people: the reason if there is no link, all processes' doors, counts of refusals."""
        from day6_core.link.state import LinkState, read_doors

        doors = read_doors(self._place) if self._place is not None else ()
        passed_over = self._place.passed_over if self._place is not None else ()
        refused = Counter(self.refusals.counts)
        if self._gate is not None:
            refused.update(self._gate.refusals.counts)
        with_zenoh = count_with_zenoh(self._place) if self._place is not None else 0
        return LinkState(self.problem, doors or self.doors, refused, passed_over, with_zenoh)

    def abandon(self) -> None:
        """In a forked child: drop everything without touching Zenoh, whose threads stayed in the parent."""
        self._closed = True
        if self._meeting is not None:
            self._meeting.release_copy()
        self.graph.transport = None
        self.graph.identify = lambda _: self.graph.new_gid()
        self.graph.renew_lock()
        abandon: Callable[[], None] | None = getattr(self._session, "abandon", None)  # Zenoh's has none
        if abandon is not None:
            abandon()
        elif self._place is not None and not self._place.tcp:
            close_inherited_sockets(self._place)

    def _report(self, what: str, error: Exception) -> None:
        self.problems.append(f"{what}: {named_reason(error)}"[:_LONGEST_PROBLEM])
