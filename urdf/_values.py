"""Numbers and vectors of URDF attributes, accepted and refused as urdfdom_headers does (C++ streams, "C" locale)."""

from __future__ import annotations

import math
import re

from day6_tui.urdf.model import Pose, Vector
from day6_tui.urdf.xmlreader import Element

# What `stream >> double` of libstdc++ takes whole: no nan, no inf, no hexadecimal; space may stand before, not after.
_DOUBLE = re.compile(r"[ \t\n\v\f\r]*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\Z")


class ParseError(Exception):
    """A value urdfdom refuses; the text is its ParseError's."""


def to_double(text: str) -> float:
    """Return the number. Raises ParseError (also for numbers too large for a double, as the stream does)."""
    match = _DOUBLE.match(text)
    value = float(match.group(1)) if match else math.inf
    if math.isinf(value):
        raise ParseError("Failed converting string to double")
    return value


def to_vector(text: str) -> Vector:
    """Return three numbers separated by blanks. Raises ParseError."""
    numbers = _split(text, "vector value")
    if len(numbers) != 3:
        raise ParseError(f"Parser found {len(numbers)} elements but 3 expected while parsing vector [{text}]")
    return numbers[0], numbers[1], numbers[2]


def to_color(text: str) -> tuple[float, float, float, float]:
    """Return red, green, blue, alpha. A wrong count is opaque black, as in urdfdom. Raises ParseError."""
    numbers = _split(text, "color value", 0.0, 1.0)
    if len(numbers) != 4:
        return 0.0, 0.0, 0.0, 1.0
    return numbers[0], numbers[1], numbers[2], numbers[3]


def to_pose(element: Element) -> Pose:
    """Return the pose of an <origin>. Raises PoseError."""
    xyz: Vector = (0.0, 0.0, 0.0)
    rpy: Vector = (0.0, 0.0, 0.0)
    if "xyz" in element.attributes:
        try:
            xyz = to_vector(element.attributes["xyz"])
        except ParseError as error:
            raise PoseError(str(error), 104) from error
    if "rpy" in element.attributes:
        try:
            rpy = to_vector(element.attributes["rpy"])
        except ParseError as error:
            raise PoseError(str(error), 116) from error
    return Pose.from_rpy(xyz, rpy)


class PoseError(ParseError):
    """A malformed <origin>; `source_line` is the line of urdfdom's pose.cpp that says so."""

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
        if not least <= number <= most:  # the same words for a colour out of range: urdfdom catches its own error
            raise ParseError(f"Unable to parse component [{piece}] to a double (while parsing a {what})")
        numbers.append(number)
    return numbers
