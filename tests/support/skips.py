"""The tests that were left out: which reasons are all right where CI runs, and a run's end that tells all of them.

CI has everything that can be installed (.ci/tools). A test that is skipped there for another reason proves nothing, and
nobody would notice: with `--no-unknown-skips` the run fails by it.
"""

from __future__ import annotations

from collections.abc import Iterable

import pytest

_OTHER_PYTHON = "CI's run with Python 3.11 has it; its other run is that of the newest Python"

ALLOWED = {
    "the recorded texts are those of Python 3.11": _OTHER_PYTHON,
    "the guesses are those of Python 3.11": _OTHER_PYTHON,
    "recorded with Python 3.11 on Linux; its own messages, signals and exit codes are part of the recordings": _OTHER_PYTHON,
}
"""Reason -> why nothing is lost by it. Only what CI's own machine cannot run belongs here, not what other systems lack."""


def add_option(parser: pytest.Parser) -> None:
    parser.addoption("--no-unknown-skips", action="store_true", help="fail when a test is skipped that CI could run")


def judge(session: pytest.Session) -> None:
    """Fail the run, if it was asked to, by a skip whose reason is not in ALLOWED; called when all tests are over."""
    if session.exitstatus in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED) and _unknown(session.config):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def tell(reporter: pytest.TerminalReporter) -> None:
    """End the run with what it did not prove here, and why."""
    known = [(each.wasxfail, each.nodeid) for each in reporter.stats.get("xfailed", ())]
    unknown = _unknown(reporter.config)
    for title, tests in (
        ("skipped here", [each for each in _skipped(reporter) if each not in unknown]),
        ("known differences", known),
        ("skipped, which fails this run (tests/support/skips.py)", unknown),
    ):
        if tests:
            reporter.section(f"{title}: {len(tests)}")
            for line in _grouped(tests):
                reporter.write_line(line)


def _unknown(config: pytest.Config) -> list[tuple[str, str]]:
    """Reason and test of what may not be skipped in this run; a worker of pytest-xdist knows of none."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    if reporter is None or not config.getoption("--no-unknown-skips"):
        return []
    return [each for each in _skipped(reporter) if each[0] not in ALLOWED]


def _skipped(reporter: pytest.TerminalReporter) -> list[tuple[str, str]]:
    return [(_reason(each), each.nodeid) for each in reporter.stats.get("skipped", ())]


def _reason(report: pytest.TestReport) -> str:
    where = report.longrepr
    return (where[2] if isinstance(where, tuple) else str(where)).removeprefix("Skipped: ")


def _grouped(tests: Iterable[tuple[str, str]]) -> list[str]:
    """Return a line for every reason, the most frequent first: how often, why, in which files."""
    files: dict[str, list[str]] = {}
    for reason, test in tests:
        files.setdefault(reason, []).append(test.partition("::")[0].removeprefix("tests/"))
    ordered = sorted(files.items(), key=lambda item: (-len(item[1]), item[0]))
    return [f"{len(each):4}  {reason}  ({', '.join(sorted(set(each)))})" for reason, each in ordered]
