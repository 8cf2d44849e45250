"""The executables of our packages and the commands of ROS, found by name without importing them.

Below everything that starts programs (shells, `ros2 run`, `launch`), so that all of it can use this; `programs.load` imports one.
"""

from __future__ import annotations

import re
from pathlib import Path

from day6_core.ros import differences, distribution

COMMANDS = {
    "rqt": ("rqt_gui", "rqt_gui"),
    "rqt_bag": ("rqt_bag", "rqt_bag"),
    "rqt_graph": ("rqt_graph", "rqt_graph"),
    "rqt_console": ("rqt_console", "rqt_console"),
    "rqt_plot": ("rqt_plot", "rqt_plot"),
    "rqt_topic": ("rqt_topic", "rqt_topic"),
    "rviz2": ("rviz2", "rviz2"),
    "check_urdf": ("urdfdom", "check_urdf"),
    "urdf_to_graphviz": ("urdfdom", "urdf_to_graphviz"),
    "xacro": ("xacro", "xacro"),
}
"""The executables that are also commands, as in ROS's `bin` folder: command -> (package, executable)."""

OTHER_COMMANDS = ("ros2", "launch_test")
"""What else is in that folder."""

_PREFIX = Path(__file__).resolve().parent
_PROGRAMS = _PREFIX / "programs"
_MAIN = re.compile(r"^async def main\(", re.MULTILINE)


def packages() -> list[str]:
    """Return the packages that have executables here, sorted."""
    return sorted(folder.name for folder in _PROGRAMS.iterdir() if executables(folder.name))


def executables(package: str) -> list[str]:
    """Return the executables of a package, sorted; empty for a package that is not ours."""
    folder = _PROGRAMS / package
    if not package.isidentifier() or not folder.is_dir():
        return []
    names = (file.stem for file in folder.glob("[!_]*.py") if _MAIN.search(file.read_text(encoding="utf-8")))
    return sorted(name for name in names if differences.has_executable(package, name))


def named_by(path: Path) -> tuple[str, str] | None:
    """Return package and name of our executable with a path, `<our prefix>/lib/<package>/<name>`, None for other paths."""
    folder = path.parent
    if folder.parent != _PREFIX / "lib" or path.name not in executables(folder.name):
        return None
    return folder.name, path.name


def place_of_command(name: str) -> str:
    """Return the path `which` prints for a command of ROS, `/opt/ros/<distribution>/bin/<name>`; '' for other names."""
    return f"/opt/ros/{distribution.current()}/bin/{name}" if name in (*OTHER_COMMANDS, *COMMANDS) else ""
