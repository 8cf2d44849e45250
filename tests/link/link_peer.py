"""One participant of the conformance suite: a graph with plain commands, here or in a process of its own.

Run as a script it reads one JSON command `[name, arguments]` a line and answers each with one JSON line.
"""

from __future__ import annotations

import json
import os
import sys
from typing import Any

from day6_core.graph import EndpointKind, Graph, QoS
from day6_core.graph.endpoints import Client, Endpoint, EventKind, Publisher, Service, Subscription
from day6_core.graph.node import Node
from day6_core.graph.qos import Durability, History, Reliability
from day6_core.interfaces import copy_message, get_message, get_service, type_hash
from day6_core.link.qos_text import qos_to_text

Json = Any


def qos_of(settings: dict[str, Any]) -> QoS:
    """Make a profile of `{"depth": 1, "latched": True, "best_effort": True, "keep_all": True, "lifespan": ns…}`."""
    plain = {key: value for key, value in settings.items() if key not in ("latched", "best_effort", "keep_all")}
    return QoS(
        durability=Durability.TRANSIENT_LOCAL if settings.get("latched") else Durability.VOLATILE,
        reliability=Reliability.BEST_EFFORT if settings.get("best_effort") else Reliability.RELIABLE,
        history=History.KEEP_ALL if settings.get("keep_all") else History.KEEP_LAST,
        **plain,
    )


