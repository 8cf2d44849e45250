"""Encodings and conversions (cv_bridge/src/cv_bridge.cpp). Errors are RuntimeErrors with the real texts.

A number of OpenCV's for a kind of pixel is `depth + (channels - 1) * 8`, with the place in `DEPTHS` as depth.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from types import ModuleType

DEPTHS = {
    "8U": "uint8", "8S": "int8", "16U": "uint16", "16S": "int16", "32S": "int32", "32F": "float32", "64F": "float64",
}  # fmt: skip
"""OpenCV's kinds of numbers, in the order of their own numbers, and numpy's."""


class Encoding(NamedTuple):
    """What an encoding of `sensor_msgs/image_encodings.hpp` is: which colours, how many bits and channels."""

    colours: str
    bits: int
    channels: int


_CHANNELS = {"mono": 1, "bgr": 3, "rgb": 3, "bgra": 4, "rgba": 4}
_NAMED = {
    **{f"{name}{bits}": Encoding(name, bits, count) for name, count in _CHANNELS.items() for bits in (8, 16)},
    **{
        f"bayer_{order}{bits}": Encoding(f"bayer_{order}", bits, 1)
        for order in ("rggb", "bggr", "gbrg", "grbg")
        for bits in (8, 16)
    },
    "yuv422": Encoding("yuv422", 8, 2),
    "yuv422_yuy2": Encoding("yuv422_yuy2", 8, 2),
}
"""The encodings that say what the numbers mean."""
_PLAIN = re.compile(r"(8U|8S|16U|16S|32S|32F|64F)(?:C([0-9]+))?\Z")

_OPENCV = {"yuv422": "YUV2{to}_UYVY", "yuv422_yuy2": "YUV2{to}_YUY2"} | {
    f"bayer_{order}": f"Bayer{code}2{{to}}"
    for order, code in {"rggb": "BG", "bggr": "RG", "gbrg": "GR", "grbg": "GB"}.items()
}
"""Colours that only OpenCV converts: `cv2.COLOR_…`."""
_NAMES = {"mono": "GRAY", "rgb": "RGB", "bgr": "BGR", "rgba": "RGBA", "bgra": "BGRA"}
_WEIGHTS = {"r": 9798, "g": 19235, "b": 3735}
"""Brightness of the colours in 32768ths, as OpenCV has it (modules/imgproc/src/color_rgb.simd.hpp)."""


def opencv(what: str) -> ModuleType:
    """The module cv2. Raises RuntimeError, naming `what` needs it, if it isn't installed."""
    try:
        import cv2  # type: ignore[import-not-found,unused-ignore]
    except ImportError:
        text = f"{what} needs OpenCV, and Python has no module cv2: pip3 install opencv-python-headless"
        raise RuntimeError(text) from None
    module: ModuleType = cv2
    return module


def getCvType(encoding: str) -> int:
    """OpenCV's number for the pixels of an encoding. Raises RuntimeError."""
    known = _NAMED.get(encoding)
    if known is not None:
        return (0 if known.bits == 8 else 2) + (known.channels - 1) * 8
    plain = _PLAIN.match(encoding)
    if plain is None:
        raise RuntimeError(f"Unrecognized image encoding [{encoding}]")
    return tuple(DEPTHS).index(plain[1]) + (int(plain[2] or 1) - 1) * 8


def CV_MAT_CNWrap(number: int) -> int:
    """The channels of a kind of pixel."""
    return (number >> 3 & 511) + 1


def CV_MAT_DEPTHWrap(number: int) -> int:
    """The kind of numbers of a kind of pixel."""
    return number & 7


def _described(encoding: str) -> Encoding:
    if encoding in _NAMED:
        return _NAMED[encoding]
    plain = _PLAIN.match(encoding)
    if plain is None or plain[2] is None:
        raise RuntimeError(f"Unknown encoding {encoding}")
    return Encoding("", int(plain[1][:-1]), int(plain[2]))


def cvtColor2(image: Any, encoding_in: str, encoding_out: str) -> Any:
    """An image in another encoding; a copy if that is the same. Raises RuntimeError if there is no way."""
    import numpy as np

    if encoding_out in ("", encoding_in):
        return np.array(image)
    source, wanted = _described(encoding_in), _described(encoding_out)
    if not source.colours or not wanted.colours:
        _refuse_colours_of_numbers(source, wanted, encoding_in, encoding_out)
        return _in_depth(image, source, encoding_out)
    if wanted.colours not in _NAMES or (source.colours.startswith("bayer") and wanted.channels == 4):
        if source.colours != wanted.colours:
            raise RuntimeError(f"Unsupported conversion from [{encoding_in}] to [{encoding_out}]")
    elif source.colours in _OPENCV:
        cv2 = opencv(f"The conversion from [{encoding_in}] to [{encoding_out}]")
        image = cv2.cvtColor(image, getattr(cv2, "COLOR_" + _OPENCV[source.colours].format(to=_NAMES[wanted.colours])))
    elif source.colours != wanted.colours:
        image = _other_colours(image, source.colours, wanted.colours)
    return _in_depth(image, source, encoding_out)


