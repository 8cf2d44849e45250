"""Collects the parser's messages while it reads the elements."""

from __future__ import annotations

from day6_urdf.model import Pose
from day6_urdf.report import Diagnostic
from day6_urdf.values import PoseError, to_pose
from day6_urdf.xmlreader import Element, Lines

Version = tuple[int, int]
OLDEST: Version = (1, 0)
QUATERNIONS = CAPSULES = (1, 1)
"""Where `quat_xyzw` and <capsule> begin (urdfdom#235, #238)."""
WIDER_LIMITS = (1, 2)
"""Where acceleration, deceleration and jerk begin, and limits may be left out (urdfdom#212, #249)."""


class Refused(Exception):
    """An element cannot be used; the reason is among the diagnostics."""


class Diagnostics:
    """The messages so far, in order. `file` is the source file in urdfdom of a message ('model', 'link', 'joint').

    `newest` is the version of URDF that this urdfdom reads, `version` that of the description.
    """

    def __init__(self, text: str, newest: Version = OLDEST) -> None:
        self._lines = Lines(text)
        self.newest = newest
        self.version = OLDEST
        self.all: list[Diagnostic] = []

    def error(self, file: str, source_line: int, text: str, element: Element | None = None, offset: int = -1) -> None:
        """Add an error about an element, or about an offset in the text."""
        self._add("Error", file, source_line, text, element, offset)

    def warning(self, file: str, source_line: int, text: str, element: Element | None = None) -> None:
        """Add a warning about an element."""
        self._add("Warning", file, source_line, text, element, -1)

    def refuse(self, file: str, source_line: int, text: str, element: Element | None = None) -> Refused:
        """Add an error and return the exception to raise."""
        self.error(file, source_line, text, element)
        return Refused(text)

    def pose(self, element: Element) -> Pose:
        """Return the pose of an <origin>.

        Raises:
            Refused: the element is malformed.
        """
        if "quat_xyzw" in element.attributes and self.version < QUATERNIONS <= self.newest:
            text = "Ignoring quat_xyzw attribute requiring URDF version 1.1 since specified version is 1.0."
            self.warning("pose", 113, text, element)
        try:
            return to_pose(element, quaternions=self.version >= QUATERNIONS)
        except PoseError as error:
            raise self.refuse("pose", error.source_line, str(error), element) from error

    def _add(self, level: str, file: str, number: int, text: str, element: Element | None, offset: int) -> None:
        if element is not None:
            offset = element.offset
        line, column = self._lines.at(offset) if offset >= 0 else (0, 0)
        self.all.append(Diagnostic(level, text, file, number, line, column))
