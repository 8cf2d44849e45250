"""Axes (rviz_default_plugins/displays/axes)."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.properties import FIXED_FRAME, FRAME, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Scene
from day6_core.ros.programs.rviz2.model.status import ERROR, OK


class AxesDisplay(Display):
    """The axes of one frame."""

    type = "Axes"

    def build(self) -> None:
        changed = self.changed
        choices = self.rviz.frame_choices
        self.frame = self.add(Property("Reference Frame", FRAME, FIXED_FRAME, options=choices, on_change=changed))
        self.length = self.add(floats("Length", 1, 0.0001, on_change=changed))
        self.radius = self.add(floats("Radius", 0.1, 0.0001, on_change=changed))

    def refresh(self) -> None:
        if self.rviz.frames.pose(self.frame.value) is not None:
            self.put_status(OK, "Transform", "Transform OK")
        elif problem := self.rviz.frames.transform_problem(self.frame.value):
            self.put_status(ERROR, "Transform", problem)
        else:
            self.transform_missing(self.frame.value)

    def draw(self, scene: Scene) -> None:
        pose = self.rviz.frames.pose(self.frame.value)
        if pose is not None:
            scene.axes(pose, self.length.value, self.radius.value)
