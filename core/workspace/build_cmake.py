"""Packages with a CMakeLists.txt. Messages, services and actions are built, files are installed; C++ cannot be compiled here.

Of CMake only the commands are known that such packages use. Where one is used wrongly the error is CMake's.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from ament_index_python.packages import get_packages_with_prefixes

from day6_tui.core.interfaces.definition import (
    InvalidSpecification,
    Structure,
    parse_action,
    parse_message,
    parse_service,
)
from day6_tui.core.interfaces.package import package_files
from day6_tui.core.interfaces.values import InvalidValue
from day6_tui.core.workspace.build_python import python_library
from day6_tui.core.workspace.cmake import CMakeError, Command, read_commands
from day6_tui.core.workspace.jobs import Work
from day6_tui.core.workspace.packages import Package
from day6_tui.core.workspace.settings import Settings
from day6_tui.core.workspace.setup_scripts import write_hook, write_package_scripts

_COMPILING = frozenset(
    {
        "add_executable",
        "add_library",
        "ament_auto_add_executable",
        "ament_auto_add_library",
        "rclcpp_components_register_node",
        "pybind11_add_module",
    }
)
_TOOLS = ("ament_", "rosidl_", "eigen", "python", "threads", "pkgconfig")
"""Names that begin so are parts of ROS itself that no build without C++ needs."""

_CPP = """
    angles class_loader console_bridge_vendor cv_bridge image_geometry image_transport interactive_markers
    kdl_parser laser_geometry libstatistics_collector orocos_kdl_vendor pluginlib qt_gui_cpp rcl rcl_action
    rcl_lifecycle rclcpp rclcpp_action rclcpp_lifecycle rcpputils rcutils resource_retriever rmw rosbag2_cpp
    rosbag2_storage rosbag2_transport rqt_gui_cpp rviz_ogre_vendor rviz_rendering tf2 tf2_bullet tf2_eigen tf2_kdl
    tf2_sensor_msgs urdf urdf_parser_plugin urdfdom_headers yaml_cpp_vendor
