"""Move Camera: the mouse moves the view (rviz_default_plugins/tools/move)."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.tools.tool import Tool


class MoveCamera(Tool):
    """The view's own rules for the mouse."""

    type, title, short, key = "MoveCamera", "Move Camera", "Move", "m"

    @property
    def status(self) -> str:
        return self.rviz.view.help
