"""Frames around the boxes of one namespace: its members stand together, and nobody else stands inside.

Lines may pass through a frame; boxes and labels of others are moved out of its rows. Where that does not come to an
end (a picture too dense for frames), the frames in question are left out.
"""

from __future__ import annotations

from collections.abc import Iterator

from day6_core.ros.programs.rqt_graph.model.shapes import Item, Rect, within

_ROUNDS = 60
"""Moves before giving up: a few rounds per cluster are usual."""


class Clusters:
    """The clusters of a layered picture; empty when no box has one."""

    def __init__(self, layers: list[list[Item]]) -> None:
        self._layers = layers
        names = {item.cluster for layer in layers for item in layer if item.box is not None and item.cluster}
        for name in list(names):
            names.update(_around(name))
        self._names = sorted(names)
        self._members = {name: [item for item in self._items() if _belongs(item, name)] for name in self._names}
        self._depth = {name: self._height(name) for name in self._names}
        self._crowded: set[str] = set()

    def _items(self) -> Iterator[Item]:
        return (item for layer in self._layers for item in layer)

    def _height(self, name: str) -> int:
        """Return how many frames lie inside one another in a cluster, its own included."""
        inner = [other for other in self._names if other != name and within(other, name)]
        return 1 + max((other.count("/") - name.count("/") for other in inner), default=0)

    @property
    def margin(self) -> int:
        """Columns that the frames need on each side of a layer."""
        return 2 * max(self._depth.values(), default=0)

    def keep_together(self) -> None:
        """Let the members of each cluster follow each other in their layers, clusters everywhere in the same order."""
        if not self._names:
            return
        place = {item: index / max(1, len(layer)) for layer in self._layers for index, item in enumerate(layer)}
        mean = {name: sum([place[item] for item in found]) / len(found) for name, found in self._members.items()}
        for layer in self._layers:
            layer.sort(
                key=lambda item: [
                    *((mean[name], name) for name in _path(item.cluster) if name in mean),
                    (place[item], ""),
                ]
            )

    def stand_apart(self) -> None:
        """Move items down until no foreign box or label stands in the rows of a cluster."""
        for _ in range(_ROUNDS):
            moved = [name for name in self._names if self._separate(name)]
            if not moved:
                break
        lowest = min([item.y for item in self._items()] + [rect.y for _, rect in self._rects()], default=0)
        for item in self._items():
            item.y -= lowest
        self._crowded.update(name for name in self._names if self._intruder(name) is not None)

    def frames(self) -> tuple[tuple[str, Rect], ...]:
        """Return the frames, outer ones first."""
        return tuple(self._rects())

    # -- one cluster ---------------------------------------------------------------------------------------------------

    def _rows(self, name: str) -> tuple[int, int]:
        """Return the first row of the frame and the first row below it."""
        members, depth = self._members[name], self._depth[name]
        return min(item.y for item in members) - depth, max(item.y + item.height for item in members) + depth

    def _intruder(self, name: str) -> Item | None:
        """Return an item that is in the frame without belonging to it."""
        top, bottom = self._rows(name)
        layers = [item.layer for item in self._members[name]]
        for layer in self._layers[min(layers) : max(layers) + 1]:
            for item in layer:
                if item.width and not _belongs(item, name):
                    own = self._room(item, name)
                    if item.y - own < bottom and item.y + item.height + own > top:
                        return item
        return None

    def _room(self, item: Item, beside: str) -> int:
        """Return the rows that an item's own frames take between it and a cluster it is not in."""
        foreign = [name for name in _path(item.cluster) if name in self._depth and not within(beside, name)]
        return self._depth[foreign[0]] if foreign else 0

    def _separate(self, name: str) -> bool:
        """Move an intruder, or the cluster, out of the other's way; False if there is none."""
        item = self._intruder(name)
        if item is None:
            return False
        top, bottom = self._rows(name)
        own = self._room(item, name)
        layer = self._layers[item.layer]
        peers = [layer.index(member) for member in self._members[name] if member.layer == item.layer]
        below = layer.index(item) > min(peers) if peers else item.y + item.height / 2 >= (top + bottom) / 2
        if below:
            self._lower([item], bottom + own - item.y)
        else:
            self._lower(self._members[name], item.y + item.height + own - top)
        return True

    def _lower(self, items: list[Item], rows: int) -> None:
        """Move items down, and whoever stands below them in their layers."""
        first: dict[int, int] = {}
        for item in items:
            index = self._layers[item.layer].index(item)
            first[item.layer] = min(first.get(item.layer, index), index)
        for number, index in first.items():
            for item in self._layers[number][index:]:
                item.y += rows

    def _rects(self) -> Iterator[tuple[str, Rect]]:
        for name in self._names:
            if name not in self._crowded:
                members, side = self._members[name], 2 * self._depth[name]
                top, bottom = self._rows(name)
                left = min(item.x for item in members) - side
                right = max(item.x + item.width for item in members) + side
                yield name, Rect(left, top, max(right - left, len(name) + 4), bottom - top)


def _belongs(item: Item, name: str) -> bool:
    return bool(item.cluster) and within(item.cluster, name)


def _path(cluster: str) -> list[str]:
    """Return the clusters in which one lies, outermost first, and itself."""
    return [*reversed(list(_around(cluster))), cluster] if cluster else []


def _around(cluster: str) -> Iterator[str]:
    """Yield the clusters around one, innermost first."""
    outer = cluster.rpartition("/")[0]
    while outer:
        yield outer
        outer = outer.rpartition("/")[0]
