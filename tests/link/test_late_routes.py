"""Whoever was announced may not be reachable yet: on a slow machine, and between machines, a route can come after the token."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import pytest

from day6_core.graph import Graph
from day6_core.interfaces import deserialize, get_message, get_service, serialize
from day6_core.link.attachment import pack
from day6_core.link.config import command_config
from day6_core.link.keys import data_key, endpoint_token, new_zid
from day6_core.link.paths import meeting_place
from tests.link.link_harness import World
from tests.link.link_peer import Peer
from tests.support.waiting import until

if TYPE_CHECKING:
    import zenoh

pytestmark = pytest.mark.process

AFTER_THE_FIRST_MESSAGE = 0.3
AFTER_SOME_REQUESTS = 2.5
"""Seconds until there is a route. A message is waited with for two, a request repeated for half a minute (`test_carriers`)."""


@pytest.fixture
def program(world: World) -> Any:
    """Publishes and asks."""
    return world.process()


@pytest.fixture
def session(program: Any) -> Iterator[zenoh.Session]:
    """A session of the meeting place, in which a test declares by hand what a link declares by itself."""
    import zenoh

    with zenoh.open(command_config(meeting_place(0), new_zid())) as opened:
        yield opened


@pytest.fixture
def unheard_of() -> Peer:
    """Endpoints whose tokens and keys are taken from here; it has no link."""
    return Peer(Graph())


def announce(session: zenoh.Session, peer: Peer, handle: int) -> zenoh.LivelinessToken:
    """Declare an endpoint's token, which lasts as long as it is kept."""
    return session.liveliness().declare_token(endpoint_token(peer.things[handle], str(session.zid())))


def test_the_first_message_waits_for_a_subscription_that_was_announced(
    program: Any, session: zenoh.Session, unheard_of: Peer
) -> None:
    subscription = unheard_of.subscription(unheard_of.node("listener"), "/chatter")
    key, String = data_key(unheard_of.things[subscription]), get_message("std_msgs/msg/String")
    heard: list[str] = []
    subscribers: list[zenoh.Subscriber[None]] = []

    def hear(sample: zenoh.Sample) -> None:
        heard.append(deserialize(sample.payload.to_bytes(), String).data)

    publisher = program.publisher(program.node("talker"), "/chatter")
    _token = announce(session, unheard_of, subscription)
    assert until(lambda: program.matched(publisher) == 1)
    late = threading.Timer(AFTER_THE_FIRST_MESSAGE, lambda: subscribers.append(session.declare_subscriber(key, hear)))
    late.start()
    program.publish_numbers(publisher, 1, 3)
    late.join()
    assert until(lambda: len(heard) >= 3, told=lambda: heard) and heard == ["1", "2", "3"]


def test_a_request_is_sent_again_until_there_is_a_route_to_the_server(
    program: Any, session: zenoh.Session, unheard_of: Peer
) -> None:
    service = unheard_of.service(unheard_of.node("server"), "/add")
    key = data_key(unheard_of.things[service])
    response = serialize(get_service("example_interfaces/srv/AddTwoInts").Response(sum=3))

    def answer(query: zenoh.Query) -> None:
        with query:
            query.reply(key, response, attachment=pack(1, 1, query.attachment.to_bytes()[-16:]))

    client = program.client(program.node("asker"), "/add")
    _token = announce(session, unheard_of, service)
    assert until(lambda: program.matched(client) == 1)
    number = program.call(client, 1, 2)
    time.sleep(AFTER_SOME_REQUESTS)
    _server = session.declare_queryable(key, answer, complete=True)
    assert number == 1 and until(lambda: program.responses(client) == [[1, 3]])
