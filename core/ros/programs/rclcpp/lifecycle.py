"""The node of rclcpp_lifecycle."""

from __future__ import annotations

from typing import Any

from day6_tui.core.ros.programs.rclcpp.node import CppNode
from rclpy.lifecycle.node import LifecycleNodeMixin


class CppLifecycleNode(LifecycleNodeMixin, CppNode):
    """A managed node. It lacks the parameters for the QoS of /parameter_events (rclcpp_lifecycle/lifecycle_node.cpp)."""

    _shows_event_qos = False

    def __init__(self, name: str, **keywords: Any) -> None:
        CppNode.__init__(self, name, **keywords)
        LifecycleNodeMixin.__init__(self)
