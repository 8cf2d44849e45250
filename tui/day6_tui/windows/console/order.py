"""The order of the console's table: the messages sorted by a column, kept so while new ones come and old ones go."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Callable, Sequence
from itertools import takewhile
from typing import Any, NamedTuple

from day6_core.ros.programs.rqt_console.filters import FilterChoice
from day6_core.ros.programs.rqt_console.model import Record

Key = Callable[[Record], tuple[Any, int]]

_KEYS: dict[str, Key] = {
    "number": lambda record: (0, record.number),
    "message": lambda record: (record.text.casefold(), record.number),
    "severity": lambda record: (record.level, record.number),
    "node": lambda record: (record.node, record.number),
    "stamp": lambda record: (record.stamp_ns, record.number),
    "location": lambda record: (record.location, record.number),
}

COLUMNS = tuple(_KEYS)
"""All columns, as in rqt_console."""

FEW = 200
"""So many new messages are put in one by one; for more it is quicker to sort all again."""


class Order(NamedTuple):
    """By which column, and whether the greatest comes first."""

    column: str = "number"
    descending: bool = False

    @classmethod
    def first_by(cls, column: str) -> Order:
        """How a column is sorted when it is chosen: the worst severity comes first, of everything else the least."""
        return cls(column, column == "severity")

    @property
    def newest_last(self) -> bool:
        """Whether new messages come at the lower end."""
        return self.column in ("number", "stamp") and not self.descending


class SortedRecords:
    """What the console shows, in order: `self[0]` is the first line of the table."""

    def __init__(self) -> None:
        self.order = Order()
        self._source: Sequence[Record] = ()
        """The messages as they came."""
        self._count = 0
        """How many of them are in order: the list of the model may have grown meanwhile."""
        self._choice: FilterChoice | None = None
        self._ascending: Sequence[Record] = ()

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: int) -> Record:
        if not 0 <= index < self._count:
            raise IndexError(index)
        return self._ascending[self._count - 1 - index if self.order.descending else index]

    def index(self, record: Record) -> int:
        """The line of a message; if it is not shown, of one beside which it would be. -1 if there are none."""
        at = bisect_left(self._ascending, self._key(record), 0, self._count, key=self._key)
        at = min(at, self._count - 1)
        return self._count - 1 - at if self.order.descending else at

    def sort(self, order: Order) -> None:
        """Sort by another column, or the other way round."""
        again = order.column != self.order.column
        self.order = order
        if again:
            self._sort_all()

    def update(self, records: Sequence[Record], choice: FilterChoice) -> None:
        """Take what the console shows now, the oldest first."""
        before, count, same = self._source, self._count, choice is self._choice
        self._source, self._count, self._choice = records, len(records), choice
        if self.order.column == "number":
            self._ascending = records
            return
        last = before[count - 1].number if count else 0
        fresh = _newer(records, last)
        gone = _older(before, count, records[0].number) if records else list(before[:count])
        if not same or len(gone) == count or len(fresh) > FEW or len(gone) > FEW:
            self._sort_all()
            return
        assert isinstance(self._ascending, list)
        for record in gone:
            del self._ascending[bisect_left(self._ascending, self._key(record), key=self._key)]
        for record in fresh:
            insort(self._ascending, record, key=self._key)

    @property
    def _key(self) -> Key:
        return _KEYS[self.order.column]

    def _sort_all(self) -> None:
        by_number = self.order.column == "number"
        self._ascending = self._source if by_number else sorted(self._source[: self._count], key=self._key)


def _newer(records: Sequence[Record], number: int) -> list[Record]:
    """The messages at the end whose number is greater."""
    return list(takewhile(lambda record: record.number > number, reversed(records)))


def _older(records: Sequence[Record], count: int, number: int) -> list[Record]:
    """The messages at the beginning whose number is less, of the first `count`."""
    return list(takewhile(lambda record: record.number < number, (records[at] for at in range(count))))
