"""The assertion about exit codes."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from launch_testing.util.proc_lookup import resolveProcesses

EXIT_OK = 0
EXIT_SIGINT = 130
EXIT_SIGQUIT = 131
EXIT_SIGKILL = 137
EXIT_SIGSEGV = 139
EXIT_FORCED = 1
"""On Windows, where there is no SIGINT, launched processes are ended with this code."""

_ALLOWED = (EXIT_OK,) if os.name != "nt" else (EXIT_OK, EXIT_FORCED)


def assertExitCodes(
    proc_info: Any,
    allowable_exit_codes: Iterable[int] = _ALLOWED,
    process: Any = None,
    cmd_args: Any = None,
    *,
    strict_proc_matching: bool = True,
) -> None:
    """Assert that processes (all of them, or `process`, see `resolveProcesses`) have ended with one of these exit codes."""
    allowed = list(allowable_exit_codes)
    for code in allowed:
        if not isinstance(code, int):
            raise AssertionError(f"Provided exit code {code} is not an int")
    found = resolveProcesses(proc_info, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching)
    for info in (proc_info[each] for each in found):
        if info.returncode not in allowed:
            raise AssertionError(f"Proc {info.process_name} exited with code {info.returncode}")
