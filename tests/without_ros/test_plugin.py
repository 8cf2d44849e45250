"""An ordinary `pytest` in a repository, with nothing but day6-tui installed beside it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from day6_core.link.paths import process_exists
from tests.support.waiting import until
from tests.without_ros.repositories import (
    TEST_COUNTER,
    message_package,
    pytest_in,
    python_package,
    result,
    start,
    variables,
    write,
)

pytestmark = pytest.mark.process


def files_in(folder: Path) -> set[str]:
    """What is in a folder, without what every pytest leaves."""
    names = {path.relative_to(folder).as_posix() for path in folder.rglob("*")}
    return {name for name in names if "__pycache__" not in name and ".pytest_cache" not in name}


def test_a_test_of_a_node_passes_and_nothing_is_left(tmp_path: Path) -> None:
    repository = python_package(tmp_path / "repository", test__test_counter=TEST_COUNTER)
    before = files_in(repository)
    process = start("pytest", repository)
    done = result(process)
    assert done.status == 0, done
    assert "1 passed" in done.out and "day6-tui stands in for ROS 2 Jazzy" in done.out
    assert files_in(repository) == before
    assert not [name for name in os.listdir("/tmp") if name.startswith(f"day6-test{process.pid}-")]


def test_a_test_that_fails_is_red_with_the_text_of_pytest(tmp_path: Path) -> None:
    python_package(tmp_path, test__test_counter=TEST_COUNTER.replace("[1, 2, 3]", "[1, 2, 4]"))
    done = pytest_in(tmp_path)
    assert done.status == 1
    assert "assert [1, 2, 3] == [1, 2, 4]" in done.out


def test_no_package_is_needed_and_the_plugin_can_be_named(tmp_path: Path) -> None:
    text = (
        "import rclpy\nfrom geometry_msgs.msg import Twist\n\n\ndef test_it():\n    rclpy.init()\n    assert Twist()\n"
    )
    write(tmp_path, {"test_it.py": text})
    assert pytest_in(tmp_path).status == 0
    assert pytest_in(tmp_path, "-p", "day6_tui.pytest").status == 0
    assert pytest_in(tmp_path, "-p", "day6_tui.pytest", PYTEST_DISABLE_PLUGIN_AUTOLOAD="1").status == 0
    without = pytest_in(tmp_path, "-p", "no:day6_tui.pytest")
    assert without.status == 2 and "No module named 'rclpy'" in without.out


def test_packages_of_a_workspace_have_their_messages_share_folders_and_executables(tmp_path: Path) -> None:
    message_package(tmp_path / "src/levels")
    test = """\
import os
import shutil
import subprocess

from ament_index_python.packages import get_package_prefix, get_package_share_directory
import counter
from levels.msg import Level


def test_all_of_it():
    assert Level(height=1.5).height == 1.5
    assert os.path.isfile(os.path.join(get_package_share_directory('counter'), 'package.xml'))
    assert os.access(os.path.join(get_package_prefix('counter'), 'lib', 'counter', 'run'), os.X_OK)
    assert counter.__file__ == os.path.join(os.path.dirname(os.path.dirname(__file__)), 'counter', '__init__.py')
    listed = subprocess.run(['ros2', 'pkg', 'executables', 'counter'], stdout=subprocess.PIPE, text=True)
    assert listed.stdout == 'counter run\\n'
