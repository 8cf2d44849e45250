"""Nodes that only look on, across the link: they hear other processes, which name and count them nowhere."""

from __future__ import annotations

from typing import Any

from day6_core.graph.names import OBSERVER_PREFIX
from tests.support.waiting import until


def test_an_observer_hears_another_process_and_is_not_in_its_lists(pair: tuple[Any, Any]) -> None:
    near, far = pair
    publisher = far.publisher(far.node("talker"), "/chatter")
    heard = near.subscription(near.node(f"{OBSERVER_PREFIX}_1"), "/chatter")
    other = near.subscription(near.node("listener"), "/chatter")
    assert until(lambda: far.matched(publisher) == 1 and "/listener" in far.nodes())

    def arrives() -> bool:
        far.publish(publisher, data="hello")
        return bool(near.messages(heard))

    assert until(arrives)
    assert until(lambda: "/talker" in near.nodes())  # a message may come first
    assert far.nodes() == near.nodes() == ["/listener", "/talker"]
    assert far.matched(publisher) == 1
    near.destroy(other)
    assert until(lambda: far.matched(publisher) == 0)
    assert until(arrives), "it is sent although nobody is counted"
