"""The Python environment of a home: what its user installs with pip, for the programs of that home only.

It is a venv, made at the first `pip install` (`pip_of_home`). Behind its own packages come those of the Python that runs
day6-tui, through `LINE` in it and the folders in `VARIABLE`: so programs have rclpy and all that it needs, whichever
installation of day6-tui starts them. A venv that the user has made and activated goes first, and gets the same line.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path

FOLDER = ".local/lib/day6-tui"
"""The folder in a home with its environments, one for each version of Python."""

VARIABLE = "DAY6_SITE_PACKAGES"
"""The folders of packages of the Python that runs day6-tui."""

LINE_FILE = "day6-tui.pth"
LINE = f"import os, site; list(map(site.addsitedir, filter(None, os.getenv({VARIABLE!r}, '').split(os.pathsep))))\n"
"""What Python runs at its start in such an environment: the packages behind its own, with their `.pth` files."""

THEN = "--then"
"""What tells `pip_of_home` to make the environment and run the words behind it with that one's Python."""

_VERSION = f"python{sys.version_info.major}.{sys.version_info.minor}{getattr(sys, 'abiflags', '')}"
BELOW_HOME = Path(FOLDER, _VERSION)
"""The environment in a home."""

_IS_WINDOWS = os.name == "nt"


def environment_of(variables: Mapping[str, str]) -> Path:
    """Return the folder of the environment of the home in these variables. It may not exist."""
    return Path(variables.get("HOME") or Path.home()) / BELOW_HOME


def scripts_of(environment: Path) -> Path:
    """Return the folder of an environment's programs."""
    return environment / ("Scripts" if _IS_WINDOWS else "bin")


def interpreter_of(environment: Path) -> Path:
    """Return the Python of an environment."""
    return scripts_of(environment) / ("python.exe" if _IS_WINDOWS else "python3")


def packages_of(environment: Path) -> Path:
    """Return the folder of an environment's packages."""
    return environment / "Lib" / "site-packages" if _IS_WINDOWS else environment / "lib" / _VERSION / "site-packages"


def is_made(environment: Path) -> bool:
    """Return whether an environment is whole, and its Python is still there."""
    return (packages_of(environment) / LINE_FILE).exists() and interpreter_of(environment).exists()


def activated(variables: Mapping[str, str]) -> Path | None:
    """Return the venv that the user has activated, if its programs are on PATH."""
    named = variables.get("VIRTUAL_ENV")
    if not named:
        return None
    environment = Path(named)
    on_path = str(scripts_of(environment)) in variables.get("PATH", "").split(os.pathsep)
    return environment if on_path and interpreter_of(environment).exists() and not _is_this(environment) else None


def python_of(variables: Mapping[str, str]) -> str:
    """Return the Python for a program with these variables: of an activated venv, else `python_of_home`."""
    environment = activated(variables)
    if environment is None:
        return python_of_home(variables)
    _show_ours(environment)
    return str(interpreter_of(environment))


def python_of_home(variables: Mapping[str, str]) -> str:
    """Return the Python of the home in these variables, else the one that runs us."""
    environment = environment_of(variables)
    return str(interpreter_of(environment)) if is_made(environment) else sys.executable


def prefix_of(python: str) -> str:
    """Return what `sys.prefix` is in a Python that `python_of` has named."""
    return sys.prefix if python == sys.executable else str(Path(python).parents[1])


def add_line(environment: Path) -> None:
    """Let programs of an environment import what day6-tui has. Raises OSError."""
    from day6_core.whole_file import replace_file

    replace_file(packages_of(environment) / LINE_FILE, LINE.encode(), sync=False)


@cache
def our_packages() -> str:
    """Return the value of `VARIABLE`: the folders of this Python or, in an environment that has them from outside, those."""
    if (packages_of(Path(sys.prefix)) / LINE_FILE).exists() and VARIABLE in os.environ:
        return os.environ[VARIABLE]
    import site

    import day6_core

    folders = site.getsitepackages()
    own = Path(day6_core.__file__ or "").resolve().parents[1]
    if own.name in ("site-packages", "dist-packages"):
        folders.append(str(own))  # it was installed with --user
    return os.pathsep.join(dict.fromkeys(folder for folder in folders if os.path.isdir(folder)))


def _is_this(environment: Path) -> bool:
    """Whether an environment is the one of day6-tui itself, from which it was started: that one stays as it is."""
    return os.path.realpath(environment) == os.path.realpath(sys.prefix)


def _show_ours(environment: Path) -> None:
    """Programs in a venv of our version of Python get what rclpy needs; one that can't be written to stays as it is."""
    packages = packages_of(environment)
    if packages.is_dir() and not (packages / LINE_FILE).exists():
        try:
            add_line(environment)
        except OSError:
            return
