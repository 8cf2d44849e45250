"""A simulated machine for the recorded cases: a graph, the stand-in nodes on it, and `ros2` run in sessions.

World time is stepped, so that a recording of minutes plays in seconds. Only a stand-in that sleeps in a callback needs the
wall clock; it gets a thread of its own.
"""

from __future__ import annotations

import builtins
import itertools
import os
import subprocess
import threading
import time
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any

from day6_core.graph import Graph
from day6_core.ros import environment, ros2
from day6_core.ros.programs import load
from day6_core.ros.ros2.cli import daemon
from day6_core.session import watch
from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured, TextInput
from tests.conformance.golden_cases import STEPS_BEFORE, Case, differences
from tests.support.waiting import Deadline, until

DOMAIN = 30
PREFIXES = [str(environment.SHARE_PATH.parent)]
SLEEPING = frozenset({"fibonacci_server", "turtlesim_node"})
"""Stand-ins that sleep in their callbacks."""

PROCESSES = frozenset({"launch"})
"""Verbs of `ros2` that start processes, which live by the wall clock."""

LONGEST = 20.0
"""Seconds after which a command that should have ended is given up."""


def is_stepped(case: Case) -> bool:
    """Whether the case is played in stepped time, within this process."""
    return not SLEEPING & set(case.nodes) and not starts_processes(case)


def starts_processes(case: Case) -> bool:
    return bool(PROCESSES & set(case.argv[1:2]))


class Machine:
    """Plays cases. `nodes_folder` has the stand-in nodes, `files` is the working directory of the commands."""

    def __init__(self, nodes_folder: Path, files: Path) -> None:
        self.nodes_folder = nodes_folder
        self.files = files
        self._world: World | None = None

    def play(self, case: Case) -> str:
        """Play a case with its setup and return how the answer differs from the recording, '' if it does not."""
        world = self._world
        block = case.nodes, case.daemon, starts_processes(case)
        if world is None or world.block != block:
            # Only where a block of cases begins: those of a block build on each other, as they did when recorded.
            self.close()
            world = self._world = World(self, block, stepped=is_stepped(case))
        for argv in STEPS_BEFORE.get(case.name, ()):
            world.run(argv)
        return differences(case, *world.run(case.argv, case.stdin, case.interrupt_after), PREFIXES)

    def close(self) -> None:
        if self._world is not None:
            self._world.close()
            self._world = None


class World:
    """One graph with its stand-ins, in stepped time or (with a sleeping stand-in) by the wall."""

    def __init__(self, machine: Machine, block: tuple[tuple[str, ...], bool, bool], *, stepped: bool) -> None:
        self.machine = machine
        self.block = block
        """Its nodes, whether a daemon runs, whether commands start processes."""
        self.stepped = stepped
        nodes, with_daemon, self.with_processes = block
        self.graph = Graph(DOMAIN)
        self.scheduler = Scheduler(WorldClock(wall=None) if self.stepped else WorldClock())
        self._pids = itertools.count(4000)
        self._contexts: list[Any] = []
        if not self.stepped:
            self.scheduler.start()
        for name in nodes:
            if name.startswith("ros2 run "):
                self._start_program(*name.split()[2:4])
                continue
            code = compile((machine.nodes_folder / f"{name}.py").read_text(encoding="utf-8"), f"{name}.py", "exec")
            (self._start_stepped if self.stepped else self._start_thread)(name, code)
        if with_daemon:
            daemon.start(self.session(["ros2"]))

    def close(self) -> None:
        daemon.stop(self.session(["ros2"]))
        for context in self._contexts:
            context.try_shutdown()
        self.scheduler.stop()

    # -- stand-in nodes ------------------------------------------------------------------------------------------------

    def _start_program(self, package: str, executable: str) -> None:
        Program(self.session([executable]), load(package, executable))
        self.scheduler.advance()

    def _start_stepped(self, name: str, code: types.CodeType) -> None:
        session = self.session([name])
        nodes: list[Any] = []

        def spin(node: Any, executor: Any = None) -> None:
            nodes.extend(executor.get_nodes() if node is None else [node])
            raise _Spinning

        async def main(session: Session) -> None:
            try:
                run_as_process(code, session.context, spin)
            except _Spinning:
                await session.spin(*nodes)

        Program(session, main)
        self._contexts.append(session.context)
        self.scheduler.advance()

    def _start_thread(self, name: str, code: types.CodeType) -> None:
        from rclpy._day6.time_base import MACHINE_TIME
        from rclpy.context import Context
        from rclpy.executors import SingleThreadedExecutor

        context = Context._for_session(self.graph, MACHINE_TIME)
        context._log_write = lambda text: None
        self._contexts.append(context)

        spins = threading.Event()

        def spin(node: Any, executor: Any = None) -> None:
            spins.set()
            runner = executor if executor is not None else SingleThreadedExecutor(context=context)
            runner.add_node(node)
            while context.ok():
                runner.spin_once()

        threading.Thread(target=run_as_process, args=(code, context, spin), name=name, daemon=True).start()
        until(spins.is_set, told=lambda: name)

    # -- commands ------------------------------------------------------------------------------------------------------

    def session(self, argv: list[str], stdin: str = "") -> Session:
        session = Session(
            self.scheduler,
            self.graph,
            argv,
            env={"COLUMNS": "80"},
            cwd=self.machine.files,
            pid=next(self._pids),
            stdin=TextInput(stdin),
            stdout=Captured(),
            stderr=Captured(),
        )
        if self.with_processes:
            from day6_core.shell.process.process import run_python

            session.python = run_python
            session.env.update({name: os.environ[name] for name in ("PATH", "DAY6_RUNTIME_DIR") if name in os.environ})
            session.env.update(HOME=str(self.machine.files), ROS_DOMAIN_ID=str(DOMAIN))
        session.host = _Shell()  # a machine that goes on after the command: one with a daemon
        return session

    def run(self, argv: list[str], stdin: str = "", interrupt_after: float | None = None) -> tuple[str, str, int]:
        """Run a command, interrupt it after some seconds if asked, and return stdout, stderr and exit status."""
        session = self.session(argv, stdin)
        program = Program(session, ros2.main)

        def has_ended() -> bool:
            return program.status is not None

        if self.with_processes and interrupt_after is not None:  # the process may start late, and has to say something
            until(lambda: has_ended() or "Publishing: " in session.stdout.text, told=lambda: session.stdout.text)
            ended = has_ended()
        else:
            ended = self._pass(has_ended, interrupt_after or LONGEST, by_wall=bool(interrupt_after))
        if not ended:
            session.interrupt()
            self._pass(has_ended, 5.0 if self.stepped else LONGEST)
        status = program.status
        if status is None:
            program.kill()
            status = -9
        elif not ended and interrupt_after is None:
            status = -1
        return session.stdout.text, session.stderr.text, status

    def _pass(self, condition: Callable[[], bool], seconds: float, *, by_wall: bool = False) -> bool:
        """Let time pass until the condition holds, at most so many seconds; of the wall where stand-ins sleep by it meanwhile."""
        if self.stepped:
            self.scheduler.advance()
            for _ in range(int(seconds / 0.02)):
                if condition():
                    return True
                _let_work_be_done()
                self.scheduler.advance(0.02)
        else:
            deadline, end = Deadline(seconds), time.monotonic() + seconds
            while not condition() and not (time.monotonic() > end if by_wall else deadline.is_over()):
                time.sleep(0.002)
        return condition()


