"""cv_bridge with numpy alone: what OpenCV 4.14 gave (checksums of it), the real words of refusals, and what needs OpenCV."""

from __future__ import annotations

import sys
import zlib
from array import array
from types import ModuleType
from typing import Any

import cv_bridge
import numpy as np
import pytest
from cv_bridge import CvBridge, CvBridgeError, getCvType
from cv_bridge.boost.cv_bridge_boost import cvtColor2
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import Header

from tests.support.folded import folded

CHANNELS = {"mono": 1, "rgb": 3, "bgr": 3, "rgba": 4, "bgra": 4}
SUMS = {
    ("mono", 8): "- cbf2aac8 cbf2aac8 809c1dee 809c1dee",
    ("rgb", 8): "bc2e480d - f47cbeca cf14309a 9b15c7f0",
    ("bgr", 8): "e3d5a448 f47cbeca - 9b15c7f0 cf14309a",
    ("rgba", 8): "a9c6fcfa bd52c78e 28966810 - dda3c576",
    ("bgra", 8): "2ee8d82f 28966810 bd52c78e dda3c576 -",
    ("mono", 16): "- 23a0ed28 23a0ed28 21bd42ee 21bd42ee",
    ("rgb", 16): "95a942cb - b444a3d4 54b9f747 4c10d3df",
    ("bgr", 16): "df059734 b444a3d4 - 4c10d3df 54b9f747",
    ("rgba", 16): "8d640d4d 1d65fea5 24341b5b - 6c9acd7d",
    ("bgra", 16): "9756ff56 24341b5b 1d65fea5 6c9acd7d -",
}
"""Colours and bits of a ramp -> crc32 of what `cv2.cvtColor` makes of it, in the order of CHANNELS."""