def _refuse_colours_of_numbers(source: Encoding, wanted: Encoding, encoding_in: str, encoding_out: str) -> None:
    same = source.channels == wanted.channels
    if not source.colours and wanted.colours:
        text = f"[{encoding_in}] is not a color format. but [{encoding_out}] is. The conversion does not make sense"
        raise RuntimeError(text)
    if not source.colours and not same:
        raise RuntimeError(f"[{encoding_in}] and [{encoding_out}] do not have the same number of channel")
    if not same:
        raise RuntimeError(
            f"[{encoding_in}] is a color format but [{encoding_out}] is not so they must have the same OpenCV type, "
            "CV_8UC3, CV16UC1 ...."
        )


def _other_colours(image: Any, source: str, wanted: str) -> Any:
    """The channels in another order, with an opaque fourth or without it, or their brightness."""
    import numpy as np

    if wanted == "mono":
        parts = [image[..., source.index(colour)].astype(np.uint32) * weight for colour, weight in _WEIGHTS.items()]
        return ((sum(parts) + 16384) >> 15).astype(image.dtype)
    made = np.full((*image.shape[:2], len(wanted)), np.iinfo(image.dtype).max, image.dtype)
    for index, colour in enumerate(wanted):
        if source == "mono" and colour != "a":
            made[..., index] = image
        elif colour in source:
            made[..., index] = image[..., source.index(colour)]
    return made


def _in_depth(image: Any, source: Encoding, encoding_out: str) -> Any:
    """The numbers in the kind of another encoding: 8 and 16 bits are stretched, others rounded and kept in range."""
    import numpy as np

    kind = np.dtype(tuple(DEPTHS.values())[CV_MAT_DEPTHWrap(getCvType(encoding_out))])
    bits = _described(encoding_out).bits
    scale = {(8, 16): 257.0, (16, 8): 1 / 257.0}.get((source.bits, bits), 1.0)
    if scale == 1.0 and image.dtype == kind:
        return np.array(image)
    values = image * np.float32(scale) if image.dtype.itemsize <= 2 else image * np.float64(scale)
    if kind.kind == "f":
        return values.astype(kind)
    limits = np.iinfo(kind)
    return np.clip(np.rint(np.nan_to_num(values, nan=limits.min)), limits.min, limits.max).astype(kind)


def cvtColorForDisplay(
    source: Any,
    encoding_in: str,
    encoding_out: str,
    do_dynamic_scaling: bool = False,
    min_image_value: float = 0.0,
    max_image_value: float = 0.0,
    colormap: int = -1,
) -> Any:
    """An image of eight bits to look at. Raises RuntimeError if there is no way."""
    import numpy as np

    out = encoding_out or "bgr8"
    if out not in _NAMED or _NAMED[out].colours not in _NAMES or _NAMED[out].bits != 8:
        raise RuntimeError(
            "cv_bridge.cvtColorForDisplay() does not have an output encoding                that is color or mono, and has "
            "is bit in depth"
        )
    low, high = min_image_value, max_image_value
    if do_dynamic_scaling:
        finite = source[~np.isinf(source)]
        low, high = float(finite.min()), float(finite.max())
        if low == high:
            return np.full((*source.shape[:2], 3), 128, np.uint8)
    if low != high:
        if source.ndim != 2:
            raise RuntimeError(
                "cv_bridge.cvtColorForDisplay() scaling for images                with more than one channel is unsupported"
            )
        scaled = (source.astype(np.float64) - low) * (255.0 / (high - low))
        grey = np.clip(np.rint(np.nan_to_num(scaled, nan=0.0)), 0, 255).astype(np.uint8)
        if colormap == -1:
            return cvtColor2(grey, "mono8", out)
        coloured = opencv("A colormap").applyColorMap(grey, colormap)
        coloured[np.isnan(source)] = 0
        return cvtColor2(coloured, "bgr8", out)
    named = {"16UC1": "mono16"}.get(encoding_in, encoding_in)
    if named == out:
        return source
    try:
        return cvtColor2(source, named, out)
    except RuntimeError as error:
        raise RuntimeError(
            f"cv_bridge.cvtColorForDisplay() while trying to convert image from '{encoding_in}' to '{out}' an exception was "
            f"thrown ({error})"
        ) from None
