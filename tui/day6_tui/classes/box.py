"""The words of a box over the panes, made to fit: what is too long loses its middle, never the line that says what to do."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from day6_tui.panes.cells import wrap

SLIM = 64
"""Columns; on a narrower desktop a box may have all of them, else half."""
WIDEST = 60
# Textual measures the height that boxes need without their scroll bar, and lays them out beside it: lines were lost.
BOX_CSS = f"""
    ToastRack {{ scrollbar-size-vertical: 0; }}
    Toast {{ width: {WIDEST}; max-width: 50%; padding: 1; }}
    .-slim Toast {{ max-width: 100%; }}
"""
BREAKPOINTS = [(0, "-slim"), (SLIM, "-broad")]
FEWEST = 3
"""Lines in which a cut text shows how it begins and ends."""


class Room(NamedTuple):
    """For the words of a box, in cells."""

    width: int
    height: int


def room_on(width: int, height: int, title: str) -> Room:
    """What a desktop of this size has for one box: without its title, its padding and its distance from the edges."""
    inside = min(WIDEST, width if width < SLIM else width // 2) - 2
    return Room(inside, height - 4 - len(wrap(title, inside)))


def words_in(room: Room, sayings: Sequence[str], unshown: int, how: str, ellipsis: str) -> str:
    """The latest sayings in so many lines, one for those before which find no place, and what to do.

    `unshown` are those that are not even given. The latest is the last to be left out.
    """
    lines = wrap(how, room.width)
    rest = room.height - len(lines)
    texts = [wrap(text, room.width) for text in sayings]
    fits = (count for count in range(len(texts), 1, -1) if rest - 2 >= count * FEWEST)
    count = next(fits, 1)
    more = unshown + len(texts) - count
    spare = rest - 2 >= FEWEST
    above = [f"{ellipsis} {more}"] if more and spare else []
    between = [""] if spare else []
    shown = _shared(texts[-count:], rest - len(above) - len(between), ellipsis)
    return "\n".join([*above, *shown, *between, *lines])


def _shared(texts: list[list[str]], most: int, ellipsis: str) -> list[str]:
    """All of the short ones; the long ones have alike of what those leave."""
    rooms: dict[int, int] = {}
    for done, number in enumerate(sorted(range(len(texts)), key=lambda each: len(texts[each]))):
        rooms[number] = min(len(texts[number]), (most - sum(rooms.values())) // (len(texts) - done))
    return [line for number, lines in enumerate(texts) for line in _cut(lines, rooms[number], ellipsis)]


def _cut(lines: list[str], most: int, ellipsis: str) -> list[str]:
    """Lines without their middle."""
    if len(lines) <= most:
        return lines
    if most < FEWEST:
        return [*lines[: max(0, most - 1)], ellipsis]
    end = (most - 1) // 2
    return [*lines[: most - 1 - end], ellipsis, *lines[-end:]]
