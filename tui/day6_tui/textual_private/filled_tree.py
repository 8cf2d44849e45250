"""The base class of our trees; in a module of its own, because most screens have none."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

from textual.widgets import Tree
from textual.widgets.tree import TreeDataType

if TYPE_CHECKING:
    from collections.abc import Iterator


class FilledTree(Tree[TreeDataType]):
    """A tree that may be filled with thousands of nodes: Textual forgets all lines it has drawn for each of them."""

    _filling = _stale = False

    @contextmanager
    def filling(self) -> Iterator[None]:
        """Have the lines forgotten once, at the end, if any node was changed inside."""
        self._filling, self._stale = True, False
        try:
            yield
        finally:
            self._filling = False
        if self._stale:
            self._invalidate()

    def forget_lines(self) -> None:
        """Have every line made anew when it is drawn."""
        self._invalidate()

    def _invalidate(self) -> None:
        if self._filling:
            self._stale = True
        else:
            super()._invalidate()
