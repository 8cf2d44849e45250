"""The daemon if it runs, else a node of the command's own."""

from __future__ import annotations

from argparse import ArgumentParser
from types import TracebackType
from typing import Any

from day6_core.ros.ros2.cli.options import add_strategy_options
from ros2cli.node.daemon import DaemonNode, is_daemon_running, spawn_daemon
from ros2cli.node.direct import DirectNode

__all__ = ["DaemonNode", "DirectNode", "NodeStrategy", "add_arguments"]


class NodeStrategy:
    """Asks the daemon what it can answer, a node of its own the rest. Without a daemon it starts one, for the next command."""

    def __init__(self, args: Any, *, node_name: str | None = None) -> None:
        self._daemon_node: DaemonNode | None = None
        self._direct_node: DirectNode | None = None
        self._args = args
        self._node_name = node_name
        self._in_scope = False
        if getattr(args, "no_daemon", False):
            self._direct_node = DirectNode(args, node_name=node_name)
        elif is_daemon_running(args):
            self._daemon_node = DaemonNode(args)
        else:
            spawn_daemon(args)
            self._direct_node = DirectNode(args, node_name=node_name)

    @property
    def daemon_node(self) -> DaemonNode | None:
        """The daemon, None where it is not used."""
        return self._daemon_node

    @property
    def direct_node(self) -> DirectNode:
        """A node of its own, made at the first use."""
        if self._direct_node is None:
            self._direct_node = DirectNode(self._args, node_name=self._node_name)
            if self._in_scope:
                self._direct_node.__enter__()
        return self._direct_node

    def __enter__(self) -> NodeStrategy:
        for node in (self._daemon_node, self._direct_node):
            if node is not None:
                node.__enter__()
        self._in_scope = True
        return self

    def __getattr__(self, name: str) -> Any:
        daemon = self.daemon_node
        return getattr(daemon if daemon is not None and name in daemon.methods else self.direct_node, name)

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._in_scope = False
        for node in (self._direct_node, self._daemon_node):
            if node is not None:
                node.__exit__(exc_type, exc_value, traceback)


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options that choose between the two."""
    add_strategy_options(parser)
