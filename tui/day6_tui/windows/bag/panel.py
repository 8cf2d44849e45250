"""What lies below the timeline of rqt_bag: the message of a topic at the playhead, as a tree of its fields or as its image."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.segment import Segment

from day6_core.ros.programs.rqt_bag.model.pictures import IMAGE
from day6_core.session.harmless import one_line
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip
from day6_tui.windows.bag.cells import runs
from day6_tui.windows.bag.message import MessageTree
from day6_tui.windows.bag.picture import Paintings

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_bag.model.bags import Bags

LEAST_LINES = 3
"""Of a message or an image."""


class BagPanel:
    """Open or not; while it `has_keys`, keys mean the fields of the message, and an image is shown as its fields, too."""

    def __init__(self, look: Look, model: Bags, paintings: Paintings) -> None:
        self._look = look
        self._model = model
        self._paintings = paintings
        self._tree: MessageTree | None = None
        self.has_keys = False

    @property
    def topic(self) -> str:
        """The topic whose messages are shown, '' while the panel is closed."""
        return "" if self._tree is None else self._tree.topic

    @property
    def is_open(self) -> bool:
        return self._tree is not None

    @property
    def field(self) -> str:
        """The field that the cursor is on, as rqt_plot wants it; '' for none, or without the keys."""
        return self._tree.field if self._tree is not None and self.has_keys else ""

    def show(self, topic: str) -> None:
        """Show the messages of a topic, '' for none."""
        self._tree = MessageTree(self._look, topic) if topic else None
        self.has_keys = False
        self._model.watch(*([topic] if topic else []))

    def forget(self) -> None:
        """Close, because other bags are on the timeline: their player watches nothing yet."""
        self._tree, self.has_keys = None, False

    def pull(self) -> None:
        """Take the message that is at the playhead now."""
        if self._tree is not None:
            self._tree.take(self._model.shown(self._tree.topic))

    def press(self, key: str) -> bool:
        """Handle a key; False for one that means nothing here."""
        return self._tree is not None and self.has_keys and self._tree.press(key)

    def click(self, y: int) -> None:
        """A click on a line: keys come here from now on."""
        if self._tree is not None:
            self.has_keys = True
            self._tree.click(y)

    def wheel(self, notch: int) -> None:
        """Move the cursor through the fields."""
        if self._tree is not None:
            self._tree.press("down" if notch > 0 else "up")

    def line(self, y: int, width: int, height: int, *, focused: bool) -> list[Segment]:
        """Draw one line of so many."""
        tree, colours = self._tree, self._look.colours
        if tree is None or y >= height:
            return []
        shown = self._model.shown(tree.topic)
        problem = self._look.texts("bag.no_message") if shown is None else shown.problem
        if shown is None or problem:
            style = colours.muted if shown is None else colours.warning
            return [Segment(" " + clip(one_line(problem), width - 1), style)] if not y else []
        if shown.type == IMAGE and not self.has_keys:
            lines = self._paintings.of(self._model.thumbnail(tree.topic, shown.time_ns, width - 2, 2 * height))
            return [Segment(" ", colours.text), *runs(lines[y])] if y < len(lines) else []
        return tree.line(y, width, height, focused=focused and self.has_keys)
