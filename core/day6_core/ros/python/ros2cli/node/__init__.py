"""The nodes with which commands look at the graph."""

from day6_core.ros.ros2.cli.node import PREFIX as NODE_NAME_PREFIX

__all__ = ["NODE_NAME_PREFIX"]
