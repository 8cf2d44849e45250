"""Who may come in: a secret word for each pupil, each watcher and the teacher, of which only the hash is kept.

A token has 128 random bits, so its plain SHA-256 cannot be turned back; and it is found by that hash, so how long a search takes
says nothing about it.
"""

from __future__ import annotations

import hashlib
import json
import secrets
from dataclasses import dataclass
from pathlib import Path

from day6_core.classroom.homes import same_name
from day6_core.whole_file import write_private

PUPIL, WATCHER, TEACHER = "pupil", "watch", "teacher"
KINDS = (PUPIL, WATCHER, TEACHER)

_VERSION = 1


class BadTokens(Exception):
    """The file is not what this program wrote; the message says which file."""


@dataclass(frozen=True)
class Ticket:
    """What a token stands for. `name` is the pupil, whose desktop it opens; empty for the teacher."""

    kind: str
    name: str = ""


class Tokens:
    """The tickets of a class, in a file that only the server's user can read."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._tickets: dict[str, Ticket] = {}

    def load(self) -> None:
        """Read the file, if there is one. Raises BadTokens, OSError."""
        try:
            found = json.loads(self._path.read_bytes())
            for each in found["tickets"]:
                ticket = Ticket(str(each["kind"]), str(each["name"]))
                if ticket.kind in KINDS:
                    self._tickets[str(each["hash"])] = ticket
        except FileNotFoundError:
            return
        except (ValueError, TypeError, KeyError):
            raise BadTokens(str(self._path)) from None

    def save(self) -> None:
        """Write the file whole. Raises OSError."""
        tickets = [{"hash": key, "kind": each.kind, "name": each.name} for key, each in self._tickets.items()]
        text = json.dumps({"version": _VERSION, "tickets": tickets}, ensure_ascii=False, indent=1)
        write_private(self._path, text.encode())

    def make(self, ticket: Ticket) -> str:
        """A new token for this; it can be told now and never again. `save` keeps it."""
        token = secrets.token_urlsafe(16)
        self._tickets[_hash(token)] = ticket
        return token

    def revoke(self, ticket: Ticket, *, keep: int = 0) -> None:
        """Let no token for this be good any longer, but the last `keep` ones."""
        old = [key for key, each in self._tickets.items() if _is_same(each, ticket)]
        for key in old[: len(old) - keep]:
            del self._tickets[key]

    def of(self, token: str) -> Ticket | None:
        """What a token stands for; None for a wrong one."""
        return self._tickets.get(_hash(token)) if 0 < len(token) <= 64 else None

    def has(self, ticket: Ticket) -> bool:
        """Whether there is a token for this."""
        return any(_is_same(each, ticket) for each in self._tickets.values())

    def names(self) -> list[str]:
        """The pupils that have a token, in the order in which they got it."""
        return list({same_name(each.name): each.name for each in self._tickets.values() if each.kind == PUPIL}.values())


def _hash(token: str) -> str:
    return hashlib.sha256(token.encode(errors="replace")).hexdigest()


def _is_same(one: Ticket, other: Ticket) -> bool:
    return one.kind == other.kind and same_name(one.name) == same_name(other.name)
