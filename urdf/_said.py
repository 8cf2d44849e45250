"""Collects what the parser says while it walks the elements."""

from __future__ import annotations

from day6_tui.urdf._values import ParseError, PoseError, to_pose
from day6_tui.urdf.model import Pose
from day6_tui.urdf.report import Diagnostic
from day6_tui.urdf.xmlreader import Element, Lines


class Refused(Exception):
    """The element that is being read cannot be used; what is wrong has been said."""


class Said:
    """The messages so far, in order; `file` is the source file of urdfdom that speaks ('model', 'link', 'joint')."""

    def __init__(self, text: str) -> None:
        self._lines = Lines(text)
        self.diagnostics: list[Diagnostic] = []

    def error(self, file: str, source_line: int, text: str, element: Element | None = None, offset: int = -1) -> None:
        self._say("Error", file, source_line, text, element, offset)

    def warning(self, file: str, source_line: int, text: str, element: Element | None = None) -> None:
        self._say("Warning", file, source_line, text, element, -1)

    def refuse(self, file: str, source_line: int, text: str, element: Element | None = None) -> Refused:
        """Say it as an error and return the exception to raise."""
        self.error(file, source_line, text, element)
        return Refused(text)

    def pose(self, element: Element) -> Pose:
        """Return the pose of an <origin>. Raises Refused."""
        try:
            return to_pose(element)
        except PoseError as error:
            raise self.refuse("pose", error.source_line, str(error), element) from error

    def _say(self, level: str, file: str, number: int, text: str, element: Element | None, offset: int) -> None:
        if element is not None:
            offset = element.offset
        line, column = self._lines.at(offset) if offset >= 0 else (0, 0)
        self.diagnostics.append(Diagnostic(level, text, file, number, line, column))


__all__ = ["ParseError", "Refused", "Said"]
