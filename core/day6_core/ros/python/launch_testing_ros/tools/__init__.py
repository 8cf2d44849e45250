"""Tools to compare the output of nodes."""

from __future__ import annotations

from launch_testing_ros.tools.output import basic_output_filter

__all__ = ["basic_output_filter"]
