"""What rqt_image_view makes of an image: colours through cv_bridge, distances as greys; only the pixels that are shown.

Compressed images go through Pillow, whose decoder of JPEG can leave out most of a large picture.
"""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from day6_core.parts import MissingPart, part
from day6_core.ros.programs import image_pixels

MOST_COMPRESSED_PIXELS = 50_000_000
"""Of a compressed image, which may say any size in a few bytes."""

RANGE_SAMPLES = 256
"""Rows and columns in which the least and the greatest value of an image are looked for."""

NUMBERS = re.compile(r"(8|16|32|64)[USF](?:C([0-9]+))?")
"""Encodings that cv_bridge knows, but cannot make colours of; rqt_image_view shows some of them all the same."""


class Undecodable(ValueError):
    """An image that cannot be shown, in the words of the real plugin (image_view.cpp, callbackImage) and cv_bridge.

    `reason` is without those of the plugin.
    """

    def __init__(self, text: str, reason: str = "") -> None:
        super().__init__(text)
        self.reason = reason or text


@dataclass(frozen=True)
class ImageRequest:
    """What is asked of an image: how many pixels, of which part of it, and how distances become greys."""

    width: int
    height: int
    zoom_1: bool = False
    """One pixel shown is one of the image, from `left` and `top` on; otherwise all of it is fitted in."""
    left: int = 0
    top: int = 0
    rotation: int = 0
    """Clockwise, in quarter turns."""
    dynamic_range: bool = False
    max_range: float = 10.0
    """Metres that are white, without the dynamic range."""


@dataclass(frozen=True, slots=True)
class DecodedImage:
    """Pixels that are shown: height x width x 3 (uint8), and of which ones of the image, after it was turned."""

    pixels: Any
    image_width: int
    image_height: int
    encoding: str
    columns: Any
    """Of each column shown the one of the turned image."""
    rows: Any


def picture_of(message: Any, view: ImageRequest) -> DecodedImage:
    """The picture of a sensor_msgs/Image or CompressedImage. Raises Undecodable."""
    if hasattr(message, "format"):
        return _compressed(message, view)
    read = _reader(message, view)
    try:
        return _sampled(read, message.width, message.height, message.encoding, view)
    except ValueError as error:
        raise _failed(message.encoding, str(error)) from error


def _sampled(
    read: Callable[[Any, Any], Any], width: int, height: int, encoding: str, view: ImageRequest
) -> DecodedImage:
    """Read the rows and columns of an image that a view shows, and turn them."""
    import numpy as np

    if not width or not height:
        raise ValueError(f"{width}x{height} pixels")
    turned = view.rotation % 2 == 1
    across, down = (height, width) if turned else (width, height)
    columns, rows = _shown(across, view.width, view.left, view), _shown(down, view.height, view.top, view)
    if not view.zoom_1:
        scale = max(across / max(1, view.width), down / max(1, view.height))
        columns = _spread(across, max(1, round(across / scale)))
        rows = _spread(down, max(1, round(down / scale)))
    # Where the shown pixels lie in the message (image_view.cpp: transpose and flip).
    at = {
        0: (rows, columns),
        1: (height - 1 - columns, rows),
        2: (height - 1 - rows, width - 1 - columns),
        3: (columns, width - 1 - rows),
    }[view.rotation % 4]
    pixels = read(*at)
    if turned:
        pixels = np.swapaxes(pixels, 0, 1)
    return DecodedImage(np.ascontiguousarray(pixels), across, down, encoding, columns, rows)


def _shown(size: int, room: int, first: int, view: ImageRequest) -> Any:
    import numpy as np

    first = max(0, min(first, size - room))
    return np.arange(first, min(size, first + room))


