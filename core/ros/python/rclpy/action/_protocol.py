"""What an action consists of: three services and two topics below its name (design.ros2.org, "Actions").

`ActionEntity` is the common half of client and server: five endpoints of the graph that are run as one entity.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_tui.core.graph import Client, Publisher, Service, Subscription
from day6_tui.core.graph.names import flaw_of_topic_name
from day6_tui.core.interfaces import copy_message, type_hash, type_name
from rclpy._entity import NOTHING
from rclpy._rclpy_pybind11 import DESTROYED, Destroyable, InvalidHandle
from rclpy.qos import QoSProfile
from rclpy.type_support import check_for_type_support
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node

SEND_GOAL = "send_goal"
CANCEL_GOAL = "cancel_goal"
GET_RESULT = "get_result"
FEEDBACK = "feedback"
STATUS = "status"

GoalKey = bytes
"""The 16 bytes of a goal's UUID."""


def key_of(goal_id: Any) -> GoalKey:
    """Return a goal's UUID message as bytes."""
    return bytes(goal_id.uuid)


class ActionEntity(Waitable[Any]):
    """Runs the endpoints of one action client or server in its executor."""

    def __init__(self, node: Node, action_type: Any, action_name: str, callback_group: CallbackGroup | None) -> None:
        super().__init__(node.default_callback_group if callback_group is None else callback_group)
        check_for_type_support(action_type)
        self._node = node
        self._action_type = action_type
        self._action_name = action_name
        self._handle = Destroyable()
        self._endpoints: list[Client | Service | Publisher | Subscription] = []
        self._receivers: list[tuple[Client | Service | Subscription, Callable[[Any], Any]]] = []

    # endpoints

    def _check_name(self, role: str, name: str) -> None:
        """Raise ValueError with rcl_action's text for a flawed action name."""
        flaw = flaw_of_topic_name(name)
        if flaw is not None:
            colon = ":" if role == "client" else ": :"
            raise ValueError(
                f"Failed to create action {role} due to invalid topic name '{name}' {colon} {flaw.message}, "
                "at /project/src/rcl/expand_topic_name.c:73"
            )

    def _name(self, part: str, *, topic: bool = False) -> str:
        name = f"{self._action_name}/_action/{part}"
        return self._node.resolve_topic_name(name) if topic else self._node.resolve_service_name(name)

    def _make_client(self, part: str, service: Any, qos: QoSProfile, receive: Callable[[Any], Any]) -> Client:
        client = self._node._graph_node.create_client(
            self._name(part), type_name(service), type_hash(service), qos.get_c_qos_profile(), copy_message
        )
        return self._listen(client, receive)

    def _make_service(self, part: str, service: Any, qos: QoSProfile, receive: Callable[[Any], Any]) -> Service:
        server = self._node._graph_node.create_service(
            self._name(part), type_name(service), type_hash(service), qos.get_c_qos_profile(), copy_message
        )
        return self._listen(server, receive)

    def _make_publisher(self, part: str, message: Any, qos: QoSProfile) -> Publisher:
        publisher = self._node._graph_node.create_publisher(
            self._name(part, topic=True), type_name(message), type_hash(message), qos.get_c_qos_profile(), copy_message
        )
        self._endpoints.append(publisher)
        return publisher

    def _make_subscription(
        self, part: str, message: Any, qos: QoSProfile, receive: Callable[[Any], Any]
    ) -> Subscription:
        subscription = self._node._graph_node.create_subscription(
            self._name(part, topic=True), type_name(message), type_hash(message), qos.get_c_qos_profile()
        )
        return self._listen(subscription, receive)

    def _listen(self, endpoint: Any, receive: Callable[[Any], Any]) -> Any:
        endpoint.on_ready = self._notify
        self._endpoints.append(endpoint)
        self._receivers.append((endpoint, receive))
        return endpoint

    # running

    def _pending(self) -> bool:
        return any(endpoint.queue for endpoint, _ in self._receivers)

    def _process(self) -> Any:
        self._queued = False
        taken = [(receive, data) for endpoint, receive in self._receivers if (data := endpoint.take()) is not None]
        if not taken:
            return NOTHING
        if self._pending():
            self._notify()
        return self._receive_all(taken)

    async def _receive_all(self, taken: list[tuple[Callable[[Any], Any], Any]]) -> None:
        for receive, data in taken:
            await receive(data)

    def get_num_entities(self) -> NumberOfEntities:
        """Return how many entities of each kind there are."""
        return NumberOfEntities(
            num_subs=sum(isinstance(each, Subscription) for each in self._endpoints),
            num_clients=sum(isinstance(each, Client) for each in self._endpoints),
            num_services=sum(isinstance(each, Service) for each in self._endpoints),
        )

    # the end

    def _check(self) -> None:
        if self._handle._destroyed:
            raise InvalidHandle(DESTROYED)

    def __enter__(self) -> None:
        self._handle.__enter__()

    def __exit__(self, exc_type: object, exc_value: object, traceback: object) -> None:
        self._handle.__exit__(exc_type, exc_value, traceback)

    def destroy(self) -> None:
        """Take the action's endpoints out of the graph. ValueError the second time, as in real rclpy."""
        self._handle.destroy_when_not_in_use()
        for endpoint in self._endpoints:
            endpoint.destroy()
        self._node.remove_waitable(self)
