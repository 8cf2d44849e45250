"""sudo, apt, rosdep, pip …: the replies to a lesson's installation commands on a machine that has no packages."""

from __future__ import annotations

import fnmatch
import os
from collections.abc import Callable
from functools import partial
from pathlib import Path

from day6_core.language import language_of, said
from day6_core.session.session import Session
from day6_core.shell.language.interpreter import Shell, shell_of


async def sudo(session: Session) -> int:
    from day6_core.shell.commands import find_command

    words = [word for word in session.argv[1:] if not word.startswith("-")]
    if not words:
        session.print_error("usage: sudo COMMAND")
        return 1
    start = session.argv.index(words[0])
    return await session.execute(find_command(words[0], shell_of(session)), session.argv[start:])


async def apt(session: Session) -> int:
    """Report for every package whether its commands exist here; nothing is downloaded."""
    say = partial(_say, language_of(session.env))
    words = [word for word in session.argv[1:] if not word.startswith("-")]
    verb = words[0] if words else ""
    if verb == "install" and len(words) > 1:
        session.print("Reading package lists... Done")
        for name in words[1:]:
            session.print(_about(name, shell_of(session), say))
    elif verb in ("update", "upgrade", "full-upgrade", "autoremove"):
        session.print("Reading package lists... Done\nAll packages are up to date.")
    elif verb in ("remove", "purge"):
        session.print(f"Reading package lists... Done\n{say('removed')}")
    else:
        session.print_error(f"E: Invalid operation {verb}" if verb else f"apt: {say('nothing')}")
        return 100 if verb else 1
    return 0


_TEXTS = {
    "removed": (
        "Nothing was removed: day6-tui has no packages of its own.",
        "没有删除任何东西：day6-tui 没有自己的软件包。",
    ),
    "nothing": ("nothing to do: packages are not managed on this machine", "没有要做的事：这台机器不管理软件包"),
    "stands_in": ("day6-tui stands in for ROS 2 {distro}", "这里由 day6-tui 代替 ROS 2 {distro}"),
    "not_part": (
        "not part of day6-tui; on a real Ubuntu this command would install it.",
        "day6-tui 里没有它；在真正的 Ubuntu 上，这条命令会安装它。",
    ),
    "not_needed": ("not needed on this machine; nothing was installed.", "这台机器不需要它，什么都没有安装。"),
    "rosdep.update": ("nothing to fetch: day6-tui works offline", "不用下载：day6-tui 不需要网络"),
    "rosdep.init": ("rosdep is initialised", "rosdep 初始化好了"),
}
"""What the real tools would not say: English, Chinese."""


def _say(language: str, key: str, **values: str) -> str:
    return said(_TEXTS[key], language).format(**values)


_COMMANDS_OF = {
    "liburdfdom-tools": ("check_urdf", "urdf_to_graphviz"),
    "ros-dev-tools": ("colcon", "rosdep"),
    "python3-rosdep2": ("rosdep",),
}
"""Packages whose name differs from the commands they provide, all of which exist here."""


_GATHERING = {
    *("desktop", "desktop_full", "ros_base", "ros_core", "common_interfaces", "rqt", "rqt_common_plugins"),
    *("rosbag2", "rosbag2_storage_mcap", "rosbag2_storage_sqlite3", "rosbag2_transport"),
}
"""Packages of ROS that only gather others, or are a part in C++ of what is here."""


def _about(name: str, shell: Shell, say: Callable[..., str]) -> str:
    """Return the outcome of `apt install NAME`."""
    from day6_core.ros.distribution import current
    from day6_core.shell.commands import where

    name = name.removeprefix("~n")  # how apt is told that a pattern of names follows
    if name in _COMMANDS_OF:
        return f"{name} is already the newest version ({', '.join(_COMMANDS_OF[name])})."
    if name.startswith("ros-"):
        package = name.split("-", 2)[-1].replace("-", "_")
        if package in _GATHERING or fnmatch.filter(_shipped(), package):
            return f"{name} is already the newest version ({say('stands_in', distro=current())})."
        return f"{name}: {say('not_part')}"
    if name.startswith("python3-colcon") or name == "python3-rosdep" or where(name, shell):
        return f"{name} is already the newest version."
    return f"{name}: {say('not_needed')}"


