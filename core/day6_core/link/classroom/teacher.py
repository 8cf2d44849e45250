"""The teacher's part: the router of the class, who is in it, and the notes and orders."""

from __future__ import annotations

import json
import logging
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.link.classroom import access, keys
from day6_core.link.classroom.naming import TeacherNaming
from day6_core.link.classroom.part import Outbox
from day6_core.link.limits import MOST_MACHINES
from day6_core.link.naming import Naming, Plain
from day6_core.looks import looks_like

if TYPE_CHECKING:
    import zenoh

_log = logging.getLogger(__name__)

MOST_REFUSED = 1000
TELL_SECONDS = 0.5
"""At least, between two words that the same one is still refused; it asks every second."""
RESERVED_SECONDS = 5.0
"""How long a granted name waits for its pupil's token."""

HAND_SECONDS = 30.0
"""For which a pupil can take to receive a file."""


class Teacher:
    """`noted(name, note)`, `came(name, is_here)` and `turned_away(name, why)` are called on foreign threads.

    Who is turned away asks again, and as long as it does, it is told again.
    """

    def __init__(self, *, room: bool = False) -> None:
        self.is_room = room
        self.is_closed = not room
        self.noted: Callable[[str, bytes], None] = _ignore
        self.came: Callable[[str, bool], None] = _ignore
        self.turned_away: Callable[[str, str], None] = _ignore
        self.problem = None
        self.naming: Naming | None = None
        self._session: zenoh.Session | None = None
        self._outbox: Outbox | None = None
        self._domain_id = 0
        self._declared: list[Any] = []
        self._lock = threading.Lock()
        self._here: dict[str, str] = {}
        """name -> session of the pupil who has it"""
        self._reserved: dict[str, tuple[str, float]] = {}
        self._refused: dict[str, tuple[tuple[str, str], float]] = {}
        """session -> name and reason, for those of whom was told, and when it was last"""

    @property
    def joined(self) -> int:
        """How many pupils are here."""
        return len(self._here)

    def order(self, name: str, order: bytes) -> bool:
        """Send an order to a pupil; False if that pupil is not here. Any thread."""
        outbox = self._outbox
        return outbox is not None and name in self._here and outbox.put(keys.order_key(name), order)

    def show(self, picture: bytes) -> None:
        """Send a picture to all pupils, those who are to pass it over too. Any thread."""
        if (outbox := self._outbox) is not None and self._here:
            outbox.put(keys.SHOWN, picture)

    def hand(self, name: str, message: bytes) -> bytes | None:
        """Hand a file to a pupil; the desktop's answer, None if there is none. Waits for it. Any thread."""
        import zenoh

        session = self._session
        if session is None or name not in self._here:
            return None
        try:
            replies = session.get(keys.file_key(name), payload=message, timeout=HAND_SECONDS)
            return next((reply.ok.payload.to_bytes() for reply in replies if reply.ok is not None), None)
        except zenoh.ZError as error:
            _report("not handed to the class", error)
            return None

    # -- for the gateway -----------------------------------------------------------------------------------------------

    def configure(self, config: zenoh.Config) -> None:
        config.insert_json5("access_control", json.dumps(access.rules(is_room=self.is_room)))

    def begin(self, session: zenoh.Session, domain_id: int) -> None:
        self._session, self._domain_id = session, domain_id
        self._outbox = Outbox(session, _report)
        self.naming = Plain(domain_id) if self.is_room else TeacherNaming(domain_id)
        self._declared = [
            session.declare_queryable(keys.join_key("*"), self._on_question),
            session.declare_subscriber(keys.note_key("*"), self._on_note),
            session.liveliness().declare_subscriber(keys.here_token("*", "*"), self._on_token, history=True),
            session.liveliness().declare_token(keys.teacher_token(str(session.info.zid()))),
        ]

    def poll(self) -> None:
        pass

    def end(self) -> None:
        self._declared.clear()
        self._session = self.naming = None
        if self._outbox is not None:
            self._outbox.close()
            self._outbox = None
        with self._lock:
            names, self._here, self._reserved, self._refused = list(self._here), {}, {}, {}
        for name in names:
            self.came(name, False)

    # -- on Zenoh's threads --------------------------------------------------------------------------------------------

    def _on_question(self, query: zenoh.Query) -> None:
        name = keys.name_in(str(query.key_expr))
        try:
            asked = json.loads(query.payload.to_bytes() if query.payload is not None else b"{}")
            zid, domain_id = str(asked["zid"])[:32], asked["domain"]
        except (ValueError, TypeError, KeyError):
            return
        if name is not None:
            refusal = self._refusal(name, zid, domain_id)
            query.reply(query.key_expr, json.dumps({"refused": refusal, "room": self.is_room}).encode())
            if refusal is None:
                self._refused.pop(zid, None)
            else:
                self._tell_refused(zid, (name, refusal))

    def _tell_refused(self, zid: str, what: tuple[str, str]) -> None:
        told, when = self._refused.get(zid, (None, 0.0))
        now = time.monotonic()
        if told == what and now - when < TELL_SECONDS:
            return
        if len(self._refused) >= MOST_REFUSED:
            self._refused.clear()
        self._refused[zid] = what, now
        self.turned_away(*what)

    def _refusal(self, name: str, zid: str, domain_id: object) -> str | None:
        """Return why this session cannot have the name, and keep it for it if it can."""
        now = time.monotonic()
        with self._lock:
            reserved, until = self._reserved.get(name, ("", 0.0))
            holder = self._here.get(name) or (reserved if now < until else None)
            if holder is not None and holder != zid:
                return "taken"
            if holder is None and looks_like(name, self._others(zid, now)) is not None:
                return "alike"
            if self.is_room and domain_id != self._domain_id:
                return "domain"
            if holder is None and len(self._here) + len(self._reserved) >= MOST_MACHINES:
                self._reserved = {key: value for key, value in self._reserved.items() if now < value[1]}
                if len(self._here) + len(self._reserved) >= MOST_MACHINES:
                    return "full"
            self._reserved[name] = zid, now + RESERVED_SECONDS
        return None

    def _others(self, zid: str, now: float) -> list[str]:
        """The names that other sessions have, or have been granted."""
        here = [name for name, holder in self._here.items() if holder != zid]
        return here + [name for name, (holder, until) in self._reserved.items() if holder != zid and now < until]

    def _on_note(self, sample: zenoh.Sample) -> None:
        name = keys.name_in(str(sample.key_expr))
        if name is not None and name in self._here:
            self.noted(name, sample.payload.to_bytes())

    def _on_token(self, sample: zenoh.Sample) -> None:
        import zenoh

        key = str(sample.key_expr)
        name, zid, is_here = keys.name_in(key), key.rpartition("/")[2], sample.kind == zenoh.SampleKind.PUT
        if name is None or len(zid) > 32:
            return
        with self._lock:
            self._reserved.pop(name, None)
            if is_here:
                if name in self._here or len(self._here) >= MOST_MACHINES:
                    return
                self._here[name] = zid
            elif self._here.get(name) == zid:
                del self._here[name]
            else:
                return
        self.came(name, is_here)


def _report(what: str, error: Exception) -> None:
    _log.warning("%s: %s", what, error)


def _ignore(*_: object) -> None:
    pass
