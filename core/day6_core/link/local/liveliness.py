"""Tokens: what is there as long as the process that declared it, and those who watch them come and go."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from day6_core.link.local.declared import Announced
from day6_core.link.local.frames import Kind
from day6_core.link.local.vocabulary import Callback, Reply, Sample, SampleKind, matches

if TYPE_CHECKING:
    from day6_core.link.local.session import Session


class Liveliness:
    """Of one session."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._watchers: list[Announced] = []

    def declare_token(self, key: str) -> Announced:
        """Show the others that something is there, until it is undeclared or this process ends."""
        return self._session.declare(Kind.TOKEN, key)

    def declare_subscriber(self, key: str, handler: Callback, *, history: bool) -> Announced:
        """Have the tokens of others called for: those that are there, and what changes from now on."""
        assert history
        watcher = Announced(Kind.TOKEN, 0, key, 0, handler, self._forget)
        self._session.do(partial(self._watch, watcher))
        return watcher

    def get(self, key: str, handler: Callback, *, timeout: float) -> None:
        """Have the tokens that are there called for, at once."""
        self._session.check()
        for token in self._session.tokens():
            if matches(key, token):
                handler.callback(Reply(Sample(token)))
        handler.end()

    def tell(self, key: str, kind: SampleKind) -> None:
        """Tell those who watch that a token came or went. By the session's thread."""
        for each in list(self._watchers):
            if matches(each.key, key):
                each.call(Sample(key, kind=kind))

    def _watch(self, watcher: Announced) -> None:
        self._watchers.append(watcher)
        for key in self._session.tokens():
            if matches(watcher.key, key):
                watcher.call(Sample(key))

    def _forget(self, watcher: Announced) -> None:
        self._session.do_if_open(partial(self._watchers.remove, watcher))
