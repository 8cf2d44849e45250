"""Path (rviz_default_plugins/displays/path)."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import COLOUR, ENUM, INT, VECTOR, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene
from day6_core.ros.programs.rviz2.model.status import ERROR
from day6_core.ros.programs.rviz2.model.topics import (
    INVALID_FLOATS,
    FilteredDisplay,
    all_finite,
    pose_numbers,
    pose_of,
)
from day6_urdf.kinematics import Transform, compose

MOST_POSES = 500
"""Poses of a path that are drawn as arrows or axes."""


class PathDisplay(FilteredDisplay):
    """The last paths as lines, with their poses if wanted."""

    type = "Path"
    message_type = "nav_msgs/msg/Path"

    def build(self) -> None:
        super().build()
        changed = self.changed
        styles = ("Lines", "Billboards")
        self.style = self.add(Property("Line Style", ENUM, "Lines", options=styles, on_change=self._switched))
        self.width = self.add(floats("Line Width", 0.03, 0.001, on_change=changed))
        self.colour = self.add(Property("Color", COLOUR, (25, 255, 0), on_change=changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.length = self.add(Property("Buffer Length", INT, 1, low=1, on_change=changed))
        self.offset = self.add(Property("Offset", VECTOR, (0.0, 0.0, 0.0), on_change=changed))
        poses = ("None", "Axes", "Arrows")
        self.pose_style = self.add(Property("Pose Style", ENUM, "None", options=poses, on_change=self._switched))
        self.axes_length = self.add(floats("Length", 0.3, on_change=changed))
        self.axes_radius = self.add(floats("Radius", 0.03, on_change=changed))
        self.pose_colour = self.add(Property("Pose Color", COLOUR, (255, 85, 255), on_change=changed))
        self.shaft_length = self.add(floats("Shaft Length", 0.1, on_change=changed))
        self.head_length = self.add(floats("Head Length", 0.2, on_change=changed))
        self.shaft_diameter = self.add(floats("Shaft Diameter", 0.1, on_change=changed))
        self.head_diameter = self.add(floats("Head Diameter", 0.3, on_change=changed))
        self._paths: list[list[Transform]] = []
        self._hide()

    def _switched(self) -> None:
        self._hide()
        self.changed()

    def _hide(self) -> None:
        self.width.hidden = self.style.value == "Lines"
        self.axes_length.hidden = self.axes_radius.hidden = self.pose_style.value != "Axes"
        arrows = (self.pose_colour, self.shaft_length, self.head_length, self.shaft_diameter, self.head_diameter)
        for each in arrows:
            each.hidden = self.pose_style.value != "Arrows"

    def reset(self) -> None:
        super().reset()
        self._paths = []

    def show(self, message: Any) -> None:
        if not all(all_finite(pose_numbers(stamped.pose)) for stamped in message.poses):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        frame = self.place(message.header)
        if frame is not None:
            self._paths.append([compose(frame, pose_of(stamped.pose)) for stamped in message.poses])

    def draw(self, scene: Scene) -> None:
        del self._paths[: -self.length.value]
        lift = Transform(self.offset.value)
        colour = rgba(self.colour, self.alpha.value)
        width = self.width.value if self.style.value == "Billboards" else 0.0
        for path in self._paths:
            ends = [pose.xyz for pair in pairwise(path) for pose in pair]
            if ends:
                scene.lines.append(Lines(ends, [colour], lift, width))
            for pose in path[:MOST_POSES] if self.pose_style.value != "None" else ():
                pose = compose(lift, pose)
                if self.pose_style.value == "Axes":
                    scene.axes(pose, self.axes_length.value, self.axes_radius.value)
                else:
                    scene.arrow(
                        pose,
                        self.shaft_length.value,
                        self.shaft_diameter.value,
                        self.head_length.value,
                        self.head_diameter.value,
                        rgba(self.pose_colour, 1.0),
                    )
