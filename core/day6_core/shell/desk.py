"""The whole simulated machine except its drawing: world clock, programs, graph, link, terminals, windows, home folder."""

from __future__ import annotations

import errno
import logging
import os
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from day6_core.graph.domain import DomainError, domain_from_text
from day6_core.graph.graph import Graph
from day6_core.link.engine import LOCAL, is_local
from day6_core.places import default_home
from day6_core.ros.environment import activate, program_environment
from day6_core.ros.home_python import BELOW_HOME, scripts_of
from day6_core.session import cores
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Main, Session
from day6_core.session.streams import InputStream, OutputStream
from day6_core.shell import login_variables
from day6_core.shell.language.interpreter import Shell
from day6_core.shell.language.redirection import Streams
from day6_core.shell.overview import DeskOverview
from day6_core.shell.runs import Runs
from day6_core.shell.user import login_name

if TYPE_CHECKING:
    from day6_core.link.classroom.part import ClassPart
    from day6_core.shell.terminal import Terminal

_log = logging.getLogger(__name__)


class Wanted(NamedTuple):
    """Another distribution of ROS 2, which a line has sourced that was typed in a terminal."""

    name: str
    terminal: Terminal
    source: str


FIRST_PID = 1001
MOST_CLOSED = 20
"""Closed terminals of which is known what was run in them."""
MOST_PROGRAMS = 1000
"""A runaway `while true; do … & done` ends with a message instead of the memory."""
HOST = "day6"
GRACE = 2.0
"""Seconds that a program has to end after Ctrl-C, and then SIGTERM, together; then comes SIGKILL."""


