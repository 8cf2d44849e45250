"""Where a new pane goes: where most of all panes is seen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from day6_tui.panes.splits import Extent, Key, Layout, PanePlace, Tree


class PaneNeeds(NamedTuple):
    """What a pane needs, with its frame: below `least` it is useless, `good` is comfortable, more than `full` gains nothing."""

    least: Extent
    good: Extent
    full: Extent
    weight: float = 1.0
    """How much it matters that it is seen."""

    def within(self, columns: int) -> PaneNeeds:
        """What it needs if it makes do with so many columns."""
        least, good = (Extent(min(each.columns, columns), each.rows) for each in (self.least, self.good))
        return self._replace(least=least, good=good)


TERMINAL = PaneNeeds(Extent(30, 8), Extent(40, 12), Extent(80, 30))
GUIDE = PaneNeeds(Extent(30, 10), Extent(40, 18), Extent(60, 20))
OTHER = PaneNeeds(Extent(36, 8), Extent(56, 14), Extent(90, 24))
LESSON = PaneNeeds(Extent(34, 16), Extent(38, 21), Extent(60, 40), 2.0)
WIDE = 100
"""From this many columns on, two panes go side by side rather than one below the other, if both would do."""

FORGETTING = 0.8
"""How much less a pane counts than the one that was used after it."""


class Spot(NamedTuple):
    """A place for a new pane: at a side of another one."""

    beside: Key
    side: str


def seen(layout: Layout, needs: Callable[[Key], PaneNeeds], recent: Sequence[Key]) -> float:
    """How much of the panes a layout shows: of terminals and of windows those used last count most."""
    total = 0.0
    ranks = {True: -1, False: -1}
    for key in recent:
        place, need = layout.places.get(key), needs(key)
        rank = ranks[_is_terminal(key, needs)] = ranks[_is_terminal(key, needs)] + 1
        if place is None or not _can_be_used(place, need):
            continue
        part = min(1.0, place.width / need.full.columns) * min(1.0, place.height / need.full.rows)
        total += need.weight * FORGETTING**rank * part**0.6
    return total


def best_spot(
    tree: Tree,
    key: Key,
    size: Extent,
    needs: Callable[[Key], PaneNeeds],
    recent: Sequence[Key],
    *,
    keyboard: Key | None = None,
) -> Spot | None:
    """Where to put `key`, which is already in `recent`; None for an empty tree.

    No pane becomes smaller than it can be used: rather one becomes a tab. A window never covers the pane with the `keyboard`,
    and nothing covers a picture that matters more than itself while there is another place.
    """
    fronts = sorted((stack.front for stack in tree.stacks()), key=lambda front: _rank(front, recent))
    others = [front for front in fronts if front != keyboard]
    if _is_terminal(key, needs) and keyboard is not None and _is_terminal(keyboard, needs):
        others = fronts  # the keyboard goes to the new one anyway
    others = [front for front in others if needs(front).weight <= needs(key).weight] or others
    sides = ("right", "below") if size.columns >= WIDE else ("below", "right")
    beside = [Spot(front, side) for side in sides for front in fronts]
    tabs = [Spot(front, "tab") for front in others]

    before = tree.lay_out(*size, lambda each: needs(each).good, recent).places
    useful = {each for each, place in before.items() if _can_be_used(place, needs(each))} | {key}

    def worth(spot: Spot, *, usable: bool) -> float:
        trial = tree.copy()
        trial.add(key, *spot)
        layout = trial.lay_out(*size, lambda each: needs(each).good, recent)
        kept = all(_can_be_used(layout.places[each], needs(each)) for each in useful & layout.places.keys())
        return seen(layout, needs, recent) if key in layout.places and (kept or not usable) else 0.0

    for spots, usable in ((beside + tabs, True), (tabs, False), (beside, False)):
        values = [worth(spot, usable=usable) for spot in spots]
        if values and max(values) > 0:
            return spots[values.index(max(values))]
    return Spot((others or fronts)[-1], "tab") if fronts else None


def _is_terminal(key: Key, needs: Callable[[Key], PaneNeeds]) -> bool:
    return needs(key) is TERMINAL


def _can_be_used(place: PanePlace, needed: PaneNeeds) -> bool:
    return place.width >= needed.least.columns and place.height >= needed.least.rows


def put(
    tree: Tree,
    key: Key,
    size: Extent,
    needs: Callable[[Key], PaneNeeds],
    recent: Sequence[Key],
    *,
    keyboard: Key | None = None,
) -> None:
    """Put a pane into a tree at its `best_spot`."""
    tree.add(key, *(best_spot(tree, key, size, needs, recent, keyboard=keyboard) or (None, "right")))


def arranged(keys: Sequence[Key], size: Extent, needs: Callable[[Key], PaneNeeds], recent: Sequence[Key]) -> Tree:
    """A new tree with these panes, each put where it is seen best after those before it."""
    tree = Tree()
    for count, key in enumerate(keys, 1):
        lately = sorted(keys[:count], key=lambda each: _rank(each, recent))
        put(tree, key, size, needs, lately)
    return tree


def _rank(key: Key, recent: Sequence[Key]) -> int:
    return recent.index(key) if key in recent else len(recent)