class Peer:
    """Handles are numbers; everything given and returned is JSON."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self.things: list[Any] = []
        self.held: dict[int, list[Any]] = {}

    def _keep(self, thing: Any) -> int:
        self.things.append(thing)
        return len(self.things) - 1

    def node(self, name: str, namespace: str = "/") -> int:
        return self._keep(self.graph.create_node(name, namespace))

    def publisher(self, node: int, topic: str, type_name: str = "std_msgs/msg/String", **settings: Any) -> int:
        owner: Node = self.things[node]
        return self._keep(owner.create_publisher(topic, type_name, _hash(type_name), qos_of(settings), copy_message))

    def subscription(self, node: int, topic: str, type_name: str = "std_msgs/msg/String", **settings: Any) -> int:
        owner: Node = self.things[node]
        return self._keep(owner.create_subscription(topic, type_name, _hash(type_name), qos_of(settings)))

    def service(self, node: int, name: str, offset: int = 0, hold: bool = False) -> int:
        """Serve AddTwoInts; `hold` leaves the answering to `answer`."""
        type_name = "example_interfaces/srv/AddTwoInts"
        owner: Node = self.things[node]
        server = owner.create_service(name, type_name, _hash(type_name), QoS(), copy_message)
        handle = self._keep(server)
        self.held[handle] = []

        def on_ready(ready: Service) -> None:
            while (taken := ready.take()) is not None:
                self.held[handle].append(taken)
                if not hold:
                    self.answer(handle, offset)

        server.on_ready = on_ready
        return handle

    def answer(self, handle: int, offset: int = 0) -> int:
        """Answer what the server holds; returns how many requests that were."""
        held, self.held[handle] = self.held[handle], []
        for request, request_id in held:
            response = get_service("example_interfaces/srv/AddTwoInts").Response(sum=request.a + request.b + offset)
            self.things[handle].send_response(request_id, response)
        return len(held)

    def holding(self, handle: int) -> int:
        return len(self.held[handle])

    def client(self, node: int, name: str) -> int:
        type_name = "example_interfaces/srv/AddTwoInts"
        owner: Node = self.things[node]
        return self._keep(owner.create_client(name, type_name, _hash(type_name), QoS(), copy_message))

    def call(self, handle: int, a: int, b: int) -> int:
        client: Client = self.things[handle]
        return client.send_request(get_service("example_interfaces/srv/AddTwoInts").Request(a=a, b=b))

    def responses(self, handle: int) -> Json:
        """Return `[[sequence number, sum], …]` of what came since the last time."""
        client: Client = self.things[handle]
        found = []
        while (taken := client.take()) is not None:
            found.append([taken[1], taken[0].sum])
        return found

    def publish(self, handle: int, **fields: Any) -> None:
        publisher: Publisher = self.things[handle]
        publisher.publish(get_message(publisher.type_name)(**fields))

    def publish_numbers(self, handle: int, first: int, count: int) -> None:
        for number in range(first, first + count):
            self.publish(handle, data=str(number))

    def messages(self, handle: int) -> Json:
        """Return the `data` of what came since the last time."""
        return [each["data"] for each in self.samples(handle)]

    def samples(self, handle: int) -> Json:
        subscription: Subscription = self.things[handle]
        found = []
        while (sample := subscription.take()) is not None:
            info = subscription.message_info(sample)
            found.append(
                {
                    "data": sample[0].data,
                    "number": info.publication_sequence_number,
                    "gid": info.publisher_gid.hex(),
                    "source": info.source_timestamp,
                    "intra": info.from_intra_process,
                }
            )
        return found

    def length(self, handle: int) -> int:
        return len(self.things[handle].queue)

    def gid(self, handle: int) -> str:
        return str(self.things[handle].gid.hex())

    def matched(self, handle: int) -> int:
        return _matched(self.things[handle])

    def incompatible(self, handle: int) -> int:
        thing: Endpoint = self.things[handle]
        return thing.events[EventKind.INCOMPATIBLE_QOS].total_count

    def destroy(self, handle: int) -> None:
        self.things[handle].destroy()

    def nodes(self) -> list[str]:
        return sorted(node.full_name for node in self.graph.nodes)

    def endpoints(self, topic: str) -> Json:
        """Return what `topic info -v` needs of every endpoint of a topic or service, sorted."""
        return sorted(
            [
                each.kind.value,
                each.node.full_name,
                each.topic,
                each.type_name,
                each.type_hash,
                qos_to_text(each.qos),
                each.gid.hex(),
            ]
            for each in self.graph.endpoints(*EndpointKind, topic=topic)
        )

    def problems(self) -> list[str]:
        link: Any = self.graph.transport
        return list(link.problems) if link is not None else []

    def knowledge(self) -> str:
        """Return nodes, endpoints (those of its own with how many match), errors and links: for people to read."""
        link: Any = self.graph.transport
        session = link._session if link is not None else None
        info = getattr(session, "info", None)  # Zenoh's
        links = [str(each.zid) for each in info.links()] if info is not None else []
        there = self.graph.endpoints(*EndpointKind)
        matches = {each: f" matches {_matched(each)}" for each in there if each.origin is None}
        endpoints = [f"{each.kind.value} {each.topic} {each.gid.hex()}{matches.get(each, '')}" for each in there]
        zid = link.zid if link is not None else "none"
        return f"{zid} linked to {links}; {self.nodes()} {endpoints}; {self.problems()}"

    def leave(self, *, ending: bool = False) -> None:
        from day6_core.link import leave

        leave(self.graph, ending=ending)

    def pid(self) -> int:
        return os.getpid()

    def keeps_meeting_point(self) -> bool:
        link: Any = self.graph.transport
        return bool(link._meeting.held_here)


def _matched(endpoint: Publisher | Subscription | Service | Client) -> int:
    return endpoint.subscription_count if isinstance(endpoint, Publisher) else len(endpoint.matched)


def _hash(type_name: str) -> str:
    package, kind, _ = type_name.split("/")
    if package == "nowhere_msgs":
        return "RIHS01_" + "0" * 64
    return str(type_hash(get_service(type_name) if kind == "srv" else get_message(type_name)))


def _part(text: str) -> Any:
    """Read "teacher", or "pupil NAME"."""
    from day6_core.link.classroom.pupil import Pupil
    from day6_core.link.classroom.teacher import Teacher

    role, _, name = text.partition(" ")
    return {"teacher": Teacher, "pupil": lambda: Pupil(name), "": lambda: None}[role]()


def main() -> None:
    from day6_core.link import config, join

    if "TEST_LEASE" in os.environ:
        config._COMMON["transport/link/tx/lease"] = os.environ["TEST_LEASE"]
    graph = Graph(int(os.environ.get("ROS_DOMAIN_ID", "0")))
    addresses = json.loads(os.environ.get("TEST_ADDRESSES", "{}"))
    link = join(graph, **addresses, part=_part(os.environ.get("TEST_PART", "")))
    peer = Peer(graph)
    print(json.dumps({"problem": link.problem}), flush=True)
    for line in sys.stdin:
        name, positional, named = json.loads(line)
        print(json.dumps(getattr(peer, name)(*positional, **named)), flush=True)


if __name__ == "__main__":
    main()
