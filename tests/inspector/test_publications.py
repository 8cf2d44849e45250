"""Which publishers nobody heard because they were gone too soon, and which were only stopped early."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from day6_core.graph import Graph
from day6_core.graph.qos import QoS
from day6_core.ros.programs.day6_inspector.process_reports import Inside, ReportedProcess
from day6_core.ros.programs.day6_inspector.publications import Publications


def talker_that_said(count: int) -> ReportedProcess:
    inside = Inside("/talker", True, True, 0.0, 0, False, {"/chatter": count}, {})
    return ReportedProcess("1", 1, ("talker.py",), (inside,))


@pytest.mark.parametrize("clock", [time.monotonic, lambda: 7.0], ids=["fine", "coarse"])
@pytest.mark.parametrize(("said", "alarms"), [(1, ["/chatter"]), (2, ["/chatter"]), (3, [])])
def test_who_published_again_and_again_was_not_gone_too_soon(
    said: int, alarms: list[str], clock: Callable[[], float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(time, "monotonic", clock)
    graph = Graph()
    publications = Publications(graph)
    talker = graph.create_node("talker", origin=object())
    talker.create_publisher("/chatter", "std_msgs/msg/String", "RIHS01_0", QoS(depth=10), lambda message: message)
    publications.missed({}, (talker_that_said(said),))
    talker.destroy()
    listener = graph.create_node("listener")
    listener.create_subscription("/chatter", "std_msgs/msg/String", "RIHS01_0", QoS(depth=10))
    assert [topic for topic, node, seconds in publications.missed({}, ()) if seconds] == alarms
    publications.close()
