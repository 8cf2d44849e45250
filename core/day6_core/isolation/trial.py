"""Tries a way of keeping pupils apart: two cells in a temporary folder, and one does to the other what `attacks` knows."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.isolation import attacks, bubblewrap, landlock, users
from day6_core.isolation.cell import Cell, IsolationError, Limits
from day6_core.isolation.mode import Mode
from day6_core.isolation.same_user import Landlock, Nothing
from day6_core.system.control_groups import Tree
from day6_core.system.processes import descendants

assert not TYPE_CHECKING or sys.platform == "linux"

SECONDS = 30.0
_LIMITS = Limits(memory=512 << 20, processes=64, disk=16 << 20)


def make(name: str, trees: list[Tree]) -> Mode:
    """Return a mode if what it needs is there. Raises IsolationError."""
    is_root = os.geteuid() == 0
    if name == "users":
        if not is_root:
            raise IsolationError("isolation.no.root")
        mode = users.Users(trees)
        if (closed := users.cannot_run_python(users.FIRST_UID)) is not None:
            raise IsolationError("isolation.no.closed", folder=str(closed))
        return mode
    if name == "none":
        return Nothing(trees)
    if is_root:  # whoever is root in a cell is the server's own user outside
        raise IsolationError("isolation.no.as_root")
    if name == "bubblewrap":
        if not bubblewrap.is_installed():
            raise IsolationError("isolation.no.bwrap")
        return bubblewrap.Bubblewrap(trees)
    if landlock.version() < 1:
        raise IsolationError("isolation.no.landlock")
    return Landlock(trees)


def run(mode: Mode) -> None:
    """Set `mode.open` to what went through. Raises IsolationError or OSError if nothing can be started in a cell."""
    with tempfile.TemporaryDirectory(prefix="day6-trial-") as name:
        top = Path(name).resolve()
        os.chmod(top, 0o711)  # other users must come through to their own folders
        token = top / "token"
        token.write_bytes(attacks.SECRET)
        token.chmod(0o600)
        mode.open = frozenset(_between(mode, _cell(mode, top, "a"), _cell(mode, top, "b"), token))


def _cell(mode: Mode, top: Path, name: str) -> Cell:
    for folder in (top / "homes", top / "run"):
        folder.mkdir(exist_ok=True)
        folder.chmod(0o711)
    home = top / "homes" / name
    uid = mode.claim(home, users.FOR_TRIALS) if isinstance(mode, users.Users) else None
    return Cell(name, home, top / "run" / name, uid, _LIMITS)


def _between(mode: Mode, first: Cell, second: Cell, token: Path) -> list[str]:
    mode.prepare(first)
    mode.prepare(second)
    try:
        words = ["stand", str(second.home), str(second.runtime)]
        with subprocess.Popen(
            mode.command(second, program(words)),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        ) as standing:
            assert standing.stdout is not None and standing.stderr is not None
            line = standing.stdout.readline()
            if not line:
                raise _failure(standing.stderr.read())
            victim = attacks.Victim(
                home=str(second.home),
                runtime=str(second.runtime),
                pid=_standing(standing.pid),
                server=os.getpid(),
                token=str(token),
                numbers=attacks.namespace(),
                **json.loads(line),
            )
            tried = subprocess.run(
                mode.command(first, program(["attack", attacks.described(victim)])),
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=SECONDS,
                check=False,
                start_new_session=True,
            )
            standing.stdin.close()  # type: ignore[union-attr]
            if tried.returncode:
                raise _failure(tried.stderr)
            return [str(name) for name in json.loads(tried.stdout)]
    finally:
        mode.end(first)
        mode.end(second)


def program(words: list[str]) -> list[str]:
    """Return the command line of `attacks`."""
    return [sys.executable, "-I", "-m", "day6_core.isolation.attacks", *words]


def _standing(first: int) -> int:
    """Return the victim's number outside: the process furthest below the one we started."""
    return [first, *descendants(first)][-1]


def _failure(said: bytes) -> IsolationError:
    lines = said.decode(errors="replace").strip().splitlines()
    return IsolationError("isolation.no.fails", reason=lines[-1] if lines else "?")