def _let_work_be_done() -> None:
    """Wait for what commands do in threads (`day6_core/session/threads.py`): the clock of the test does not wait for it."""
    for thread in threading.enumerate():
        if thread.name == "day6-work":
            thread.join(LONGEST)


class _Shell:
    """The shell that commands see; `ros2 run --prefix` has it run a line."""

    starts_programs = False

    def becomes(self, session: Session, before: list[str]) -> None:
        """Nobody keeps what is run."""

    async def run_line(self, line: str, session: Session) -> int:
        watch.end()  # it is the real shell, and there is nobody else to keep waiting
        try:
            done = subprocess.run(line, shell=True, capture_output=True, text=True, timeout=LONGEST)
        finally:
            watch.begin()
        session.stdout.write(done.stdout)
        session.stderr.write(done.stderr)
        return done.returncode


class _Spinning(BaseException):
    """Leaves a stand-in's file where it would spin for ever."""


def run_as_process(code: types.CodeType, context: Any, spin: Callable[..., None]) -> None:
    """Run a stand-in's file as if in a process of its own: its default context is `context`, `spin` is what it spins by."""
    import rclpy
    from rclpy import executors, node

    def by_default(cls: type) -> type:
        def init(self: Any, *args: Any, **keywords: Any) -> None:
            cls.__init__(self, *args, **{"context": context, **keywords})

        return type(cls.__name__, (cls,), {"__init__": init})

    def copy_of(module: Any, **changes: Any) -> Any:
        private = types.ModuleType(module.__name__)
        private.__dict__.update(vars(module), **changes)
        return private

    single, multi = map(by_default, (executors.SingleThreadedExecutor, executors.MultiThreadedExecutor))
    single.spin = lambda self: spin(None, self)  # type: ignore[attr-defined]
    own_executors = copy_of(executors, SingleThreadedExecutor=single, MultiThreadedExecutor=multi)
    own_node = copy_of(node, Node=by_default(node.Node))
    own = {
        "rclpy": copy_of(rclpy, init=lambda: None, spin=spin, executors=own_executors, node=own_node),
        "rclpy.executors": own_executors,
        "rclpy.node": own_node,
    }

    def import_(module: str, globals_: Any = None, locals_: Any = None, names: Any = (), level: int = 0) -> Any:
        if not names and module.startswith("rclpy."):
            return own["rclpy"]
        found = own.get(module)
        return found if found is not None else builtins.__import__(module, globals_, locals_, names, level)

    exec(code, {"__name__": "__main__", "__builtins__": {**vars(builtins), "__import__": import_}})
