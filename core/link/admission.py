"""Which of the things that other machines announce are let in to this user's processes, and how many.

Pure: the bridge asks it about every token. No token of another machine ever counts as one of this machine's processes: a
session id that is in use here is refused at the door.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator
from typing import NamedTuple

from day6_tui.core.link.keys import LIVELINESS_PREFIX, parse_token
from day6_tui.core.link.limits import (
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
    """What the bridge needs to know of a token: whose it is, whether of a node, and the kind and key of an endpoint's data."""

    zid: str
    is_node: bool
    kind: str = ""
    data_key: str = ""


def token_of(key: str) -> Token | None:
    """Return what a liveliness token of a node, an endpoint or a cache says; None for any other."""
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
    """Says which tokens from outside are let in; `lives_here` says whether a session is one of this machine's."""

    def __init__(self, lives_here: Callable[[str], bool], refusals: Refusals) -> None:
        self._lives_here = lives_here
        self._refusals = refusals
        self._inside: dict[str, Token] = {}
        self._of_one: Counter[tuple[str, bool]] = Counter()
        self._in_all: Counter[bool] = Counter()
        self._waiting: dict[str, Token] = {}
        """Refused for want of room, the oldest first."""
        self._room = False

    def come(self, key: str) -> Token | None:
        """Return what a token says that is let in now; None if it is not, or is inside already."""
        if key in self._inside:
            return None
        token = token_of(key)
        if token is None:
            self._refusals.add("names")
        elif self._lives_here(token.zid):
            self._refusals.add("sessions")
        elif self._has_room(token):
            self._enter(key, token)
            return token
        elif key not in self._waiting:
            self._refusals.add("nodes" if token.is_node else "endpoints")
            if len(self._waiting) < MOST_WAITING_FOR_ROOM:
                self._waiting[key] = token
        return None

    def go(self, key: str) -> Token | None:
        """Return what a token said that was inside and is gone; None if it was not inside."""
        if self._waiting.pop(key, None) is not None:
            return None
        token = self._inside.pop(key, None)
        if token is not None:
            self._count(token, -1)
            self._room = True
        return token

    def let_in(self) -> Iterator[tuple[str, Token]]:
        """Yield what was refused for want of room and is let in now; to be called now and then."""
        if not self._room:
            return
        self._room = False
        for key, token in list(self._waiting.items()):
            if self._has_room(token) and not self._lives_here(token.zid):
                del self._waiting[key]
                self._enter(key, token)
                yield key, token
        if not self._waiting:
            self._refusals.forget("nodes", "endpoints")

    def of(self, zid: str | None) -> list[str]:
        """Return the tokens that are inside of one session, or (None) of all; what waits of them is forgotten at once."""
        self._waiting = {key: token for key, token in self._waiting.items() if zid is not None and token.zid != zid}
        self._room = True
        return [key for key, token in self._inside.items() if zid in (None, token.zid)]

    def _enter(self, key: str, token: Token) -> None:
        self._inside[key] = token
        self._count(token, 1)

    def _count(self, token: Token, change: int) -> None:
        self._in_all[token.is_node] += change
        self._of_one[token.zid, token.is_node] += change
        if not self._of_one[token.zid, token.is_node]:
            del self._of_one[token.zid, token.is_node]

    def _has_room(self, token: Token) -> bool:
        most, most_of_one = (
            (MOST_NODES, MOST_NODES_OF_ONE) if token.is_node else (MOST_ENDPOINTS, MOST_ENDPOINTS_OF_ONE)
        )
        return self._in_all[token.is_node] < most and self._of_one[token.zid, token.is_node] < most_of_one
