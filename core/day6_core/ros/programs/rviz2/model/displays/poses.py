"""Pose, PoseArray and PointStamped (rviz_default_plugins/displays/pose, pose_array, point)."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.arrows import PoseShape, rgba
from day6_core.ros.programs.rviz2.model.displays.covariance import Covariance, Spread, spread_of
from day6_core.ros.programs.rviz2.model.properties import (
    COLOUR,
    ENUM,
    INT,
    TEXT,
    VECTOR,
    Property,
    floats,
    pose_lines,
)
from day6_core.ros.programs.rviz2.model.scene import SPHERE, Lines, Scene, Shape, placed
from day6_core.ros.programs.rviz2.model.status import ERROR
from day6_core.ros.programs.rviz2.model.topics import (
    INVALID_FLOATS,
    FilteredDisplay,
    all_finite,
    pose_numbers,
    pose_of,
)
from day6_urdf.kinematics import IDENTITY, Transform, compose
from day6_urdf.model import Vector

MOST_POSES = 2000
"""Of a pose array: particle filters send thousands, of which nobody sees each."""


class PoseDisplay(FilteredDisplay):
    """The newest pose, as an arrow or as axes."""

    type = "Pose"
    selectable = True
    message_type = "geometry_msgs/msg/PoseStamped"

    def build(self) -> None:
        super().build()
        self.shape = PoseShape(self.add, self.changed, below=False)
        self._pose: Transform | None = None
        self._message: Any = None

    def reset(self) -> None:
        super().reset()
        self._pose = self._message = None

    def show(self, message: Any) -> None:
        if not all_finite(pose_numbers(message.pose)):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        frame = self.place(message.header)
        if frame is not None:
            self._pose = compose(frame, pose_of(message.pose))
            self._message = message

    def describe(self, key: str) -> tuple[str, list[Property]] | None:
        if self._message is None:
            return None
        frame = Property("Frame", TEXT, self._message.header.frame_id, read_only=True)
        numbers = pose_numbers(self._message.pose)
        return f"Pose {self.name}", [frame, *pose_lines(numbers[:3], numbers[3:])]

    def draw(self, scene: Scene) -> None:
        if self._pose is not None:
            self.shape.draw(scene, self._pose)


class PoseWithCovarianceDisplay(FilteredDisplay):
    """The newest pose with its covariance."""

    type = "PoseWithCovariance"
    message_type = "geometry_msgs/msg/PoseWithCovarianceStamped"
    selectable = True

    def build(self) -> None:
        super().build()
        self.shape = PoseShape(self.add, self.changed, below=False)
        self.covariance = Covariance(self.add, self.changed)
        self._pose: Transform | None = None
        self._frame = IDENTITY
        """That of the newest message's header."""
        self._spread: Spread | None = None
        self._message: Any = None

    def reset(self) -> None:
        super().reset()
        self._pose = self._message = self._spread = None

    def show(self, message: Any) -> None:
        if not all_finite([*pose_numbers(message.pose.pose), *message.pose.covariance]):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        frame = self.place(message.header)
        if frame is not None:
            self._pose, self._message = compose(frame, pose_of(message.pose.pose)), message
            self._frame, self._spread = frame, spread_of(message.pose.covariance)

    def describe(self, key: str) -> tuple[str, list[Property]] | None:
        if self._message is None:
            return None
        frame = Property("Frame", TEXT, self._message.header.frame_id, read_only=True)
        numbers, spread = pose_numbers(self._message.pose.pose), self._message.pose.covariance
        variances = [
            Property(f"Covariance {name}", VECTOR, tuple(float(spread[7 * index]) for index in indices), read_only=True)
            for name, indices in (("Position", range(3)), ("Orientation", range(3, 6)))
        ]
        return f"Pose {self.name}", [frame, *pose_lines(numbers[:3], numbers[3:]), *variances]

    def draw(self, scene: Scene) -> None:
        if self._pose is not None:
            self.shape.draw(scene, self._pose)
            self.covariance.draw(scene, self._spread, self._pose, self._frame.rotation)


