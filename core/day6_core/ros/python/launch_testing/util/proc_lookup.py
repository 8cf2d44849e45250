"""Finds the launched processes that a test means."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol

from launch.actions import ExecuteLocal
from launch.substitutions import TextSubstitution

NO_CMD_ARGS = object()
"""As `cmd_args`: the process without arguments."""


class HasProcesses(Protocol):
    """What has recorded processes: the handlers of output and of exit codes."""

    def processes(self) -> Iterable[Any]: ...


class NoMatchingProcessException(Exception):
    """Raised if nothing is recorded of the process that is asked for."""


def resolveProcesses(
    info_obj: HasProcesses, *, process: Any = None, cmd_args: Any = None, strict_proc_matching: bool = True
) -> list[Any]:
    """Return the recorded processes that are meant, as their actions.

    `process` is an action, a part of the name of a process (`talker-1`), or None for all of them. `cmd_args`, a word or several,
    or NO_CMD_ARGS, chooses between processes of that name. Raises NoMatchingProcessException if there is none, TypeError for any
    other `process`, and Exception if there are several and `strict_proc_matching`.
    """
    recorded = list(info_obj.processes())
    if process is None:
        if not recorded:
            raise NoMatchingProcessException("No data recorded for any process")
        return recorded
    if isinstance(process, ExecuteLocal):
        if process not in recorded:
            raise NoMatchingProcessException(f"No data recorded for proc {_name_and_arguments(process)}")
        return [process]
    if not isinstance(process, str):
        raise TypeError(f"proc argument must be 'ExecuteProcess' or 'str' not {type(process)}")
    words = [cmd_args] if isinstance(cmd_args, str) else cmd_args
    found = [each for each in recorded if process in each.process_details["name"] and _has(each, words)]
    if found and not (strict_proc_matching and len(found) > 1):
        return found
    names = ", ".join(sorted(map(_name_and_arguments, recorded)))
    if found:
        raise Exception(f"Found multiple processes matching name '{process}' and cmd_args '{words}'. Procs: {names}")
    raise NoMatchingProcessException(
        f"Did not find any processes matching name '{process}' and args '{words}'. Procs: {names}"
    )


def _has(process: Any, words: Any) -> bool:
    """Return whether a process has these arguments."""
    given = process.process_details["cmd"][1:]
    if words is None:
        return True
    return not given if words is NO_CMD_ARGS else all(word in given for word in words)


def _name_and_arguments(process: Any) -> str:
    details = process.process_details
    if details:
        return f"{details['name']} {' '.join(details['cmd'][1:])}"
    words = process.process_description.cmd
    if not all(isinstance(part, TextSubstitution) for word in words for part in word):
        return "Unknown - Process not launched yet"
    return " ".join("".join(part.text for part in word) for word in words)
