"""Recorded calls that are sent again: `--publish-service-requests` and `--send-actions-as-client` of `ros2 bag play`.

The texts are those of rosbag2_transport's player.cpp.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from uuid import uuid4

from day6_core.interfaces import deserialize, get_interface
from rosbag2_py._options import ServiceRequestsSource
from rosbag2_py._storage import EVENT_SUFFIX, Message, TopicMetadata

if TYPE_CHECKING:
    from rclpy.node import Node


class ServiceRequests:
    """The clients of a player, by the topic of the recorded events."""

    def __init__(self, node: Node, source: ServiceRequestsSource) -> None:
        self._node = node
        self._log = node.get_logger()
        from service_msgs.msg import ServiceEventInfo  # not in Humble, whose bags have no such events

        # Of the up to four events of a call, the one that its request is taken from.
        self._taken = {
            ServiceRequestsSource.SERVICE_INTROSPECTION: ServiceEventInfo.REQUEST_RECEIVED,
            ServiceRequestsSource.CLIENT_INTROSPECTION: ServiceEventInfo.REQUEST_SENT,
        }[source]
        self._clients: dict[str, Any] = {}
        self._event_types: dict[str, type] = {}
        self._goals: dict[bytes, Any] = {}
        """The ID with which a recorded goal was sent, by the recorded one: a server may still know that."""
        self._told: set[str] = set()

    def add(self, topic: TopicMetadata) -> None:
        """Make the client for a topic with events (others are left out); a service of unknown type is told and left out."""
        if topic.name in self._clients or not topic.name.endswith(EVENT_SUFFIX):
            return
        service = topic.name.removesuffix(EVENT_SUFFIX)
        try:
            self._event_types[topic.name] = get_interface(topic.type)
            kind = get_interface(topic.type.removesuffix("_Event"))
            self._clients[topic.name] = self._node.create_client(kind, service)
        except Exception as error:
            # Whatever is wrong with a type, the rest of the bag is played.
            self._log.warning(f"Ignoring a service '{service}', reason: {error}.")

    def takes(self, topic: str) -> bool:
        """Say whether messages of a topic are recorded calls."""
        return topic in self._clients

    def send(self, message: Message) -> bool:
        """Send the request in an event again; False for events that are not to be, or cannot be, sent."""
        service = message.topic.removesuffix(EVENT_SUFFIX)
        client = self._clients[message.topic]
        try:
            event: Any = deserialize(message.data, self._event_types[message.topic])
        except Exception:
            # As for a damaged message of a topic: the playback goes on.
            self._log.error(f"Failed to deserialize service event message for '{service}' service!\n")
            return False
        if event.info.event_type != self._taken:
            return False
        if not client.service_is_ready():
            self._log.error(f"Service request hasn't been sent. The '{service}' service isn't ready !")
            return False
        if not event.request:
            self._tell_of_metadata(service, event)
            return False
        self._name_goal(event.request[0])
        try:
            client.call_async(event.request[0])
        except Exception as error:
            # As the real player: one request that cannot be sent must not end the playback.
            self._log.error(f"Failed to send request on '{service}' service. \nError: {error}")
            return False
        return True

    def _name_goal(self, request: Any) -> None:
        """Give a request of an action the ID that its goal has now."""
        from unique_identifier_msgs.msg import UUID

        about = getattr(request, "goal_info", request)
        recorded = getattr(about, "goal_id", None)
        if not isinstance(recorded, UUID):
            return  # of a service
        key = bytes(recorded.uuid)
        if hasattr(request, "goal"):
            self._goals[key] = UUID(uuid=list(uuid4().bytes))
        about.goal_id = self._goals.get(key, recorded)

    def _tell_of_metadata(self, service: str, event: Any) -> None:
        from service_msgs.msg import ServiceEventInfo

        if service in self._told:
            return
        self._told.add(service)
        side = (
            f"'{service}' was metadata only on service side!"
            if event.info.event_type == ServiceEventInfo.REQUEST_RECEIVED
            else f"'{service}' client [ID: {_shown(event.info.client_gid)}]` was metadata only!"
        )
        self._log.warning(f"Can't send service request. The configuration of introspection for {side}")


def _shown(gid: Any) -> str:
    """Return a GID as rosbag2_cpp's client_id_to_string writes it: in decimal numbers."""
    return "-".join(str(int(byte)) for byte in gid)
