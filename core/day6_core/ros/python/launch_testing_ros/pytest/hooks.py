"""The plugin: pytest runs a file as a launch test if its `generate_test_description` is marked `@pytest.mark.rostest`, too."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from launch_testing.pytest.hooks import LaunchTestItem, LaunchTestModule, collector_if_marked

if TYPE_CHECKING:
    from launch_testing_ros.test_runner import LaunchTestRunner


class LaunchROSTestItem(LaunchTestItem):
    """All test runs of one file, as one test."""

    def runner_class(self) -> type[LaunchTestRunner]:
        from launch_testing_ros.test_runner import LaunchTestRunner

        return LaunchTestRunner


class LaunchROSTestModule(LaunchTestModule):
    """A file with a launch test of ROS nodes."""

    item_class = LaunchROSTestItem


def pytest_launch_collect_makemodule(path: Path, parent: pytest.Collector, entrypoint: Any) -> pytest.Collector | None:
    return collector_if_marked("rostest", LaunchROSTestModule, path, parent, entrypoint)


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line(
        "markers", "rostest: mark a generate_test_description function as a ROS launch test entrypoint"
    )
