"""ROS's commands, `python3` and `pytest` as real executables, so that `subprocess.run(["ros2", …])` of any program finds them.

They are in one folder per interpreter, below the user's data folder. It is created when first needed, and its files never change:
its name is a hash of what they start. A newer day6-tui of the same interpreter adds what is missing. The folders of interpreters
that are gone are removed when a new one is created: nothing in them can be run any more, so none of them is in use.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import shlex
import shutil
import stat
import sys
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path

from day6_core.places import data_folder
from day6_core.ros.home_python import BELOW_HOME, THEN, interpreter_of, python_of
from day6_core.ros.program_index import COMMANDS
from day6_core.whole_file import replace_file

_SELF = ("-m", "day6_tui.main")
"""The arguments with which our Python is `day6-tui`, wherever its own script may be."""


PIP = "day6_core.ros.pip_of_home"
_OF_SETUP = frozenset({"install", "develop"})
"""Commands of a setup.py that install."""


def ros_commands() -> list[str]:
    """Return every command of ROS that exists here: ros2, colcon, rviz2 …"""
    return ["ros2", "colcon", *COMMANDS]


def python_words(arguments: Sequence[str], variables: Mapping[str, str]) -> list[str]:
    """Return what `python3 ARG…` runs in a home: pip by `pip_of_home`, so that it never changes day6-tui's own packages."""
    if arguments[:2] == ["-m", "pip"]:
        return [sys.executable, "-m", PIP, *arguments[2:]]
    installs = arguments and os.path.basename(arguments[0]) == "setup.py" and _OF_SETUP.intersection(arguments)
    return [sys.executable, "-m", PIP, THEN, *arguments] if installs else [python_of(variables), *arguments]


def with_executables(path: str) -> str:
    """Return a PATH with the folder first, unchanged if it cannot be created."""
    entries = [entry for entry in path.split(os.pathsep) if entry]
    there = (entry for entry in entries if os.path.basename(entry) == _digest() and _is_complete(entry))
    ours = next(there, None) or _folder()
    return os.pathsep.join(dict.fromkeys([ours, *entries])) if ours else path


def are_on(path: str) -> bool:
    """Return whether the folder is on a PATH; True where it could not be created, for then no PATH has it."""
    return any(os.path.basename(entry) == _digest() for entry in path.split(os.pathsep)) or _folder() is None


@cache
def texts(system: str = os.name) -> dict[str, str]:
    """Return the files for a system ('posix' or 'nt'), `{name: text}`."""
    arguments: dict[str, tuple[str, ...]] = {"day6-tui": _SELF, **{name: (*_SELF, name) for name in ros_commands()}}
    arguments.update(dict.fromkeys(("pip", "pip3"), ("-m", PIP)))
    make = _batch_file if system == "nt" else _script
    return dict(
        [make(name, words) for name, words in arguments.items()]
        + [make(name, words, OF_HOME) for name, words in _PYTHONS.items()]
    )


_PYTHONS = {
    "python3": (),
    "python": (),
    "pytest": ("-m", "pytest"),
    "launch_test": ("-m", "launch_testing.launch_test"),
}
"""What runs in the home's own environment, if there is one."""
OF_HOME = interpreter_of(BELOW_HOME)
"""Its Python, below the home folder."""


def _script(name: str, words: Sequence[str], first: Path | None = None) -> tuple[str, str]:
    """Return a file that runs `first` below the home folder, if it is there, else our Python."""
    own = f'"$HOME"/{shlex.join([first.as_posix(), *words])}' if first else ""
    lines = [f'[ -x "$HOME"/{shlex.quote(first.as_posix())} ] && exec {own} "$@"'] if first else []
    return name, "\n".join(["#!/bin/sh", *lines, f'exec {shlex.join([sys.executable, *words])} "$@"', ""])


def _batch_file(name: str, words: Sequence[str], first: Path | None = None) -> tuple[str, str]:
    # A batch file is read in the console's old code page, so the interpreter's path is passed in the environment.
    own = f'"%HOME%\\{str(first).replace("/", chr(92))}"'
    rest = f'"%DAY6_PYTHON%" {" ".join(words)} %*'
    lines = [f"@if exist {own} {own} {' '.join(words)} %*", f"@if not exist {own} {rest}"] if first else [f"@{rest}"]
    return f"{name}.bat", "\r\n".join([*lines, ""])


@cache
def _digest() -> str:
    """Return the folder's name: a hash of the interpreter and of how our files call it."""
    first = [text for name, text in texts().items() if name.partition(".")[0] in ("python3", "day6-tui")]
    return "bin-" + hashlib.sha256(repr(first).encode()).hexdigest()[:12]


@cache
def _folder() -> str | None:
    """Return the folder's path, created if missing; None if it cannot be written."""
    folder = data_folder() / _digest()
    if _is_complete(folder):
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
        return (
            str(folder) if _is_complete(folder) else None
        )  # another process has just created it, or it cannot be created
    remove_orphans(folder.parent)
    return str(folder)


def _is_complete(folder: str | Path) -> bool:
    """Return whether the folder has all our files, after adding those that a newer version has more than the one that made it."""
    try:
        missing = texts().keys() - set(os.listdir(folder))
        write_executables(Path(folder), missing)
    except OSError:
        return False
    return True


def write_executables(folder: Path, names: Iterable[str] | None = None) -> None:
    """Write the files into a folder, or those with these names. Raises OSError."""
    for name in texts() if names is None else names:
        replace_file(folder / name, texts()[name].encode("utf-8"), mode=0o755, sync=False, follow=False)
        (folder / name).chmod(0o755)  # whatever the umask: pupils that are users of their own run them, too


def remove_orphans(data: Path) -> None:
    """Remove the folders whose interpreter is gone; what is not ours in them stays."""
    for folder in data.glob("bin-*"):
        interpreter = _interpreter(folder / "python3")
        if interpreter is not None and not os.path.exists(interpreter) and not folder.is_symlink():
            with contextlib.suppress(OSError):  # another process removes it, too
                remove_executables(folder)


def remove_executables(folder: Path) -> None:
    """Remove our files from a folder, and the folder if nothing is left in it. Raises OSError."""
    for file in folder.iterdir():
        if is_executable_of_ours(file):
            file.unlink(missing_ok=True)
    if not any(folder.iterdir()):
        folder.rmdir()


def is_executable_of_ours(file: Path) -> bool:
    """Return whether a file was written by `write_executables`, of this installation or another one."""
    return (file.suffix == ".bat" and b'"%DAY6_PYTHON%" ' in _begin(file)) or _interpreter(file) is not None


def _interpreter(file: Path) -> str | None:
    """Return the interpreter that one of our files calls, None if it is not one of ours."""
    try:
        first, *_, line, _ = _begin(file).decode("utf-8").split("\n")
        words = shlex.split(line)
    except ValueError:
        return None
    ours = first == "#!/bin/sh" and words[:1] == ["exec"] and words[-1:] == ["$@"] and len(words) > 2
    return words[1] if ours else None


def _begin(file: Path) -> bytes:
    """Return the first bytes of a file that is no link, none if it cannot be read."""
    try:
        if not stat.S_ISREG(file.lstat().st_mode):
            return b""
        with open(file, "rb") as opened:
            return opened.read(10_000)
    except OSError:
        return b""
