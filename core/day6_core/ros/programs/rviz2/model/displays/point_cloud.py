"""PointCloud (rviz_default_plugins/displays/pointcloud): the old message of points, each channel an array of its own."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.point_cloud2 import own_colours
from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import MOST_DRAWN, PointsDisplay


class PointCloudDisplay(PointsDisplay):
    """The original makes a PointCloud2 of it: every channel is a float32, one of another length than the points is zero."""

    type = "PointCloud"
    message_type = "sensor_msgs/msg/PointCloud"

    def show(self, message: Any) -> None:
        import numpy as np

        pose = self.place(message.header)
        if pose is None:
            return
        count = len(message.points)
        step = max(1, -(-count // MOST_DRAWN))
        self.of_all = count if step > 1 else 0
        kinds = {"x": "<f4", "y": "<f4", "z": "<f4"} | {channel.name: "<f4" for channel in message.channels}
        points = np.zeros(len(range(0, count, step)), list(kinds.items()))
        chosen = message.points[::step]
        for name in "xyz":
            points[name] = [getattr(point, name) for point in chosen]
        for channel in message.channels:
            if channel.name not in ("x", "y", "z") and len(channel.values) == count:
                points[channel.name] = np.asarray(channel.values, np.float32)[::step]
        xyz = np.stack([points[name].astype(np.float64) for name in "xyz"], axis=1)
        good = np.isfinite(xyz).all(axis=1)
        kept = points[good]
        self.take(xyz[good], pose, {name: kept[name] for name in kinds}, *own_colours(kept))
