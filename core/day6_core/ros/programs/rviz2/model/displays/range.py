"""Range (rviz_default_plugins/displays/range): the cone in which a sonar or an infrared sensor found something."""

from __future__ import annotations

import math
from typing import Any

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import COLOUR, INT, Property, floats
from day6_core.ros.programs.rviz2.model.scene import CONE, Scene, Shape
from day6_core.ros.programs.rviz2.model.topics import FilteredDisplay
from day6_urdf.kinematics import Transform, compose
from day6_urdf.model import Quaternion

_HALF = 0.5**0.5
TIP_BACK: Quaternion = (0.0, -_HALF, 0.0, _HALF)
"""Turns the z axis onto -x: the tip of the cone is at the sensor, its foot at what was measured."""


class RangeDisplay(FilteredDisplay):
    """The last measurements, each as a cone along the x axis of its sensor."""

    type = "Range"
    message_type = "sensor_msgs/msg/Range"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.colour = self.add(Property("Color", COLOUR, (255, 255, 255), on_change=changed))
        self.alpha = self.add(floats("Alpha", 0.5, 0, 1, on_change=changed))
        self.length = self.add(Property("Buffer Length", INT, 1, low=1, on_change=changed))
        self._cones: list[tuple[Transform, float, float]] = []
        """Place, diameter of the foot and height of each."""

    def reset(self) -> None:
        super().reset()
        self._cones = []

    def show(self, message: Any) -> None:
        frame = self.place(message.header)
        if frame is None:
            return
        height = displayed_range(message)
        diameter = (
            abs(2 * height * math.tan(message.field_of_view / 2)) if math.isfinite(message.field_of_view) else 0.0
        )
        middle = compose(frame, Transform((height / 2, 0.0, 0.0), TIP_BACK))
        self._cones.append((middle, diameter, height))

    def draw(self, scene: Scene) -> None:
        del self._cones[: -self.length.value]
        colour = rgba(self.colour, self.alpha.value)
        for middle, diameter, height in self._cones:
            if height > 0 and diameter > 0:
                scene.shapes.append(Shape(CONE, middle, (diameter, diameter, height), colour))


def displayed_range(message: Any) -> float:
    """The height of a message's cone in metres, 0 if nothing was found (range_display.cpp, getDisplayedRange)."""
    measured: float = message.range
    if message.min_range <= measured <= message.max_range:
        return measured if math.isfinite(measured) else 0.0
    if message.min_range == message.max_range and measured == -math.inf:
        # A sensor of one fixed distance says -Inf for "something is there" (sensor_msgs/Range).
        return float(message.min_range)
    return 0.0
