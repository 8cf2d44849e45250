"""LaserScan (rviz_default_plugins/displays/laser_scan): every ray that hit something is a point."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import PointsDisplay
from day6_core.ros.programs.rviz2.model.status import WARN


class LaserScanDisplay(PointsDisplay):
    """Points in the frame of the scanner."""

    type = "LaserScan"
    message_type = "sensor_msgs/msg/LaserScan"

    def build(self) -> None:
        self._longest = 0.0
        super().build()

    def reset(self) -> None:
        super().reset()
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
        channels = {}
        if len(message.intensities) == len(ranges):
            channels["intensity"] = np.asarray(message.intensities, np.float64)[good]
        self.take(flat[np.isfinite(flat).all(axis=1)], pose, channels, None, ())
