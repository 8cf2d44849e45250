"""Parses numbers and vectors in URDF attributes as urdfdom_headers does (C++ streams, "C" locale)."""

from __future__ import annotations

import math
import re

from day6_urdf.model import Pose, Quaternion, Vector, unit
from day6_urdf.xmlreader import Element

# The texts `stream >> double` of libstdc++ reads completely: no nan, inf or hexadecimal; space is allowed before, not after.
_DOUBLE = re.compile(r"[ \t\n\v\f\r]*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\Z")


class ParseError(Exception):
    """A value urdfdom refuses; the message is that of its ParseError."""


def to_double(text: str) -> float:
    """Parse a number.

    Raises:
        ParseError: it is not a number, or too large for a double, as for the stream.
    """
    match = _DOUBLE.match(text)
    value = float(match.group(1)) if match else math.inf
    if math.isinf(value):
        raise ParseError("Failed converting string to double")
    return value


def to_vector(text: str) -> Vector:
    """Parse three numbers separated by spaces.

    Raises:
        ParseError: there are not exactly three numbers.
    """
    numbers = _split(text, "vector value")
    if len(numbers) != 3:
        raise ParseError(f"Parser found {len(numbers)} elements but 3 expected while parsing vector [{text}]")
    return numbers[0], numbers[1], numbers[2]


def to_quaternion(text: str) -> Quaternion:
    """Parse x, y, z and w; the result has length 1.

    Raises:
        ParseError: there are not exactly four numbers.
    """
    numbers = _split(text, "vector value")
    if len(numbers) != 4:
        raise ParseError(f"Parser found {len(numbers)} elements but 4 expected while parsing vector [{text}]")
    return unit((numbers[0], numbers[1], numbers[2], numbers[3]))


def to_color(text: str) -> tuple[float, float, float, float]:
    """Parse red, green, blue and alpha, each 0..1. A wrong count gives opaque black, as in urdfdom.

    Raises:
        ParseError: a component is not a number from 0 to 1.
    """
    numbers = _split(text, "color value", 0.0, 1.0)
    if len(numbers) != 4:
        return 0.0, 0.0, 0.0, 1.0
    return numbers[0], numbers[1], numbers[2], numbers[3]


def to_pose(element: Element, *, quaternions: bool = False) -> Pose:
    """Return the pose of an <origin>: metres, and fixed-axis roll, pitch, yaw in radians, or a quaternion if those are read.

    Raises:
        PoseError: an attribute is malformed.
    """
    xyz: Vector = (0.0, 0.0, 0.0)
    rpy: Vector = (0.0, 0.0, 0.0)
    quaternion = element.attributes.get("quat_xyzw") if quaternions else None
    if "xyz" in element.attributes:
        try:
            xyz = to_vector(element.attributes["xyz"])
        except ParseError as error:
            raise PoseError(str(error), 104) from error
    if quaternion is not None and "rpy" in element.attributes:
        raise PoseError("Both rpy and quat_xyzw orientations are defined. Use either one or the other.", 116)
    if quaternion is not None:
        try:
            return Pose(xyz, to_quaternion(quaternion))
        except ParseError as error:
            raise PoseError(str(error), 136) from error
    if "rpy" in element.attributes:
        try:
            rpy = to_vector(element.attributes["rpy"])
        except ParseError as error:
            raise PoseError(str(error), 116) from error
    return Pose.from_rpy(xyz, rpy)


class PoseError(ParseError):
    """A malformed <origin>; `source_line` is the line of the message in urdfdom's pose.cpp."""

    def __init__(self, text: str, source_line: int) -> None:
        super().__init__(text)
        self.source_line = source_line


def _split(text: str, what: str, least: float = -math.inf, most: float = math.inf) -> list[float]:
    numbers = []
    for piece in filter(None, text.split(" ")):
        try:
            number = to_double(piece)
        except ParseError:
            number = math.nan
        if not least <= number <= most:  # the same message for a colour out of range: urdfdom catches its own error
            raise ParseError(f"Unable to parse component [{piece}] to a double (while parsing a {what})")
        numbers.append(number)
    return numbers
