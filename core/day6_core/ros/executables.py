"""ROS's commands, `python3` and `pytest` as real executables, so that `subprocess.run(["ros2", …])` of any program finds them.

They are in one folder per installation, below the user's data folder. It is created when first needed and never changed: its
name is a hash of its contents, so another installation has another folder.
"""

from __future__ import annotations

import hashlib
import os
import shlex
import shutil
import sys
import tempfile
from functools import cache
from pathlib import Path

from day6_core.places import data_folder
from day6_core.ros.program_index import COMMANDS

_SELF = ("-m", "day6_tui.main")
"""The arguments with which our Python is `day6-tui`, wherever its own script may be."""


def ros_commands() -> list[str]:
    """Return every command of ROS that exists here: ros2, colcon, rviz2 …"""
    return ["ros2", "colcon", *COMMANDS]


def with_executables(path: str) -> str:
    """Return a PATH with the folder first, unchanged if it cannot be created."""
    entries = [entry for entry in path.split(os.pathsep) if entry]
    there = [entry for entry in entries if os.path.basename(entry) == _digest() and os.path.isdir(entry)]
    ours = there[0] if there else _folder()
    return os.pathsep.join(dict.fromkeys([ours, *entries])) if ours else path


def are_on(path: str) -> bool:
    """Return whether the folder is on a PATH; True where it could not be created, for then no PATH has it."""
    return any(os.path.basename(entry) == _digest() for entry in path.split(os.pathsep)) or _folder() is None


@cache
def texts(system: str = os.name) -> dict[str, str]:
    """Return the files for a system ('posix' or 'nt'), `{name: text}`."""
    arguments: dict[str, tuple[str, ...]] = {"python3": (), "python": (), "pytest": ("-m", "pytest"), "day6-tui": _SELF}
    arguments["launch_test"] = ("-m", "launch_testing.launch_test")
    arguments.update({name: (*_SELF, name) for name in ros_commands()})
    if system == "nt":
        # A batch file is read in the console's old code page, so the interpreter's path is passed in the environment.
        return {f"{name}.bat": f'@"%DAY6_PYTHON%" {" ".join(words)} %*\r\n' for name, words in arguments.items()}
    return {name: f'#!/bin/sh\nexec {shlex.join([sys.executable, *words])} "$@"\n' for name, words in arguments.items()}


@cache
def _digest() -> str:
    return "bin-" + hashlib.sha256(repr(sorted(texts().items())).encode()).hexdigest()[:12]


@cache
def _folder() -> str | None:
    """Return the folder's path, created if missing; None if it cannot be written."""
    folder = data_folder() / _digest()
    if folder.is_dir():
        return str(folder)
    new = ""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        new = tempfile.mkdtemp(prefix=".bin-", dir=folder.parent)
        write_executables(Path(new))
        os.chmod(new, 0o755)
        os.rename(new, folder)
    except OSError:
        shutil.rmtree(new, ignore_errors=True)
        return str(folder) if folder.is_dir() else None  # another process has just created it, or it cannot be created
    return str(folder)


def write_executables(folder: Path) -> None:
    """Write the files into a folder. Raises OSError."""
    for name, text in texts().items():
        file = folder / name
        file.write_bytes(text.encode("utf-8"))
        file.chmod(0o755)