"""
    python_package(tmp_path / "src/counter", needs="<depend>levels</depend>", test__test_all=test)
    for folder, words in ((tmp_path, ()), (tmp_path, ("src/counter/test",)), (tmp_path / "src/counter", ())):
        done = pytest_in(folder, *words)
        assert done.status == 0, done


def test_what_a_repository_needs_of_another_one_beside_it_is_built(tmp_path: Path) -> None:
    (message_package(tmp_path / "src/messages/levels") / "../.git").mkdir()
    test = "from levels.msg import Level\n\n\ndef test_it():\n    assert Level()\n"
    own = python_package(tmp_path / "src/robot/counter", needs="<depend>levels</depend>", test__test_it=test)
    (own / "../.git").mkdir()
    write(python_package(tmp_path / "src/other", "other"), {"setup.py": "raise OSError('nobody needs it')\n"})
    done = pytest_in(own.parent)
    assert done.status == 0 and "warning" not in done.out, done


def test_a_package_that_cannot_be_built_is_told_and_the_tests_of_others_run(tmp_path: Path) -> None:
    python_package(tmp_path / "src/counter", test__test_counter=TEST_COUNTER)
    write(python_package(tmp_path / "src/broken", "broken"), {"setup.py": "raise OSError('no such luck')\n"})
    done = pytest_in(tmp_path)
    assert done.status == 0 and "no such luck" in done.out, done


def test_started_in_a_package_of_a_repository_with_settings_at_its_top_it_builds_that_package(tmp_path: Path) -> None:
    own = python_package(tmp_path / "counter", test__test_counter=TEST_COUNTER)
    write(python_package(tmp_path / "broken", "broken"), {"setup.py": "raise OSError('nobody needs it')\n"})
    write(tmp_path, {"pyproject.toml": "[tool.black]\n"})
    (tmp_path / ".git").mkdir()
    done = pytest_in(own)
    assert done.status == 0 and "warning" not in done.out, done


def test_a_folder_of_modules_is_the_tested_packages_own_whatever_others_call_theirs(tmp_path: Path) -> None:
    test = (
        "import rclpy\nfrom tools.sums import two\nimport other\n\n\ndef test_it():\n    assert two + other.one == 3\n"
    )
    own = python_package(tmp_path / "src/counter", needs="<depend>other</depend>", test__test_it=test)
    write(own, {"tools/sums.py": "two = 2\n", "pytest.ini": "[pytest]\npythonpath = .\n"})
    beside = python_package(tmp_path / "src/other", "other")
    write(beside, {"tools/__init__.py": "", "other/__init__.py": "one = 1\n"})
    done = pytest_in(own)
    assert done.status == 0, done


SEES = """\
import pathlib
import time

import rclpy


def test_nobody_else():
    rclpy.init()
    node = rclpy.create_node('{name}')
    here, there = (pathlib.Path('{folder}', each) for each in ('{name}', '{other}'))
    here.touch()
    while not there.exists():
        time.sleep(0.01)
    time.sleep(0.5)
    pathlib.Path('{folder}', '{name}_sees').write_text(' '.join(sorted(node.get_node_names())))
    while not pathlib.Path('{folder}', '{other}_sees').exists():
        time.sleep(0.01)
    rclpy.shutdown()
"""


def test_two_runs_at_the_same_time_do_not_see_each_other_nor_what_runs_on_the_machine(tmp_path: Path) -> None:
    user = "import rclpy\nrclpy.init()\nnode = rclpy.create_node('of_the_user')\nprint(flush=True)\nrclpy.spin(node)\n"
    other = subprocess.Popen(
        [sys.executable, "-m", "day6_tui.main", "python", str(write(tmp_path, {"user.py": user}) / "user.py")],
        env=variables(),
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    try:
        assert other.stdout is not None and other.stdout.readline() == "\n"
        runs = []
        for name, its_other in (("one", "two"), ("two", "one")):
            text = SEES.format(name=name, other=its_other, folder=tmp_path.as_posix())
            runs.append(start("pytest", write(tmp_path / f"of_{name}", {"test_it.py": text})))
        for run in runs:
            assert (done := result(run)).status == 0, done
        assert (tmp_path / "one_sees").read_text(encoding="utf-8") == "one"
        assert (tmp_path / "two_sees").read_text(encoding="utf-8") == "two"
    finally:
        other.kill()
        other.communicate()


def test_processes_that_a_test_starts_join_its_graph_and_end_with_it(tmp_path: Path) -> None:
    test = """\
import pathlib
import subprocess

import rclpy
from std_msgs.msg import Int32


def test_it_is_heard():
    process = subprocess.Popen(['ros2', 'run', 'counter', 'run'], start_new_session=True)
    rclpy.init()
    heard = []
    node = rclpy.create_node('listener')
    node.create_subscription(Int32, 'count', heard.append, 10)
    while not heard:
        rclpy.spin_once(node)
    rclpy.shutdown()
    pathlib.Path('number').write_text(str(process.pid))
