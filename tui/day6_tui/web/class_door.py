"""Who comes in, on the teacher's page: {"t":"door","do"}.

`do` is ask (`on`), admit (`ids`, `trust`), turn_away (`ids`) or remove (`name`).
"""

from __future__ import annotations

from typing import Any

from aiohttp import web

from day6_tui.locale import Texts
from day6_tui.web.addresses import source
from day6_tui.web.class_part import Answer, Hear
from day6_tui.web.entrance import Entrance
from day6_tui.web.lobby import MOST_OF_ALL, Newcomer
from day6_tui.web.sessions import Sessions


class ClassDoor:
    """Shows who waits, and lets the teacher decide."""

    def __init__(self, entrance: Entrance, sessions: Sessions) -> None:
        self._entrance = entrance
        self._sessions = sessions

    def hears(self) -> dict[str, Hear]:
        """What the teacher decides."""
        return {"door": self._decide}

    def routes(self) -> list[web.RouteDef]:
        """It has none."""
        return []

    def state(self, texts: Texts) -> dict[str, Any]:
        """Who waits, and whether all have to."""
        lobby = self._entrance.lobby
        return {"asks": lobby.asks, "lobby": [self._waiting(each) for each in lobby.waiting()]}

    def _waiting(self, newcomer: Newcomer) -> dict[str, Any]:
        claimed = newcomer.name if newcomer.is_claim else ""
        return {
            "id": newcomer.number,
            "name": newcomer.name,
            "address": newcomer.address,
            "source": source(newcomer.address),
            "why": newcomer.why,
            "was": self._sessions.address_of(claimed) if claimed else "",
            "here": bool(claimed) and self._sessions.has_tab(claimed),
        }

    async def _decide(self, found: dict[str, Any]) -> Answer:
        do = found["do"]
        try:
            if do == "ask":
                self._entrance.lobby.asks = found["on"] is True
                self._sessions.feed.tell()
            elif do == "admit":
                await self._entrance.admit(_numbers(found), trust=found["trust"] is True)
            elif do == "turn_away":
                self._entrance.turn_away(_numbers(found))
            elif do == "remove":
                await self._entrance.remove(str(found["name"]))
            else:
                raise ValueError("there is no such door")
        except OSError:
            pass  # the tokens could not be written, which the teacher has been told: they are good until the server ends
        return None


def _numbers(found: dict[str, Any]) -> list[int]:
    return [int(each) for each in list(found["ids"])[:MOST_OF_ALL]]
