"""CameraInfo (rviz_default_plugins/displays/camera_info): the pyramid that a camera sees, by its calibration."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_core.ros.programs.rviz2.model.properties import BOOL, COLOUR, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene, Triangles
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN
from day6_core.ros.programs.rviz2.model.topics import FilteredDisplay
from day6_urdf.kinematics import Transform
from day6_urdf.model import Vector

CAMERA_INFO = "Camera Info"
EDGE_WIDTH = 0.01
TOP: Vector = (0.0, 0.0, 0.0)


class CameraInfoDisplay(FilteredDisplay):
    """Edges, and sides if they are wanted, from the camera to the far clip distance."""

    type = "CameraInfo"
    message_type = "sensor_msgs/msg/CameraInfo"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.far = self.add(floats("Far clip", 1, on_change=changed))
        self.edges = self.add(Property("Show edges", BOOL, True, on_change=changed))
        self.polygons = self.add(Property("Show polygons", BOOL, True, on_change=self._switched))
        self.no_sides = self.add(Property("Not show side polygons", BOOL, True, on_change=changed))
        self.colour = self.add(Property("Color", COLOUR, (85, 255, 255), on_change=changed))
        self.edge_colour = self.add(Property("Edge color", COLOUR, (125, 125, 125), on_change=changed))
        self.alpha = self.add(floats("Alpha", 0.5, on_change=changed))
        self._corners: list[Vector] = []
        """Of the picture, at depth 1; none of a calibration that is none."""
        self._pose = Transform(TOP)

    def _switched(self) -> None:
        self.no_sides.hidden = not self.polygons.value
        self.changed()

    def reset(self) -> None:
        super().reset()
        self._corners = []

    def show(self, message: Any) -> None:
        fx, fy, cx, cy = message.p[0], message.p[5], message.p[2], message.p[6]
        if fx == 0 or fy == 0:
            self._corners = []
            self.put_status(ERROR, CAMERA_INFO, "Invalid intrinsic matrix")
            return
        self.put_status(OK, CAMERA_INFO, "OK")
        width = (message.roi.width or message.width) // max(1, message.binning_x)
        height = (message.roi.height or message.height) // max(1, message.binning_y)
        self._corners = [
            ((x - cx - message.p[3]) / fx, (y - cy - message.p[7]) / fy, 1.0)
            for x, y in ((0, 0), (width, 0), (width, height), (0, height))
        ]
        pose = self.place(message.header)
        if pose is not None:
            self._pose = pose
        else:
            frame, fixed = message.header.frame_id, self.rviz.fixed_frame
            text = f"Error transforming pose '{self.name}' from frame '{frame}' to frame '{fixed}'"
            self.put_status(WARN, CAMERA_INFO, text)

    def draw(self, scene: Scene) -> None:
        if not self._corners:
            return
        import numpy as np

        far, alpha = self.far.value, self.alpha.value
        corners = [(x * far, y * far, far) for x, y, _ in self._corners]
        if self.polygons.value and not self.no_sides.value:
            faces = np.array([(0, 2, 1), (0, 3, 2), (0, 4, 3), (0, 1, 4)])
            vertices = np.array([TOP, *corners])
            colour = rgba(self.colour, alpha)
            scene.triangles.append(Triangles(vertices, faces, self._pose, (1.0, 1.0, 1.0), colour, lit=False))
        if self.edges.value:
            ends = [
                end for index in range(4) for end in (TOP, corners[index], corners[index], corners[(index + 1) % 4])
            ]
            scene.lines.append(Lines(ends, [rgba(self.edge_colour, alpha)], self._pose, EDGE_WIDTH))
