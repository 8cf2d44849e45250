"""The tree of splits: which panes stand where, which are tabs of one place, and what a small desktop folds together.

No widgets here: a pane is a key. A `Stack` is one place with the panes that share it; a `Split` divides its place between its
parts. Where a desktop is too small for a split, its parts become tabs of one place until there is room again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol, TypeAlias

Key: TypeAlias = int
"""A pane's number."""

NARROWEST = 24
LOWEST = 5
"""A place with fewer columns or rows is folded into the one beside it."""

SIDES = ("left", "right", "above", "below", "tab")


class PanePlace(NamedTuple):
    """A rectangle in cells."""

    x: int
    y: int
    width: int
    height: int

    @property
    def right(self) -> int:
        return self.x + self.width

    @property
    def bottom(self) -> int:
        return self.y + self.height


class Extent(NamedTuple):
    """Columns and rows, with the frame."""

    columns: int
    rows: int


@dataclass(eq=False)
class Stack:
    """Panes that share one place: `front` is seen, the others are tabs on its frame."""

    keys: list[Key]
    front: Key


@dataclass(eq=False)
class Split:
    """Parts side by side (`across`) or one below the other. Without `shares` each gets what its panes wish for."""

    across: bool
    parts: list[Stack | Split]
    shares: list[float] | None = None


Node: TypeAlias = Stack | Split


class Border(NamedTuple):
    """The border behind `part` of a split: at column or row `at`, between `first` and `end` in the other direction."""

    split: Split
    part: int
    at: int
    first: int
    end: int
    begin: int
    """Where the split begins, and how long it is."""
    length: int


@dataclass
class Layout:
    """What a tree looks like at one size."""

    places: dict[Key, PanePlace] = field(default_factory=dict)
    """Of the panes that are seen."""
    stacks: dict[Key, list[Key]] = field(default_factory=dict)
    """For each pane that is seen, all panes of its place, itself included."""
    borders: list[Border] = field(default_factory=list)

    def neighbour(self, key: Key, side: str, recent: Sequence[Key] = ()) -> Key | None:
        """The pane beside `key` on a side; of several the one used last."""
        here = self.places.get(key)
        if here is None:
            return None
        beside = []
        for other, there in self.places.items():
            edges = {
                "left": there.right == here.x,
                "right": there.x == here.right,
                "above": there.bottom == here.y,
                "below": there.y == here.bottom,
            }
            overlaps = (
                min(here.bottom, there.bottom) > max(here.y, there.y)
                if side in ("left", "right")
                else min(here.right, there.right) > max(here.x, there.x)
            )
            if edges[side] and overlaps:
                beside.append(other)
        return min(beside, key=lambda other: recent.index(other) if other in recent else len(recent), default=None)


class Sizes(Protocol):
    """Below `least` a pane is useless, `good` is comfortable, more than `full` gains nothing."""

    @property
    def least(self) -> Extent: ...

    @property
    def good(self) -> Extent: ...

    @property
    def full(self) -> Extent: ...


Wish = Callable[[Key], Sizes]
"""The sizes that a pane wishes for."""


