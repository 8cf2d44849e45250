"""One call of `colcon`: finds the packages, then runs the verb. It has its own thread, so it may block.

Why not colcon-core itself, with our own tasks: it keeps its state in the process (environment, root logger, an event loop that
handles the signals), so that a desktop, where several terminals build at once, needs a process for each call. An empty
workspace then takes 0.48 s of CPU (colcon-core 0.21.3 and colcon-ros 0.5.0 alone; 0.64 s among 80 other distributions, all
of whose entry points it reads) against 0.01 s here, or 0.22 s as a process of its own. The limit was 0.3 s more. What it
prints and leaves is compared case by case in tests/conformance.
"""

from __future__ import annotations

import os
import threading
from argparse import Namespace
from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager, nullcontext, suppress
from pathlib import Path

from day6_core.reason import reason_and_name
from day6_core.workspace import overriding, reports
from day6_core.workspace.advisor import Advisor
from day6_core.workspace.build import BUILD_TOOL, find_task, refuse_foreign_folder
from day6_core.workspace.events import INTERRUPTED, BuildEvent, Console, Events, Handler
from day6_core.workspace.files import BuildOutput
from day6_core.workspace.handlers import chosen_handlers
from day6_core.workspace.jobs import Executor, Job, OnError, Work
from day6_core.workspace.logs import LogFolder, mark_ignored
from day6_core.workspace.meta import MetaFiles
from day6_core.workspace.order import OrderError, Planned, check_unique, plan
from day6_core.workspace.package_tests import test
from day6_core.workspace.packages import Package, find_packages, refuse_sources
from day6_core.workspace.results import show_results
from day6_core.workspace.selection import LOGGER, SelectionError, select, without_ignored
from day6_core.workspace.settings import BuildSettings
from day6_core.workspace.setup_scripts import write_workspace_scripts

_OURS = "colcon.day6_tui"
"""The logger of what colcon itself doesn't say."""

_INTERRUPT_STATUS = 2
"""The real colcon's exit status after Ctrl-C: the number of SIGINT."""


class Failure(Exception):
    """Ends the call with status 1; the text is shown as an error in colcon's log."""


