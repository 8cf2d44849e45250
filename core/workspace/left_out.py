"""What of a package cannot be built here because it is C++, and the note of it that a build leaves for `ros2 run`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from day6_tui.core.ros.programs import executables
from day6_tui.core.workspace.cmake import Command
from day6_tui.core.workspace.files import Output

_LIBRARIES = frozenset({"add_library", "ament_auto_add_library", "pybind11_add_module", "python3_add_library"})
_EXECUTABLES = frozenset({"add_executable", "ament_auto_add_executable"})
_COMPONENT = "rclcpp_components_register_node"
_NOTHING_TO_COMPILE = frozenset({"IMPORTED", "ALIAS", "INTERFACE"})

_NOTE = "share/ament_index/resource_index/day6_left_out"
"""The resource of the ament index in which a package names its programs that were not built, one a line."""


@dataclass(frozen=True)
class LeftOut:
    """Names of targets, in their order."""

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
    """Return what a compiler would make of a package."""
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


def write_note(output: Output, prefix: Path, package: str, left_out: LeftOut) -> None:
    """Note the programs that were left out; where there are none, a note of an earlier build becomes empty."""
    note = prefix / _NOTE / package
    if left_out.executables or note.is_file():
        output.write_text(note, "".join(f"{name}\n" for name in left_out.executables))


def stand_ins(package: str, left_out: Iterable[str]) -> list[str]:
    """Return which of a package's left-out programs came with day6-tui, in a package of that name, and are started instead.

    A built package hides the one of the same name underneath, with all of its programs: whoever builds ros2/demos would have
    no demo_nodes_cpp talker any more.
    """
    ours = executables(package)
    return [name for name in left_out if name in ours]


def why_not(prefix: str, package: str, executable: str) -> str:
    """Return a line that says why the build made no such program; nothing where it had no reason that we know."""
    if executable not in noted_programs(prefix, package):
        return ""
    return f"\n('{executable}' is a C++ program: day6-tui has no compiler, and so 'colcon build' left it out of '{package}')"


def noted_programs(prefix: str, package: str) -> list[str]:
    """Return the programs that the build of an installed package left out."""
    try:
        return Path(prefix, _NOTE, package).read_text(encoding="utf-8", errors="replace").split()
    except OSError:
        return []
