"""The gateway: this process's doors to other machines (`--listen`, `--connect`), kept apart from the local graph.

It has its own sessions and thread, so a failing door (a port in use, an unknown host name, a machine that does not answer)
does not affect the connections among this machine's processes; it is reported, and retried.
"""

from __future__ import annotations

import errno
import os
import re
import socket
import threading
import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from day6_core.interrupts import unsignalled
from day6_core.link.addresses import Address, address_of
from day6_core.link.bridge import Bridge
from day6_core.link.classroom.part import ClassPart
from day6_core.link.config import inner_config, outer_config
from day6_core.link.engine_thread import open_session
from day6_core.link.file_lock import FileLock
from day6_core.link.limits import Refusals
from day6_core.link.naming import Naming
from day6_core.link.paths import MeetingPlace
from day6_core.link.secret import USER
from day6_core.link.state import Door, DoorState, remove_doors, write_doors
from day6_core.whole_file import PRIVATE, replace_file

if TYPE_CHECKING:
    import zenoh

Report = Callable[[str, Exception], None]

POLL_SECONDS = 0.5
RETRY_SECONDS = 2.0
"""Before a door that could not be opened is tried again."""
_CLOSING_SECONDS = 0.7
_ANSWER_SECONDS = 2.0
_PROBE_SECONDS = 5.0
"""Between probes of a machine that does not answer; Zenoh itself keeps trying to connect."""
_ANOTHER = "another program of yours has opened the doors of this domain"
_IN_USE = (errno.EADDRINUSE, 10048, 10013)
"""The last two are Windows' WSAEADDRINUSE, and its WSAEACCES for a port another program uses exclusively."""


