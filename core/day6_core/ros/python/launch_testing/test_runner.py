"""Launches test runs one after the other, and runs the tests beside and after each launch."""

from __future__ import annotations

import inspect
import threading
import unittest
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from launch import LaunchDescription, LaunchDescriptionEntity, LaunchDescriptionSource, LaunchService
from launch.actions import IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart

from launch_testing.io_handler import ActiveIoHandler
from launch_testing.loader import TestRun
from launch_testing.parse_arguments import parse_launch_arguments
from launch_testing.proc_info_handler import ActiveProcInfoHandler
from launch_testing.test_result import FailResult, SkipResult, TestResult


class _LaunchDiedException(Exception):
    """The launch has ended before its tests."""


class _RunnerWorker:
    """Launches one test run. A launch needs the main thread, so the tests beside it run on another one."""

    def __init__(
        self,
        test_run: TestRun,
        test_run_preamble: Sequence[LaunchDescriptionEntity],
        launch_file_arguments: Iterable[str] = (),
        debug: bool = False,
    ) -> None:
        self._test_run = test_run
        self._preamble = test_run_preamble
        self._arguments = parse_launch_arguments(launch_file_arguments)
        self._launch_service = LaunchService(debug=debug)
        self._processes_launched = threading.Event()
        self._tests_completed = threading.Event()
        self._results: TestResult | None = None

    def run(self) -> TestResult:
        """Launch, test, shut down, test again; returns all results. Raises _LaunchDiedException, and SkipTest of unittest."""
        description, context = self._test_run.normalized_test_description(ready_fn=self._processes_launched.set)
        proc_info, proc_output = ActiveProcInfoHandler(), ActiveIoHandler()
        self._bind(
            self._test_run.pre_shutdown_tests,
            context,
            launch_service=self._launch_service,
            proc_info=proc_info,
            proc_output=proc_output,
        )
        # Nothing is recorded any more when these run, so they get the plain handlers.
        self._bind(
            self._test_run.post_shutdown_tests,
            context,
            proc_info=proc_info._proc_info_handler,
            proc_output=proc_output._io_handler,
        )
        self._launch_service.include_launch_description(
            LaunchDescription([*self._preamble, *_recording(proc_info, proc_output), self._included(description)])
        )
        threading.Thread(target=self._run_test, name="test_runner_thread", daemon=True).start()
        self._launch_service.run(shutdown_when_idle=not self._test_run.markers.get("keep_alive", False))
        if not self._tests_completed.is_set() or self._results is None:
            print("Processes under test stopped before tests completed")
            _print_failed_processes(proc_info, proc_output)
            raise _LaunchDiedException
        self._results.append(_results_of(self._test_run.post_shutdown_tests))
        return self._results

    def _bind(self, tests: Any, context: Mapping[str, Any], **ours: Any) -> None:
        ours["test_args"] = dict(self._arguments)
        self._test_run.bind(tests, ours, {**context, **self._test_run.param_args, **ours})

    def _included(self, description: LaunchDescription) -> IncludeLaunchDescription:
        return IncludeLaunchDescription(LaunchDescriptionSource(description), launch_arguments=self._arguments)

    def _run_test(self) -> None:
        if not self._processes_launched.wait(self._test_run.timeout):
            print("Timed out waiting for processes to start up")
            self._launch_service.shutdown()
            return
        try:
            self._results = _results_of(self._test_run.pre_shutdown_tests)
        finally:
            self._tests_completed.set()
            self._launch_service.shutdown()


class LaunchTestRunner:
    """Runs test runs; each is launched with the arguments `name:=value`, `debug` makes the launch tell more."""

    def __init__(
        self, test_runs: Sequence[TestRun], launch_file_arguments: Iterable[str] = (), debug: bool = False
    ) -> None:
        self._test_runs = test_runs
        self._launch_file_arguments = list(launch_file_arguments)
        self._debug = debug

    def generate_preamble(self) -> Sequence[LaunchDescriptionEntity]:
        """Return what each launch begins with."""
        return []

    def run(self) -> dict[TestRun, Any]:
        """Run all; returns the result of each. A launch that dies ends the rest: mostly it was Ctrl-C."""
        results: dict[TestRun, Any] = {}
        for run in self._test_runs:
            if len(self._test_runs) > 1:
                print(f"\nStarting test run {run}")
            worker = _RunnerWorker(run, self.generate_preamble(), self._launch_file_arguments, self._debug)
            try:
                results[run] = worker.run()
            except unittest.SkipTest as skipped:
                print(f"{run} is skipped: {skipped}")
                results[run] = SkipResult(run, str(skipped))
            except _LaunchDiedException:
                results[run] = FailResult(run, "Launch stopped before the active tests finished.")
                break
        return results

    def validate(self) -> None:
        """Raise Exception for a `generate_test_description` whose arguments are not those that `parametrize` gives it."""
        for run in self._test_runs:
            specification = inspect.getfullargspec(inspect.unwrap(run._test_description_function))
            names = [*specification.args, *specification.kwonlyargs]
            for name in run.param_args:
                if name not in names:
                    raise Exception(
                        f"Could not find an argument in generate_test_description matching prametrized argument '{name}'"
                    )
            for name in names:
                if name not in run.param_args:
                    raise Exception(f"generate_test_description has unexpected extra argument '{name}'")


def _recording(proc_info: ActiveProcInfoHandler, proc_output: ActiveIoHandler) -> list[RegisterEventHandler]:
    """Return the actions that record what the processes do."""
    return [
        RegisterEventHandler(handler)
        for handler in (
            OnProcessStart(on_start=lambda event, context: proc_info.append(event)),
            OnProcessStart(on_start=lambda event, context: proc_output.track(event.process_name)),
            OnProcessExit(on_exit=lambda event, context: proc_info.append(event)),
            OnProcessIO(on_stdout=proc_output.append, on_stderr=proc_output.append),
        )
    ]


def _results_of(tests: Any) -> TestResult:
    results: Any = unittest.TextTestRunner(verbosity=2, resultclass=TestResult).run(tests)
    return results  # type: ignore[no-any-return]


def _print_failed_processes(proc_info: ActiveProcInfoHandler, proc_output: ActiveIoHandler) -> None:
    for event in proc_info:
        if not getattr(event, "returncode", 0):
            continue
        name = event.process_name
        print(f"Process '{name}' exited with {event.returncode}")
        print(f"##### '{name}' output #####")
        for io in proc_output[name]:
            print(io.text.decode(errors="replace"))
        print("#" * (len(name) + 21))
