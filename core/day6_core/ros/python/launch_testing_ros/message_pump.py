"""Spins a node while a test waits."""

from __future__ import annotations

import threading

from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

_PATIENCE = 5.0
"""Seconds in which the thread has to end."""


class MessagePump:
    """Spins a node on a thread, from `start` until `stop`."""

    def __init__(self, node: Node, context: Context | None = None) -> None:
        self._node = node
        self._context = context
        self._goes_on = True
        self._thread = threading.Thread(target=self._run, name="msg_pump_thread")

    def start(self) -> None:
        self._thread.start()

    def stop(self) -> None:
        """End the thread. Raises Exception if it is still busy after 5 seconds."""
        self._goes_on = False
        self._thread.join(_PATIENCE)
        if self._thread.is_alive():
            raise Exception("Timed out waiting for message pump to stop")

    def _run(self) -> None:
        executor = SingleThreadedExecutor(context=self._context)
        executor.add_node(self._node)
        while self._goes_on:
            executor.spin_once(timeout_sec=1.0)