class Desk:
    """One simulated machine. `start()` runs it in a thread of its own; tests and `exec` drive `scheduler` themselves.

    `home` is created with a `ros2_ws/src` in it; OSError if it cannot be. `join_link` lets its graph meet the other processes of
    this user; that happens in the background, when `start` or `open_link` is called. `listen` and `connect` are Zenoh endpoints
    (`tcp/0.0.0.0:7447`), the only way to leave this machine; other machines must show `secret` there. `part` is the one in a
    class (see `day6_core.link.classroom`).
    """

    def __init__(
        self,
        home: Path | None = None,
        *,
        domain_id: int | None = None,
        join_link: bool = True,
        clock: WorldClock | None = None,
        display: bool = True,
        listen: str | None = None,
        connect: str | None = None,
        secret: str | None = None,
        part: ClassPart | None = None,
    ) -> None:
        activate()
        self._listen, self._connect, self._secret, self._part = listen, connect, secret, part
        self.home = (default_home() if home is None else home).expanduser().resolve()
        self.room: Path | None = None
        """Another home folder for new terminals, while a drill has one of its own."""
        self.closed_runs: deque[Runs] = deque(maxlen=MOST_CLOSED)
        """What was run in terminals that are closed."""
        self.searching: Callable[[], str] = lambda: ""
        """'drill' or 'exam' while the pupil is to find a fault himself: whatever names faults asks, and is quiet then."""
        self.may_change_distribution = False
        """Whether somebody looks at `wanted_distribution`."""
        self.wanted_distribution: Wanted | None = None
        self.user = login_name()
        (self.home / "ros2_ws" / "src").mkdir(parents=True, exist_ok=True)
        self.domain_id = _own_domain() if domain_id is None else domain_id
        self._domain_text = os.environ.get("ROS_DOMAIN_ID", "0") if domain_id is None else str(domain_id)
        self._link_opened = False
        self.clock = WorldClock() if clock is None else clock
        self.graphs: dict[int, Graph] = {}
        """By domain; more than one once a terminal exports another ROS_DOMAIN_ID."""
        self.graph = self.graph_of(self.domain_id)
        self.scheduler = Scheduler(self.clock)
        self.display: Display | None = Display() if display else None
        self.programs: dict[int, Program] = {}
        """Running programs by process id."""
        self.terminals: list[Terminal] = []
        self.overview = DeskOverview(self)
        self._join_link = join_link and os.environ.get("DAY6_LINK") != "off"
        self._joined: set[Graph] = set()
        self._on_demand = False
        self._background: list[threading.Thread] = []
        self._last_pid = FIRST_PID - 1
        self._changed = threading.Condition()
        self._started = False
        self.processes_stopped = False
        """Whether the students' processes stand still with the paused world."""
        self._closed = False
        self._hurried = False

    def graph_of(self, domain_id: int) -> Graph:
        """The graph of a domain, made and linked when it is first asked for."""
        graph = self.graphs.get(domain_id)
        if graph is None:
            graph = self.graphs[domain_id] = Graph(domain_id)
            graph.now_ns = self.clock.now_ns
            if self._link_opened:
                self._join_in_background(graph)
        return graph

    def _linked_graph_of(self, domain_id: int) -> Graph:
        """The graph of a domain, joined before it is used where `link_on_demand` was chosen."""
        graph = self.graph_of(domain_id)
        if self._on_demand and graph not in self._joined:
            self._join(graph)
        return graph

    # -- programs ------------------------------------------------------------------------------------------------------

    def new_pid(self) -> int:
        """The next process number of the simulated machine."""
        self._last_pid += 1
        return self._last_pid

    @property
    def login_home(self) -> Path:
        """The home folder of a new terminal."""
        return self.home if self.room is None else self.room

    def environment(self) -> dict[str, str]:
        """The variables of a fresh login."""
        kept = {"LANG": "C.UTF-8", **login_variables.passed_on(os.environ)}
        if is_local():  # also if a user installs Zenoh for his programs: they are to see this desktop
            kept.setdefault("DAY6_LINK", LOCAL)
        env = program_environment(kept)
        ours, *others = env["PATH"].split(os.pathsep)
        scripts = scripts_of(self.login_home / BELOW_HOME)
        env["PATH"] = os.pathsep.join(dict.fromkeys([ours, str(scripts), *others]))
        env.update(
            login_variables.of_user(self.user, self.login_home),
            SHELL="/bin/bash",
            TERM="xterm-256color",
            ROS_DOMAIN_ID=self._domain_text,
        )
        return env

    def shell(
        self, *, interactive: bool = False, cwd: Path | None = None, env: Mapping[str, str] | None = None
    ) -> Shell:
        """A new shell, as after login; with `env` as started by a program that has these variables."""
        env = self.environment() if env is None else dict(env)
        folder = self.login_home if cwd is None else cwd
        env["PWD"] = str(folder)
        return Shell(self, env=env, cwd=folder, interactive=interactive)

    def start_program(
        self,
        argv: list[str],
        main: Main,
        streams: Streams,
        *,
        env: dict[str, str],
        cwd: Path,
        shell: Shell | None = None,
        pid: int | None = None,
    ) -> Program:
        """Start a cooperative program; it is in `programs` until it has ended.

        Raises BlockingIOError, as `fork` does, when too many run already.
        """
        if len(self.programs) >= MOST_PROGRAMS:
            raise BlockingIOError(errno.EAGAIN, "Resource temporarily unavailable")
        from day6_core.shell.process.process import run_python

        if self.searching():
            env = {**env, "DAY6_HINTS": "off"}
        session = Session(
            self.scheduler,
            lambda: self._linked_graph_of(domain_of(env)),
            argv,
            env=env,
            cwd=cwd,
            pid=self.new_pid() if pid is None else pid,
            stdin=streams.stdin,
            stdout=streams.stdout,
            stderr=streams.stderr,
            display=self.display,
        )
        session.host = shell
        session.overview = self.overview
        session.python = run_python
        program = Program(session, main)
        self.programs[program.pid] = program

        def forget() -> None:
            self.programs.pop(program.pid, None)
            with self._changed:
                self._changed.notify_all()

        session.defer(forget)
        return program

    def start_unseen(self, name: str, main: Main) -> None:
        """Start a program without a terminal, on any thread, in the home folder: nothing to read, silent output."""

        def start() -> None:
            streams = Streams(InputStream(), OutputStream(), OutputStream())
            self.start_program([name], main, streams, env=self.environment(), cwd=self.home)

        self.scheduler.call_soon_threadsafe(start)

    def in_background(self, work: Callable[[], None], name: str) -> None:
        """Do something in a thread of this name; `close` waits for its end, `GRACE` seconds at most."""
        thread = threading.Thread(target=work, name=name, daemon=True)
        self._background = [*(each for each in self._background if each.is_alive()), thread]
        thread.start()

    # -- time ----------------------------------------------------------------------------------------------------------

    def pause(self) -> None:
        """Pause the world; students' processes are stopped too (where the system can)."""
        self.clock.pause()
        self._stop_processes(True)

    def resume(self) -> None:
        self._stop_processes(False)
        self.clock.resume()

    def step(self, seconds: float = 0.016) -> None:
        """Advance the paused world; processes stay stopped."""
        self.clock.step(seconds)

    def set_speed(self, factor: float) -> None:
        self.clock.set_speed(factor)

    def _stop_processes(self, stopped: bool) -> None:
        self.processes_stopped = stopped
        from day6_core.shell.process.process import running_processes

        for process in running_processes(self.scheduler):
            process.pause(stopped, "world")

    # -- terminals -----------------------------------------------------------------------------------------------------

    def open_terminal(
        self,
        columns: int = 80,
        rows: int = 24,
        *,
        cwd: Path | None = None,
        env: Mapping[str, str] | None = None,
        command: str = "",
        text: str = "",
    ) -> Terminal:
        """Open a terminal with its own shell; with a `command` it runs that, with `env`, and ends.

        `text` is what stood in an earlier one (`transcript`): it is shown above the first prompt.
        """
        from day6_core.shell.terminal import Terminal

        terminal = Terminal(self, columns, rows, cwd=cwd, env=env, command=command, text=text)
        self.terminals.append(terminal)
        return terminal

    # -- life ----------------------------------------------------------------------------------------------------------

    def start(self, *, link: bool = True) -> None:
        """Run the programs in a thread of its own and (`link`) join the link in the background. Returns at once."""
        self._started = True
        # Whole, before there are two threads that may want it: its modules import each other, and of two threads that begin at
        # different ones Python gives one a module that isn't finished.
        import rclpy  # noqa: F401

        self.scheduler.start()
        if link:
            self.open_link()

    def open_link(self) -> None:
        """Let the graphs meet the other processes of this user, in the background."""
        if not self._join_link or self._link_opened:
            return
        self._link_opened = True
        for graph in list(self.graphs.values()):
            self._join_in_background(graph)

    def link_on_demand(self) -> None:
        """Join a graph just before a program first uses it (a script that uses none should not pay for it)."""
        self._on_demand = self._join_link

    def _join_in_background(self, graph: Graph) -> None:
        self.in_background(partial(self._join, graph), "day6-join")

    def _join(self, graph: Graph) -> None:
        from day6_core.link import join

        self._joined.add(graph)
        try:
            if self._part is not None and graph is not self.graph:
                join(graph, never_wait=True)  # only one graph of a desktop can be in the class
            else:
                join(
                    graph,
                    never_wait=True,
                    listen=self._listen,
                    connect=self._connect,
                    secret=self._secret,
                    part=self._part,
                )
        except Exception:
            # Without the link the desk still works by itself; other processes are not visible, and the inspector says why.
            _log.warning("the link could not be opened", exc_info=True)

    def close(self) -> None:
        """End every program (see `end_programs`), then the link and the thread. May be called twice."""
        if self._closed:
            return
        self._closed = True
        self._stop_processes(False)
        for terminal in list(self.terminals):
            terminal.hang_up()
        self.end_programs(list(self.programs.values()))
        for terminal in list(self.terminals):  # each takes itself off the list
            terminal.close()
        for thread in self._background:
            cores.join(thread, GRACE)
        if self._joined:
            from day6_core.link import leave

            for graph in self._joined:
                leave(graph)
        self.scheduler.close()

    def end_programs(self, programs: list[Program]) -> None:
        """End these: Ctrl-C, a second later SIGTERM, a second later SIGKILL (wall time: the world may stand still)."""

        def alive() -> list[Program]:
            return [program for program in programs if program.status is None]

        def over(hopeful: bool) -> bool:
            return not alive() or (self._hurried and hopeful)

        for action in (Program.interrupt, Program.terminate, Program.kill):
            hopeful = action is not Program.kill
            if self._hurried and hopeful:
                continue
            for program in alive():
                program.resume()
                action(program)
            self._wait(partial(over, hopeful), GRACE / 2)
            if not alive():
                return

    def hurry(self) -> None:
        """Stop waiting for programs: whatever is ending them goes on to SIGKILL at once. Any thread."""
        self._hurried = True
        with self._changed:
            self._changed.notify_all()

    def _wait(self, condition: Callable[[], bool], timeout: float) -> None:
        if not self._started:
            self.scheduler.run(condition, timeout)
            return
        end = time.monotonic() + timeout
        with self._changed:
            while not condition() and (left := end - time.monotonic()) > 0:
                self._changed.wait(left)


def domain_of(env: Mapping[str, str]) -> int:
    """The domain of programs with these variables; raises DomainError for a ROS_DOMAIN_ID that rcl refuses."""
    return domain_from_text(env.get("ROS_DOMAIN_ID", ""))


def _own_domain() -> int:
    """The domain that the desk itself uses: the environment's, or 0 if every program will refuse that one."""
    try:
        return domain_of(os.environ)
    except DomainError:
        return 0
