"""The tree of the Displays panel, with the two columns of RViz."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rich.segment import Segment
from rich.text import Text
from textual import events
from textual.geometry import Region
from textual.strip import Strip
from textual.widgets import Tree
from textual.widgets.tree import TreeNode

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.properties import Property
from day6_tui.appearance.characters import showable
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import harmless
from day6_tui.textual_private.survival import PersonMessage
from day6_tui.windows.parts.desktop_tree import DesktopTree
from day6_tui.windows.rviz import panel

MOST_LINES = 5000
"""A robot of thousands of links must not make the panel slow."""

_NO_LABEL = Text("")


class PropertyTree(DesktopTree[panel.PropertyLine]):
    """Shows the properties of an `RViz`. Which branches are open is the program's, the cursor and what is in sight are Textual's.

    A branch that was never opened has no nodes.
    """

    class Clicked(PersonMessage):
        """The mouse was pressed and released on a `part` of a line: its `opener`, its check `box` or its `value`."""

        def __init__(self, prop: Property, part: str) -> None:
            super().__init__()
            self.prop = prop
            self.part = part

    class Moved(PersonMessage):
        """The cursor is on another line, or other lines are in sight."""

    def __init__(self, rviz: RViz, look: Look) -> None:
        super().__init__(look)
        self._rviz = rviz
        self._seen = -1
        self._active = False
        self._room = 0
        """How many more lines there may be."""
        self._node_by_property: dict[Property, TreeNode[panel.PropertyLine]] = {}
        """The nodes that are lines."""
        self._shown: list[tuple[object, ...]] = []
        """What the rows in sight look like."""

    # -- what there is -------------------------------------------------------------------------------------------------

    @property
    def prop(self) -> Property | None:
        """The chosen property."""
        return self.chosen.prop if self.chosen is not None else None

    @property
    def chosen_display(self) -> Display | None:
        """The display that the chosen line belongs to."""
        each = self.prop
        while each is not None and not isinstance(each, Display):
            each = each.parent
        return each

    @property
    def at_the_end(self) -> bool:
        """Whether the cursor is on the last line."""
        return self.cursor_line >= self.last_line

    def node_of(self, prop: Property) -> TreeNode[panel.PropertyLine] | None:
        """The node of a property, if the branches above it are open."""
        return self._node_by_property.get(prop)

    # -- following the program -----------------------------------------------------------------------------------------

    def follow(self, *, active: bool) -> None:
        """Show what the program changed, and draw only the lines that differ. `active`: the tree has the keyboard."""
        self._active = active
        if self._rviz.tree_version != self._seen:
            self._seen = self._rviz.tree_version
            self.refill()
        first = int(self.scroll_offset.y)
        rows = [self._state(y) for y in range(first, first + self.size.height)]
        if (before := self._shown) != rows:
            self._shown = rows
            for y, (old, new) in enumerate(zip(before, rows, strict=False)):
                if old != new:
                    self.refresh(Region(0, y, self.size.width, 1))

    def _state(self, y: int) -> tuple[object, ...]:
        """What a line looks like depends on this."""
        node = self.get_node_at_line(y)
        if node is None or node.data is None:
            return ()
        prop = node.data.prop
        chosen = node is self.cursor_node
        opens = node.data.can_open and prop.expanded, node.data.can_open
        return (
            prop,
            node.data.depth,
            prop.name,
            prop.value,
            isinstance(prop, Display) and prop.enabled,
            opens,
            panel.level_of(prop),
            chosen,
            chosen and self._active,
        )

    def refill(self) -> None:
        """Walk the properties again; the chosen one stays chosen where it still is, else the line where it was."""
        line, before, in_sight = self.cursor_line, self.prop, self._is_in_sight(self.cursor_line)
        self._room = MOST_LINES
        self._node_by_property.clear()
        with self.filling():
            self._fill(self.root, self._rviz.panels, 0)
        if self.last_line >= 0:
            kept = self.node_of(before) if before is not None else None
            if kept is None:
                kept = self.get_node_at_line(max(0, min(line, self.last_line)))
            assert kept is not None
            if kept is not self.cursor_node:
                self.move_cursor(kept)
            elif in_sight and not self._is_in_sight(kept.line):
                self.scroll_to_line(kept.line, animate=False)

    def _is_in_sight(self, line: int) -> bool:
        return 0 <= line - int(self.scroll_offset.y) < self.size.height

    def _fill(self, node: TreeNode[panel.PropertyLine], properties: Sequence[Property], depth: int) -> None:
        shown = [prop for prop in properties if not prop.hidden][: self._room]
        self._room -= len(shown)
        if [child.data and child.data.prop for child in node.children] != shown:
            node.remove_children()
            for prop in shown:
                node.add(_NO_LABEL, panel.PropertyLine(prop, depth), expand=prop.expanded)
        for child, prop in zip(node.children, shown, strict=True):
            self._node_by_property[prop] = child
            child.allow_expand = panel.PropertyLine(prop, depth).can_open
            if child.is_expanded != prop.expanded:
                child.toggle()
            if prop.expanded:
                self._fill(child, prop.children, depth + 1)

    def process_label(self, label: object) -> Text:
        return _NO_LABEL  # lines draw themselves

    def choose(self, prop: Property) -> None:
        """Open the tree down to a property and choose it."""
        above = prop.parent
        while above is not None:
            above.expanded = True
            above = above.parent
        self.refill()
        if (node := self.node_of(prop)) is not None:
            self.move_cursor(node)

    def on_tree_node_expanded(self, event: Tree.NodeExpanded[panel.PropertyLine]) -> None:
        event.stop()
        self._tell(event.node)

    def on_tree_node_collapsed(self, event: Tree.NodeCollapsed[panel.PropertyLine]) -> None:
        event.stop()
        self._tell(event.node)

    def _tell(self, node: TreeNode[panel.PropertyLine]) -> None:
        """Textual's own keys opened or closed a branch, or all beside it: the program keeps which are open."""
        if node.data is None or node.data.prop.expanded == node.is_expanded:
            return
        for each in node.parent.children if node.parent is not None else ():
            if each.data is not None:
                each.data.prop.expanded = each.is_expanded
        self.refill()

    def on_tree_node_highlighted(self, event: Tree.NodeHighlighted[panel.PropertyLine]) -> None:
        event.stop()
        self.post_message(self.Moved())

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        super().watch_scroll_y(old_value, new_value)
        self.post_message(self.Moved())

    # -- drawing -------------------------------------------------------------------------------------------------------

    def render_line(self, y: int) -> Strip:
        width, look = self.size.width, self._look
        node = self.get_node_at_line(y + int(self.scroll_offset.y))
        if node is None or node.data is None:
            return Strip.blank(width, look.colours.text)
        chosen = node is self.cursor_node
        segments: Iterable[Segment] = harmless(panel.segments_of(node.data, width, look, chosen, self._active))
        return showable(Strip(segments), look).adjust_cell_length(width, look.colours.text)

    def on_hide(self, event: events.Hide) -> None:
        if self.has_focus:
            event.prevent_default()  # the window decides who gets the keyboard, not the order of Textual's widgets

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def move(self, steps: int) -> None:
        """Choose a line farther down, or up."""
        self.move_cursor(self.get_node_at_line(max(0, min(self.cursor_line + steps, self.last_line))))

    def on_click(self, event: events.Click) -> None:
        event.stop()
        event.prevent_default()
        node = self.get_node_at_line(event.y + int(self.scroll_offset.y))
        if node is None or node.data is None:
            return
        self.cursor_line = node.line
        line, zone = node.data, panel.zones(node.data, self.size.width)
        if line.can_open and zone.opener <= event.x <= zone.opener + 1:
            self.post_message(self.Clicked(line.prop, "opener"))
        elif zone.box is not None and zone.box <= event.x < zone.box + 3:
            self.post_message(self.Clicked(line.prop, "box"))
        elif event.x >= zone.value or event.chain > 1:
            self.post_message(self.Clicked(line.prop, "value"))
