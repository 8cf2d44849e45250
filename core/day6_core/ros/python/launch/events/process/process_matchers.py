"""Matchers of processes, for `SignalProcess` and `ShutdownProcess`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.actions.execute_local import ExecuteLocal


def matches_pid(pid: int) -> Callable[[ExecuteLocal], bool]:
    """Return a matcher for the running process with that pid."""
    return lambda action: bool(action.process_details) and action.process_details.get("pid") == pid


def matches_name(name: str) -> Callable[[ExecuteLocal], bool]:
    """Return a matcher for the process with that name (`talker-1`)."""
    return lambda action: bool(action.process_details) and action.process_details["name"] == name


def matches_executable(executable: str) -> Callable[[ExecuteLocal], bool]:
    """Return a matcher for the processes of that executable."""
    return lambda action: bool(action.process_details) and action.process_details["cmd"][0] == executable