def _spread(size: int, count: int) -> Any:
    """`count` indices, evenly over 0 … size-1."""
    import numpy as np

    return (np.arange(count) * size + size // 2) // count if count < size else np.arange(count) * size // count


def _reader(message: Any, view: ImageRequest) -> Callable[[Any, Any], Any]:
    """What reads rows and columns of a message as colours. Raises Undecodable for one that nothing is made of."""
    encoding = message.encoding
    _require_form(message)
    if encoding in image_pixels.BAYER:
        return lambda rows, columns: image_pixels.demosaiced(message, rows, columns)
    if encoding in image_pixels.DEEP:
        return lambda rows, columns: image_pixels.deep_colours(message, rows, columns)
    if encoding in ("16UC1", "32FC1", "mono16"):
        return lambda rows, columns: _measured(message, rows, columns, view)
    if encoding != "8UC1" and NUMBERS.fullmatch(encoding):
        sense = f"[{encoding}] is not a color format. but [rgb8] is. The conversion does not make sense"
        raise Undecodable(f"ImageView.callback_image() could not convert image from '{encoding}' to 'rgb8' ({sense})")
    return lambda rows, columns: image_pixels.colours(message, rows, columns)


def _require_form(message: Any) -> None:
    """Raise Undecodable for what cv_bridge takes for no image (cv_bridge.cpp, matFromImage)."""
    encoding = message.encoding
    depth, channels = _form(encoding)
    least, whole = message.width * depth * channels, message.height * message.step
    wrong = "Image is wrongly formed:"
    if message.step < least:
        form = f"{message.step} != {message.width} * {depth} * {channels}"
        raise _failed(encoding, f"{wrong} step < width * byte_depth * num_channels  or  {form}")
    if whole != len(message.data):
        form = f"{message.height} * {message.step} != {len(message.data)}"
        raise _failed(encoding, f"{wrong} height * step != size  or  {form}")


def _form(encoding: str) -> tuple[int, int]:
    """Bytes of a number and numbers of a pixel. Raises Undecodable for an unknown encoding."""
    if numbers := NUMBERS.fullmatch(encoding):
        return int(numbers[1]) // 8, int(numbers[2] or 1)
    if encoding in image_pixels.VIDEO:
        return 1, 2
    coloured = image_pixels.COLOURED.get(encoding) or image_pixels.DEEP.get(encoding)
    if coloured is None and encoding not in ("mono8", "mono16", *image_pixels.BAYER):
        raise _failed(encoding, f"Unrecognized image encoding [{encoding}]")
    return 2 if encoding.endswith("16") else 1, coloured[0] if coloured is not None else 1


def _failed(encoding: str, reason: str) -> Undecodable:
    return Undecodable(
        f"ImageView.callback_image() while trying to convert image from '{encoding}' to 'rgb8' "
        f"an exception was thrown ({reason})",
        reason,
    )


def _measured(message: Any, rows: Any, columns: Any, view: ImageRequest) -> Any:
    """Distances as greys: from 0 to the greatest range, or between the least and the greatest there are (image_view.cpp)."""
    import numpy as np

    values = image_pixels.measures(message, rows, columns)
    least, most = 0.0, view.max_range * (1000 if message.encoding == "16UC1" else 1)
    if message.encoding == "mono16":  # as cv_bridge
        most = 65535.0
    elif view.dynamic_range:
        some = image_pixels.measures(
            message, *(_spread(size, min(size, RANGE_SAMPLES)) for size in (message.height, message.width))
        )
        finite = some[np.isfinite(some)]
        least, most = (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 0.0)
        if least == most:  # an image all of one value is grey
            least, most = 0.0, 2.0
    with np.errstate(over="ignore", invalid="ignore"):
        part = np.nan_to_num((values - least) / ((most - least) or 1.0), nan=0.0, posinf=1.0, neginf=0.0)
    return np.repeat(np.rint(part.clip(0, 1) * 255).astype(np.uint8)[..., None], 3, axis=2)


def _compressed(message: Any, view: ImageRequest) -> DecodedImage:
    """A JPEG or PNG; a large JPEG is decoded only as finely as it is shown."""
    import numpy as np

    try:
        images = part("PIL.Image", "compressed images need")
    except MissingPart as error:
        raise Undecodable(str(error)) from None
    name = message.format
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", images.DecompressionBombWarning)
            image = images.open(io.BytesIO(bytes(message.data)), formats=("JPEG", "PNG"))
            width, height = image.size
            if width * height > MOST_COMPRESSED_PIXELS:
                raise Undecodable(f"{width}x{height}: too large")
            if not view.zoom_1:
                image.draft("RGB", (max(1, view.width), max(1, view.height)))
            pixels = np.asarray(image.convert("RGB"))
    except Undecodable:
        raise
    except Exception as error:
        # Pillow's decoders raise nearly anything for damaged data.
        raise Undecodable(f"cv_bridge: {name}: {error}") from error
    rows, columns = pixels.shape[:2]

    def read(at_rows: Any, at_columns: Any) -> Any:
        return pixels[(at_rows * rows // height)[:, None], (at_columns * columns // width)[None, :]]

    return _sampled(read, width, height, name, view)
