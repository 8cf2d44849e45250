"""The topic monitor's tree, with columns."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment
from rich.style import Style
from rich.text import Text
from textual import events
from textual.strip import Strip
from textual.widgets import Tree
from textual.widgets.tree import TreeNode

from day6_core.elide import elide
from day6_core.session.harmless import one_line
from day6_tui.appearance.characters import showable
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, clip, fit
from day6_tui.windows.fields.field_list import without_package
from day6_tui.windows.parts.desktop_tree import DesktopTree

if TYPE_CHECKING:
    from day6_tui.windows.rqt.topics import TopicsPane

BEFORE_NAME = 6
"""Cells before the name of a topic: the mark of what can be opened, and the check box."""

LONGEST_PART = 17
"""Cells of the longest name of what is below every topic, with what stands before it."""

INDENT = 2
"""Cells by which a field lies further right than its message."""

Path = tuple[str, ...]
"""Where a line belongs: the name of the topic, then those of its fields."""


@dataclass(frozen=True, slots=True)
class TopicRow:
    """What a line of the tree says. `ticked` is None for a line without a check box."""

    path: Path
    type: str = ""
    bandwidth: str = ""
    hz: str = ""
    value: str = ""
    ticked: bool | None = None
    quiet: bool = False
    """Whether the value is a remark, and none that was received."""


class Branch(NamedTuple):
    """A line and what opening it shows; None for a line that cannot be opened."""

    row: TopicRow
    parts: Callable[[], Sequence[Branch]] | None = None


class Columns(NamedTuple):
    """Widths in cells; 0 for a column for which there is no room."""

    topic: int
    type: int
    bandwidth: int
    hz: int
    value: int


LEAST_VALUE = 13
"""Cells that long names leave to the values."""


def columns_in(width: int, longest: int = 0) -> Columns:
    """The columns that a window of this width has room for: topic and value come before all others.

    Names of up to `longest` cells, with what stands before them, are shown in full if there is room.
    """
    bandwidth = 9 if width >= 76 else 0
    hz = 6 if width >= 34 else 0
    rest = width - sum(size + 1 for size in (bandwidth, hz) if size)
    kind = rest // 4 if width >= 50 else 0
    rest -= kind + 1 if kind else 0
    topic = max(rest * 11 // 20, min(rest, 14))
    topic = max(topic, min(longest, rest - 1 - LEAST_VALUE))
    return Columns(topic, kind, bandwidth, hz, max(0, rest - topic - 1))


class TopicTree(DesktopTree[TopicRow]):
    """Shows the branches that its pane gives it; which are open and where the cursor is outlasts their coming and going."""

    DEFAULT_CSS = """
    TopicTree { margin: 2 1 1 1; scrollbar-gutter: stable; }
    """

    def __init__(self, pane: TopicsPane, look: Look) -> None:
        super().__init__(look)
        self._pane = pane
        self._open: set[Path] = set()
        self._opened: Path | None = None
        """What was opened last, until its parts are in sight."""
        self._names: list[str] = []
        self._longest = LONGEST_PART
        """Cells of the longest name of a topic, with what stands before it."""
        self.remark = ""
        """What is shown while there are no lines."""
        self.guide_depth = INDENT

    def take_look(self, look: Look) -> None:
        super().take_look(look)
        self.notify_style_update()

    # -- what is shown -------------------------------------------------------------------------------------------------

    @property
    def columns(self) -> Columns:
        """The columns that there is room for, beside the scroll bar."""
        return columns_in(self.scrollable_content_region.width, self._longest)

    @property
    def visible_topics(self) -> set[str]:
        """The topics of which a line is in sight."""
        first = self.scroll_offset.y
        nodes = map(self.get_node_at_line, range(first, first + self.size.height))
        return {node.data.path[0] for node in nodes if node is not None and node.data is not None}

    def show(self, branches: Sequence[Branch]) -> None:
        """Show these branches, and draw only the lines that differ."""
        line, before = self.cursor_line, self.chosen
        if self._measure([row.path[-1] for row, _ in branches]) or bool(branches) != bool(self.root.children):
            self.forget_lines()
            self.refresh()
        self._fill(self.root, branches)
        if self.last_line >= 0:
            kept = self.node_at(before.path) if before is not None else None
            if kept is None:
                self.move_cursor(self.get_node_at_line(max(0, min(line, self.last_line))))
            elif kept is not self.cursor_node or kept.line != self.cursor_line:
                self.move_cursor(kept)
        if self._opened is not None and (opened := self.node_at(self._opened)) is not None:
            self._opened = None
            self.call_after_refresh(self._show_parts, opened)

    def _measure(self, names: list[str]) -> bool:
        """Measure the names of the topics; return whether the columns are other ones now."""
        if names == self._names:
            return False
        before, self._names = self._longest, names
        self._longest = max([LONGEST_PART, *(BEFORE_NAME + cell_len(one_line(name)) for name in names)])
        return self._longest != before

    def _show_parts(self, node: TreeNode[TopicRow]) -> None:
        """Scroll down as far as is needed to see what is below a line, but not beyond the line itself."""
        last = node
        while last.is_expanded and last.children:
            last = last.children[-1]
        top = min(node.line, last.line + 1 - self.size.height)
        if top > self.scroll_offset.y:
            self.scroll_to(y=top, animate=False, immediate=True)

    def node_at(self, path: Path) -> TreeNode[TopicRow] | None:
        """The node of a line, if it is shown."""
        node: TreeNode[TopicRow] | None = self.root
        for depth in range(len(path)):
            found = node.children if node is not None else ()
            node = next((each for each in found if each.data and each.data.path == path[: depth + 1]), None)
        return node

    def _fill(self, node: TreeNode[TopicRow], branches: Sequence[Branch]) -> None:
        if [child.data and child.data.path for child in node.children] != [branch.row.path for branch in branches]:
            node.remove_children()
            for row, _ in branches:
                node.add("", row, expand=row.path in self._open)
        for child, (row, parts) in zip(node.children, branches, strict=True):
            if child.data != row:
                child.data = row
                child.refresh()
            if child.allow_expand != (parts is not None):
                child.allow_expand = parts is not None
            if parts is not None and child.is_expanded:
                self._fill(child, parts())

    def on_tree_node_expanded(self, event: Tree.NodeExpanded[TopicRow]) -> None:
        event.stop()
        if event.node.data is not None:
            self._open.add(event.node.data.path)
            self._opened = event.node.data.path
            self._pane.refill()

    def on_tree_node_collapsed(self, event: Tree.NodeCollapsed[TopicRow]) -> None:
        event.stop()
        if event.node.data is not None:
            self._open.discard(event.node.data.path)

    def on_tree_node_highlighted(self, event: Tree.NodeHighlighted[TopicRow]) -> None:
        event.stop()
        self._pane.touch_frame()

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        super().watch_scroll_y(old_value, new_value)
        self._look.wake()

    # -- drawing -------------------------------------------------------------------------------------------------------

    def get_component_rich_style(self, *names: str, partial: bool = False, default: Style | None = None) -> Style:
        return Style.null() if partial else self.rich_style

    def render_label(self, node: TreeNode[TopicRow], base_style: Style, style: Style) -> Text:
        row, look = node.data, self._look
        assert row is not None
        colours, ellipsis = look.colours, look.glyphs.ellipsis
        widths, depth = self.columns, len(row.path) - 1
        chosen = colours.choice if self.has_focus else colours.strong
        on = chosen if node is self.cursor_node else None
        text = Text(end="", no_wrap=True)
        text.append(self._opener(node), (on or colours.muted) + Style.from_meta({"toggle": True}))
        if row.ticked is not None:
            box = on or (colours.publisher if row.ticked else colours.muted)
            text.append("[x] " if row.ticked else "[ ] ", box + Style.from_meta({"tick": row.path[0]}))
        room = widths.topic - depth * INDENT - text.cell_len
        name = elide(one_line(row.path[-1]), max(1, room), ellipsis)
        text.append(fit(name, max(0, room), ellipsis), on or (colours.node if depth else colours.topic))
        for size, cell, cell_style, right in (
            (widths.type, _short_type(row.type, widths.type), colours.accent, False),
            (widths.bandwidth, row.bandwidth, colours.text, True),
            (widths.hz, row.hz, colours.text, True),
            (widths.value, row.value, colours.muted if row.quiet else colours.text, False),
        ):
            if size:
                shown = clip(cell, size, ellipsis)
                pad = " " * (size - cell_len(shown))
                text.append(" " + (pad + shown if right else shown + pad), on or cell_style)
        return text

    def _opener(self, node: TreeNode[TopicRow]) -> str:
        if not node.allow_expand:
            return "  "
        if not self._look.glyphs.chinese:
            return "- " if node.is_expanded else "+ "
        return "▾ " if node.is_expanded else "▸ "

    def render_line(self, y: int) -> Strip:
        strip = super().render_line(y) if self.root.children or y else self._remark()
        return showable(strip, self._look)

    def _remark(self) -> Strip:
        width, colours = self.size.width, self._look.colours
        text = fit(" " + self.remark, width, self._look.glyphs.ellipsis)
        return Strip([Segment(text, colours.muted)], width)

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        node = self.cursor_node
        if self._pane.used(event):
            pass
        elif event.key == "right" and node is not None and node.allow_expand:
            node.expand()
        elif event.key == "left" and node is not None:
            if node.is_expanded:
                node.collapse()
            elif node.parent is not None and node.parent is not self.root:
                self.move_cursor(node.parent)
                self.scroll_to_node(node.parent, animate=False)
        else:
            return
        event.stop()
        event.prevent_default()

    def on_click(self, event: events.Click) -> None:
        topic = event.style.meta.get("tick")
        if topic is not None:
            self.move_cursor_to_line(event.style.meta["line"])
            self._pane.tick(topic)
            event.stop()
            event.prevent_default()


def _short_type(type_name: str, width: int) -> str:
    """A type in full if there is room, else without its package."""
    return type_name if cell_len(type_name) <= width else without_package(type_name)
