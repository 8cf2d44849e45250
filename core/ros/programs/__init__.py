"""The executables of our packages: `programs/<package>/<executable>.py` with `async def main(session)`.

Finding them needs no import of theirs. Modules of a package that are no executables (a program's model) define no such `main`.
"""

from __future__ import annotations

import importlib
import re
from pathlib import Path
from typing import TYPE_CHECKING

from day6_tui.core.ros.environment import activate

if TYPE_CHECKING:
    from day6_tui.core.session.session import Main

COMMANDS = {
    "rqt": ("rqt_gui", "rqt_gui"),
    "rqt_graph": ("rqt_graph", "rqt_graph"),
    "rqt_console": ("rqt_console", "rqt_console"),
    "rqt_plot": ("rqt_plot", "rqt_plot"),
    "rqt_topic": ("rqt_topic", "rqt_topic"),
    "rviz2": ("rviz2", "rviz2"),
    "check_urdf": ("urdfdom", "check_urdf"),
    "urdf_to_graphviz": ("urdfdom", "urdf_to_graphviz"),
    "xacro": ("xacro", "xacro"),
}
"""The executables that are commands of their own, as in ROS's `bin` folder: (package, executable) by command."""

_HERE = Path(__file__).resolve().parent
_MAIN = re.compile(r"^async def main\(", re.MULTILINE)


def packages() -> list[str]:
    """The packages that have executables here, sorted."""
    return sorted(folder.name for folder in _HERE.iterdir() if executables(folder.name))


def executables(package: str) -> list[str]:
    """The executables of a package, sorted; empty for a package that is not ours."""
    folder = _HERE / package
    if not package.isidentifier() or not folder.is_dir():
        return []
    return sorted(file.stem for file in folder.glob("[!_]*.py") if _MAIN.search(file.read_text(encoding="utf-8")))


def named_by(path: Path) -> tuple[str, str] | None:
    """Return package and name of the executable whose "file", `<our prefix>/lib/<package>/<name>`, a path names, else None."""
    folder = path.parent
    if folder.parent != _HERE.parent / "lib" or path.name not in executables(folder.name):
        return None
    return folder.name, path.name


def load(package: str, executable: str) -> Main:
    """Return the `main` of an executable. Raises LookupError when there is no such package or executable."""
    if executable not in executables(package):
        raise LookupError(f"{package}/{executable}")
    activate()
    main: Main = importlib.import_module(f"{__name__}.{package}.{executable}").main
    return main
