"""The session of a cooperative program: its arguments, streams, clock, ROS context, windows, and ways to wait.

A program is `async def main(session: Session) -> int | None`. It runs on the scheduler's thread, never blocks, and touches
nothing process-wide. `day6_core.session.program.Program` starts one and derives its exit status.
"""

from __future__ import annotations

import contextlib
import logging
from collections.abc import Awaitable, Callable, Coroutine
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from day6_core.places import meant_in
from day6_core.session.clock import WorldClock, nanoseconds
from day6_core.session.display import Display, ProgramDisplay
from day6_core.session.folder import working_folder
from day6_core.session.scheduler import Scheduler
from day6_core.session.streams import InputStream, OutputStream, WriteError
from day6_core.session.task import Signal, Task, TaskCancelled, let_others_run, sleep_until, wait_for
from day6_core.session.write_errors import report_write_error

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph
    from day6_core.session.host import Host
    from day6_core.session.overview import Overview
    from rclpy.context import Context
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from rclpy.task import Future

AnyNode = TypeVar("AnyNode", bound="Node")

_log = logging.getLogger(__name__)


class KilledBySignal(BaseException):
    """Ends a program as if by the signal `number` (Linux numbers); raised by the program or thrown into it."""

    def __init__(self, number: int) -> None:
        super().__init__(f"signal {number}")
        self.number = number


class Terminated(KilledBySignal):
    """Thrown into a program that was sent SIGTERM."""

    def __init__(self) -> None:
        super().__init__(15)


STOPPED = (KeyboardInterrupt, Terminated)
"""What is raised in a program by the signals at which rclcpp and rclpy shut down: SIGINT and SIGTERM."""


class Crash(Exception):
    """An error that, where nothing in the program catches it, ends it as if by the signal `number`: a C++ exception.

    `report` is what the program's run-time library then prints.
    """

    def __init__(self, text: str, report: str, number: int) -> None:
        Exception.__init__(self, text)
        self.report = report
        self.number = number


