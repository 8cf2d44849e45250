"""Group (rviz_common/display_group.cpp): a folder of displays, of which its check box switches all."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.display import Display


class GroupDisplay(Display):
    """Its displays are below it, may be groups themselves, and have their own check boxes, which they keep."""

    type = "Group"

    @property
    def class_id(self) -> str:
        return "rviz_common/Group"

    def close(self) -> None:
        for display in self.displays:
            display.close()
        super().close()

    def save(self) -> dict[str, Any]:
        saved = super().save()
        del saved["Value"]  # the original writes it beside properties only, and a group has none
        return saved

    def save_extras(self) -> dict[str, Any]:
        return {"Displays": [display.save() for display in self.displays] or None}

    def load_extras(self, config: dict[str, Any]) -> None:
        for display in self.displays:
            display.close()
            self.remove(display)
        for display in self.rviz.make_displays(config.get("Displays")):
            self.add(display)
