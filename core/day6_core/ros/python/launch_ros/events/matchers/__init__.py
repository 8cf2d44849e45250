"""Matchers for events of nodes."""

from __future__ import annotations

from launch_ros.events.matchers.matches_node_name import matches_node_name

__all__ = ["matches_node_name"]
