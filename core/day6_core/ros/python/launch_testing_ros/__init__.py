"""What launch tests of ROS nodes are written with, on top of launch_testing. Names and signatures are launch_testing_ros's.

Its pytest plugin is loaded by every pytest, as launch_testing's is, so everything else is imported when it is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch_testing_ros import tools
    from launch_testing_ros.data_republisher import DataRepublisher
    from launch_testing_ros.message_pump import MessagePump
    from launch_testing_ros.test_runner import LaunchTestRunner
    from launch_testing_ros.wait_for_topics import WaitForTopics

_MODULES = {
    "DataRepublisher": "data_republisher",
    "LaunchTestRunner": "test_runner",
    "MessagePump": "message_pump",
    "WaitForTopics": "wait_for_topics",
    "tools": "tools",
}

__all__ = ["DataRepublisher", "LaunchTestRunner", "MessagePump", "WaitForTopics", "tools"]


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = import_module(f"{__name__}.{_MODULES[name]}")
    return getattr(module, name, module)
