"""`day6-tui test`: builds a workspace and runs its tests, as `colcon build` and `colcon test` do, and sums up the results.

Everything is built in a temporary folder, which is gone afterwards: a repository stays as it was checked out, and no earlier
build can make a test pass. Where everything is Python that costs a second. `--build-dir` keeps the folders, with colcon's layout.

Each process of tests has a graph of its own (`own_graph`): pytest of a Python package, and each test of a CMake package. Where
there is virtual time it has that, too: a test that waits takes no longer than what it computes, and does the same each time.
"""

from __future__ import annotations

import os
import shutil
import tempfile
import time
from argparse import Namespace
from collections import defaultdict, deque
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.values import Values
from day6_core.language import language_of
from day6_core.reason import reason, reason_and_name

if TYPE_CHECKING:
    from day6_core.command_line.texts import Wording
    from day6_core.session.session import Session
    from day6_core.workspace.colcon import Colcon
    from day6_core.workspace.events import BuildEvent, Console
    from day6_core.workspace.style import Style

_SILENT = tuple(  # what is left is a line on a terminal that says what runs
    f"{name}-"
    for name in (
        *("console_start_end", "console_stderr", "desktop_notification", "event_log", "log"),
        *("summary", "terminal_title"),
    )
)
_MOST_OUTPUT = 1_000_000
"""Characters of a package's output that are kept; of more the end is shown."""
_LONGEST_REASON = 200
_MOST_NAMES = 3
"""Tests with the same outcome and reason that are named."""
_RAN = {"passed", "failed", "xfailed"}
_OF_PYTEST = (
    "pyproject.toml",
    "pytest.ini",
    "tox.ini",
    "setup.cfg",
    "conftest.py",
    "test",
    "tests",
    "test_*.py",
    "*_test.py",
)
"""What a repository has whose tests are run though there is no package."""
_INTERRUPTED = 130


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui test`, and what it takes."""
    parser = command_parser("test", language)
    texts, values, add = parser.texts, Values(parser.texts), parser.add_argument
    add(
        "workspace",
        nargs="?",
        default=Path(),
        type=values.folder,
        metavar="WORKSPACE",
        help=texts("cli.test.workspace"),
    )
    add("--packages-select", nargs="+", metavar="PKG", help=texts("cli.test.select"))
    add("--packages-skip", nargs="+", metavar="PKG", help=texts("cli.test.skip"))
    add("--junit-dir", type=Path, metavar="DIR", help=texts("cli.test.junit"))
    add("--build-dir", type=Path, metavar="DIR", help=texts("cli.test.build_dir"))
    add("--parallel-workers", type=values.whole(1, 1000), metavar="N", help=texts("cli.test.workers"))
    add("--pytest-args", metavar="WORDS", help=texts("cli.test.pytest_args"))
    add("--real-time", action="store_true", help=texts("cli.real_time"))
    add("--allow-no-tests", action="store_true", help=texts("cli.test.allow_none"))
    return parser


def main(words: list[str]) -> int:
    """`day6-tui test WORD…`; returns the exit status."""
    parser = build_parser(language_of(os.environ, words))
    options = parser.parse_args(words)
    from day6_core.session.local import run_local

    try:
        temporary = tempfile.TemporaryDirectory(prefix="day6-test-", ignore_cleanup_errors=True)
    except OSError as error:
        parser.exit(1, f"{parser.prog}: {reason_and_name(error)}\n")
    with temporary as folder:
        run = _Run(options, parser.texts, Path(folder))
        return run_local(run.program, [parser.prog], one_shot=True)


class Case(NamedTuple):
    """One test: 'passed', 'failed', 'skipped' or 'xfailed' (it failed as it was said to), and why."""

    name: str
    outcome: str
    reason: str


class _Run:
    def __init__(self, options: Namespace, texts: Wording, folder: Path) -> None:
        self._options = options
        self._texts = texts
        self._workspace: Path = options.workspace.absolute()
        self._folder: Path = options.build_dir.absolute() if options.build_dir else folder
        self._results = folder / "results"
        """A new folder in any case: nothing of an earlier run is counted."""

    async def program(self, session: Session) -> int:
        """Build, test and report; returns the exit status."""
        from day6_core.ros.environment import activate, as_program
        from day6_core.session.argument_parser import ParserExit
        from day6_core.virtual.surroundings import is_due
        from day6_core.workspace.arguments import parse
        from day6_core.workspace.colcon import Colcon
        from day6_core.workspace.command import in_thread
        from day6_core.workspace.events import Console
        from day6_core.workspace.order import OrderError
        from day6_core.workspace.own_graph import own_graph
        from day6_core.workspace.selection import SelectionError

        activate()
        environment = as_program(session.env)
        console = Console(session.stdout, session.stderr, environment=environment)
        report = Report(console, self._texts, self._results)

        def colcon(verb: str, *words: str) -> Colcon:
            bases = [f"--{name}-base={self._folder / name}" for name in ("build", "install")]
            bases += [f"--test-result-base={self._results}"] if verb == "test" else []
            workers = self._options.parallel_workers
            words = (
                *(f"--log-base={self._folder / 'log'}", verb, *bases, *words, "--event-handlers", *_SILENT),
                *(("--parallel-workers", str(workers)) if workers else ()),
            )
            args = parse(session, list(words))
            around = partial(own_graph, fast=is_due(real_time=self._options.real_time))
            return Colcon(args, console, self._workspace, environment, handlers=[report], around_test=around)

        async def run(verb: str, *words: str) -> bool:
            """Run a verb; returns whether it came to its end."""
            found = colcon(verb, *words)
            report.verb = verb
            await in_thread(found.run, found.interrupt)
            return not found.interrupted

        try:
            chosen = [each.package.name for each in colcon("test", *self._selection()).planned() if each.selected]
            if not chosen:
                if self._selection() or not any(any(self._workspace.glob(each)) for each in _OF_PYTEST):
                    return report.nothing(self._texts("cli.test.no_package", workspace=self._workspace))
                return await self._plain(colcon("test", *self._pytest_args()), report)
            if not await run("build", "--continue-on-error", "--packages-up-to", *chosen):
                return _INTERRUPTED
            report.expect(chosen)
            ready = report.ready()
            if ready and not await run("test", *self._pytest_args(), "--packages-select", *ready):
                return _INTERRUPTED
            self._hand_over_results()
        except ParserExit as end:
            return end.status
        except (SelectionError, OrderError) as error:
            return report.nothing(str(error))
        except OSError as error:
            return report.nothing(reason_and_name(error))
        return report.end(allow_none=self._options.allow_no_tests)

    async def _plain(self, colcon: Colcon, report: Report) -> int:
        """Run pytest in a repository without packages; returns the exit status."""
        from day6_core.workspace.command import in_thread
        from day6_core.workspace.jobs import Job, OnError, Work
        from day6_core.workspace.package_tests import test
        from day6_core.workspace.packages import Package

        package = Package(self._workspace.name, "python", self._workspace, ".")
        settings, failures = colcon.settings(), list[str]()

        def run(work: Work) -> int:
            return test(package, settings, work, failures)

        report.verb = "test"
        report.expect([package.name])
        await in_thread(lambda: colcon.execute([Job(package.name, set(), run)], OnError.CONTINUE), colcon.interrupt)
        self._hand_over_results()
        return _INTERRUPTED if colcon.interrupted else report.end(allow_none=self._options.allow_no_tests)

    def _hand_over_results(self) -> None:
        if self._options.junit_dir is not None:
            self._results.mkdir(exist_ok=True)
            shutil.copytree(self._results, self._options.junit_dir, dirs_exist_ok=True)

    def _selection(self) -> list[str]:
        options = self._options
        return [
            *(("--packages-select", *options.packages_select) if options.packages_select else ()),
            *(("--packages-skip", *options.packages_skip) if options.packages_skip else ()),
        ]

    def _pytest_args(self) -> list[str]:
        if not self._options.pytest_args:
            return []
        import shlex

        return ["--pytest-args", *shlex.split(self._options.pytest_args)]


class Report:
    """Prints a line for each package that was tested, then what failed, what was skipped, and a sum."""

    def __init__(self, console: Console, texts: Wording, results: Path) -> None:
        self.verb = "build"
        """What is being done."""
        self._console = console
        self._texts = texts
        self._results = results
        self._output: dict[str, deque[str]] = defaultdict(deque)
        self._sizes: dict[str, int] = defaultdict(int)
        self._began: dict[str, float] = {}
        self._built: set[str] = set()
        self._chosen: list[str] = []
        self._failed: dict[str, str] = {}
        """The packages with something that went wrong, and all their output then."""
        self._cases: dict[str, list[Case]] = {}
        self._failing: set[str] = set()

    # -- events --------------------------------------------------------------------------------------------------------

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        name = event.job
        if event.kind == "started":
            self._began[name] = time.monotonic()
            self._output[name].clear()
            self._sizes[name] = 0
        elif event.kind in ("stdout", "stderr"):
            self._keep(name, event.text)
        elif event.kind == "test_failure":
            self._failing.add(name)
        elif event.kind == "ended":
            (self._build_ended if self.verb == "build" else self._test_ended)(name, event.result)

    def _keep(self, name: str, text: str) -> None:
        lines = self._output[name]
        lines.append(text)
        self._sizes[name] += len(text)
        while self._sizes[name] > _MOST_OUTPUT and len(lines) > 1:
            self._sizes[name] -= len(lines.popleft())

    def _build_ended(self, name: str, result: int | str) -> None:
        if result:
            self._failed[name] = "".join(self._output[name])
            self._line(name, "cli.test.not_built", bad=True)
        else:
            self._built.add(name)

    def _test_ended(self, name: str, result: int | str) -> None:
        cases = self._cases[name] = read_cases(self._results / name)
        bad = bool(result) or name in self._failing or any(each.outcome == "failed" for each in cases)
        if bad:
            self._failed[name] = "".join(self._output[name])
        outcomes = {case.outcome for case in cases}
        best = "passed" if outcomes & _RAN else "skipped" if outcomes else "no_tests"
        self._line(name, f"cli.test.{'failed' if bad else best}", self._counts(cases), bad=bad)

    def _line(self, name: str, key: str, counts: str = "", *, bad: bool) -> None:
        from day6_core.session.harmless import one_line
        from day6_core.workspace.events import duration
        from day6_core.workspace.style import Style

        took = duration(time.monotonic() - self._began[name])
        word = self._styled(Style.ERROR, self._texts(key)) if bad else self._texts(key)
        told = self._texts("cli.test.comma").join(filter(None, (word, counts)))
        self._console.out(f"{one_line(name)}: {told} [{took}]\n")

    def _styled(self, style: Style, text: str) -> str:
        return self._console.out_style(style, text)

    # -- between building and testing ----------------------------------------------------------------------------------

    def expect(self, chosen: list[str]) -> None:
        """Take note of the packages that are to be tested."""
        self._chosen = chosen

    def ready(self) -> list[str]:
        """Return those of them that are built."""
        return [name for name in self._chosen if name in self._built]

    # -- the end -------------------------------------------------------------------------------------------------------

    def nothing(self, text: str) -> int:
        """Say why there is nothing to report; returns the exit status."""
        from day6_core.session.harmless import one_line

        self._console.err(f"day6-tui test: {one_line(text)}\n")
        return 1

    def end(self, *, allow_none: bool) -> int:
        """Print what went wrong, in the words of those who said it, and the sum; returns the exit status."""
        for name, output in self._failed.items():
            self._console.out(f"\n--- {name}\n{output.rstrip()}\n---\n")
        cases = {name: self._cases.get(name, []) for name in self._chosen}
        self._list("failed", cases)
        self._list("skipped", cases)
        untested = [name for name in self._chosen if name not in self._cases]
        if untested:
            self._console.out(f"\n{self._texts('cli.test.untested', names=', '.join(untested))}\n")
        every = [case for of_package in cases.values() for case in of_package]
        ran = any(case.outcome in _RAN for case in every)
        self._console.out(f"\n{self._texts('cli.test.sum', count=len(cases), tests=self._counts(every) or 0)}\n")
        if not ran and not self._failed:
            self._console.out(f"{self._texts('cli.test.none_ran')}\n")
        return int(bool(self._failed or untested) or not (ran or allow_none))

    def _list(self, outcome: str, cases: Mapping[str, list[Case]]) -> None:
        """Print the tests with an outcome; those with the same reason in one line."""
        from day6_core.session.harmless import one_line

        found: dict[tuple[str, str], list[str]] = defaultdict(list)
        for name, of_package in cases.items():
            for case in of_package:
                if case.outcome == outcome:
                    found[name, case.reason[:_LONGEST_REASON]].append(case.name)
        if found:
            self._console.out(f"\n{self._texts(f'cli.test.{outcome}_tests')}\n")
        for (name, why), tests in found.items():
            more = self._texts("cli.test.more", count=len(tests) - _MOST_NAMES) if len(tests) > _MOST_NAMES else ""
            text = ": ".join(filter(None, (name, ", ".join(tests[:_MOST_NAMES]) + more, why)))
            self._console.out(f"  {one_line(text)}\n")

    def _counts(self, cases: list[Case]) -> str:
        outcomes = [case.outcome for case in cases]
        counts = ((key, outcomes.count(key)) for key in ("passed", "failed", "xfailed", "skipped"))
        comma = self._texts("cli.test.comma")
        return comma.join(self._texts(f"cli.test.count.{key}", count=count) for key, count in counts if count)


def read_cases(folder: Path) -> list[Case]:
    """Return the tests in the JUnit files below a folder."""
    from day6_core.plain_xml import plain_xml

    cases = []
    for path in sorted(folder.rglob("*.xml")):
        try:
            root = plain_xml(path.read_bytes())
        except (OSError, ValueError) as error:
            cases.append(Case(path.name, "failed", reason(error)))
            continue
        for case in root.iter("testcase"):
            name = "::".join(filter(None, (case.get("classname"), case.get("name"))))
            bad = [node for kind in ("failure", "error") for node in case.findall(kind)]
            left_out = [node for kind in ("skipped", "skip", "disabled") for node in case.findall(kind)]
            outcome = "failed" if bad else "skipped" if left_out else "passed"
            if any(node.get("type") == "pytest.xfail" for node in left_out):
                outcome = "xfailed"
            whole = next((node.get("message") or node.text or "" for node in (*bad, *left_out)), "")
            cases.append(Case(name, outcome, whole.strip().partition("\n")[0]))
    return cases
