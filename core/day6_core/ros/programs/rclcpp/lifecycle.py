"""The node of rclcpp_lifecycle."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros import differences
from day6_core.ros.programs.rclcpp.node import CppNode
from rclpy.lifecycle.node import LifecycleNodeMixin

if TYPE_CHECKING:
    from day6_core.session.session import Session

_FINALIZED = 4
"""lifecycle_msgs/msg/State.PRIMARY_STATE_FINALIZED"""


class CppLifecycleNode(LifecycleNodeMixin, CppNode):
    """A managed node. It lacks the parameters for the QoS of /parameter_events (rclcpp_lifecycle/lifecycle_node.cpp)."""

    _shows_event_qos = False

    def __init__(self, name: str, **keywords: Any) -> None:
        CppNode.__init__(self, name, **keywords)
        LifecycleNodeMixin.__init__(self)

    def _reason(self, state: int, label: str) -> str:
        return f"{label}: Transition is not registered., at ./src/rcl_lifecycle.c:355"

    def warn_unless_finalized(self, session: Session) -> None:
        """Print what the destructor of a node says that was not shut down by a transition."""
        from day6_core.ros.programs.rclcpp import log

        state = self._state_machine.current_state[0]
        if state != _FINALIZED and differences.value("rclcpp.lifecycle_warns"):
            text = f"LifecycleNode is not shut down: Node still in state({state}) in destructor"
            log(session, "WARN", "rclcpp_lifecycle", text)
