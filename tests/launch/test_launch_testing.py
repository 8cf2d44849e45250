"""Launch tests: as files that a person writes, run by `launch_test` and by pytest; and what they are written with."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros.environment import program_environment
from tests.support import waiting

DESCRIPTION = """\
import sys
import unittest

import launch
import launch.actions
import launch_testing
import launch_testing.actions
import pytest


@pytest.mark.launch_test
def generate_test_description():
    program = launch.actions.ExecuteProcess(
        cmd=[sys.executable, '-u', '-c', {program!r}, *{arguments!r}], name='program', output='screen')
    return launch.LaunchDescription([program, launch_testing.actions.ReadyToTest()]), {{'program': program}}


"""
WAITS = """\
import time
try:
    print('first')
    print('second')
    time.sleep(99)
except KeyboardInterrupt:
    print('bye')
"""
DIES = "import sys\nprint('on my way')\nsys.exit(3)\n"
GOOD = """\
class TestIt(unittest.TestCase):

    def test_output(self, proc_output, program):
        proc_output.assertWaitFor('second', process=program, stream='stdout')


@launch_testing.post_shutdown_test()
class TestAfter(unittest.TestCase):

    def test_end(self, proc_info, proc_output, program):
        launch_testing.asserts.assertExitCodes(proc_info, process=program)
        with launch_testing.asserts.assertSequentialStdout(proc_output, program) as order:
            for word in ('first', 'second', 'bye'):
                order.assertInStdout(word)
"""
BAD = """\
class TestIt(unittest.TestCase):

    def test_output(self, proc_output):
        proc_output.assertWaitFor('second', stream='stdout')
        proc_output.assertWaitFor('third', timeout=0.1, stream='stdout')
"""


def write(
    folder: Path, tests: str, program: str = WAITS, arguments: Iterable[str] = (), name: str = "test_it.py"
) -> str:
    file = folder / name
    file.write_text(DESCRIPTION.format(program=program, arguments=list(arguments)) + tests, encoding="utf-8")
    return name


def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run our Python, with both streams in one."""
    environment = {**program_environment(), "ROS_LOG_DIR": str(folder / "log"), "PYTHONDONTWRITEBYTECODE": "1"}
    streams = {"stdin": subprocess.DEVNULL, "stderr": subprocess.STDOUT}
    return waiting.run([sys.executable, "-m", *words], cwd=folder, env=environment, **streams)


