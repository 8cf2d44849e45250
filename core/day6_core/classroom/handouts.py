"""What a teacher has handed to the pupils, and who has opened it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass, field
from typing import Any

MOST_KEPT = 4
"""Of which it is shown who has opened them; the oldest makes room for the next."""


@dataclass
class HandOut:
    """A link, or a file by its name."""

    number: int
    text: str
    given: list[str] = field(default_factory=list)
    """Whom it has reached."""
    opened: set[str] = field(default_factory=set)


class HandOuts:
    """The last ones, the latest last."""

    def __init__(self) -> None:
        self.all: list[HandOut] = []

    def give(self, number: int, text: str, names: Iterable[str]) -> None:
        """It has reached these pupils, too."""
        found = self._numbered(number)
        if found is None:
            if number < max((each.number for each in self.all), default=0):
                return  # it has made room already
            found = HandOut(number, text)
            self.all = [*self.all, found][-MOST_KEPT:]
        found.given = list(dict.fromkeys([*found.given, *names]))

    def sent(self, number: int, missed: Collection[str]) -> None:
        """It has reached all but these."""
        for each in self.all:
            if each.number == number:
                each.given = [name for name in each.given if name not in missed]
        self.all = [each for each in self.all if each.given]

    def heard(self, name: str, numbers: Collection[int]) -> bool:
        """A pupil has opened these: what was handed to nobody or others was not. Whether there is anything new."""
        new = [each for each in self.all if each.number in numbers and name in each.given and name not in each.opened]
        for each in new:
            each.opened.add(name)
        return bool(new)

    def data(self) -> list[dict[str, Any]]:
        """Return all as JSON, for `restore`."""
        return [{**vars(each), "opened": sorted(each.opened)} for each in self.all]

    def restore(self, found: Any, is_of_now: Callable[[int], bool]) -> None:
        """Go on with what an earlier server had. Raises ValueError, TypeError, KeyError if it isn't that."""
        handouts = [
            HandOut(int(each["number"]), str(each["text"]), [*map(str, each["given"])], {*map(str, each["opened"])})
            for each in found
        ]
        self.all = [each for each in handouts if is_of_now(each.number)][-MOST_KEPT:]

    def _numbered(self, number: int) -> HandOut | None:
        return next((each for each in self.all if each.number == number), None)