"""
    python_package(tmp_path, test__test_it=test)
    done = pytest_in(tmp_path)
    assert done.status == 0, done
    number = int((tmp_path / "number").read_text(encoding="utf-8"))
    until(lambda: not process_exists(number))


def test_of_a_run_that_is_killed_no_process_is_left(tmp_path: Path) -> None:
    test = """\
import pathlib
import subprocess
import time

import rclpy


def test_it():
    process = subprocess.Popen(['ros2', 'run', 'counter', 'run'], start_new_session=True)
    pathlib.Path('number').write_text(f'{process.pid}.')
    time.sleep(1000)
"""
    process = start("pytest", python_package(tmp_path, test__test_it=test))
    file = tmp_path / "number"
    until(lambda: file.exists() and file.read_text(encoding="utf-8").endswith("."))
    process.kill()
    result(process)
    for folder in Path("/tmp").glob(f"day6-test{process.pid}-*"):  # it goes by itself an hour later
        shutil.rmtree(folder)
    until(lambda: not process_exists(int(file.read_text(encoding="utf-8")[:-1])))


LAUNCH_TEST = """\
import unittest

import launch
import launch_ros.actions
import launch_testing.actions
from launch_testing_ros import WaitForTopics
import pytest
from std_msgs.msg import Int32


@pytest.mark.launch_test
def generate_test_description():
    counter = launch_ros.actions.Node(package='counter', executable='run')
    return launch.LaunchDescription([counter, launch_testing.actions.ReadyToTest()])


class TestCounter(unittest.TestCase):

    def test_it_counts(self):
        with WaitForTopics([('count', Int32)], timeout=20.0):
            pass
"""
LAUNCH_PYTEST = """\
import launch
import launch_pytest
import launch_ros.actions
import pytest
import rclpy
from std_msgs.msg import Int32


@launch_pytest.fixture
def description():
    counter = launch_ros.actions.Node(package='counter', executable='run')
    return launch.LaunchDescription([counter, launch_pytest.actions.ReadyToTest()])


@pytest.mark.launch(fixture=description)
def test_it_counts():
    rclpy.init()
    heard = []
    node = rclpy.create_node('listener')
    node.create_subscription(Int32, 'count', heard.append, 10)
    while not heard:
        rclpy.spin_once(node)
    rclpy.shutdown()
"""


@pytest.mark.parametrize("test", [LAUNCH_TEST, LAUNCH_PYTEST], ids=["launch_testing", "launch_pytest"])
def test_launch_tests_run(tmp_path: Path, test: str) -> None:
    python_package(tmp_path, test__test_launched=test)
    done = pytest_in(tmp_path, "--strict-markers")
    assert done.status == 0 and "1 passed" in done.out and "warning" not in done.out, done


def test_options_of_launch_tests_are_known(tmp_path: Path) -> None:
    python_package(tmp_path, test__test_launched=LAUNCH_TEST)
    assert pytest_in(tmp_path, "--launch-args", "a:=b").status == 0


def test_a_launch_test_that_fails_is_red(tmp_path: Path) -> None:
    python_package(
        tmp_path, test__test_launched=LAUNCH_TEST.replace("            pass\n", "            assert 1 == 2\n")
    )
    done = pytest_in(tmp_path)
    assert done.status == 1 and "assert 1 == 2" in done.out


PLAIN = """\
import os
import sys

def test_nothing_of_ours_is_there():
    assert not [name for name in sys.modules if name.startswith(('day6_core.', 'rclpy'))]
    assert not [name for name in os.environ if name.startswith(('DAY6_TEST', 'ROS_D', 'AMENT', 'PYTHONPATH', 'DAY6_JOB'))]
    assert not [entry for entry in sys.path if entry.endswith(os.path.join('ros', 'python'))]


def test_what_is_not_there_is_not_there():
    try:
        import quite_unknown
    except ImportError:
        return
    assert False
