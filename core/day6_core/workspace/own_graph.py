"""A graph of its own for a process of tests and whatever it starts: nobody else is on it, and nothing of it stays.

The processes of a graph meet in a folder (`day6_core.link.paths`). So one that has a new folder sees nobody but those who inherit
its variables: no other test, no desktop, and not the daemon of the user's own graph.
"""

from __future__ import annotations

import atexit
import os
import re
import shutil
import stat
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path

from day6_core.guardian import MARK, end_marked, new_mark
from day6_core.link.paths import process_exists
from day6_core.ros.environment import as_program
from day6_core.virtual.surroundings import environment as virtual_environment

RUN = "DAY6_TEST_RUN"
"""Set where pytest may start workers: one that finds it makes its own graph in place of joining that of the run."""

_NAME = re.compile(r"day6-test(\d+)-[a-z0-9_]{8}")
_ABANDONED = 3600.0
"""Seconds after which a folder that nothing has changed is taken for that of a process that was killed, if that one is gone.

Not at once: the process may live in another container, which has numbers of its own.
"""


def environment_of_test(variables: Mapping[str, str], folder: Path, *, fast: bool = False) -> dict[str, str]:
    """Return the variables of a test process whose graph, logs and marks are those of `folder`.

    Every test process gets its variables here, whoever starts it. `fast`: a program of Python, in virtual time.
    """
    env = as_program(dict(variables))
    if fast:
        env = virtual_environment(env)
    env["DAY6_RUNTIME_DIR"] = str(folder / "graph")
    if not env.get("ROS_LOG_DIR"):
        env["ROS_LOG_DIR"] = str(folder / "log")
    env[MARK] = new_mark()
    return env


@contextmanager
def own_graph(variables: Mapping[str, str], *, fast: bool = False) -> Iterator[dict[str, str]]:
    """Provide the variables of a test process; afterwards end what it has left running, and remove its folder."""
    folder = _make_folder()
    env = {**environment_of_test(variables, folder, fast=fast), RUN: "1"}
    env.pop("PYTEST_XDIST_WORKER", None)  # of whoever runs us, perhaps; this process is no worker of that run
    end = partial(_end, folder, env[MARK], os.getpid())
    atexit.register(end)  # whoever is interrupted may not come back here
    try:
        yield env
    finally:
        end()
        atexit.unregister(end)


def graph_until_exit(variables: Mapping[str, str]) -> tuple[Path, dict[str, str]]:
    """Make a graph for this process itself; returns its folder and the variables to take. All of it ends with this process."""
    folder = _make_folder()
    env = environment_of_test(variables, folder)
    atexit.register(_end, folder, env[MARK], os.getpid())
    return folder, env


def _end(folder: Path, mark: str, process: int) -> None:
    if os.getpid() == process:  # not in the child of a fork
        end_marked(mark)
        shutil.rmtree(folder, ignore_errors=True)


def _make_folder() -> Path:
    """Make a private folder with a short path, for it holds sockets."""
    place = Path("/tmp") if os.name == "posix" and os.access("/tmp", os.W_OK | os.X_OK) else Path(tempfile.gettempdir())
    remove_abandoned(place)
    return Path(tempfile.mkdtemp(prefix=f"day6-test{os.getpid()}-", dir=place))


def remove_abandoned(place: Path) -> None:
    """Remove from a folder those that killed processes of this user have left in it."""
    for entry in os.scandir(place):
        if (found := _NAME.fullmatch(entry.name)) is None or process_exists(int(found[1])):
            continue
        with suppress(OSError):  # another process removes it, too
            status = entry.stat(follow_symlinks=False)
            mine = sys.platform == "win32" or status.st_uid == os.getuid()
            if mine and stat.S_ISDIR(status.st_mode) and time.time() - status.st_mtime > _ABANDONED:
                shutil.rmtree(entry.path, ignore_errors=True)
