"""A command's own node."""

from __future__ import annotations

import os
import time
from argparse import ArgumentParser
from types import TracebackType
from typing import Any

import rclpy
import rclpy.action
from day6_core.ros.ros2.cli.options import add_discovery_options
from rclpy.parameter import Parameter
from ros2cli.node import NODE_NAME_PREFIX

DEFAULT_TIMEOUT = 0.5
"""Seconds that the real one listens for the others unless it is told another time."""

NamesAndTypes = list[tuple[str, list[str]]]


class DirectNode:
    """A hidden node, with rclpy initialised for it; its attributes are the node's.

    The real one listens `args.spin_time` seconds for the others first. Here the graph is known as soon as the link has settled;
    a time that was asked for is waited.
    """

    def __init__(self, args: Any, *, node_name: str | None = None) -> None:
        rclpy.init(args=getattr(args, "argv", []))
        self.node = rclpy.create_node(
            node_name or NODE_NAME_PREFIX + getattr(args, "node_name_suffix", f"_{os.getpid()}"),
            start_parameter_services=getattr(args, "start_parameter_services", False),
            parameter_overrides=[
                Parameter("use_sim_time", value=getattr(args, "use_sim_time", False)),
                Parameter(
                    "start_type_description_service", value=getattr(args, "start_type_description_service", True)
                ),
            ],
            automatically_declare_parameters_from_overrides=True,
        )
        settle(self.node)
        seconds = getattr(args, "spin_time", None)
        if seconds not in (None, DEFAULT_TIMEOUT):
            time.sleep(seconds)

    def __enter__(self) -> DirectNode:
        return self

    def get_action_names_and_types(self) -> NamesAndTypes:
        """As in `rclpy.action`."""
        return rclpy.action.get_action_names_and_types(self.node)

    def get_action_client_names_and_types_by_node(
        self, remote_node_name: str, remote_node_namespace: str
    ) -> NamesAndTypes:
        """As in `rclpy.action`."""
        return rclpy.action.get_action_client_names_and_types_by_node(
            self.node, remote_node_name, remote_node_namespace
        )

    def get_action_server_names_and_types_by_node(
        self, remote_node_name: str, remote_node_namespace: str
    ) -> NamesAndTypes:
        """As in `rclpy.action`."""
        return rclpy.action.get_action_server_names_and_types_by_node(
            self.node, remote_node_name, remote_node_namespace
        )

    def __getattr__(self, name: str) -> Any:
        if not rclpy.ok():
            raise RuntimeError("!rclpy.ok()")
        return getattr(self.node, name)

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.node.destroy_node()
        rclpy.try_shutdown()


def settle(node: Any) -> None:
    """Wait until the link has brought the other processes' entities into the node's graph."""
    from day6_core.link import link_of

    link = link_of(node.context._graph)
    if link is not None:
        link.wait_settled(DEFAULT_TIMEOUT)


def add_arguments(parser: ArgumentParser) -> None:
    """Add `--spin-time` and `--use-sim-time`."""
    add_discovery_options(parser)
    parser.set_defaults(spin_time=DEFAULT_TIMEOUT)
