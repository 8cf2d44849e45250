"""The gate: this process's doors to other machines (`--listen`, `--connect`), kept apart from the local graph.

It has sessions and a thread of its own, so nothing that is wrong with a door (a taken port, a name that nobody knows, a machine
that does not answer) touches what the processes of this machine have of one another; it is told, and tried again.
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

from day6_tui.core.link.addresses import Address, address_of
from day6_tui.core.link.bridge import Bridge
from day6_tui.core.link.config import inner_config, outer_config
from day6_tui.core.link.file_lock import FileLock
from day6_tui.core.link.limits import Refusals
from day6_tui.core.link.paths import Place
from day6_tui.core.link.secret import USER
from day6_tui.core.link.state import Door, DoorState, remove_doors, write_doors

if TYPE_CHECKING:
    import zenoh

Report = Callable[[str, Exception], None]

LOOK_SECONDS = 0.5
RETRY_SECONDS = 2.0
"""Until a door that could not be opened is tried again."""
_CLOSING_SECONDS = 0.7
_ANSWER_SECONDS = 2.0
_ASK_SECONDS = 5.0
"""Between questions to a machine that does not answer; Zenoh itself goes on calling it."""
_ANOTHER = "another program of yours keeps the doors of this domain"
_IN_USE = (errno.EADDRINUSE, 10048, 10013)
"""The last two are Windows' WSAEADDRINUSE, and its WSAEACCES for a port that another program has for itself alone."""


