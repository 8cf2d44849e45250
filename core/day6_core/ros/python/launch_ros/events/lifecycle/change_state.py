"""The event that makes lifecycle nodes execute a transition."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from launch.event import Event

if TYPE_CHECKING:
    from launch_ros.actions.lifecycle_node import LifecycleNode


class ChangeState(Event):
    """Makes the nodes for which the matcher is true execute a transition. Raises ValueError for an unknown one."""

    name = "launch_ros.events.lifecycle.ChangeState"

    valid_transitions = {
        0: "TRANSITION_CREATE",
        1: "TRANSITION_CONFIGURE",
        2: "TRANSITION_CLEANUP",
        3: "TRANSITION_ACTIVATE",
        4: "TRANSITION_DEACTIVATE",
        5: "TRANSITION_UNCONFIGURED_SHUTDOWN",
        6: "TRANSITION_INACTIVE_SHUTDOWN",
        7: "TRANSITION_ACTIVE_SHUTDOWN",
        8: "TRANSITION_DESTROY",
    }
    """The constants of lifecycle_msgs/msg/Transition."""

    valid_states = {
        0: "PRIMARY_STATE_UNKNOWN",
        1: "PRIMARY_STATE_UNCONFIGURED",
        2: "PRIMARY_STATE_INACTIVE",
        3: "PRIMARY_STATE_ACTIVE",
        4: "PRIMARY_STATE_FINALIZED",
        10: "TRANSITION_STATE_CONFIGURING",
        11: "TRANSITION_STATE_CLEANINGUP",
        12: "TRANSITION_STATE_SHUTTINGDOWN",
        13: "TRANSITION_STATE_ACTIVATING",
        14: "TRANSITION_STATE_DEACTIVATING",
        15: "TRANSITION_STATE_ERRORPROCESSING",
    }
    """The constants of lifecycle_msgs/msg/State."""

    def __init__(self, *, lifecycle_node_matcher: Callable[[LifecycleNode], bool], transition_id: int) -> None:
        if transition_id not in self.valid_transitions:
            known = ", ".join(f"{name}: {number}" for number, name in self.valid_transitions.items())
            raise ValueError(f"given transition_id of '{transition_id}', expected one of {{{known}}}")
        self.__matcher = lifecycle_node_matcher
        self.__transition_id = transition_id

    @property
    def lifecycle_node_matcher(self) -> Callable[[LifecycleNode], bool]:
        return self.__matcher

    @property
    def transition_id(self) -> int:
        return self.__transition_id