@pytest.fixture(autouse=True)
def no_opencv(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cv2", None)


def ramp(bits: int, channels: int) -> Any:
    numbers = (np.arange(24 * 32 * channels, dtype=np.uint32) * 2654435761 >> 7) % (1 << bits)
    image = numbers.astype(np.uint8 if bits == 8 else np.uint16).reshape(24, 32, channels)
    return image[..., 0] if channels == 1 else image


@folded("colours, bits", SUMS)
def test_colours_become_others_as_opencv_makes_them(colours: str, bits: int) -> None:
    image = ramp(bits, CHANNELS[colours])
    message = CvBridge().cv2_to_imgmsg(image, f"{colours}{bits}")
    for wanted, crc in zip(CHANNELS, SUMS[colours, bits].split(), strict=True):
        made = CvBridge().imgmsg_to_cv2(message, f"{wanted}{bits}")
        assert made.shape == image.shape[:2] + (() if wanted == "mono" else (CHANNELS[wanted],))
        if crc == "-":
            assert (made == image).all()
        else:
            assert f"{zlib.crc32(np.ascontiguousarray(made).tobytes()):08x}" == crc, wanted


def test_other_depths_are_stretched() -> None:
    deep = np.array([[0, 128, 129, 257, 65407, 65535]], np.uint16)
    assert cvtColor2(deep, "mono16", "mono8").tolist() == [[0, 0, 1, 1, 255, 255]]
    assert cvtColor2(np.array([[0, 1, 255]], np.uint8), "mono8", "mono16").tolist() == [[0, 257, 65535]]
    grey = cvtColor2(np.full((1, 1, 3), 65535, np.uint16), "bgr16", "mono8")
    assert (grey.tolist(), grey.dtype) == ([[255]], np.uint8)
    assert cvtColor2(np.array([[0.4, 300.0, np.nan]], np.float32), "32FC1", "8UC1").tolist() == [[0, 255, 0]]


def test_a_message_is_read_with_padding_and_in_either_byte_order() -> None:
    rows = np.array([[1, 2, 99], [3, 4, 99]], np.uint16)
    for order in "<>":
        message = Image(height=2, width=2, step=6, encoding="16UC1", is_bigendian=int(order == ">"))
        message.data = array("B", rows.astype(order + "u2").tobytes())
        image = CvBridge().imgmsg_to_cv2(message)
        assert image.tolist() == [[1, 2], [3, 4]] and image.dtype == np.dtype(np.uint16) and image.dtype.isnative
        image[0, 0] = 7  # it is the caller's own
        assert message.data[0 if order == "<" else 1] == 1
    back = CvBridge().cv2_to_imgmsg(rows.astype(">u2"), header=Header(frame_id="camera"))
    assert (back.encoding, back.step, back.is_bigendian, back.header.frame_id) == ("16UC1", 6, 1, "camera")
    message.height = 9
    with pytest.raises(TypeError, match="buffer is too small"):
        CvBridge().imgmsg_to_cv2(message)


@folded(
    "source, wanted, text",
    [
        ("8UC1", "mono8", r"[8UC1] is not a color format. but [mono8] is. The conversion does not make sense"),
        ("8UC3", "32FC1", "[8UC3] and [32FC1] do not have the same number of channel"),
        ("bgr8", "8UC1", ("[bgr8] is a color format but [8UC1] is not so they must have the same OpenCV type, CV_8UC3, "
         "CV16UC1 ....")),
        ("bgr8", "bayer_rggb8", "Unsupported conversion from [bgr8] to [bayer_rggb8]"),
        ("bayer_rggb8", "bgra8", "Unsupported conversion from [bayer_rggb8] to [bgra8]"),
        ("bgr8", "brg8", "Unknown encoding brg8"),
        ("jpeg", "bgr8", "Unrecognized image encoding [jpeg]"),
    ],
)  # fmt: skip
def test_what_cannot_be_converted_is_refused_in_the_real_words(source: str, wanted: str, text: str) -> None:
    message = Image(height=1, width=1, step=8, encoding=source, data=bytes(8))
    with pytest.raises(CvBridgeError) as refused:
        CvBridge().imgmsg_to_cv2(message, wanted)
    assert str(refused.value) == text


def test_a_wrong_encoding_for_an_array_is_refused() -> None:
    bridge, image = CvBridge(), np.zeros((2, 3, 3), np.uint8)
    with pytest.raises(CvBridgeError, match=r"^encoding specified as mono8, but image has incompatible type 8UC3$"):
        bridge.cv2_to_imgmsg(image, "mono8")
    with pytest.raises(KeyError, match="bool"):
        bridge.cv2_to_imgmsg(image.astype(bool))
    for wrong in ([[1, 2]], None):
        with pytest.raises(TypeError, match=r"^Your input type is not a numpy array$"):
            bridge.cv2_to_imgmsg(wrong)


def test_the_tables_of_types_are_those_of_opencv() -> None:
    bridge = CvBridge()
    assert [getCvType(name) for name in ("bgr8", "mono16", "rgba16", "32FC1", "64FC4", "8U", "yuv422")] == [
        16, 2, 26, 5, 30, 0, 8,
    ]  # fmt: skip
    assert bridge.encoding_to_dtype_with_channels("16SC2") == ("int16", 2)
    assert bridge.dtype_with_channels_to_cvtype2(np.dtype(np.float32), 3) == "32FC3"
    assert (bridge.cvtype_to_name[21], bridge.numpy_type_to_cvtype["8U"]) == ("32FC3", "uint8")
    assert cv_bridge.cvtColorForDisplay(np.array([[0.0, 2.0]], np.float32), "32FC1", "mono8", True).tolist() == [
        [0, 255]
    ]


@folded("encoding, what", [("yuv422", "yuv422"), ("bayer_rggb8", "bayer_rggb8")])
def test_what_needs_opencv_says_so(encoding: str, what: str) -> None:
    message = Image(height=2, width=2, step=4, encoding=encoding, data=bytes(8))
    with pytest.raises(
        CvBridgeError, match=rf"\[{what}\] to \[bgr8\] needs OpenCV.*pip3 install opencv-python-headless$"
    ):
        CvBridge().imgmsg_to_cv2(message, "bgr8")
    assert CvBridge().imgmsg_to_cv2(message).dtype == np.uint8  # as it is, it can be had


def test_compressed_images_need_opencv_and_use_it(monkeypatch: pytest.MonkeyPatch) -> None:
    bridge, image = CvBridge(), np.zeros((2, 2, 3), np.uint8)
    for convert in (
        lambda: bridge.cv2_to_compressed_imgmsg(image),
        lambda: bridge.compressed_imgmsg_to_cv2(CompressedImage()),
    ):
        with pytest.raises(CvBridgeError, match="CompressedImage needs OpenCV"):
            convert()
    cv2: Any = ModuleType("cv2")
    cv2.IMREAD_UNCHANGED = -1
    cv2.imencode = lambda suffix, pixels: (True, np.frombuffer(suffix.encode() + pixels.tobytes(), np.uint8))
    cv2.imdecode = lambda data, flags: data[0, 4:].reshape(2, 2, 3)
    monkeypatch.setitem(sys.modules, "cv2", cv2)
    image[..., 2] = 255
    message = bridge.cv2_to_compressed_imgmsg(image, "png")
    assert (message.format, bytes(message.data[:4])) == ("png", b".png")
    assert bridge.compressed_imgmsg_to_cv2(message, "rgb8")[0, 0].tolist() == [255, 0, 0]
