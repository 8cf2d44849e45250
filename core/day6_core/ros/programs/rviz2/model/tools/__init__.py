"""RViz's tools (rviz_default_plugins/tools): what the mouse and the keys do in the view.

A tool's class is imported when a configuration names it. `toolbox` holds those that are there.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.tools.tool import Tool

TYPES: dict[str, str] = {
    "Interact": "interact",
    "MoveCamera": "camera",
    "Select": "select",
    "FocusCamera": "picking",
    "Measure": "picking",
    "SetInitialPose": "pose",
    "SetGoal": "pose",
    "PublishPoint": "picking",
}
"""Type -> the module of its class, which has its name, in the order of the toolbar of default.rviz."""


def tool_class(type_name: str) -> type[Tool]:
    """The class of a type of `TYPES`. Raises KeyError."""
    found: type[Tool] = getattr(import_module(f"{__name__}.{TYPES[type_name]}"), type_name)
    return found
