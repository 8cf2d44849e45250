"""What the image view makes of messages: encodings, rotation, zoom, ranges, and what cannot be shown."""

from __future__ import annotations

import io
import struct
import zlib
from itertools import product
from typing import Any

import numpy as np
import pytest
from sensor_msgs.msg import CompressedImage, Image

from day6_core.ros.programs.rqt_image_view.decoding import ImageRequest, Undecodable, picture_of
from tests.support.folded import folded

RED, GREEN, BLUE, WHITE = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)
FOUR = [[RED, GREEN], [BLUE, WHITE]]


def image(encoding: str, data: Any, *, step: int | None = None, big: int = 0) -> Image:
    """A message of an array: rows x columns, or rows x columns x channels."""
    data = np.ascontiguousarray(data)
    rows, columns = data.shape[:2]
    width = data.nbytes // rows
    return Image(
        height=rows, width=columns, encoding=encoding, step=step or width, is_bigendian=big, data=data.tobytes()
    )


def seen(message: Any, width: int = 2, height: int = 2, **options: Any) -> list[Any]:
    return picture_of(message, ImageRequest(width, height, **options)).pixels.tolist()


def as_lists(colours: Any) -> list[Any]:
    return np.array(colours).tolist()


def test_colours_come_in_any_order_of_bytes() -> None:
    four = np.array(FOUR, np.uint8)
    solid = np.full((2, 2, 1), 9, np.uint8)
    assert seen(image("rgb8", four)) == as_lists(FOUR)
    assert seen(image("bgr8", four[..., ::-1])) == as_lists(FOUR)
    assert seen(image("rgba8", np.concatenate([four, solid], axis=2))) == as_lists(FOUR)
    assert seen(image("bgra8", np.concatenate([four[..., ::-1], solid], axis=2))) == as_lists(FOUR)
    assert seen(image("mono8", np.array([[0, 7], [8, 255]], np.uint8)))[1] == [[8] * 3, [255] * 3]


