"""A stand-in for a Zenoh session: it notes what is declared and sent, and nothing reaches anybody."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import zenoh


class Declared:
    """A token, subscriber, queryable, publisher or listener: what it is, its key, and what it was declared with."""

    def __init__(self, session: FakeSession, what: str, key: str, handler: Any, options: dict[str, Any]) -> None:
        self.session, self.what, self.key, self.handler, self.options = session, what, key, handler, options
        self.matching_status = SimpleNamespace(matching=True)

    def undeclare(self) -> None:
        self.session.log.append(f"undeclare {self.what} {self.key}")
        self.session.declared.remove(self)

    def put(self, payload: bytes, *, attachment: bytes) -> None:
        self.session.sent.append((self.key, payload, attachment))

    def call(self, *arguments: Any) -> None:
        """Call it as Zenoh would."""
        self.handler.callback(*arguments)


class FakeSession:
    def __init__(self, name: str = "", log: list[str] | None = None) -> None:
        self.name = name
        self.log: list[str] = [] if log is None else log
        self.declared: list[Declared] = []
        self.sent: list[tuple[str, bytes, bytes]] = []
        self.asked: list[Declared] = []
        self.puts: list[dict[str, Any]] = []
        self.fails = False
        self.present: list[str] = []
        """The tokens that an inquiry finds."""

    def _declare(self, what: str, key: Any, handler: Any = None, **options: Any) -> Declared:
        if self.fails:
            raise zenoh.ZError("no")
        self.log.append(f"declare {what} {key}")
        self.declared.append(Declared(self, what, str(key), handler, options))
        return self.declared[-1]

    def declare_subscriber(self, key: str, handler: Any, **options: Any) -> Declared:
        return self._declare("subscriber", key, handler, **options)

    def declare_queryable(self, key: str, handler: Any, **options: Any) -> Declared:
        return self._declare("queryable", key, handler, **options)

    def declare_publisher(self, key: str, **options: Any) -> Declared:
        return self._declare("publisher", key, **options)

    def put(self, key: str, payload: bytes, **options: Any) -> None:
        if self.fails:
            raise zenoh.ZError("no")
        self.puts.append({"key": key, "payload": payload, **options})

    def get(self, key: str, handler: Any, **options: Any) -> None:
        if self.fails:
            raise zenoh.ZError("no")
        self.asked.append(Declared(self, "get", str(key), handler, options))

    def liveliness(self) -> Liveliness:
        return Liveliness(self)

    @property
    def info(self) -> Info:
        return Info(self)

    def zid(self) -> str:
        return f"zid-{self.name}"

    def close(self) -> None:
        self.log.append(f"close {self.name}")
        if self.fails:
            raise zenoh.ZError("no")

    def keys(self, what: str) -> list[str]:
        return [each.key for each in self.declared if each.what == what]

    def one(self, what: str, key: str | None = None) -> Declared:
        (found,) = (each for each in self.declared if each.what == what and key in (None, each.key))
        return found


class Liveliness:
    def __init__(self, session: FakeSession) -> None:
        self._session = session

    def declare_token(self, key: str) -> Declared:
        return self._session._declare("token", key)

    def declare_subscriber(self, key: str, handler: Any, **options: Any) -> Declared:
        return self._session._declare("watch", key, handler, **options)

    def get(self, key: str, handler: Any, **options: Any) -> None:
        if self._session.fails:
            raise zenoh.ZError("no")
        self._session.asked.append(Declared(self._session, "tokens", key, handler, options))
        for token in self._session.present:
            handler.callback(SimpleNamespace(ok=SimpleNamespace(key_expr=token)))
        handler.callback(SimpleNamespace(ok=None))
        handler.drop()


class Info:
    def __init__(self, session: FakeSession) -> None:
        self._session = session

    def declare_link_events_listener(self, handler: Any, **options: Any) -> Declared:
        return self._session._declare("links", "", handler, **options)


class Bytes(bytes):
    def to_bytes(self, *_: Any, **__: Any) -> bytes:  # type: ignore[override]
        return bytes(self)


def sample(key: str = "", payload: bytes = b"", attachment: bytes | None = None, *, present: bool = True) -> Any:
    return SimpleNamespace(
        key_expr=key,
        payload=Bytes(payload),
        attachment=None if attachment is None else Bytes(attachment),
        kind=zenoh.SampleKind.PUT if present else zenoh.SampleKind.DELETE,
        encoding="encoding",
        congestion_control="congestion",
        priority="priority",
        timestamp="timestamp",
    )


class FakeQuery:
    def __init__(self, payload: bytes | None = b"", attachment: bytes | None = b"", key: str = "0/k") -> None:
        self.key_expr, self.parameters = key, ""
        self.payload = None if payload is None else Bytes(payload)
        self.attachment = None if attachment is None else Bytes(attachment)
        self.encoding = "encoding"
        self.replies: list[dict[str, Any]] = []
        self.dropped = 0

    def drop(self) -> None:
        self.dropped += 1

    def reply(self, key: str, payload: bytes, **options: Any) -> None:
        assert not self.dropped
        self.replies.append({"key": key, "payload": payload, **options})

    def accepts_replies(self) -> str:
        return "any"

    def __enter__(self) -> FakeQuery:
        return self

    def __exit__(self, *_: object) -> None:
        self.drop()


class StillThread:
    """In place of `threading.Thread`: the test itself runs `target` when it wants to."""

    def __init__(self, *, target: Callable[[], None], name: str, daemon: bool) -> None:
        self.target, self.name, self.daemon = target, name, daemon
        self.started = False
        self.joined: list[float | None] = []

    def start(self) -> None:
        self.started = True

    def is_alive(self) -> bool:
        return self.started

    def join(self, timeout: float | None = None) -> None:
        self.joined.append(timeout)
