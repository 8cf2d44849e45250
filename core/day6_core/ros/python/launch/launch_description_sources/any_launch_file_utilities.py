"""Loads launch files of every kind."""

from __future__ import annotations

import os
from collections.abc import Callable

from launch.frontend.parser import Parser
from launch.invalid_launch_file_error import InvalidLaunchFileError
from launch.launch_description import LaunchDescription
from launch.launch_description_sources.frontend_launch_file_utilities import (
    get_launch_description_from_frontend_launch_file,
)
from launch.launch_description_sources.python_launch_file_utilities import (
    get_launch_description_from_python_launch_file,
)

__all__ = ["InvalidLaunchFileError", "get_launch_description_from_any_launch_file"]


def get_launch_description_from_any_launch_file(
    launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """Load a launch file, trying the language of its extension first. Raises InvalidLaunchFileError with all errors."""

    def from_frontend(path: str) -> LaunchDescription:
        return get_launch_description_from_frontend_launch_file(path, parser=parser)

    loaders: list[Callable[[str], LaunchDescription]] = [from_frontend, get_launch_description_from_python_launch_file]
    name = os.path.basename(launch_file_path)
    extension = os.path.splitext(name)[1][1:]
    if extension == "py":
        loaders.reverse()
    elif not parser.is_filename_valid(name):
        extension = ""
    errors: list[Exception] = []
    for load in loaders:
        try:
            return load(launch_file_path)
        except Exception as error:
            errors.append(error)
    raise InvalidLaunchFileError(extension, likely_errors=errors)
