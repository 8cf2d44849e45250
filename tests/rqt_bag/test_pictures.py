"""Images of messages in as many pixels as are shown."""

from __future__ import annotations

import struct

import pytest
from sensor_msgs.msg import Image

from day6_core.ros.programs.rqt_bag.model.pictures import NoPicture, picture


def image(encoding, width, height, data, **fields):
    return Image(encoding=encoding, width=width, height=height, data=data, **fields)


@pytest.mark.parametrize(
    ("encoding", "data", "colour"),
    (
        ("rgb8", bytes([1, 2, 3]), 0x010203),
        ("bgr8", bytes([1, 2, 3]), 0x030201),
        ("rgba8", bytes([1, 2, 3, 9]), 0x010203),
        ("bgra8", bytes([1, 2, 3, 9]), 0x030201),
        ("mono8", bytes([7]), 0x070707),
        ("bayer_rggb8", bytes([7]), 0x070707),
    ),
)
def test_the_colours_of_an_encoding(encoding, data, colour):
    assert picture(image(encoding, 1, 1, data), 10, 10) == ((colour,),)


def test_measured_values_are_greys_between_the_least_and_the_greatest():
    data = struct.pack("<4f", 1.0, 3.0, float("nan"), 2.0)
    assert picture(image("32FC1", 4, 1, data), 4, 4) == ((0, 0xFFFFFF, 0, 0x808080),)
    data = struct.pack(">2H", 5, 10)
    assert picture(image("16UC1", 2, 1, data, is_bigendian=1), 4, 4) == ((0, 0xFFFFFF),)


def test_a_large_image_keeps_its_proportions_and_its_padding_is_skipped():
    width, height, step = 640, 480, 2000
    data = bytearray(step * height)
    for line in range(height):
        data[line * step + 320 * 3 : line * step + 640 * 3] = b"\xff" * 960
    found = picture(image("rgb8", width, height, bytes(data), step=step), 16, 100)
    assert (len(found), len(found[0])) == (12, 16)
    assert found[0] == (0,) * 8 + (0xFFFFFF,) * 8


@pytest.mark.parametrize(
    ("message", "reason"),
    (
        (image("rgb8", 4, 4, b"123"), "3 bytes are too few for 4x4 pixels"),
        (image("jpeg", 1, 1, b"1"), "Unsupported image format: jpeg"),
        (image("rgb8", 0, 0, b""), "0x0"),
        (image("rgb8", 4_000_000_000, 4_000_000_000, b"1"), "too few"),
    ),
)
def test_what_is_no_image_is_told(message, reason):
    with pytest.raises(NoPicture, match=reason):
        picture(message, 10, 10)
