"""A folder of displays, `rviz_common/Group`: its check box is that of all in it (rviz_common/display_group.cpp)."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.display import Display


class GroupDisplay(Display):
    """Displays are its children, other groups among them."""

    type = "Group"

    @property
    def class_id(self) -> str:
        return "rviz_common/Group"

    @property
    def displays(self) -> list[Display]:
        """Those directly in it, in the order of the panel."""
        return [child for child in self.children if isinstance(child, Display)]

    def load(self, config: Any) -> None:
        super().load({key: value for key, value in config.items() if key != "Displays"})
        for display in self.rviz.make_displays(config.get("Displays")):
            self.add(display)

    def save(self) -> dict[str, Any]:
        named = {"Class": self.class_id, "Name": self.name, "Enabled": bool(self.value), "Value": bool(self.value)}
        return {**self.unknown, **named, "Displays": [display.save() for display in self.displays]}

    def close(self) -> None:
        for display in self.displays:
            display.close()
        super().close()

    def reset(self) -> None:
        self.clear_statuses()
