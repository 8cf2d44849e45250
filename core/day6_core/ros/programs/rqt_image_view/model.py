"""What the image view shows: the topics with images, and the newest image of the chosen one.

Messages are kept as they come, as bytes: only the newest one is decoded, by the window when it draws, and of it only the pixels
that there is room for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Point

from day6_core.interfaces import DeserializationError, deserialize, get_message
from day6_core.parts import part
from day6_core.ros.programs.rqt_image_view.decoding import DecodedImage, ImageRequest, Undecodable, picture_of
from day6_core.ros.programs.rqt_py_common.requests import Requests
from rclpy.qos import qos_profile_sensor_data

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher
    from rclpy.subscription import Subscription

TYPES = ("sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage")

MOST_BYTES = 200_000_000
"""A larger message is told, but not decoded."""


class ImageView(Requests):
    """The model of one plugin. The window may read its attributes, call `picture`, `save`, and the requests."""

    def __init__(self, node: Node, path: Callable[[str], Path]) -> None:
        super().__init__()
        self._node = node
        self.path = path
        """The file that a user of this program means."""
        self._subscription: Subscription[Any] | None = None
        self._mouse: Publisher[Point] | None = None
        self._newest: Any = None
        """A message or its bytes, as it came."""
        self._decoded: tuple[int, Any] = (0, None)
        self.topics: Mapping[str, str] = {}
        """The names of topics with images, sorted, and their types."""
        self.topic = ""
        self.view = ImageRequest(0, 0)
        """How the image is shown; the window changes it, and knows its size."""
        self.received = 0
        """How many images have come."""
        self.publishes_clicks = False
        self.version = 0
        """Grows when anything but the image changes."""
        self.on_image: Callable[[], object] | None = None
        """Called (any thread) when an image has come: nothing else may be going on that would have the window drawn anew."""

    # -- the window's side ---------------------------------------------------------------------------------------------

    def choose(self, topic: str) -> None:
        """Show another topic; '' shows none."""
        self.post(lambda: self.show_topic(topic))

    def publish_clicks(self, on: bool) -> None:
        """Publish clicks on the image, or no longer."""
        self.post(lambda: self.set_publishing(on))

    def click(self, x: int, y: int) -> None:
        """Somebody clicked on a pixel of the image."""
        self.post(lambda: self._publish(x, y))

    @property
    def mouse_topic(self) -> str:
        """Where clicks are published."""
        return f"{self.topic}_mouse_left" if self.topic else "mouse_left"

    def picture(self, view: ImageRequest) -> DecodedImage | None:
        """The newest image as it is to be shown; None while there is none. Raises Undecodable."""
        message = self._message()
        return picture_of(message, view) if message is not None else None

    def save(self, name: str, view: ImageRequest) -> Path:
        """Write the whole newest image, turned as `view`, to a file; its suffix names the format. OSError, ValueError."""
        message = self._message()
        if message is None:
            raise ValueError("there is no image yet")
        size = (100_000, 100_000)
        whole = ImageRequest(*size, True, 0, 0, view.rotation, view.dynamic_range, view.max_range)
        path = self.path(name)
        if path.suffix.lower() not in (".bmp", ".jpg", ".png", ".tiff"):
            raise ValueError("Image (*.bmp *.jpg *.png *.tiff)")
        from day6_core.whole_file import replacing

        pixels = picture_of(message, whole).pixels
        images = part("PIL.Image", "saving images needs")
        with replacing(path) as file:
            images.fromarray(pixels).save(file, images.registered_extensions()[path.suffix.lower()])
        return path

    def _message(self) -> Any:
        """The newest message, decoded from its bytes once. Raises Undecodable."""
        number, newest = self.received, self._newest
        if not isinstance(newest, bytes):
            return newest
        if self._decoded[0] != number:
            if len(newest) > MOST_BYTES:
                raise Undecodable(f"an image of {len(newest)} bytes")
            try:
                message = deserialize(newest, get_message(self.topics.get(self.topic, TYPES[0])))
            except DeserializationError as error:
                raise Undecodable(str(error)) from error
            self._decoded = number, message
        return self._decoded[1]

    # -- the program's side --------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Look which topics have images; one that was chosen before it was there is listened to now."""
        found = {}
        for name, types in sorted(self._node.get_topic_names_and_types()):
            fitting = next((each for each in TYPES if each in types), None)
            if fitting is not None:
                found[name] = fitting
        if found != self.topics:
            self.topics = found
            self.version += 1
        if self.topic in found and self._subscription is None:
            self.show_topic(self.topic)

    def show_topic(self, topic: str) -> None:
        """Listen to a topic, and to no other."""
        if self._subscription is not None:
            self._node.destroy_subscription(self._subscription)
            self._subscription = None
        self._newest, self.received, self._decoded = None, 0, (0, None)
        self.topic = topic
        if topic in self.topics:
            kind = get_message(self.topics[topic])
            subscription = self._node.create_subscription(kind, topic, self._receive, qos_profile_sensor_data, raw=True)
            subscription.handle.take_at_once(self._receive)
            self._subscription = subscription
        self.set_publishing(self.publishes_clicks)
        self.version += 1

    def _receive(self, message: Any) -> None:
        """Keep a message; on the thread that received it."""
        self._newest = message
        self.received += 1
        if self.on_image is not None:
            self.on_image()

    def set_publishing(self, on: bool) -> None:
        """Have a publisher for clicks, or none."""
        if self._mouse is not None:
            self._node.destroy_publisher(self._mouse)
            self._mouse = None
        self.publishes_clicks = on
        if on:
            self._mouse = self._node.create_publisher(Point, self.mouse_topic, 1000)
        self.version += 1

    def _publish(self, x: int, y: int) -> None:
        if self._mouse is not None:
            self._mouse.publish(Point(x=float(x), y=float(y)))

    def close(self) -> None:
        """Give back what it has on the program's node."""
        self.show_topic("")
        self.set_publishing(False)
