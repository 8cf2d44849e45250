"""Launches single processes inside a test."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from typing import Any

from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess
from launch.events import IncludeLaunchDescription, matches_action
from launch.events.process import ProcessExited, ProcessStarted, ShutdownProcess
from launch.utilities import ensure_argument_type

from launch_testing.io_handler import ActiveIoHandler
from launch_testing.proc_info_handler import ActiveProcInfoHandler


class OutputWaited:
    """Whether what was waited for has come; printed by a failing assertion together with the output so far."""

    def __init__(self, has_come: bool, output: str | None) -> None:
        self._has_come = has_come
        self._output = output

    def __bool__(self) -> bool:
        return self._has_come

    def __repr__(self) -> str:
        return f"<BoolWithText({self._has_come}): {self._output!r}>"


class ProcessProxy:
    """What a test sees of a launched process; `output_filter` is applied to its output. Raises TypeError for other arguments."""

    def __init__(
        self,
        process_action: ExecuteProcess,
        proc_info: ActiveProcInfoHandler,
        proc_output: ActiveIoHandler,
        *,
        output_filter: Callable[[str], str] | None = None,
    ) -> None:
        ensure_argument_type(process_action, ExecuteProcess, "process_action")
        ensure_argument_type(proc_info, ActiveProcInfoHandler, "proc_info")
        ensure_argument_type(proc_output, ActiveIoHandler, "proc_output")
        if output_filter is not None and not callable(output_filter):
            raise TypeError(f"Expected 'output_filter' to be callable but got '{output_filter!r}'")
        self._process_action = process_action
        self._proc_info = proc_info
        self._proc_output = proc_output
        self._output_filter = output_filter

    def wait_for_shutdown(self, timeout: float | None = None) -> bool:
        """Wait so many seconds, or for ever, for its end; returns whether it has ended."""
        with self._proc_info.proc_event:
            return self._proc_info.proc_event.wait_for(lambda: self.terminated, timeout)

    def wait_for_output(
        self, condition: Callable[[str], bool] | None = None, timeout: float | None = None
    ) -> OutputWaited:
        """Wait until its output, both streams together, fulfils a condition, or until there is any; the result is a truth value.

        Raises TypeError for a condition that cannot be called.
        """
        if condition is not None and not callable(condition):
            raise TypeError(f"Expected 'condition' to be callable but got '{condition!r}'")
        seen: str | None = None

        def has_come() -> bool:
            nonlocal seen
            if not self.running:
                return False
            seen = self.output
            return condition is None or bool(condition(seen))

        with self._proc_output.io_event:
            return OutputWaited(self._proc_output.io_event.wait_for(has_come, timeout), seen)

    @property
    def target_process_action(self) -> ExecuteProcess:
        return self._process_action

    @property
    def stderr(self) -> str:
        return self._written(lambda io: io.from_stderr)

    @property
    def stdout(self) -> str:
        return self._written(lambda io: io.from_stdout)

    @property
    def output(self) -> str:
        return self._written(lambda io: True)

    def _written(self, wanted: Callable[[Any], bool]) -> str:
        pieces = [io.text for io in self._proc_output[self._process_action] if wanted(io)]
        text = b"".join(pieces).decode(errors="replace")
        return text if self._output_filter is None else self._output_filter(text)

    @property
    def running(self) -> bool:
        return self._last_event_is(ProcessStarted)

    @property
    def terminated(self) -> bool:
        return self._last_event_is(ProcessExited)

    def _last_event_is(self, kind: type) -> bool:
        action = self._process_action
        return action in self._proc_info.processes() and isinstance(self._proc_info[action], kind)

    @property
    def exit_code(self) -> int:
        return int(self._proc_info[self._process_action].returncode)


@contextlib.contextmanager
def launch_process(
    launch_service: LaunchService,
    process_action: ExecuteProcess,
    proc_info: ActiveProcInfoHandler,
    proc_output: ActiveIoHandler,
    **kwargs: Any,
) -> Iterator[ProcessProxy]:
    """Launch a process and give a proxy of it; it is shut down at the end of the block. The rest is as in `ProcessProxy`."""
    proxy = ProcessProxy(process_action, proc_info, proc_output, **kwargs)
    launch_service.emit_event(IncludeLaunchDescription(LaunchDescription([process_action])))
    try:
        yield proxy
    finally:
        if not proxy.terminated:
            launch_service.emit_event(ShutdownProcess(process_matcher=matches_action(process_action)))
