"""Where everybody stands in a kitchen: cooks side by side behind their counters, each belt on lines of its own below them.

What is drawn is decided here, without a widget. Rows of belts count from the first one, columns from the first cook.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from day6_core.elide import elide
from day6_core.ros.programs.day6_kitchen.belts import Belt, Content, Cook, Hand
from day6_tui.panes.cells import cell_len, clip
from day6_tui.windows.kitchen.figures import NOBODY, Glyphs

NARROWEST, WIDEST = 10, 60
"""Columns for one cook."""

STUB = 26
"""Most cells of a belt that has nobody at its other end."""

LEAST_LINES = 6
"""From so many lines on, one is kept for what is not seen."""

SIDE = 1
"""Cells of a counter on either side of its middle."""

PILE = 2
"""Dishes that lie side by side where nobody takes them; a third one lies on them where a belt has lines enough."""


OUTER = 14
"""Cells that a belt has between an outer cook and the wall, where nobody is at its other end and there is room."""


class Size(NamedTuple):
    """How large things are drawn: which of the figures (None: none), and the lines of a belt."""

    figure: int | None
    step: int


SIZES = (Size(0, 5), Size(1, 5), Size(1, 4), Size(2, 4), Size(2, 3), Size(2, 2), Size(3, 2), Size(None, 2))
"""From the largest; the first in which all belts are seen is taken."""

TALLEST = 7
"""Lines of a belt where there is room for more."""

LONG_LISTS = {14: Size(2, 2), 9: Size(3, 2), 0: Size(None, 2)}
"""By the lines there are at least: the size where belts have to be scrolled."""


class KitchenPlan:
    """Where everybody stands in a window of `columns` x `lines` cells."""

    def __init__(self, content: Content, columns: int, lines: int, glyphs: Glyphs, ellipsis: str = "…") -> None:
        self.content = content
        count = max(1, len(content.cooks))
        at_the_left, at_the_right = _walls(content, columns)
        # Where not all have room, as many as are seen are seen whole.
        seen = max(1, min(count, columns // NARROWEST))
        self.pitch = max(NARROWEST, min(WIDEST, (columns - at_the_left - at_the_right) // seen))
        self.width = self.pitch * len(content.cooks) + at_the_left + at_the_right
        name_lines = 3 if lines >= 18 else 2 if lines >= 10 else 1
        self.names = {
            cook.name: name_in_lines(_told(cook), self.pitch - 2, name_lines, ellipsis) for cook in content.cooks
        }
        self.name_lines = max(map(len, self.names.values()), default=1)
        self.size = self._size(lines, glyphs)
        self.figure = NOBODY if self.size.figure is None else glyphs.figures[self.size.figure]
        cooks, belts = len(self.figure.rows) + self.name_lines, len(content.belts)
        self.step = max(self.size.step, min(TALLEST, (lines - cooks) // max(1, belts)))
        """Lines of a belt."""
        self.height = self.step * belts
        self.top = max(0, lines - cooks - self.height) // 2
        """Empty lines above."""
        self.head = self.top + cooks
        """Lines above the belts."""
        self._start = at_the_left
        """Where the first cook's part begins."""
        first = self._start + self.pitch // 2
        self._lanes = {cook.name: first + index * self.pitch for index, cook in enumerate(content.cooks)}
        self._last: dict[str, int] = {}
        """By cook: the row of the last of its belts."""
        for index, belt in enumerate(content.belts):
            self._last.update(dict.fromkeys((hand.cook for hand in (*belt.givers, *belt.takers)), self.running(index)))

    def _size(self, lines: int, glyphs: Glyphs) -> Size:
        belts = len(self.content.belts)
        for size in SIZES:
            figure = NOBODY if size.figure is None else glyphs.figures[size.figure]
            fits = not figure.rows or figure.width + 1 <= self.pitch
            if fits and len(figure.rows) + self.name_lines + belts * size.step <= lines:
                return size
        return next(size for least, size in LONG_LISTS.items() if lines >= least)

    # -- across --------------------------------------------------------------------------------------------------------

    def lane(self, cook: str) -> int:
        """The column in the middle of a cook's counter."""
        return self._lanes[cook]

    def cook_at(self, column: int) -> Cook | None:
        """The cook who stands there."""
        index = (column - self._start) // self.pitch
        return self.content.cooks[index] if 0 <= index < len(self.content.cooks) else None

    def cooks_between(self, first: int, end: int) -> Sequence[Cook]:
        """The cooks who stand, at least in part, from a column to before another one."""
        first, end = first - self._start, end - self._start
        return self.content.cooks[max(0, first // self.pitch) : max(0, -(-end // self.pitch))]

    def beyond(self, first: int, end: int) -> tuple[int, int]:
        """How many cooks are not seen to the left of a column, and from another one to the right."""
        lefts = [lane - self.pitch // 2 for lane in self._lanes.values()]
        return sum(left < first for left in lefts), sum(left + self.pitch > end for left in lefts)

    def ends(self, belt: Belt) -> tuple[int, int]:
        """The first and the last column of a belt, stubs among them, without the counters at its ends."""
        lanes = [self.lane(hand.cook) for hand in (*belt.givers, *belt.takers)]
        first, last = min(lanes), max(lanes)
        to_nobody = not belt.takers or (belt.givers and first == last)
        return (
            first + SIDE + 1 if belt.givers else self._stub(first, -1),
            self._stub(last, 1) if to_nobody else last - SIDE - 1,
        )

    def _stub(self, lane: int, way: int) -> int:
        """Where a belt ends that leads from a counter to nobody: before the next counter, or the wall."""
        outermost = lane + way * self.pitch
        others = outermost in self._lanes.values()
        wall = outermost - way * (SIDE + 3) if others else 0 if way < 0 else self.width - 1
        farthest = lane + way * (SIDE + STUB)
        return max(wall, farthest) if way < 0 else min(wall, farthest)

    # -- down ----------------------------------------------------------------------------------------------------------

    @property
    def dish_lines(self) -> int:
        """Lines of a dish: 2 where it stands on the belt, drawn large, 1 where it stands there small, 0 where it lies in it."""
        return min(2, self.step - 2)

    def running(self, index: int) -> int:
        """The row on which the belt of a number runs; its words are on the first of its rows, its dishes between."""
        return index * self.step + 1 + self.dish_lines

    def reaches(self, cook: str, row: int) -> bool:
        """Whether a cook's counter is as long as that."""
        return row <= self._last.get(cook, -1)

    def belt_at(self, row: int) -> Belt | None:
        """The belt of a row."""
        index = row // self.step
        return self.content.belts[index] if 0 <= index < len(self.content.belts) else None

    def belts_between(self, first: int, end: int) -> Iterator[tuple[int, Belt]]:
        """The belts that are seen, wholly or in part, from a row to before another one, each with its first row."""
        for index in range(max(0, first // self.step), min(len(self.content.belts), -(-end // self.step))):
            yield index * self.step, self.content.belts[index]

    def row(self, topic: str) -> int:
        """The first row of a belt."""
        return next(index for index, belt in enumerate(self.content.belts) if belt.topic == topic) * self.step


def _walls(content: Content, columns: int) -> tuple[int, int]:
    """Columns to leave at the left and at the right, for belts of the outer cooks at which nobody else stands."""
    if not content.cooks:
        return 0, 0
    first, last = content.cooks[0].name, content.cooks[-1].name
    more = max(0, min(OUTER - columns // len(content.cooks) // 2, columns - NARROWEST * len(content.cooks)))
    to_the_left = any(not belt.givers and belt.takers[0].cook == first for belt in content.belts)
    to_the_right = any(not belt.takers and last in [hand.cook for hand in belt.givers] for belt in content.belts)
    both = to_the_left and to_the_right
    return to_the_left * (more // 2 if both else more), to_the_right * (more // 2 if both else more)


def _told(cook: Cook) -> str:
    return cook.title + (f" ×{cook.count}" if cook.count > 1 else "")


def name_in_lines(name: str, room: int, most: int, ellipsis: str) -> list[str]:
    """A name in at most so many lines of `room` cells, broken where its parts end; of a longer one the end stays whole."""
    lines = [""]
    for part in re.findall(r"[^_/ .-]*[_/ .-]?", name):
        if lines[-1] and cell_len((lines[-1] + part).rstrip()) > room:
            lines.append("")
        lines[-1] += part if lines[-1] or part != " " else ""
    lines = [line.strip() for line in lines]
    if len(lines) > most:
        lines[most - 1 :] = ["".join(lines[most - 1 :])]
    return [elide(line, room, ellipsis) if cell_len(line) > room else line for line in lines]


class Way(NamedTuple):
    """The way of the dishes of one cook on one belt: columns of the dish's left edge at the beginning and at the end."""

    giver: Hand
    start: int
    end: int


def ways(plan: KitchenPlan, belt: Belt, width: int) -> Iterator[Way]:
    """The ways of dishes of a `width` on a belt: from each giver to the farthest taker on either side, or to its end."""
    near = SIDE + 1
    # Of each taker: the column of its counter, and how many cells before it a dish stops.
    places = [(plan.lane(taker.cook), near + (4 if belt.refusal_of(taker) is not None else 0)) for taker in belt.takers]
    first, last = min(places, default=(0, 0)), max(places, default=(0, 0))
    for giver in belt.givers:
        lane = plan.lane(giver.cook)
        to_the_left = bool(places) and first[0] < lane
        if places and last[0] > lane:
            yield Way(giver, lane + near, max(lane + near, last[0] - last[1] - width + 1))
        elif not to_the_left:
            yield Way(giver, lane + near, max(lane + near, plan.ends(belt)[1] - width + 1))
        if to_the_left:
            yield Way(giver, lane - near - width + 1, min(lane - near - width + 1, first[0] + first[1]))


def dish_places(way: Way, on_the_way: Sequence[float], width: int) -> list[int]:
    """The columns of the dishes' left edges when they have made these parts (0 to 1) of their way, the first one first.

    Of dishes that would lie on each other only the first is drawn.
    """
    found: list[int] = []
    for progress in on_the_way:
        place = round(way.start + (way.end - way.start) * min(1.0, max(0.0, progress)))
        if not found or abs(place - found[-1]) > width:
            found.append(place)
    return found


def clipped(topic: str, room: int, ellipsis: str) -> str:
    """A topic's name in so many cells: the parts at its ends tell most."""
    return clip(elide(topic, room, ellipsis), room, ellipsis)
