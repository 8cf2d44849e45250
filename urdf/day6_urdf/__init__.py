"""The robot model: reading and checking URDF, plain data, kinematics, the robot seen from above, the shipped robots.

Imports neither `core` nor `tui`; both may import it. The first `load_robot` imports yourdfpy (and numpy with it), the package
itself does not.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_urdf.check import check_file, check_text
    from day6_urdf.load import RobotError, load_robot, parse_robot
    from day6_urdf.model import Robot
    from day6_urdf.report import Diagnostic, Report
    from day6_urdf.shipped import copy_model, shipped_model, shipped_models

__all__ = [
    "Diagnostic",
    "Report",
    "Robot",
    "RobotError",
    "check_file",
    "check_text",
    "copy_model",
    "load_robot",
    "parse_robot",
    "shipped_model",
    "shipped_models",
]

_HOME = {
    "Diagnostic": "report",
    "Report": "report",
    "Robot": "model",
    "RobotError": "load",
    "check_file": "check",
    "check_text": "check",
    "copy_model": "shipped",
    "load_robot": "load",
    "parse_robot": "load",
    "shipped_model": "shipped",
    "shipped_models": "shipped",
}


def __getattr__(name: str) -> object:
    module = _HOME.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    value: object = getattr(import_module(f"{__name__}.{module}"), name)
    globals()[name] = value
    return value
