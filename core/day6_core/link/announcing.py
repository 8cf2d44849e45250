"""Announces this process's own nodes and endpoints to the others."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Protocol

from day6_core.graph.endpoints import Client, Endpoint, Publisher, Service, Subscription
from day6_core.graph.node import Node
from day6_core.link.keys import endpoint_token, node_token
from day6_core.link.services import Services
from day6_core.link.topics import Topics

if TYPE_CHECKING:
    import zenoh


class _Declared(Protocol):
    """A Zenoh token, subscriber or queryable."""

    def undeclare(self) -> None: ...


class Announcements:
    """The tokens, subscribers and queryables of local nodes and endpoints in one session. Thread-safe."""

    def __init__(self, session: zenoh.Session, zid: str, topics: Topics, services: Services) -> None:
        self._session = session
        self._zid = zid
        self._topics = topics
        self._services = services
        self._lock = threading.RLock()
        self._declared: dict[Node | Endpoint, list[_Declared]] = {}

    def follow(self, subject: Node | Endpoint) -> None:
        """Declare or undeclare a local node or endpoint, by whether it exists now: events may come in any order.

        Raises:
            zenoh.ZError: Zenoh refused it.
        """
        with self._lock:
            if subject.destroyed:
                self._withdraw(subject)
            elif subject not in self._declared:
                self._declare(subject)

    def clear(self) -> None:
        """Drop all Zenoh objects; closing the session undeclares them."""
        with self._lock:
            self._declared.clear()

    def _declare(self, subject: Node | Endpoint) -> None:
        entries: list[_Declared] = []
        # The receiver before the token: whoever sees the token may send at once.
        if isinstance(subject, Subscription):
            entries.append(self._topics.subscribe(subject))
        elif isinstance(subject, Service):
            entries.append(self._services.serve(subject))
        elif isinstance(subject, Publisher) and subject.cache:
            self._topics.open(subject)
        token = node_token(subject, self._zid) if isinstance(subject, Node) else endpoint_token(subject, self._zid)
        entries.append(self._session.liveliness().declare_token(token))
        self._declared[subject] = entries

    def _withdraw(self, subject: Node | Endpoint) -> None:
        for entry in reversed(self._declared.pop(subject, [])):
            entry.undeclare()
        if isinstance(subject, Publisher):
            self._topics.withdraw(subject)
        elif isinstance(subject, (Service, Client)):
            self._services.withdraw(subject)
