"""Converts laser scans to point clouds in the laser's frame (the Python part of laser_geometry 2.7)."""

from __future__ import annotations

from typing import Any

import numpy as np
from sensor_msgs.msg import LaserScan, PointCloud2, PointField
from sensor_msgs_py.point_cloud2 import create_cloud


class LaserProjection:
    """Converts scans to clouds; readings outside of the scan's range are left out."""

    LASER_SCAN_INVALID = -1.0
    LASER_SCAN_MIN_RANGE = -2.0
    LASER_SCAN_MAX_RANGE = -3.0

    class ChannelOption:
        """Flags for the fields of a point besides x, y and z."""

        NONE = 0x00
        INTENSITY = 0x01
        INDEX = 0x02
        DISTANCE = 0x04
        TIMESTAMP = 0x08
        VIEWPOINT = 0x10
        DEFAULT = INTENSITY | INDEX

    def projectLaser(
        self, scan_in: LaserScan, range_cutoff: float = -1.0, channel_options: int = ChannelOption.DEFAULT
    ) -> PointCloud2:
        """Return the cloud of a scan. `range_cutoff` (metres) reduces the scan's own `range_max`.

        The fields are x, y, z and, by `channel_options`, intensity, index, distances, stamps (seconds since the scan began),
        vp_x …
        """
        option = self.ChannelOption
        ranges = np.array(scan_in.ranges)
        angles = scan_in.angle_min + np.arange(len(ranges)) * scan_in.angle_increment
        nothing = np.zeros(len(ranges))
        columns: list[tuple[str, int, Any]] = [
            (name, PointField.FLOAT32, values)
            for name, values in (("x", ranges * np.cos(angles)), ("y", ranges * np.sin(angles)), ("z", nothing))
        ]
        if channel_options & option.INTENSITY and len(scan_in.intensities) > 0:
            columns.append(("intensity", PointField.FLOAT32, scan_in.intensities))
        if channel_options & option.INDEX:
            columns.append(("index", PointField.INT32, range(len(ranges))))
        if channel_options & option.DISTANCE:
            columns.append(("distances", PointField.FLOAT32, ranges))
        if channel_options & option.TIMESTAMP:
            columns.append(("stamps", PointField.FLOAT32, np.arange(len(ranges)) * scan_in.time_increment))
        if channel_options & option.VIEWPOINT:
            columns += [(name, PointField.FLOAT32, nothing) for name in ("vp_x", "vp_y", "vp_z")]
        farthest = scan_in.range_max if range_cutoff < 0 else min(range_cutoff, scan_in.range_max)
        wanted = np.flatnonzero((ranges < farthest) & (ranges >= scan_in.range_min))
        fields = [
            PointField(name=name, offset=4 * number, datatype=kind, count=1)
            for number, (name, kind, _) in enumerate(columns)
        ]
        points = [tuple(values[index] for _, _, values in columns) for index in wanted.tolist()]
        return create_cloud(scan_in.header, fields, points)
