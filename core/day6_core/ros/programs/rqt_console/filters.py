"""rqt_console's filters: which messages are left out, and which stand out."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from day6_core.user_pattern import UserPattern, user_pattern

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_console.model import Record

KINDS: dict[str, tuple[str, ...]] = {
    "message": ("text",),
    "severity": ("levels",),
    "node": ("nodes",),
    "time": ("start_ns", "stop_ns"),
    "location": ("text",),
    "custom": ("text", "levels", "nodes"),
}
"""The kinds of filters in the order of rqt_console's menu, and what is asked for each."""

LONGEST = 10_000
"""Characters of a text in which a regular expression is looked for."""

MANY = ("message", "location")
"""Kinds of which there may be several."""

SIDES = ("excludes", "highlights")


@dataclass(frozen=True)
class Filter:
    """One filter; of its attributes those count that its kind has."""

    kind: str
    text: str = ""
    """To be found anywhere in the message, in the location for that kind."""
    is_regex: bool = False
    levels: frozenset[int] = frozenset()
    nodes: frozenset[str] = frozenset()
    start_ns: int = 0
    stop_ns: int | None = None
    """None: no end."""
    enabled: bool = True

    @property
    def is_active(self) -> bool:
        """Whether it is enabled and says anything; a time always does."""
        return self.enabled and (self.kind == "time" or bool(self.text or self.levels or self.nodes))

    @property
    def problem(self) -> str:
        """What is wrong with its regular expression; it then finds nothing."""
        if self.is_regex:
            try:
                self._pattern()
            except re.error as error:
                return str(error)
        return ""

    def matches(self, record: Record) -> bool:
        """Whether a message is meant, by all that is filled in."""
        if self.kind == "time":
            return self.start_ns <= record.stamp_ns and (self.stop_ns is None or record.stamp_ns <= self.stop_ns)
        return (
            (not self.levels or record.level in self.levels)
            and (not self.nodes or record.node in self.nodes)
            and (not self.text or self._finds(record.location if self.kind == "location" else record.text))
        )

    def _finds(self, text: str) -> bool:
        if not self.is_regex:
            return self.text in text
        try:
            return self._pattern().search(text[:LONGEST]) is not None
        except re.error:
            return False

    def _pattern(self) -> UserPattern:
        return user_pattern(self.text, re.DOTALL)


@dataclass(frozen=True)
class FilterChoice:
    """What is left out and what stands out: whatever one of the filters means. It begins with the two of rqt_console."""

    excludes: tuple[Filter, ...] = field(default=(Filter("severity"),))
    highlights: tuple[Filter, ...] = field(default=(Filter("message"),))
    only_highlighted: bool = False
    """Whether all is left out that does not stand out."""

    def shows(self, record: Record) -> bool:
        """Whether a message is not left out."""
        if any(each.is_active and each.matches(record) for each in self.excludes):
            return False
        return not self.only_highlighted or not self.is_highlighting or self.is_highlighted(record)

    @property
    def is_highlighting(self) -> bool:
        """Whether any filter lets messages stand out."""
        return any(each.is_active for each in self.highlights)

    def is_highlighted(self, record: Record) -> bool:
        """Whether a message stands out."""
        return any(each.is_active and each.matches(record) for each in self.highlights)

    def first(self, side: str, kind: str) -> Filter:
        """The first filter of a kind, an empty one if there is none."""
        return next((each for each in getattr(self, side) if each.kind == kind), Filter(kind))

    def place_of(self, side: str, kind: str) -> int:
        """The index of the first filter of a kind; that after the last one if there is none."""
        filters: tuple[Filter, ...] = getattr(self, side)
        return next((at for at, each in enumerate(filters) if each.kind == kind), len(filters))

    def with_filter(self, side: str, at: int, each: Filter | None) -> FilterChoice:
        """The choice with another filter at this place, or (None) without it; behind the last one it is added."""
        filters: list[Filter] = list(getattr(self, side))
        filters[at : at + 1] = [] if each is None else [each]
        changes: dict[str, Any] = {side: tuple(filters)}
        return replace(self, **changes)
