"""DepthCloud (rviz_default_plugins/displays/depth_cloud): the points that a depth image and its camera's calibration give."""

from __future__ import annotations

import math
from typing import Any

from day6_core.ros.programs import image_pixels
from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import INTENSITY, MOST_DRAWN, RGB8, PointsDisplay
from day6_core.ros.programs.rviz2.model.properties import TOPIC, Property
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN

METRES = {"16UC1": 0.001, "mono16": 0.001, "32FC1": 1.0}
"""Encoding -> metres of one unit of depth (depth_image_proc)."""
CAMERA_INFO = "Camera Info"


class DepthCloudDisplay(PointsDisplay):
    """The calibration comes from `camera_info` beside the depth image; a colour image of the same size may colour the points.

    The transport hints of a .rviz file and its `Auto Size` and `Occlusion Compensation` are kept and do nothing.
    """

    type = "DepthCloud"
    message_type = "sensor_msgs/msg/Image"
    topic_name = "Depth Map Topic"

    def build(self) -> None:
        super().build()
        self.colour_topic = self.add(
            Property("Color Image Topic", TOPIC, "", options=self._topics, on_change=self.changed), 1
        )
        self._beside: list[Any] = []
        self._info: Any = None
        self._colour: Any = None

    def _wanted(self) -> tuple[Any, ...]:
        return (*super()._wanted(), self.colour_topic.value)

    def _subscribe(self) -> None:
        super()._subscribe()
        if self.subscription is None:
            return
        info = f"{self.topic.value.rpartition('/')[0]}/camera_info"
        self.put_status(WARN, CAMERA_INFO, f"No CameraInfo received on [{info}].")
        self._also(info, "sensor_msgs/msg/CameraInfo", self._take_info, CAMERA_INFO)
        if self.colour_topic.value:
            self._also(self.colour_topic.value, self.message_type, self._take_colour, "Color Image")

    def _also(self, topic: str, type_name: str, callback: Any, line: str) -> None:
        subscription = self._try_to_subscribe(topic, type_name, callback, line)
        if subscription is not None:
            self._beside.append(subscription)

    def _unsubscribe(self) -> None:
        super()._unsubscribe()
        for subscription in self._beside:
            self.rviz.node.destroy_subscription(subscription)
        self._beside.clear()
        self._info = self._colour = None

    def _take_info(self, message: Any) -> None:
        self._info = message
        if message.k[0] == 0 or message.k[4] == 0:
            self.put_status(ERROR, CAMERA_INFO, "Invalid intrinsic matrix")
        else:
            self.put_status(OK, CAMERA_INFO, "OK")

    def _take_colour(self, message: Any) -> None:
        self._colour = message

    def show(self, message: Any) -> None:
        import numpy as np

        scale, info = METRES.get(message.encoding), self._info
        if scale is None:
            self.put_status(
                ERROR, "Message", f"Input image must be unsigned 16 bit or float. Found [{message.encoding}]"
            )
            return
        pose = self.place(message.header)
        if pose is None or info is None or info.k[0] == 0 or info.k[4] == 0:
            return
        step = max(1, math.ceil(math.sqrt(message.width * message.height / MOST_DRAWN)))
        rows, columns = np.arange(0, message.height, step), np.arange(0, message.width, step)
        try:
            depth = image_pixels.measures(message, rows, columns) * scale
        except ValueError as error:
            self.put_status(ERROR, "Message", str(error))
            return
        x = (columns[None, :] - info.k[2]) / info.k[0] * depth
        y = (rows[:, None] - info.k[5]) / info.k[4] * depth
        xyz = np.stack([x, y, depth], axis=-1).reshape(-1, 3)
        good = np.isfinite(xyz).all(axis=1) & (xyz[:, 2] > 0)
        colours = self._colours_of(message, rows, columns)
        names = (RGB8,) if colours is not None else ()
        self.of_all = 0
        self.take(
            xyz[good], pose, {INTENSITY.lower(): xyz[good][:, 2]}, colours if colours is None else colours[good], names
        )

    def _colours_of(self, message: Any, rows: Any, columns: Any) -> Any:
        """The colours of the points, N x 4 (0..1); None without a colour image of the same size."""
        import numpy as np

        seen = self._colour
        if seen is None or (seen.width, seen.height) != (message.width, message.height):
            return None
        try:
            pixels = image_pixels.colours(seen, rows, columns)
        except ValueError:
            return None
        if pixels is None:
            return None
        flat = pixels.reshape(-1, 3) / 255
        return np.concatenate([flat, np.ones((len(flat), 1))], axis=1)
