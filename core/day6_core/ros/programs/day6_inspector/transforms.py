"""The transforms that are sent now, and by whom: what `Samples` brings of /tf and /tf_static, put together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

from day6_core.graph.endpoints import Publisher

TOPICS = ("/tf", "/tf_static")
STILL = 4
"""Looks at which an open /tf brought a transform no more: nobody sends it any longer."""

PAUSED = 2
"""Looks after which a transform that comes again counts as a new one: a cup is put down and picked up again."""

APART = 0.001
"""Metres, or parts of a unit quaternion, by which two programs' values of one transform differ."""

MOST = 2000


class Transform(NamedTuple):
    """One that is sent now."""

    parent: str
    child: str
    nodes: tuple[str, ...]
    static: bool = False
    apart: bool = False
    """Whether two programs send it, with different values."""


@dataclass
class _Sent:
    """One transform as one publisher sends it."""

    first_ns: int
    """When it came first, without a pause since."""
    last_ns: int
    value: tuple[float, ...]
    unheard: int = 0
    """Looks since it came last."""


class Transforms:
    """Keeps those of all publishers, until they are no longer sent."""

    def __init__(self) -> None:
        self._sent: dict[tuple[str, str, Publisher], _Sent] = {}

    def take(self, publisher: Publisher, message: Any, sent_ns: int) -> None:
        """Take a message of a publisher."""
        for each in message.transforms:
            key = (each.header.frame_id.lstrip("/"), each.child_frame_id.lstrip("/"), publisher)
            value = _value(each.transform)
            before = self._sent.get(key)
            if before is not None:
                if before.unheard >= PAUSED:
                    before.first_ns = sent_ns
                before.last_ns, before.value, before.unheard = sent_ns, value, 0
            elif len(self._sent) < MOST:
                if publisher.cache is not None:  # a fixed transform is replaced by the next one of its child
                    self._drop(lambda parent, child, by, key=key: (child, by) == key[1:])
                self._sent[key] = _Sent(sent_ns, sent_ns, value)

    def look(self, publishers: frozenset[Publisher], is_open: bool) -> None:
        """Forget what is not sent any more; `is_open`: whether /tf was listened to."""
        self._drop(lambda parent, child, by: by not in publishers)
        for (_, _, publisher), sent in self._sent.items():
            sent.unheard += is_open and publisher.cache is None
        self._sent = {key: sent for key, sent in self._sent.items() if sent.unheard <= STILL}

    def _drop(self, is_gone: Any) -> None:
        self._sent = {key: sent for key, sent in self._sent.items() if not is_gone(*key)}

    @property
    def frames(self) -> frozenset[str]:
        """All frames."""
        return frozenset(frame for parent, child, _ in self._sent for frame in (parent, child))

    def now(self) -> tuple[Transform, ...]:
        """Return the transforms, sorted; of a child that has changed its parent only the new one."""
        of_child: dict[str, list[tuple[str, Publisher, _Sent]]] = {}
        for (parent, child, publisher), sent in self._sent.items():
            of_child.setdefault(child, []).append((parent, publisher, sent))
        together: dict[tuple[str, str], list[tuple[Publisher, _Sent]]] = {}
        for (parent, child, publisher), sent in self._sent.items():
            if not _was_replaced(parent, publisher, sent, of_child[child]):
                together.setdefault((parent, child), []).append((publisher, sent))
        return tuple(
            Transform(
                *names,
                tuple(sorted({publisher.node.full_name for publisher, _ in senders})),
                all(publisher.cache is not None for publisher, _ in senders),
                len(senders) > 1 and _apart([sent.value for _, sent in senders]),
            )
            for names, senders in sorted(together.items())
        )


def _was_replaced(parent: str, by: Publisher, sent: _Sent, of_child: list[tuple[str, Publisher, _Sent]]) -> bool:
    """Whether the child has had another parent since this was sent last."""
    return by.cache is None and any(
        other != parent and later.first_ns > sent.last_ns and publisher.cache is None
        for other, publisher, later in of_child
    )


def _value(transform: Any) -> tuple[float, ...]:
    moved, turned = transform.translation, transform.rotation
    sign = -1.0 if turned.w < 0 else 1.0  # a quaternion and its negative are one rotation
    return (moved.x, moved.y, moved.z, *(sign * each for each in (turned.x, turned.y, turned.z, turned.w)))


def _apart(values: list[tuple[float, ...]]) -> bool:
    return any(max(each) - min(each) > APART for each in zip(*values, strict=True))
