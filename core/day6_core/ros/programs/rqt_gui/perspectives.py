"""Perspectives: which plugins are open, with their settings, kept in files of rqt's own format.

A perspective that the real rqt has exported opens here with the plugins that there are, and the other way round. What Qt
keeps in it of its windows says nothing to a terminal, and is not written.
"""

from __future__ import annotations

import ast
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.session.blocking_files import read_at_most
from day6_core.whole_file import replace_file

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUFFIX = ".perspective"
DEFAULT = "Default"
"""The perspective rqt begins with (qt_gui's perspective_manager.py)."""

LARGEST = 1_000_000
"""Bytes of a file that is read: real ones have some ten thousand."""

_CURRENT = "current-perspective"


class Instance(NamedTuple):
    """One plugin of a perspective: `<package>/<class>`, its number among those of the same class, and its settings."""

    name: str
    serial: int
    settings: Mapping[str, Any] = {}


def written(instances: list[Instance]) -> str:
    """Return the text of a perspective file."""
    running: dict[str, list[int]] = {}
    groups = {}
    for name, serial, settings in instances:
        running.setdefault(name, []).append(serial)
        values = {key: _represented(value) for key, value in settings.items()}
        groups[_group(name, serial)] = {"keys": {}, "groups": {"plugin": {"keys": values, "groups": {}}}}
    manager = {"keys": {"running-plugins": _represented(running)}, "groups": groups}
    whole = {"keys": {}, "groups": {"pluginmanager": manager}}
    return json.dumps(whole, indent=2, separators=(",", ": ")) + "\n"


def read(text: str) -> list[Instance]:
    """Return the plugins of a perspective file's text.

    Raises:
        ValueError: it is none, or damaged.
    """
    try:
        manager = _member(json.loads(text), "groups", "pluginmanager")
        running = _value(_member(manager, "keys").get("running-plugins"))
        groups = _member(manager, "groups")
        found = []
        for name, serial in _instances(running):
            keys = _member(groups.get(_group(name, serial), {}), "groups", "plugin", "keys")
            found.append(Instance(name, serial, {key: _value(value) for key, value in keys.items()}))
    except (RecursionError, MemoryError, SyntaxError, TypeError):
        raise ValueError("not a perspective") from None
    return found


def _instances(running: object) -> Iterator[tuple[str, int]]:
    if not isinstance(running, dict):
        raise ValueError("not a perspective")
    for name, serials in running.items():
        if not isinstance(name, str) or not isinstance(serials, (list, tuple)):
            raise ValueError("not a perspective")
        for serial in serials:
            yield name, int(serial)


def _group(name: str, serial: int) -> str:
    return f"plugin__{name.replace('/', '__')}__{serial}"


def _represented(value: object) -> dict[str, str]:
    return {"repr": repr(value), "type": "repr"}


def _value(entry: object) -> object:
    """The value of an entry; bytes of Qt's are None. Raises ValueError and SyntaxError."""
    if not isinstance(entry, dict) or entry.get("type") != "repr":
        return None
    text = entry.get("repr")
    return ast.literal_eval(text) if isinstance(text, str) else None


def _member(value: object, *path: str) -> dict[str, Any]:
    """The dictionary at a path, an empty one if it is not there. Raises ValueError if something else is there."""
    for step in ("", *path):
        value = value.get(step, {}) if step and isinstance(value, dict) else value
        if not isinstance(value, dict):
            raise ValueError("not a perspective")
    assert isinstance(value, dict)
    return value


def folder_of(session: Session) -> Path:
    """`~/.config/ros.org/rqt_gui`; the real rqt keeps all perspectives in one file `rqt_gui.ini` beside it."""
    return Path(session.env.get("HOME", session.cwd), ".config", "ros.org", "rqt_gui")


class Perspectives:
    """The perspectives that a user has, one file each in a folder. All methods wait for the disk."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def names(self) -> list[str]:
        """Return their names, sorted; the default one is always among them."""
        try:
            found = {path.stem for path in self.folder.iterdir() if path.suffix == SUFFIX}
        except OSError:
            found = set()
        return sorted({*found, DEFAULT})

    def current(self) -> str:
        """Return the name of the one used last."""
        try:
            with open(self.folder / _CURRENT, encoding="utf-8", errors="replace") as file:
                name = file.read(200).strip()
        except OSError:
            return DEFAULT
        return name if name in self.names() else DEFAULT

    def load(self, name: str) -> list[Instance]:
        """Return the plugins of one, none if it does not exist. Raises OSError, and ValueError for a damaged one."""
        path = self._file(name)
        return load_file(path) if path.exists() else []

    def save(self, name: str, instances: list[Instance]) -> None:
        """Keep one, which is the current one then. Raises OSError."""
        self.folder.mkdir(parents=True, exist_ok=True)
        replace_file(self._file(name), written(instances).encode("utf-8"))
        replace_file(self.folder / _CURRENT, f"{name}\n".encode())

    def remove(self, name: str) -> None:
        """Forget one. Raises OSError."""
        self._file(name).unlink(missing_ok=True)

    def clear(self) -> None:
        """Forget all. Raises OSError."""
        for name in self.names():
            self.remove(name)
        (self.folder / _CURRENT).unlink(missing_ok=True)

    def _file(self, name: str) -> Path:
        return self.folder / f"{name}{SUFFIX}"


def load_file(path: Path) -> list[Instance]:
    """Return the plugins of a perspective file. Raises OSError and ValueError."""
    return read(read_at_most(path, LARGEST).decode("utf-8"))


def save_file(path: Path, instances: list[Instance]) -> None:
    """Write a perspective file. Raises OSError."""
    replace_file(path, written(instances).encode("utf-8"))


def wrong_name(name: str) -> bool:
    """Whether a perspective cannot have this name: it is that of a file."""
    return not name or len(name.encode()) > 200 or name.startswith((".", "@")) or not set(name).isdisjoint('/\\:*?"<>|') \
        or not name.isprintable()  # fmt: skip
