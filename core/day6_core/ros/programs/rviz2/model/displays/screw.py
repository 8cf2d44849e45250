"""Wrench, AccelStamped and TwistStamped: an arrow for what is along, one for what is around (…/displays/wrench, screw)."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import BOOL, COLOUR, INT, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene, placed, pointing
from day6_core.ros.programs.rviz2.model.status import ERROR
from day6_core.ros.programs.rviz2.model.topics import INVALID_FLOATS, FilteredDisplay, all_finite
from day6_urdf.kinematics import Transform, compose
from day6_urdf.model import Vector

ORIGIN: Vector = (0.0, 0.0, 0.0)
CIRCLE = range(4, 33)
"""Of 32 parts of a circle those that show the direction of rotation (wrench_visual.cpp)."""


class _TwoVectors(FilteredDisplay):
    """`along` and `around` are the words of the properties, `route` leads to the vectors in a message."""

    along, around = "Linear", "Angular"
    route: tuple[str, str, str] = ("", "linear", "angular")

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.first_lines()
        self.along_colour = self.add(Property(f"{self.along} Color", COLOUR, (204, 51, 51), on_change=changed))
        self.around_colour = self.add(Property(f"{self.around} Color", COLOUR, (204, 204, 51), on_change=changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.along_scale = self.add(floats(f"{self.along} Arrow Scale", 2, on_change=changed))
        self.around_scale = self.add(floats(f"{self.around} Arrow Scale", 2, on_change=changed))
        self.width = self.add(floats("Arrow Width", 0.5, on_change=changed))
        self.history = self.add(Property("History Length", INT, 1, low=1, high=100000, on_change=changed))
        self.last_lines()
        self._shown: list[tuple[Transform, Vector, Vector]] = []

    def first_lines(self) -> None:
        """Properties above the common ones."""

    def last_lines(self) -> None:
        """Properties below them."""

    def reset(self) -> None:
        super().reset()
        self._shown = []

    def accepted(self, numbers: list[float]) -> list[float]:
        """The numbers as they are shown."""
        return numbers

    @property
    def hides_small(self) -> bool:
        """Whether arrows shorter than wide are left out."""
        return True

    def show(self, message: Any) -> None:
        part, along, around = (getattr(message, self.route[0]), *self.route[1:])
        vectors = (getattr(part, along), getattr(part, around))
        numbers = self.accepted([number for vector in vectors for number in (vector.x, vector.y, vector.z)])
        if not all_finite(numbers):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        frame = self.place(message.header)
        if frame is not None:
            one, two = tuple(numbers[:3]), tuple(numbers[3:])
            self._shown.append((frame, one, two))  # type: ignore[arg-type]

    def draw(self, scene: Scene) -> None:
        del self._shown[: -self.history.value]
        for frame, along, around in self._shown[-1000:]:
            self._arrow(scene, frame, along, self.along_scale.value, self.along_colour)
            length = self._arrow(scene, frame, around, self.around_scale.value, self.around_colour)
            if length:
                self._circle(scene, compose(frame, pointing(ORIGIN, around)), length)

    def _arrow(self, scene: Scene, frame: Transform, vector: Vector, scale: float, colour: Property) -> float:
        """Draw one arrow; returns its length, 0 for one that is left out."""
        length, width = math.hypot(*vector) * scale, self.width.value
        if length == 0 or (self.hides_small and length <= width):
            return 0.0
        pose = compose(frame, pointing(ORIGIN, vector))
        scene.arrow(pose, length, 0.1 * width, 0.3 * length, 0.2 * width, rgba(colour, self.alpha.value))
        return length

    def _circle(self, scene: Scene, along: Transform, length: float) -> None:
        points = [
            placed(
                along,
                (
                    length / 2,
                    length / 4 * math.cos(number * math.tau / 32),
                    length / 4 * math.sin(number * math.tau / 32),
                ),
            )
            for number in CIRCLE
        ]
        ends = [point for pair in pairwise(points) for point in pair]
        colour, width = rgba(self.around_colour, self.alpha.value), self.width.value
        scene.lines.append(Lines(ends, [colour]))
        # The circle's own head, where it ends.
        end = (length / 2, length / 4, 0.0)
        head = compose(along, pointing(end, (end[0], end[1], 1.0)))
        scene.arrow(head, 0.0, 0.1 * width, 0.1 * width, 0.2 * width, colour)


class WrenchDisplay(_TwoVectors):
    """Force and torque."""

    type = "Wrench"
    message_type = "geometry_msgs/msg/WrenchStamped"
    along, around = "Force", "Torque"
    route = ("wrench", "force", "torque")

    def first_lines(self) -> None:
        self.accepts_nan = self.add(Property("Accept NaN Values", BOOL, False, on_change=self.changed))

    def accepted(self, numbers: list[float]) -> list[float]:
        return [0.0 if math.isnan(number) else number for number in numbers] if self.accepts_nan.value else numbers


class _ScrewDisplay(_TwoVectors):
    def last_lines(self) -> None:
        self.hide_small = self.add(Property("Hide Small Values", BOOL, True, on_change=self.changed))

    @property
    def hides_small(self) -> bool:
        return bool(self.hide_small.value)


class AccelStampedDisplay(_ScrewDisplay):
    """Linear and angular acceleration."""

    type = "AccelStamped"
    message_type = "geometry_msgs/msg/AccelStamped"
    route = ("accel", "linear", "angular")


class TwistStampedDisplay(_ScrewDisplay):
    """Linear and angular velocity."""

    type = "TwistStamped"
    message_type = "geometry_msgs/msg/TwistStamped"
    route = ("twist", "linear", "angular")
