"""LaserScan (rviz_default_plugins/displays/laser_scan and …/pointcloud): every ray that hit something is a point."""

from __future__ import annotations

import colorsys
import math
from collections import deque
from typing import Any

from day6_tui.core.ros.programs.rviz2.model.displays.arrows import rgba
from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, COLOUR, ENUM, TEXT, Property, floats
from day6_tui.core.ros.programs.rviz2.model.scene import Points, Scene
from day6_tui.core.ros.programs.rviz2.model.status import OK, WARN
from day6_tui.core.ros.programs.rviz2.model.topics import FilteredDisplay
from day6_tui.urdf.kinematics import Transform

STYLES = ("Points", "Squares", "Flat Squares", "Spheres", "Boxes", "Tiles")
INTENSITY, AXIS, FLAT = "Intensity", "AxisColor", "FlatColor"
MOST_SCANS = 1000


class LaserScanDisplay(FilteredDisplay):
    """Points in the frame of the scanner, coloured by intensity, by height, or all alike."""

    type = "LaserScan"
    message_type = "sensor_msgs/msg/LaserScan"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.selectable = self.add(Property("Selectable", BOOL, True, on_change=changed))
        self.style = self.add(Property("Style", ENUM, "Flat Squares", options=STYLES, on_change=self._switched))
        self.size = self.add(floats("Size (m)", 0.01, 0.0001, on_change=changed))
        self.pixels = self.add(floats("Size (Pixels)", 3, 1, on_change=changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.decay = self.add(floats("Decay Time", 0, 0, on_change=changed))
        self.add(Property("Position Transformer", ENUM, "XYZ", options=("XYZ",), on_change=changed))
        colours = (INTENSITY, AXIS, FLAT)
        self.how = self.add(Property("Color Transformer", ENUM, INTENSITY, options=colours, on_change=self._switched))
        self.channel = self.add(Property("Channel Name", TEXT, "intensity", on_change=changed))
        self.rainbow = self.add(Property("Use rainbow", BOOL, True, on_change=changed))
        self.invert = self.add(Property("Invert Rainbow", BOOL, False, on_change=changed))
        self.low_colour = self.add(Property("Min Color", COLOUR, (0, 0, 0), on_change=changed))
        self.high_colour = self.add(Property("Max Color", COLOUR, (255, 255, 255), on_change=changed))
        self.auto = self.add(Property("Autocompute Intensity Bounds", BOOL, True, on_change=changed))
        self.least = self.add(floats("Min Intensity", 0, on_change=changed))
        self.most = self.add(floats("Max Intensity", 4096, on_change=changed))
        self.axis = self.add(Property("Axis", ENUM, "Z", options=("X", "Y", "Z"), on_change=changed))
        self.colour = self.add(Property("Color", COLOUR, (255, 255, 255), on_change=changed))
        self._scans: deque[tuple[int, Any, Any]] = deque(maxlen=MOST_SCANS)
        self._longest = 0.0
        self._drawn: tuple[Any, ...] = ()
        self._points: list[Points] = []
        self._hide()

    def _switched(self) -> None:
        self._hide()
        self.changed()

    def _hide(self) -> None:
        self.size.hidden, self.pixels.hidden = self.style.value == "Points", self.style.value != "Points"
        how = self.how.value
        for each in (self.channel, self.rainbow, self.invert, self.auto, self.least, self.most):
            each.hidden = how != INTENSITY
        self.low_colour.hidden = self.high_colour.hidden = how != INTENSITY
        self.axis.hidden, self.colour.hidden = how != AXIS, how != FLAT

    def reset(self) -> None:
        super().reset()
        self._scans.clear()
        self._drawn = ()
        self._warn_of_long_scans()

    def _warn_of_long_scans(self) -> None:
        if self._longest >= 2:  # compared in whole seconds, as the original does
            self.put_status(
                WARN,
                "Scan Time",
                "Laser scan time, computed from time_increment * len(ranges), is rather large: "
                f" {int(self._longest)}s.\nThe display of any message will be delayed by this amount of time!",
            )

    def show(self, message: Any) -> None:
        import numpy as np

        took = (len(message.ranges) - 1) * message.time_increment
        if took > self._longest:
            self._longest = took
            self._warn_of_long_scans()
        pose = self.place(message.header)
        if pose is None:
            return
        ranges = np.asarray(message.ranges, np.float64)
        angles = message.angle_min + np.arange(len(ranges)) * message.angle_increment
        good = np.isfinite(ranges) & (ranges >= message.range_min) & (ranges <= message.range_max)
        flat = np.stack([ranges * np.cos(angles), ranges * np.sin(angles), np.zeros(len(ranges))], axis=1)[good]
        intensities = np.asarray(message.intensities, np.float64)
        intensities = intensities[good] if len(intensities) == len(ranges) else np.zeros(len(flat))
        self._scans.append((self.rviz.now_ns(), _moved(flat, pose), intensities))
        shown = sum(len(points) for _, points, _ in self._scans) if self.decay.value else len(flat)
        self.put_status(
            OK, "Points", f"Showing [{shown}] points from [{len(self._scans) if self.decay.value else 1}] messages"
        )

    @property
    def fading(self) -> bool:
        """Old points vanish by time alone."""
        return bool(self.decay.value) and len(self._scans) > 1

    def draw(self, scene: Scene) -> None:
        if not self._scans:
            return
        oldest = self.rviz.now_ns() - int(self.decay.value * 1e9)
        while len(self._scans) > 1 and self._scans[0][0] < oldest:
            self._scans.popleft()
        colours = tuple(each.value for each in self.children[1:] if each is not self.statuses)
        wanted = (self._scans[-1][1], len(self._scans), colours)
        if not self._drawn or wanted[0] is not self._drawn[0] or wanted[1:] != self._drawn[1:]:
            self._drawn = wanted
            size = 0.0 if self.style.value == "Points" else self.size.value
            self._points = [Points(points, self._colours(points, bright), size) for _, points, bright in self._scans]
        scene.points += self._points

    def _colours(self, points: Any, intensities: Any) -> Any:
        import numpy as np

        alpha = self.alpha.value
        if self.how.value == FLAT or not len(points):
            return np.array([rgba(self.colour, alpha)])
        if self.how.value == AXIS:
            values = points[:, "XYZ".index(self.axis.value)]
            low, high = float(values.min()), float(values.max())
        else:
            values = intensities
            low, high = (
                (float(values.min()), float(values.max())) if self.auto.value else (self.least.value, self.most.value)
            )
        part = np.clip((values - low) / (high - low), 0, 1) if high > low else np.ones(len(values))
        if self.how.value == INTENSITY and not self.rainbow.value:
            a, b = np.array(rgba(self.low_colour, alpha)), np.array(rgba(self.high_colour, alpha))
            return a + (b - a) * part[:, None]
        if self.invert.value:
            part = 1 - part
        table = np.array([(*_rainbow(step / 31), alpha) for step in range(32)])
        return table[np.round(part * 31).astype(int)]


def _rainbow(part: float) -> tuple[float, float, float]:
    """From red through green to violet, the low end being violet (point_cloud_helpers)."""
    return colorsys.hsv_to_rgb((1 - part) * 5 / 6, 1.0, 1.0)


def _moved(points: Any, pose: Transform) -> Any:
    import numpy as np

    from day6_tui.core.ros.programs.rviz2.model.turning import matrix

    moved = points @ np.array(matrix(pose.rotation)).T + np.array(pose.xyz)
    return moved if math.isfinite(float(moved.sum())) else moved[np.isfinite(moved).all(axis=1)]
