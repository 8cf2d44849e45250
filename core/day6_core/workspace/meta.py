"""What files besides the manifests say about packages (colcon-metadata): their names, types, dependencies, hooks and options.

`colcon.meta` and the `*.meta` files of `~/.colcon/metadata` name packages, or folders; `colcon.pkg` is in a package's own folder.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from day6_core.workspace.yaml_files import colcon_home, content_of

_META = "colcon.colcon_metadata.package_discovery.colcon_meta"
_DISCOVERY = "colcon.colcon_core.package_discovery"
_IDENTIFICATION = "colcon.colcon_core.package_identification"
_AUGMENTATION = "colcon.colcon_core.package_augmentation"
_OWN_FILE = "colcon.pkg"
_CATEGORIES = ("build", "run", "test")
_NO_OPTIONS = {"name", "type", "dependencies", "hooks", *(f"{each}-dependencies" for each in _CATEGORIES)}

Warn = Callable[..., None]
"""Called with a logger's name, the text, and the level where it is no warning."""


@dataclass
class Meta:
    """What is said about a package."""

    dependencies: dict[str, set[str]] = field(default_factory=lambda: {each: set() for each in _CATEGORIES})
    hooks: list[str] = field(default_factory=list)
    options: dict[str, Any] = field(default_factory=dict)
    """Other keys, among them options of the verbs, without their dashes at the beginning."""

    def add(self, said: Mapping[str, Any]) -> None:
        """Take what a file says. Raises TypeError for what is no list."""
        for category in _CATEGORIES:
            for key in ("dependencies", f"{category}-dependencies"):
                self.dependencies[category].update(map(str, said.get(key, ())))
        self.hooks += map(str, said.get("hooks", ()))
        _merge(self.options, {key: value for key, value in said.items() if key not in _NO_OPTIONS})


class MetaFiles:
    """The files of one call of colcon."""

    def __init__(self, warn: Warn = lambda logger, text, level="": None) -> None:
        self._warn = warn
        self._by_name: dict[str, dict[str, Any]] = {}
        self._by_path: dict[str, dict[str, Any]] = {}

    def read(self, metas: Iterable[str], cwd: Path, environment: Mapping[str, str], *, of_user: bool) -> None:
        """Read the files that `--metas` names, or folders with a `colcon.meta`, after those of the user."""
        for path in (*(_files_of_user(environment) if of_user else ()), *(cwd / meta for meta in metas)):
            try:
                self._add(path / "colcon.meta" if path.is_dir() else path)
            except (AttributeError, TypeError) as error:
                self._warn(
                    _DISCOVERY, f"Exception in package discovery extension 'colcon_meta': {error}", level="ERROR"
                )

    def _add(self, path: Path) -> None:
        said = content_of(path, lambda text: self._warn(_META, text))
        for section, known in (("names", self._by_name), ("paths", self._by_path)):
            if isinstance(found := said.get(section), dict):
                for key, value in found.items():
                    if section == "paths":
                        key = os.path.realpath(path.parent / key)
                    _merge(known.setdefault(key, {}), value)

    def identity(self, folder: Path, shown: str) -> tuple[str, str]:
        """Return the name and the type that files give the package in a folder, each '' where they don't."""
        own, placed = self._own(folder, shown), self._by_path.get(os.path.realpath(folder), {})
        found = {key: str(own.get(key) or "") for key in ("type", "name")}
        for key, value in found.items():
            self._agree(key, value, placed.get(key), shown)
            found[key] = value or str(placed.get(key) or "")
        named = self._by_name.get(found["name"], {}).get("type")
        self._agree("type", found["type"], named, found["name"])
        return found["name"], found["type"] or str(named or "")

    def _agree(self, key: str, value: str, configured: Any, what: str) -> None:
        if value and configured and value != configured:
            self._warn(
                _IDENTIFICATION, f"{key} '{value}' of package '{what}' does not match configured {key} '{configured}'"
            )

    def about(self, name: str, folder: Path, shown: str) -> Meta:
        """Return what is said about a package."""
        found = Meta()
        for said, extension in (
            (self._own(folder, shown), "colcon_pkg"),
            (self._by_name.get(name, {}), "colcon_meta"),
            (self._by_path.get(os.path.realpath(folder), {}), "colcon_meta"),
        ):
            try:
                found.add(said)
            except TypeError as error:
                text = f"Exception in package augmentation extension '{extension}': {error}"
                self._warn(_AUGMENTATION, text, level="ERROR")
        return found

    def _own(self, folder: Path, shown: str) -> Mapping[str, Any]:
        """Return what the file in a package's folder says."""
        path = folder / _OWN_FILE
        if not path.is_file():
            return {}

        def warn(text: str) -> None:
            reason = text.partition("failed to parse: ")[2]
            if reason:
                text = f"Exception in package identification extension 'colcon_pkg' in '{shown}': {reason}"
                self._warn(_IDENTIFICATION, text, level="ERROR")

        return content_of(path, warn)


def _files_of_user(environment: Mapping[str, str]) -> list[Path]:
    return [
        file
        for file in sorted((colcon_home(environment) / "metadata").rglob("*.meta"))
        if file.is_file()
        and not any(part.startswith(".") for part in file.relative_to(colcon_home(environment)).parts[:-1])
    ]


def _merge(known: dict[str, Any], said: Mapping[str, Any]) -> None:
    for key, value in said.items():
        before = known.get(key)
        if isinstance(before, dict) and isinstance(value, dict):
            known[key] = {**before, **value}
        elif isinstance(before, list) and isinstance(value, list):
            known[key] = [*before, *value]
        else:
            known[key] = value