class PoseArrayDisplay(FilteredDisplay):
    """Many poses: flat arrows, solid arrows or axes."""

    type = "PoseArray"
    message_type = "geometry_msgs/msg/PoseArray"

    FLAT, SOLID, AXES = "Arrow (Flat)", "Arrow (3D)", "Axes"

    def build(self) -> None:
        super().build()
        changed = self.changed
        shapes = (self.FLAT, self.SOLID, self.AXES)
        self.shape = self.add(Property("Shape", ENUM, self.FLAT, options=shapes, on_change=self._switched))
        self.colour = self.add(Property("Color", COLOUR, (255, 25, 0), on_change=changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.flat_length = self.add(floats("Arrow Length", 0.3, on_change=changed))
        self.head_radius = self.add(floats("Head Radius", 0.03, on_change=changed))
        self.head_length = self.add(floats("Head Length", 0.07, on_change=changed))
        self.shaft_radius = self.add(floats("Shaft Radius", 0.01, on_change=changed))
        self.shaft_length = self.add(floats("Shaft Length", 0.23, on_change=changed))
        self.axes_length = self.add(floats("Axes Length", 0.3, on_change=changed))
        self.axes_radius = self.add(floats("Axes Radius", 0.01, on_change=changed))
        self._poses: list[Transform] = []
        self._hide()

    def _switched(self) -> None:
        self._hide()
        self.changed()

    def _hide(self) -> None:
        shape = self.shape.value
        self.flat_length.hidden = shape != self.FLAT
        for each in (self.head_radius, self.head_length, self.shaft_radius, self.shaft_length):
            each.hidden = shape != self.SOLID
        self.axes_length.hidden = self.axes_radius.hidden = shape != self.AXES
        self.colour.hidden = shape == self.AXES

    def reset(self) -> None:
        super().reset()
        self._poses = []

    def show(self, message: Any) -> None:
        poses = message.poses[:MOST_POSES]
        if not all(all_finite(pose_numbers(pose)) for pose in poses):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        frame = self.place(message.header)
        if frame is not None:
            self._poses = [compose(frame, pose_of(pose)) for pose in poses]

    def draw(self, scene: Scene) -> None:
        colour = rgba(self.colour, self.alpha.value)
        if self.shape.value == self.FLAT:
            length = self.flat_length.value
            # Two strokes of the original's flat arrow: the shaft and both barbs, in the x-y plane of the pose.
            ends: list[Vector] = []
            for pose in self._poses:
                tip = placed(pose, (length, 0.0, 0.0))
                ends += [pose.xyz, tip]
                for side in (-0.2, 0.2):
                    ends += [tip, placed(pose, (0.75 * length, side * length, 0.0))]
            if ends:
                scene.lines.append(Lines(ends, [colour]))
            return
        for pose in self._poses:
            if self.shape.value == self.AXES:
                scene.axes(pose, self.axes_length.value, self.axes_radius.value, self.alpha.value)
            else:
                head, shaft = 2 * self.head_radius.value, 2 * self.shaft_radius.value
                scene.arrow(pose, self.shaft_length.value, shaft, self.head_length.value, head, colour)


class PointStampedDisplay(FilteredDisplay):
    """The last points, as balls."""

    type = "PointStamped"
    message_type = "geometry_msgs/msg/PointStamped"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.colour = self.add(Property("Color", COLOUR, (204, 41, 204), on_change=changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.radius = self.add(floats("Radius", 0.2, on_change=changed))
        self.history = self.add(Property("History Length", INT, 1, low=1, high=100000, on_change=changed))
        self._points: list[Vector] = []

    def reset(self) -> None:
        super().reset()
        self._points = []

    def show(self, message: Any) -> None:
        point = (message.point.x, message.point.y, message.point.z)
        if not all_finite(point):
            self.put_status(ERROR, "Topic", INVALID_FLOATS)
            return
        frame = self.place(message.header)
        if frame is not None:
            self._points.append(placed(frame, point))

    def draw(self, scene: Scene) -> None:
        del self._points[: -self.history.value]
        size = (2 * self.radius.value,) * 3
        for point in self._points[-1000:]:
            scene.shapes.append(Shape(SPHERE, Transform(point), size, rgba(self.colour, self.alpha.value)))
