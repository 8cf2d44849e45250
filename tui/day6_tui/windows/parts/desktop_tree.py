"""Textual's Tree in the colours of the desktop; its lines are as wide as the window and never wider."""

from __future__ import annotations

from rich.style import Style
from textual.widgets import Tree
from textual.widgets.tree import TreeDataType, TreeNode

from day6_tui.appearance.look import Look
from day6_tui.panes.scrollbars import colour_scrollbar
from day6_tui.textual_private.filled_tree import FilledTree
from day6_tui.textual_private.survival import Surviving


class DesktopTree(Surviving, FilledTree[TreeDataType]):
    """A tree without guides and without a line for its root. What opens and closes branches is the subclass's."""

    DEFAULT_CSS = """
    DesktopTree, DesktopTree:focus {
        background: transparent; background-tint: transparent 0%; border: none; padding: 0;
        width: 1fr; height: 1fr; overflow-x: hidden;
        scrollbar-size-vertical: 1; scrollbar-size-horizontal: 0;
    }
    """

    def __init__(self, look: Look) -> None:
        super().__init__("")
        self._look = look
        self.show_root = self.show_guides = self.auto_expand = False
        self.root.expand()
        self.take_look(look)

    def take_look(self, look: Look) -> None:
        """Take the colours and characters of the desktop."""
        colour_scrollbar(self, look)
        self.styles.scrollbar_size_vertical = 1 if look.glyphs.unicode else 0
        self.refresh()

    @property
    def chosen(self) -> TreeDataType | None:
        """The line the cursor is on."""
        node = self.cursor_node
        return node.data if node is not None else None

    @property
    def rich_style(self) -> Style:
        return self._look.colours.text

    def get_label_width(self, node: TreeNode[TreeDataType]) -> int:
        return 1

    def on_tree_node_selected(self, event: Tree.NodeSelected[TreeDataType]) -> None:
        event.stop()
