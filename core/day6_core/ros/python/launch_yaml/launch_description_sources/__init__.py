"""YAML launch files as sources."""

from __future__ import annotations

from launch_yaml.launch_description_sources.yaml_launch_description_source import YAMLLaunchDescriptionSource

__all__ = ["YAMLLaunchDescriptionSource"]
