"""Records the output of launched processes."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from typing import Any

from launch.events.process import ProcessIO

from launch_testing.asserts.assert_output import assertInStream
from launch_testing.util.proc_lookup import NoMatchingProcessException, resolveProcesses


class IoHandler:
    """The output of all processes, in order: iterate over it, or ask for that of one process by its action or its name."""

    def __init__(self) -> None:
        self._sequence: list[ProcessIO] = []
        self._by_name: dict[str, list[ProcessIO]] = {}

    def track(self, process_name: str) -> None:
        """Note a process that has written nothing yet."""
        self._by_name.setdefault(process_name, [])

    def append(self, process_io: ProcessIO) -> None:
        self._sequence.append(process_io)
        self._by_name.setdefault(process_io.process_name, []).append(process_io)

    def __iter__(self) -> Iterator[ProcessIO]:
        return iter(self._sequence)

    def processes(self) -> list[Any]:
        """Return the actions of the processes that have written."""
        return [written[0].action for written in self._by_name.values() if written]

    def process_names(self) -> list[str]:
        """Return the names of all processes."""
        return list(self._by_name)

    def __getitem__(self, key: Any) -> list[ProcessIO]:
        """Return what a process has written. Raises KeyError for an unknown one."""
        return list(self._by_name[key if isinstance(key, str) else key.process_details["name"]])


class ActiveIoHandler:
    """What processes have written while they run: it may be used by several threads, and can wait for output."""

    def __init__(self) -> None:
        self._sync_lock = threading.Condition()
        self._io_handler = IoHandler()

    @property
    def io_event(self) -> threading.Condition:
        """The condition that is notified of each piece of output."""
        return self._sync_lock

    def track(self, process_name: str) -> None:
        with self._sync_lock:
            self._io_handler.track(process_name)
            self._sync_lock.notify_all()

    def append(self, process_io: ProcessIO) -> None:
        with self._sync_lock:
            self._io_handler.append(process_io)
            self._sync_lock.notify_all()

    def __iter__(self) -> Iterator[ProcessIO]:
        with self._sync_lock:
            return iter(list(self._io_handler))

    def processes(self) -> list[Any]:
        with self._sync_lock:
            return self._io_handler.processes()

    def process_names(self) -> list[str]:
        with self._sync_lock:
            return self._io_handler.process_names()

    def __getitem__(self, key: Any) -> list[ProcessIO]:
        with self._sync_lock:
            return self._io_handler[key]

    def assertWaitFor(self, *args: Any, **kwargs: Any) -> None:
        """Assert that output comes in time; the arguments are those of `waitFor`."""
        if not self.waitFor(*args, **kwargs):
            raise AssertionError("Waiting for output timed out")

    def waitFor(
        self, expected_output: Any, process: Any = None, cmd_args: Any = None, *, timeout: float = 10, **options: Any
    ) -> bool:
        """Wait `timeout` seconds for output of a process (None: of any); returns whether it has come.

        The rest is as in `assertInStream`. Raises NoMatchingProcessException if by then no such process has written anything.
        """

        def has_come() -> bool:
            try:
                assertInStream(self._io_handler, expected_output, process, cmd_args, **options)
            except (NoMatchingProcessException, AssertionError):
                return False
            return True

        with self._sync_lock:
            if self._sync_lock.wait_for(has_come, timeout):
                return True
        resolveProcesses(self, process=process, cmd_args=cmd_args, strict_proc_matching=False)
        return False
