"""The handlers of SIGINT and SIGTERM.

As in real rclpy a handler makes every context invalid (so that spin ends) and then calls the previous handler:
for Ctrl-C that is Python's, which raises KeyboardInterrupt; for SIGTERM there is none, and spin raises
ExternalShutdownException.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from types import FrameType
from typing import TYPE_CHECKING, Any

from day6_core.interrupts import defer
from rclpy._day6.incidental import also
from rclpy._rclpy_pybind11 import SignalHandlerOptions as SignalHandlerOptions
from rclpy.guard_condition import GuardCondition

if TYPE_CHECKING:
    import signal

    from rclpy.context import Context
else:
    import _signal as signal  # what signal is made of: in real rclpy a student's own signal.py is in nobody's way

__getattr__ = also(__name__, "InvalidHandle")


_Handler = Callable[[int, FrameType | None], Any] | int | None

_CTRL_BREAK = getattr(signal, "SIGBREAK", None)
"""On Windows the Ctrl-C of a simulated terminal arrives as SIGBREAK: a separate process group gets no other signal."""

_current = SignalHandlerOptions.NO
_previous: dict[int, _Handler] = {}


def _on_signal(number: int, frame: FrameType | None) -> None:
    from rclpy.context import _valid_contexts

    for context in _valid_contexts():
        context._invalidate()
    previous = _previous.get(number)
    if number == _CTRL_BREAK and previous == signal.SIG_DFL:
        previous = signal.default_int_handler
    if callable(previous) and not isinstance(previous, int):
        is_deferred = defer(partial(previous, number, frame))
        if not is_deferred:
            previous(number, frame)


def _install(number: int) -> None:
    if number not in _previous:
        _previous[number] = signal.getsignal(number)
        signal.signal(number, _on_signal)


def _uninstall(number: int) -> None:
    if number in _previous:
        previous = _previous.pop(number)
        # A handler that the program has set since then stays.
        if signal.getsignal(number) is _on_signal:
            signal.signal(number, signal.SIG_DFL if previous is None else previous)


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Install handlers for SIGINT, SIGTERM, both or none.

    Python allows this only in the main thread; elsewhere nothing is installed (real rclpy can).
    """
    global _current
    if not isinstance(options, SignalHandlerOptions):
        raise TypeError(
            "install_signal_handlers(): incompatible function arguments. The following argument types are supported:\n"
            f"    1. (arg0: rclpy::SignalHandlerOptions) -> None\n\nInvoked with: {options!r}"
        )
    if threading.current_thread() is not threading.main_thread():
        return
    wanted = int(options)
    for bit, number in ((1, signal.SIGINT), (1, _CTRL_BREAK), (2, signal.SIGTERM)):
        if number is None:
            continue
        if wanted & bit:
            _install(number)
        else:
            _uninstall(number)
    _current = options


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    """Return the signals that have a handler."""
    return _current


def uninstall_signal_handlers() -> None:
    """Restore the previous handlers."""
    install_signal_handlers(SignalHandlerOptions.NO)


class SignalHandlerGuardCondition(GuardCondition):
    """A guard condition that is triggered by a signal."""

    def __init__(self, context: Context | None = None) -> None:
        super().__init__(callback=None, callback_group=None, context=context)
