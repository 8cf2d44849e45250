"""Warns of selected packages that an underlay has as well, where other packages there need them (colcon-override-check)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from pathlib import Path

from ament_index_python.resources import names_in
from ament_index_python.search_paths import BUILT_IN_PREFIX, get_search_paths

from day6_core.ros.distribution import current
from day6_core.workspace.manifest import ManifestError, read_manifest

_DESKTOP = frozenset({
    "action_tutorials_cpp", "action_tutorials_interfaces", "action_tutorials_py", "composition", "demo_nodes_cpp",
    "demo_nodes_py", "dummy_map_server", "dummy_robot_bringup", "dummy_sensors",
    "examples_rclpy_minimal_action_client", "examples_rclpy_minimal_action_server",
    "examples_rclpy_minimal_client", "examples_rclpy_minimal_publisher", "examples_rclpy_minimal_service",
    "examples_rclpy_minimal_subscriber", "image_tools", "lifecycle", "logging_demo", "rviz2",
    "teleop_twist_keyboard", "turtlesim",
})  # fmt: skip
"""What nothing but the package `desktop` of a real /opt/ros needs (ros2/variants), which has no files of its own."""

_ADVICE = """
If a package in a merged underlay workspace is overridden and it installs headers, then all packages in the overlay must sort \
their include directories by workspace order. Failure to do so may result in build failures or undefined behavior at run time.
If the overridden package is used by another package in any underlay, then the overriding package in the overlay must be API and \
ABI compatible or undefined behavior at run time may occur.

If you understand the risks and want to override a package anyways, add the following to the command line:
\t--allow-overriding {names}

This may be promoted to an error in a future release of colcon-override-check."""
"""Its words (Apache-2.0), which pupils search for."""


def warning(
    selected: Collection[str], allowed: Iterable[str], install_base: Path, environment: Mapping[str, str]
) -> str:
    """Return what colcon warns of before it builds the packages `selected`, '' if none overrides another one's dependency."""
    underlay = [
        (name, prefix)
        for prefix in get_search_paths(environment)
        if Path(prefix) != install_base
        for name in names_in(prefix, "packages")
    ]
    overriding = {name for name, _ in underlay if name in selected}.difference(allowed)
    if not overriding:
        return ""
    index = install_base / "share" / "colcon-core" / "packages"
    built = {entry.name for entry in index.iterdir()} if index.is_dir() else set()
    needed = {name for name in overriding & _DESKTOP if (name, BUILT_IN_PREFIX) in underlay}
    for name, prefix in underlay:
        if name not in selected and name not in built:
            needed |= overriding.intersection(_run_dependencies(Path(prefix, "share", name), environment))
    if not needed:
        return ""
    places = "".join(
        f"\n\t'{name}' is in: {', '.join(_shown(prefix) for each, prefix in underlay if each == name)}"
        for name in sorted(needed)
    )
    text = f"Some selected packages are already built in one or more underlay workspaces:{places}"
    return text + _ADVICE.format(names=" ".join(sorted(needed)))


def _run_dependencies(share: Path, environment: Mapping[str, str]) -> list[str]:
    try:
        manifest = read_manifest(share, str(share), environment)
    except ManifestError:
        return []
    return manifest.run_depends if manifest is not None else []


def _shown(prefix: str) -> str:
    return f"/opt/ros/{current()}" if prefix == BUILT_IN_PREFIX else prefix