class Gateway:
    """Opens the doors in the background and watches them until `close`."""

    def __init__(
        self,
        place: MeetingPlace,
        domain_id: int,
        listen: Sequence[str],
        connect: Sequence[str],
        secret: str | None,
        report: Report,
        is_neighbour: Callable[[str], bool],
        part: ClassPart | None = None,
    ) -> None:
        self._part = part
        self._place = place
        self._domain_id = domain_id
        self._secret = secret
        self._report = report
        self._is_neighbour = is_neighbour
        self.refusals = Refusals()
        self._lock = FileLock(place.folder / "gate.lock")
        doors = [(endpoint, True) for endpoint in listen] + [(endpoint, False) for endpoint in connect]
        self._doors = {
            (endpoint, listening): Door(
                endpoint, listening, secret=secret is not None, is_class=part is not None and part.is_closed
            )
            for endpoint, listening in doors
        }
        self._outer: zenoh.Session | None = None
        self._bridge: Bridge | None = None
        """Owns the session; closed at the end."""
        self._last_tried: dict[str, float] = {}
        self._addresses: dict[str, frozenset[str]] = {}
        """endpoint to connect to -> `host:port` of all its host's addresses, as Zenoh's links write them"""
        self._written: tuple[Door, ...] = ()
        self._closing = threading.Event()
        self._tried = threading.Event()
        self._thread = threading.Thread(target=self._run, name="day6-gate", daemon=True)

    @property
    def doors(self) -> tuple[Door, ...]:
        """The present state of each door."""
        return tuple(self._doors.values())

    def start(self, patience: float) -> None:
        """Open the doors in the background; wait at most `patience` seconds for the first attempt."""
        with unsignalled():
            self._thread.start()
        self._tried.wait(patience)

    def close(self) -> None:
        """Close all doors, in the background if that takes long: with thousands of tokens Zenoh needs seconds."""
        self._closing.set()
        if self._thread.is_alive():
            self._thread.join(timeout=_CLOSING_SECONDS)
        remove_doors(self._place)

    def _run(self) -> None:
        try:
            while not self._closing.is_set():
                try:
                    self._poll()
                except Exception as error:
                    # A failing door must not end the rest of the link.
                    self._report("the gate to other machines", error)
                self._tried.set()
                self._closing.wait(POLL_SECONDS if self._outer is not None else RETRY_SECONDS)
        finally:
            self._shut()
            self._lock.release()

    def _poll(self) -> None:
        """Open what is not open, and update who has connected and who does not answer."""
        if self._outer is None or self._may_listen_now():
            self._open()
        if self._outer is not None and self._part is not None:
            self._take_part(self._part)
        if self._outer is not None:
            self._read_links(self._outer)
        if self.doors != self._written:
            write_doors(self._place, self.doors)
            self._written = self.doors

    # -- opening -------------------------------------------------------------------------------------------------------

    def _may_listen_now(self) -> bool:
        """Return whether a door that could not be opened may now be free."""
        shut = [door for door in self.doors if door.listening and door.state != DoorState.OPEN]
        return bool(shut) and self._due("listen", RETRY_SECONDS) and all(_is_free(door.endpoint) for door in shut)

    def _open(self) -> None:
        import zenoh

        self._shut()
        if not self._lock.try_acquire():
            # Two routes to the same machines would form a loop in which messages circulate forever.
            for endpoint, listening in self._doors:
                self._change(endpoint, listening, state=DoorState.FAILED, reason=_ANOTHER)
            return
        listen, connect = self._endpoints(listening=True), self._endpoints(listening=False)
        if listen:
            try:
                self._open_sessions(listen, connect)
            except zenoh.ZError as error:
                # The error is only a text and does not name the door, so all count as shut.
                for endpoint in listen:
                    self._change(endpoint, True, **_problem_in(str(error))._asdict())
            else:
                for endpoint in listen:
                    self._change(endpoint, True, state=DoorState.OPEN, reason="")
                return
        if connect:
            try:
                self._open_sessions((), connect)
            except zenoh.ZError as error:
                for endpoint in connect:
                    # A pupil's session opens only when the teacher answers; the error does not say why not.
                    problem = _problem_in(str(error)) if self._part is None else _problem_at(endpoint)
                    self._change(endpoint, False, **problem._asdict())

    def _open_sessions(self, listen: Sequence[str], connect: Sequence[str]) -> None:
        """Open the two sessions of the bridge.

        Raises:
            zenoh.ZError: one of them could not be opened.
        """
        import zenoh

        users = self._place.folder / f"guests-{os.getpid()}"
        try:
            if self._secret is not None:
                replace_file(users, f"{USER}:{self._secret}\n".encode(), mode=PRIVATE, sync=False, follow=False)
            config = outer_config(listen, connect, self._secret, users)
            if self._part is not None:
                self._part.configure(config)
            self._outer = open_session(config)
        finally:
            users.unlink(missing_ok=True)  # Zenoh has read it
        try:
            if self._part is None:
                self._build_bridge(None)
            else:
                self._part.begin(self._outer, self._domain_id)
                self._take_part(self._part)
        except zenoh.ZError:
            self._shut()
            raise

    def _build_bridge(self, naming: Naming | None) -> None:

        assert self._outer is not None
        inner = open_session(inner_config(self._place))
        self._bridge = Bridge(
            inner, self._outer, self._domain_id, self._report, self.refusals, self._is_neighbour, naming
        )

    def _take_part(self, part: ClassPart) -> None:
        """Join the graphs as soon as there is a class, and part them when this desktop does not belong to it any more."""
        part.poll()
        naming = part.naming
        if naming is not None and self._bridge is None:
            self._build_bridge(naming)
        elif naming is None and self._bridge is not None:
            self._shut()  # the bridge owns the sessions; they are opened again at the next poll

    def _shut(self) -> None:
        bridge, outer, self._bridge, self._outer = self._bridge, self._outer, None, None
        if self._part is not None:
            self._part.end()
        if bridge is not None:
            bridge.close()
        elif outer is not None:
            outer.close()

    # -- watching ------------------------------------------------------------------------------------------------------

    def _read_links(self, session: zenoh.Session) -> None:
        links = [(str(link.src), str(link.dst)) for link in session.info.links()]
        for door in self.doors:
            if door.listening:
                port = address_of(door.endpoint, listening=True).port
                links_here = {far for near, far in links if near.endswith(f":{port}")}
                joined = self._part.joined if self._part is not None else None
                self._change(door.endpoint, True, joined=len(links_here) if joined is None else joined)
            else:
                self._check_connection(door, {far.split("?")[0].partition("/")[2] for _, far in links})

    def _check_connection(self, door: Door, joined: set[str]) -> None:
        """Check whether one of the addresses of a door's host is connected; if not, probe periodically for the reason."""
        if self._addresses.get(door.endpoint, frozenset()) & joined:
            refused = self._part.problem if self._part is not None else None
            self._change(door.endpoint, False, state=refused or DoorState.OPEN, joined=0 if refused else 1)
        elif self._due(door.endpoint, _PROBE_SECONDS):
            state, self._addresses[door.endpoint] = _probe(address_of(door.endpoint, listening=False))
            if not self._addresses[door.endpoint] & joined:
                self._change(door.endpoint, False, state=state, joined=0)
        elif door.state == DoorState.OPEN:
            self._last_tried.pop(door.endpoint, None)  # it has gone: probe at the next poll

    def _endpoints(self, *, listening: bool) -> tuple[str, ...]:
        return tuple(endpoint for endpoint, kind in self._doors if kind == listening)

    def _due(self, what: str, seconds: float) -> bool:
        now = time.monotonic()
        if now - self._last_tried.get(what, -seconds) < seconds:
            return False
        self._last_tried[what] = now
        return True

    def _change(self, endpoint: str, listening: bool, **fields: object) -> None:
        self._doors[endpoint, listening] = self._doors[endpoint, listening]._replace(**fields)  # type: ignore[arg-type]


