"""Image (rviz_default_plugins/displays/image): the picture of a camera, in a corner of the view."""

from __future__ import annotations

import math
from collections import deque
from typing import Any

from day6_core.ros.programs import image_pixels
from day6_core.ros.programs.rviz2.model.properties import BOOL, INT, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Overlay, Scene
from day6_core.ros.programs.rviz2.model.status import ERROR
from day6_core.ros.programs.rviz2.model.topics import TopicDisplay

MOST_PIXELS = 640
"""An image that is wider or higher is kept with every second, third … pixel only: no terminal shows more."""


class UnsupportedEncoding(ValueError):
    """An image in an encoding that RViz does not show."""

    def __init__(self, encoding: str) -> None:
        super().__init__(f"Unsupported image encoding [{encoding}]")


class ImageDisplay(TopicDisplay):
    """The newest image of a topic; where its frame is does not matter."""

    type = "Image"
    message_type = "sensor_msgs/msg/Image"

    def build(self) -> None:
        super().build()
        changed = self._switched
        self.normalize = self.add(Property("Normalize Range", BOOL, True, on_change=changed))
        self.least = self.add(floats("Min Value", 0, on_change=changed))
        self.most = self.add(floats("Max Value", 1, on_change=changed))
        self.window = self.add(Property("Median window", INT, 5, low=1, on_change=changed))
        self._message: Any = None
        self._measured = False
        self._overlay: Overlay | None = None
        self._bounds: deque[tuple[float, float]] = deque()
        self._hide()

    def _switched(self) -> None:
        self._hide()
        if self._message is not None:
            self._read(self._message)
        self.changed()

    def _hide(self) -> None:
        self.normalize.hidden = not self._measured
        self.least.hidden = self.most.hidden = not self._measured or bool(self.normalize.value)
        self.window.hidden = not self._measured or not self.normalize.value

    def reset(self) -> None:
        super().reset()
        self._message = self._overlay = None
        self._bounds.clear()

    def process(self, message: Any) -> None:
        measured = message.encoding in image_pixels.MEASURED
        if measured != self._measured:
            self._measured = measured
            self._hide()
            self.rviz.tree_changed()
        if len(message.data):
            self._message = message
            self._read(message)

    def _read(self, message: Any) -> None:
        try:
            pixels = self._pixels(message)
        except UnsupportedEncoding as error:
            self.put_status(ERROR, "Image", str(error))
            return
        except ValueError as error:
            self.rviz.log_error(f"Error loading image: {error}")
            return
        self.drop_status("Image")
        self._overlay = Overlay(self.name, pixels)

    def _pixels(self, message: Any) -> Any:
        """Rows x columns x 3 (0..255). UnsupportedEncoding, or ValueError for too few data."""
        import numpy as np

        thin = max(1, math.ceil(max(message.width, message.height) / MOST_PIXELS))
        at = np.arange(0, message.height, thin), np.arange(0, message.width, thin)
        found = image_pixels.colours(message, *at)
        if found is not None:
            return found
        if message.encoding in image_pixels.MEASURED:
            return np.repeat(self._normalised(image_pixels.measures(message, *at))[..., None], 3, axis=2)
        if message.encoding.startswith("bayer"):
            return image_pixels.greys(message, *at)
        raise UnsupportedEncoding(message.encoding)

    def _normalised(self, values: Any) -> Any:
        """Numbers as greys: between the least and the most there are (medians of the last images), or between those set."""
        import numpy as np

        least, most = self.least.value, self.most.value
        finite = values[np.isfinite(values)]
        if self.normalize.value and len(finite):
            self._bounds.append((float(finite.min()), float(finite.max())))
            while len(self._bounds) > self.window.value:
                self._bounds.popleft()
            middle = len(self._bounds) // 2
            least = sorted(low for low, _ in self._bounds)[middle]
            most = sorted(high for _, high in self._bounds)[middle]
        part = np.nan_to_num((values - least) / ((most - least) or 1.0), nan=0.0, posinf=1.0, neginf=0.0)
        return (np.clip(part, 0, 1) * 255).astype(np.uint8)

    @property
    def picture_size(self) -> str:
        """The size of the image as `640x480`; '' without one."""
        message = self._message
        return f"{message.width}x{message.height}" if message is not None and self._overlay is not None else ""

    def draw(self, scene: Scene) -> None:
        if self._overlay is not None:
            if self._overlay.name != self.name:
                self._overlay = Overlay(self.name, self._overlay.pixels)
            scene.overlays.append(self._overlay)
