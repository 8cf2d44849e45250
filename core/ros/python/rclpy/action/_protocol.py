"""What servers and clients of actions share: the names below `<action>/_action/` and the states of a goal."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_tui.core.graph import names
from day6_tui.core.interfaces import copy_message, type_hash, type_name
from rclpy._rclpy_pybind11 import DESTROYED, GoalEvent, InvalidHandle, RCLError
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from rclpy._handles import NodeHandle

UNKNOWN, ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(7)
STATE_NAMES = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
_TRANSITIONS = {
    (ACCEPTED, GoalEvent.EXECUTE): EXECUTING,
    (ACCEPTED, GoalEvent.CANCEL_GOAL): CANCELING,
    (EXECUTING, GoalEvent.CANCEL_GOAL): CANCELING,
    (EXECUTING, GoalEvent.SUCCEED): SUCCEEDED,
    (EXECUTING, GoalEvent.ABORT): ABORTED,
    (CANCELING, GoalEvent.SUCCEED): SUCCEEDED,
    (CANCELING, GoalEvent.ABORT): ABORTED,
    (CANCELING, GoalEvent.CANCELED): CANCELED,
}


def next_state(state: int, event: GoalEvent) -> int:
    """Return the state after an event; RCLError for an event that may not happen now (rcl_action/goal_state_machine.c)."""
    after = _TRANSITIONS.get((state, event))
    if after is None:
        raise RCLError(
            f"Failed to update goal state: goal_handle attempted invalid transition from state {STATE_NAMES[state]} "
            f"with event {event.name}, at /project/src/rcl_action/goal_handle.c:101"
        )
    return after


class ActionEndpoints:
    """The five endpoints of an action server or client. `failed` begins the text for a bad name."""

    def __init__(self, node: NodeHandle, action_type: Any, action_name: str, failed: str) -> None:
        node.check()
        self.node = node
        if not hasattr(action_type, "Impl"):
            # Real rclpy dies of a segmentation fault here.
            raise RuntimeError(
                f"The action type provided is not valid ({action_type}), this might be a message or service"
            )
        self.implementation = action_type.Impl
        self.name = _full_name(node, action_name, failed)
        self.endpoints: list[Any] = []
        self.destroyed = False

    def check(self) -> None:
        """Raise InvalidHandle after destruction."""
        if self.destroyed:
            raise InvalidHandle(DESTROYED)

    def service(self, name: str, interface: Any, qos: QoSProfile) -> Any:
        """Add a service server."""
        return self._add(
            self.node.node.create_service(
                self._sub_name(name), type_name(interface), type_hash(interface), qos.get_c_qos_profile(), copy_message
            )
        )

    def client(self, name: str, interface: Any, qos: QoSProfile) -> Any:
        """Add a service client."""
        return self._add(
            self.node.node.create_client(
                self._sub_name(name), type_name(interface), type_hash(interface), qos.get_c_qos_profile(), copy_message
            )
        )

    def publisher(self, name: str, interface: Any, qos: QoSProfile) -> Any:
        """Add a publisher."""
        return self._add(
            self.node.node.create_publisher(
                self._sub_name(name), type_name(interface), type_hash(interface), qos.get_c_qos_profile(), copy_message
            )
        )

    def subscription(self, name: str, interface: Any, qos: QoSProfile) -> Any:
        """Add a subscription."""
        return self._add(
            self.node.node.create_subscription(
                self._sub_name(name), type_name(interface), type_hash(interface), qos.get_c_qos_profile()
            )
        )

    def _sub_name(self, name: str) -> str:
        full = f"{self.name}/_action/{name}"
        node = self.node
        return names.remap_topic(full, node.name, node.namespace, node.rules) if node.rules else full

    def _add(self, endpoint: Any) -> Any:
        self.endpoints.append(endpoint)
        return endpoint

    def destroy(self) -> None:
        """Take everything out of the graph."""
        self.destroyed = True
        for endpoint in self.endpoints:
            endpoint.destroy()


def _full_name(node: NodeHandle, name: Any, failed: str) -> str:
    if name is None:
        kind = failed.split()[4]
        raise ValueError(
            f"Failed to create action {kind}: action_name argument is null, at /project/src/rcl_action/action_{kind}.c:180"
        )
    flaw = names.flaw_of_topic_name(name)
    if flaw is not None:
        raise ValueError(f"{failed.format(name)} {flaw.message}, at /project/src/rcl/expand_topic_name.c:73")
    try:
        return names.expand(name, node.name, node.namespace)
    except names.UnknownSubstitution as error:
        raise ValueError(f"{failed.format(name)} {error}, at /project/src/rcl/expand_topic_name.c:164") from None