def _is_free(endpoint: str) -> bool:
    """Return whether a door can be opened, by opening and closing it."""
    address = address_of(endpoint, listening=True)
    kind = socket.SOCK_DGRAM if address.protocol == "udp" else socket.SOCK_STREAM
    try:
        family, _, _, _, where = socket.getaddrinfo(address.host, address.port, type=kind)[0]
        with socket.socket(family, kind) as probe:
            if os.name == "posix":
                # As Zenoh does; on Windows it would take the port from another program.
                probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            probe.bind(where)
    except OSError:
        return False
    return True


def _probe(address: Address) -> tuple[DoorState, frozenset[str]]:
    """Probe a machine that is not connected; returns the reason, and all addresses of its name.

    Zenoh does not report why a connection was rejected, so this checks whether anything answers there at all.
    """
    try:
        found = socket.getaddrinfo(address.host, address.port, type=socket.SOCK_STREAM)
    except OSError:
        return DoorState.NO_NAME, frozenset()
    addresses = frozenset(_host_and_port(str(where[0]), int(where[1])) for _, _, _, _, where in found)
    if address.protocol == "udp":
        return DoorState.NO_ANSWER, addresses
    try:
        socket.create_connection((address.host, address.port), _ANSWER_SECONDS).close()
    except ConnectionRefusedError:
        return DoorState.NOBODY, addresses
    except OSError:
        return DoorState.NO_ANSWER, addresses
    return DoorState.NOT_LET_IN, addresses


def _host_and_port(host: str, port: int) -> str:
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"


class _Problem(NamedTuple):
    state: DoorState
    reason: str


def _problem_at(endpoint: str) -> _Problem:
    return _Problem(_probe(address_of(endpoint, listening=False))[0], "")


def _problem_in(text: str) -> _Problem:
    """Parse a Zenoh error: a text with the system's error number in it, and a position in Zenoh's source at its end."""
    if found := re.search(r"\(os error (\d+)\)", text):
        number = int(found[1])
        return _Problem(DoorState.IN_USE if number in _IN_USE else DoorState.FAILED, os.strerror(number))
    if "failed to lookup" in text:
        return _Problem(DoorState.NO_NAME, "")
    return _Problem(DoorState.FAILED, text.partition(" at /")[0])
