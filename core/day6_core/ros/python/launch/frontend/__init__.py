"""Shared by XML and YAML launch files; `launch_xml` and `launch_yaml` read the files themselves."""

from __future__ import annotations

from launch.frontend import type_utils
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action, expose_substitution
from launch.frontend.parser import InvalidFrontendLaunchFileError, Parser

__all__ = [
    "Entity",
    "InvalidFrontendLaunchFileError",
    "Parser",
    "expose_action",
    "expose_substitution",
    "type_utils",
]
