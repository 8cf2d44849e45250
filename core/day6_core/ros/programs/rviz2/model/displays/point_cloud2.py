"""PointCloud2 (rviz_default_plugins/displays/pointcloud): the points of a depth camera or a 3-D lidar."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import (
    MOST_DRAWN,
    RGB8,
    RGBF32,
    PointsDisplay,
)
from day6_core.ros.programs.rviz2.model.status import ERROR

_FLOAT32 = 7
_FORMATS = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", _FLOAT32: "f4", 8: "f8"}
"""sensor_msgs/PointField's datatypes."""
_PACKED = ("i4", "u4", "f4")
"""What a packed colour is kept in."""


class PointCloud2Display(PointsDisplay):
    """Points with x, y, z; points that are not finite are left out, clouds without x, y, z are not looked at."""

    type = "PointCloud2"
    message_type = "sensor_msgs/msg/PointCloud2"

    def show(self, message: Any) -> None:
        import numpy as np

        fields = {field.name: field for field in message.fields}
        if not {"x", "y", "z"} <= fields.keys():
            return
        size = len(message.data)
        if message.width * message.height * message.point_step != size:
            self.put_status(
                ERROR,
                "Message",
                f"Data size ({size} bytes) does not match width ({message.width}) times height ({message.height}) "
                f"times point_step ({message.point_step}).  Dropping message.",
            )
            return
        pose = self.place(message.header)
        if pose is None:
            return
        if fields["x"].datatype != _FLOAT32:
            self.put_status(ERROR, "Message", "No position transformer available for cloud")
            return
        try:
            points = np.frombuffer(message.data, _layout(message)) if size else np.zeros(0, _layout(message))
        except (TypeError, ValueError):
            self.put_status(ERROR, "Message", "PointCloud contained not enough or too much data")
            return
        # Two million points must not hold up the other programs of this thread: no more are looked at than are drawn.
        step = max(1, -(-len(points) // MOST_DRAWN))
        self.of_all = len(points) if step > 1 else 0
        points = points[::step]
        xyz = np.stack([points[name].astype(np.float64) for name in "xyz"], axis=1)
        good = np.isfinite(xyz).all(axis=1)
        kept = points[good]
        channels = {name: kept[name] for name in kept.dtype.names or () if kept[name].ndim == 1}
        colours, names = own_colours(kept)
        self.take(xyz[good], pose, channels, colours, names)


def _layout(message: Any) -> Any:
    """The dtype of one point. ValueError for fields that do not fit into it."""
    import numpy as np

    order = ">" if message.is_bigendian else "<"
    fields = {field.name: field for field in message.fields if field.datatype in _FORMATS}
    for name, field in fields.items():
        width = np.dtype(_FORMATS[field.datatype]).itemsize
        if field.offset + width > message.point_step:
            raise ValueError(name)
    return np.dtype(
        {
            "names": list(fields),
            "formats": [order + _FORMATS[field.datatype] for field in fields.values()],
            "offsets": [field.offset for field in fields.values()],
            "itemsize": message.point_step,
        }
    )


def own_colours(points: Any) -> tuple[Any, tuple[str, ...]]:
    """The colours (N x 4) that the points bring along, None if they bring none; and the transformers that read them."""
    import numpy as np

    names = points.dtype.names or ()
    packed = next((name for name in ("rgb", "rgba") if name in names and points.dtype[name].str[1:] in _PACKED), "")
    split = {"r", "g", "b"} <= set(names) and points.dtype["r"].str[1:] == "f4"
    if packed:
        bits = np.ascontiguousarray(points[packed]).astype(points[packed].dtype.newbyteorder("<")).view("<u4")
        parts = [(bits >> shift) & 0xFF for shift in (16, 8, 0)]
        opaque = np.full(len(bits), 255) if packed == "rgb" else bits >> 24
        return np.stack([*parts, opaque], axis=1).astype(np.float32) / 255, (RGB8, RGBF32) if split else (RGB8,)
    if split:
        parts = [np.nan_to_num(points[name].astype(np.float32)).clip(0, 1) for name in "rgb"]
        return np.stack([*parts, np.ones(len(points), np.float32)], axis=1), (RGBF32,)
    return None, ()
