"""`pip` of the simulated machine, as a process: what it installs goes into the environment of the home, which is made for it.

Run as `python3 -m day6_core.ros.pip_of_home ARG…`. What only looks (`pip list`, `pip download`) needs no environment.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from day6_core.language import language_of, said
from day6_core.reason import reason
from day6_core.ros.home_python import (
    THEN,
    VARIABLE,
    activated,
    add_line,
    environment_of,
    interpreter_of,
    is_made,
    our_packages,
    python_of,
)

_CHANGES = frozenset({"install", "uninstall"})

_TEXTS = {
    "made": (
        "What pip installs here is kept in {folder}: for the programs of this home, not for day6-tui itself.",
        "pip 安装的包放在 {folder} 里：给这个主目录里的程序用，不影响 day6-tui 自己。",
    ),
    "no_venv": (
        "pip: {python} has no module venv, which keeps your packages apart (Debian, Ubuntu: sudo apt install python3-venv)",
        "pip：{python} 没有 venv 模块，没法把你的包单独存放（Debian、Ubuntu：sudo apt install python3-venv）",
    ),
    "no_pip": (
        "pip: this Python ({python}) has no pip. Install it in a real terminal: {command}",
        "pip：这个 Python（{python}）没有 pip。请在真正的终端里安装：{command}",
    ),
    "not_made": ("pip: {folder} cannot be made: {reason}", "pip：没法建立 {folder}：{reason}"),
}
"""What pip itself would not say: English, Chinese."""


class _Told(Exception):
    """Why there is no pip to run; the text is whole."""


def changes(arguments: Sequence[str]) -> bool:
    """Return whether pip with these arguments changes what is installed."""
    return next((word for word in arguments if not word.startswith("-")), "") in _CHANGES and "--help" not in arguments


def main() -> int:
    """Become pip; return a status where that can't be."""
    arguments, variables = sys.argv[1:], os.environ
    other = arguments[:1] == [THEN]
    try:
        python = _python_for(arguments, variables)
    except _Told as told:
        print(told, file=sys.stderr)
        return 1
    if activated(variables) is None:
        # The environment of the home is the user's own already; pip refuses --user in one.
        arguments = [word for word in arguments if word != "--user"]
    words = [python, *arguments[1:]] if other else [python, "-m", "pip", *arguments]
    if os.name == "nt":
        return subprocess.run(words, check=False).returncode
    os.execv(python, words)


def _python_for(arguments: Sequence[str], variables: Mapping[str, str]) -> str:
    """Return the Python whose pip is to run. Raises _Told."""
    folder = environment_of(variables)
    other = arguments[:1] == [THEN]
    if activated(variables) is None and not is_made(folder) and (other or changes(arguments)):
        _make(folder, variables)
        print(_say("made", variables, folder=_shown(folder, variables)), file=sys.stderr)
    python = python_of(variables)
    if not other and not _has_pip(python):
        _add_pip(python, variables)
    return python


def _make(folder: Path, variables: Mapping[str, str]) -> None:
    """Make the environment. Raises _Told."""
    try:
        import venv
    except ImportError:
        raise _Told(_say("no_venv", variables, python=sys.executable)) from None
    try:
        venv.EnvBuilder(symlinks=os.name != "nt", with_pip=False).create(folder)
        add_line(folder)
    except (OSError, subprocess.CalledProcessError) as error:
        raise _Told(_say("not_made", variables, folder=_shown(folder, variables), reason=reason(error))) from None


def _has_pip(python: str) -> bool:
    look = "import importlib.util as u, sys; sys.exit(u.find_spec('pip') is None)"
    return subprocess.run([python, "-c", look], check=False).returncode == 0


def _add_pip(python: str, variables: Mapping[str, str]) -> None:
    """Put Python's own copy of pip into an environment. Raises _Told."""
    by_hand = (
        f"uv pip install --python {python} pip" if shutil.which("uv") else "sudo apt install python3-venv python3-pip"
    )
    in_home = Path(python) == interpreter_of(environment_of(variables))
    if in_home and importlib.util.find_spec("ensurepip") is not None:
        done = subprocess.run([python, "-m", "ensurepip", "--default-pip"], check=False, capture_output=True)
        if done.returncode == 0:
            return
    raise _Told(_say("no_pip", variables, python=python, command=by_hand))


def _shown(folder: Path, variables: Mapping[str, str]) -> str:
    home = variables.get("HOME", "")
    return f"~{str(folder)[len(home) :]}" if home and str(folder).startswith(home + os.sep) else str(folder)


def _say(key: str, variables: Mapping[str, str], **values: str) -> str:
    return said(_TEXTS[key], language_of(variables)).format(**values)


if __name__ == "__main__":
    os.environ.setdefault(VARIABLE, our_packages())
    sys.exit(main())
