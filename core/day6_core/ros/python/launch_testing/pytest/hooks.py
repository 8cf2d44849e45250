"""The plugin: pytest runs a file as a launch test if its `generate_test_description` is marked `@pytest.mark.launch_test`.

It is loaded by every pytest that has day6-tui's packages on its path, so launch itself is imported when there is a launch test.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from launch_testing.test_runner import LaunchTestRunner

_ENTRY_POINT = "generate_test_description"


class LaunchTestFailure(Exception):
    """Some tests of some launches have failed; `results` are those of the runner."""

    def __init__(self, message: str, results: dict[Any, Any]) -> None:
        super().__init__(message)
        self.results = results

    def __str__(self) -> str:
        return str(self.args[0])

    def report(self) -> str:
        """Return the failures one after the other, as unittest prints them."""
        failures = [
            (case.id() if hasattr(case, "id") else str(case), text)
            for result in self.results.values()
            for case, text in (*result.errors, *result.failures)
        ]
        width = max((len(line) for _, text in failures for line in text.splitlines()), default=3)
        return "\n" + "\n\n".join(f"{'=' * width}\nFAIL: {name}\n{'-' * width}\n{text}" for name, text in failures)


class LaunchTestItem(pytest.Item):
    """All test runs of one file, as one test."""

    def __init__(self, *, module: ModuleType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._module = module

    def runner_class(self) -> type[LaunchTestRunner]:
        from launch_testing.test_runner import LaunchTestRunner

        return LaunchTestRunner

    def runtest(self) -> None:
        from launch_testing.loader import LoadTestsFromPythonModule

        runner = self.runner_class()(
            test_runs=LoadTestsFromPythonModule(self._module, name=self._module.__name__),
            launch_file_arguments=[word for words in self.config.getoption("--launch-args") for word in words],
            debug=bool(self.config.getoption("verbose") > 0),
        )
        runner.validate()
        results = runner.run()
        if not all(result.wasSuccessful() for result in results.values()):
            raise LaunchTestFailure("some test cases have failed", results)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, LaunchTestFailure):
            return excinfo.value.report()
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, 0, f"launch tests: {self.name}"


class LaunchTestModule(pytest.Module):
    """A file with a launch test."""

    item_class: type[LaunchTestItem] = LaunchTestItem

    def collect(self) -> Iterator[pytest.Item]:
        yield self.item_class.from_parent(self, name=self.obj.__name__, module=self.obj)


def pytest_addhooks(pluginmanager: pytest.PytestPluginManager) -> None:
    from launch_testing.pytest import hookspecs

    pluginmanager.add_hookspecs(hookspecs)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--launch-args", action="append", nargs="*", default=[], help="One or more Launch test arguments")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line(
        "markers", "launch_test: mark a generate_test_description function as a launch test entrypoint"
    )


def pytest_pycollect_makemodule(module_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    if _ENTRY_POINT.encode() not in module_path.read_bytes():
        return None  # without importing it: pytest does that later, in its own way
    try:
        entry_point = getattr(pytest.Module.from_parent(parent, path=module_path).obj, _ENTRY_POINT, None)
    except pytest.Collector.CollectError:
        return None  # pytest meets and reports the same error when it collects the file
    if entry_point is None:
        return None
    hooks = parent.session.gethookproxy(module_path)
    made: pytest.Collector | None = hooks.pytest_launch_collect_makemodule(
        path=module_path, parent=parent, entrypoint=entry_point
    )
    return made


@pytest.hookimpl(trylast=True)
def pytest_launch_collect_makemodule(path: Path, parent: pytest.Collector, entrypoint: Any) -> pytest.Collector | None:
    return collector_if_marked("launch_test", LaunchTestModule, path, parent, entrypoint)


def collector_if_marked(
    marker: str, collector: type[LaunchTestModule], path: Path, parent: pytest.Collector, entry_point: Any
) -> LaunchTestModule | None:
    """Return a collector of a file, with the marks of its entry point, if one of these is `marker`."""
    marks = getattr(entry_point, "pytestmark", [])
    if all(mark.name != marker for mark in marks):
        return None
    made: LaunchTestModule = collector.from_parent(parent, path=path)
    for mark in marks:
        made.add_marker(getattr(pytest.mark, mark.name).with_args(*mark.args, **mark.kwargs))
    return made
