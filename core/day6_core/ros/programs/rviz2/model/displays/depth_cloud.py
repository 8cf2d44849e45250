"""DepthCloud (rviz_default_plugins/displays/depth_cloud): the picture of a depth camera as points in space.

Needs `camera_info` beside the topic of the depths; a second picture gives the points their colours.
"""

from __future__ import annotations

import math
import operator
from collections import deque
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.ros.programs import image_pixels
from day6_core.ros.programs.rviz2.model.displays.point_cloud_common import RGB8, PointsDisplay
from day6_core.ros.programs.rviz2.model.properties import BOOL, ENUM, INT, TOPIC, Property, floats
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN
from day6_core.ros.programs.rviz2.model.topics import stamp_ns
from day6_urdf.kinematics import Transform
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data

if TYPE_CHECKING:
    from rclpy.subscription import Subscription

RELIABILITY = {
    "System Default": ReliabilityPolicy.SYSTEM_DEFAULT,
    "Reliable": ReliabilityPolicy.RELIABLE,
    "Best effort": ReliabilityPolicy.BEST_EFFORT,
}
METRES = {"16UC1": 0.001, "mono16": 0.001, "32FC1": 1.0}
"""What the numbers of each encoding count (depth_cloud_mld.cpp: sixteen bits are millimetres)."""
NEAR_SHADOW = 0.01
"""Metres that a point lies before a remembered one to hide it."""
MOVED, TURNED = 0.01, 0.5
"""Metres and degrees by which the camera moves for what it remembers to be forgotten."""


class CloudError(ValueError):
    """Depths that cannot become points; `str()` says why."""


class Shadow(NamedTuple):
    """The farthest that each pixel saw, for Occlusion Compensation: depth (0: nothing), when, where, colour."""

    depth: Any
    since_ns: Any
    xyz: Any
    colours: Any


