"""The older way to test a launch: actions are added as fixtures and as tests, and the launch ends when the tests have."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from launch import LaunchDescription, LaunchService
from launch.action import Action
from launch.actions import EmitEvent, ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnShutdown
from launch.events import Shutdown

from launch_testing import actions
from launch_testing.legacy import output

__all__ = ["LaunchTestService", "actions", "output"]


class LaunchTestService:
    """Knows which tests of a launch are still running, and which have failed."""

    def __init__(self) -> None:
        self.__tests: dict[str, str] = {}
        """Test -> 'armed', 'finished', 'succeeded', 'failed' or 'dropped'."""
        self.__exit_codes: dict[str, int] = {}

    def add_fixture_action(
        self, launch_description: LaunchDescription, action: Action, exit_allowed: Any = (0,)
    ) -> Action:
        """Add an action that the tests need. A process that ends ends the launch as failed.

        `exit_allowed`: with which exit codes it may end, or True for any of them.
        """
        launch_description.add_action(action)

        def on_exit(event: Any, context: Any) -> EmitEvent | None:
            code = event.returncode
            allowed = exit_allowed if isinstance(exit_allowed, bool) else code in exit_allowed
            if context.is_shutdown or allowed:
                return None
            name = event.action.process_details["name"]
            self.__exit_codes[name] = code or 1
            return _shutdown(f"{name} fixture process died!")

        if isinstance(action, ExecuteProcess):
            launch_description.add_action(RegisterEventHandler(OnProcessExit(target_action=action, on_exit=on_exit)))
        return action

    def add_test_action(self, launch_description: LaunchDescription, action: Action) -> Action:
        """Add an action that is a test: a process has to end with 0, another action to complete without an exception."""
        name = f"test_{id(action)}"

        def on_exit(event: Any, context: Any) -> EmitEvent | None:
            if event.returncode == 0:
                return self.__succeed(name)
            process = event.action.process_details["name"]
            self.__exit_codes[process] = event.returncode
            return self.__fail(name, f"{process} test failed!")

        def on_completion(event: Any, context: Any) -> EmitEvent | None:
            future = event.action.get_asyncio_future()
            if future is not None and future.cancelled():
                self.__tests[name] = "dropped"
                return None
            error = None if future is None else future.exception()
            return self.__succeed(name) if error is None else self.__fail(name, str(error))

        handler = (
            OnProcessExit(target_action=action, on_exit=on_exit)
            if isinstance(action, ExecuteProcess)
            else OnExecutionComplete(target_action=action, on_completion=on_completion)
        )
        launch_description.add_action(RegisterEventHandler(handler))
        launch_description.add_action(action)
        self.__arm(name)
        return action

    def add_output_test(
        self,
        launch_description: LaunchDescription,
        action: ExecuteProcess,
        output_test: output.OutputTest,
        test_suffix: str = "output",
        output_filter: Callable[[bytes], bytes] | None = None,
        side_effect: str | None = None,
    ) -> ExecuteProcess:
        """Test the standard output of a process that is part of the launch, with a test of `legacy.output`.

        A process may have several tests, told apart by their suffix. The side effect 'shutdown' ends the launch when the test
        has succeeded.
        """
        assert isinstance(action, ExecuteProcess)
        name = f"test_{id(action)}_{test_suffix}"
        written, collate, matches, patterns = output_test
        missing = list(patterns)
        assert missing

        def on_stdout(event: Any) -> EmitEvent | None:
            nonlocal written
            written = collate(written, event.text if output_filter is None else output_filter(event.text))
            missing[:] = [pattern for pattern in missing if not matches(written, pattern)]
            return None if missing else self.__succeed(name, side_effect)

        def on_exit(event: Any, context: Any) -> EmitEvent | None:
            if not missing:
                return None
            self.__tests[name] = (
                "finished"  # whether it has failed is seen at the end: output may come after this event
            )
            return self.__shutdown_if_none_is_left()

        def on_shutdown(event: Any, context: Any) -> None:
            if missing:
                details = action.process_details
                self.__fail(name, f"not all {details and details['name']} output matched!")
            else:
                self.__succeed(name, side_effect)

        for handler in (
            OnProcessExit(target_action=action, on_exit=on_exit),
            OnShutdown(on_shutdown=on_shutdown),
            OnProcessIO(target_action=action, on_stdout=on_stdout),
        ):
            launch_description.add_action(RegisterEventHandler(handler))
        self.__arm(name)
        return action

    def run(self, launch_service: LaunchService, *args: Any, **kwargs: Any) -> int:
        """Run the launch; returns its status, or if that is 0 the exit code of the first process that failed, or 1."""
        status = launch_service.run(*args, **kwargs)
        if status != 0:
            return status
        failed = 1 if "failed" in self.__tests.values() else 0
        return next((code for code in self.__exit_codes.values() if code != 0), failed)

    def __arm(self, name: str) -> None:
        assert name not in self.__tests
        self.__tests[name] = "armed"

    def __succeed(self, name: str, side_effect: str | None = None) -> EmitEvent | None:
        self.__tests[name] = "succeeded"
        ends = self.__shutdown_if_none_is_left()
        return _shutdown("shutdown after test") if ends is None and side_effect == "shutdown" else ends

    def __fail(self, name: str, reason: str) -> EmitEvent:
        self.__tests[name] = "failed"
        self.__tests.update(dict.fromkeys(self.__armed(), "dropped"))
        return _shutdown(reason)

    def __shutdown_if_none_is_left(self) -> EmitEvent | None:
        return None if self.__armed() else _shutdown("all tests finished")

    def __armed(self) -> Iterable[str]:
        return [name for name, state in self.__tests.items() if state == "armed"]


def _shutdown(reason: str) -> EmitEvent:
    return EmitEvent(event=Shutdown(reason=reason))
