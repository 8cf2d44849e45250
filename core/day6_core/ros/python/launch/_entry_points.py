"""The packages that extend launch, by name.

In ROS these are entry points, declared in the setup.py of `launch_xml`, `launch_yaml` and `launch_ros`, which launch looks up
when it loads a launch file. They lie above launch: it imports them by these names only, and only then.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_description_source import LaunchDescriptionSource

PARSERS = {"xml": "launch_xml.parser", "yaml": "launch_yaml.parser"}
"""`launch.frontend.parser`: the module of the `Parser` of each language."""

EXTENSIONS = ("launch.actions", "launch.substitutions", "launch_ros.actions", "launch_ros.substitutions")
"""`launch.frontend.launch_extension`: the modules that expose tags and substitutions when they are imported."""

SOURCES = {
    "XMLLaunchDescriptionSource": "launch_xml.launch_description_sources",
    "YAMLLaunchDescriptionSource": "launch_yaml.launch_description_sources",
}
"""The other packages' classes that `launch.launch_description_sources` offers too, each with its module."""


def load_parsers() -> dict[str, type[Parser]]:
    """Import the parsers of all languages."""
    return {language: import_module(module).Parser for language, module in PARSERS.items()}


def load_extensions() -> None:
    """Import the modules that expose tags and substitutions."""
    for module in EXTENSIONS:
        import_module(module)


def load_source(name: str) -> type[LaunchDescriptionSource]:
    """Return a source class of another package. Raises LookupError if there is none with that name."""
    source: type[LaunchDescriptionSource] = getattr(import_module(SOURCES[name]), name)
    return source
