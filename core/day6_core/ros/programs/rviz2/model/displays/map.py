"""Map (rviz_default_plugins/displays/map): an occupancy grid as a picture on the ground."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.properties import (
    BOOL,
    ENUM,
    INT,
    QUATERNION,
    VECTOR,
    Property,
    floats,
)
from day6_core.ros.programs.rviz2.model.scene import Image, Scene
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN
from day6_core.ros.programs.rviz2.model.topics import (
    INVALID_FLOATS,
    TopicDisplay,
    all_finite,
    pose_numbers,
    pose_of,
    stamp_ns,
)
from day6_urdf.kinematics import compose


class MapDisplay(TopicDisplay):
    """The newest map; updates of parts of it come on `<topic>_updates`, as in the original."""

    type = "Map"
    message_type = "nav_msgs/msg/OccupancyGrid"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.alpha = self.add(floats("Alpha", 0.7, 0, 1, on_change=changed))
        schemes = ("map", "costmap", "raw")
        self.scheme = self.add(Property("Color Scheme", ENUM, "map", options=schemes, on_change=changed))
        self.behind = self.add(Property("Draw Behind", BOOL, False, on_change=changed))
        self.resolution = self.add(floats("Resolution", 0, read_only=True))
        self.width = self.add(Property("Width", INT, 0, read_only=True))
        self.height = self.add(Property("Height", INT, 0, read_only=True))
        self.position = self.add(Property("Position", VECTOR, (0.0, 0.0, 0.0), read_only=True))
        self.orientation = self.add(Property("Orientation", QUATERNION, (0.0, 0.0, 0.0, 1.0), read_only=True))
        self.use_stamp = self.add(Property("Use Timestamp", BOOL, False, on_change=changed))
        self.binary = self.add(Property("Binary representation", BOOL, False, on_change=changed))
        self.threshold = self.add(Property("Binary threshold", INT, 100, low=0, high=100, on_change=changed))
        self._header: Any = None
        self._origin: Any = None
        self._cells: Any = None
        self._drawn: tuple[Any, ...] = ()
        self._pixels: Any = None

    def on_enable(self) -> None:
        super().on_enable()
        self.put_status(WARN, "Message", "No map received")

    def reset(self) -> None:
        super().reset()
        self._header = self._cells = None
        if self.enabled:
            self.put_status(WARN, "Message", "No map received")

    def on_fixed_frame(self) -> None:
        """A map is sent once: it stays, and only its transform is another."""

    def process(self, message: Any) -> None:
        import numpy as np

        info = message.info
        origin = pose_numbers(info.origin)
        if not all_finite((info.resolution, *origin)):
            self.put_status(ERROR, "Map", INVALID_FLOATS)
            return
        if info.width * info.height == 0:
            self.put_status(ERROR, "Map", f"Map is zero-sized ({info.width}x{info.height})")
            return
        if info.width * info.height != len(message.data):
            self.put_status(
                ERROR,
                "Map",
                f"Data size doesn't match width*height: width = {info.width}, height = {info.height},"
                f" data size = {len(message.data)}",
            )
            return
        self.put_status(OK, "Message", "Map received")
        self._header = message.header
        self._origin = pose_of(info.origin)
        self._cells = np.array(message.data, np.int16).reshape(info.height, info.width)
        self.put_status(OK, "Map", "Map OK")
        self.resolution.value, self.width.value, self.height.value = info.resolution, info.width, info.height
        self.position.value, self.orientation.value = self._origin.xyz, self._origin.rotation

    def refresh(self) -> None:
        super().refresh()
        if self._header is None:
            return
        stamp = stamp_ns(self._header.stamp) if self.use_stamp.value else 0
        if self.rviz.frames.pose(self._header.frame_id, stamp) is None:
            self.transform_missing(self._header.frame_id)
        else:
            self.transform_ok()

    def draw(self, scene: Scene) -> None:
        if self._header is None:
            return
        stamp = stamp_ns(self._header.stamp) if self.use_stamp.value else 0
        frame = self.rviz.frames.pose(self._header.frame_id, stamp)
        if frame is None:
            return
        wanted = (id(self._cells), self.alpha.value, self.scheme.value, self.binary.value, self.threshold.value)
        if wanted != self._drawn:
            self._drawn = wanted
            self._pixels = self._paint()
        pose = compose(frame, self._origin)
        scene.images.append(Image(self._pixels, pose, self.resolution.value, self.behind.value))

    def _paint(self) -> Any:
        import numpy as np

        palette = np.array(_PALETTES[self.scheme.value](), np.uint8)
        cells = self._cells
        if self.binary.value:
            cells = np.where(cells >= self.threshold.value, 100, np.where(cells >= 0, 0, -1))
        pixels = palette[cells.astype(np.int64) & 255]
        pixels[..., 3] = (pixels[..., 3] * self.alpha.value).astype(np.uint8)
        return pixels


def _map_palette() -> list[tuple[int, int, int, int]]:
    """White free, black occupied, grey-green unknown, odd values in loud colours (map/palette_builder.cpp)."""
    colours = []
    for value in range(256):
        if value <= 100:
            grey = 255 - 255 * value // 100
            colours.append((grey, grey, grey, 255))
        else:
            colours.append(_odd_or_unknown(value))
    return colours


def _costmap_palette() -> list[tuple[int, int, int, int]]:
    colours = [(0, 0, 0, 0)]
    for value in range(1, 256):
        if value <= 98:
            share = 255 * value // 100
            colours.append((share, 0, 255 - share, 255))
        elif value == 99:
            colours.append((0, 255, 255, 255))
        elif value == 100:
            colours.append((255, 0, 255, 255))
        else:
            colours.append(_odd_or_unknown(value))
    return colours


def _odd_or_unknown(value: int) -> tuple[int, int, int, int]:
    """The colour of a value above 100: green where it is too large, red to yellow where negative, -1 is unknown."""
    if value <= 127:
        return 0, 255, 0, 255
    if value < 255:
        return 255, 255 * (value - 128) // (254 - 128), 0, 255
    return 0x70, 0x89, 0x86, 255


def _raw_palette() -> list[tuple[int, int, int, int]]:
    return [(value, value, value, 255) for value in range(256)]


_PALETTES = {"map": _map_palette, "costmap": _costmap_palette, "raw": _raw_palette}
