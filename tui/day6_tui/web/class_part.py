"""What the teacher's page consists of besides the roster and the orders."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any, Protocol

from aiohttp import web

from day6_core.classroom.roster import MOST_PUPILS
from day6_tui.locale import Texts

ALL = "*"
"""In place of names."""

Answer = dict[str, Any] | None
"""What the page that asked is told, as JSON."""

Hear = Callable[[dict[str, Any]], Awaitable[Answer]]
"""Does what a message asks. Raises ValueError, TypeError, KeyError or AttributeError if it is nonsense: the page has to go."""


class ClassPart(Protocol):
    """One thing that a teacher can do there. It tells the feed (`RosterFeed.tell`) when its state has changed."""

    def hears(self) -> dict[str, Hear]:
        """What is done for the messages of the page, by their `t`."""

    def state(self, texts: Texts) -> dict[str, Any]:
        """What every message of rows says of it."""

    def routes(self) -> list[web.RouteDef]:
        """Its addresses below `class/`."""


def names_of(found: dict[str, Any]) -> list[str] | None:
    """The pupils that a message is about; None for everybody, also those who come later."""
    return None if found["names"] == ALL else [str(each) for each in list(found["names"])[:MOST_PUPILS]]
