"""Names of joints in few cells: shortened in their middle, where they can still be told apart."""

from __future__ import annotations

from collections.abc import Sequence

from day6_tui.panes.cells import cell_len, clip


def shortened(names: Sequence[str], width: int, ellipsis: str) -> list[str]:
    """The names in at most `width` cells each.

    Of a long one the beginning and the end stay; how much of each, depends on where the names differ. One in which a character
    takes two cells is cut at its end.
    """
    room = width - cell_len(ellipsis)
    if room < 2:
        return [clip(name, width, ellipsis) for name in names]
    # Two parts of the end to one of the beginning, unless names become equal; then as near to that as possible.
    heads = sorted(range(1, room), key=lambda head: abs(head - room // 3))
    ways = [[_short(name, head, room - head, ellipsis) for name in names] for head in heads]
    return max(ways, key=lambda way: len(set(way)))


def _short(name: str, head: int, tail: int, ellipsis: str) -> str:
    if cell_len(name) <= head + tail + cell_len(ellipsis):
        return name
    if cell_len(name) != len(name):
        return clip(name, head + tail + cell_len(ellipsis), ellipsis)
    return f"{name[:head]}{ellipsis}{name[-tail:]}"
