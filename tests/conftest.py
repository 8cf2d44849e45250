"""Makes a bare checkout importable and keeps every test away from this user's real session."""

from __future__ import annotations

import importlib.util
import os
import shutil
import sys
import tempfile
import types
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

if importlib.util.find_spec("day6_tui") is None:
    namespace = types.ModuleType("day6_tui")
    namespace.__path__ = [str(ROOT)]
    sys.modules["day6_tui"] = namespace

# Nothing a test starts may meet the desktop this developer has open: its own link folder, and no link unless asked.
OWN_FOLDERS = [tempfile.mkdtemp(prefix=f"day6-{what}-") for what in ("tests", "logs", "data")]
os.environ["DAY6_RUNTIME_DIR"] = OWN_FOLDERS[0]
os.environ["DAY6_LINK"] = "off"
os.environ.pop("ROS_DOMAIN_ID", None)
# Where programs are told that one of them makes all the others wait (core/session/watch.py); it is a failure of the test.
WAITS = Path(OWN_FOLDERS[0]) / "waits.txt"
os.environ["DAY6_WATCH"] = str(WAITS)
# What a test logs does not belong below this developer's ~/.ros.
os.environ["ROS_LOG_DIR"] = OWN_FOLDERS[1]
os.environ["XDG_DATA_HOME"] = OWN_FOLDERS[2]

from day6_tui.core.ros.environment import activate  # noqa: E402

activate()


@pytest.fixture(autouse=True)
def nothing_waits_on_the_schedulers_thread() -> Iterator[None]:
    """Fail where a call that may block was made on the thread that runs all programs, here or in a desktop of the test."""
    WAITS.unlink(missing_ok=True)
    yield
    if WAITS.exists():
        pytest.fail(WAITS.read_text(encoding="utf-8"), pytrace=False)


def pytest_unconfigure() -> None:
    """Take the folders of this run away."""
    for folder in OWN_FOLDERS:
        shutil.rmtree(folder, ignore_errors=True)
