"""The end of real processes, waited for by the clock of `Deadline`."""

from __future__ import annotations

import subprocess
from typing import Any

from waiting import PATIENCE, Deadline


def communicate(process: subprocess.Popen[Any], given: Any = None, limit: float = PATIENCE) -> tuple[Any, Any]:
    """Do what `Popen.communicate` does; a process that does not end is killed, and AssertionError tells what it wrote."""
    deadline = Deadline(limit)
    while True:
        try:
            return process.communicate(given, timeout=0.5)
        except subprocess.TimeoutExpired:
            given = None  # it goes on with what it was given
            if deadline.is_over():
                process.kill()
                raise AssertionError(
                    f"after {limit} s it still runs: {process.args!r}", process.communicate()
                ) from None


def run(command: list[Any], given: Any = None, limit: float = 2 * PATIENCE, **options: Any) -> Any:
    """Do what `subprocess.run` does, with both streams captured and in UTF-8 unless `text` says otherwise."""
    if options.setdefault("text", True):
        options.setdefault("encoding", "utf-8")
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options
    ) as process:
        out, err = communicate(process, given, limit)
    return subprocess.CompletedProcess(command, process.returncode, out, err)
