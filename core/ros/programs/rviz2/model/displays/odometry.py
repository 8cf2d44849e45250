"""Odometry (rviz_default_plugins/displays/odometry): an arrow for every step the robot took."""

from __future__ import annotations

import math
from typing import Any

from day6_tui.core.ros.programs.rviz2.model.displays.arrows import PoseShape, rgba
from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, COLOUR, ENUM, INT, Property, floats
from day6_tui.core.ros.programs.rviz2.model.scene import SPHERE, Scene, Shape
from day6_tui.core.ros.programs.rviz2.model.status import ERROR
from day6_tui.core.ros.programs.rviz2.model.topics import (
    INVALID_FLOATS,
    FilteredDisplay,
    all_finite,
    pose_numbers,
    pose_of,
)
from day6_tui.urdf.kinematics import Transform, compose

UNNORMALISED = "Message contained unnormalized quaternion (squares of values don't add to 1)"
MOST_KEPT = 5000
"""Arrows kept when `Keep` says all of them."""

_TOLERANCE = 10e-3


class OdometryDisplay(FilteredDisplay):
    """A new arrow whenever the robot moved or turned far enough; the newest place has its covariance."""

    type = "Odometry"
    message_type = "nav_msgs/msg/Odometry"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.distance = self.add(floats("Position Tolerance", 0.1, 0))
        self.angle = self.add(floats("Angle Tolerance", 0.1, 0))
        self.keep = self.add(Property("Keep", INT, 100, low=0, on_change=changed))
        self.shape = PoseShape(self.add, changed, below=True)
        self.covariance = self.add(Property("Covariance", BOOL, True, on_change=changed))
        place = self.covariance.add(Property("Position", BOOL, True, on_change=changed))
        self.ball_colour = place.add(Property("Color", COLOUR, (204, 51, 204), on_change=changed))
        self.ball_alpha = place.add(floats("Alpha", 0.3, 0, 1, on_change=changed))
        self.ball_scale = place.add(floats("Scale", 1, 0, on_change=changed))
        turn = self.covariance.add(Property("Orientation", BOOL, True, on_change=changed))
        turn.add(Property("Frame", ENUM, "Local", options=("Local", "Fixed"), on_change=changed))
        turn.add(Property("Color Style", ENUM, "Unique", options=("Unique", "RGB"), on_change=changed))
        turn.add(Property("Color", COLOUR, (255, 255, 127), on_change=changed))
        turn.add(floats("Alpha", 0.5, 0, 1, on_change=changed))
        turn.add(floats("Offset", 1, 0, on_change=changed))
        turn.add(floats("Scale", 1, 0, on_change=changed))
        self._ball = place
        self._arrows: list[Transform] = []
        self._last: Any = None
        self._spread: tuple[float, float, float] | None = None

    def reset(self) -> None:
        super().reset()
        self._arrows, self._last, self._spread = [], None, None

    def show(self, message: Any) -> None:
        pose = message.pose.pose
        if not all_finite(pose_numbers(pose)):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        turn = pose.orientation
        if abs(turn.x**2 + turn.y**2 + turn.z**2 + turn.w**2 - 1) > _TOLERANCE:
            self.put_status(ERROR, "Topic", UNNORMALISED)
            return
        if self._last is not None and not self._far_enough(pose, self._last):
            return
        frame = self.place(message.header)
        if frame is None:
            return
        self._last = pose
        self._arrows.append(compose(frame, pose_of(pose)))
        spread = [message.pose.covariance[index] for index in (0, 7, 14)]
        good = all_finite(spread) and max(spread) > 0 and min(spread) >= 0
        self._spread = tuple(map(math.sqrt, spread)) if good else None  # type: ignore[assignment]

    def _far_enough(self, new: Any, old: Any) -> bool:
        a, b = new.position, old.position
        moved = math.dist((a.x, a.y, a.z), (b.x, b.y, b.z))
        p, q = new.orientation, old.orientation
        cosine = abs(p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w)
        turned = 2 * math.acos(min(1.0, cosine))
        far: bool = moved >= self.distance.value or turned >= self.angle.value
        return far

    def draw(self, scene: Scene) -> None:
        keep = self.keep.value or MOST_KEPT
        del self._arrows[:-keep]
        for pose in self._arrows:
            self.shape.draw(scene, pose)
        if self._arrows and self._spread is not None and self.covariance.value and self._ball.value:
            # Two standard deviations, at least a tenth of a millimetre thick.
            size = tuple(max(1e-4, 2 * self.ball_scale.value * part) for part in self._spread)
            scene.shapes.append(Shape(SPHERE, self._arrows[-1], size, rgba(self.ball_colour, self.ball_alpha.value)))
