"""Tests that run beside launched programs: a `generate_test_description`, and unittest classes that look at what it launches.

Names, signatures and texts are those of ros2/launch's launch_testing. A launch test is run by the command `launch_test`, or by
pytest, whose plugin (`launch_testing.pytest.hooks`) is found by the `launch_testing-….dist-info` beside this folder. Every pytest
loads that plugin, so everything else is imported when it is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch_testing import actions, asserts, event_handlers, markers, tools, util
    from launch_testing.decorator import post_shutdown_test
    from launch_testing.io_handler import ActiveIoHandler, IoHandler
    from launch_testing.parametrize import parametrize
    from launch_testing.proc_info_handler import ActiveProcInfoHandler, ProcInfoHandler
    from launch_testing.ready_aggregator import ReadyAggregator
    from launch_testing.ready_to_test_action_timeout import ready_to_test_action_timeout

_MODULES = {
    "ActiveIoHandler": "io_handler",
    "ActiveProcInfoHandler": "proc_info_handler",
    "IoHandler": "io_handler",
    "ProcInfoHandler": "proc_info_handler",
    "ReadyAggregator": "ready_aggregator",
    "post_shutdown_test": "decorator",
}
"""The names that come from a module of another name."""

__all__ = [
    "ActiveIoHandler",
    "ActiveProcInfoHandler",
    "IoHandler",
    "ProcInfoHandler",
    "ReadyAggregator",
    "actions",
    "asserts",
    "event_handlers",
    "markers",
    "parametrize",
    "post_shutdown_test",
    "ready_to_test_action_timeout",
    "tools",
    "util",
]


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = import_module(f"{__name__}.{_MODULES.get(name, name)}")
    found = getattr(module, name, module)
    globals()[name] = found
    return found
