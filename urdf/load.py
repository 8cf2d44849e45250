"""From a description to a robot.

Two ways lead there, and a test holds them equal: `parse_robot` takes what our own check read, at once and without
numpy, and is what robot_state_publisher and the commands use; `load_robot` hands the checked description to yourdfpy,
the project's robot model, and is what views use (its first call takes some tenths of a second: call it from a thread).
"""

from __future__ import annotations

import logging
import os
from pathlib import Path

from day6_tui.urdf.check import MAX_BYTES, check_text, read_description, too_large
from day6_tui.urdf.model import Robot
from day6_tui.urdf.report import Diagnostic, Report
from day6_tui.urdf.xmlreader import read_xml, write_xml

_log = logging.getLogger(__name__)


class RobotError(Exception):
    """A description was refused; `diagnostics` says why, `str()` is the text of the last, most general one."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(diagnostics[-1].text if diagnostics else "")
        self.diagnostics = diagnostics


def parse_robot(source: str | os.PathLike[str]) -> Robot:
    """Return the robot of a description (text with a `<` in it) or of a file, by our own parser. Raises RobotError."""
    return _robot(_check(source)[1])


def load_robot(source: str | os.PathLike[str]) -> Robot:
    """Return the robot of a description (text with a `<` in it) or of a file, by yourdfpy. Raises RobotError.

    The description is checked first, and yourdfpy gets it without comments, entities and document type, on which its
    own parser (lxml) stumbles or opens files. urdfdom accepts robots with a malformed part and leaves that part away;
    yourdfpy raises; then what the check read is the robot.
    """
    text, report = _check(source)
    checked = _robot(report)
    from day6_tui.urdf import _yourdfpy

    plain = write_xml([element for element in read_xml(text) if element.tag == "robot"][:1])
    try:
        return _yourdfpy.robot_of(_yourdfpy.load(plain))
    except Exception as error:
        # Any exception type may come out of yourdfpy for parts that urdfdom skips (KeyError, TypeError, IndexError …).
        _log.info("yourdfpy refused %r: %r", checked.name, error)
        return checked


def _robot(report: Report) -> Robot:
    if report.robot is None:
        raise RobotError(report.diagnostics)
    return report.robot


def _check(source: str | os.PathLike[str]) -> tuple[str, Report]:
    if isinstance(source, str) and ("<" in source or not source.strip()):
        return source, check_text(source)
    path = Path(source)
    try:
        text, size = read_description(path)
    except FileNotFoundError:
        said = Diagnostic("Error", f"File {path} does not exist", "model", 56)
        return "", Report(None, (said,))
    except OSError as error:
        return "", Report(None, (Diagnostic("Error", f"File {path} cannot be read: {error.strerror}"),))
    return text, too_large(size) if size > MAX_BYTES else check_text(text)