class Session:
    """One running program's view of the machine. See the module's docstring; created by a terminal, `exec` or `local`."""

    def __init__(
        self,
        scheduler: Scheduler,
        graph: Graph | Callable[[], Graph] | None,
        argv: list[str],
        *,
        env: dict[str, str] | None = None,
        cwd: Path | None = None,
        pid: int = 0,
        stdin: InputStream | None = None,
        stdout: OutputStream | None = None,
        stderr: OutputStream | None = None,
        display: Display | None = None,
    ) -> None:
        self.scheduler = scheduler
        self.clock: WorldClock = scheduler.clock
        self._graph = graph
        self.argv = argv
        self.env: dict[str, str] = {} if env is None else env
        self.cwd: Path = working_folder() if cwd is None else cwd
        self.pid = pid
        self.stdin: InputStream = InputStream() if stdin is None else stdin
        self.stdout: OutputStream = OutputStream() if stdout is None else stdout
        self.stderr: OutputStream = OutputStream() if stderr is None else stderr
        self.display: Display | None = None if display is None else ProgramDisplay(display, self.interrupt, pid)
        self.background = False
        """Whether no shell waits for it: it was launched, or started with `&`, or without a terminal."""
        self.host: Host | None = None
        """The shell that started the program; None in `local`."""
        self.overview: Overview | None = None
        """The machine's terminals and windows, for programs that look at all of it; None in `local`."""
        self.python: Callable[[Session, list[str]], Awaitable[int]] | None = None
        """Runs `python3 ARGS` as a process with this session's streams and returns its status; see `run_python`."""
        self.on_write_error: Callable[[Session, OSError], int] = report_write_error
        """Reports that this program's output could not be written and returns its status; a shell has its own messages."""
        self.on_interrupt: Callable[[], bool] | None = None
        """Called first at Ctrl-C; True means that a command which this program runs was interrupted instead."""
        self.terminated = False
        """Whether SIGTERM has come."""
        self.stopping = False
        """Whether the program ends by itself because of a signal; another one then changes nothing."""
        self.on_stop: Callable[[bool], None] | None = None
        """Called with True when the program is stopped and with False when it is resumed, to pass that on to its processes."""
        self.on_own_stop: Callable[[int], None] | None = None
        """Called with the signal when one of its processes was stopped from elsewhere, and with 0 when it goes on."""
        self.task: Task | None = None
        """The task that runs `main`."""
        self.status: int | None = None
        """How it ended; known when what was deferred is called."""
        self._children: list[Task] = []
        self._deferred: list[Callable[[], object]] = []
        self._nodes: list[Node] = []
        self._context: Context | None = None
        self._executor: SingleThreadedExecutor | None = None
        self._ros_wake = Signal()
        self._closed = False
        self._stirs: Callable[[], None] | None = None
        """Ends what wakes a program that rests when the graph changes."""

    @property
    def graph(self) -> Graph | None:
        """The graph of the program's ROS domain; it may be joined to other processes only at its first use."""
        graph = self._graph
        if callable(graph):
            graph = self._graph = graph()
        return graph

    # -- ROS -----------------------------------------------------------------------------------------------------------

    @property
    def context(self) -> Context:
        """This program's own ROS context: on the machine's graph, with the machine's clock, logging to this session's stderr.

        Raises:
            RuntimeError: the session has no graph.
        """
        if self._context is None:
            from day6_core.session.log_output import LogOutput
            from rclpy._day6.log_file import LogFile
            from rclpy.context import Context

            graph = self.graph
            if graph is None:
                raise RuntimeError("this session has no graph")
            file = LogFile(Path(self.argv[0]).name if self.argv else "program", self.pid, self.env)
            self.defer(file.close)
            write = LogOutput(self).write
            self._context = Context._for_session(graph, self.clock, self.argv, self.env, write, file, str(self.cwd))
            self._context.on_shutdown(lambda: self._ros_wake.set())
        return self._context

    @property
    def executor(self) -> SingleThreadedExecutor:
        """The executor that `spin`, `spin_until` and `spin_some` use, on this program's context."""
        if self._executor is None:
            from rclpy.executors import SingleThreadedExecutor

            self._executor = SingleThreadedExecutor(context=self.context)
            self._executor._set_wake(self._ros_wake.set)
        return self._executor

    def create_node(self, name: str, **keywords: Any) -> Node:
        """Return `rclpy.node.Node(name, …)` in this program's context, which uses the ROS arguments of its command line."""
        from rclpy.node import Node

        return self.keep(Node(name, context=self.context, **keywords))

    def keep(self, node: AnyNode) -> AnyNode:
        """Destroy a node when the program ends, however it ends. Returns the node."""
        self._nodes.append(node)
        return node

    async def spin(self, *nodes: Node) -> None:
        """Run callbacks until the context is shut down; raises exceptions of callbacks, as `rclpy.spin` does."""
        executor = self.executor
        for node in nodes:
            executor.add_node(node)
        try:
            await self._spin_while(self.context.ok, None)
        finally:
            for node in nodes:
                executor.remove_node(node)

    async def spin_until(self, future: Future[Any], timeout: float | None = None) -> bool:
        """Run callbacks of the nodes in `executor` until `future.done()`; False if `timeout` world seconds pass first."""
        deadline = self._deadline(timeout)
        future.add_done_callback(lambda _: self._ros_wake.set())
        await self._spin_while(lambda: self.context.ok() and not future.done(), deadline)
        return bool(future.done())

    def spin_some(self) -> None:
        """Run everything that is ready now, once: at most one message per subscription, as `rclcpp::spin_some`."""
        self._ros_wake.clear()
        self.executor._run_ready()

    async def rest(self, ticks: Ticks, periods: int) -> range:
        """Let at most `periods` of `ticks` pass at once, for a program whom nobody waits for; return their times (steady ns).

        Fewer do as soon as something comes for the program's nodes, or the graph changes: somebody may listen now. `ticks` then
        goes on with the next one, at its time. Call it after `spin_some`.
        """
        if self._stirs is None and (graph := self.graph) is not None:
            self._stirs = graph.add_listener(lambda event: self._ros_wake.set())
            self.defer(self._stirs)
            return range(0)  # what has changed so far is known only to those who look again
        return await ticks.rest(periods, self._ros_wake, self.executor._next_deadline())

    async def _spin_while(self, condition: Callable[[], bool], until_ns: int | None) -> None:
        executor = self.executor
        wake = self._ros_wake
        while condition():
            wake.clear()
            if executor._run_ready():
                await let_others_run()
                continue
            if until_ns is not None and self.clock.steady_ns() >= until_ns:
                return
            if not condition():
                return
            deadline = executor._next_deadline()
            if until_ns is not None:
                deadline = until_ns if deadline is None else min(deadline, until_ns)
            await wait_for(wake, deadline)

    def timer_ns(self, node: Node) -> int:
        """The time (ns) by which the node's timers run: /clock where it uses simulated time, else the world's."""
        clock = node.get_clock()
        return int(clock.now().nanoseconds) if clock._is_simulated() else self.clock.steady_ns()

    # -- waiting -------------------------------------------------------------------------------------------------------

    async def sleep(self, seconds: float) -> None:
        """Wait `seconds` of world time."""
        await sleep_until(self.clock.steady_ns() + nanoseconds(seconds))

    async def wait(self, signal: Signal, timeout: float | None = None) -> bool:
        """Wait for `signal`, at most `timeout` world seconds; True if it is set."""
        return await wait_for(signal, self._deadline(timeout))

    async def until(self, holds: Callable[[], object], seconds: float, every: float = 0.05) -> bool:
        """Look again `every` so many world seconds until something holds; False if it does not within `seconds`."""
        waited = 0.0
        while not holds():
            if waited >= seconds:
                return False
            await self.sleep(every)
            waited += every
        return True

    def every(self, seconds: float) -> Ticks:
        """Return an async iterator that yields 1, 2, 3 … at exact multiples of `seconds` from now, skipping none."""
        return Ticks(self.clock, nanoseconds(seconds))

    def _deadline(self, timeout: float | None) -> int | None:
        return None if timeout is None else self.clock.steady_ns() + nanoseconds(timeout)

    # -- tasks and other programs --------------------------------------------------------------------------------------

    def spawn(self, coroutine: Coroutine[Any, Any, Any]) -> Task:
        """Start a child task, which ends with the program. An exception in it is raised in the program's main task."""
        task = self.scheduler.spawn(coroutine, f"{self.name} (child)")
        self._children.append(task)
        task.on_done = self._child_done
        return task

    def _child_done(self, task: Task) -> None:
        if task in self._children:
            self._children.remove(task)
        error = task.exception
        if error is not None and not isinstance(error, TaskCancelled) and self.task is not None and not self._closed:
            self.task.throw(error)

    async def execute(self, main: Callable[[Session], Awaitable[int | None]], argv: list[str]) -> int:
        """Go on as another program with the same process number, streams and environment. Returns its status."""
        before, self.argv = self.argv, argv
        if self.host is not None:
            self.host.becomes(self, before)
        return (await main(self)) or 0

    async def run_python(self, args: list[str]) -> int:
        """Go on as `python3 ARGS…` in a separate process on this session's streams. Returns its exit status.

        Raises:
            RuntimeError: this session cannot start processes.
        """
        if self.python is None:
            raise RuntimeError("no processes can be started from here")
        return await self.python(self, args)

    # -- output --------------------------------------------------------------------------------------------------------

    @property
    def name(self) -> str:
        """The program's name for its own messages: the last part of argv[0]."""
        return self.argv[0].rpartition("/")[2] if self.argv else "program"

    def path(self, name: str) -> Path:
        """The file that a user of the program means who writes this name: `~` is the home of the program's user."""
        return self.cwd / meant_in(self.env.get("HOME", "~"), name)

    def print(self, *values: object, sep: str = " ", end: str = "\n", flush: bool = False) -> None:
        """`print` to this program's standard output."""
        self.stdout.write(sep.join(map(str, values)) + end)
        if flush:
            self.stdout.flush()

    def print_error(self, *values: object, sep: str = " ", end: str = "\n") -> None:
        """`print(…, file=sys.stderr)`. A text that cannot be written is dropped."""
        with contextlib.suppress(WriteError):
            self.stderr.write(sep.join(map(str, values)) + end)

    # -- the end -------------------------------------------------------------------------------------------------------

    def defer(self, function: Callable[[], object]) -> None:
        """Call `function` when the program ends, however it ends; the last one registered is called first."""
        self._deferred.append(function)

    def interrupt(self) -> None:
        """Ctrl-C: KeyboardInterrupt is raised in the program where it waits."""
        if self.on_interrupt is not None and self.on_interrupt():
            return
        if self.task is not None:
            self.task.throw(KeyboardInterrupt())

    def terminate(self) -> None:
        """SIGTERM: `Terminated` is raised in the program where it waits; its `finally` blocks run."""
        self.terminated = True
        if self.task is not None:
            self.task.throw(Terminated())

    def stop(self) -> None:
        """SIGSTOP: none of the program's tasks takes another step until `resume`."""
        if self.on_stop is not None:
            self.on_stop(True)
        for task in self._all_tasks():
            task.hold()

    def resume(self) -> None:
        """SIGCONT: the program's tasks go on."""
        if self.on_stop is not None:
            self.on_stop(False)
        for task in self._all_tasks():
            task.release()

    def _all_tasks(self) -> list[Task]:
        return ([self.task] if self.task is not None else []) + self._children

    def close(self) -> None:
        """Release everything the program held. Called once by its runner, on the scheduler's thread."""
        if self._closed:
            return
        self._closed = True
        for task in list(self._children):
            task.cancel()
        steps: list[Callable[[], object]] = list(reversed(self._deferred))
        if isinstance(self.display, ProgramDisplay):
            steps.append(self.display.close)
        steps.extend(node.destroy_node for node in reversed(self._nodes))
        if self._executor is not None:
            steps.append(lambda: self._executor._set_wake(None) if self._executor else None)
        if self._context is not None:
            steps.append(self._context.try_shutdown)
        for step in steps:
            try:
                step()
            except Exception:
                # One failed clean-up must not keep the others from running.
                _log.exception("cleaning up after %s", self.name)


class Ticks:
    """Async iterator over whole periods of the world clock: 1, 2, 3 … at start + n × period."""

    def __init__(self, clock: WorldClock, period_ns: int) -> None:
        if period_ns <= 0:
            raise ValueError("a period must be positive")
        self._clock = clock
        self._next = clock.steady_ns()
        self._period = period_ns
        self._count = 0

    def __aiter__(self) -> Ticks:
        return self

    async def __anext__(self) -> int:
        self._next += self._period
        self._count += 1
        await sleep_until(self._next)
        return self._count

    async def rest(self, periods: int, wake: Signal, until_ns: int | None = None) -> range:
        """Wait until the tick after `periods` more ones, or `wake` is set, or `until_ns`; return the times of those passed."""
        end = self._next + (periods + 1) * self._period
        await wait_for(wake, end if until_ns is None else min(end, until_ns))
        passed = max(0, min(periods, (self._clock.steady_ns() - self._next) // self._period))
        first = self._next + self._period
        self._next += passed * self._period
        self._count += passed
        return range(first, self._next + 1, self._period)


Main = Callable[[Session], Coroutine[Any, Any, "int | None"]]
"""A program: the `main` of a module under day6_core/ros/programs, of a `ros2` verb or of a shell built-in."""
