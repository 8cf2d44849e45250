"""Runs the tests of a package, as `colcon test` does: pytest for a Python package, pytest and launch tests of a CMake package.

Other tests of a CMake package (C++ tests, linters) cannot run here. Each of them becomes a skipped result and is named on
standard error: a test that did not run is never green.
"""

from __future__ import annotations

import itertools
import os
from collections.abc import Mapping
from html import escape
from importlib.util import find_spec
from pathlib import Path

from day6_core.ros.home_python import python_of
from day6_core.session.harmless import one_line
from day6_core.workspace.build_cmake import cmake_variables
from day6_core.workspace.cmake import LISTS, CMakeError, Command, read_commands
from day6_core.workspace.jobs import Work
from day6_core.workspace.local_setup_util import Environment, source_package
from day6_core.workspace.packages import Package
from day6_core.workspace.settings import BuildSettings

_LOGGER = "colcon.colcon_core.verb.test"
_TESTS_FAILED = 1
_NO_TESTS = 5

_PYTEST = "ament_add_pytest_test"
_LAUNCH_TEST, _ROS_TEST = "add_launch_test", "add_ros_test"
_KEYWORDS = (
    *("APPEND_ENV", "APPEND_LIBRARY_DIRS", "ARGS", "ENV", "LABELS", "PYTHON_EXECUTABLE"),
    *("RUNNER", "TARGET", "TIMEOUT", "WORKING_DIRECTORY"),
)
"""The keywords of these commands."""
_ISOLATED = "run_test_isolated.py"
"""The runner of ament_cmake_ros that gives each test a ROS_DOMAIN_ID of its own, as add_ros_test does by itself."""
_domains = itertools.cycle(range(1, 102))
_OTHERS = frozenset(
    {
        "add_test",
        "ament_add_catch2",
        "ament_add_gmock",
        "ament_add_google_benchmark",
        "ament_add_gtest",
        "ament_add_nose_test",
        "ament_add_ros_isolated_gtest",
        "ament_add_ros_isolated_pytest_test",
        "ament_add_test",
        "ament_lint_auto_find_test_dependencies",
    }
)


def test(package: Package, settings: BuildSettings, work: Work, failures: list[str]) -> int:
    """Run the tests of one package; returns an exit status. Failing tests are not an error: the name is added to `failures`."""
    environment = Environment(settings.environment)
    for name in (*settings.needs.get(package.name, ()), package.name):
        source_package(str(settings.prefix(name)), name, environment)
    run = _Run(package, settings, work, dict(environment.variables))
    status = run.python() if package.type.endswith("python") else run.cmake()
    if status == _TESTS_FAILED and find_spec("pytest") is not None:
        failures.append(package.name)
        work.report_test_failure()
        return 0
    return status  # without pytest 1 is "No module named pytest", which is more than a failing test


