"""Where a new pane goes: where most of all panes is seen, and a window in place of what was used least recently."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeAlias

from day6_tui.panes.splits import Extent, Key, Layout, Tree


class PaneNeeds(NamedTuple):
    """What a pane needs, with its frame: below `least` it is useless, `good` is comfortable, more than `full` gains nothing."""

    least: Extent
    good: Extent
    full: Extent
    weight: float = 1.0
    """How much it matters that it is seen."""
    stays: bool = False
    """Whether it is read all the time: what opens by itself covers it only where there is no other place."""

    def within(self, columns: int) -> PaneNeeds:
        """What it needs if it makes do with so many columns."""
        least, good = (Extent(min(each.columns, columns), each.rows) for each in (self.least, self.good))
        return self._replace(least=least, good=good)


TERMINAL = PaneNeeds(Extent(30, 8), Extent(40, 12), Extent(80, 30))
TELEOP = TERMINAL._replace(good=Extent(40, 10))
"""Of a terminal in which keys drive: it goes on showing what it printed at its start."""

GUIDE = PaneNeeds(Extent(30, 10), Extent(40, 18), Extent(60, 20))
OTHER = PaneNeeds(Extent(36, 8), Extent(56, 14), Extent(90, 24))
LESSON = PaneNeeds(Extent(34, 15), Extent(38, 21), Extent(46, 40), 2.0, stays=True)
WIDE = 100
"""From this many columns on, two panes go side by side rather than one below the other, if both would do."""

FORGETTING = 0.8
"""How much less a pane counts than the one that was used after it."""

YIELDING = 0.7
"""The same when a window has to cover one: a turtle yields to a terminal after which two others were used, RViz after four."""

PICTURE = 2.0
"""The weight from which on a window is a picture of what moves."""

LARGER = 1.3
"""The others make room for a picture that has a place, but none where it is comfortable, if it becomes so much larger."""


class Spot(NamedTuple):
    """A place for a new pane: at a side of another one."""

    beside: Key
    side: str


Wanted: TypeAlias = Callable[[PaneNeeds], Extent]


def least(needs: PaneNeeds) -> Extent:
    """Of what a pane needs: to be of use."""
    return needs.least


def good(needs: PaneNeeds) -> Extent:
    """Of what a pane needs: to be comfortable."""
    return needs.good


@dataclass(frozen=True)
class Room:
    """The desktop in which a pane gets its place, and what is known of the panes there, the new one included."""

    size: Extent
    needs: Callable[[Key], PaneNeeds]
    recent: Sequence[Key]
    """The panes used last, the last one first."""
    keyboard: Key | None = None
    """The pane that keeps the keyboard: no window covers it."""
    family: Callable[[Key], Collection[object]] = lambda key: ()
    """What a window has in common with others, its launch and what it is about: such windows are looked at together."""

    driven: Collection[Key] = ()
    """The terminals in which keys drive."""
    firm: bool = True
    """Whether comfortable panes give to those that would be of no use: not for terminals, whose places people know by heart."""

    def rank(self, key: Key) -> int:
        return self.recent.index(key) if key in self.recent else len(self.recent)

    def is_terminal(self, key: Key) -> bool:
        return self.needs(key) is TERMINAL

    def are_kin(self, one: Key, other: Key) -> bool:
        return bool(set(self.family(one)) & set(self.family(other)))

    def fronts(self, tree: Tree) -> list[Key]:
        """The panes in front, the one used last first."""
        return sorted((stack.front for stack in tree.stacks()), key=self.rank)

    def lay_out(self, tree: Tree) -> Layout:
        needs = self.needs if self.firm else lambda key: self.needs(key)._replace(least=Extent(0, 0))
        return tree.lay_out(*self.size, needs, self.recent)

    def has(self, wanted: Wanted, key: Key, layout: Layout) -> bool:
        """Whether a pane is seen, and as large as wanted."""
        place, size = layout.places.get(key), wanted(self.needs(key))
        return place is not None and place.width >= size.columns and place.height >= size.rows

    def part(self, key: Key, layout: Layout) -> float:
        """How much of what a pane could use it has; 0 if that is of no use."""
        if not self.has(least, key, layout):
            return 0.0
        place, full = layout.places[key], self.needs(key).full
        return min(1.0, place.width / full.columns) * min(1.0, place.height / full.rows)


def seen(layout: Layout, room: Room) -> float:
    """How much of the panes a layout shows: of terminals and of windows those used last count most."""
    total = 0.0
    ranks = {True: -1, False: -1}
    for key in room.recent:
        rank = ranks[room.is_terminal(key)] = ranks[room.is_terminal(key)] + 1
        total += room.needs(key).weight * FORGETTING**rank * room.part(key, layout) ** 0.6
    return total


def _best(
    tree: Tree, key: Key, spots: Sequence[Spot], room: Room, kept: Wanted | None = least, *, folds: bool = False
) -> Spot | None:
    """The spot with which most is seen, None if with none anything is; the new pane has what is `kept`, and nobody loses it.

    With `folds` panes may vanish where the desktop is too small for all.
    """
    before = room.lay_out(tree)
    had = [key] if kept is None else [key, *(each for each in before.places if room.has(kept, each, before))]

    def worth(spot: Spot) -> float:
        layout = _with(tree, key, spot, room)
        if not folds and spot.side != "tab" and len(layout.places) <= len(before.places):
            return 0.0  # a desktop that is too small would show both as tabs
        lost = kept is not None and any(each in layout.places and not room.has(kept, each, layout) for each in had)
        return seen(layout, room) if key in layout.places and not lost else 0.0

    values = [worth(spot) for spot in spots]
    return spots[values.index(max(values))] if values and max(values) > 0 else None


def _with(tree: Tree, key: Key, spot: Spot, room: Room) -> Layout:
    """How a tree looks with a new pane."""
    trial = tree.copy()
    trial.add(key, *spot)
    return room.lay_out(trial)


def _sides(tree: Tree, room: Room) -> list[Spot]:
    """Every place beside a pane."""
    sides = ("right", "below") if room.size.columns >= WIDE else ("below", "right")
    return [Spot(front, side) for side in sides for front in room.fronts(tree)]


def best_spot(tree: Tree, key: Key, room: Room) -> Spot | None:
    """Where to put a pane; None if there is no place where it can be used.

    No pane becomes smaller than it can be used: rather one becomes a tab. A window never covers the pane with the keyboard, nor
    one that came with it; of the others the one that was used least recently, and a picture later than text.
    """
    if room.is_terminal(key):
        tabs, soft = _tabs_of_terminals(tree, key, room), replace(room, firm=False)
        spots = [spot for spot in _sides(tree, room) if _best(tree, key, [spot], room, folds=True)] + tabs
        return _best(tree, key, spots, soft, folds=True) or _best(tree, key, tabs, soft, None)
    tabs = [spot for spot in _tabs_of_windows(tree, key, room) if not room.needs(spot.beside).stays]
    tabs = [spot for spot in tabs if _best(tree, key, [spot], room)]
    sides = _sides(tree, room)
    comfortable = [spot for spot in sides if room.has(good, key, _with(tree, key, spot, room))]
    return _best(tree, key, comfortable, room) or _best(tree, key, sides + tabs[:1], room)


def _tabs_of_terminals(tree: Tree, key: Key, room: Room) -> list[Spot]:
    """What a terminal may cover: the keyboard's terminal too, as it gets the keyboard; no picture that matters more.

    Rather than the only terminal, in which keys drive, it covers a picture: what is opened then listens to these keys.
    """
    fronts = room.fronts(tree)
    others = [front for front in fronts if front != room.keyboard]
    if room.keyboard is not None and room.is_terminal(room.keyboard):
        others = fronts
    light = [front for front in others if room.needs(front).weight <= room.needs(key).weight]
    if light and all(front in room.driven for front in light):
        light = [front for front in others if front not in room.driven and not room.needs(front).stays] or light
    return [Spot(front, "tab") for front in light or others]


def _tabs_of_windows(tree: Tree, key: Key, room: Room, *, of_kin: bool = False) -> list[Spot]:
    """What a window may cover: first what was used least recently. A picture is used while keys drive.

    Only if there is nothing else (`of_kin`) it may be what belongs to the window.
    """

    def order(front: Key) -> tuple[bool, float]:
        needs = room.needs(front)
        users = [front, *room.driven] if needs.weight >= PICTURE else [front]
        return needs.stays, needs.weight * YIELDING ** min(map(room.rank, users))

    def is_kin(front: Key) -> bool:
        return any(room.are_kin(each, key) for each in tree.stack_of(front).keys)

    fronts = room.fronts(tree)
    others = [front for front in fronts if front != room.keyboard and (of_kin or not is_kin(front))]
    if of_kin:
        others = others or fronts
    return [Spot(front, "tab") for front in sorted(others, key=lambda front: (is_kin(front), *order(front)))]


def put(tree: Tree, key: Key, room: Room) -> Tree:
    """Put a pane into a tree, and return that or, if others have to make room for it, a new one."""
    spot = None if tree.root is None else best_spot(tree, key, room)
    if tree.root is not None and not room.is_terminal(key) and (made := _made_room(tree, key, spot, room)) is not None:
        return made
    if spot is None and room.is_terminal(key) and tree.root is not None:
        spot = _tabs_of_terminals(tree, key, room)[-1]
    elif spot is None and tree.root is not None:
        tabs = _tabs_of_windows(tree, key, room, of_kin=True)
        spot = next((each for each in tabs if _best(tree, key, [each], room)), tabs[0])
    tree.add(key, *(spot or (None, "right")))
    return tree


def _made_room(tree: Tree, key: Key, spot: Spot | None, room: Room) -> Tree | None:
    """A new tree with a window for which there is no place in `tree`, or (a picture that matters most) none that is comfortable.

    Seen are the pane with the keyboard, what came with the window and what is read all the time; of the rest, what was used last
    first, as much as has room in comfort. None if even then the window could not be used.
    """
    before = room.lay_out(tree)
    needs = room.needs(key)
    if spot is not None:
        heaviest = max((room.needs(each).weight for each in before.places if not room.needs(each).stays), default=0.0)
        if needs.weight <= heaviest or room.has(good, key, _with(tree, key, spot, room)):
            return None
    wanted = [key] if room.keyboard is None else [key, room.keyboard]
    beside = [each for each in before.places if room.needs(each).stays or room.are_kin(each, key)]
    seen_before = [each for each in room.recent if each in before.places]

    def by_size(keys: Iterable[Key]) -> list[Key]:
        return sorted(dict.fromkeys(keys), key=lambda each: -math.prod(room.needs(each).least))

    for first in (by_size([*wanted, *beside]), [*by_size(wanted), *by_size(beside)]):
        order = list(dict.fromkeys([*first, *seen_before, *room.recent]))
        made = arranged(order, room, len(first), len(seen_before) + 1)
        layout = room.lay_out(made)
        if all(room.has(least, each, layout) for each in wanted):
            larger = spot is None or room.part(key, layout) >= LARGER * room.part(key, _with(tree, key, spot, room))
            return made if larger else None
    return None


def arranged(keys: Sequence[Key], room: Room, in_any_case: int | None = None, seen_at_most: int | None = None) -> Tree:
    """A new tree with these panes, the first ones seen best: what has no room beside those is a tab behind one of its sort.

    Panes after the first `in_any_case` are seen only where all are comfortable, those after the first `seen_at_most` never.
    """
    tree = Tree()
    for count, key in enumerate(keys, 1):
        now = replace(room, recent=sorted(keys[:count], key=room.rank))
        kept = least if in_any_case is None or count <= in_any_case else good
        fronts = now.fronts(tree)
        sides = _sides(tree, now) if seen_at_most is None or count <= seen_at_most else []
        spot = _best(tree, key, sides, now, kept)
        if spot is not None or not fronts:
            tree.add(key, *(spot or (None, "right")))
            continue
        alike = [front for front in fronts if now.is_terminal(front) == now.is_terminal(key)] or fronts
        tree.add(key, alike[-1], "tab")
        tree.bring_to_front(alike[-1])
        tree.stack_of(key).keys.sort()
    return tree