class Tree:
    """All panes of a desktop. Every operation keeps the tree tidy: no split with one part, none directly in its own kind."""

    def __init__(self, root: Node | None = None) -> None:
        self.root = root

    def stacks(self, node: Node | None = None) -> Iterator[Stack]:
        """All places, from the upper left on."""
        node = self.root if node is None else node
        if isinstance(node, Stack):
            yield node
        elif node is not None:
            for part in node.parts:
                yield from self.stacks(part)

    @property
    def keys(self) -> list[Key]:
        return [key for stack in self.stacks() for key in stack.keys]

    def stack_of(self, key: Key) -> Stack:
        """The place of a pane. Raises KeyError if it has none."""
        for stack in self.stacks():
            if key in stack.keys:
                return stack
        raise KeyError(key)

    @property
    def shape(self) -> object:
        """What stands where, whatever is in front: equal for trees in which it is the same."""

        def shape_of(node: Node | None) -> object:
            if isinstance(node, Split):
                return node.across, [shape_of(part) for part in node.parts], node.shares
            return set(node.keys) if node is not None else None

        return shape_of(self.root)

    def copy(self) -> Tree:
        def copied(node: Node) -> Node:
            if isinstance(node, Stack):
                return Stack(list(node.keys), node.front)
            shares = None if node.shares is None else list(node.shares)
            return Split(node.across, [copied(part) for part in node.parts], shares)

        return Tree(None if self.root is None else copied(self.root))

    # -- changes -------------------------------------------------------------------------------------------------------

    def add(self, key: Key, beside: Key | None = None, side: str = "right") -> None:
        """Put a pane at a side of another one (or of everything, without one); 'tab' puts it onto the same place."""
        if self.root is None:
            self.root = Stack([key], key)
        elif beside is not None and side == "tab":
            stack = self.stack_of(beside)
            stack.keys.append(key)
            stack.front = key
        else:
            target = self.root if beside is None else self.stack_of(beside)
            self._insert(target, Stack([key], key), side)

    def remove(self, key: Key) -> None:
        """Take a pane out; its neighbours get its place."""
        stack = self.stack_of(key)
        index = stack.keys.index(key)
        stack.keys.remove(key)
        if stack.front == key and stack.keys:
            stack.front = stack.keys[max(0, index - 1)]
        if not stack.keys:
            self._drop(stack)

    def move(self, key: Key, beside: Key, side: str) -> None:
        """Put a pane somewhere else."""
        if key != beside or (side != "tab" and len(self.stack_of(key).keys) > 1):
            other = beside if key != beside else next(k for k in self.stack_of(key).keys if k != key)
            self.remove(key)
            self.add(key, other, side)

    def swap(self, one: Key, other: Key) -> None:
        """Let two panes change places."""
        first, second = self.stack_of(one), self.stack_of(other)
        if first is second:
            return
        at, there = first.keys.index(one), second.keys.index(other)
        first.keys[at], second.keys[there] = other, one
        first.front = other if first.front == one else first.front
        second.front = one if second.front == other else second.front

    def bring_to_front(self, key: Key) -> None:
        """Make a pane the one that is seen of its stack."""
        self.stack_of(key).front = key

    def drag(self, border: Border, to: int) -> None:
        """Move a border to a column or row."""
        split = border.split
        shares = split.shares or [1.0 / len(split.parts)] * len(split.parts)
        before = sum(shares[: border.part])
        both = shares[border.part] + shares[border.part + 1]
        wanted = (to - border.begin) / max(1, border.length) - before
        least = min((NARROWEST if split.across else LOWEST) / max(1, border.length), both / 2)
        shares[border.part] = max(least, min(both - least, wanted))
        shares[border.part + 1] = both - shares[border.part]
        split.shares = shares

    def _insert(self, target: Node, new: Stack, side: str) -> None:
        across = side in ("left", "right")
        before = side in ("left", "above")
        parent = self._parent(target)
        if isinstance(target, Split) and target.across == across:
            parent, at = target, 0 if before else len(target.parts)
        elif parent is not None and parent.across == across:
            at = parent.parts.index(target) + (not before)
        else:
            both: list[Node] = [new, target] if before else [target, new]
            self._replace(target, Split(across, both))
            return
        if parent.shares is not None:
            # Half of the neighbour's.
            given = max(0, min(at - (not before), len(parent.shares) - 1))
            parent.shares[given] /= 2
            parent.shares.insert(at, parent.shares[given])
        parent.parts.insert(at, new)

    def _parent(self, node: Node, within: Node | None = None) -> Split | None:
        within = self.root if within is None else within
        if not isinstance(within, Split):
            return None
        if node in within.parts:
            return within
        return next((found for part in within.parts if (found := self._parent(node, part)) is not None), None)

    def _replace(self, old: Node, new: Node) -> None:
        parent = self._parent(old)
        if parent is None:
            self.root = new
            return
        at = parent.parts.index(old)
        if isinstance(new, Split) and new.across == parent.across:
            parent.parts[at : at + 1] = new.parts
            if parent.shares is not None:
                share = parent.shares[at]
                inner = new.shares or [1.0 / len(new.parts)] * len(new.parts)
                parent.shares[at : at + 1] = [share * each for each in inner]
        else:
            parent.parts[at] = new

    def _drop(self, node: Node) -> None:
        parent = self._parent(node)
        if parent is None:
            self.root = None
            return
        at = parent.parts.index(node)
        del parent.parts[at]
        if parent.shares is not None:
            del parent.shares[at]
            total = sum(parent.shares)
            parent.shares = [share / total for share in parent.shares]
        if len(parent.parts) == 1:
            self._replace(parent, parent.parts[0])

    # -- layout --------------------------------------------------------------------------------------------------------

    def lay_out(self, width: int, height: int, wish: Wish, recent: Sequence[Key] = ()) -> Layout:
        """The places at a size. `recent` are the panes used last, the last one first: they stay in sight where others fold."""
        found = Layout()
        if self.root is not None:
            _lay(self.root, PanePlace(0, 0, max(1, width), max(1, height)), wish, recent, found)
        return found