"""
"""C++ libraries of every ROS 2 desktop. Packages name them out of habit (`ros2 pkg create --dependencies rclcpp`) and then
install only Python programs, models or messages; who compiles against them is refused before."""

_INTERFACES = "rosidl_generate_interfaces"
_GROUP = "rosidl_interface_packages"
_KEYWORDS = ("DEPENDENCIES", "LIBRARY_NAME", "SKIP_INSTALL", "ADD_LINTER_TESTS", "SKIP_GROUP_MEMBERSHIP_CHECK")


def build(package: Package, settings: Settings, work: Work) -> int:
    """Build one package; returns an exit status."""
    try:
        return _CMakeBuild(package, settings, work).run()
    except CMakeError as error:
        work.stderr(str(error))
        return 1


class _CMakeBuild:
    def __init__(self, package: Package, settings: Settings, work: Work) -> None:
        self.package = package
        self.settings = settings
        self.output = settings.output
        self.work = work
        self.prefix = settings.prefix(package.name)
        self.share = self.prefix / "share" / package.name
        self.python = False
        """Whether something was installed for Python to import."""

    def run(self) -> int:
        self.output.make_folder(self.settings.build_base / self.package.name)
        lists = self.package.path / "CMakeLists.txt"
        if not lists.is_file():
            self.work.stderr(
                f'CMake Error: The source directory "{self.package.path}" does not appear to contain CMakeLists.txt.\n'
                "Specify --help for usage, or press the help button on the CMake GUI.\n"
            )
            return 1
        commands = read_commands(
            lists.read_text(encoding="utf-8", errors="replace"),
            {
                "CMAKE_CURRENT_SOURCE_DIR": str(self.package.path),
                "CMAKE_SOURCE_DIR": str(self.package.path),
                "CMAKE_INSTALL_PREFIX": str(self.prefix),
            },
        )
        compiled = [command for command in commands if command.name in _COMPILING]
        if compiled or self.package.type in ("cmake", "ros.cmake", "ros.catkin"):
            return self._cannot_compile(compiled)
        self._check_found(commands)
        for command in commands:
            if command.name == _INTERFACES:
                self._generate(command, commands)
            elif command.name == "install":
                self._install(command)
            elif command.name == "ament_python_install_package" and command.words:
                self._install_python(command)
            elif command.name == "ament_auto_package":
                for name in command.after("INSTALL_TO_SHARE", "NO_INSTALL_TO_SHARE", "INSTALL_TO_PATH"):
                    self._copy_tree(self.package.path / name, self.share / name)
        self._finish()
        return 0

    def _cannot_compile(self, commands: list[Command]) -> int:
        what = ", ".join(f"{command.name}({command.words[0]})" for command in commands if command.words)
        kind = f" ({what})" if what else ""
        self.work.stderr(
            f"day6-tui has no C++ compiler and no CMake: '{self.package.name}' cannot be built here{kind}.\n"
            "On a real ROS 2 it can: `day6-tui export` makes a zip of the workspace for there. Here Python packages are built,\n"
            "and packages with messages or with files to install.\n"
        )
        return 1

    # -- what CMake would find out -------------------------------------------------------------------------------------

    def _check_found(self, commands: list[Command]) -> None:
        known = {
            *get_packages_with_prefixes(self.settings.environment),
            *self.settings.needs.get(self.package.name, ()),
            *_CPP.split(),
        }
        for command in commands:
            if command.name != "find_package" or "REQUIRED" not in command.words:
                continue
            name = command.words[0]
            if name not in known and not name.lower().startswith(_TOOLS):
                raise CMakeError(
                    f'By not providing "Find{name}.cmake" in CMAKE_MODULE_PATH this project has asked CMake to find a package '
                    f'configuration file provided by "{name}", but CMake did not find one.\n\n'
                    f'Could not find a package configuration file provided by "{name}" with any of the following names:\n\n'
                    f"  {name}Config.cmake\n  {name.lower()}-config.cmake\n\n"
                    f'Add the installation prefix of "{name}" to CMAKE_PREFIX_PATH or set "{name}_DIR" to a directory '
                    f'containing one of the above files.  If "{name}" provides a separate development package or SDK, be '
                    "sure it has been installed.",
                    command.line,
                    command.name,
                )

    # -- interfaces ----------------------------------------------------------------------------------------------------

    def _generate(self, command: Command, commands: list[Command]) -> None:
        found = {each.words[0] for each in commands if each.name == "find_package" and each.words}
        if not found & {"rosidl_default_generators", "rosidl_cmake"}:
            raise CMakeError(f'Unknown CMake command "{_INTERFACES}".', command.line, "")
        if self.package.manifest is not None and _GROUP not in self.package.manifest.groups:
            raise CMakeError(
                f"Packages installing interfaces must include '<member_of_group>{_GROUP}</member_of_group>' in their "
                "package.xml",
                command.line,
                _INTERFACES,
            )
        files = [word for word in command.words[1:] if word.endswith((".msg", ".srv", ".action", ".idl"))]
        known = {self.package.name, *command.after("DEPENDENCIES", *_KEYWORDS)}
        made: dict[str, list[str]] = {}
        for file in files:
            made.setdefault(Path(file).suffix[1:], []).append(self._interface(file, command, known))
        if not made:
            raise CMakeError(f"{_INTERFACES}() called without any idl files", command.line, _INTERFACES)
        for path, text in package_files(self.package.name, sorted(made)).items():
            self.output.write_text(python_library(self.prefix) / path, text)
        self.python = True
        index = "".join(f"{kind}/{name}.{kind}\n" for kind in sorted(made) for name in sorted(made[kind]))
        self.output.write_text(
            self.prefix / "share/ament_index/resource_index/rosidl_interfaces" / self.package.name, index
        )

    def _interface(self, file: str, command: Command, known: set[str]) -> str:
        """Check and install one definition; returns its name."""
        source = self.package.path / file
        kind, name = source.suffix[1:], source.stem
        if not source.is_file():
            raise CMakeError(
                f"{_INTERFACES}() the passed file '{file}' doesn't exist relative to the CMAKE_CURRENT_SOURCE_DIR "
                f"'{self.package.path}'",
                command.line,
                _INTERFACES,
            )
        if kind == "idl":
            raise CMakeError(f"{file}: day6-tui reads .msg, .srv and .action, not .idl", command.line, _INTERFACES)
        text = source.read_text(encoding="utf-8", errors="surrogateescape")
        try:
            parts = self._parse(kind, name, text)
        except (InvalidSpecification, InvalidValue, TypeError, ValueError, NameError) as error:
            raise CMakeError(
                f"Error processing idl file: {source}\n{type(error).__name__}: {error}", command.line, _INTERFACES
            ) from error
        for part in parts:
            for field in part.fields:
                if field.type.nested and "/msg/" in field.type.base:
                    self._check_nested(field.type.base, file, command, known)
        target = self.share / kind / source.name
        if self.settings.symlink_install:
            self.output.link(source, target)
        else:
            self.output.write_text(target, text)
        return name

    def _parse(self, kind: str, name: str, text: str) -> list[Structure]:
        if kind == "msg":
            return [parse_message(self.package.name, kind, name, text)]
        return (parse_service if kind == "srv" else parse_action)(self.package.name, kind, name, text)

    def _check_nested(self, base: str, file: str, command: Command, known: set[str]) -> None:
        package = base.partition("/")[0]
        if package in known or package in (
            "builtin_interfaces",
            "service_msgs",
            "unique_identifier_msgs",
            "action_msgs",
        ):
            if package != self.package.name or (self.package.path / f"{base.partition('/')[2]}.msg").is_file():
                return
            raise CMakeError(f"{file}: Unknown type '{base}'", command.line, _INTERFACES)
        raise CMakeError(
            f"{file} uses '{base}', but '{package}' is not among the DEPENDENCIES of {_INTERFACES}()",
            command.line,
            _INTERFACES,
        )

    # -- files ---------------------------------------------------------------------------------------------------------

    def _install(self, command: Command) -> None:
        kind = command.words[0] if command.words else ""
        if kind not in ("DIRECTORY", "FILES", "PROGRAMS"):
            return
        ends = ("DESTINATION", "PERMISSIONS", "PATTERN", "USE_SOURCE_PERMISSIONS", "RENAME", "OPTIONAL")
        destination = command.after("DESTINATION", *ends)
        if not destination:
            raise CMakeError(f"install {kind} given no DESTINATION!", command.line, "install")
        folder = self.prefix / destination[0]
        for name in command.after(kind, *ends):
            source = self.package.path / name
            if not source.exists():
                raise CMakeError(
                    f'file INSTALL cannot find "{source}": No such file or directory.', command.line, "install"
                )
            if source.is_dir():
                inside = "" if name.endswith("/") else source.name
                self._copy_tree(source, folder / inside)
            else:
                self._copy(source, folder / source.name, executable=kind == "PROGRAMS")

    def _copy_tree(self, source: Path, target: Path) -> None:
        for folder, folders, files in os.walk(source):
            folders[:] = sorted(name for name in folders if name != "__pycache__")
            for name in sorted(files):
                path = Path(folder, name)
                self._copy(path, target / path.relative_to(source))

    def _copy(self, source: Path, target: Path, *, executable: bool = False) -> None:
        if self.settings.symlink_install:
            self.output.link(source, target)
            return
        self.output.copy(source, target, executable=executable)

    def _install_python(self, command: Command) -> None:
        name = command.words[0]
        source = self.package.path / next(iter(command.after("PACKAGE_DIR")), name)
        if not (source / "__init__.py").is_file():
            raise CMakeError(
                f"ament_python_install_package() the Python package folder '{source}' has no '__init__.py'",
                command.line,
                command.name,
            )
        self._copy_tree(source, python_library(self.prefix) / name)
        self.python = True

    def _finish(self) -> None:
        name = self.package.name
        self.output.write_text(self.prefix / "share/ament_index/resource_index/packages" / name, "")
        self._copy(self.package.path / "package.xml", self.share / "package.xml")
        write_package_scripts(self.output, self.prefix, name, list(self._hooks()), self.package.dependencies("run"))

    def _hooks(self) -> Iterator[str]:
        name = self.package.name
        if self.python:
            library = python_library(self.prefix).relative_to(self.prefix).as_posix()
            yield from write_hook(self.output, self.prefix, name, "pythonpath", "PYTHONPATH", library)
        yield from write_hook(self.output, self.prefix, name, "cmake_prefix_path", "CMAKE_PREFIX_PATH", "")
        yield from write_hook(self.output, self.prefix, name, "ament_prefix_path", "AMENT_PREFIX_PATH", "")