class DepthCloudDisplay(PointsDisplay):
    """Depths are points of a pyramid with the camera at its top."""

    type = "DepthCloud"
    message_type = "sensor_msgs/msg/Image"
    topic_name = "Depth Map Topic"
    topic_line = "Depth Map"

    def build(self) -> None:
        super().build()
        changed = self.changed
        self.topic.children = []  # its QoS are lines of the display here
        self.position.hidden = True
        lines = (
            Property("Reliability Policy", ENUM, "Best effort", options=tuple(RELIABILITY), on_change=changed),
            Property("Topic Filter", BOOL, True, on_change=changed),
            Property("Depth Map Transport Hint", ENUM, "raw", on_change=changed),
            Property("Color Image Topic", TOPIC, "", options=self._topics, on_change=changed),
            Property("Color Transport Hint", ENUM, "raw", on_change=changed),
            Property("Queue Size", INT, 5, low=1, on_change=changed),
            Property("Auto Size", BOOL, True, on_change=self._switched),
            Property("Occlusion Compensation", BOOL, False, on_change=self._remember_anew),
        )
        for line in lines:
            self.add(line)
        self.reliability, _, self.hint, self.colour_topic, self.colour_hint, self.queue, self.auto_size, self.behind = (
            lines
        )
        self.factor = self.auto_size.add(floats("Auto Size Factor", 1, 0.0001, on_change=changed))
        self.timeout = self.behind.add(floats("Occlusion Time-Out", 30, on_change=changed))
        self._info: Any = None
        self._pictures: deque[Any] = deque()
        self._others: list[Subscription[Any]] = []
        self._shadow: Shadow | None = None
        self._seen_from = Transform()
        self._hide()

    def _hide(self) -> None:
        super()._hide()
        if hasattr(self, "factor"):
            self.factor.hidden, self.timeout.hidden = not self.auto_size.value, not self.behind.value
            self.size.read_only = bool(self.auto_size.value)

    def _remember_anew(self) -> None:
        self._shadow = None
        self._switched()

    # -- messages ------------------------------------------------------------------------------------------------------

    def _wanted(self) -> tuple[Any, ...]:
        lines = (self.reliability, self.hint, self.colour_topic, self.colour_hint, self.queue)
        return (self.topic.value, *(line.value for line in lines))

    @property
    def info_topic(self) -> str:
        """`camera_info` beside the topic of the depths (image_transport's getCameraInfoTopic)."""
        return f"{str(self.topic.value).rpartition('/')[0]}/camera_info"

    def _subscribe(self) -> None:
        self._subscribed = self._wanted()
        if not self.topic.value or not self.hint.value:
            return
        for hint in {self.hint.value, self.colour_hint.value if self.colour_topic.value else "raw"} - {"raw"}:
            text = f"Error subscribing: Unable to load plugin for transport 'image_transport/{hint}_sub'"
            self.put_status(ERROR, "Message", f"{text}: only raw images are received here")
            return
        profile = QoSProfile(
            depth=self.queue.value, history=HistoryPolicy.KEEP_LAST, reliability=RELIABILITY[self.reliability.value]
        )
        self.filter_size.value = self.queue.value
        wanted = [(self.topic.value, self.message_type, self._incoming, self.topic_line, profile)]
        wanted.append(
            (self.info_topic, "sensor_msgs/msg/CameraInfo", self._info_came, "Message", qos_profile_sensor_data)
        )
        if self.colour_topic.value:
            wanted.append((self.colour_topic.value, self.message_type, self._picture_came, "Message", profile))
        found = [self._try_to_subscribe(*each) for each in wanted]
        self._others = [each for each in found if each is not None and each is not self.subscription]
        self._since_ns = self.rviz.now_ns()
        self.put_status(OK, self.topic_line, "0 depth maps received")

    def _unsubscribe(self) -> None:
        super()._unsubscribe()
        for each in self._others:
            self.rviz.node.destroy_subscription(each)
        self._others = []

    def reset(self) -> None:
        super().reset()
        self._pictures.clear()
        self._info = self._shadow = None

    def _info_came(self, message: Any) -> None:
        self._info = message
        self.rviz.touch()

    def _picture_came(self, message: Any) -> None:
        self._pictures.append(message)
        while len(self._pictures) > self.queue.value:
            self._pictures.popleft()
        self.rviz.touch()

    def show(self, message: Any) -> None:
        self.put_status(OK, "Message", "Ok")
        picture = None
        if self.colour_topic.value:
            if not self._pictures:
                return
            at = stamp_ns(message.header.stamp)
            picture = min(self._pictures, key=lambda each: abs(stamp_ns(each.header.stamp) - at))
        pose = self.place(message.header)
        if self._info is None:
            # The original says nothing and shows nothing.
            self.put_status(WARN, "Message", f"No CameraInfo received on [{self.info_topic}].")
        if self._info is None or pose is None:
            return
        self.put_status(OK, "Depth Image Size", f"{message.width} x {message.height}")
        try:
            own, colours = self._points_of(message, picture, pose)
        except (CloudError, ValueError) as error:
            self.put_status(ERROR, "Message", str(error))
            return
        if self.auto_size.value and self._info.k[0]:
            self.size.value = self.factor.value / self._info.k[0] * max(1, self._info.binning_x)
        self.take(own, pose, {}, colours, (RGB8,))
        # `take` drops what other clouds say about their messages.
        self.put_status(OK, "Message", "Ok")
        if picture is not None:
            self.put_status(OK, "Image Size", f"{picture.width} x {picture.height}")
            frames = message.header.frame_id, picture.header.frame_id
            if frames[0] != frames[1]:
                text = f"Depth image frame id [{frames[0]}] doesn't match color image frame id [{frames[1]}]"
                self.put_status(WARN, "Message", text)

    # -- points --------------------------------------------------------------------------------------------------------

    def _points_of(self, message: Any, picture: Any, pose: Transform) -> tuple[Any, Any]:
        """Points (N x 3) in the camera's frame and their colours (N x 4, 0..1). Raises CloudError, ValueError."""
        import numpy as np

        rays = self._rays(message)
        if message.encoding not in METRES:
            raise CloudError("Depth image has invalid format (only 16 bit and float are supported)!")
        rows, columns = np.arange(message.height), np.arange(message.width)
        depth = image_pixels.packed(message, "f4" if message.encoding == "32FC1" else "u2", 1)[..., 0]
        depth = depth.astype(np.float64) * METRES[message.encoding]
        depth[~np.isfinite(depth)] = 0.0
        xyz = np.stack([rays[0][None, :] * depth, rays[1][:, None] * depth, depth], axis=2)
        colours = np.ones((*depth.shape, 4), np.float32)
        if picture is not None:
            colours[..., :3] = self._colours_of(picture, message, rows, columns) / 255
        seen = depth != 0
        points, colour = [xyz[seen]], [colours[seen]]
        if self.behind.value:
            behind = self._hidden(depth, xyz, colours, pose)
            points.append(behind[0])
            colour.append(behind[1])
        return np.concatenate(points), np.concatenate(colour)

    def _rays(self, message: Any) -> tuple[Any, Any]:
        """How far to the right a column is, and how far down a row, one metre ahead."""
        import numpy as np

        info = self._info
        across, down = max(1, info.binning_x), max(1, info.binning_y)
        wide, high = info.roi.width or info.width, info.roi.height or info.height
        if (wide // across, high // down) != (message.width, message.height):
            raise CloudError(
                f"Depth image size and camera info don't match: {message.width} x {message.height} vs {wide // across} x "
                f"{high // down}(binning: {across} x {down}, ROI size: {wide} x {high})"
            )
        fx, fy = info.p[0] / across, info.p[5] / down
        if not fx or not fy:
            raise CloudError("Invalid intrinsic matrix")
        middle = (info.p[2] - info.roi.x_offset) / across, (info.p[6] - info.roi.y_offset) / down
        return (np.arange(message.width) - middle[0]) / fx, (np.arange(message.height) - middle[1]) / fy

    @staticmethod
    def _colours_of(picture: Any, message: Any, rows: Any, columns: Any) -> Any:
        if (picture.width, picture.height) != (message.width, message.height):
            raise CloudError(
                f"Depth image resolution ({message.width}x{message.height}) does not match color image resolution "
                f"({picture.width}x{picture.height})"
            )
        if "rgb" not in picture.encoding and "bgr" not in picture.encoding:
            raise CloudError("Encoded type not supported!")
        if picture.encoding in image_pixels.DEEP:
            return image_pixels.deep_colours(picture, rows, columns)
        return image_pixels.colours(picture, rows, columns)

    def _hidden(self, depth: Any, xyz: Any, colours: Any, pose: Transform) -> tuple[Any, Any]:
        """Points that something nearer hides now, at half their brightness; and remember what is farthest."""
        import numpy as np

        now = self.rviz.now_ns()
        before = self._seen_from
        turned = 2 * math.acos(min(1.0, abs(sum(map(operator.mul, pose.rotation, before.rotation)))))
        if math.dist(pose.xyz, before.xyz) > MOVED or math.degrees(turned) > TURNED:
            self._seen_from, self._shadow = pose, None
        old = self._shadow
        if old is None or old.depth.shape != depth.shape:
            empty = np.zeros(depth.shape)
            old = Shadow(empty, empty.copy(), np.zeros(xyz.shape), np.zeros(colours.shape, np.float32))
        old.depth[old.since_ns < now - self.timeout.value * 1e9] = 0.0
        seen = depth != 0
        nearer = seen & (depth < old.depth - NEAR_SHADOW)
        shown = nearer | (~seen & (old.depth != 0))
        points, faint = old.xyz[shown], old.colours[shown]
        kept = seen & ~nearer
        old.depth[kept], old.since_ns[kept], old.xyz[kept] = depth[kept], now, xyz[kept]
        old.colours[kept] = colours[kept] * np.array((0.5, 0.5, 0.5, 1.0), np.float32)
        self._shadow = old
        return points, faint
