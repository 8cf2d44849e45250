"""Builds the messages, services and actions of a package: `rosidl_generate_interfaces` in its CMakeLists.txt.

Errors are those of CMake and of the code generators. Interfaces that use a package that ROS has and day6-tui has not are left
out, with those that use them, and so is a definition in IDL; the package's other interfaces are built. Which ones are left out
is noted in the ament index, for packages that use them.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Set
from dataclasses import dataclass
from pathlib import Path

from day6_core.interfaces.definition import (
    InvalidSpecification,
    Structure,
    parse_action,
    parse_message,
    parse_service,
)
from day6_core.interfaces.package import package_files
from day6_core.interfaces.values import InvalidValue
from day6_core.workspace.build_python import python_library
from day6_core.workspace.cmake import CMakeError, Command
from day6_core.workspace.interface_packages import LEFT_OUT, InterfacePackages
from day6_core.workspace.packages import Package
from day6_core.workspace.settings import BuildSettings

INTERFACES = "rosidl_generate_interfaces"
_GROUP = "rosidl_interface_packages"
_SUFFIXES = ("msg", "srv", "action", "idl")
_KEYWORDS = ("DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "ADD_LINTER_TESTS", "SKIP_GROUP_MEMBERSHIP_CHECK")
_NO_IDL = "day6-tui reads .msg, .srv and .action, not .idl"


class GeneratorError(ValueError):
    """An error of the code generator for interfaces; its last line is the real generator's."""

    def __init__(self, last_line: str, about: str) -> None:
        super().__init__(f"{last_line}\n({about})\n")


@dataclass(frozen=True)
class _Definition:
    """A file with an interface; `uses` are the types of its fields, like 'std_msgs/msg/Header'."""

    file: str
    source: Path
    text: str
    uses: list[str]

    @property
    def kind(self) -> str:
        return self.source.suffix[1:]

    @property
    def shown(self) -> str:
        """The name as in `ros2 interface list`, without the package: 'msg/Header'."""
        return f"{'msg' if self.kind == 'idl' else self.kind}/{self.source.stem}"


