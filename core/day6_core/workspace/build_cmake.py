"""Builds packages with a CMakeLists.txt: messages, services and actions, and installed files. C++ cannot be compiled here.

Only the CMake commands that such packages use are known. A command used wrongly gives CMake's error.

A package that contains C++ is built without it, with status 0 and a note on standard error, so that no C++ package stops the
Python packages beside it; its messages can be used by others, and its Python programs run. The names of left-out programs
are kept in the ament index (`ros/left_out`), so that `ros2 run` and launch can explain why they are missing. A package that
cannot be found is an error as in CMake, unless its C++ is left out (only the compiler would have needed it) or ROS has such a
package and day6-tui has not: then it is only named.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from pathlib import Path

from ament_index_python.packages import get_packages_with_prefixes

from day6_core.ros.left_out import replacements
from day6_core.ros.released import is_released
from day6_core.workspace.build_interfaces import INTERFACES, GeneratorError, InterfaceBuild
from day6_core.workspace.build_python import python_library
from day6_core.workspace.cmake import CMakeError, Command, read_commands
from day6_core.workspace.interface_packages import EXPORTS, InterfacePackages, exports_text
from day6_core.workspace.jobs import Work
from day6_core.workspace.left_out import LeftOut, write_note
from day6_core.workspace.left_out import left_out as find_left_out
from day6_core.workspace.option import cmake_definitions
from day6_core.workspace.packages import Package
from day6_core.workspace.settings import BuildSettings
from day6_core.workspace.setup_scripts import write_hook, write_package_scripts

_TOOLS = ("ament_", "rosidl_", "eigen", "python", "threads", "pkgconfig")
"""Prefixes of parts of ROS itself that no build without C++ needs."""

_CPP = """
    class_loader console_bridge_vendor cv_bridge image_geometry image_transport interactive_markers
    kdl_parser libstatistics_collector orocos_kdl_vendor pluginlib qt_gui_cpp rcl rcl_action
    rcl_lifecycle rclcpp rclcpp_action rclcpp_lifecycle rcpputils rcutils resource_retriever rmw rosbag2_cpp
    rosbag2_storage rosbag2_transport rqt_gui_cpp rviz_ogre_vendor rviz_rendering tf2 tf2_bullet tf2_eigen tf2_kdl
    urdf urdf_parser_plugin urdfdom_headers yaml_cpp_vendor
"""
"""C++ libraries of every ROS 2 desktop. Packages name them out of habit (`ros2 pkg create --dependencies rclcpp`) and then
install only Python programs, models or messages."""

_INSTALL_WORDS = """
    DESTINATION TYPE PERMISSIONS FILE_PERMISSIONS DIRECTORY_PERMISSIONS USE_SOURCE_PERMISSIONS OPTIONAL RENAME
    CONFIGURATIONS COMPONENT EXCLUDE_FROM_ALL MESSAGE_NEVER FILES_MATCHING PATTERN REGEX EXCLUDE
"""
"""Keywords that end a list of files in `install`, in any order (cmake manual, command `install`)."""

_TYPES = {"BIN": "bin", "LIB": "lib", "INCLUDE": "include", "DATA": "share", "SYSCONF": "etc"}
"""The folder of each TYPE of `install` (GNUInstallDirs)."""

_COMPILER = {
    "CMAKE_VERSION": "3.28.3",
    "CMAKE_C_COMPILER_ID": "GNU",
    "CMAKE_CXX_COMPILER_ID": "GNU",
    "CMAKE_CXX_COMPILER_VERSION": "13.3.0",
    "CMAKE_COMPILER_IS_GNUCC": "1",
    "CMAKE_COMPILER_IS_GNUCXX": "1",
}
"""Variables about the compiler that packages read, with the values of Ubuntu 24.04, the platform of ROS 2 Kilted."""


def build(package: Package, settings: BuildSettings, work: Work) -> int:
    """Build one package; returns an exit status."""
    try:
        return _CMakeBuild(package, settings, work).run()
    except (CMakeError, GeneratorError) as error:
        work.stderr(str(error))
        return 1


def cmake_variables(package: Package, settings: BuildSettings) -> dict[str, str]:
    """Return the variables that are set when a package's CMakeLists.txt starts."""
    here, build_folder = str(package.path), str(settings.build_base / package.name)
    prefix = settings.prefix(package.name)
    system = {"win32": "WIN32", "darwin": "APPLE"}.get(sys.platform)
    return {
        **{f"ENV{{{name}}}": value for name, value in settings.environment.items()},
        "CMAKE_CURRENT_SOURCE_DIR": here,
        "CMAKE_SOURCE_DIR": here,
        "CMAKE_CURRENT_LIST_DIR": here,
        "CMAKE_BINARY_DIR": build_folder,
        "CMAKE_CURRENT_BINARY_DIR": build_folder,
        "CMAKE_INSTALL_PREFIX": str(prefix),
        "PYTHON_INSTALL_DIR": python_library(prefix).relative_to(prefix).as_posix(),
        **_COMPILER,
        **_defined(package, settings),
        "BUILD_TESTING": "OFF",  # anything only tests need is not built here
        **({"UNIX": "1"} if sys.platform != "win32" else {}),
        **({system: "1"} if system else {}),
    }


