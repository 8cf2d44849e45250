"""Counting what other processes send each other: nobody notices it, and nothing else is counted."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.graph import EndpointKind
from day6_core.link import listen_in
from tests.link.link_harness import World
from tests.support.waiting import until

pytestmark = pytest.mark.process


def publisher_of(peer: Any, topic: str) -> Any:
    found = peer.graph.endpoints(EndpointKind.PUBLISHER, topic=topic)
    return found[0] if found else None


def test_messages_between_two_other_processes_are_counted_and_nobody_notices(world: World) -> None:
    here, talker, listener = world.here(), world.process(), world.process()
    says = talker.publisher(talker.node("talker"), "/chatter", depth=100)
    hears = listener.subscription(listener.node("listener"), "/chatter", depth=100)
    other = talker.publisher(talker.node("talker2"), "/chatter", depth=100)
    last = talker.publisher(talker.node("talker3"), "/chatter", depth=100)
    assert until(lambda: talker.matched(says) == talker.matched(last) == listener.matched(hears) - 2 == 1)
    assert until(lambda: len(here.graph.endpoints(EndpointKind.PUBLISHER, topic="/chatter")) == 3)
    assert until(lambda: here.graph.endpoints(EndpointKind.SUBSCRIPTION, topic="/chatter"))
    before = talker.endpoints("/chatter"), listener.endpoints("/chatter"), listener.nodes()
    found = {each.node.name: each for each in here.graph.endpoints(EndpointKind.PUBLISHER, topic="/chatter")}
    first, third = found["talker"], found["talker3"]
    passing = listen_in(here.graph)
    assert passing is not None and passing.count(first) is None
    passing.follow([first, third])
    assert until(lambda: passing.count(first) == passing.count(third) == 0)
    sent = 0

    def heard() -> bool:
        nonlocal sent
        talker.publish(says, data=f"{sent}")
        talker.publish(other, data="not followed")
        sent += 1
        return bool(passing.count(first))

    assert until(heard), "as soon as Zenoh knows the way"
    talker.publish(last, data="behind them all")
    assert until(lambda: passing.count(third) == 1), "and before it came what was sent meanwhile"
    now = passing.count(first)
    assert now is not None
    for number in range(50):
        talker.publish(says, data=f"more {number}")
    talker.publish(last, data="behind them all")
    assert until(lambda: passing.count(third) == 2) and passing.count(first) == now + 50
    assert (talker.endpoints("/chatter"), listener.endpoints("/chatter"), listener.nodes()) == before
    assert not here.graph.endpoints(EndpointKind.SUBSCRIPTION, topic="/chatter")[0].matched
    assert first.delivered == 0 and talker.matched(says) == 1
    passing.follow([])
    assert until(lambda: passing.count(first) is None)
    passing.close()
    passing.close()


def test_a_link_that_closes_ends_the_counting(world: World) -> None:
    from day6_core.link import leave

    here, talker, listener = world.here(), world.process(), world.process()
    talker.publisher(talker.node("talker"), "/chatter")
    listener.subscription(listener.node("listener"), "/chatter")
    assert until(lambda: publisher_of(here, "/chatter") is not None)
    passing, publisher = listen_in(here.graph), publisher_of(here, "/chatter")
    assert passing is not None
    passing.follow([publisher])
    assert until(lambda: passing.count(publisher) == 0)
    leave(here.graph)
    assert passing.closed and passing.count(publisher) is None
    passing.follow([publisher])
    assert passing.count(publisher) is None and listen_in(here.graph) is None
