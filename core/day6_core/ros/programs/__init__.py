"""The executables of our packages: `programs/<package>/<executable>.py` with `async def main(session)`.

`program_index` beside this folder lists them. Modules of a package that are not executables (a program's model) define
no such `main`. Programs import what a ROS program could (rclpy, tf2_ros …) and the session that runs them; they never import
the layers above them: `ros2`, the shell and the screen.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

from day6_core.ros.environment import activate
from day6_core.ros.program_index import executables

if TYPE_CHECKING:
    from day6_core.session.session import Main


def load(package: str, executable: str) -> Main:
    """Return the `main` of an executable. Raises LookupError when there is no such package or executable."""
    if executable not in executables(package):
        raise LookupError(f"{package}/{executable}")
    activate()
    main: Main = importlib.import_module(f"{__name__}.{package}.{executable}").main
    return main
