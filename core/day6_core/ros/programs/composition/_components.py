"""The five components: a talker, two listeners, a server and its client."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs.demo_messages import String
from day6_core.ros.programs.demo_nodes_cpp.listener import Listener

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component
    from rclpy.node import Node


class Talker:
    """Publishes Hello World on `chatter` once a second."""

    NAME = "talker"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._publisher = node.create_publisher(String, "chatter", 10)
        self._count = 0
        node.create_timer(1.0, self._publish)

    def _publish(self) -> None:
        self._count += 1
        message = String(data=f"Hello World: {self._count}")
        self._logger.info(f"Publishing: '{message.data}'")
        self._publisher.publish(message)


class NodeLikeListener(Listener):
    """In C++ a class that has a node instead of being one; every component here is such a class."""

    NAME = "node_like_listener"


class Server:
    """Adds two numbers."""

    NAME = "Server"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        node.create_service(AddTwoInts, "add_two_ints", self._add)

    def _add(self, request: Any, response: Any) -> Any:
        self._logger.info(f"Incoming request: [a: {request.a}, b: {request.b}]")
        response.sum = request.a + request.b
        return response


class Client:
    """Requests the sum of 2 and 3 every two seconds."""

    NAME = "Client"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._client = node.create_client(AddTwoInts, "add_two_ints")
        node.create_timer(2.0, self._ask)

    def _ask(self) -> None:
        if not self._client.service_is_ready():
            self._logger.info("Service not available after waiting")
            return
        future: Any = self._client.call_async(AddTwoInts.Request(a=2, b=3))
        future.add_done_callback(lambda done: self._logger.info(f"Got result: [{done.result().sum}]"))


COMPONENTS: dict[str, type[Component]] = {
    f"composition::{kind.__name__}": kind for kind in (Talker, Listener, NodeLikeListener, Server, Client)
}