def _lay(node: Node, place: PanePlace, wish: Wish, recent: Sequence[Key], found: Layout) -> None:
    if isinstance(node, Stack):
        found.places[node.front] = place
        found.stacks[node.front] = list(node.keys)
        return
    length = place.width if node.across else place.height
    least = NARROWEST if node.across else LOWEST
    parts = _folded(node, max(1, length // least), recent)
    if len(parts) == 1:
        _lay(parts[0], place, wish, recent, found)
        return
    at = place.x if node.across else place.y
    begin = at
    whole = len(parts) == len(node.parts)
    for index, size in enumerate(_lengths(node if whole else Split(node.across, parts), length, wish)):
        there = PanePlace(at, place.y, size, place.height) if node.across else PanePlace(place.x, at, place.width, size)
        _lay(parts[index], there, wish, recent, found)
        at += size
        if whole and index + 1 < len(parts):
            first, end = (place.y, place.bottom) if node.across else (place.x, place.right)
            found.borders.append(Border(node, index, at, first, end, begin, length))


def _folded(node: Split, room: int, recent: Sequence[Key]) -> list[Node]:
    """The parts of a split, of which neighbours are folded into stacks until there are no more than `room`."""
    parts, never = list(node.parts), len(recent)
    if len(parts) <= room:
        return parts
    ranks = {key: rank for rank, key in reversed([*enumerate(recent)])}
    # How long ago each part was used.
    ages = [min((ranks.get(key, never) for key in Tree(part).keys), default=never) for part in parts]
    while len(parts) > room:
        # The two neighbours that were not used for the longest time.
        at = max(range(len(parts) - 1), key=lambda i: min(ages[i], ages[i + 1]))
        stacks = [stack for part in parts[at : at + 2] for stack in Tree(part).stacks()]
        keys = [key for stack in stacks for key in stack.keys]
        fronts = [stack.front for stack in stacks]
        front = min(fronts, key=lambda key: ranks.get(key, never))
        parts[at : at + 2], ages[at : at + 2] = [Stack(keys, front)], [min(ages[at : at + 2])]
    return parts


def _extent(node: Node, wish: Wish, which: Callable[[Sizes], Extent]) -> Extent:
    """The size at which everything in a node has `which` of its sizes."""
    if isinstance(node, Stack):
        return which(wish(node.front))
    sizes = [_extent(part, wish, which) for part in node.parts]
    columns, rows = [size.columns for size in sizes], [size.rows for size in sizes]
    return Extent(sum(columns), max(rows)) if node.across else Extent(max(columns), sum(rows))


def _lengths(node: Split, length: int, wish: Wish) -> list[int]:
    """The columns or rows of the parts of a split, which fill `length`."""
    count = len(node.parts)
    floor = min(NARROWEST if node.across else LOWEST, length // count)
    if node.shares is not None:
        return _whole([share * length for share in node.shares], length, floor)

    def lengths(which: Callable[[Sizes], Extent]) -> list[int]:
        return [max(floor, _extent(part, wish, which)[0 if node.across else 1]) for part in node.parts]

    least, good = lengths(lambda sizes: sizes.least), lengths(lambda sizes: sizes.good)
    if sum(good) <= length:
        return _whole(_shared(good, length, most=lengths(lambda sizes: sizes.full)), length, floor)
    return _whole(_cut(floor, least, good, length), length, floor)


def _cut(floor: int, least: list[int], good: list[int], length: int) -> list[float]:
    """Less than `good`, as all of it has no room: nobody gets less than `least` while another one has more."""
    fixed: dict[int, float] = {}
    while True:
        free = [at for at in range(len(good)) if at not in fixed]
        more = {at: good[at] - floor for at in free}
        rest = length - sum(fixed.values()) - floor * len(free)
        found = fixed | {at: floor + more[at] * rest / max(1, sum(more.values())) for at in free}
        short = [at for at in free if found[at] < least[at]]
        if not short or sum(least) > length:
            return [found[at] for at in range(len(good))]
        fixed |= {at: float(least[at]) for at in short}


def _shared(good: list[int], length: int, most: list[int]) -> list[float]:
    """What is more than `good` is shared: nobody gets more than `most` while another one still gains by it."""
    if sum(most) <= length:
        growth = [1 + full - each for each, full in zip(good, most, strict=True)]
        return [full + (length - sum(most)) * each / sum(growth) for full, each in zip(most, growth, strict=True)]
    fixed: dict[int, float] = {}
    while True:
        free = [at for at in range(len(good)) if at not in fixed]
        scale = (length - sum(fixed.values())) / sum(good[at] for at in free)
        found = fixed | {at: good[at] * scale for at in free}
        large = [at for at in free if found[at] > most[at]]
        if not large:
            return [found[at] for at in range(len(good))]
        fixed |= {at: float(most[at]) for at in large}


def _whole(wanted: list[float], length: int, least: int) -> list[int]:
    """Whole numbers near `wanted`, none below `least`, that add up to `length`."""
    found = [max(least, int(each)) for each in wanted]
    while (over := sum(found) - length) != 0:
        if over > 0:
            at = max(range(len(found)), key=lambda i: (found[i] > least, found[i] - wanted[i]))
            found[at] -= 1
        else:
            at = max(range(len(found)), key=lambda i: wanted[i] - found[i])
            found[at] += 1
    return found
