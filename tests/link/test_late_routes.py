"""Who was announced may not be reachable yet: on a slow machine, and between machines, a route can come after the token."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from typing import Any

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

pytestmark = pytest.mark.process

AFTER_THE_FIRST_MESSAGE = 0.4
AFTER_SOME_REQUESTS = 2.5
"""Seconds until there is a route."""


@pytest.fixture
def publisher_side(world: World) -> Any:
    return world.process()


@pytest.fixture
def session(world: World, publisher_side: Any) -> Iterator[Any]:
    """A session of the meeting place that declares by hand what a link declares by itself."""
    import zenoh

    with zenoh.open(command_config(meeting_place(0), new_zid())) as opened:
        yield opened


@pytest.fixture
def unheard_of() -> Peer:
    """Endpoints whose tokens and keys are taken from here; it has no link."""
    return Peer(Graph())


def announce(session: Any, peer: Peer, *handles: int) -> list[Any]:
    zid = str(session.zid())
    tokens = [endpoint_token(peer.things[handle], zid) for handle in handles]
    return [session.liveliness().declare_token(token) for token in tokens]


def test_the_first_message_waits_for_a_subscription_that_was_announced(
    publisher_side: Any, session: Any, unheard_of: Peer
) -> None:
    subscription = unheard_of.subscription(unheard_of.node("listener"), "/chatter")
    heard: list[str] = []
    String = get_message("std_msgs/msg/String")
    declared: list[Any] = []

    def declare() -> None:
        time.sleep(AFTER_THE_FIRST_MESSAGE)
        declared.append(
            session.declare_subscriber(
                data_key(unheard_of.things[subscription]),
                lambda sample: heard.append(deserialize(sample.payload.to_bytes(), String).data),
            )
        )

    publisher = publisher_side.publisher(publisher_side.node("talker"), "/chatter")
    _tokens = announce(session, unheard_of, subscription)
    assert until(lambda: publisher_side.matched(publisher) == 1)
    declaring = threading.Thread(target=declare)
    declaring.start()
    publisher_side.publish_numbers(publisher, 1, 3)
    declaring.join()
    assert until(lambda: len(heard) >= 3, told=lambda: heard) and heard == ["1", "2", "3"]


def test_a_request_is_sent_again_until_there_is_a_route_to_the_server(
    publisher_side: Any, session: Any, unheard_of: Peer
) -> None:
    service = unheard_of.service(unheard_of.node("server"), "/add")
    key = data_key(unheard_of.things[service])
    response = serialize(get_service("example_interfaces/srv/AddTwoInts").Response(sum=3))

    def answer(query: Any) -> None:
        with query:
            query.reply(key, response, attachment=pack(1, 1, query.attachment.to_bytes()[-16:]))

    client = publisher_side.client(publisher_side.node("asker"), "/add")
    _tokens = announce(session, unheard_of, service)
    assert until(lambda: publisher_side.matched(client) == 1)
    number = publisher_side.call(client, 1, 2)
    time.sleep(AFTER_SOME_REQUESTS)
    _server = session.declare_queryable(key, answer, complete=True)
    assert number == 1 and until(lambda: publisher_side.responses(client) == [[1, 3]])
