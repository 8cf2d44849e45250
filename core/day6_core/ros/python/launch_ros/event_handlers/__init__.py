"""Handlers for events of ROS nodes."""

from __future__ import annotations

from launch_ros.event_handlers.on_state_transition import OnStateTransition

__all__ = ["OnStateTransition"]
