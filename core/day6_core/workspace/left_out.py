"""The C++ targets of a package, not built here, and the note a build leaves of them (see `day6_core.ros.left_out`)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from day6_core.ros.left_out import NOTE
from day6_core.workspace.cmake import Command
from day6_core.workspace.files import BuildOutput

_LIBRARIES = frozenset({"add_library", "ament_auto_add_library", "pybind11_add_module", "python3_add_library"})
_EXECUTABLES = frozenset({"add_executable", "ament_auto_add_executable"})
_COMPONENT = "rclcpp_components_register_node"
_NOTHING_TO_COMPILE = frozenset({"IMPORTED", "ALIAS", "INTERFACE"})


@dataclass(frozen=True)
class LeftOut:
    """The names of left-out targets, in order."""

    executables: list[str]
    libraries: list[str]

    def __bool__(self) -> bool:
        return bool(self.executables or self.libraries)

    def __str__(self) -> str:
        parts = (("executable", "executables", self.executables), ("library", "libraries", self.libraries))
        return "; ".join(
            f"{one if len(names) == 1 else more} {', '.join(names)}" for one, more, names in parts if names
        )


def left_out(commands: Iterable[Command]) -> LeftOut:
    """Return the targets for which a compiler is needed."""
    programs: dict[str, None] = {}
    libraries: dict[str, None] = {}
    for command in commands:
        name = command.words[:1]
        if command.name in _EXECUTABLES and not _NOTHING_TO_COMPILE & set(command.words):
            programs.update(dict.fromkeys(name))
        elif command.name in _LIBRARIES and not _NOTHING_TO_COMPILE & set(command.words):
            libraries.update(dict.fromkeys(name))
        elif command.name == _COMPONENT:
            programs.update(dict.fromkeys(command.after("EXECUTABLE")[:1]))
    return LeftOut(list(programs), list(libraries))


def write_note(output: BuildOutput, prefix: Path, package: str, left_out: LeftOut) -> None:
    """Write the names of left-out programs; if there are none, empty the note of an earlier build."""
    note = prefix / NOTE / package
    if left_out.executables or note.is_file():
        output.write_text(note, "".join(f"{name}\n" for name in left_out.executables))
