"""Escalation for a process that ignores SIGINT: SIGTERM after a while, then SIGKILL."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launch.actions.emit_event import EmitEvent
from launch.actions.opaque_function import OpaqueFunction
from launch.actions.timer_action import TimerAction
from launch.events import matches_action
from launch.events.process import SignalProcess

if TYPE_CHECKING:
    from launch.actions.execute_local import ExecuteLocal
    from launch.launch_context import LaunchContext

_TOO_SLOW = "process[{}] failed to terminate '{}' seconds after receiving '{}', escalating to '{}'"


def escalation(
    action: ExecuteLocal, name: str, sigterm_timeout: str, sigkill_timeout: str, log_error: Callable[[str], None]
) -> list[TimerAction]:
    """Return the timers that send SIGTERM and SIGKILL to the process `name` of an action.

    The timeouts are seconds, as the text that is logged: from now to SIGTERM, and from there to SIGKILL.
    """

    def log(_: LaunchContext, text: str) -> None:
        log_error(text)

    both = str(float(sigterm_timeout) + float(sigkill_timeout))
    timers = []
    steps: tuple[tuple[str, str, Any], ...] = (
        (sigterm_timeout, "SIGINT", signal.SIGTERM),
        (both, "SIGTERM", "SIGKILL"),
    )
    for period, before, number in steps:
        next_name = number if isinstance(number, str) else number.name
        event = SignalProcess(signal_number=number, process_matcher=matches_action(action))
        timers.append(
            TimerAction(
                period=float(period),
                actions=[
                    OpaqueFunction(function=log, args=[_TOO_SLOW.format(name, period, before, next_name)]),
                    EmitEvent(event=event),
                ],
                cancel_on_shutdown=False,
            )
        )
    return timers
