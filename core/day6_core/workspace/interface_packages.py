"""Finds the packages that a package exports, and those of them with interfaces, as rosidl_cmake collects them.

A package exports dependencies (`ament_export_dependencies`, which `rosidl_generate_interfaces` calls with its DEPENDENCIES), and
`find_package` finds those too, recursively: `nav_msgs` brings `geometry_msgs`, which brings `std_msgs`. A package built by
CMake, or here, lists them in `share/<package>/cmake/ament_cmake_export_dependencies-extras.cmake`; for those that come with
day6-tui they are taken from the package.xml.
Sources: rosidl_cmake/cmake/rosidl_generate_interfaces.cmake, ament_cmake_export_dependencies.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from day6_core.workspace.manifest import ManifestError, read_manifest

EXPORTS = "cmake/ament_cmake_export_dependencies-extras.cmake"
"""The file below `share/<package>` that lists the exported packages."""

LEFT_OUT = "share/ament_index/resource_index/day6_left_out_interfaces"
"""The resource of the ament index in which a package lists its interfaces that were not built: name and reason in each line."""

GENERATORS = {
    "rosidl_default_generators": ("action_msgs", "service_msgs"),
    "rosidl_default_runtime": ("action_msgs", "service_msgs"),
}
"""The packages that the code generators export (rosidl_defaults)."""

_EXPORTED = re.compile(r'set\(_exported_dependencies "([^"]*)"\)')


def exports_text(names: Iterable[str]) -> str:
    """Return the text of the file that lists the exported packages."""
    return f'set(_exported_dependencies "{";".join(names)}")\n'


class InterfacePackages:
    """The packages a build can find; `prefixes` maps each to its install prefix."""

    def __init__(self, prefixes: Mapping[str, str], environment: Mapping[str, str]) -> None:
        self._prefixes = prefixes
        self._environment = environment
        self._exported: dict[str, list[str]] = {}

    def share(self, package: str) -> Path | None:
        """Return the share folder of a package, None if there is none."""
        prefix = self._prefixes.get(package)
        return Path(prefix, "share", package) if prefix is not None else None

    def exported(self, package: str) -> list[str]:
        """Return the packages that a package exports directly."""
        if package not in self._exported:
            self._exported[package] = list(GENERATORS.get(package, ())) or self._read(package)
        return self._exported[package]

    def with_exported(self, packages: Iterable[str]) -> list[str]:
        """Return packages and everything they export, directly or indirectly, in the order of discovery."""
        found: dict[str, None] = {}
        waiting = list(packages)[::-1]
        while waiting:
            name = waiting.pop()
            if name not in found:
                found[name] = None
                waiting.extend(reversed(self.exported(name)))
        return list(found)

    def has_type(self, package: str, interface: str) -> bool:
        """Return whether an installed package has an interface like `msg/Header`."""
        share = self.share(package)
        kind, _, name = interface.partition("/")
        return share is not None and any((share / kind / f"{name}.{end}").is_file() for end in (kind, "idl"))

    def left_out(self, package: str) -> dict[str, str]:
        """Return the interfaces that the build of a package left out, like `msg/Point`, and why."""
        try:
            lines = Path(self._prefixes.get(package, ""), LEFT_OUT, package).read_text(encoding="utf-8").splitlines()
        except OSError:
            return {}
        return {name: why for name, _, why in (line.partition(" ") for line in lines)}

    def _read(self, package: str) -> list[str]:
        share = self.share(package)
        if share is None:
            return []
        try:
            text = (share / EXPORTS).read_text(encoding="utf-8", errors="replace")
        except OSError:
            return self._read_manifest(share)
        found = _EXPORTED.search(text)
        return [name for name in found[1].split(";") if name] if found else []

    def _read_manifest(self, share: Path) -> list[str]:
        try:
            manifest = read_manifest(share, share.name, self._environment)
        except ManifestError:
            return []
        return [] if manifest is None else manifest.run_depends