class _Run:
    def __init__(self, package: Package, settings: BuildSettings, work: Work, environment: dict[str, str]) -> None:
        self.package = package
        self.settings = settings
        self.work = work
        self.environment = environment
        self.results = (settings.test_result_base or settings.build_base) / package.name

    def python(self) -> int:
        """Run the tests of a Python package; returns the status of pytest or unittest."""
        if self.settings.option("python_testing", self.package) == "setuppy_test":
            return self._unittest()
        return self._pytest([], self.results / "pytest.xml", self.environment)

    def _unittest(self) -> int:
        for option in ("retest-until-fail", "retest-until-pass"):
            if self.settings.option(option.replace("-", "_"), self.package):
                self._warn(
                    f"Ignored '--{option}' for package '{self.package.name}' since 'unittest' does not support the usage"
                )
        words = [
            python_of(self.environment),
            "-m",
            "unittest",
            "-v",
            *(self.settings.option("unittest_args", self.package) or ()),
        ]
        return self._run(words, self.package.path, self.environment)

    def _run(self, words: list[str], cwd: Path, environment: Mapping[str, str], *, one_stream: bool = False) -> int:
        with self.settings.around_test(environment) as variables:
            return self.work.run(words, cwd, variables, one_stream=one_stream)

    def _warn(self, text: str) -> None:
        self.settings.warn(_LOGGER, text)

    def cmake(self) -> int:
        """Run the tests added with BUILD_TESTING on; returns the worst of pytest's statuses."""
        lists = self.package.path / LISTS
        if not lists.is_file():
            return 0
        variables = {**cmake_variables(self.package, self.settings), "BUILD_TESTING": "ON"}
        try:
            commands = read_commands(lists.read_text(encoding="utf-8", errors="replace"), variables)
        except CMakeError as error:
            self.work.stderr(str(error))
            return 1
        self._skip([command for command in commands if command.name in _OTHERS])
        statuses = [self._cmake_test(each) for each in commands if each.name == _PYTEST and len(each.words) > 1]
        statuses += [
            self._launch_test(each) for each in commands if each.name in (_LAUNCH_TEST, _ROS_TEST) and each.words
        ]
        return max(statuses, key=lambda status: (status > _TESTS_FAILED, status), default=0)

    def _cmake_test(self, command: Command) -> int:
        name, path, *_ = command.words
        return self._pytest([str(command.folder / path)], self._result_of(name), self._environment_of(command))

    def _launch_test(self, command: Command) -> int:
        """Run a launch test as add_launch_test (launch_testing_ament_cmake) does, or add_ros_test (ros_testing).

        Returns 0 or _TESTS_FAILED.
        """
        path = command.folder / command.words[0]
        target = (command.after("TARGET", *_KEYWORDS) or [os.path.relpath(path, self.package.path)])[0]
        result = self._result_of(target)
        self._write_missing(result)
        words = [
            *(
                python_of(self.environment),
                "-m",
                "launch_testing.launch_test",
                str(path),
                *command.after("ARGS", *_KEYWORDS),
            ),
            *(f"--junit-xml={result.as_posix()}", f"--package-name={self.package.name}"),
        ]
        environment = self._environment_of(command)
        runner = os.path.basename("".join(command.after("RUNNER", *_KEYWORDS)))
        if command.name == _ROS_TEST or runner == _ISOLATED:
            self._isolate(environment)
        status = self._run(words, self.settings.build_base / self.package.name, environment, one_stream=True)
        return _TESTS_FAILED if status else 0

    def _isolate(self, environment: dict[str, str]) -> None:
        """Choose a domain, unless one is set (run_test_isolated.py); a terminal of day6-tui says 0 where none is."""
        if environment.get("ROS_DOMAIN_ID", "0") == "0" and "DISABLE_ROS_ISOLATION" not in environment:
            environment["ROS_DOMAIN_ID"] = str(next(_domains))
            self.work.stdout(f"Running with ROS_DOMAIN_ID {environment['ROS_DOMAIN_ID']}\n")

    def _environment_of(self, command: Command) -> dict[str, str]:
        pairs = (word.partition("=") for word in command.after("ENV", *_KEYWORDS))
        return {**self.environment, **{variable: value for variable, equals, value in pairs if equals}}

    def _result_of(self, name: str) -> Path:
        file = f"{one_line(name).replace('/', '_').replace(os.sep, '_')}.xunit.xml"
        return self.results / "test_results" / self.package.name / file

    def _pytest(self, words: list[str], result: Path, environment: dict[str, str]) -> int:
        """Run pytest; returns 0 also if there were no tests, as colcon does."""
        name = self.package.name
        self._write_missing(result)
        cache = (self.settings.build_base / name / ".pytest_cache").as_posix()
        options = [
            "--tb=short",
            f"--junit-xml={result.as_posix()}",
            f"--junit-prefix={name}",
            "-o",
            f"cache_dir={cache}",
        ]
        coverage = self._coverage()
        options += [*coverage, *self._again(), *(self.settings.option("pytest_args", self.package) or ())]
        environment = {
            **environment,
            **({"COVERAGE_FILE": str(self.settings.build_base / name / ".coverage")} if coverage else {}),
            "PYTEST_ADDOPTS": " ".join(f'"{each}"' if " " in each else each for each in options),
        }
        status = self._run([python_of(environment), "-m", "pytest", *words], self.package.path, environment)
        return 0 if status == _NO_TESTS else status

    def _coverage(self) -> list[str]:
        """Return what `--pytest-with-coverage` asks of pytest."""
        if not self.settings.option("pytest_with_coverage", self.package):
            return []
        if find_spec("pytest_cov") is None:
            self._warn(
                f"Test coverage will not be produced for package '{self.package.name}' since the pytest extension 'cov' was "
                "not found"
            )
            return []
        folder = (self.settings.build_base / self.package.name).as_posix()
        reports = (f"--cov-report={kind}:{folder}/coverage.{kind}" for kind in ("html", "xml"))
        return [f"--cov={self.package.path.as_posix()}", *reports, "--cov-branch"]

    def _again(self) -> list[str]:
        """Return what `--retest-until-fail` and `--retest-until-pass` ask of pytest."""
        words = []
        for option, the, plugin in (
            ("retest_until_fail", "the pytest extension", "repeat"),
            ("retest_until_pass", "pytest extension", "rerunfailures"),
        ):
            if not (number := self.settings.option(option, self.package)):
                continue
            if find_spec(f"pytest_{plugin}") is None:
                self._warn(
                    f"Ignored '--{option.replace('_', '-')}' for package '{self.package.name}' since {the} '{plugin}' was not "
                    "found"
                )
            else:
                words.append(f"--count={number + 1}" if plugin == "repeat" else f"--reruns={number}")
        return words

    def _skip(self, commands: list[Command]) -> None:
        """Report the tests that do not run here and write a skipped result for each; an outdated result is removed."""
        names = [_test_name(command) for command in commands]
        result = self.results / "test_results" / self.package.name / "not_run_here.xunit.xml"
        if names:
            self._write(result, names, "skipped", "day6-tui runs only pytest and launch tests")
            self.work.stderr(
                "day6-tui runs only pytest and launch tests: "
                f"these of '{self.package.name}' did not run: {', '.join(names)}\n"
            )
        elif result.is_file():
            self.settings.output.remove(result)

    def _write_missing(self, result: Path) -> None:
        """Write a failing result, in case the tests end before they write their own."""
        self._write(result, ["pytest.missing_result"], "error", "The test invocation failed without a result file.")

    def _write(self, path: Path, tests: list[str], outcome: str, reason: str) -> None:
        """Write a result in which all tests have one outcome: 'error' or 'skipped'."""
        name = escape(one_line(self.package.name))
        element = "failure" if outcome == "error" else outcome
        cases = [
            f'  <testcase classname="{name}" name="{escape(one_line(test))}" time="0">\n'
            f'    <{element} message="{escape(reason)}"/>\n  </testcase>\n'
            for test in tests
        ]
        errors, skipped = (len(cases) if outcome == each else 0 for each in ("error", "skipped"))
        self.settings.output.write_text(
            path,
            f'<?xml version="1.0" encoding="UTF-8"?>\n<testsuite name="{name}" tests="{len(cases)}" failures="0" '
            f'time="0" errors="{errors}" skipped="{skipped}">\n{"".join(cases)}</testsuite>\n',
        )


def _test_name(command: Command) -> str:
    if command.name == "ament_lint_auto_find_test_dependencies":
        return "ament_lint_auto"
    words = command.after("NAME") if command.name == "add_test" and "NAME" in command.words else command.words
    return words[0] if words else command.name
