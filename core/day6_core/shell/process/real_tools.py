"""Programs of the real machine (git, awk, make …): found on the terminal's PATH, run as processes. What is ours comes first."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path

from day6_core.session.session import Main, Session

_NEVER = frozenset({"halt", "init", "poweroff", "reboot", "shutdown", "su", "telinit"})
"""Programs that would end or leave the real machine: a lesson that says `sudo reboot` means another one."""


def find_tool(name: str, variables: Mapping[str, str], cwd: Path) -> str:
    """Return the path of a program of the real machine, '' if there is none of that name."""
    if not name or name in _NEVER:
        return ""
    return shutil.which(name, path=os.pathsep.join(map(str, _folders(variables, cwd)))) or ""


def tools_beginning_with(start: str, variables: Mapping[str, str], cwd: Path) -> set[str]:
    """Return the names of the real machine's programs that begin so, as they are typed."""
    found: set[str] = set()
    for folder in _folders(variables, cwd):
        try:
            with os.scandir(folder) as entries:
                found.update(
                    _typed(entry.name)
                    for entry in entries
                    if entry.name.startswith(start) and entry.is_file() and os.access(entry.path, os.X_OK)
                )
        except OSError:
            continue  # a PATH may name folders that do not exist
    return found - _NEVER - {""}


def running(path: str) -> Main:
    """Return a program that runs a real one, which is told how it was typed."""

    async def main(session: Session) -> int:
        from day6_core.shell.process.process import run_process

        return await run_process(session, [path, *session.argv[1:]], session.argv[0])

    return main


def _folders(variables: Mapping[str, str], cwd: Path) -> Iterator[Path]:
    for entry in variables.get("PATH", os.defpath).split(os.pathsep):
        yield cwd / entry


def _typed(name: str) -> str:
    """Return the command that starts a file: on Windows without its suffix, '' for a file that is no program there."""
    if os.name != "nt":
        return name
    stem, suffix = os.path.splitext(name)
    return stem if suffix.upper() in os.environ.get("PATHEXT", ".EXE").upper().split(os.pathsep) else ""
