"""A module whose name begins with an underscore is used by its own package only; what others need has a public name."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from tests.support.source_files import ON_THE_PATH, PACKAGES, place, statements, trees

COMMAND = "day6_core.ros.ros2"
"""One package: its folders are the groups of verbs, in which only private modules are no verbs."""

FRIENDS = {
    ("day6_core.ros.ros2", "rosbag2_py"): "the public names are imported on first use, and so have no types",
    ("day6_core.ros.programs.rqt_bag", "rosbag2_py"): "the same; its index has no public name in ROS",
    ("day6_tui.commands", "rosbag2_py"): "the same: what makes tables of a bag has no public name in ROS",
    ("ros2bag.api", "rosbag2_py"): "the same",
    ("ros2bag.api", "day6_core.ros.ros2"): "the public names of what `ros2 bag` is made of",
    ("day6_core.session", "rclpy._day6.log_file"): "rclpy's public names are those of the real one, which has no such",
    ("launch_ros", "rclpy._rclpy_pybind11"): "its name in the real one, and what launch files catch",
    ("day6_core.ros.ros2", "launch._host"): "launch's public names are those of the real one",
    ("day6_core.ros.ros2.launch", "launch_ros.actions.load_composable_nodes"): "the same",
    (
        "day6_core.ros.ros2.launch",
        "rclpy._",
    ): "the plan of a launch asks what a program makes of its arguments, as rcl does",
    ("launch_pytest", "launch_testing.loader"): "the real one's public names have no such",
    ("launch_ros", "launch._loop"): "launch's public names are those of the real one",
    ("day6_core.ros.programs.tf2_ros", "tf2_py._rotation"): "the C++ library tf2, which has no Python names",
    (
        "day6_core.ros.programs.rclcpp",
        "rclpy",
    ): "the other client library on the same core, which is rcl in real ROS",
    ("tf2_geometry_msgs", "tf2_py._rotation"): "the C++ library tf2, which has no Python names",
}
"""Whose package lies in two folders because the real one's does: (importer, what it may import) -> why."""


def package_of(file: Path) -> str:
    """The package that a file of this repository belongs to, as it is imported."""
    if file.is_relative_to(ON_THE_PATH):
        return ".".join(file.relative_to(ON_THE_PATH).parent.parts)
    base = next(base for name, base in PACKAGES.items() if file.is_relative_to(base / name))
    return ".".join(file.relative_to(base).parent.parts)


def imported(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Line and name of every module that is imported, or might be one (`from package import _module`)."""
    for node in statements(tree):
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module is not None and node.level == 0:
            yield node.lineno, node.module
            yield from ((node.lineno, f"{node.module}.{alias.name}") for alias in node.names)


@cache
def imports_of_all_files() -> list[tuple[str, str, str]]:
    """Package, place and imported name of every import in the repository."""
    found = [
        (package_of(place(file.as_posix())), f"{file}:{line}", sys.intern(module))
        for file, tree in trees(words=("import",))
        for line, module in imported(tree)
    ]
    assert len({place.partition(":")[0] for _, place, _ in found}) > 800
    return found


def folder_of(package: str) -> Path:
    path = package.replace(".", "/")
    return place(path) if package.partition(".")[0] in PACKAGES else ON_THE_PATH / path


def is_ours(module: str) -> bool:
    top = module.partition(".")[0]
    return top in PACKAGES or (ON_THE_PATH / top).is_dir()


def intrudes(package: str, module: str) -> bool:
    """Whether `module` is private to a package that `package` is no part of."""
    parts = module.split(".")
    private = next((at for at, part in enumerate(parts) if part.startswith("_") and not part.startswith("__")), None)
    if private is None or not is_ours(module):
        return False
    owner = ".".join(parts[:private])
    if not folder_of(owner).is_dir():  # a private name of a module
        owner = owner.rpartition(".")[0]
    if f"{package}.".startswith(f"{owner}.") or (package.startswith(COMMAND) and owner.startswith(COMMAND)):
        return False
    return not any(f"{package}.".startswith(f"{who}.") and module.startswith(what) for who, what in FRIENDS)


def test_no_package_imports_a_private_module_of_another_one() -> None:
    found = [f"{place}: {module}" for package, place, module in imports_of_all_files() if intrudes(package, module)]
    assert found == []


@pytest.mark.parametrize(
    ("package", "source"),
    [
        ("day6_tui.windows", "from day6_core.ros.programs.rqt_graph._content import Options"),
        ("day6_tui.windows", "def later():\n    import day6_core.shell._inside"),
        ("day6_core.shell", "from day6_core.session import _inside"),
        ("day6_core.shell", "from day6_core.session.clock import _inside"),
        ("day6_core.ros.ros2.topic", "from rclpy._day6.entity import Entity"),
        ("day6_core.ros.programs.rqt_plot", "from day6_core.ros.programs.rqt_topic._measure import Measure"),
    ],
)
def test_an_import_of_anothers_private_module_is_found(package: str, source: str) -> None:
    assert any(intrudes(package, module) for _, module in imported(ast.parse(source)))


@pytest.mark.parametrize(
    ("package", "source"),
    [
        ("day6_core.ros.programs.rqt_topic", "from day6_core.ros.programs.rqt_topic._measure import Measure"),
        ("day6_core.ros.programs.turtlesim", "from day6_core.ros.programs._waiting import spin"),
        ("day6_core.ros.ros2.topic", "from day6_core.ros.ros2.param._values import type_name"),
        ("day6_tui", "from textual._time import get_time"),
        ("day6_core.ros.ros2.bag", "from rosbag2_py._info import Info"),
    ],
)
def test_what_is_ones_own_or_not_ours_is_not(package: str, source: str) -> None:
    assert not any(intrudes(package, module) for _, module in imported(ast.parse(source)))


@pytest.mark.long
def test_every_friend_still_needs_what_it_is_allowed() -> None:
    used = {
        friend
        for package, _, module in imports_of_all_files()
        for friend in FRIENDS
        if f"{package}.".startswith(f"{friend[0]}.") and module.startswith(friend[1])
    }
    assert used == FRIENDS.keys()
