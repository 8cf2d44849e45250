"""Odometry (rviz_default_plugins/displays/odometry): an arrow for every step the robot took."""

from __future__ import annotations

import math
from typing import Any

from day6_core.ros.programs.rviz2.model.displays.arrows import PoseShape
from day6_core.ros.programs.rviz2.model.displays.covariance import Covariance, Spread, spread_of
from day6_core.ros.programs.rviz2.model.properties import INT, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Scene
from day6_core.ros.programs.rviz2.model.status import ERROR
from day6_core.ros.programs.rviz2.model.topics import (
    INVALID_FLOATS,
    FilteredDisplay,
    all_finite,
    pose_numbers,
    pose_of,
)
from day6_urdf.kinematics import Transform, compose
from day6_urdf.model import Quaternion

UNNORMALISED = "Message contained unnormalized quaternion (squares of values don't add to 1)"
MOST_KEPT = 5000
"""Arrows kept when `Keep` says all of them."""

MOST_SPREADS = 25
"""Covariances drawn, the newest ones: each is see-through, and a hundred take ten times as long to paint as all else."""

_TOLERANCE = 10e-3


class OdometryDisplay(FilteredDisplay):
    """A new arrow with its covariance whenever the robot moved or turned far enough."""

    type = "Odometry"
    message_type = "nav_msgs/msg/Odometry"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.distance = self.add(floats("Position Tolerance", 0.1, 0))
        self.angle = self.add(floats("Angle Tolerance", 0.1, 0))
        self.keep = self.add(Property("Keep", INT, 100, low=0, on_change=changed))
        self.shape = PoseShape(self.add, changed, below=True)
        self.covariance = Covariance(self.add, changed)
        self._arrows: list[tuple[Transform, Spread | None, Quaternion]] = []
        """Poses in the Fixed Frame, their covariances, and how the frames are turned that these were given in."""
        self._last: Any = None

    def reset(self) -> None:
        super().reset()
        self._arrows, self._last = [], None

    def show(self, message: Any) -> None:
        pose = message.pose.pose
        if not all_finite([*pose_numbers(pose), *message.pose.covariance]):
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
        self._arrows.append((compose(frame, pose_of(pose)), spread_of(message.pose.covariance), frame.rotation))

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
        for pose, _, _ in self._arrows:
            self.shape.draw(scene, pose)
        for pose, spread, frame in self._arrows[-MOST_SPREADS:]:
            self.covariance.draw(scene, spread, pose, frame)