class InterfaceBuild:
    """The interfaces of one package. `found` are packages of `find_package`; `lacks(name)`: ROS has it, day6-tui has not."""

    def __init__(
        self,
        package: Package,
        settings: BuildSettings,
        packages: InterfacePackages,
        found: Set[str],
        lacks: Callable[[str], bool],
    ) -> None:
        self.package = package
        self.settings = settings
        self.output = settings.output
        self.prefix = settings.prefix(package.name)
        self.packages = packages
        self.found = found
        self.lacks = lacks
        self.made = False
        """Whether there is something for Python to import."""
        self.exported: dict[str, None] = {}
        """Packages that a package with interfaces exports."""
        self.left_out: dict[str, str] = {}
        """interface, like 'msg/Point' -> why it is left out"""

    def generate(self, command: Command) -> None:
        """Check all definitions, then install those that aren't left out."""
        if not self.found & {"rosidl_default_generators", "rosidl_core_generators", "rosidl_cmake"}:
            raise CMakeError(f'Unknown CMake command "{INTERFACES}".', command.line, "", command.file)
        if (
            self.package.manifest is not None
            and _GROUP not in self.package.manifest.groups
            and not {"SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK"} & set(command.words)
        ):
            raise command.error(
                f"Packages installing interfaces must include '<member_of_group>{_GROUP}</member_of_group>' in their "
                "package.xml"
            )
        files = [word for word in _before_keywords(command.words[1:]) if Path(word).suffix[1:] in _SUFFIXES]
        if not files:
            raise command.error(f"{INTERFACES}() called without any interface files")
        known = self._known_packages(command, files)
        definitions = [self._read(file, command) for file in files]
        self._leave_out(definitions)
        listed = {each.shown for each in definitions}
        made: dict[str, list[str]] = {}
        self.made = True
        for each in definitions:
            if each.shown not in self.left_out:
                self._check(each, known, listed)
                self._install(each)
                made.setdefault(each.kind, []).append(each.source.stem)
        for path, text in package_files(self.package.name, sorted(made)).items():
            self.output.write_text(python_library(self.prefix) / path, text)
        index = "".join(f"{kind}/{name}.{kind}\n" for kind in sorted(made) for name in sorted(made[kind]))
        resources = self.prefix / "share/ament_index/resource_index"
        self.output.write_text(resources / "rosidl_interfaces" / self.package.name, index)
        note = self.prefix / LEFT_OUT / self.package.name
        if self.left_out or note.is_file():
            self.output.write_text(note, "".join(f"{name} {why}\n" for name, why in self.left_out.items()))

    def _known_packages(self, command: Command, files: list[str]) -> set[str]:
        """Return the packages whose messages may be used: DEPENDENCIES, those actions and services need, and their exports."""
        named = command.after("DEPENDENCIES", *_KEYWORDS)
        for name in named:
            if name not in self.found and not self.lacks(name):
                raise command.error(
                    f"{INTERFACES}() the passed dependency '{name}' has not been found before using find_package()"
                )
        kinds = {Path(file).suffix for file in files}
        implied = ["service_msgs"] if kinds & {".srv", ".action"} else []
        implied += ["action_msgs"] if ".action" in kinds else []
        self.exported.update(dict.fromkeys([*named, *implied]))
        return set(self.packages.with_exported([*named, *implied]))

    def _read(self, file: str, command: Command) -> _Definition:
        base, colon, inside = file.rpartition(":") if Path(file).is_absolute() else ("", "", "")
        source = Path(base, inside) if colon else command.folder / file
        if not source.is_file():
            raise command.error(
                f"{INTERFACES}() the passed file '{source}' doesn't exist"
                if colon
                else f"{INTERFACES}() the passed file '{file}' doesn't exist relative to the CMAKE_CURRENT_SOURCE_DIR "
                f"'{command.folder}'"
            )
        text = source.read_text(encoding="utf-8", errors="surrogateescape")
        try:
            parts = self._parse(source.suffix[1:], source.stem, text)
        except (InvalidSpecification, InvalidValue, TypeError, ValueError, NameError) as error:
            raise command.error(f"Error processing idl file: {source}\n{type(error).__name__}: {error}") from error
        uses = [
            field.type.base
            for part in parts
            for field in part.fields
            if field.type.nested and "/msg/" in field.type.base
        ]
        return _Definition(file, source, text, uses)

    def _parse(self, kind: str, name: str, text: str) -> list[Structure]:
        if kind == "idl":
            return []
        if kind == "msg":
            return [parse_message(self.package.name, kind, name, text)]
        return (parse_service if kind == "srv" else parse_action)(self.package.name, kind, name, text)

    # -- what is left out ----------------------------------------------------------------------------------------------

    def _leave_out(self, definitions: list[_Definition]) -> None:
        """Find the interfaces that cannot be built here, until no further one uses one of them."""
        while new := {each.shown: why for each in definitions if (why := self._why_not(each))}:
            self.left_out |= new

    def _why_not(self, definition: _Definition) -> str:
        if definition.shown in self.left_out:
            return ""
        if definition.kind == "idl":
            return _NO_IDL
        return next(filter(None, map(self._why_not_type, definition.uses)), "")

    def _why_not_type(self, base: str) -> str:
        package, _, interface = base.partition("/")
        if package == self.package.name:
            return self.left_out.get(interface, "")
        if self.lacks(package):
            return f"day6-tui doesn't have {package}"
        return self.packages.left_out(package).get(interface, "")

    # -- what is built -------------------------------------------------------------------------------------------------

    def _check(self, definition: _Definition, known: set[str], listed: set[str]) -> None:
        """Refuse an unknown type, with the errors of generate_type_hash() in rosidl_generator_type_description."""
        for base in definition.uses:
            package, _, interface = base.partition("/")
            if package == self.package.name:
                if interface in listed:
                    continue
                folder = self.settings.build_base / package / "rosidl_generator_type_description" / package
                about = f"{definition.file} uses '{base}', which is not among the files of {INTERFACES}()"
            elif package not in known:
                about = (
                    f"{definition.file} uses '{base}', but '{package}' is not among the DEPENDENCIES of {INTERFACES}()"
                )
                raise GeneratorError(f"KeyError: '{package}'", about)
            elif self.packages.has_type(package, interface):
                continue
            else:
                folder = self.packages.share(package) or Path(package)
                about = f"{definition.file} uses '{base}', but '{package}' has no such message"
            missing = f"[Errno 2] No such file or directory: '{folder / interface}.json'"
            raise GeneratorError(f"FileNotFoundError: {missing}", about)

    def _install(self, definition: _Definition) -> None:
        target = self.prefix / "share" / self.package.name / definition.kind / definition.source.name
        if self.settings.symlink_install:
            self.output.link(definition.source, target)
        else:
            self.output.write_text(target, definition.text)


def _before_keywords(words: list[str]) -> Iterator[str]:
    """Yield the arguments of `rosidl_generate_interfaces` that belong to no keyword."""
    taking = 0
    for word in words:
        if word in _KEYWORDS:
            taking = {"DEPENDENCIES": sys.maxsize, "LIBRARY_NAME": 1}.get(word, 0)
        elif taking:
            taking -= 1
        else:
            yield word
