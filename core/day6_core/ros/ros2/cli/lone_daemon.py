"""The daemon where no desktop is: a process with nothing but the daemon's node, until it is stopped or unused for two hours.

At most one per domain: it holds a lock in the folder where the link's processes meet, beside a file with its number. A command
that uses it touches that file.
"""

from __future__ import annotations

import os
import select
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from day6_core.link.file_lock import FileLock
from day6_core.link.paths import LinkError, meeting_place, process_exists
from day6_core.whole_file import PRIVATE, replace_file

UNUSED_SECONDS = 2 * 60 * 60
_POLL_SECONDS = 0.02
_LOOK_SECONDS = 60.0
_ENDED_SECONDS = 5.0
_ASKED_SECONDS = 1.0
"""Longer than anybody holds the lock who only asks whether there is a daemon."""


def running(domain_id: int) -> int:
    """Return the process number of the domain's lone daemon, 0 if there is none."""
    try:
        folder = meeting_place(domain_id).folder
    except LinkError:
        return 0
    lock = _lock(folder)
    if lock.try_acquire():
        lock.release()
        return 0
    try:
        number = int(_file(folder).read_text(encoding="ascii"))
        os.utime(_file(folder))
    except (OSError, ValueError):
        return 0  # it has the lock and is about to write its number
    return number if process_exists(number) else 0


def spawn(domain_id: int, seconds: float | None = None, *, debug: bool = False) -> bool:
    """Start one and wait until it is there; returns False if there is one already.

    `debug` leaves it this process's output. Raises RuntimeError if it does not come up within `seconds`.
    """
    if running(domain_id):
        return False
    output = None if debug else subprocess.DEVNULL
    process = subprocess.Popen(
        [sys.executable, "-m", __name__, str(domain_id)],
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=output,
        cwd=os.path.expanduser("~"),
        start_new_session=sys.platform != "win32",
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    )
    process.returncode = 0  # it goes on without us: no warning that it still runs
    if not _becomes_true(lambda: running(domain_id), seconds):
        raise RuntimeError("Timed out waiting for daemon to become ready")
    return True


def shut_down(domain_id: int, seconds: float | None = _ENDED_SECONDS) -> bool:
    """End it and wait until it is gone; returns False if there is none. Raises RuntimeError if it stays."""
    number = running(domain_id)
    if not number:
        return False
    with suppress(ProcessLookupError):
        os.kill(number, signal.SIGTERM)
    if not _becomes_true(lambda: not running(domain_id), seconds):
        raise RuntimeError("Timed out waiting for daemon to shutdown")
    return True


def main(domain_id: int) -> None:
    """Be the daemon of a domain; returns if there is one."""
    folder = meeting_place(domain_id).folder
    lock = _lock(folder)
    if not _becomes_true(lock.try_acquire, _ASKED_SECONDS):
        return
    _file(folder).unlink(missing_ok=True)  # of one that was killed
    from day6_core.ros.environment import activate

    activate()
    from day6_core.ros.ros2.cli.daemon import keywords, node_name
    from rclpy.context import Context
    from rclpy.node import Node

    # A handler runs once the main thread is back from what it waits for, which a signal need not interrupt: it wakes the wait.
    woken, waking = socket.socketpair()
    waking.setblocking(False)
    signal.set_wakeup_fd(waking.fileno(), warn_on_full_buffer=False)
    signal.signal(signal.SIGTERM, lambda number, frame: None)
    context = Context()
    context.init(args=[], domain_id=domain_id)
    node = Node(node_name(domain_id), context=context, **keywords())
    try:
        replace_file(_file(folder), str(os.getpid()).encode(), mode=PRIVATE, sync=False, follow=False)
        while time.time() < _file(folder).stat().st_mtime + UNUSED_SECONDS:
            if select.select([woken], [], [], _LOOK_SECONDS)[0]:
                break
    finally:
        node.destroy_node()
        context.try_shutdown()
        _file(folder).unlink(missing_ok=True)
        lock.release()


def _becomes_true(condition: Callable[[], object], seconds: float | None) -> bool:
    """Wait until it is true, for so many seconds at most; None or less than none: as long as it takes."""
    deadline = float("inf") if seconds is None or seconds < 0 else time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(_POLL_SECONDS)
    return True


def _lock(folder: Path) -> FileLock:
    return FileLock(folder / "daemon.lock")


def _file(folder: Path) -> Path:
    return folder / "daemon"


if __name__ == "__main__":
    main(int(sys.argv[1]))
