"""Shared by action servers and clients: the names below `<action>/_action/` and the states of a goal."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.graph import RequestId, Service, names
from day6_core.interfaces import copy_message, type_hash, type_name
from rclpy._rclpy_pybind11 import DESTROYED, GoalEvent, InvalidHandle, RCLError
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from rclpy._day6.handles import NodeHandle
    from rclpy._day6.introspection import Introspection
    from rclpy.clock import Clock
    from rclpy.service_introspection import ServiceIntrospectionState

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
    """Return the state after an event; RCLError for an event that is invalid in this state (rcl_action/goal_state_machine.c)."""
    after = _TRANSITIONS.get((state, event))
    if after is None:
        raise RCLError(
            f"Failed to update goal state: goal_handle attempted invalid transition from state {STATE_NAMES[state]} "
            f"with event {event.name}, at /project/src/rcl_action/goal_handle.c:101"
        )
    return after


class ActionEndpoints:
    """The five endpoints of an action server or client. `failed` is the start of the error text for a bad name."""

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
        self._services: dict[Any, Any] = {}
        self._introspections: dict[Any, Introspection] = {}
        node.add_user(self)

    def check(self) -> None:
        """Raise InvalidHandle after destruction."""
        if self.destroyed:
            raise InvalidHandle(DESTROYED)

    def service(self, name: str, interface: Any, qos: QoSProfile) -> Any:
        """Add a service server."""
        endpoint = self._add(
            self.node.node.create_service(
                self._sub_name(name), type_name(interface), type_hash(interface), qos.get_c_qos_profile(), copy_message
            )
        )
        self._services[endpoint] = interface
        return endpoint

    def client(self, name: str, interface: Any, qos: QoSProfile) -> Any:
        """Add a service client."""
        endpoint = self._add(
            self.node.node.create_client(
                self._sub_name(name), type_name(interface), type_hash(interface), qos.get_c_qos_profile(), copy_message
            )
        )
        self._services[endpoint] = interface
        return endpoint

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
        for introspection in self._introspections.values():
            introspection.destroy()
        for endpoint in self.endpoints:
            endpoint.destroy()
        self.node.remove_user(self)

    def __del__(self, python_ends: Callable[[], bool] = sys.is_finalizing) -> None:
        if not python_ends() and not getattr(self, "destroyed", True):
            self.destroy()

    # asking and answering, with what introspection tells of it

    def send_request(self, client: Any, request: Any) -> int:
        """Send a request; returns its number."""
        number: int = client.send_request(request)
        introspection = self._introspections.get(client)
        if introspection is not None:
            introspection.request_sent(request, number)
        return number

    def send_response(self, service: Any, request_id: RequestId, response: Any) -> None:
        """Send a response."""
        introspection = self._introspections.get(service)
        if introspection is not None:
            introspection.response_sent(response, request_id)
        service.send_response(request_id, response)

    def take(self, endpoint: Any) -> Any:
        """Take the oldest request (with its id) or response (with the request's number); None if there is none."""
        taken = endpoint.take()
        introspection = self._introspections.get(endpoint)
        if introspection is not None and taken is not None:
            publish_event = (
                introspection.request_received if isinstance(endpoint, Service) else introspection.response_received
            )
            publish_event(*taken)
        return taken

    def configure_introspection(self, clock: Clock, qos: QoSProfile, state: ServiceIntrospectionState) -> None:
        """Publish requests and responses of the action's three services on `…/_service_event`, or stop doing so."""
        from rclpy._day6.introspection import Introspection

        self.check()
        for endpoint, interface in self._services.items():
            configured = Introspection.configured(
                self._introspections.pop(endpoint, None), self.node, endpoint, interface, clock, qos, state
            )
            if configured is not None:
                self._introspections[endpoint] = configured


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
        full = names.expand(name, node.name, node.namespace)
    except names.UnknownSubstitution as error:
        raise ValueError(f"{failed.format(name)} {error}, at /project/src/rcl/expand_topic_name.c:164") from None
    flaw = names.flaw_of_full_topic_name(f"{full}/_action/cancel_goal")
    if flaw is not None:
        raise ValueError(f"{failed.format(name)} {flaw.message}, at /project/src/rcl/node_resolve_name.c:102")
    return full