class Gate:
    """Opens the doors in the background and looks after them until `close`."""

    def __init__(
        self,
        place: Place,
        domain_id: int,
        listen: Sequence[str],
        connect: Sequence[str],
        secret: str | None,
        report: Report,
        is_neighbour: Callable[[str], bool],
    ) -> None:
        self._place = place
        self._domain_id = domain_id
        self._secret = secret
        self._report = report
        self._is_neighbour = is_neighbour
        self.refusals = Refusals()
        self._lock = FileLock(place.folder / "gate.lock")
        doors = [(endpoint, True) for endpoint in listen] + [(endpoint, False) for endpoint in connect]
        self._doors = {
            (endpoint, listening): Door(endpoint, listening, secret=secret is not None) for endpoint, listening in doors
        }
        self._outer: zenoh.Session | None = None
        self._bridge: Bridge | None = None
        """What owns the session, and is closed in the end."""
        self._asked: dict[str, float] = {}
        self._addresses: dict[str, frozenset[str]] = {}
        """By endpoint to connect to: `host:port` of all its host's addresses, as links write them."""
        self._written: tuple[Door, ...] = ()
        self._closing = threading.Event()
        self._tried = threading.Event()
        self._thread = threading.Thread(target=self._run, name="day6-gate", daemon=True)

    @property
    def doors(self) -> tuple[Door, ...]:
        """How it stands with each door, now."""
        return tuple(self._doors.values())

    def start(self, patience: float) -> None:
        """Open the doors in the background; wait at most `patience` seconds for the first try."""
        self._thread.start()
        self._tried.wait(patience)

    def close(self) -> None:
        """Close all doors, those of a machine with thousands of tokens in the background: Zenoh takes seconds for them."""
        self._closing.set()
        if self._thread.is_alive():
            self._thread.join(timeout=_CLOSING_SECONDS)
        remove_doors(self._place)

    def _run(self) -> None:
        try:
            while not self._closing.is_set():
                try:
                    self._look()
                except Exception as error:
                    # A door is never worth the rest of the link.
                    self._report("the gate to other machines", error)
                self._tried.set()
                self._closing.wait(LOOK_SECONDS if self._outer is not None else RETRY_SECONDS)
        finally:
            self._shut()
            self._lock.release()

    def _look(self) -> None:
        """Open what is not open, and see who came in and who does not answer."""
        if self._outer is None or self._may_listen_now():
            self._open()
        if self._outer is not None:
            self._see_links(self._outer)
        if self.doors != self._written:
            write_doors(self._place, self.doors)
            self._written = self.doors

    # opening

    def _may_listen_now(self) -> bool:
        """Say whether a door could not be opened and now perhaps can."""
        shut = [door for door in self.doors if door.listening and door.state != DoorState.OPEN]
        return bool(shut) and self._due("listen", RETRY_SECONDS) and all(_is_free(door.endpoint) for door in shut)

    def _open(self) -> None:
        import zenoh

        self._shut()
        if not self._lock.try_acquire():
            # Two ways out to one place would be a circle, in which messages run for ever.
            for endpoint, listening in self._doors:
                self._change(endpoint, listening, state=DoorState.FAILED, reason=_ANOTHER)
            return
        listen, connect = self._endpoints(listening=True), self._endpoints(listening=False)
        if listen:
            try:
                self._open_sessions(listen, connect)
            except zenoh.ZError as error:
                # Only the text tells: which door it was is not said, and all are taken for shut.
                for endpoint in listen:
                    self._change(endpoint, True, **_why(str(error))._asdict())
            else:
                for endpoint in listen:
                    self._change(endpoint, True, state=DoorState.OPEN, reason="")
                return
        if connect:
            try:
                self._open_sessions((), connect)
            except zenoh.ZError as error:
                for endpoint in connect:
                    self._change(endpoint, False, **_why(str(error))._asdict())

    def _open_sessions(self, listen: Sequence[str], connect: Sequence[str]) -> None:
        """Open what joins this machine to others. Raises zenoh.ZError."""
        import zenoh

        users = self._place.folder / f"guests-{os.getpid()}"
        try:
            if self._secret is not None:
                with os.fdopen(os.open(users, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "wb") as file:
                    file.write(f"{USER}:{self._secret}\n".encode())
            outer = zenoh.open(outer_config(listen, connect, self._secret, users))
        finally:
            users.unlink(missing_ok=True)  # Zenoh has read it
        try:
            inner = zenoh.open(inner_config(self._place))
        except zenoh.ZError:
            outer.close()
            raise
        self._bridge = Bridge(inner, outer, self._domain_id, self._report, self.refusals, self._is_neighbour)
        self._outer = outer

    def _shut(self) -> None:
        bridge, self._bridge, self._outer = self._bridge, None, None
        if bridge is not None:
            bridge.close()

    # looking

    def _see_links(self, session: zenoh.Session) -> None:
        links = [(str(link.src), str(link.dst)) for link in session.info.links()]
        for door in self.doors:
            if door.listening:
                port = address_of(door.endpoint, listening=True).port
                joined = {far for near, far in links if near.endswith(f":{port}")}
                self._change(door.endpoint, True, joined=len(joined))
            else:
                self._see_answer(door, {far.split("?")[0].partition("/")[2] for _, far in links})

    def _see_answer(self, door: Door, joined: set[str]) -> None:
        """See whether one of the addresses of a door's host is joined; if none is, ask now and then why."""
        if self._addresses.get(door.endpoint, frozenset()) & joined:
            self._change(door.endpoint, False, state=DoorState.OPEN, joined=1)
        elif self._due(door.endpoint, _ASK_SECONDS):
            state, self._addresses[door.endpoint] = _ask(address_of(door.endpoint, listening=False))
            if not self._addresses[door.endpoint] & joined:
                self._change(door.endpoint, False, state=state, joined=0)
        elif door.state == DoorState.OPEN:
            self._asked.pop(door.endpoint, None)  # it has gone: ask at the next look

    def _endpoints(self, *, listening: bool) -> tuple[str, ...]:
        return tuple(endpoint for endpoint, kind in self._doors if kind == listening)

    def _due(self, what: str, seconds: float) -> bool:
        now = time.monotonic()
        if now - self._asked.get(what, -seconds) < seconds:
            return False
        self._asked[what] = now
        return True

    def _change(self, endpoint: str, listening: bool, **fields: object) -> None:
        self._doors[endpoint, listening] = self._doors[endpoint, listening]._replace(**fields)  # type: ignore[arg-type]


def _is_free(endpoint: str) -> bool:
    """Say whether a door could be opened, by opening it and closing it again."""
    address = address_of(endpoint, listening=True)
    kind = socket.SOCK_DGRAM if address.protocol == "udp" else socket.SOCK_STREAM
    try:
        family, _, _, _, where = socket.getaddrinfo(address.host, address.port, type=kind)[0]
        with socket.socket(family, kind) as probe:
            if os.name == "posix":
                # As Zenoh does; under Windows it would take the port from another program.
                probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            probe.bind(where)
    except OSError:
        return False
    return True


def _ask(address: Address) -> tuple[DoorState, frozenset[str]]:
    """Ask a machine why it is not joined: the answer, and all addresses that its name has.

    Zenoh does not say why it is not let in, so what is asked is whether anything answers there at all.
    """
    try:
        found = socket.getaddrinfo(address.host, address.port, type=socket.SOCK_STREAM)
    except OSError:
        return DoorState.NO_NAME, frozenset()
    addresses = frozenset(_written(str(where[0]), int(where[1])) for _, _, _, _, where in found)
    if address.protocol == "udp":
        return DoorState.NO_ANSWER, addresses
    try:
        socket.create_connection((address.host, address.port), _ANSWER_SECONDS).close()
    except ConnectionRefusedError:
        return DoorState.NOBODY, addresses
    except OSError:
        return DoorState.NO_ANSWER, addresses
    return DoorState.NOT_LET_IN, addresses


def _written(host: str, port: int) -> str:
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"


class _Why(NamedTuple):
    state: DoorState
    reason: str


def _why(text: str) -> _Why:
    """Return what an error of Zenoh's means: a text with the system's number in it, and a place in Zenoh's source at its end."""
    if found := re.search(r"\(os error (\d+)\)", text):
        number = int(found[1])
        return _Why(DoorState.IN_USE if number in _IN_USE else DoorState.FAILED, os.strerror(number))
    if "failed to lookup" in text:
        return _Why(DoorState.NO_NAME, "")
    return _Why(DoorState.FAILED, text.partition(" at /")[0])
