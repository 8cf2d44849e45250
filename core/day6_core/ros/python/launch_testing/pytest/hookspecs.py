"""The hook that makes a collector of a launch test."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest


@pytest.hookspec(firstresult=True)
def pytest_launch_collect_makemodule(path: Path, parent: pytest.Collector, entrypoint: Any) -> pytest.Collector | None:
    """Return the collector of a file whose `generate_test_description` is `entrypoint`; None leaves it to others."""
