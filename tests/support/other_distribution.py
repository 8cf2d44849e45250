"""Making this process one of another distribution for a test."""

from __future__ import annotations

import contextlib
import importlib
import os
from collections.abc import Callable, Iterator

import pytest

from day6_core.interfaces import registry, type_hash
from day6_core.places import data_folder
from day6_core.ros import distribution

DECIDED_AT_IMPORT = (
    "day6_core.interfaces.checks",
    "day6_core.ros.programs.day6_inspector.rules",
    "day6_core.ros.programs.demo_messages",
    "day6_core.ros.programs.fibonacci_interface",
    "day6_core.ros.programs.turtlesim_interfaces",
    "launch.actions",
    "rclpy",
    "rclpy._day6.own_services",
    "rclpy.qos",
    "rosbag2_py._storage",
)
"""The modules that ask for the distribution while they are imported (`tests/distribution` compares it with them)."""


@pytest.fixture
def in_distribution(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Return what makes this process one of a distribution until the test ends.

    A process has one distribution and keeps each class of an interface that it has made, and each module that it has imported.
    They are made first, so that no test of this process, which may come in any order, meets one of the other distribution.
    """
    for package in registry.packages():
        for name in registry.interface_names(package):
            type_hash(registry.find_class(f"{package}/{name}"))
    for module in DECIDED_AT_IMPORT:
        importlib.import_module(module)

    def enter(name: str) -> None:
        monkeypatch.setattr(distribution, "_current", name)

    return enter


@pytest.fixture(autouse=True)
def nothing_chosen() -> Iterator[None]:
    """Forget what was chosen (the distribution, a theme …): all tests of a process share the file of settings."""
    path = data_folder() / "settings.json"
    yield
    with contextlib.suppress(FileNotFoundError):
        os.remove(path)  # some tests let Path.unlink fail
