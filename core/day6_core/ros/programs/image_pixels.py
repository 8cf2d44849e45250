"""The pixels of a sensor_msgs/Image, only those that are asked for: a terminal shows few of those that a camera has.

Used by RViz's Image display and by rqt_image_view, which differ in what they do with numbers that are no colours.
"""

from __future__ import annotations

from typing import Any

COLOURED = {
    "rgb8": (3, (0, 1, 2)),
    "rgba8": (4, (0, 1, 2)),
    "bgra8": (4, (2, 1, 0)),
    "8UC4": (4, (2, 1, 0)),
    "8SC4": (4, (2, 1, 0)),
    "bgr8": (3, (2, 1, 0)),
    "8UC3": (3, (2, 1, 0)),
    "8SC3": (3, (2, 1, 0)),
}
"""Encoding -> bytes of a pixel, and which of them are red, green and blue."""
GREY = ("mono8", "8UC1", "8SC1")
MEASURED = {"mono16": "u2", "16UC1": "u2", "16SC1": "u2", "32FC1": "f4"}
"""Encodings of distances and the like, which have no natural black and white."""
VIDEO = {"uyvy": (1, 0, 2), "yuv422": (1, 0, 2), "yuyv": (0, 1, 3), "yuv422_yuy2": (0, 1, 3)}
"""Two pixels in four bytes: where the first brightness is, and the two colour differences."""
BAYER = {
    "bayer_rggb8": (0, 0),
    "bayer_grbg8": (0, 1),
    "bayer_gbrg8": (1, 0),
    "bayer_bggr8": (1, 1),
    "bayer_rggb16": (0, 0),
    "bayer_grbg16": (0, 1),
    "bayer_gbrg16": (1, 0),
    "bayer_bggr16": (1, 1),
}
"""Row and column of the red pixel in every square of four; the blue one is opposite, the others are green."""
DEEP = {"rgb16": (3, (0, 1, 2)), "bgr16": (3, (2, 1, 0)), "rgba16": (4, (0, 1, 2)), "bgra16": (4, (2, 1, 0))}
"""As `COLOURED`, with two bytes for each colour."""

Pixels = Any
"""An array of numpy: rows x columns x channels."""


def colours(message: Any, rows: Any, columns: Any) -> Pixels | None:
    """Pixels x 3 (uint8: red, green, blue) of some rows and columns (arrays of indices); None for what has no colours or greys.

    Raises ValueError for too few data.
    """
    import numpy as np

    encoding = message.encoding
    if encoding in COLOURED:
        size, order = COLOURED[encoding]
        return _at(packed(message, "u1", size), rows, columns)[..., list(order)]
    if encoding in GREY:
        return np.repeat(_at(packed(message, "u1", 1), rows, columns), 3, axis=2)
    if encoding in VIDEO:
        return _video(packed(message, "u1", 2), rows, columns, *VIDEO[encoding])
    return None


def deep_colours(message: Any, rows: Any, columns: Any) -> Pixels:
    """Pixels x 3 of one of `DEEP`, as `colours`. Raises ValueError for too few data."""
    size, order = DEEP[message.encoding]
    return _bytes_of(_at(packed(message, "u2", size), rows, columns)[..., list(order)])


def greys(message: Any, rows: Any, columns: Any) -> Pixels:
    """Pixels x 3 of an image with one byte for each, as greys. Raises ValueError for too few data."""
    import numpy as np

    return np.repeat(_at(packed(message, "u1", 1), rows, columns), 3, axis=2)


def demosaiced(message: Any, rows: Any, columns: Any) -> Pixels:
    """Pixels x 3 of one of `BAYER`, each with the colours of its square of four. Raises ValueError for too few data."""
    import numpy as np

    deep = message.encoding.endswith("16")
    data = packed(message, "u2" if deep else "u1", 1)[..., 0]
    down, across = BAYER[message.encoding]
    top = np.clip(rows // 2 * 2, 0, max(0, message.height - 2))[:, None]
    left = np.clip(columns // 2 * 2, 0, max(0, message.width - 2))[None, :]
    last_row, last_column = message.height - 1, message.width - 1

    def part(row: int, column: int) -> Any:
        return data[np.minimum(top + row, last_row), np.minimum(left + column, last_column)]

    green = (part(down, 1 - across).astype(np.uint32) + part(1 - down, across)) // 2
    found = np.stack([part(down, across), green.astype(data.dtype), part(1 - down, 1 - across)], axis=2)
    return _bytes_of(found) if deep else found


def measures(message: Any, rows: Any, columns: Any) -> Pixels:
    """The numbers of one of `MEASURED` (rows x columns, float64). Raises ValueError for too few data."""
    import numpy as np

    return _at(packed(message, MEASURED[message.encoding], 1), rows, columns)[..., 0].astype(np.float64)


def packed(message: Any, format_: str, channels: int) -> Pixels:
    """All the data as rows x columns x channels, without a copy; `step` may be longer than a row. ValueError for too few."""
    import numpy as np

    kind = np.dtype((">" if message.is_bigendian else "<") + format_)
    size = channels * kind.itemsize
    width = message.width * size
    step = message.step if message.step >= width else width
    data = np.frombuffer(message.data, np.uint8)
    if not width or not message.height or len(data) < step * (message.height - 1) + width:
        raise ValueError(f"{len(data)} bytes are too few for {message.width}x{message.height} pixels")
    shape, strides = (message.height, message.width, channels), (step, size, kind.itemsize)
    return np.ndarray(shape, kind, data, 0, strides)


def _bytes_of(deep: Pixels) -> Pixels:
    """Numbers of two bytes as those of one (cv_bridge.cpp: times 255 / 65535, to the nearest)."""
    import numpy as np

    return ((deep.astype(np.uint32) * 255 + 32767) // 65535).astype(np.uint8)


def _at(pixels: Pixels, rows: Any, columns: Any) -> Pixels:
    return pixels[rows[:, None], columns[None, :]]


def _video(pairs: Pixels, rows: Any, columns: Any, bright: int, blue_at: int, red_at: int) -> Pixels:
    """YUV in which two pixels share their colour differences, with RViz's whole-number factors."""
    import numpy as np

    columns = np.minimum(columns, max(0, pairs.shape[1] // 2 * 2 - 1))
    first = columns // 2 * 2
    luma = pairs[rows[:, None], columns[None, :], bright % 2].astype(np.int32)
    blue, red = (
        pairs[rows[:, None], np.minimum(first + at // 2, pairs.shape[1] - 1)[None, :], at % 2].astype(np.int32) - 128
        for at in (blue_at, red_at)
    )
    # Towards zero, as C divides.
    parts = [np.trunc(part / 1000) for part in (1403 * red, 344 * blue - 714 * red, 1770 * blue)]
    return (luma[..., None] + np.stack(parts, axis=2)).clip(0, 255).astype(np.uint8)