class Colcon:
    """One call. `run()` returns the exit status; `interrupt()` may be called from any thread while it runs."""

    def __init__(
        self,
        args: Namespace,
        console: Console,
        cwd: Path,
        environment: Mapping[str, str],
        *,
        handlers: Iterable[Handler] = (),
        around_test: Callable[[Mapping[str, str]], AbstractContextManager[Mapping[str, str]]] = nullcontext,
    ) -> None:
        self.args = args
        self.console = console
        self.cwd = cwd
        self.environment = environment
        base = args.log_base or environment.get("COLCON_LOG_PATH") or "log"
        self.log = LogFolder(Path(base) if base == os.devnull else cwd / base, args.verb_name, self._warn_of_logs)
        self.selected: list[str] = []
        """The packages of a build."""
        self._handlers = tuple(handlers)
        """Besides those that the options choose."""
        self._around_test = around_test
        self._advisor = Advisor(console, environment, cwd)
        self._executor: Executor | None = None
        self.interrupted = False
        """Whether Ctrl-C has ended it."""
        self._lock = threading.Lock()

    def interrupt(self) -> None:
        """Ctrl-C."""
        with self._lock:
            self.interrupted = True
            if self._executor is not None:
                self._executor.interrupt()

    def run(self) -> int:
        """Run the verb. File system errors are reported with the name of the file."""
        verb = self.args.verb_name
        for text in self.args.remarks:
            self.warn(_OURS, text)
        try:
            try:
                self.log.write("logger_all.log", f"[0.000s] DEBUG:colcon:Command line arguments: {['colcon', verb]}\n")
            except OSError as error:
                self.log.give_up(error)
            return _VERBS[verb](self)
        except (Failure, OrderError) as error:
            self.warn("colcon", f"colcon {verb}: {error}", level="ERROR")
        except SelectionError as error:
            self.console.err(f"{error}\n")
        except OSError as error:
            self.warn("colcon", f"colcon {verb}: {reason_and_name(error)}", level="ERROR")
        return 1

    def warn(self, logger: str, text: str, level: str = "WARNING") -> None:
        """Print a message of colcon's log."""
        self.console.warn(logger, text, level)

    def _warn_of_logs(self, text: str) -> None:
        self.warn("colcon.colcon_core.logging", text)

    # -- packages ------------------------------------------------------------------------------------------------------

    def planned(self) -> list[Planned]:
        """Find, order and select the packages.

        With `--paths` alone nothing is crawled (colcon_core's discover_packages: a discovery extension without parameters is
        skipped if another one has some).
        """
        base_paths = self.args.base_paths
        if base_paths is None:
            base_paths = [] if self.args.paths else ["."]
        metas = MetaFiles(self.warn)
        metas.read(self.args.metas or (), self.cwd, self.environment, of_user=not self.args.ignore_user_meta)
        packages = without_ignored(
            find_packages(base_paths, self.cwd, self.environment, self.warn, paths=self.args.paths or (), metas=metas),
            self.args,
        )
        planned = plan(packages)
        build_base = self.cwd / getattr(self.args, "build_base", "build")
        select(planned, self.args, build_base, self.warn)
        return planned

    # -- verbs ---------------------------------------------------------------------------------------------------------

    def build(self) -> int:
        """Run `colcon build`; returns the exit status."""
        args = self.args
        settings = self.settings()
        _mark_build_tool(settings)
        _mark_layout(settings, args)
        for folder in (settings.build_base, settings.install_base):
            mark_ignored(settings.output, folder)
        planned = self.planned()
        check_unique(planned)
        settings.output.protect(each.package.path for each in planned)
        settings.needs = {each.package.name: each.needs for each in planned}
        jobs = self._jobs(planned, "build", settings, find_task)
        self.selected = [each.package.name for each in planned if each.selected]
        if text := overriding.warning(self.selected, args.allow_overriding, settings.install_base, self.environment):
            self.warn(LOGGER, text)
        outcome = self.execute(jobs, OnError.SKIP_DOWNSTREAM if args.continue_on_error else OnError.INTERRUPT)
        chained = self._chained(settings.install_base)
        write_workspace_scripts(settings.output, settings.install_base, chained)
        return outcome

    def test(self) -> int:
        """Run `colcon test`; returns the exit status."""
        settings = self.settings()
        if settings.install_base.is_dir():
            _mark_layout(settings, self.args)
        if not settings.build_base.is_dir():
            self.console.err("The build space does not exist. Build the packages before testing them.\n")
        planned = self.planned()
        check_unique(planned)
        settings.output.protect(each.package.path for each in planned)
        settings.needs = {each.package.name: each.needs for each in planned}
        failures: list[str] = []

        def run(package: Package, settings: BuildSettings, work: Work) -> int:
            return test(package, settings, work, failures)

        jobs = self._jobs(planned, "test", settings, lambda package: run if find_task(package) else None)
        outcome = self.execute(jobs, OnError.INTERRUPT if self.args.abort_on_error else OnError.CONTINUE)
        return 1 if not outcome and failures and self.args.return_code_on_test_failure else outcome

    def list_(self) -> int:
        """Run `colcon list`; returns the exit status."""
        return reports.list_packages(self.planned(), self.args, self.console)

    def info(self) -> int:
        """Run `colcon info`; returns the exit status."""
        return reports.info(self.planned(), self.args, self.console)

    def graph(self) -> int:
        """Run `colcon graph`; returns the exit status."""
        return reports.graph(self.planned(), self.args, self.console)

    def test_result(self) -> int:
        """Run `colcon test-result`; returns the exit status."""
        return show_results(self.cwd, self.args, self.console)

    def metadata(self) -> int:
        """Run `colcon metadata`, which has nothing to do here."""
        return 0

    def extensions(self) -> int:
        """Run `colcon extensions` or `extension-points`; returns the exit status."""
        return reports.extensions(self.console)

    def version_check(self) -> int:
        """Run `colcon version-check`; returns the exit status."""
        return reports.version_check(self.console)

    # -- running the jobs ----------------------------------------------------------------------------------------------

    def settings(self) -> BuildSettings:
        """Return what tasks need; its folders for output hold no sources."""
        args = self.args
        build, install = ((self.cwd / base).absolute() for base in (args.build_base, args.install_base))
        results = (self.cwd / args.test_result_base).absolute() if args.test_result_base else None
        bases = [build, install, *([results] if results else [])]
        for base in (*bases, *self.log.bases):
            refuse_sources(base)
        return BuildSettings(
            build_base=build,
            install_base=install,
            output=BuildOutput(bases),
            environment=self.environment,
            warn=self.warn,
            print_error=self._advisor.print_error,
            merge_install=args.merge_install,
            symlink_install=getattr(args, "symlink_install", False),
            test_result_base=results,
            around_test=self._around_test,
            args=args,
        )

    def _jobs(
        self,
        planned: list[Planned],
        verb: str,
        settings: BuildSettings,
        task_of: Callable[[Package], Callable[[Package, BuildSettings, Work], int] | None],
    ) -> list[Job]:
        jobs = []
        for each in planned:
            if not each.selected:
                continue
            task = task_of(each.package)
            if task is None:
                self.warn("colcon.colcon_core.verb", f"No task extension to '{verb}' a '{each.package.type}' package")
                continue
            jobs.append(
                Job(
                    each.package.name, set(each.needs), _recorded(task, each.package, settings, verb), each.package.type
                )
            )
        return jobs

    def execute(self, jobs: list[Job], on_error: OnError) -> int:
        """Run jobs, with what is printed and logged of them; returns the exit status."""
        handlers = chosen_handlers(self.args.event_handlers or [], self.console, self.args.verb_name, self.log)
        events = Events([*handlers, *self._handlers, self._advisor])
        executor_name = self.args.executor or self.environment.get("COLCON_DEFAULT_EXECUTOR")
        workers = 1 if executor_name == "sequential" else self.args.parallel_workers
        with self._lock:
            executor = self._executor = Executor(events, workers, on_error)
            if self.interrupted:
                executor.interrupt()
        outcome = executor.run(jobs)
        events.emit(BuildEvent("end"))
        if isinstance(outcome, Exception):
            self.console.err(f"{outcome}\n")
        self._advisor.advise(building=self.args.verb_name == "build")
        if isinstance(outcome, Exception):
            return 1
        return _INTERRUPT_STATUS if outcome == INTERRUPTED else int(outcome)

    def _chained(self, install: Path) -> list[str]:
        """Return the workspaces that were sourced here, nearest first; warn of those that no longer exist."""
        chained: dict[str, None] = {}
        for variable, logger in (
            ("COLCON_PREFIX_PATH", "colcon.colcon_core.prefix_path.colcon"),
            ("AMENT_PREFIX_PATH", "colcon.colcon_ros.prefix_path.ament"),
        ):
            for path in self.environment.get(variable, "").split(os.pathsep):
                if path and not os.path.exists(path):
                    self.warn(logger, f"The path '{path}' in the environment variable {variable} doesn't exist")
                elif path and variable == "COLCON_PREFIX_PATH" and Path(path) != install:
                    chained[path] = None
        return list(chained)


