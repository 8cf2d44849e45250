"""Loads a robot from a description.

There are two functions, and a test keeps their results equal: `parse_robot` returns the robot read by our own check, at once
and without numpy, for robot_state_publisher and the commands; `load_robot` passes the checked description to yourdfpy, for
views (its first call takes some tenths of a second: call it from a thread).
"""

from __future__ import annotations

import logging
import os
from pathlib import Path

from day6_urdf.check import MAX_BYTES, check_text, read_description, too_large
from day6_urdf.diagnostics import OLDEST, Version
from day6_urdf.model import Robot
from day6_urdf.report import Diagnostic, Report
from day6_urdf.xmlreader import read_xml, write_xml

_log = logging.getLogger(__name__)


class RobotError(Exception):
    """A description was refused; `diagnostics` are the reasons, `str()` is the text of the last, most general one."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(diagnostics[-1].text if diagnostics else "")
        self.diagnostics = diagnostics


def parse_robot(source: str | os.PathLike[str], newest: Version = OLDEST) -> Robot:
    """Return the robot of a description (text with a `<` in it) or of a file, read by our own parser.

    Raises:
        RobotError: the description is refused, or the file cannot be read.
    """
    return _robot(_check(source, newest)[1])


def load_robot(source: str | os.PathLike[str], newest: Version = OLDEST) -> Robot:
    """Return the robot of a description (text with a `<` in it) or of a file, read by yourdfpy.

    The description is checked first, and passed to yourdfpy without comments, entities and document type, which make its parser
    (lxml) fail or open files. urdfdom accepts robots with a malformed part and drops that part, but yourdfpy raises; then the
    robot read by the check is returned.

    Raises:
        RobotError: the description is refused, or the file cannot be read.
    """
    text, report = _check(source, newest)
    checked = _robot(report)
    from day6_urdf import yourdfpy_robot

    elements = [element for element in read_xml(text) if element.tag == "robot"][:1]
    if elements[0].attributes.get("version", "1.0") != "1.0":
        return checked  # it knows neither quaternions nor capsules
    plain = write_xml(elements)
    try:
        return yourdfpy_robot.robot_of(yourdfpy_robot.load(plain))
    except Exception as error:
        # yourdfpy may raise any type of exception for parts that urdfdom skips (KeyError, TypeError, IndexError …).
        _log.info("yourdfpy refused %r: %r", checked.name, error)
        return checked


def _robot(report: Report) -> Robot:
    if report.robot is None:
        raise RobotError(report.diagnostics)
    return report.robot


def _check(source: str | os.PathLike[str], newest: Version) -> tuple[str, Report]:
    if isinstance(source, str) and ("<" in source or not source.strip()):
        return source, check_text(source, newest)
    path = Path(source)
    try:
        text, size = read_description(path)
    except FileNotFoundError:
        missing = Diagnostic("Error", f"File {path} does not exist", "model", 56)
        return "", Report(None, (missing,))
    except OSError as error:
        return "", Report(None, (Diagnostic("Error", f"File {path} cannot be read: {error.strerror}"),))
    return text, too_large(size) if size > MAX_BYTES else check_text(text, newest)
