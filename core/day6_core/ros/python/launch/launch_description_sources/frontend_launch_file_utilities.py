"""Loads XML and YAML launch files."""

from __future__ import annotations

from launch.frontend.parser import InvalidFrontendLaunchFileError, Parser
from launch.launch_description import LaunchDescription

__all__ = ["InvalidFrontendLaunchFileError", "get_launch_description_from_frontend_launch_file"]


def get_launch_description_from_frontend_launch_file(
    frontend_launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """Return the launch description of an XML or YAML file."""
    root, own_parser = parser.load(frontend_launch_file_path)
    return own_parser.parse_description(root)
