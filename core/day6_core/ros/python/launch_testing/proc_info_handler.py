"""Records when launched processes start, and how they end."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from typing import Any

from launch.events.process import ProcessExited

from launch_testing.util.proc_lookup import NoMatchingProcessException, resolveProcesses


class ProcInfoHandler:
    """The last event of each process, ProcessStarted or ProcessExited: by its action, or by a part of its name."""

    def __init__(self) -> None:
        self._events: dict[Any, Any] = {}

    def append(self, process_info: Any) -> None:
        self._events[process_info.action] = process_info

    def __iter__(self) -> Iterator[Any]:
        return iter(self._events.values())

    def processes(self) -> list[Any]:
        """Return the actions of all processes."""
        return list(self._events)

    def process_names(self) -> list[str]:
        return [action.process_details["name"] for action in self._events]

    def __getitem__(self, key: Any) -> Any:
        """Return the last event of a process. Raises KeyError for an unknown one."""
        if not isinstance(key, str):
            return self._events[key]
        for action, event in self._events.items():
            if key in action.process_details["name"]:
                return event
        raise KeyError(key)


class ActiveProcInfoHandler:
    """What is known of processes while they run: it may be used by several threads, and can wait for a start or an end."""

    def __init__(self) -> None:
        self._sync_lock = threading.Condition()
        self._proc_info_handler = ProcInfoHandler()

    @property
    def proc_event(self) -> threading.Condition:
        """The condition that is notified of each start and each end."""
        return self._sync_lock

    def append(self, process_info: Any) -> None:
        with self._sync_lock:
            self._proc_info_handler.append(process_info)
            self._sync_lock.notify_all()

    def __iter__(self) -> Iterator[Any]:
        with self._sync_lock:
            return iter(list(self._proc_info_handler))

    def processes(self) -> list[Any]:
        with self._sync_lock:
            return self._proc_info_handler.processes()

    def process_names(self) -> list[str]:
        with self._sync_lock:
            return self._proc_info_handler.process_names()

    def __getitem__(self, key: Any) -> Any:
        with self._sync_lock:
            return self._proc_info_handler[key]

    def assertWaitForShutdown(self, process: Any, cmd_args: Any = None, *, timeout: float = 10) -> None:
        """Assert that a process ends within `timeout` seconds."""
        if not self._wait_for(process, cmd_args, timeout, ended=True):
            raise AssertionError(f"Timed out waiting for process '{process}' to finish")

    def assertWaitForStartup(self, process: Any, cmd_args: Any = None, *, timeout: float = 10) -> None:
        """Assert that a process starts within `timeout` seconds."""
        if not self._wait_for(process, cmd_args, timeout, ended=False):
            raise AssertionError(f"Timed out waiting for process '{process}' to start")

    def _wait_for(self, process: Any, cmd_args: Any, timeout: float, *, ended: bool) -> bool:
        recorded = self._proc_info_handler

        def has_come() -> bool:
            try:
                action = resolveProcesses(recorded, process=process, cmd_args=cmd_args)[0]
            except NoMatchingProcessException:
                return False
            return not ended or isinstance(recorded[action], ProcessExited)

        with self._sync_lock:
            return self._sync_lock.wait_for(has_come, timeout)