def _recorded(
    task: Callable[[Package, BuildSettings, Work], int], package: Package, settings: BuildSettings, verb: str
) -> Callable[[Work], int]:
    """Run a task and record its result in the package's build folder, for options like `--packages-skip-build-finished`."""

    def run(work: Work) -> int:
        folder = settings.build_base / package.name
        refuse_foreign_folder(folder)
        result = "1"
        try:
            status = task(package, settings, work)
            result = "SIGINT" if work.stopped and status else str(status)
            return status
        finally:
            with suppress(OSError):
                settings.output.write_text(
                    folder / f"colcon_{verb}.rc", f"{'SIGINT' if work.stopped and result != '0' else result}\n"
                )

    return run


def _mark_build_tool(settings: BuildSettings) -> None:
    folder = settings.build_base
    marker = folder / ".built_by"
    if marker.is_file():
        before = marker.read_text(encoding="utf-8", errors="replace").strip()
        if before != BUILD_TOOL:
            raise Failure(
                f"The build directory '{folder.name}' was created by '{before}'. Please remove the build directory or pick a "
                "different one."
            )
        return
    settings.output.write_text(marker, f"{BUILD_TOOL}\n")


def _mark_layout(settings: BuildSettings, args: Namespace) -> None:
    marker = settings.install_base / ".colcon_install_layout"
    wanted = "merged" if args.merge_install else "isolated"
    if marker.is_file():
        layout = marker.read_text(encoding="utf-8", errors="replace").strip()
        if layout != wanted:
            what = "add" if layout == "merged" else "remove"
            raise Failure(
                f"The install directory '{args.install_base}' was created with the layout '{layout}'. Please remove the "
                f"install directory, pick a different one or {what} the '--merge-install' option."
            )
        return
    settings.output.write_text(marker, f"{wanted}\n")


_VERBS: dict[str, Callable[[Colcon], int]] = {
    "build": Colcon.build,
    "test": Colcon.test,
    "list": Colcon.list_,
    "info": Colcon.info,
    "graph": Colcon.graph,
    "test-result": Colcon.test_result,
    "metadata": Colcon.metadata,
    "extensions": Colcon.extensions,
    "extension-points": Colcon.extensions,
    "version-check": Colcon.version_check,
}
