"""Who becomes a pupil of the class by the class word, and how the teacher lets in, turns away and removes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from day6_core.classroom.homes import same_name
from day6_core.looks import looks_like, mixes_alphabets
from day6_core.reason import reason
from day6_tui.web.links import Links
from day6_tui.web.lobby import Lobby, LobbyFull
from day6_tui.web.names import BadName, clean
from day6_tui.web.sessions import Sessions, Tell
from day6_tui.web.tokens import PUPIL, WATCHER, Ticket, Tokens

MOST_TOLD = 1000
"""Addresses, and names that somebody from there tried to be taken for: each is told once."""


class NotIn(Exception):
    """A newcomer does not get in: the key of a text for the page, what fills it, and the status of the answer."""

    def __init__(self, key: str, status: int, **values: str) -> None:
        super().__init__(key)
        self.key, self.status, self.values = key, status, values


class Admitted(NamedTuple):
    """What the browser is to remember: as a pupil or, until the teacher has decided, as one who waits."""

    token: str = ""
    waits: str = ""


class Entrance:
    """Judges newcomers. What depends on each other is judged and done without anything awaited in between."""

    def __init__(
        self,
        tokens: Tokens,
        links: Links,
        sessions: Sessions,
        lobby: Lobby,
        has_files: Callable[[str], bool],
        tell: Tell,
    ) -> None:
        self._tokens = tokens
        self._links = links
        self._sessions = sessions
        self.lobby = lobby
        self._has_files = has_files
        self._tell = tell
        self._told: set[tuple[str, str]] = set()

    async def enter(self, typed: str, address: str, before: str) -> Admitted:
        """Somebody knows the word and has typed a name; `before` is what the same browser waits by. Raises NotIn."""
        name, claim = self._fit(typed, address)
        if why := claim or self.lobby.why_wait(address, has_files=self._has_files(name)):
            return Admitted(waits=self._wait(name, address, why, before))
        self.lobby.leave(before)
        token = self._register(name, address)
        try:
            await self._keep()
        except OSError:
            self._unregister(name)
            raise NotIn("serve.wrong.disk", 507) from None
        return Admitted(token)

    def _wait(self, name: str, address: str, why: str, before: str) -> str:
        try:
            key = self.lobby.wait(name, address, why, before=before)
        except LobbyFull:
            raise NotIn("serve.lobby.full", 429) from None
        self._tell_once((address, ""), "serve.lobby.asks", name=name, address=address)
        self._sessions.feed.tell()
        return key

    def _fit(self, typed: str, address: str) -> tuple[str, str]:
        """The name, and why the teacher is asked although it is somebody's already ("" if it is nobody's)."""
        try:
            name = clean(typed)
        except BadName as error:
            raise NotIn(str(error), 400) from None
        if mixes_alphabets(name):
            raise NotIn("serve.wrong.mixed", 400)
        if claim := self._taken(name):
            return self._known(name) or name, claim
        if (like := looks_like(name, self._links.all_names())) is not None:
            self._tell_once((address, like), "serve.alike", name=name, like=like, address=address)
            raise NotIn("serve.wrong.alike", 409, name=name, like=like)
        return name, ""

    def _taken(self, name: str) -> str:
        """Whose the name is already (`lobby.CLAIMS`): names of the list are reserved, also while no link opens them."""
        if self._links.is_listed(name):
            return "listed"
        return "known" if self._tokens.has(Ticket(PUPIL, name)) else ""

    def _known(self, name: str) -> str | None:
        """The pupil of this name, as the class writes it."""
        return next((each for each in self._links.all_names() if same_name(each) == same_name(name)), None)

    def _tell_once(self, what: tuple[str, str], key: str, **values: str) -> None:
        """Who comes again and again makes no more of it; the page shows everybody who waits."""
        if what not in self._told and len(self._told) < MOST_TOLD:
            self._told.add(what)
            self._tell(key, **values)

    def _register(self, name: str, address: str) -> str:
        self.lobby.came_in(address)
        self._sessions.note_address(name, address)
        self._sessions.feed.roster.expect([name])
        self._sessions.feed.tell()
        return self._tokens.make(Ticket(PUPIL, name))

    def _revoke(self, name: str) -> None:
        for kind in (PUPIL, WATCHER):
            self._tokens.revoke(Ticket(kind, name))

    def _unregister(self, name: str) -> None:
        self._revoke(name)
        self._sessions.feed.roster.forget(name)
        if self._links.is_listed(name):
            self._sessions.feed.roster.expect([name])
        self._sessions.feed.tell()

    async def _keep(self) -> None:
        """Write the tokens; the server's user is told if that fails. Raises OSError."""
        try:
            await self._links.keep()
        except OSError as error:
            self._tell("serve.no_record", file=str(error.filename), reason=reason(error))
            raise

    def is_listed(self, name: str) -> bool:
        """Whether the pupil is on the class list, and has a place and a link."""
        return self._links.is_listed(name)

    # -- the teacher ---------------------------------------------------------------------------------------------------

    async def admit(self, numbers: Iterable[int], *, trust: bool) -> None:
        """Let these in, and with `trust` also whoever comes from there later. Raises OSError; they are in all the same.

        Nobody gets another's desktop by a click for all: who says to be a pupil that there is goes on waiting then.
        """
        for newcomer in self.lobby.chosen(numbers):
            if trust:
                self.lobby.trust(newcomer.address)
            if newcomer.is_claim:
                if not trust:
                    newcomer.token = self._register(newcomer.name, newcomer.address)
            elif self._taken(newcomer.name) or looks_like(newcomer.name, self._links.all_names()):
                newcomer.refusal = "serve.wrong.name"  # another was let in under it meanwhile
            else:
                newcomer.token = self._register(newcomer.name, newcomer.address)
                self._sessions.feed.roster.journal.note("let_in", newcomer.name, newcomer.address)
        self._sessions.feed.tell()
        await self._keep()

    def turn_away(self, numbers: Iterable[int]) -> None:
        """Do not let these in."""
        for newcomer in self.lobby.chosen(numbers):
            newcomer.refusal = "serve.lobby.away"
            self._sessions.feed.roster.journal.note("turned_away", newcomer.name, newcomer.address)
            self.lobby.distrust(newcomer.address)
        self._sessions.feed.tell()

    async def remove(self, name: str) -> None:
        """End this pupil's desktop and let nobody use its links or browsers any more; the files stay. Raises OSError."""
        known = self._known(name)
        if known is None:
            return
        self._sessions.feed.roster.journal.note("removed", known)
        if address := self._sessions.address_of(known):
            self.lobby.distrust(address)
        self._revoke(known)
        await self._sessions.remove(known)
        self._unregister(known)
        await self._keep()
