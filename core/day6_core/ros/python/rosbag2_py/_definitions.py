"""The text of a message or service type with the types it contains, as it is stored in bags."""

from __future__ import annotations

import re
from pathlib import Path

from day6_core.interfaces import InterfaceNameError, UnknownInterfaceError, definition_text
from day6_core.interfaces.registry import package_folder, structure
from rosbag2_py._storage import MessageDefinition

_LINE = "=" * 80
_INCLUDED = re.compile(r'^#include\s+["<]([a-zA-Z0-9_/]+)\.idl[">]', re.MULTILINE)
_PARTS = {"msg": ("",), "srv": ("_Request", "_Response")}


class LocalMessageDefinitionSource:
    """Finds the texts of types among the interfaces of this machine (rosbag2_cpp's local_message_definition_source.cpp)."""

    def get_full_text(self, root_type: str) -> MessageDefinition:
        """Return the text of 'package/msg/Name' or 'package/srv/Name', followed by those of the types in it.

        An empty text is 'unknown'. Types that are derived from a service or action ('…_Event', '…_FeedbackMessage') have no
        text of their own. Where a .msg file is missing, the .idl file counts.
        """
        text = _Text()
        try:
            if "/srv/" in root_type:
                text.add_service(root_type)
            else:
                text.add_message(root_type)
        except (UnknownInterfaceError, InterfaceNameError, ValueError):
            return MessageDefinition(root_type, "unknown", "", "")
        return MessageDefinition(root_type, text.encoding, "\n".join(text.parts), "")


class _Text:
    """The parts of a definition so far."""

    def __init__(self) -> None:
        self.parts: list[str] = []
        self.encoding = "ros2msg"
        self._seen: set[str] = set()

    def add_message(self, name: str) -> None:
        try:
            self._add_msg(name)
        except UnknownInterfaceError:
            del self.parts[:]
            self._add_idl(name)

    def add_service(self, name: str) -> None:
        self.parts.append(_headed("SRV", name, definition_text(name)))
        for inner in _dependencies(name):
            try:
                self._add_msg(inner)
            except UnknownInterfaceError:
                self.parts.append(_headed("MSG", inner, ""))  # the original's: what it has begun stays
                self._add_idl(inner)

    def _add_msg(self, name: str) -> None:
        text = definition_text(_full(name))
        self.parts.append(_headed("MSG", name, text) if self.parts else text)
        for inner in _dependencies(_full(name)):
            if inner not in self._seen:
                self._seen.add(inner)
                self._add_msg(inner)

    def _add_idl(self, name: str) -> None:
        self.encoding = "ros2idl"
        text = _idl(name)
        self.parts.append(_headed("IDL", name, text))
        for inner in sorted(set(_INCLUDED.findall(text))):
            if inner not in self._seen:
                self._seen.add(inner)
                self._add_idl(inner)


def _headed(kind: str, name: str, text: str) -> str:
    return f"{_LINE}\n{kind}: {name}\n{text}"


def _full(name: str) -> str:
    """Return 'package/msg/Name' for 'package/Name' too."""
    package, _, base = name.rpartition("/")
    return name if "/" in package else f"{package}/msg/{base}"


def _dependencies(name: str) -> list[str]:
    """Return the types in a message or service, each as 'package/Name'."""
    _, kind, _ = name.split("/")
    fields = [field for part in _PARTS[kind] for field in structure(name + part).fields]
    return sorted({field.type.base.replace("/msg/", "/") for field in fields if field.type.nested})


def _idl(name: str) -> str:
    package, kind, base = _full(name).split("/")
    folder = package_folder(package)
    try:
        return Path(folder or "", kind, f"{base}.idl").read_text(encoding="utf-8")
    except OSError:
        raise UnknownInterfaceError(name, folder is not None) from None
