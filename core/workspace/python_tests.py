"""Runs the tests of a Python package with pytest, as `colcon test` does."""

from __future__ import annotations

import sys
from html import escape
from importlib.util import find_spec
from pathlib import Path

from day6_tui.core.session.harmless import one_line
from day6_tui.core.workspace.files import Output
from day6_tui.core.workspace.jobs import Work
from day6_tui.core.workspace.local_setup_util import Environment, source_package
from day6_tui.core.workspace.packages import Package
from day6_tui.core.workspace.settings import Settings

_TESTS_FAILED = 1
_NO_TESTS = 5


def test(package: Package, settings: Settings, work: Work, failures: list[str]) -> int:
    """Run the tests of one package; returns an exit status. Failing tests are no error: the name is put into `failures`."""
    environment = Environment(settings.environment)
    for name in (*settings.needs.get(package.name, ()), package.name):
        source_package(str(settings.prefix(name)), name, environment)
    results = (settings.test_result_base or settings.build_base) / package.name / "pytest.xml"
    if not package.type.endswith("python"):
        return 0
    _write_missing(settings.output, results, package.name)
    env = dict(environment.variables)
    options = ["--tb=short", f"--junit-xml={results.as_posix()}", f"--junit-prefix={package.name}"]
    options += ["-o", f"cache_dir={(settings.build_base / package.name / '.pytest_cache').as_posix()}"]
    env["PYTEST_ADDOPTS"] = " ".join(f'"{each}"' if " " in each else each for each in (*options, *settings.pytest_args))
    status = work.run([sys.executable, "-m", "pytest"], package.path, env)
    if find_spec("pytest") is None:
        return status  # "No module named pytest": tests that did not run are more than a failing test
    if status == _TESTS_FAILED:
        failures.append(package.name)
        work.tell_test_failure()
    return 0 if status in (0, _TESTS_FAILED, _NO_TESTS) else status


def _write_missing(output: Output, path: Path, name: str) -> None:
    """Leave a failing result for a run that ends before it writes its own."""
    output.write_text(
        path,
        f'<?xml version="1.0" encoding="UTF-8"?>\n<testsuite name="{escape(one_line(name))}" tests="1" failures="0" time="0" '
        f'errors="1" skipped="0">\n  <testcase classname="{escape(one_line(name))}" name="pytest.missing_result" time="0">\n'
        '    <failure message="The test invocation failed without generating a result file."/>\n  </testcase>\n</testsuite>\n',
    )
