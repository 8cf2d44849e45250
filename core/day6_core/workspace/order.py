"""The order in which packages are built: dependencies first, otherwise by name."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from day6_core.workspace.packages import Package


class OrderError(ValueError):
    """Packages depend on each other in a cycle, or two have the same name. The text is colcon's."""


@dataclass(eq=False)
class Planned:
    """A package in its place. `needs` are the workspace packages it depends on, directly or indirectly, in order."""

    package: Package
    needs: list[str]
    selected: bool = True


def plan(packages: Iterable[Package], *, direct: tuple[str, ...] = ()) -> list[Planned]:
    """Return the packages in build order.

    `direct` limits the categories of direct dependencies (empty: all); indirect ones count whatever their category, as they do
    in colcon-core 0.21.

    Raises:
        OrderError: packages depend on each other in a cycle.
    """
    packages = list(packages)
    names = {package.name for package in packages}
    by_name: dict[str, list[Package]] = {}
    for package in packages:
        by_name.setdefault(package.name, []).append(package)
    queued = {package: {name for name in _recursive(package, by_name, direct) if name in names} for package in packages}
    left = {package: set(needs) for package, needs in queued.items()}
    ordered: list[Package] = []
    while left:
        done = {package.name for package in ordered}
        for needs in left.values():
            needs -= done
        ready = sorted((package for package, needs in left.items() if not needs), key=lambda each: each.name)
        if not ready:
            lines = sorted(f"{package.name}: {sorted(needs)}" for package, needs in left.items())
            raise OrderError("Unable to order packages topologically:\n" + "\n".join(lines))
        ordered += ready
        for package in ready:
            del left[package]
    places = [package.name for package in ordered]
    return [Planned(package, sorted(queued[package], key=places.index)) for package in ordered]


def _recursive(package: Package, by_name: dict[str, list[Package]], direct: tuple[str, ...]) -> set[str]:
    found: set[str] = set()
    waiting = [name for name in package.dependencies(*direct) if name in by_name]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += [further for each in by_name[name] for further in each.dependencies() if further in by_name]
    # A cycle leads back to the package itself; it is reported by the other packages in it.
    return found - {package.name}


def check_unique(planned: Iterable[Planned]) -> None:
    """Raise OrderError if two selected packages have the same name."""
    places: dict[str, list[str]] = {}
    for each in planned:
        if each.selected:
            places.setdefault(each.package.name, []).append(each.package.shown)
    twice = {name: paths for name, paths in places.items() if len(paths) > 1}
    if twice:
        lines = [
            f"- {name}:" + "".join(f"\n  - {path}" for path in sorted(paths)) for name, paths in sorted(twice.items())
        ]
        raise OrderError("Duplicate package names not supported:\n" + "\n".join(lines))
