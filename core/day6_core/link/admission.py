"""Decides which tokens from other machines reach this user's processes, and how many.

Pure: the bridge asks it about every token. A token from another machine never counts as one of this machine's processes: a
session id in use here is refused.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator
from typing import NamedTuple

from day6_core.link.keys import LIVELINESS_PREFIX, parse_token
from day6_core.link.limits import (
    MOST_ENDPOINTS,
    MOST_ENDPOINTS_OF_ONE,
    MOST_NODES,
    MOST_NODES_OF_ONE,
    MOST_WAITING_FOR_ROOM,
    Refusals,
)

_LONGEST_TOKEN = 2048
_CACHE = re.compile(
    r"[0-9]{1,10}(?:/[A-Za-z0-9_:~]{1,255}){1,128}/@adv/(?:pub|sub)/([0-9a-f]{1,32})(?:/[A-Za-z0-9_]{1,32}){1,2}"
)
"""The token by which a transient-local publisher's cache is found (zenoh-ext's publisher detection)."""


class Token(NamedTuple):
    """The parts of a token the bridge needs: session, node or endpoint, and the endpoint's kind and data key."""

    zid: str
    is_node: bool
    kind: str = ""
    data_key: str = ""


def token_of(key: str) -> Token | None:
    """Parse the liveliness token of a node, an endpoint or a cache; returns None for anything else."""
    if not key.startswith(LIVELINESS_PREFIX):
        cache = _CACHE.fullmatch(key) if len(key) <= _LONGEST_TOKEN else None
        return Token(cache[1], False) if cache is not None else None
    announcement = parse_token(key)
    if announcement is None:
        return None
    if announcement.kind is None:
        return Token(announcement.zid, True)
    _, domain_id, *_, dds_type, type_hash, _ = key.split("/")
    data_key = f"{domain_id}/{announcement.topic.strip('/')}/{dds_type}/{type_hash}"
    return Token(announcement.zid, False, announcement.kind.value, data_key)


class Admission:
    """Decides which tokens from outside are admitted; `lives_here(zid)` is whether a session belongs to this machine."""

    def __init__(self, lives_here: Callable[[str], bool], refusals: Refusals) -> None:
        self._lives_here = lives_here
        self._refusals = refusals
        self._inside: dict[str, Token] = {}
        self._of_session: Counter[tuple[str, bool]] = Counter()
        self._total: Counter[bool] = Counter()
        self._waiting: dict[str, Token] = {}
        """Refused because a limit was reached, oldest first."""
        self._room = False

    def admit(self, key: str) -> Token | None:
        """Admit a token that appeared and return it parsed; None if it is refused or already inside."""
        if key in self._inside:
            return None
        token = token_of(key)
        if token is None:
            self._refusals.add("names")
        elif self._lives_here(token.zid):
            self._refusals.add("sessions")
        elif self._has_room(token):
            self._add(key, token)
            return token
        elif key not in self._waiting:
            self._refusals.add("nodes" if token.is_node else "endpoints")
            if len(self._waiting) < MOST_WAITING_FOR_ROOM:
                self._waiting[key] = token
        return None

    def remove(self, key: str) -> Token | None:
        """Remove a token that disappeared and return it parsed; None if it was not inside."""
        if self._waiting.pop(key, None) is not None:
            return None
        token = self._inside.pop(key, None)
        if token is not None:
            self._count(token, -1)
            self._room = True
        return token

    def admit_waiting(self) -> Iterator[tuple[str, Token]]:
        """Admit and yield tokens that were refused because a limit was reached; to be called periodically."""
        if not self._room:
            return
        self._room = False
        for key, token in list(self._waiting.items()):
            if self._has_room(token) and not self._lives_here(token.zid):
                del self._waiting[key]
                self._add(key, token)
                yield key, token
        if not self._waiting:
            self._refusals.forget("nodes", "endpoints")

    def tokens_of(self, zid: str | None) -> list[str]:
        """Return the admitted tokens of one session, or of all (None); those still waiting are forgotten."""
        self._waiting = {key: token for key, token in self._waiting.items() if zid is not None and token.zid != zid}
        self._room = True
        return [key for key, token in self._inside.items() if zid in (None, token.zid)]

    def _add(self, key: str, token: Token) -> None:
        self._inside[key] = token
        self._count(token, 1)

    def _count(self, token: Token, change: int) -> None:
        self._total[token.is_node] += change
        self._of_session[token.zid, token.is_node] += change
        if not self._of_session[token.zid, token.is_node]:
            del self._of_session[token.zid, token.is_node]

    def _has_room(self, token: Token) -> bool:
        most, most_of_session = (
            (MOST_NODES, MOST_NODES_OF_ONE) if token.is_node else (MOST_ENDPOINTS, MOST_ENDPOINTS_OF_ONE)
        )
        return self._total[token.is_node] < most and self._of_session[token.zid, token.is_node] < most_of_session