def test_a_bayer_pattern_gives_each_square_of_four_its_colour() -> None:
    pattern = np.zeros((2, 4), np.uint8)
    pattern[0, 0], pattern[0, 1], pattern[1, 0], pattern[1, 1] = 200, 100, 50, 20
    assert seen(image("bayer_rggb8", pattern), 4, 2)[0][:2] == [[200, 75, 20]] * 2
    assert seen(image("bayer_bggr8", pattern), 4, 2)[1][:2] == [[20, 75, 200]] * 2
    assert seen(image("bayer_grbg8", pattern), 4, 2)[0][0] == [100, (200 + 20) // 2, 50]


def test_colours_of_sixteen_bits_are_shown_by_eight_of_them() -> None:
    """cv_bridge.cpp: 255 / 65535, to the nearest."""
    deep = np.array(FOUR, np.uint16) * 257
    assert seen(image("rgb16", deep)) == seen(image("bgr16", deep[..., ::-1])) == as_lists(FOUR)
    solid = np.full((2, 2, 1), 9, np.uint16)
    assert seen(image("rgba16", np.concatenate([deep, solid], axis=2))) == as_lists(FOUR)
    assert seen(image("bgra16", np.concatenate([deep[..., ::-1], solid], axis=2).astype(">u2"), big=1)) == as_lists(
        FOUR
    )
    assert seen(image("rgb16", np.array([[[128, 129, 65535]]], np.uint16)), 1, 1) == [[[0, 1, 255]]]
    pattern = np.zeros((2, 2), np.uint8)
    pattern[0, 0], pattern[0, 1], pattern[1, 0], pattern[1, 1] = 200, 100, 50, 20
    for order in ("rggb", "bggr", "grbg", "gbrg"):
        eight = seen(image(f"bayer_{order}8", pattern))
        assert seen(image(f"bayer_{order}16", pattern.astype(np.uint16) * 257)) == eight


def test_two_pixels_of_yuv_share_their_colours() -> None:
    grey = np.array([[[128, 50], [128, 200]]], np.uint8)
    assert seen(image("yuv422", grey), 2, 1) == [[[50] * 3, [200] * 3]]
    assert seen(image("yuv422_yuy2", grey[..., ::-1]), 2, 1) == [[[50] * 3, [200] * 3]]


def test_distances_are_white_at_the_greatest_range_or_at_the_greatest_there_is() -> None:
    metres = image("32FC1", np.array([[0, 5], [10, 20]], np.float32))
    assert [pixel[0] for row in seen(metres) for pixel in row] == [0, 128, 255, 255]
    assert [pixel[0] for row in seen(metres, dynamic_range=True) for pixel in row] == [0, 64, 128, 255]
    millimetres = image("16UC1", np.array([[0, 5000], [10000, 65535]], np.uint16))
    assert [pixel[0] for row in seen(millimetres) for pixel in row] == [0, 128, 255, 255]
    big = image("16UC1", np.array([[0, 5000], [10000, 65535]], ">u2"), big=1)
    assert seen(big) == seen(millimetres)


def test_what_is_no_number_is_black_and_one_value_is_grey() -> None:
    odd = image("32FC1", np.array([[np.nan, np.inf], [-np.inf, 1e38]], np.float32))
    assert [pixel[0] for row in seen(odd) for pixel in row] == [0, 255, 0, 255]
    assert np.array(seen(odd, dynamic_range=True)).shape == (2, 2, 3)
    assert seen(image("32FC1", np.ones((2, 2), np.float32)), dynamic_range=True)[0][0] == [128] * 3
    assert seen(image("32FC1", np.full((2, 2), np.nan, np.float32)), dynamic_range=True)[0][0] == [0] * 3


def test_an_image_is_turned_clockwise_and_its_pixels_are_still_known() -> None:
    message = image("rgb8", np.array(FOUR, np.uint8))
    assert seen(message, rotation=1) == as_lists([[BLUE, RED], [WHITE, GREEN]])
    assert seen(message, rotation=2) == as_lists([[WHITE, BLUE], [GREEN, RED]])
    assert seen(message, rotation=3) == as_lists([[GREEN, WHITE], [RED, BLUE]])
    wide = picture_of(image("mono8", np.zeros((2, 6), np.uint8)), ImageRequest(6, 6, rotation=1))
    assert (wide.image_width, wide.image_height, wide.pixels.shape) == (2, 6, (6, 2, 3))


def test_an_image_is_fitted_in_or_shown_pixel_by_pixel() -> None:
    message = image("mono8", np.arange(100, dtype=np.uint8).reshape(10, 10))
    fitted = picture_of(message, ImageRequest(5, 20))
    assert fitted.pixels.shape == (5, 5, 3) and list(fitted.columns) == [1, 3, 5, 7, 9]
    assert picture_of(message, ImageRequest(40, 20)).pixels.shape == (20, 20, 3)
    part = picture_of(message, ImageRequest(3, 2, zoom_1=True, left=4, top=99))
    assert part.pixels[..., 0].tolist() == [[84, 85, 86], [94, 95, 96]]


def test_rows_may_be_padded() -> None:
    padded = np.zeros((2, 8), np.uint8)
    padded[:, :6] = np.array(FOUR, np.uint8).reshape(2, 6)
    message = image("rgb8", padded, step=8)
    message.width = 2
    assert seen(message) == as_lists(FOUR)


@pytest.mark.parametrize(
    ("message", "told"),
    [
        (
            image("8UC3", np.zeros((2, 2, 3), np.uint8)),
            "could not convert image from '8UC3' to 'rgb8' ([8UC3] is not a",
        ),
        (image("64FC1", np.zeros((2, 2))), "[64FC1] is not a color format"),
        (image("8UC5", np.zeros((2, 2, 5), np.uint8)), "[8UC5] is not a color format"),
        (image("nv21", np.zeros((3, 2), np.uint8)), "Unrecognized image encoding [nv21]"),
        (
            image("rgb8", np.zeros((4, 2, 3), np.uint8), step=2),
            "(Image is wrongly formed: step < width * byte_depth * num_channels  or  2 != 2 * 1 * 3)",
        ),
        (image("\x1b[2J", np.zeros((2, 2), np.uint8)), "an exception was thrown (Unrecognized image encoding ["),
        (Image(height=10**9, width=10**9, encoding="rgb8", step=2**32 - 1), "size  or  1000000000 * 4294967295 != 0)"),
        (
            Image(height=2, width=2, encoding="rgb8", step=6, data=[0] * 11),
            "(Image is wrongly formed: height * step != size  or  2 * 6 != 11)",
        ),
        (Image(encoding="mono8"), "0x0 pixels"),
        (Image(height=5, width=0, encoding="32FC1"), "0x5 pixels"),
        (CompressedImage(format="jpeg", data=[1, 2, 3]), "cannot identify"),
        (CompressedImage(format="png", data=[]), "cannot identify"),
    ],
)
def test_what_cannot_be_shown_is_told_in_the_words_of_the_real_one(message, told) -> None:
    with pytest.raises(Undecodable) as error:
        picture_of(message, ImageRequest(20, 20))
    assert told in str(error.value)


@folded(
    "encoding, rotation, size",
    product(
        ["rgb8", "mono8", "bayer_rggb8", "yuv422", "yuv422_yuy2", "16UC1", "32FC1", "mono16"],
        range(4),
        [(1, 1), (1, 7), (7, 1), (5, 3)],
    ),
)
def test_odd_sizes_have_pixels_too(encoding, rotation, size) -> None:
    width, height = size
    bytes_each = {"rgb8": 3, "32FC1": 4, "mono8": 1, "bayer_rggb8": 1}.get(encoding, 2)
    message = Image(height=height, width=width, encoding=encoding, step=width * bytes_each)
    message.data = bytes(width * bytes_each * height)
    for view in (ImageRequest(9, 9, rotation=rotation), ImageRequest(2, 2, True, 3, 3, rotation=rotation)):
        assert picture_of(message, view).pixels.shape[2] == 3


def test_compressed_images_are_decoded() -> None:
    from PIL import Image as Picture

    for form in ("png", "jpeg"):
        file = io.BytesIO()
        Picture.new("RGB", (640, 480), (200, 10, 10)).save(file, form)
        found = picture_of(CompressedImage(format=form, data=file.getvalue()), ImageRequest(32, 24))
        assert (found.image_width, found.image_height, found.pixels.shape) == (640, 480, (24, 32, 3))
        assert abs(int(found.pixels[5, 5, 0]) - 200) < 5


def black_png(width: int, height: int) -> bytes:
    """A picture of one bit per pixel, made without having its pixels."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    packed = zlib.compressobj()
    row = bytes(1 + (width + 7) // 8)
    data = b"".join(packed.compress(row) for _ in range(height)) + packed.flush()
    header = struct.pack(">IIBBBBB", width, height, 1, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def test_a_compressed_bomb_is_refused() -> None:
    small = picture_of(CompressedImage(format="png", data=black_png(20, 10)), ImageRequest(32, 24))
    assert (small.image_width, small.image_height) == (20, 10)
    with pytest.raises(Undecodable):
        picture_of(CompressedImage(format="png", data=black_png(20_000, 20_000)), ImageRequest(32, 24))
