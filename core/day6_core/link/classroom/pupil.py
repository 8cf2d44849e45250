"""A pupil's part: asks the teacher for the name, and joins when it is granted."""

from __future__ import annotations

import json
import logging
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.link.classroom import keys
from day6_core.link.classroom.naming import PupilNaming
from day6_core.link.classroom.part import Outbox
from day6_core.link.naming import Naming, Plain
from day6_core.link.state import DoorState

if TYPE_CHECKING:
    import zenoh

_log = logging.getLogger(__name__)

ASK_SECONDS = 1.0
"""Between two questions for the name, and for how long one waits."""
PATIENCE_SECONDS = 3.0
"""Before a machine that is connected counts as one without a class."""
_REFUSALS = {
    "taken": DoorState.NAME_TAKEN,
    "alike": DoorState.NAME_ALIKE,
    "full": DoorState.CLASS_FULL,
    "domain": DoorState.OTHER_DOMAIN,
}


class Pupil:
    """`ordered` gets the teacher's orders, `shown` the screen for all, `handed` a file and returns the answer, `met` whether the
    teacher is there; all are called on foreign threads.
    """

    is_closed = False
    joined = None

    def __init__(self, name: str) -> None:
        self.name = name
        self.ordered: Callable[[bytes], None] = _ignore
        self.shown: Callable[[bytes], None] = _ignore
        self.handed: Callable[[bytes], bytes] = _take_nothing
        self.met: Callable[[bool], None] = _ignore
        self.problem: DoorState | None = DoorState.NO_CLASS
        self.naming: Naming | None = None
        self.is_room = False
        """Whether the class shares one graph."""
        self._session: zenoh.Session | None = None
        self._outbox: Outbox | None = None
        self._domain_id = 0
        self._declared: list[Any] = []
        self._here: Any = None
        """The token that keeps the name."""
        self._teachers: set[str] = set()
        self._granted = False
        self._asked = self._begun = 0.0

    def tell(self, note: bytes) -> None:
        """Send a note to the teacher. Any thread."""
        outbox = self._outbox
        if outbox is not None and self._granted:
            outbox.put(keys.note_key(self.name), note)

    # -- for the gateway -----------------------------------------------------------------------------------------------

    def configure(self, config: zenoh.Config) -> None:
        for name, value in (("mode", '"client"'), ("connect/timeout_ms", "0"), ("connect/exit_on_failure", "true")):
            config.insert_json5(name, value)

    def begin(self, session: zenoh.Session, domain_id: int) -> None:
        self._session, self._domain_id = session, domain_id
        self._begun, self.problem = time.monotonic(), DoorState.OPENING
        self._outbox = Outbox(session, _report)
        self._declared = [
            session.declare_subscriber(keys.order_key(self.name), self._on_order),
            session.declare_subscriber(keys.SHOWN, self._on_shown),
            session.declare_queryable(keys.file_key(self.name), self._on_file),
            session.liveliness().declare_subscriber(keys.teacher_token("*"), self._on_teacher, history=True),
        ]

    def poll(self) -> None:
        now = time.monotonic()
        if self.problem == DoorState.OPENING and now - self._begun >= PATIENCE_SECONDS:
            self.problem = DoorState.NO_CLASS
        if self._teachers and not self._granted and now - self._asked >= ASK_SECONDS:
            self._asked = now
            self._ask()

    def end(self) -> None:
        self._lose_teacher()
        self._teachers.clear()
        self._declared.clear()
        self._here = self._session = self.naming = None
        self.problem = DoorState.NO_CLASS
        if self._outbox is not None:
            self._outbox.close()
            self._outbox = None

    # -- on Zenoh's threads --------------------------------------------------------------------------------------------

    def _ask(self) -> None:
        import zenoh

        if self._session is None:
            return
        request = json.dumps({"zid": str(self._session.info.zid()), "domain": self._domain_id}).encode()
        handler = zenoh.handlers.Callback(self._on_answer)
        self._session.get(keys.join_key(self.name), handler, payload=request, timeout=ASK_SECONDS)

    def _on_answer(self, reply: zenoh.Reply) -> None:
        try:
            answer = json.loads(reply.ok.payload.to_bytes() if reply.ok is not None else b"{}")
            refusal, is_room = answer["refused"], answer["room"] is True
        except (ValueError, TypeError, KeyError):
            return  # nobody of ours, or it took too long: asked again
        session = self._session
        if session is None:
            return
        if refusal is not None:
            self.problem, self._here, self.naming = _REFUSALS.get(str(refusal), DoorState.NOT_LET_IN), None, None
            return
        if self.naming is not None and is_room != self.is_room:
            self.naming, self._here = None, None  # the class has become another: the gateway opens anew
            return
        if self._here is None:
            self._here = session.liveliness().declare_token(keys.here_token(self.name, str(session.info.zid())))
        self.is_room = is_room
        if self.naming is None:
            self.naming = Plain(self._domain_id) if is_room else PupilNaming(self.name, self._domain_id)
        self.problem, self._granted = None, True
        self.met(True)

    def _on_order(self, sample: zenoh.Sample) -> None:
        if _is_sent_to(sample, keys.order_key(self.name)):
            self.ordered(sample.payload.to_bytes())

    def _on_shown(self, sample: zenoh.Sample) -> None:
        if self._granted and _is_sent_to(sample, keys.SHOWN):
            self.shown(sample.payload.to_bytes())

    def _on_file(self, query: zenoh.Query) -> None:
        if self._granted and _is_sent_to(query, keys.file_key(self.name)) and query.payload is not None:
            query.reply(query.key_expr, self.handed(query.payload.to_bytes()))

    def _on_teacher(self, sample: zenoh.Sample) -> None:
        import zenoh

        if sample.kind == zenoh.SampleKind.PUT:
            self._teachers.add(str(sample.key_expr))
            return
        self._teachers.discard(str(sample.key_expr))
        if not self._teachers:
            self._lose_teacher()

    def _lose_teacher(self) -> None:
        """The name is asked for again when there is a teacher; the graphs stay joined, in case it is the same one."""
        was_granted, self._granted = self._granted, False
        if was_granted:
            self.problem = DoorState.NO_CLASS
            self.met(False)


def _is_sent_to(sample: zenoh.Sample | zenoh.Query, key: str) -> bool:
    """Whether it comes from the teacher: the router of a room would let it through for a key with wildcards (`access`)."""
    return str(sample.key_expr) == key


def _report(what: str, error: Exception) -> None:
    _log.warning("%s: %s", what, error)


def _ignore(_: object) -> None:
    pass


def _take_nothing(_: bytes) -> bytes:
    return b""
