"""`%load_ext day6_tui`: cells of a notebook are ROS programs, as `day6-tui python FILE` makes one of a file.

Nodes made in a cell are spun by a thread as soon as the cell has ended, so their callbacks run while the next one is written.
A cell that spins a node itself has it for that long, as in any program. What differs from a program: rclpy.init installs no
signal handlers (the kernel's interrupt stays a KeyboardInterrupt, and ROS goes on), and a node that a cell makes again takes
the place of the one it made before.
"""

from __future__ import annotations

import os
import sys
import threading
import traceback
from functools import wraps
from typing import TYPE_CHECKING, Any

from day6_tui.core.ros.environment import activate, program_environment

if TYPE_CHECKING:
    from rclpy.executors import Executor
    from rclpy.node import Node

PAUSE_SECONDS = 0.1
"""Longest between two looks for the end."""
_loaded: list[Notebook] = []


def load(shell: Any) -> None:
    """Load it into an IPython shell; a second time changes nothing."""
    if not _loaded:
        _loaded.append(Notebook(shell))


def unload(shell: Any) -> None:
    """Stop spinning. What was imported stays."""
    while _loaded:
        _loaded.pop().close()


class Notebook:
    """Spins the nodes of the default context between cells and during them."""

    def __init__(self, shell: Any) -> None:
        activate()
        os.environ.update(program_environment())  # for !ros2 and !python3
        import rclpy

        self._shell = shell
        self._rclpy = rclpy
        self._init = rclpy.init
        rclpy.init = self._init_for_cells(rclpy.init)
        self._executor: Executor | None = None
        self._names: dict[str, Node] = {}
        """full name -> the node that was adopted last under it"""
        self._lock = threading.Lock()
        self._wake = threading.Event()
        self._closed = False
        self._thread = threading.Thread(target=self._spin, name="day6-notebook", daemon=True)
        self._thread.start()
        shell.events.register("post_run_cell", self._adopt)
        shell.register_magic_function(self._ros2, "line", "ros2")

    def close(self) -> None:
        """Stop the thread; nodes stay, and are spun by nobody."""
        self._closed = True
        self._wake.set()
        self._shell.events.unregister("post_run_cell", self._adopt)
        self._shell.magics_manager.magics["line"].pop("ros2", None)
        self._rclpy.init = self._init
        self._thread.join(timeout=10 * PAUSE_SECONDS)

    def _init_for_cells(self, init: Any) -> Any:
        @wraps(init)
        def init_for_cells(**keywords: Any) -> Any:
            if keywords.get("signal_handler_options") is None:
                keywords["signal_handler_options"] = self._rclpy.SignalHandlerOptions.NO
            return init(**keywords)

        return init_for_cells

    def _ros2(self, line: str) -> None:
        """Run a ros2 command."""
        self._shell.system(f"ros2 {line}")

    def _adopt(self, *_: object) -> None:
        """After a cell: have the thread spin the nodes that nobody spins."""
        context = self._rclpy.get_default_context()
        if not context.ok():
            return
        with self._lock:
            if self._executor is None or self._executor.context is not context:
                from rclpy.executors import SingleThreadedExecutor

                self._executor, self._names = SingleThreadedExecutor(), {}
            for node in context._living_nodes():
                if node.executor is None or node not in node.executor.get_nodes():
                    self._replace(node)
                    self._executor.add_node(node)
        self._wake.set()

    def _replace(self, node: Node) -> None:
        """End the node that an earlier run of the cell made under this name."""
        name = node.get_fully_qualified_name()
        before = self._names.get(name)
        if before is not None and before is not node:
            before.destroy_node()
            print(f"{name}: the node that was made here before has been destroyed")
        self._names[name] = node

    def _spin(self) -> None:
        while not self._closed:
            with self._lock:
                executor = self._executor
            if executor is None or not executor.context.ok() or not executor.get_nodes():
                self._wake.wait(PAUSE_SECONDS)
                self._wake.clear()
                continue
            try:
                executor.spin_once(timeout_sec=PAUSE_SECONDS)
            except Exception:
                # A callback failed: its traceback is the pupil's, and the other callbacks go on.
                traceback.print_exc(file=sys.stderr)
