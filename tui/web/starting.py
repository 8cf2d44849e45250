"""Starts the keeper of a pupil's desktop in the pupil's cell. It blocks: not for the event loop's thread."""

from __future__ import annotations

import errno
import os
import socket
import subprocess
import sys
from pathlib import Path

from day6_tui.core.isolation.cell import Cell
from day6_tui.core.isolation.mode import Mode
from day6_tui.tui.detached import meeting

START_SECONDS = 30.0
"""What the system may take to start a process."""

LOCALE = "C.UTF-8"
"""Only the encoding matters: the desktop's language is said by `--lang`."""


def start(mode: Mode, cell: Cell, keepers: Path, words: list[str]) -> socket.socket:
    """Start a keeper and return the first line to it; `words` are for the desktop.

    Raises BlockingIOError if one runs, IsolationError or OSError if it cannot be started.
    """
    if sys.platform == "win32":  # which has no keepers
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    mode.prepare(cell)
    held = meeting.hold(cell.home, keepers)
    try:
        ours, theirs = socket.socketpair()
        with theirs:
            descriptors = (held.listener.fileno(), held.lock, theirs.fileno())
            keeper = [sys.executable, "-m", "day6_tui.tui.detached.keeper", *map(str, descriptors)]
            program = mode.command(cell, [*keeper, str(cell.home), str(cell.home), *words], descriptors)
            numbers = ",".join(map(str, descriptors))
            subprocess.run(
                [sys.executable, "-I", "-m", "day6_tui.tui.web.orphan", numbers, *program],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                env=environment(),
                pass_fds=descriptors,
                cwd="/",
                timeout=START_SECONDS,
                check=True,
            )
    finally:
        held.close()  # the keeper has inherited both
    return ours


def environment() -> dict[str, str]:
    """What the desktops see of the world, and nothing else of the server's variables; the cell adds its folders."""
    path = os.pathsep.join([os.path.dirname(sys.executable), os.defpath.lstrip(":"), "/usr/local/bin"])
    return {
        "PATH": path,
        "LANG": LOCALE,
        "LC_ALL": LOCALE,
        "TERM": "xterm-256color",
        "COLORTERM": "truecolor",
        "TERM_PROGRAM": "day6-serve",
    }
