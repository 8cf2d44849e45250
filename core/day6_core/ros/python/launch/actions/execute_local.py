"""Runs an executable: its start, output, end, and shutdown."""

from __future__ import annotations

import os
import signal
import traceback
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from launch._escalation import escalation
from launch._output_lines import OutputLines
from launch._programs import BuiltIn, resolve
from launch._subprocess import LocalProcess
from launch.action import Action
from launch.actions.emit_event import EmitEvent
from launch.actions.opaque_function import OpaqueFunction
from launch.actions.timer_action import TimerAction
from launch.conditions import evaluate_condition_expression
from launch.event_handler import BaseEventHandler, EventHandler
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from launch.events import Shutdown, matches_action
from launch.events.process import (
    ProcessExited,
    ProcessIO,
    ProcessStarted,
    ProcessStderr,
    ProcessStdout,
    ShutdownProcess,
    SignalProcess,
)
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_entities_type import SomeEntitiesType
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions.launch_configuration import LaunchConfiguration
from launch.utilities import is_a_subclass, normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution

if TYPE_CHECKING:
    from launch._loop import Future, Timer
    from launch.descriptions.executable import Executable
    from launch.launch_context import LaunchContext


class ExecuteLocal(Action):
    """Runs `process_description`.

        - `shell`: the command is one line for the shell. `emulate_tty`: its output is a pty (not on Windows).
    - `output`: see `launch.logging.get_output_loggers`; `output_format` has `{line}` and `{this}`.
    - `sigterm_timeout`, `sigkill_timeout`: seconds between SIGINT and SIGTERM, and from there to SIGKILL.
    - `cached_output`: keep the output for `get_stdout()` and `get_stderr()`. `log_cmd`: log the command line too.
        - `on_exit`: the entities to visit at its end. `respawn`: start it again then, after `respawn_delay` seconds, at most
      `respawn_max_retries` times (negative: always).
    """

    def __init__(
        self,
        *,
        process_description: Executable,
        shell: bool = False,
        sigterm_timeout: SomeSubstitutionsType | None = None,
        sigkill_timeout: SomeSubstitutionsType | None = None,
        emulate_tty: bool = False,
        output: SomeSubstitutionsType | Mapping[str, Any] = "log",
        output_format: str = "[{this.process_description.final_name}] {line}",
        cached_output: bool = False,
        log_cmd: bool = False,
        on_exit: SomeEntitiesType | Callable[..., SomeEntitiesType | None] | None = None,
        respawn: bool | SomeSubstitutionsType = False,
        respawn_delay: float | None = None,
        respawn_max_retries: int = -1,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__process_description = process_description
        self.__shell = shell
        self.__sigterm_timeout = normalize_to_list_of_substitutions(
            LaunchConfiguration("sigterm_timeout", default="5") if sigterm_timeout is None else sigterm_timeout
        )
        self.__sigkill_timeout = normalize_to_list_of_substitutions(
            LaunchConfiguration("sigkill_timeout", default="5") if sigkill_timeout is None else sigkill_timeout
        )
        self.__emulate_tty = emulate_tty
        wanted: Any = os.environ.get("OVERRIDE_LAUNCH_PROCESS_OUTPUT", output)
        self.__output: Any = wanted if isinstance(wanted, Mapping) else normalize_to_list_of_substitutions(wanted)
        self.__output_format = output_format
        self.__log_cmd = log_cmd
        self.__on_exit = on_exit
        self.__respawn: Any = normalize_typed_substitution(respawn, bool)
        self.__respawn_delay = respawn_delay
        self.__respawn_max_retries = respawn_max_retries
        self.__respawns = 0
        self.__cached_output = cached_output
        self.__streams = {number: OutputLines(cached_output) for number in (1, 2)}
        self.__details: dict[str, Any] | None = None
        self.__process: Any = None
        self.__started = False
        self.__returncode: int | None = None
        self.__completed: Future | None = None
        self.__stopping: Future | None = None
        self.__timers: list[TimerAction] = []
        self.__executed = False

    # -- properties ----------------------------------------------------------------------------------------------------

    @property
    def process_description(self) -> Executable:
        return self.__process_description

    @property
    def shell(self) -> bool:
        return self.__shell

    @property
    def emulate_tty(self) -> bool:
        return self.__emulate_tty

    @property
    def sigterm_timeout(self) -> Any:
        return self.__sigterm_timeout

    @property
    def sigkill_timeout(self) -> Any:
        return self.__sigkill_timeout

    @property
    def output(self) -> Any:
        return self.__output

    @property
    def process_details(self) -> Any:
        """`name`, `cmd`, `cwd`, `env`, and, once it runs, `pid`; None before it is executed."""
        return self.__details

    @property
    def return_code(self) -> int | None:
        """The exit code, None until it has ended."""
        return self.__returncode

    def get_stdout(self) -> str:
        """Return its standard output so far. Raises RuntimeError without `cached_output`."""
        return self.__cached(1)

    def get_stderr(self) -> str:
        return self.__cached(2)

    def __cached(self, fd: int) -> str:
        if not self.__cached_output:
            raise RuntimeError(
                f"cached output must be true to be able to get it, proc '{self.__process_description.name}'"
            )
        return self.__streams[fd].text

    def get_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        return self.__on_exit if isinstance(self.__on_exit, list) else []

    def get_asyncio_future(self) -> Future | None:
        return self.__completed

    # -- starting ------------------------------------------------------------------------------------------------------

    def prepare(self, context: LaunchContext) -> None:
        """Perform the substitutions of the description."""
        description = self.__process_description
        description.prepare(context, self)
        self.__details = {
            "action": self,
            "name": description.final_name,
            "cmd": description.final_cmd,
            "cwd": description.final_cwd,
            "env": description.final_env,
        }
        self.__respawn = perform_typed_substitution(context, self.__respawn, bool)

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        self.prepare(context)
        name = self.__process_description.final_name
        if self.__executed:
            raise RuntimeError(f"ExecuteLocal action '{name}': executed more than once: {self.describe()}")
        self.__executed = True
        if context.is_shutdown:
            return None
        output = self.__output
        if not isinstance(output, Mapping):
            output = perform_substitutions(context, output)
        self.__logger = launch.logging.get_logger(name)
        out, err = launch.logging.get_output_loggers(str(name), output)
        self.__output_loggers = {1: out, 2: err}
        for handler in self.__handlers():
            context.register_event_handler(handler)
        self.__completed = context.asyncio_loop.create_future()
        self.__stopping = context.asyncio_loop.create_future()
        context.asyncio_loop.call_soon(self.__start, context)
        return None

    def __handlers(self) -> list[BaseEventHandler]:
        def on_exit(event: ProcessExited, context: LaunchContext) -> SomeEntitiesType | None:
            return self.__on_exit(event, context) if callable(self.__on_exit) else self.__on_exit

        return [
            EventHandler(
                matcher=lambda event: is_a_subclass(event, ShutdownProcess),
                entities=OpaqueFunction(function=self.__on_shutdown_process),
            ),
            EventHandler(
                matcher=lambda event: is_a_subclass(event, SignalProcess),
                entities=OpaqueFunction(function=self.__on_signal_process),
            ),
            OnProcessIO(target_action=self, on_stdout=self.__on_output, on_stderr=self.__on_output),
            OnShutdown(on_shutdown=self.__on_shutdown),
            OnProcessExit(target_action=self, on_exit=on_exit),
            OnProcessExit(target_action=self, on_exit=self.__flush),
        ]

    def __start(self, context: LaunchContext) -> None:
        details = self.__details
        assert details is not None
        self.__started = False
        if context._is_broken:
            self.__clean_up()
            return
        if self.__log_cmd:
            has_env = details["env"] is not None
            line = _line(details["cmd"])
            self.__logger.info(f"process details: cmd='{line}', cwd='{details['cwd']}', custom_env?={has_env}")
        try:
            self.__process = self.__start_process(context, details)
        except (OSError, ValueError) as error:
            self.__failed("".join(traceback.format_exception_only(type(error), error)))
            return
        if not self.__process.hosted:
            self.__has_started(context)
            self.__process.watch()

    def __start_process(self, context: LaunchContext, details: dict[str, Any]) -> Any:
        call = context.asyncio_loop.call_soon_threadsafe

        def on_output(fd: int, data: bytes) -> None:
            call(self.__has_written, context, fd, data)

        def on_ended(code: int) -> None:
            call(self.__has_ended, context, code)

        owner = context._host
        terminals = owner.terminals if owner is not None else ()
        plan = resolve(details["cmd"], self.__shell, hosted=owner is not None, terminals=terminals)
        if isinstance(plan, BuiltIn) and owner is not None:
            return owner.start(
                plan.kind,
                plan.argv,
                cwd=details["cwd"],
                env=details["env"],
                on_started=lambda: call(self.__has_started, context),
                on_output=on_output,
                on_ended=on_ended,
                on_failed=lambda reason: call(self.__failed, reason),
            )
        assert not isinstance(plan, BuiltIn)
        return LocalProcess(
            plan.args,
            shell=plan.shell,
            cwd=details["cwd"],
            env=details["env"],
            emulate_tty=self.__wants_tty(context),
            on_output=on_output,
            on_ended=on_ended,
        )

    def __wants_tty(self, context: LaunchContext) -> bool:
        given = context.launch_configurations.get("emulate_tty")
        if given is None:
            return self.__emulate_tty
        return evaluate_condition_expression(context, normalize_to_list_of_substitutions(given))

    def __failed(self, reason: str) -> None:
        self.__logger.error(f"exception occurred while executing process:\n{reason}")
        self.__clean_up()

    # -- events of the process -----------------------------------------------------------------------------------------

    def __has_started(self, context: LaunchContext) -> None:
        assert self.__details is not None
        self.__details["pid"] = self.__process.pid
        self.__started = True
        self.__logger.info(f"process started with pid [{self.__process.pid}]")
        context._emit_event(ProcessStarted(**self.__details))

    def __has_written(self, context: LaunchContext, fd: int, data: bytes) -> None:
        assert self.__details is not None
        kind = ProcessStdout if fd == 1 else ProcessStderr
        context.emit_event_sync(kind(text=data, **{"pid": 0, **self.__details}))

    def __has_ended(self, context: LaunchContext, code: int) -> None:
        details = self.__details
        assert details is not None
        self.__started = False
        self.__returncode = code
        pid = details.get("pid", 0)
        if code == 0:
            self.__logger.info(f"process has finished cleanly [pid {pid}]")
        else:
            line = _line(details["cmd"])
            self.__logger.error(f"process has died [pid {pid}, exit code {code}, cmd '{line}'].")
        context._emit_event(ProcessExited(returncode=code, **details))
        if not self.__starts_again(context):
            self.__clean_up()

    def __starts_again(self, context: LaunchContext) -> bool:
        stopping = self.__stopping
        if not self.__respawn or context.is_shutdown or stopping is None or stopping.done():
            return False
        if 0 <= self.__respawn_max_retries <= self.__respawns:
            return False
        self.__respawns += 1
        timer: Timer = context.asyncio_loop.call_later(self.__respawn_delay or 0.0, self.__start, context)

        def give_up(_: Future) -> None:
            if not self.__started and self.__completed is not None and not self.__completed.done():
                timer.cancel()
                self.__clean_up()

        stopping.add_done_callback(give_up)
        return True

    def __clean_up(self) -> None:
        for timer in self.__timers:
            timer.cancel()
        if self.__completed is not None and not self.__completed.done():
            self.__completed.set_result(None)

    def __on_output(self, event: ProcessIO) -> None:
        fd = 1 if event.from_stdout else 2
        for line in self.__streams[fd].feed(event.text):
            self.__log_line(fd, line)

    def __flush(self, event: ProcessExited, context: LaunchContext) -> None:
        for fd, stream in self.__streams.items():
            rest = stream.rest()
            if rest:
                self.__log_line(fd, rest)

    def __log_line(self, fd: int, line: str) -> None:
        self.__output_loggers[fd].info(self.__output_format.format(line=line, this=self))

    # -- ending it -----------------------------------------------------------------------------------------------------

    def __on_shutdown(self, event: Shutdown, context: LaunchContext) -> SomeEntitiesType | None:
        return self._shutdown_process(context, send_sigint=not event.due_to_sigint or context.noninteractive)

    def __on_shutdown_process(self, context: LaunchContext) -> SomeEntitiesType | None:
        if not context.locals.event.process_matcher(self):
            return None
        return self._shutdown_process(context, send_sigint=True)

    def _shutdown_process(self, context: LaunchContext, *, send_sigint: bool) -> SomeEntitiesType | None:
        stopping, completed = self.__stopping, self.__completed
        if stopping is None or completed is None or stopping.done():
            return None
        if completed.done() or (self.__returncode is not None and not self.__started):
            stopping.set_result(None)
            return None
        if not self.__started:
            # It is still starting; shut it down once it runs.
            context.register_event_handler(
                OnProcessStart(
                    target_action=self,
                    on_start=lambda event, context: self._shutdown_process(context, send_sigint=send_sigint),
                    handle_once=True,
                )
            )
            return None
        stopping.set_result(None)
        if not send_sigint and self.__process.hosted:
            # The Ctrl-C that ends this launch reached its own processes, but not the programs that the host runs for it.
            self.__process.send_signal(signal.SIGINT)
        assert self.__details is not None
        self.__timers = escalation(
            self,
            self.__details["name"],
            perform_substitutions(context, self.__sigterm_timeout),
            perform_substitutions(context, self.__sigkill_timeout),
            self.__logger.error,
        )
        interrupt = EmitEvent(event=SignalProcess(signal_number=signal.SIGINT, process_matcher=matches_action(self)))
        return [*self.__timers, interrupt] if send_sigint else [*self.__timers]

    def __on_signal_process(self, context: LaunchContext) -> None:
        event: SignalProcess = context.locals.event
        if not event.process_matcher(self):
            return
        if self.__details is None:
            raise RuntimeError("Signal event received before execution.")
        if self.__process is None:
            raise RuntimeError("Signal event received before subprocess transport available.")
        name = self.__details["name"]
        if not self.__started:
            self.__logger.debug(f"signal '{event.signal_name}' not set to '{name}' because it is already closing")
            return
        number: Any = event.signal
        if os.name == "nt" and event.signal_name == "SIGINT" and not self.__process.hosted:
            self.__logger.warning(f"'SIGINT' sent to process[{name}] not supported on Windows, escalating to 'SIGTERM'")
            number = signal.SIGTERM
        text = number if isinstance(number, str) else number.name
        self.__logger.info(f"sending signal '{text}' to process[{name}]")
        try:
            if text == "SIGKILL":
                self.__process.kill()
            else:
                self.__process.send_signal(number if not isinstance(number, str) else getattr(signal, number))
        except ProcessLookupError:
            self.__logger.debug(f"signal '{text}' not sent to '{name}' because it has closed already")


def _line(cmd: Sequence[str]) -> str:
    return " ".join(part for part in cmd if part.strip())
