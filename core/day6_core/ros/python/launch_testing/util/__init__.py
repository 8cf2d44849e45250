"""What launch tests are written with: looking up processes, and one that never ends."""

from __future__ import annotations

import sys

from launch.actions import ExecuteProcess

from launch_testing.util.proc_lookup import NO_CMD_ARGS, NoMatchingProcessException, resolveProcesses

__all__ = ["NO_CMD_ARGS", "KeepAliveProc", "NoMatchingProcessException", "resolveProcesses"]

_UNTIL_INTERRUPTED = """\
import threading
try:
    while True:
        threading.Event().wait(1)
except KeyboardInterrupt:
    pass
"""


def KeepAliveProc() -> ExecuteProcess:
    """Return a process that does nothing until it is interrupted: a launch in which all others end would end before its tests."""
    return ExecuteProcess(cmd=[sys.executable, "-c", _UNTIL_INTERRUPTED])
