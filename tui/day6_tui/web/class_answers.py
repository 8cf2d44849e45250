"""What the teacher asks the pupils, on the teacher's page: {"t":"ask","names","text"} says something that is to be answered.

{"t":"settle","number"} waits for the answers no longer. The rows come with `questions`.
"""

from __future__ import annotations

from typing import Any

from aiohttp import web

from day6_core.classroom import order as orders
from day6_core.classroom.asked import Question
from day6_core.classroom.order import OrderError
from day6_tui.locale import Texts
from day6_tui.web.class_part import Answer, Hear, names_of
from day6_tui.web.roster_feed import RosterFeed


class ClassAnswers:
    """Shows the questions that are open, and who has answered what."""

    def __init__(self, feed: RosterFeed) -> None:
        self._feed = feed

    def hears(self) -> dict[str, Hear]:
        """What the teacher asks."""
        return {"ask": self._ask, "settle": self._settle}

    def routes(self) -> list[web.RouteDef]:
        """It has none."""
        return []

    def state(self, texts: Texts) -> dict[str, Any]:
        """The open questions, the latest last."""
        return {"questions": [_told(each) for each in self._feed.roster.questions.open]}

    async def _ask(self, found: dict[str, Any]) -> Answer:
        roster, chosen = self._feed.roster, names_of(found)
        try:
            text = orders.of({"do": "say", "text": found["text"]}).text
        except OrderError as error:
            raise ValueError(str(error)) from None
        names = roster.everybody() if chosen is None else chosen
        missed = roster.ask(names, text)
        self._feed.tell()
        return {"t": "sent", "do": "say", "count": len(names) - len(missed), "missed": missed}

    async def _settle(self, found: dict[str, Any]) -> Answer:
        self._feed.roster.settle(int(found["number"]))
        self._feed.tell()
        return None


def _told(question: Question) -> dict[str, Any]:
    replies = {name: {"kind": each.kind, "text": each.text} for name, each in question.replies.items()}
    return {"number": question.number, "text": question.text, "asked": list(question.asked), "replies": replies}