def _shipped() -> set[str]:
    from day6_core.ros.environment import shipped_packages

    return set(shipped_packages())


async def rosdep(session: Session) -> int:
    """`rosdep init/update` succeed; `rosdep install --from-paths src` checks the packages' real dependencies."""
    words = session.argv[1:]
    verb = next((word for word in words if not word.startswith("-")), "")
    if verb in ("init", "update"):
        session.print(_say(language_of(session.env), f"rosdep.{verb}"))
        return 0
    if verb != "install":
        session.print_error("Usage: rosdep [options] <command> <args>\n\nrosdep: error: Please enter a command")
        return 1
    paths = [words[at + 1] for at, word in enumerate(words[:-1]) if word in ("--from-paths", "--from-path")]
    for path in paths:
        if not (session.cwd / path).is_dir():
            session.print_error(f"ERROR: Could not find path: {session.cwd / path}")
            return 1
    missing = _unresolved([session.cwd / path for path in paths or ["."]], session.env.get("AMENT_PREFIX_PATH", ""))
    if missing:
        session.print_error("ERROR: the following packages/stacks could not have their rosdep keys resolved")
        session.print_error("to system dependencies:")
        for package, keys in missing.items():
            session.print_error(
                f"{package}: " + ", ".join(f"Cannot locate rosdep definition for [{key}]" for key in keys)
            )
        return 1
    session.print("#All required rosdeps installed successfully")
    return 0


def _unresolved(folders: list[Path], prefixes: str) -> dict[str, list[str]]:
    """Return, by package, the dependencies that nothing here provides."""
    from day6_core.workspace.manifest import ManifestError, read_manifest

    manifests = []
    for path in [path for folder in folders for path in sorted(folder.rglob("package.xml"))]:
        if any((above / name).exists() for above in _below(path, folders) for name in _IGNORED):
            continue
        try:
            found = read_manifest(path.parent, str(path.parent), {})
        except (ManifestError, OSError):
            continue  # colcon says what is wrong with it
        if found is not None:
            manifests.append(found)
    installed = {
        path.name for prefix in prefixes.split(os.pathsep) if prefix for path in Path(prefix, "share").glob("*")
    }
    known = {manifest.name for manifest in manifests} | installed | _shipped()
    missing: dict[str, list[str]] = {}
    for manifest in manifests:
        keys = [
            key
            for key in dict.fromkeys([*manifest.build_depends, *manifest.run_depends])
            if key not in known and not _is_system(key)
        ]
        if keys:
            missing[manifest.name] = keys
    return missing


_IGNORED = ("AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE")
"""Files in a folder that is no place for packages (catkin_pkg/packages.py)."""
_SYSTEM = ("ament_", "python3", "rosidl_", "launch_testing", "lib", "qt5-", "qt6-", "qtbase5-")
"""How names of build tools, Python's and the system's packages begin (turtlesim's own sources need Qt)."""
_LIBRARIES = frozenset(
    {"class_loader", "pluginlib", "setuptools", "tf2", "tf2_eigen"}
    | {f"rclcpp{part}" for part in ("", "_action", "_lifecycle")}
    | {f"rosbag2_{part}" for part in ("cpp", "storage", "transport")}
)
"""What packages of C++ depend on: every installation of ROS 2 has it. Here colcon says what has no compiler."""


def _below(path: Path, folders: list[Path]) -> list[Path]:
    """Return the folders around a file, up to the one of these that it was found in."""
    return [above for above in path.parents if any(above.is_relative_to(folder) for folder in folders)]


def _is_system(key: str) -> bool:
    """Whether a dependency is a build tool, a library for C++ or a Python tool, which this machine has or does not need."""
    return key.startswith(_SYSTEM) or key in _LIBRARIES


async def pip(session: Session) -> int:
    """pip, really: of the Python that runs this home's programs."""
    return await session.run_python(["-m", "pip", *session.argv[1:]])
