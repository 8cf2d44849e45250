"""The runner of launch tests of ROS nodes; it does nothing that launch_testing's does not."""

from __future__ import annotations

import launch_testing.test_runner


class LaunchTestRunner(launch_testing.test_runner.LaunchTestRunner):
    """Runs launch tests marked `@pytest.mark.rostest`."""
