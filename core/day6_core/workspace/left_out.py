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
_COMPONENT, _COMPONENTS = "rclcpp_components_register_node", "rclcpp_components_register_nodes"
_COMPONENT_INDEX = "share/ament_index/resource_index/rclcpp_components"
_NOTHING_TO_COMPILE = frozenset({"IMPORTED", "ALIAS", "INTERFACE"})


@dataclass(frozen=True)
class LeftOut:
    """The names of left-out targets, in order, and the components in them: class -> library."""

    executables: list[str]
    libraries: list[str]
    components: dict[str, str]

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
    components: dict[str, str] = {}
    for command in commands:
        name = command.words[:1]
        if command.name in _EXECUTABLES and not _NOTHING_TO_COMPILE & set(command.words):
            programs.update(dict.fromkeys(name))
        elif command.name in _LIBRARIES and not _NOTHING_TO_COMPILE & set(command.words):
            libraries.update(dict.fromkeys(name))
        elif command.name == _COMPONENT:
            programs.update(dict.fromkeys(command.after("EXECUTABLE")[:1]))
            components.update(dict.fromkeys(command.after("PLUGIN")[:1], "".join(name)))
        elif command.name == _COMPONENTS:
            components.update(dict.fromkeys(command.words[1:], "".join(name)))
    return LeftOut(list(programs), list(libraries), components)


def write_note(output: BuildOutput, prefix: Path, package: str, left_out: LeftOut) -> None:
    """Write the names of left-out programs; if there are none, empty the note of an earlier build.

    Components are listed where a container looks for them, as a real build does: it says that it cannot load them.
    """
    if left_out.components:
        lines = (f"{plugin};lib/lib{library}.so\n" for plugin, library in left_out.components.items())
        output.write_text(prefix / _COMPONENT_INDEX / package, "".join(lines))
    note = prefix / NOTE / package
    if left_out.executables or note.is_file():
        output.write_text(note, "".join(f"{name}\n" for name in left_out.executables))
