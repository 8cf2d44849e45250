"""Repositories of people who have no ROS, and the plain `pytest` beside which day6-tui is installed."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

COUNTER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class Counter(Node):

    def __init__(self):
        super().__init__('counter')
        self.publisher = self.create_publisher(Int32, 'count', 10)
        self.timer = self.create_timer(0.01, self.tick)
        self.count = 0

    def tick(self):
        self.count += 1
        self.publisher.publish(Int32(data=self.count))


def main():
    rclpy.init()
    rclpy.spin(Counter())
"""
TEST_COUNTER = """\
import rclpy
from counter.node import Counter
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import Int32


def test_it_counts():
    rclpy.init()
    heard = []
    counter, listener = Counter(), rclpy.create_node('listener')
    listener.create_subscription(Int32, 'count', lambda message: heard.append(message.data), 10)
    executor = SingleThreadedExecutor()
    executor.add_node(counter)
    executor.add_node(listener)
    while len(heard) < 3:
        executor.spin_once()
    rclpy.shutdown()
    assert heard == [1, 2, 3]
"""
SETUP = """\
from glob import glob
from setuptools import setup

setup(
    name='{name}',
    version='0.0.0',
    packages=['{name}'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/{name}']),
        ('share/{name}', ['package.xml', *glob('launch/*')]),
    ],
    entry_points={{'console_scripts': ['run = {name}.node:main']}},
)
"""
MANIFEST = """\
<package format="3"><name>{name}</name><version>0.0.0</version><description>d</description>
<maintainer email="student@todo.todo">a</maintainer><license>MIT</license>{needs}
<export><build_type>{kind}</build_type></export></package>
"""
MESSAGES = """\
cmake_minimum_required(VERSION 3.8)
project({name})
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces({name} "msg/Level.msg")
ament_package()
"""


def write(folder: Path, files: Mapping[str, str]) -> Path:
    """Write the files of a folder; returns it."""
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def python_package(folder: Path, name: str = "counter", needs: str = "", **files: str) -> Path:
    """Write a package of Python with its node and these files besides, `/` written as `__`."""
    own = {
        "package.xml": MANIFEST.format(name=name, needs=needs, kind="ament_python"),
        "setup.py": SETUP.format(name=name),
        "setup.cfg": f"[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n",
        f"resource/{name}": "",
        f"{name}/__init__.py": "",
        f"{name}/node.py": COUNTER,
    }
    return write(folder, own | {path.replace("__", "/", 1) + ".py": text for path, text in files.items()})


def message_package(folder: Path, name: str = "levels") -> Path:
    """Write a package with one message, `Level`."""
    needs = (
        "<buildtool_depend>rosidl_default_generators</buildtool_depend>"
        "<member_of_group>rosidl_interface_packages</member_of_group>"
    )
    return write(
        folder,
        {
            "package.xml": MANIFEST.format(name=name, needs=needs, kind="ament_cmake"),
            "CMakeLists.txt": MESSAGES.format(name=name),
            "msg/Level.msg": "float64 height\n",
        },
    )


class Done(NamedTuple):
    """What came of a command."""

    status: int
    out: str
    err: str


def variables(**more: str) -> dict[str, str]:
    """Return those of somebody with day6-tui in an environment that is not activated, whose programs see each other."""
    return {**{name: value for name, value in os.environ.items() if name != "DAY6_LINK"}, **more}


def start(command: str, folder: Path, *words: str, **more: str) -> subprocess.Popen[str]:
    """Start a command of the environment in a folder."""
    return subprocess.Popen(
        [str(Path(sys.executable).parent / command), *words],
        cwd=folder,
        env=variables(**more),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
    )


def result(process: subprocess.Popen[str]) -> Done:
    """Wait until a command has ended."""
    out, err = process.communicate()
    return Done(process.returncode, out, err)


def pytest_in(folder: Path, *words: str, **more: str) -> Done:
    """Run a plain `pytest`."""
    return result(start("pytest", folder, *words, **more))
