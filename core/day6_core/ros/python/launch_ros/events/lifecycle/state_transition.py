"""The event that a lifecycle node has changed its state."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.event import Event

if TYPE_CHECKING:
    from launch_ros.actions.lifecycle_node import LifecycleNode


class StateTransition(Event):
    """A lifecycle_msgs/msg/TransitionEvent from `action`."""

    name = "launch_ros.events.lifecycle.StateTransition"

    def __init__(self, *, action: LifecycleNode, msg: Any) -> None:
        self.__action = action
        self.__msg = msg

    @property
    def action(self) -> LifecycleNode:
        return self.__action

    @property
    def msg(self) -> Any:
        return self.__msg

    @property
    def timestamp(self) -> int:
        return int(self.__msg.timestamp)

    @property
    def stamp(self) -> Any:
        """The time, which the message has since Lyrical in place of `timestamp` (ros2/launch_ros#495)."""
        return self.__msg.stamp

    @property
    def transition(self) -> str:
        return str(self.__msg.transition.label)

    @property
    def start_state(self) -> str:
        return str(self.__msg.start_state.label)

    @property
    def goal_state(self) -> str:
        return str(self.__msg.goal_state.label)
