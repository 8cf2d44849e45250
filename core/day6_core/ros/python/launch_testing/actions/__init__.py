"""The actions of launch tests."""

from __future__ import annotations

from launch_testing.actions.gtest import GTest
from launch_testing.actions.pytest import PyTest
from launch_testing.actions.ready import ReadyToTest

__all__ = ["GTest", "PyTest", "ReadyToTest"]