def launch_test(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return run(folder, "launch_testing.launch_test", *words)


def pytest_on(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return run(folder, "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", *words)


@pytest.mark.process
def test_a_launch_test_passes_and_reports_its_cases(tmp_path: Path) -> None:
    done = launch_test(tmp_path, write(tmp_path, GOOD), "--junit-xml", "report.xml", "--package-name", "car")
    assert done.returncode == 0, done.stdout
    assert "test_output (car.TestIt" in done.stdout and done.stdout.count("\nOK\n") == 2
    suites = ElementTree.parse(tmp_path / "report.xml").getroot()
    assert {**suites.attrib, "time": ""} == {
        "name": "car.test_it",
        "tests": "2",
        "failures": "0",
        "errors": "0",
        "time": "",
    }
    assert [suite.get("name") for suite in suites] == ["car.test_it.launch_tests"]
    assert [case.get("name") for case in suites[0]] == ["test_output", "test_end"]


@pytest.mark.process
def test_ros2_test_runs_a_launch_test(tmp_path: Path) -> None:
    done = run(tmp_path, "day6_tui", "ros2", "test", write(tmp_path, GOOD))
    assert done.returncode == 0, done.stdout
    assert "ROS_DOMAIN_ID" in done.stdout and "test_output (test_it.TestIt" in done.stdout


@pytest.mark.process
def test_a_failing_launch_test_says_why_and_shuts_its_launch_down(tmp_path: Path) -> None:
    done = launch_test(tmp_path, write(tmp_path, BAD))
    assert done.returncode == 1
    assert "AssertionError: Waiting for output timed out" in done.stdout and "FAILED (failures=1)" in done.stdout
    assert "[program-1] bye" in done.stdout


@pytest.mark.process
def test_a_launch_that_ends_too_early_fails_all_its_tests(tmp_path: Path) -> None:
    waits = (
        "class TestIt(unittest.TestCase):\n    def test_never(self, proc_output):\n        proc_output.waitFor('x')\n"
    )
    done = launch_test(tmp_path, write(tmp_path, waits, DIES), "--junit-xml=report.xml")
    assert done.returncode == 1
    assert "Processes under test stopped before tests completed\nProcess 'program-1' exited with 3\n" in done.stdout
    assert "##### 'program-1' output #####\non my way\n" in done.stdout
    report = (tmp_path / "report.xml").read_text(encoding="utf-8")
    assert 'failures="1"' in report and "Launch stopped before the active tests finished." in report


@pytest.mark.process
def test_a_marker_keeps_a_launch_alive_whose_processes_have_ended(tmp_path: Path) -> None:
    file = write(tmp_path, GOOD.replace("'second', process=program", "'on my way'").split("@")[0], DIES)
    path = tmp_path / file
    text = path.read_text(encoding="utf-8")
    text = text.replace("@pytest", "from launch_testing.markers import keep_alive\n\n\n@keep_alive\n@pytest")
    path.write_text(text, encoding="utf-8")
    done = launch_test(tmp_path, file)
    assert done.returncode == 0, done.stdout


@pytest.mark.process
@pytest.mark.parametrize(
    ("tests", "words", "what"),
    [
        (GOOD, ["nowhere.py"], "launch_test: error: Test file 'nowhere.py' does not exist"),
        (GOOD, ["test_it.py", "speed"], "error: malformed launch argument 'speed', expected format '<name>:=<value>'"),
        (
            "def generate_test_description(ready_fn):\n    pass\n",
            ["test_it.py"],
            "error: generate_test_description has unexpected extra argument 'ready_fn'",
        ),
        (
            "def generate_test_description():\n    return launch.LaunchDescription([])\n",
            ["test_it.py"],
            "error: generate_test_description functions must return a LaunchDescription containing a ReadyToTest action",
        ),
    ],
)
def test_what_is_no_launch_test_is_an_error_without_a_traceback(
    tmp_path: Path, tests: str, words: list[str], what: str
) -> None:
    write(tmp_path, tests)
    done = launch_test(tmp_path, *words)
    assert done.returncode == 2
    assert what in done.stdout and "Traceback" not in done.stdout


@pytest.mark.process
def test_the_arguments_of_a_launch_test_are_shown_and_given(tmp_path: Path) -> None:
    tests = """\
declared = generate_test_description


@launch_testing.parametrize('speed, name', [(1, 'slow'), (9, 'fast')])
def generate_test_description(speed, name):
    description, context = declared()
    description.add_action(launch.actions.DeclareLaunchArgument('colour', default_value='red', description='Of paint'))
    return description, context


class TestIt(unittest.TestCase):

    def test_values(self, speed, name, test_args):
        print('VALUES', speed, name, test_args['colour'])
"""
    shown = launch_test(tmp_path, write(tmp_path, tests), "--show-args")
    assert shown.stdout == (
        "Arguments (pass arguments as '<name>:=<value>'):\n\n    'colour':\n        Of paint\n        (default: 'red')\n"
    )
    done = launch_test(tmp_path, "test_it.py", "colour:=blue", "colour:=green")
    assert done.returncode == 0, done.stdout
    assert re.findall("VALUES .*", done.stdout) == ["VALUES 1 slow green", "VALUES 9 fast green"]
    assert "\nStarting test run test_it.test_it.launch_tests[1, slow]\n" in done.stdout


@pytest.mark.process
def test_pytest_runs_what_is_marked_as_one_test_and_leaves_other_files_alone(tmp_path: Path) -> None:
    write(tmp_path, GOOD)
    (tmp_path / "test_sum.py").write_text("def test_sum():\n    assert 1 + 1 == 2\n", encoding="utf-8")
    done = pytest_on(tmp_path, "--strict-markers", "-vv")
    assert done.returncode == 0, done.stdout
    assert "test_it.py::test_it PASSED" in done.stdout and "test_sum.py::test_sum PASSED" in done.stdout
    assert "2 passed" in done.stdout


@pytest.mark.process
@pytest.mark.parametrize("mark", ["launch_test", "rostest"])
def test_pytest_shows_each_failed_case_of_a_launch_test(tmp_path: Path, mark: str) -> None:
    file = tmp_path / write(tmp_path, BAD)
    file.write_text(file.read_text(encoding="utf-8").replace("mark.launch_test", f"mark.{mark}"), encoding="utf-8")
    done = pytest_on(tmp_path, "--strict-markers")
    assert done.returncode == 1
    assert "FAIL: test_it.TestIt.test_output\n----" in done.stdout
    assert "AssertionError: Waiting for output timed out" in done.stdout and "1 failed" in done.stdout


@pytest.mark.process
def test_the_marks_of_a_description_are_those_of_its_test(tmp_path: Path) -> None:
    file = tmp_path / write(tmp_path, BAD)
    text = file.read_text(encoding="utf-8").replace("@pytest", "@pytest.mark.skip(reason='no wheels')\n@pytest")
    file.write_text(text, encoding="utf-8")
    done = pytest_on(tmp_path, "-rs")
    assert done.returncode == 0 and "1 skipped" in done.stdout and "no wheels" in done.stdout


@pytest.mark.process
def test_a_launch_test_with_a_slip_is_reported_as_any_test_file_is(tmp_path: Path) -> None:
    (tmp_path / write(tmp_path, BAD)).write_text("def generate_test_description():\n    return (\n", encoding="utf-8")
    done = pytest_on(tmp_path)
    assert "ERROR collecting test_it.py" in done.stdout and "SyntaxError" in done.stdout and done.returncode == 2


@pytest.mark.process
def test_pytest_imports_no_launch_for_other_tests(tmp_path: Path) -> None:
    (tmp_path / "test_sum.py").write_text(
        "import sys\n\n\ndef test_sum():\n    assert 'launch_testing.pytest.hooks' in sys.modules\n"
        "    assert not {'launch', 'rclpy', 'launch_testing.loader', 'unittest.mock'} & set(sys.modules)\n",
        encoding="utf-8",
    )
    done = pytest_on(tmp_path)
    assert done.returncode == 0, done.stdout


NODES = """\
import unittest

import launch
import launch_ros.actions
import launch_testing
import launch_testing.actions
import pytest
import rclpy
from launch_testing_ros import DataRepublisher, MessagePump, WaitForTopics
from std_msgs.msg import String


@pytest.mark.rostest
def generate_test_description():
    talker = launch_ros.actions.Node(package='demo_nodes_py', executable='talker')
    return launch.LaunchDescription([talker, launch_testing.actions.ReadyToTest()]), {'talker': talker}


class TestTalker(unittest.TestCase):

    def test_topics(self):
        with WaitForTopics([('chatter', String)], timeout=300.0, messages_received_buffer_length=2) as waited:
            assert waited.topics_received() == {'chatter'} and waited.topics_not_received() == set()
            assert 'Hello World' in waited.received_messages('chatter')[0].data
        waited = WaitForTopics([('nobody', String)], timeout=0.1)
        assert not waited.wait() and waited.topics_not_received() == {'nobody'}
        with self.assertRaises(KeyError):
            waited.received_messages('chatter')
        waited.shutdown()

    def test_republished(self):
        context = rclpy.Context()
        rclpy.init(context=context)
        node = rclpy.create_node('between', context=context)
        republisher = DataRepublisher(node, 'chatter', 'loud', String, lambda heard: String(data=heard.data.upper()))
        pump = MessagePump(node, context=context)
        pump.start()
        with WaitForTopics([('loud', String)], timeout=300.0) as waited:
            assert 'HELLO WORLD' in waited.received_messages('loud')[0].data
        pump.stop()
        assert republisher.get_num_received() == republisher.get_num_republished() >= 1
        assert 'Hello World' in republisher.get_republished()[0].data
        republisher.shutdown()
        rclpy.shutdown(context=context)


@launch_testing.post_shutdown_test()
class TestEnd(unittest.TestCase):

    def test_exit_codes(self, proc_info):
        launch_testing.asserts.assertExitCodes(proc_info)
"""


@pytest.mark.process
@pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to a process")
def test_a_test_of_ros_nodes_waits_for_topics_and_changes_messages(
    tmp_path: Path, short_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DAY6_LINK", "on")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "r"))
    (tmp_path / "test_talker.py").write_text(NODES, encoding="utf-8")
    done = pytest_on(tmp_path)
    assert done.returncode == 0, done.stdout


# -- what tests are written with ---------------------------------------------------------------------------------------


def recorded(*processes: tuple[str, list[str], str]) -> tuple[Any, list[Any]]:
    """Return a handler with the output of processes (name, arguments, standard output), and their actions."""
    from launch.actions import ExecuteProcess
    from launch.events.process import ProcessStdout
    from launch.launch_context import LaunchContext
    from launch_testing import IoHandler

    handler, actions = IoHandler(), []
    for name, arguments, text in processes:
        action = ExecuteProcess(cmd=["/bin/x", *arguments], name=name)
        action.prepare(LaunchContext())
        handler.append(ProcessStdout(text=text.encode(), **{**action.process_details, "pid": 1}))
        actions.append(action)
    return handler, actions


def test_a_process_is_meant_by_its_action_its_name_and_its_arguments() -> None:
    from launch.actions import ExecuteProcess
    from launch.substitutions import EnvironmentVariable
    from launch_testing.util import NO_CMD_ARGS, NoMatchingProcessException, resolveProcesses

    handler, (fast, slow, bare) = recorded(("car", ["--fast"], "a"), ("car", ["--slow", "2"], "b"), ("car", [], "c"))
    assert resolveProcesses(handler) == [fast, slow, bare]
    assert resolveProcesses(handler, process=slow) == [slow]
    assert resolveProcesses(handler, process="car", cmd_args="--fast") == [fast]
    assert resolveProcesses(handler, process="car", cmd_args=["2", "--slow"]) == [slow]
    assert resolveProcesses(handler, process="car", cmd_args=NO_CMD_ARGS) == [bare]
    assert resolveProcesses(handler, process="car", strict_proc_matching=False) == [fast, slow, bare]
    with pytest.raises(
        Exception, match=r"^Found multiple processes matching name 'car' and cmd_args 'None'. Procs: car-"
    ):
        resolveProcesses(handler, process="car")
    with pytest.raises(
        NoMatchingProcessException, match=r"^Did not find any processes matching name 'bus' and args 'None'. Procs: "
    ):
        resolveProcesses(handler, process="bus")
    with pytest.raises(NoMatchingProcessException, match=r"^No data recorded for proc bus --late$"):
        resolveProcesses(handler, process=ExecuteProcess(cmd=["bus", "--late"]))
    with pytest.raises(NoMatchingProcessException, match=r"Unknown - Process not launched yet$"):
        resolveProcesses(handler, process=ExecuteProcess(cmd=[EnvironmentVariable("HOME")]))
    with pytest.raises(TypeError, match=r"proc argument must be 'ExecuteProcess' or 'str' not <class 'int'>"):
        resolveProcesses(handler, process=3)


def test_output_is_found_as_text_pattern_and_list_in_the_stream_that_is_asked_for() -> None:
    from launch_testing.asserts import assertInStderr, assertInStdout, assertInStream

    handler, _ = recorded(("car", [], "\033[32mwheel 1\033[0m\r\nwheel 2\r\n"))
    for expected in ("wheel 1\nwheel", re.compile(r"wheel \d$"), ["1", re.compile("2")]):
        assertInStdout(handler, expected, "car")
    assertInStdout(handler, "rad 1", "car", output_filter=lambda text: text.replace("wheel", "rad"))
    for wrong in (["2", "1"], "\033[32m"):
        with pytest.raises(
            AssertionError, match=r"^Did not find '.*' in output for any of the matching processes: car-\d+$"
        ):
            assertInStdout(handler, wrong, "car")
    assertInStdout(handler, "\033[32m", "car", strip_ansi_escape_sequences=False)
    with pytest.raises(AssertionError):
        assertInStderr(handler, "wheel", "car")
    with pytest.raises(ValueError, match=r"Invalid value for stream; must be 'stdout' or 'stderr'"):
        assertInStream(handler, "wheel", "car", stream="stdin")
    with pytest.raises(ValueError, match=r"Unknown format for expected text"):
        assertInStdout(handler, 3, "car")


def test_a_text_out_of_order_is_told_with_the_lines_around_the_last_one() -> None:
    from launch_testing.asserts import assertSequentialStdout

    handler, _ = recorded(("car", [], "one\ntwo\nthree\nfour\nfive\nsix\n"))
    with (
        assertSequentialStdout(handler, "car") as order,
        pytest.raises(AssertionError, match=r"^'two' not found in sequence after previous match.") as caught,
    ):
        order.assertInStdout("thr")
        order.assertInStdout("ee")
        order.assertInStdout("two")
    assert str(caught.value).endswith(":\none\ntwo\nthree\nfour\nfive\nsix")


def test_lines_are_expected_somewhere_or_strictly() -> None:
    from launch_testing.tools import basic_output_filter, expect_output

    lines = ["pid 3", "one", "two", "three"]
    assert expect_output(lines=lines, expected_lines=["one", re.compile("th")])
    assert not expect_output(lines=lines, expected_lines=["one", re.compile("th")], strict=True)
    assert expect_output(lines=lines[1:], expected_lines=["one", "two"], strict=True)
    assert not expect_output(lines=lines, expected_lines=["three", "one"])
    assert expect_output("\n".join(lines), expected_text="two\nthree")
    assert not expect_output("\n".join(lines), expected_text="two\nthree", strict=True)
    assert not expect_output(lines=[], expected_lines=["one"])
    assert basic_output_filter(filtered_patterns=["t.*e"])("pid 3\none\nthree\n") == "one\n"
    for wrong in ({}, {"text": "a"}, {"text": "a", "lines": ["a"], "expected_text": "a"}):
        with pytest.raises(ValueError, match=r"but not both, must be specified"):
            expect_output(**wrong)


def test_exit_codes_are_looked_at_by_number() -> None:
    from launch.events.process import ProcessExited
    from launch_testing import ProcInfoHandler
    from launch_testing.asserts import EXIT_OK, EXIT_SIGINT, assertExitCodes

    handler = ProcInfoHandler()
    for name, code in (("talker", 0), ("listener", EXIT_SIGINT)):
        action: Any = object()
        handler.append(ProcessExited(action=action, name=name, cmd=[name], cwd=None, env=None, pid=1, returncode=code))
    assertExitCodes(handler, [EXIT_OK, EXIT_SIGINT])
    with pytest.raises(AssertionError, match=r"^Proc listener exited with code 130$"):
        assertExitCodes(handler)
    with pytest.raises(AssertionError, match=r"^Provided exit code 0 is not an int$"):
        assertExitCodes(handler, ["0"])  # type: ignore[list-item]


def test_a_test_is_tried_again_until_it_succeeds() -> None:
    import unittest

    from launch_testing.markers import retry_on_failure

    tries = []

    class TestIt(unittest.TestCase):
        @retry_on_failure(times=3)
        def test_third_time(self) -> None:
            tries.append(len(tries))
            with self.subTest():
                self.assertEqual(len(tries), 3)

        @retry_on_failure(times=2)
        def test_never(self) -> None:
            self.fail("never")

    outcomes = {}
    for name in ("test_third_time", "test_never"):
        result = unittest.TestResult()
        TestIt(name).run(result)
        outcomes[name] = (result.wasSuccessful(), len(result.failures))
    assert outcomes == {"test_third_time": (True, 0), "test_never": (False, 1)} and len(tries) == 3


PLAIN = """
import launch, launch_pytest, pytest, sys
from launch_pytest import tools
from launch.actions import ExecuteProcess

SCRIPT = "import time; print('ready', flush=True); time.sleep(60)"

@pytest.fixture(scope="module")
def program():
    return ExecuteProcess(cmd=[sys.executable, "-c", SCRIPT], cached_output=True)

@launch_pytest.fixture(scope="module")
def launched(program):
    return launch.LaunchDescription([program])

@pytest.mark.launch(fixture=launched, shutdown=True)
def test_after(program):
    assert program.return_code is not None

@pytest.mark.launch(fixture=launched)
async def test_coroutine(program, launch_context):
    assert await tools.wait_for_start(launch_context, program, timeout=20)

@pytest.mark.launch(fixture=launched)
def test_function(program, launch_context):
    def is_ready(text):
        assert "ready" in text
    tools.assert_output_sync(launch_context, program, is_ready, timeout=20)
    assert not tools.wait_for_output_sync(launch_context, program, lambda text: "never" in text, timeout=0.01)
    assert program.return_code is None

@pytest.mark.launch(fixture=launched)
def test_two_parts(program):
    assert program.return_code is None
    yield
    assert program.return_code is not None

@pytest.mark.launch(fixture=launched)
async def test_twice():
    yield
    yield

@pytest.mark.launch(fixture=launched)
def test_wrong():
    assert not "so it is reported"
    yield

@pytest.mark.launch
def test_without_fixture():
    pass
"""


@pytest.mark.process
def test_launch_pytest_runs_tests_beside_and_after_a_launch(tmp_path: Path) -> None:
    (tmp_path / "test_it.py").write_text(PLAIN, encoding="utf-8")
    done = pytest_on(tmp_path, "-vv", "test_it.py")
    ran = [tuple(line.split()[:2]) for line in done.stdout.splitlines() if line.startswith("test_it.py::")]
    assert [(test.partition("::")[2], outcome) for test, outcome in ran] == [
        ("test_coroutine", "PASSED"),
        ("test_function", "PASSED"),
        ("test_two_parts", "PASSED"),
        ("test_twice", "PASSED"),
        ("test_wrong", "FAILED"),
        ("test_after", "PASSED"),
        ("test_two_parts[shutdown_test]", "PASSED"),
        ("test_twice[shutdown_test]", "FAILED"),
        ("test_wrong[shutdown_test]", "SKIPPED"),
        ("test_without_fixture", "SKIPPED"),
    ], done.stdout
    assert "an async gen function must stop iteration after yielding once" in done.stdout