"""


@pytest.mark.parametrize("words", [(), ("-n", "2")], ids=["one process", "xdist"])
def test_a_repository_without_ros_is_left_alone(tmp_path: Path, words: tuple[str, ...]) -> None:
    write(tmp_path, {"test_plain.py": PLAIN, "setup.py": "", "launch/settings.txt": ""})
    done = pytest_in(tmp_path, *words)
    assert done.status == 0 and "day6-tui stands in" not in done.out, done


def test_a_package_whose_tests_need_no_ros_is_imported_from_its_sources_and_nothing_else_happens(
    tmp_path: Path,
) -> None:
    test = (
        "from counter import sums\n"
        + PLAIN.replace("('day6_core.', 'rclpy')", "'rclpy'")
        + "\n\ndef test_sum():\n    assert sums.total(1, 2) == 3\n"
    )
    python_package(tmp_path, counter__sums="def total(a, b):\n    return a + b\n", test__test_sums=test)
    done = pytest_in(tmp_path)
    assert done.status == 0 and "3 passed" in done.out, done


def test_a_folder_named_like_a_package_of_ros_is_not_taken_for_it(tmp_path: Path) -> None:
    write(tmp_path, {"launch/demo.launch.py": "", "conftest.py": ""})
    write(
        tmp_path,
        {"test_it.py": "from launch import LaunchDescription\n\n\ndef test_it():\n    assert LaunchDescription()\n"},
    )
    done = pytest_in(tmp_path)
    assert done.status == 0, done


def test_an_rclpy_of_somebody_else_wins(tmp_path: Path) -> None:
    write(tmp_path / "real", {"rclpy/__init__.py": "REAL = True\n", "launch/__init__.py": "REAL = True\n"})
    test = (
        "import launch\nimport rclpy\nimport pytest\n\n\ndef test_it():\n    assert rclpy.REAL and launch.REAL\n"
        "    with pytest.raises(ImportError):\n        import std_msgs\n"
    )
    write(tmp_path, {"test_it.py": test})
    done = pytest_in(tmp_path, PYTHONPATH=str(tmp_path / "real"))
    assert done.status == 0, done


def test_mocks_in_the_place_of_ros_stay(tmp_path: Path) -> None:
    conftest = "import sys\nfrom unittest.mock import MagicMock\n\nsys.modules['rclpy'] = MagicMock()\n"
    test = (
        "import rclpy\nimport pytest\n\n\ndef test_it():\n    assert rclpy.anything\n"
        "    with pytest.raises(ImportError):\n        import std_msgs\n"
    )
    write(tmp_path, {"conftest.py": conftest, "test_it.py": test})
    done = pytest_in(tmp_path)
    assert done.status == 0, done


def test_what_was_skipped_without_ros_runs(tmp_path: Path) -> None:
    test = "import pytest\n\nrclpy = pytest.importorskip('rclpy')\n\n\ndef test_it():\n    assert rclpy.__file__\n"
    write(tmp_path, {"test_it.py": test})
    assert "1 passed" in pytest_in(tmp_path).out


@pytest.mark.parametrize("first", ["the package", "a conftest", "a test"])
def test_each_worker_of_xdist_has_a_graph_of_its_own(tmp_path: Path, first: str) -> None:
    """Whatever makes a process a ROS program first: that of pytest itself, or those of the workers."""
    tests = {}
    for name, other in (("one", "two"), ("two", "one")):
        tests[f"test/test_{name}.py"] = SEES.format(name=name, other=other, folder=tmp_path.as_posix())
    if first == "the package":
        python_package(tmp_path)
    elif first == "a conftest":
        tests["conftest.py"] = "import rclpy\npytest_plugins = ['launch_pytest.plugin']\n"
    write(tmp_path, tests)
    done = pytest_in(tmp_path, "-n", "2", "--dist", "loadfile")
    assert done.status == 0 and "2 passed" in done.out, done
    assert (tmp_path / "one_sees").read_text(encoding="utf-8") == "one"
    assert (tmp_path / "two_sees").read_text(encoding="utf-8") == "two"
