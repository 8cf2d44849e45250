"""What the link hands to an engine and gets from it, under Zenoh's names. What means nothing on one machine is not read."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from day6_core.link.local.questions import Asked

Locality = SimpleNamespace(REMOTE="remote")
"""Nothing goes to the process that it comes from."""
CongestionControl = SimpleNamespace(BLOCK="block", DROP="drop")
QueryTarget = SimpleNamespace(ALL="all", ALL_COMPLETE="all")
ConsolidationMode = SimpleNamespace(NONE="none")
Priority = SimpleNamespace(INTERACTIVE_HIGH="high")


class ZError(Exception):
    """The engine cannot do what it was asked for: it is closed, or something is too long."""


class SampleKind(Enum):
    """Whether something is there or gone."""

    PUT = "put"
    DELETE = "delete"


class Payload:
    """Bytes that were received."""

    __slots__ = ("_data",)

    def __init__(self, data: bytes) -> None:
        self._data = data

    def to_bytes(self) -> bytes:
        """Return them."""
        return self._data


class Sample(NamedTuple):
    """A message, a reply's contents, or a token that came or went."""

    key_expr: str
    payload: Payload = Payload(b"")
    attachment: Payload | None = None
    kind: SampleKind = SampleKind.PUT


class Reply(NamedTuple):
    """An answer to a question."""

    ok: Sample


class Callback:
    """The functions that are called for each thing that comes, and once nothing comes any more."""

    def __init__(
        self, callback: Callable[[Any], object], drop: Callable[[], object] | None = None, *, indirect: bool = False
    ) -> None:
        self.callback = callback
        self.drop = drop

    def end(self) -> None:
        """Nothing comes any more."""
        if self.drop is not None:
            self.drop()


handlers = SimpleNamespace(Callback=Callback)


class CancellationToken:
    """Given to `Session.get`, it takes back the questions that are still open."""

    def __init__(self) -> None:
        self.open: set[Asked] = set()

    def cancel(self) -> None:
        """Nobody waits for the answers any more."""
        for asked in list(self.open):
            asked.end()


def matches(pattern: str, key: str) -> bool:
    """Return whether a key expression stands for a key: `*` is any one chunk, `**` at the end any number of them."""
    if pattern.endswith("/**"):
        return key.startswith(pattern[:-2])
    if "*" not in pattern:
        return pattern == key
    wanted, found = pattern.split("/"), key.split("/")
    return len(wanted) == len(found) and all(each in ("*", chunk) for each, chunk in zip(wanted, found, strict=True))
