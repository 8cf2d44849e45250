"""What the logger levels show: nodes, the loggers of the chosen one, and their levels.

The window runs on another thread: it reads and makes requests, the program's thread carries them out.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from rcl_interfaces.msg import LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

from day6_core.graph.names import full_name
from day6_core.ros.programs.rqt_py_common.requests import Requests
from day6_core.ros.programs.rqt_py_common.service_calls import ServiceCalls

if TYPE_CHECKING:
    from rclpy.client import Client
    from rclpy.node import Node

LEVELS = {10: "DEBUG", 20: "INFO", 30: "WARN", 40: "ERROR", 50: "FATAL"}
"""Numbers of rcl_interfaces/msg/LoggerLevel, with the words of the list in the real plugin."""

OTHERS = ("rcl", "rmw")
"""Loggers that every program has; a node cannot be asked which others there are."""

MOST_LOGGERS = 100


class Logger(NamedTuple):
    """A logger of the chosen node. `level` is None until the node has told it; 0 is not set: that of its parent counts."""

    name: str
    level: int | None


class LoggerLevels(Requests):
    """The model of one plugin. The window may read the attributes and call `choose`, `add`, `set`, `read` and `cancel`."""

    def __init__(self, node: Node, now: Callable[[], int], chosen: str = "") -> None:
        super().__init__()
        self._node = node
        self._awaited = chosen
        """The node to choose as soon as it is there."""
        self._calls = ServiceCalls(now, self._show, self._on_failure)
        self._clients: list[Client[Any, Any]] = []
        self._levels: dict[str, int | None] = {}
        self.nodes: dict[str, bool] = {}
        """The full names of all nodes, sorted, and whether each has the services."""
        self.node = ""
        """The chosen one."""
        self.loggers: tuple[Logger, ...] = ()
        self.waited: int | None = None
        """The whole seconds for which a response is waited; None if none is."""
        self.message = ""
        """Why the last change failed, in the words of the node."""
        self.version = 0

    # -- the window's side ---------------------------------------------------------------------------------------------

    def choose(self, node: str) -> None:
        """Show the loggers of a node."""
        self.post(lambda: self._choose(node))

    def add(self, logger: str) -> None:
        """Show a logger of the chosen node that is not listed."""
        self.post(lambda: self._add(logger))

    def set(self, logger: str, level: int) -> None:
        """Set the level of a logger of the chosen node."""
        self.post(lambda: self._set(logger, level))

    def read(self) -> None:
        """Ask the chosen node again."""
        self.post(self._read)

    def cancel(self) -> None:
        """Wait for no response any more."""
        self.post(self._cancel)

    # -- the program's side --------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Look which nodes there are, and ask the chosen one when it has come."""
        node = self._node
        names = sorted({full_name(namespace, name) for name, namespace in node.get_node_names_and_namespaces()})
        # Not by the list of services: it has those that are only called, too.
        found = {name: node.count_services(f"{name}/get_logger_levels") > 0 for name in names}
        if found == self.nodes:
            return
        before, self.nodes = self.nodes, found
        if self.node and not before.get(self.node) and found.get(self.node):
            self._read()
        elif self.node and not found.get(self.node):
            self._calls.give_up()
        elif self._awaited in found:
            self._choose(self._awaited)
        self._show()

    def tick(self) -> None:
        """Count the seconds for which a response is waited; called about once a second."""
        self._show()

    def close(self) -> None:
        """Give back what it has on the program's node."""
        self._calls.give_up()
        while self._clients:
            self._node.destroy_client(self._clients.pop())

    def _choose(self, name: str) -> None:
        if name == self.node:
            return
        self.close()
        self.node, self.message, self._awaited = name, "", ""
        self._levels = dict.fromkeys((name[1:].replace("/", "."), *OTHERS))
        self._clients = [
            self._node.create_client(GetLoggerLevels, f"{name}/get_logger_levels"),
            self._node.create_client(SetLoggerLevels, f"{name}/set_logger_levels"),
        ]
        self._read()

    def _read(self) -> None:
        if self.nodes.get(self.node):
            request = GetLoggerLevels.Request(names=list(self._levels))
            self._calls.send(self._clients[0], request, self._on_levels)
        self._show()

    def _add(self, logger: str) -> None:
        if self.node and logger and len(self._levels) < MOST_LOGGERS:
            self._levels.setdefault(logger)
            self._read()

    def _set(self, logger: str, level: int) -> None:
        if self.nodes.get(self.node) and logger in self._levels:
            self.message = ""
            request = SetLoggerLevels.Request(levels=[LoggerLevel(name=logger, level=level)])
            self._calls.send(self._clients[1], request, self._on_set)
            self._show()

    def _cancel(self) -> None:
        self._calls.give_up()
        self._show()

    def _on_levels(self, response: GetLoggerLevels.Response) -> None:
        for each in response.levels:
            if each.name in self._levels:
                self._levels[each.name] = each.level

    def _on_set(self, response: SetLoggerLevels.Response) -> None:
        self.message = next((each.reason or "failed" for each in response.results if not each.successful), "")
        self._read()

    def _on_failure(self, reason: str) -> None:
        self.message = reason

    def _show(self) -> None:
        self.loggers = tuple(Logger(*each) for each in self._levels.items())
        self.waited = self._calls.waited
        self.version += 1
