"""A simulated machine for the recorded cases: one graph, the stand-in nodes on it, and `ros2` run in sessions."""

from __future__ import annotations

import itertools
import os
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from golden_cases import STEPS_BEFORE, Case, differences

from day6_tui.core.graph import Graph
from day6_tui.core.ros import environment, ros2
from day6_tui.core.ros.ros2.cli import daemon
from day6_tui.core.session.clock import WorldClock
from day6_tui.core.session.program import Program
from day6_tui.core.session.scheduler import Scheduler
from day6_tui.core.session.session import Session
from day6_tui.core.session.streams import Captured, TextInput

DOMAIN = 30
_pids = itertools.count(4000)


class Machine:
    """Runs commands on one graph by the real clock. `nodes_folder` has the stand-in nodes, `files` is the working directory."""

    def __init__(self, nodes_folder: Path, files: Path) -> None:
        os.environ["ROS_DOMAIN_ID"] = str(DOMAIN)
        from day6_tui.core.graph import graph_for_domain

        self.graph: Graph = graph_for_domain(DOMAIN)
        self.scheduler = Scheduler(WorldClock())
        self.scheduler.start()
        self.nodes_folder = nodes_folder
        self.files = files
        self._with_daemon: bool | None = None
        self.prefixes = [str(environment.SHARE_PATH.parent)]
        self._threads: list[threading.Thread] = []
        self._contexts: list[Any] = []
        self.running: tuple[str, ...] = ()

    def close(self) -> None:
        self.stop_nodes()
        self.scheduler.stop()
        del os.environ["ROS_DOMAIN_ID"]

    # -- stand-in nodes ------------------------------------------------------------------------------------------------

    def set_up(self, nodes: tuple[str, ...], with_daemon: bool) -> None:
        """Let exactly these stand-in nodes run, and the daemon or not."""
        if nodes != self.running:
            self.stop_nodes()
            for name in nodes:
                self._start_node(name)
            self.running = nodes
            self._wait(lambda: self._settled(nodes))
            self._with_daemon = None
        if with_daemon != self._with_daemon:
            # Only where a block of cases begins: commands of the block may stop and start it themselves.
            self._with_daemon = with_daemon
            (daemon.start if with_daemon else daemon.stop)(self.session(["ros2"]))

    def _start_node(self, name: str) -> None:
        from rclpy._time_source import MACHINE_TIME
        from rclpy.context import Context

        context = Context._for_session(self.graph, MACHINE_TIME)
        context._log_write = lambda text: None
        code = compile((self.nodes_folder / f"{name}.py").read_text(encoding="utf-8"), f"{name}.py", "exec")
        thread = threading.Thread(target=_run_node, args=(code, context), name=name, daemon=True)
        thread.start()
        self._contexts.append(context)
        self._threads.append(thread)

    def stop_nodes(self) -> None:
        for context in self._contexts:
            context.try_shutdown()
        for thread in self._threads:
            thread.join(5)
        self._threads, self._contexts = [], []
        for node in list(self.graph.nodes):
            if not node.name.startswith(daemon.PREFIX):
                self.graph.remove_node(node)
        self.running = ()

    def _settled(self, nodes: tuple[str, ...]) -> bool:
        """Say whether every stand-in has made what it makes: nothing has come for a while."""
        before = self.graph.names_and_types(*_ALL_KINDS())
        time.sleep(0.15)
        return (
            bool(before) and self.graph.names_and_types(*_ALL_KINDS()) == before and len(self.graph.nodes) >= len(nodes)
        )

    @staticmethod
    def _wait(condition: Callable[[], bool], seconds: float = 10.0) -> None:
        deadline = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > deadline:
                raise TimeoutError("the stand-in nodes did not come up")

    # -- commands ------------------------------------------------------------------------------------------------------

    def session(self, argv: list[str], stdin: str = "") -> Session:
        session = Session(
            self.scheduler,
            self.graph,
            argv,
            env={"COLUMNS": "80"},
            cwd=self.files,
            pid=next(_pids),
            stdin=TextInput(stdin),
            stdout=Captured(),
            stderr=Captured(),
        )
        session.shell = object()  # a machine that goes on after the command: one with a daemon
        return session

    def play(self, case: Case) -> str:
        """Play a case with its setup and return how the answer differs from the recording, '' if it does not."""
        self.set_up(case.nodes, case.daemon)
        for argv in STEPS_BEFORE.get(case.name, ()):
            self.run(argv)
        return differences(case, *self.run(case.argv, case.stdin, case.interrupt_after), self.prefixes)

    def run(self, argv: list[str], stdin: str = "", interrupt_after: float | None = None) -> tuple[str, str, int]:
        """Run a command, interrupt it after some seconds if asked, and return stdout, stderr and exit status."""
        session = self.session(argv, stdin)
        program = Program(session, ros2.main)
        limit = time.monotonic() + (interrupt_after if interrupt_after is not None else 20.0)
        while program.status is None and time.monotonic() < limit:
            time.sleep(0.002)
        if program.status is None:
            session.interrupt()
            limit = time.monotonic() + 5.0
            while program.status is None and time.monotonic() < limit:
                time.sleep(0.002)
        status = program.status
        if status is None:
            program.kill()
            status = -9
        elif interrupt_after is None and time.monotonic() >= limit:
            status = -1
        return session.stdout.text, session.stderr.text, status


def _run_node(code: Any, context: Any) -> None:
    """Run a stand-in's file in this thread as in a process of its own: its default context is `context`."""
    import builtins
    import types

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

    def spin(one: Any, executor: Any = None) -> None:
        runner = executor if executor is not None else own_executors.SingleThreadedExecutor()
        runner.add_node(one)
        while context.ok():
            runner.spin_once()
        raise executors.ExternalShutdownException()

    kinds = ("SingleThreadedExecutor", "MultiThreadedExecutor")
    own_executors = copy_of(executors, **{kind: by_default(getattr(executors, kind)) for kind in kinds})
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


def _ALL_KINDS() -> tuple[Any, ...]:
    from day6_tui.core.graph.endpoints import EndpointKind

    return tuple(EndpointKind)
