"""Move Camera and Interact: the mouse moves the view (rviz_default_plugins/tools/move, interaction)."""

from __future__ import annotations

from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_tui.core.ros.programs.rviz2.model.tools.tool import Tool


class MoveCamera(Tool):
    """The view's own rules for the mouse."""

    type, title, short, key = "MoveCamera", "Move Camera", "Move", "m"

    @property
    def status(self) -> str:
        return self.rviz.view.help


class Interact(Tool):
    """Interactive markers take the mouse where they are; elsewhere it moves the view."""

    type, title, short, key = "Interact", "Interact", "Interact", "i"

    def build(self) -> None:
        self.hide = self.add(Property("Hide Inactive Objects", BOOL, True))

    @property
    def status(self) -> str:
        return self.rviz.view.help
