"""The two components: one publishes pictures, the other one takes them (image_tools/src)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterDescriptor
from sensor_msgs.msg import Image

from day6_core.ros.programs.demo_messages import Bool
from day6_core.ros.programs.image_tools._burgers import Burgers
from day6_core.ros.programs.rclcpp import CppException
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component
    from rclpy.node import Node

_RELIABILITY = {"best_effort": ReliabilityPolicy.BEST_EFFORT, "reliable": ReliabilityPolicy.RELIABLE}
_HISTORY = {"keep_all": HistoryPolicy.KEEP_ALL, "keep_last": HistoryPolicy.KEEP_LAST}


def _profile(node: Node, kind: str) -> QoSProfile:
    """Return the QoS that the parameters say. Raises RuntimeError for a value that is none."""

    def policy(name: str, default: str, policies: dict[str, Any]) -> Any:
        about = ParameterDescriptor(
            description=f"{name.capitalize()} QoS setting for the image {kind}",
            additional_constraints="Must be one of: " + "".join(f"{each} " for each in policies),
        )
        value = node.declare_parameter(name, default, about).value
        if value not in policies:
            raise RuntimeError(f"Invalid QoS {name} setting '{value}'")
        return policies[value]

    reliability = policy("reliability", "reliable", _RELIABILITY)
    history = policy("history", "keep_last", _HISTORY)
    depth = node.declare_parameter("depth", 10).value
    return QoSProfile(history=history, depth=depth, reliability=reliability)


_ENCODINGS = ("mono8", "bgr8", "mono16", "rgba8", "bgra8", "32FC1", "rgb8", "yuv422")
"""Those that become an OpenCV matrix (cv_mat_sensor_msgs_image_type_adapter.cpp)."""

Show = Callable[[str, Image], object]
"""Shows an image in the window of that name."""


class Cam2Image:
    """Publishes pictures of burgers on `image`; there is no camera. RuntimeError without `burger_mode`, as without a camera."""

    NAME = "cam2image"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node, show: Show | None = None) -> None:
        self._node = node
        self._show = show
        self._logger = node.get_logger()
        qos = _profile(node, "publisher")
        frequency = node.declare_parameter("frequency", 30.0).value
        self._shows = node.declare_parameter("show_camera", False).value
        node.declare_parameter("device_id", 0)
        self._width = node.declare_parameter("width", 320).value
        self._height = node.declare_parameter("height", 240).value
        about = ParameterDescriptor(description="Produce images of burgers rather than connecting to a camera")
        with_burgers = node.declare_parameter("burger_mode", False, about).value
        self._frame = node.declare_parameter("frame_id", "camera_frame").value
        self._publisher = node.create_publisher(Image, "image", qos)
        self._flip = False
        node.create_subscription(Bool, "flip_image", self._set_flip, qos_profile_sensor_data)
        if not with_burgers:
            self._logger.error("Could not open video stream")
            raise RuntimeError("Could not open video stream")
        self._burgers = Burgers(self._width, self._height)
        self._count = 0
        node.create_timer(int(1000 / frequency) / 1000, self._publish)

    def _set_flip(self, message: Bool) -> None:
        self._flip = message.data
        self._logger.info(f"Set flip mode to: {'on' if self._flip else 'off'}")

    def _publish(self) -> None:
        picture = self._burgers.draw()
        message = Image(height=self._height, width=self._width, encoding="bgr8", step=3 * self._width)
        message.data = self._burgers.flipped(picture) if self._flip else picture
        message.header.frame_id = self._frame
        message.header.stamp = self._node.get_clock().now().to_msg()
        self._count += 1
        self._logger.info(f"Publishing image #{self._count}")
        if self._shows and self._show is not None:
            self._show("cam2image", message)
        self._publisher.publish(message)


class ShowImage:
    """Tells of each picture on `image` and shows it. `echo` gets what the real one writes beside its log."""

    NAME = "showimage"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node, echo: Callable[[str], object] = lambda text: None, show: Show | None = None) -> None:
        self._logger = node.get_logger()
        self._echo = echo
        self._show = show
        qos = _profile(node, "subscription")
        self.shows = node.declare_parameter("show_image", True).value
        name = node.declare_parameter("window_name", "").value
        self._logger.info("Subscribing to topic 'image'")
        subscription = node.create_subscription(Image, "image", self._take, qos)
        self._name = name or subscription.topic_name

    def _take(self, message: Image) -> None:
        if message.encoding not in _ENCODINGS:
            raise CppException("Unsupported encoding type")
        text = f"Received image #{message.header.frame_id}"
        self._logger.info(text)
        self._echo(text)
        if self.shows and self._show is not None:
            self._show(self._name, message)


COMPONENTS: dict[str, type[Component]] = {f"image_tools::{kind.__name__}": kind for kind in (Cam2Image, ShowImage)}
