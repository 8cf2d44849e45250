"""The action that starts the tests."""

from __future__ import annotations

from launch_testing.actions import ReadyToTest

__all__ = ["ReadyToTest"]