def _defined(package: Package, settings: BuildSettings) -> dict[str, str]:
    """Return the variables that `--cmake-args` and the like define for a package."""
    options = [
        "cmake_args",
        *({"ros.ament_cmake": ["ament_cmake_args"], "ros.catkin": ["catkin_cmake_args"]}.get(package.type, [])),
    ]
    words = [word for option in options for word in settings.option(option, package) or ()]
    return cmake_definitions(words)[0]


def _not_found(name: str, command: Command) -> CMakeError:
    return CMakeError(
        f'By not providing "Find{name}.cmake" in CMAKE_MODULE_PATH this project has asked CMake to find a package '
        f'configuration file provided by "{name}", but CMake did not find one.\n\n'
        f'Could not find a package configuration file provided by "{name}" with any of the following names:\n\n'
        f"  {name}Config.cmake\n  {name.lower()}-config.cmake\n\n"
        f'Add the installation prefix of "{name}" to CMAKE_PREFIX_PATH or set "{name}_DIR" to a directory '
        f'containing one of the above files.  If "{name}" provides a separate development package or SDK, be '
        "sure it has been installed.",
        command.line,
        "find_package",
        command.file,
    )


class _CMakeBuild:
    def __init__(self, package: Package, settings: BuildSettings, work: Work) -> None:
        self.package = package
        self.settings = settings
        self.output = settings.output
        self.work = work
        self.prefix = settings.prefix(package.name)
        self.share = self.prefix / "share" / package.name
        self.python = False
        """Whether something was installed for Python to import."""
        prefixes = get_packages_with_prefixes(settings.environment)
        prefixes.update({name: str(settings.prefix(name)) for name in settings.needs.get(package.name, ())})
        prefixes.pop(package.name, None)
        self.packages = InterfacePackages(prefixes, settings.environment)
        self.found: dict[str, None] = {}
        """Packages found by `find_package`, directly or through others."""
        self.missing: list[tuple[str, Command]] = []
        self.exported: dict[str, None] = {}
        self.interfaces = InterfaceBuild(package, settings, self.packages, self.found.keys(), self._lacks)
        self.not_made: dict[str, None] = {}
        """Files to install that CMake itself would make."""

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
            cmake_variables(self.package, self.settings),
            self._find,
        )
        left_out = find_left_out(commands)
        if not left_out:
            self._refuse(commands)
        for command in commands:
            self._run(command)
        self._finish(left_out)
        stopped = next((command for command in commands if command.stops), None)
        if notes := list(self._notes(left_out, stopped)):
            self.work.stderr("\n".join([*notes, ""]))
        return 0

    def _refuse(self, commands: list[Command]) -> None:
        """Stop where CMake would: at a package that nobody has, or where the project says so."""
        for command in commands:
            if command.stops:
                raise command.error("".join(command.words[1:]))
            for name, asked in self.missing:
                if asked is command and not is_released(name):
                    raise _not_found(name, command)

    def _run(self, command: Command) -> None:
        if command.name == INTERFACES:
            self.interfaces.generate(command)
        elif command.name == "install":
            self._install(command)
        elif command.name == "ament_python_install_package" and command.words:
            self._install_python(command)
        elif command.name == "ament_python_install_module" and command.words:
            self._install_module(command)
        elif command.name == "ament_export_dependencies":
            self.exported.update(dict.fromkeys(command.words))
        elif command.name == "ament_auto_package":
            for name in command.after("INSTALL_TO_SHARE", "NO_INSTALL_TO_SHARE", "INSTALL_TO_PATH"):
                self._copy_tree(command.folder / name, self.share / name)

    # -- what is left out ----------------------------------------------------------------------------------------------

    def _notes(self, left_out: LeftOut, stopped: Command | None) -> Iterator[str]:
        """Yield the lines that say what was not built, and why."""
        name = self.package.name
        missing = ", ".join(dict.fromkeys(each for each, _ in self.missing))
        if left_out:
            yield f"day6-tui has no C++ compiler: left out of '{name}': {left_out}."
            if ours := ", ".join(replacements(name, left_out.executables)):
                yield f"day6-tui has its own versions of these programs and starts them instead: {ours}."
            if missing:
                yield f"Not found, and needed to compile it: {missing}."
            if stopped is not None:
                text = " ".join("".join(stopped.words[1:]).split())
                yield f"Its {stopped.file} (line {stopped.line}) would stop CMake here: {text}"
        elif missing:
            yield f"day6-tui doesn't have these packages of ROS, which '{name}' looks for: {missing}."
            yield "It was built without them."
        not_made = dict.fromkeys(self.not_made, "CMake itself makes it, and day6-tui doesn't run CMake")
        reasons = self.interfaces.left_out | not_made
        for why in dict.fromkeys(reasons.values()):
            yield f"Left out of '{name}': {', '.join(each for each in reasons if reasons[each] == why)} ({why})"
        if left_out:
            yield "Everything else was built. A real ROS 2 can build all of it: `day6-tui export` makes a zip for it."

    # -- finding packages ----------------------------------------------------------------------------------------------

    def _find(self, command: Command) -> list[str]:
        """Run `find_package` or ament_auto's search for all dependencies of package.xml; returns the packages it finds."""
        if command.name == "find_package":
            names, required = command.words[:1], "REQUIRED" in command.words
        else:
            manifest = self.package.manifest
            names, required = list(manifest.build_depends) if manifest else [], True
        here = [name for name in names if self._is_there(name)]
        if required:
            self.missing += [(name, command) for name in names if name not in here]
        found = self.packages.with_exported(here)
        self.found.update(dict.fromkeys(found))
        return found

    def _lacks(self, name: str) -> bool:
        return not self._is_there(name) and is_released(name)

    def _is_there(self, name: str) -> bool:
        known = self.packages.share(name) is not None or name in self.settings.needs.get(self.package.name, ())
        return known or name in _CPP.split() or name.lower().startswith(_TOOLS)

    # -- files ---------------------------------------------------------------------------------------------------------

    def _install(self, command: Command) -> None:
        kind = command.words[0] if command.words else ""
        if kind not in ("DIRECTORY", "FILES", "PROGRAMS"):
            return
        destination = command.after("DESTINATION", *_INSTALL_WORDS.split())
        destination = destination or [_TYPES[word] for word in command.after("TYPE")[:1] if word in _TYPES]
        if not destination:
            raise command.error(f"install {kind} given no DESTINATION!")
        folder = self.prefix / destination[0]
        permissions = command.after(
            "FILE_PERMISSIONS" if kind == "DIRECTORY" else "PERMISSIONS", *_INSTALL_WORDS.split()
        )
        executable = kind == "PROGRAMS" or "OWNER_EXECUTE" in permissions
        for name in command.after(kind, *_INSTALL_WORDS.split()):
            source = command.folder / name
            if not source.exists():
                if source.is_relative_to(self.settings.build_base / self.package.name):
                    self.not_made[source.name] = None
                    continue
                if "OPTIONAL" in command.words:
                    continue
                raise command.error(f'file INSTALL cannot find "{source}": No such file or directory.')
            if source.is_dir():
                inside = "" if name.endswith("/") else source.name
                self._copy_tree(source, folder / inside, executable=executable)
            else:
                named = next(iter(command.after("RENAME", *_INSTALL_WORDS.split())), source.name)
                self._copy(source, folder / named, executable=executable)

    def _copy_tree(self, source: Path, target: Path, *, executable: bool = False) -> None:
        for folder, folders, files in os.walk(source):
            folders[:] = sorted(name for name in folders if name != "__pycache__")
            for name in sorted(files):
                path = Path(folder, name)
                self._copy(path, target / path.relative_to(source), executable=executable)

    def _copy(self, source: Path, target: Path, *, executable: bool = False) -> None:
        if self.settings.symlink_install:
            self.output.link(source, target)
            return
        self.output.copy(source, target, executable=executable)

    def _install_python(self, command: Command) -> None:
        name = command.words[0]
        source = command.folder / next(iter(command.after("PACKAGE_DIR")), name)
        if not (source / "__init__.py").is_file():
            raise command.error(
                f"ament_python_install_package() the Python package folder '{source}' has no '__init__.py'"
            )
        self._copy_tree(source, python_library(self.prefix) / name)
        self.python = True

    def _install_module(self, command: Command) -> None:
        source = command.folder / command.words[0]
        if not source.is_file():
            raise command.error(f"ament_python_install_module() the Python module '{source}' doesn't exist")
        self._copy(source, python_library(self.prefix) / source.name)
        self.python = True

    def _finish(self, left_out: LeftOut) -> None:
        name = self.package.name
        if self.package.manifest is None:  # a project of CMake alone
            self.output.make_folder(self.prefix)
            hooks = self.package.meta.hooks
            write_package_scripts(self.output, self.prefix, name, hooks, self.package.dependencies("run"))
            return
        self.output.write_text(self.prefix / "share/ament_index/resource_index/packages" / name, "")
        write_note(self.output, self.prefix, name, left_out)
        exported = [*self.exported, *self.interfaces.exported]
        self.output.write_text(self.share / EXPORTS, exports_text(dict.fromkeys(exported)))
        self._copy(self.package.path / "package.xml", self.share / "package.xml")
        hooks = [*self._hooks(), *self.package.meta.hooks]
        write_package_scripts(self.output, self.prefix, name, hooks, self.package.dependencies("run"))

    def _hooks(self) -> Iterator[str]:
        name = self.package.name
        if self.python or self.interfaces.made:
            library = python_library(self.prefix).relative_to(self.prefix).as_posix()
            yield from write_hook(self.output, self.prefix, name, "pythonpath", "PYTHONPATH", library)
        yield from write_hook(self.output, self.prefix, name, "cmake_prefix_path", "CMAKE_PREFIX_PATH", "")
        yield from write_hook(self.output, self.prefix, name, "ament_prefix_path", "AMENT_PREFIX_PATH", "")
