"""Images of messages, in as many pixels as are shown: only those are read out of a message, however large it is."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

IMAGE = "sensor_msgs/msg/Image"

Picture = tuple[tuple[int, ...], ...]
"""Rows of pixels 0xRRGGBB."""

_COLOURED = {"rgb8": (3, (0, 1, 2)), "bgr8": (3, (2, 1, 0)), "rgba8": (4, (0, 1, 2)), "bgra8": (4, (2, 1, 0))}
"""Encoding -> bytes of a pixel, and which of them are red, green and blue (sensor_msgs/image_encodings.hpp)."""
_GREY = {"mono8", "8UC1"}
_MEASURED = {"mono16": "H", "16UC1": "H", "32FC1": "f"}
"""Encodings without a natural black and white, as struct's letters."""


class NoPicture(ValueError):
    """A message that can't be shown as an image, in the words of rqt_bag."""


def picture(message: Any, columns: int, rows: int) -> Picture:
    """The image of a sensor_msgs/Image in at most so many pixels, in its proportions, each the nearest of the image's own.

    Raises NoPicture.
    """
    width, height, encoding = message.width, message.height, message.encoding
    if not width or not height:
        raise NoPicture(f"Error loading image: {width}x{height}")
    across = max(1, min(columns, width, round(rows * width / height)))
    down = max(1, min(rows, height, round(columns * height / width)))
    size, read = _reader(encoding, bool(message.is_bigendian))
    step = message.step if message.step >= width * size else width * size
    data = memoryview(message.data).cast("B") if len(message.data) else memoryview(b"")
    if len(data) < step * (height - 1) + width * size:
        raise NoPicture(f"Can't convert image: {len(data)} bytes are too few for {width}x{height} pixels")
    lines = [(2 * line + 1) * height // (2 * down) * step for line in range(down)]
    places = [(2 * column + 1) * width // (2 * across) * size for column in range(across)]
    values = [[read(data, line + place) for place in places] for line in lines]
    return tuple(map(tuple, _as_greys(values) if encoding in _MEASURED else values))


def _reader(encoding: str, big: bool) -> tuple[int, Callable[[memoryview, int], Any]]:
    """Bytes of a pixel, and what reads one."""
    if encoding in _COLOURED:
        size, (red, green, blue) = _COLOURED[encoding]
        return size, lambda data, at: data[at + red] << 16 | data[at + green] << 8 | data[at + blue]
    if encoding in _GREY or (encoding.startswith("bayer_") and encoding.endswith("8")):
        return 1, lambda data, at: data[at] * 0x10101
    if encoding in _MEASURED:
        number = struct.Struct((">" if big else "<") + _MEASURED[encoding])
        return number.size, lambda data, at: number.unpack_from(data, at)[0]
    raise NoPicture(f"Unsupported image format: {encoding}")


def _as_greys(values: list[list[float]]) -> list[list[int]]:
    """Numbers as greys between the least and the greatest; what is no number is black."""
    finite = [value for line in values for value in line if abs(value) < float("inf")]
    least, most = min(finite, default=0.0), max(finite, default=1.0)
    scale = 255 / ((most - least) or 1.0)
    return [
        [round((value - least) * scale) * 0x10101 if abs(value) < float("inf") else 0 for value in line]
        for line in values
    ]
