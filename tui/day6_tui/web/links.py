"""The links of the class. A token can be told only by the server that made it; of older ones there is only the hash."""

from __future__ import annotations

import asyncio
from urllib.parse import urlsplit

from day6_core.classroom.homes import same_name
from day6_tui.web.options import is_loopback
from day6_tui.web.tokens import PUPIL, TEACHER, Ticket, Tokens

MOST_TEACHERS = 3
"""Tokens of the teacher that stay good: each start of the server makes one."""


class Links:
    """Makes tokens and remembers, for as long as the server runs, what they were."""

    def __init__(self, tokens: Tokens, base: str) -> None:
        self._tokens = tokens
        self._base = base
        """The address of the start page, with a slash at the end."""
        self._made: dict[tuple[str, str], str] = {}
        self._lock = asyncio.Lock()
        self.names: list[str] = []
        """The pupils of the list, in its order."""

    def enrol(self, names: list[str], *, anew: bool) -> list[str]:
        """Give these pupils links; returns who has got a new one. `keep` has to follow."""
        self.names = names
        new = [name for name in names if anew or not self._tokens.has(Ticket(PUPIL, name))]
        for name in new:
            self.make(Ticket(PUPIL, name))
        return new

    def make(self, ticket: Ticket) -> str:
        """A new link in place of all older ones for the same."""
        self._tokens.revoke(ticket, keep=MOST_TEACHERS - 1 if ticket.kind == TEACHER else 0)
        token = self._tokens.make(ticket)
        self._made[ticket.kind, same_name(ticket.name)] = token
        return self.link(token)

    def make_all(self) -> None:
        """New links for the list. Who chose a name with the class word has none, and would be shut out by it."""
        for name in self.names:
            self.make(Ticket(PUPIL, name))

    def is_listed(self, name: str) -> bool:
        """Whether the pupil is on the list, and so was given a link."""
        return same_name(name) in map(same_name, self.names)

    @property
    def are_local(self) -> bool:
        """Whether only this machine can use the links."""
        return is_loopback(urlsplit(self._base).hostname or "")

    def all_names(self) -> list[str]:
        """The pupils of the list, and then those that chose their names themselves."""
        listed = {same_name(name) for name in self.names}
        return [*self.names, *(name for name in self._tokens.names() if same_name(name) not in listed)]

    def known(self, ticket: Ticket) -> str | None:
        """The link, if this server has made it."""
        token = self._made.get((ticket.kind, same_name(ticket.name)))
        return None if token is None else self.link(token)

    def link(self, token: str) -> str:
        """The address that lets somebody in."""
        return f"{self._base}p/{token}"

    async def keep(self) -> None:
        """Write the tokens. Raises OSError."""
        async with self._lock:
            await asyncio.to_thread(self._tokens.save)
