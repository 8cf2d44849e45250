"""Starts and ends the keeper of a pupil's desktop in the pupil's cell. It blocks: not for the event loop's thread."""

from __future__ import annotations

import contextlib
import errno
import os
import socket
import subprocess
import sys
from pathlib import Path

from day6_core.isolation import enter
from day6_core.isolation.cell import Cell
from day6_core.isolation.mode import Mode
from day6_core.ros import distribution
from day6_tui.detached import meeting, wire
from day6_tui.web.nursery import Nursery

START_SECONDS = 30.0
"""What the system may take to start a process."""

END_SECONDS = 5.0
"""What a desktop gets to end in order."""

LOCALE = "C.UTF-8"
"""Only the encoding matters: the desktop's language is said by `--lang`."""

TERMINAL = {
    "TERM": "xterm-256color",
    "COLORTERM": "truecolor",
    "TERM_PROGRAM": wire.PAGE,
    "LANG": LOCALE,
    "LC_ALL": LOCALE,
}
"""What a desktop judges the browser's terminal by."""


def start(
    mode: Mode, cell: Cell, keepers: Path, domain: int, words: list[str], nursery: Nursery | None = None
) -> socket.socket:
    """Start a keeper and return the first line to it; `words` are for the desktop. With a nursery it is born there if possible.

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
            # -I: in the pupil's home, whose random.py is not Python's
            keeper = [sys.executable, "-I", "-m", "day6_tui.detached.keeper", *map(str, descriptors)]
            keeper += [str(cell.home), str(cell.home), "--home", str(cell.home), *words]
            if nursery is None or not _is_born(nursery, mode, cell, keeper, domain, descriptors):
                program = mode.command(cell, keeper, descriptors)
                numbers = ",".join(map(str, descriptors))
                _run([sys.executable, "-I", "-m", "day6_tui.web.orphan", numbers, *program], domain, descriptors)
        return ours
    finally:
        held.close()  # the keeper has inherited both


def _is_born(
    nursery: Nursery, mode: Mode, cell: Cell, keeper: list[str], domain: int, descriptors: tuple[int, ...]
) -> bool:
    plan = mode.plan(cell, descriptors)
    shown = enter.command(cell, plan, keeper)
    order = {"plan": enter.filled(plan), "keeper": keeper, "shown": shown, "environment": environment(domain)}
    return nursery.bear(order, descriptors)


def _run(program: list[str], domain: int, descriptors: tuple[int, ...]) -> None:
    """Run what returns at once. Raises OSError."""
    try:
        subprocess.run(
            program,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env=environment(domain),
            pass_fds=descriptors,
            cwd="/",
            timeout=START_SECONDS,
            check=True,
        )
    except subprocess.SubprocessError as error:
        raise OSError(errno.EIO, str(error)) from None


def environment(domain: int) -> dict[str, str]:
    """What the desktops see of the world, and nothing else of the server's variables; the cell adds its folders."""
    path = [os.path.dirname(sys.executable), "/usr/local/bin", "/usr/bin", "/bin"]
    of_all = {"ROS_DOMAIN_ID": str(domain), distribution.HANDED_ON: distribution.current()}
    return {"PATH": os.pathsep.join(path), **of_all, **TERMINAL}


def stop(mode: Mode, cell: Cell, keepers: Path) -> bool:
    """End the desktop in order, then whatever is left of the cell; return whether nothing is."""
    if sys.platform == "win32":  # which has no keepers
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    with contextlib.suppress(OSError):
        found = meeting.connect(cell.home, keepers)
        if found is not None:
            with found:
                found.settimeout(END_SECONDS)
                found.sendall(wire.message(wire.STOP))
                with contextlib.suppress(socket.timeout):
                    found.recv(1)  # nothing comes: the keeper is gone
    return mode.end(cell)
