"""Launch files as sources of launch descriptions."""

from __future__ import annotations

from launch.launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource
from launch.launch_description_sources.any_launch_file_utilities import (
    InvalidLaunchFileError,
    get_launch_description_from_any_launch_file,
)
from launch.launch_description_sources.frontend_launch_description_source import FrontendLaunchDescriptionSource
from launch.launch_description_sources.frontend_launch_file_utilities import (
    InvalidFrontendLaunchFileError,
    get_launch_description_from_frontend_launch_file,
)
from launch.launch_description_sources.python_launch_description_source import PythonLaunchDescriptionSource
from launch.launch_description_sources.python_launch_file_utilities import (
    InvalidPythonLaunchFileError,
    get_launch_description_from_python_launch_file,
    load_python_launch_file_as_module,
)

__all__ = [
    "AnyLaunchDescriptionSource",
    "FrontendLaunchDescriptionSource",
    "InvalidFrontendLaunchFileError",
    "InvalidLaunchFileError",
    "InvalidPythonLaunchFileError",
    "PythonLaunchDescriptionSource",
    "get_launch_description_from_any_launch_file",
    "get_launch_description_from_frontend_launch_file",
    "get_launch_description_from_python_launch_file",
    "load_python_launch_file_as_module",
]


def __getattr__(name: str) -> object:
    """Return a source class of `launch_xml` or `launch_yaml`; those packages import this one."""
    from launch import _entry_points

    if name in _entry_points.SOURCES:
        return _entry_points.load_source(name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
