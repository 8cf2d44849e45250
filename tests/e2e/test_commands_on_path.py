"""ROS's commands are executables on the PATH of every program, however it was started."""

from __future__ import annotations

import os
import subprocess
from typing import TYPE_CHECKING

import pytest

from tests.e2e.place import DAY6

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = [
    pytest.mark.person,
    pytest.mark.skipif(os.name != "posix", reason="on Windows they are batch files, which only a shell finds"),
]

CALLER = """\
import os, shutil, subprocess

print('prefix', subprocess.run(['ros2', 'pkg', 'prefix', 'turtlesim'], capture_output=True, text=True).returncode)
print('colcon', subprocess.run(['colcon', 'list'], stdout=subprocess.DEVNULL).returncode)
print('urdf', os.system('check_urdf robot.urdf > /dev/null'))
print('xacro', 'wheel' in os.popen('xacro robot.urdf').read())
print('python', subprocess.run(['python3', '-c', 'import rclpy']).returncode)
print('pytest', subprocess.run(['pytest', '--version'], capture_output=True).returncode)
print('which', shutil.which('ros2') is not None)
"""
ANSWERS = ["prefix 0", "colcon 0", "urdf 0", "xacro True", "python 0", "pytest 0", "which True"]
ROBOT = '<robot name="car"><link name="wheel"/></robot>\n'
TEST = """\
import subprocess


def test_it():
    import rclpy

    assert subprocess.call(['ros2', 'pkg', 'prefix', 'rclpy']) == 0, rclpy
"""


@pytest.fixture
def caller(place: Place) -> Place:
    place.file("caller.py", CALLER)
    place.file("robot.urdf", ROBOT)
    return place


def test_a_program_of_the_simulated_terminal_starts_them(caller: Place) -> None:
    done = caller.execute("python3 caller.py")
    assert done.stdout.splitlines() == ANSWERS, done.stderr


def test_a_program_under_day6_tui_python_starts_them(caller: Place) -> None:
    done = caller.run("python", "caller.py")
    assert done.stdout.splitlines() == ANSWERS, done.stderr


def test_a_launched_program_starts_them(caller: Place) -> None:
    caller.file(
        "it.launch.py",
        "from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([ExecuteProcess(cmd=['python3', 'caller.py'], output='screen')])\n",
    )
    for done in (caller.execute("ros2 launch it.launch.py"), caller.run("ros2", "launch", "it.launch.py")):
        for answer in ANSWERS:
            assert f"] {answer}\n" in done.stdout, done.stdout + done.stderr


def test_a_real_shell_has_them_after_its_variables_were_set(caller: Place) -> None:
    variables = caller.run("env").stdout
    done = subprocess.run(
        ["sh", "-c", f"{variables}\npython3 caller.py; day6-tui --version"],
        cwd=caller.work,
        env={**caller.variables(), "PATH": "/usr/bin:/bin"},
        capture_output=True,
        text=True,
    )
    assert done.stdout.splitlines()[:-1] == ANSWERS, done.stderr
    assert done.stdout.splitlines()[-1].startswith("day6-tui ")


def test_pytest_in_the_simulated_terminal_and_after_env_finds_rclpy(caller: Place) -> None:
    caller.file("test_it.py", TEST)
    assert "1 passed" in caller.execute("pytest -q test_it.py").stdout
    variables = caller.run("env").stdout
    done = subprocess.run(
        ["sh", "-c", f"{variables}\npytest -q test_it.py"],
        cwd=caller.work,
        env=caller.variables(),
        capture_output=True,
        text=True,
    )
    assert "1 passed" in done.stdout, done.stdout + done.stderr


def test_colcon_test_in_a_real_terminal_passes_for_the_package_that_we_make(place: Place) -> None:
    source = place.work / "src"
    source.mkdir()
    made = subprocess.run(
        [*DAY6, "ros2", "pkg", "create", "--build-type", "ament_python", "--node-name", "hi", "hello"],
        cwd=source,
        env=place.variables(),
        capture_output=True,
        text=True,
    )
    assert made.returncode == 0, made.stderr
    (source / "hello" / "test" / "test_it.py").write_text(TEST, encoding="utf-8")
    assert place.run("colcon", "build").returncode == 0
    done = place.run("colcon", "test", "--event-handlers", "console_direct+")
    assert "ModuleNotFoundError" not in done.stdout + done.stderr
    assert "test failures" not in done.stdout, done.stdout
    result = place.run("colcon", "test-result", "--all").stdout
    assert "4 tests, 0 errors, 0 failures, 1 skipped" in result, result
