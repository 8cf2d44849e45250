"""What a teacher has asked the pupils, and what each has answered."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any, NamedTuple

from day6_core.classroom.kept import LESSON_SECONDS
from day6_core.classroom.note import REPLIES, Reply

MOST_OPEN = 4
"""Questions that wait for answers at a time; the oldest makes room for the next."""


@dataclass
class Question:
    """A saying that asks for an answer."""

    number: int
    text: str
    asked: tuple[str, ...]
    """Whom it has reached."""
    replies: dict[str, Reply] = field(default_factory=dict)
    """name -> what that pupil has answered last"""

    @property
    def silent(self) -> list[str]:
        """Who has not answered."""
        return [name for name in self.asked if name not in self.replies]

    def counts(self) -> dict[str, int]:
        """How many gave which answer."""
        kinds = [reply.kind for reply in self.replies.values()]
        return {kind: kinds.count(kind) for kind in REPLIES}


class Asked(NamedTuple):
    """What a pupil was asked, and the answer if there is one."""

    question: Question
    reply: Reply | None


class Questions:
    """Those that are open, the latest last."""

    def __init__(self, wall: Callable[[], float] = time.time) -> None:
        self._wall = wall
        self._last = 0
        self.open: list[Question] = []

    def next_number(self) -> int:
        """Return a number that no question had, also none of an earlier server: a desktop may still hold its answer."""
        self._last = max(self._last + 1, int(self._wall() * 1000))
        return self._last

    def is_of_now(self, number: int) -> bool:
        """Whether something got its number in this lesson, or one of the same day."""
        return abs(self._wall() - number / 1000) < LESSON_SECONDS

    def add(self, number: int, text: str, asked: Sequence[str]) -> None:
        """Wait for answers to this."""
        self.open.append(Question(number, text, tuple(asked)))

    def sent(self, number: int, missed: Collection[str]) -> list[Question]:
        """It has reached all but these; return the questions that have to make room."""
        for each in self.open:
            if each.number == number:
                each.asked = tuple(name for name in each.asked if name not in missed)
        self.open = [each for each in self.open if each.asked]
        full, self.open = self.open[:-MOST_OPEN], self.open[-MOST_OPEN:]
        return full

    def close(self, number: int) -> Question | None:
        """Wait no longer."""
        found = next((each for each in self.open if each.number == number), None)
        if found is not None:
            self.open.remove(found)
        return found

    def heard(self, name: str, replies: Iterable[Reply]) -> bool:
        """A pupil has answered: what others were asked, or nobody, is no answer. Whether there is anything new."""
        is_new = False
        for reply in replies:
            for question in self.open:
                if question.number == reply.number and name in question.asked and question.replies.get(name) != reply:
                    question.replies[name] = reply
                    is_new = True
        return is_new

    def data(self) -> dict[str, Any]:
        """Return all as JSON, for `restore`."""
        return {"last": self._last, "open": [asdict(each) for each in self.open]}

    def restore(self, found: Any) -> None:
        """Go on with what an earlier server had. Raises ValueError, TypeError, KeyError, AttributeError if it isn't that."""
        questions = [_question(each) for each in found["open"]]
        self._last = max(self._last, int(found["last"]), *(each.number for each in questions))
        self.open = [each for each in questions if self.is_of_now(each.number)][-MOST_OPEN:]

    def latest(self, name: str) -> Asked | None:
        """Return what this pupil was asked last of what is open."""
        found = next((each for each in reversed(self.open) if name in each.asked), None)
        return None if found is None else Asked(found, found.replies.get(name))


def _question(found: Any) -> Question:
    number, replies = int(found["number"]), found["replies"].items()
    answers = {str(name): Reply(number, str(each["kind"]), str(each["text"])) for name, each in replies}
    known = {name: each for name, each in answers.items() if each.kind in REPLIES}
    return Question(number, str(found["text"]), tuple(map(str, found["asked"])), known)
