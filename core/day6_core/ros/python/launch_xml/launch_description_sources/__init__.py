"""XML launch files as sources."""

from __future__ import annotations

from launch_xml.launch_description_sources.xml_launch_description_source import XMLLaunchDescriptionSource

__all__ = ["XMLLaunchDescriptionSource"]
