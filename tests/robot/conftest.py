"""A machine whose time the test moves on, with the robot's programs on it and a node that listens."""

from __future__ import annotations

import importlib
import re
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from sensor_msgs.msg import JointState

from day6_tui.core.graph import Graph
from day6_tui.core.session.clock import WorldClock
from day6_tui.core.session.display import Display
from day6_tui.core.session.program import Program
from day6_tui.core.session.scheduler import Scheduler
from day6_tui.core.session.session import Session
from day6_tui.core.session.streams import Captured
from day6_tui.urdf import shipped_model

EPOCH_NS = 1_700_000_000_000_000_000


class Running:
    """A started program with what it wrote."""

    def __init__(self, program: Program, stdout: Captured, stderr: Captured) -> None:
        self.program = program
        self._stdout = stdout
        self._stderr = stderr

    @property
    def output(self) -> str:
        return self._stdout.text

    @property
    def errors(self) -> str:
        """What it wrote to stderr, without the time stamps of its log."""
        return re.sub(r" \[17\d+\.\d{9}\]", "", self._stderr.text)


class Machine:
    def __init__(self) -> None:
        self.clock = WorldClock(wall=None, epoch_ns=EPOCH_NS)
        self.scheduler = Scheduler(self.clock)
        self.graph = Graph()
        self.display = Display()
        self._programs: list[Program] = []
        session = Session(self.scheduler, self.graph, ["watcher"])
        self.node = session.create_node("watcher")
        self._programs.append(Program(session, lambda session: session.spin(self.node)))
        self._joints: Any = None

    def start(self, package: str, executable: str, *args: str, screen: bool = False) -> Running:
        """Run an executable up to its first wait."""
        stdout, stderr = Captured(), Captured()
        display = self.display if screen else None
        session = Session(
            self.scheduler, self.graph, [executable, *args], stdout=stdout, stderr=stderr, display=display
        )
        module = importlib.import_module(f"day6_tui.core.ros.programs.{package}.{executable}")
        program = Program(session, module.main)
        self._programs.append(program)
        self.advance()
        return Running(program, stdout, stderr)

    def publish_robot(self, *args: str) -> Running:
        """Start robot_state_publisher with the shipped car."""
        return self.start("robot_state_publisher", "robot_state_publisher", str(shipped_model()), *args)

    def watch(self, message: type, topic: str, qos: Any = 100) -> list[Any]:
        """Return a list that fills with the messages of a topic."""
        seen: list[Any] = []
        self.node.create_subscription(message, topic, seen.append, qos)
        self.advance()
        return seen

    def joint_states(self, names: list[str], positions: list[float], after: float = 0.06, stamp: bool = True) -> None:
        """Publish one message `after` seconds, with the stamp of then or none."""
        self.advance(after)
        message = JointState(name=names, position=positions)
        if stamp:
            message.header.stamp = self.node.get_clock().now().to_msg()
        if self._joints is None:  # only now: a publisher is seen by whoever counts them
            self._joints = self.node.create_publisher(JointState, "joint_states", 10)
        self._joints.publish(message)
        self.advance()

    def call(self, service: Any, name: str, **fields: Any) -> Any:
        """Call a service and return its response."""
        future = self.node.create_client(service, name).call_async(service.Request(**fields))
        for _ in range(100):
            if future.done():
                return future.result()
            self.advance(0.01)
        raise AssertionError("no answer")

    def advance(self, seconds: float = 0.0) -> None:
        self.scheduler.advance(seconds)

    def until(self, condition: Callable[[], object], seconds: float = 20.0) -> None:
        """Wait in real time for what a thread does, without moving the machine's time on."""
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, "it did not happen"
            time.sleep(0.002)
            self.advance()

    def end(self) -> None:
        for program in self._programs:
            program.kill()
        self.advance()


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    yield machine
    machine.end()
