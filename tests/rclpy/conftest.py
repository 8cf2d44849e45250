"""A context on a graph of its own, with a clock that only moves when a test steps it."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from typing import Any

import pytest

from day6_core.graph import Graph

EPOCH_NS = 1_700_000_000_000_000_000
SECOND = 1_000_000_000


class SteppedTime:
    """A time source for tests: `steady_ns` starts at 0, `now_ns` is that after EPOCH_NS."""

    def __init__(self) -> None:
        self.elapsed = 0

    def steady_ns(self) -> int:
        return self.elapsed

    def now_ns(self) -> int:
        return EPOCH_NS + self.elapsed


class World:
    """A session's context and executor, run by hand."""

    def __init__(self) -> None:
        from rclpy.context import Context
        from rclpy.executors import SingleThreadedExecutor

        self.time = SteppedTime()
        self.graph = Graph()
        self.graph.now_ns = self.time.now_ns
        self.context = Context._for_session(self.graph, self.time, env={})
        self.log: list[str] = []
        self.context._log_write = self.log.append
        self.executor = SingleThreadedExecutor(context=self.context)

    def node(self, name: str, **keywords: Any) -> Any:
        """Make a node in the executor."""
        from rclpy.node import Node

        node = Node(name, context=self.context, **keywords)
        self.executor.add_node(node)
        return node

    def settle(self) -> None:
        """Run until nothing is ready any more."""
        while self.executor._run_ready():
            continue

    def run(self, seconds: float) -> None:
        """Let time pass, stopping at every timer."""
        end = self.time.elapsed + round(seconds * SECOND)
        self.settle()
        while True:
            deadline = self.executor._next_deadline()
            if deadline is None or deadline > end:
                break
            self.time.elapsed = max(self.time.elapsed, deadline)
            self.settle()
        self.time.elapsed = end

    def interrupt(self) -> None:
        """Do what SIGTERM does: every context is invalid after it, and nothing is destroyed."""
        import rclpy
        from rclpy.signals import SignalHandlerOptions

        before = signal.signal(signal.SIGTERM, lambda _number, _frame: None)
        try:
            rclpy.install_signal_handlers(SignalHandlerOptions.SIGTERM)
            signal.raise_signal(signal.SIGTERM)
        finally:
            rclpy.uninstall_signal_handlers()
            signal.signal(signal.SIGTERM, before)

    def until(self, future: Any) -> Any:
        """Run until a future is done; returns its result."""
        self.settle()
        assert future.done(), "nothing is ready and the future is not done"
        return future.result()


@pytest.fixture
def world() -> Iterator[World]:
    made = World()
    yield made
    made.context.try_shutdown()
