"""What a type browser shows: the fields of the types that were added, each message of them as a tree."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from day6_core.interfaces import definition_text, get_interface, interface_names, packages
from day6_core.reason import named_reason
from day6_core.ros.programs.rqt_py_common.message_form import INTERFACE_ERRORS, FieldRow, field_rows
from day6_core.ros.programs.rqt_topic.fields import element_type

PARTS = {
    "msg": (("Msg Root", ""),),
    "srv": (("Service Request", "Request"), ("Service Response", "Response")),
    "action": (("Action Goal", "Goal"), ("Action Result", "Result"), ("Action Feedback", "Feedback")),
}
"""The trees of a type by its kind: their names in rqt, and the class of each in the type's."""

MOST_TREES = 300
"""The oldest ones go."""


class MessageTree(NamedTuple):
    """A tree: its name, and its type as rqt writes it, `std_msgs/String` or `turtlesim/Spawn/Request`."""

    number: int
    name: str
    type: str
    rows: list[FieldRow]


class TypeBrowser:
    """The model of one type browser; `kind` is msg, srv or action. Any thread may call anything, one at a time."""

    def __init__(self, kind: str) -> None:
        self.kind = kind
        self.trees: list[MessageTree] = []
        self.message = ""
        """Why the last type was not added."""
        self.package = next(iter(self.packages()), "")
        """The one whose types are offered."""
        self.on_warning: Callable[[str], None] = lambda text: None
        """Gets every message, for the terminal."""
        self.version = 0
        self._number = 0

    def packages(self) -> list[str]:
        """The packages that have such types."""
        return [package for package in sorted(packages()) if interface_names(package, self.kind)]

    def types(self) -> list[str]:
        """The names of the types of the chosen package."""
        return [name.partition("/")[2] for name in interface_names(self.package, self.kind)]

    def choose_package(self, package: str) -> None:
        """Offer the types of this package."""
        self.package = package
        self.version += 1

    def add(self, name: str) -> None:
        """Show a type of the chosen package."""
        self.version += 1
        full, self.message = f"{self.package}/{self.kind}/{name}", ""
        try:
            kind: Any = get_interface(full)
            rows = [field_rows((getattr(kind, part) if part else kind)(), 1) for _, part in PARTS[self.kind]]
        except INTERFACE_ERRORS as error:
            self.message = f"Failed to load class {full}: {error}"
            self.on_warning(self.message)
            return
        for (title, part), fields in zip(PARTS[self.kind], rows, strict=True):
            self._number += 1
            type_name = f"{self.package}/{name}" + (f"/{part}" if part else "")
            self.trees.append(MessageTree(self._number, title, type_name, fields))
        del self.trees[:-MOST_TREES]

    def remove(self, number: int) -> None:
        """Show a tree no longer."""
        self.trees = [tree for tree in self.trees if tree.number != number]
        self.version += 1

    def text(self, type_name: str) -> str:
        """The text that defines a type, which is written as in a tree; of a plain type its name."""
        base = element_type(type_name) or type_name
        parts = base.split("/")
        if len(parts) < 2:
            return base
        # As in rqt: a message has one slash, what belongs to a service or an action two.
        kind = "msg" if len(parts) == 2 else self.kind
        try:
            return definition_text(f"{parts[0]}/{kind}/{parts[1]}")
        except (LookupError, OSError, ValueError) as error:
            return named_reason(error)
