"""All combinations of rqt_graph's controls, against node and edge sets computed one name at a time from the rules."""

from __future__ import annotations

from itertools import product

import pytest

from day6_core.ros.programs.rqt_graph.model.content import (
    QUIET_EDGES,
    QUIET_NAMES,
    GraphContent,
    GraphOptions,
    GraphType,
    namespace_of,
    select,
)
from tests.rqt_graph.one_graph import FACTS, shown

NODES = {node for table in (FACTS.publishers, FACTS.subscribers) for names in table.values() for node in names}
TOPICS = {*FACTS.publishers, *FACTS.subscribers}
CAMERA = {"/cam/image", "/cam/image/compressed", "/cam/image/theora"}
DOCK = {topic for topic in TOPICS if topic.startswith("/dock/")}


def ends(topic: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    return FACTS.publishers.get(topic, ()), FACTS.subscribers.get(topic, ())


def is_quiet(name: str) -> bool:
    return any(quiet in name for quiet in QUIET_NAMES) or name.split("/")[-1].startswith("_")


def kept_topics(options: GraphOptions) -> set[str]:
    """Topics that no topic option hides."""
    kept = set()
    for topic in TOPICS:
        senders, hearers = ends(topic)
        hidden = (
            (options.hide_dead_sinks and not hearers)
            or (options.hide_leaf_topics and len(senders) + len(hearers) < 2)
            or (options.hide_tf and topic in ("/tf", "/tf_static"))
            or (options.hide_params and topic.endswith("/parameter_events"))
        )
        if not hidden:
            kept.add(topic)
    return kept


def nodes_only(options: GraphOptions) -> tuple[set[str], set[tuple[str, str, str]]]:
    nodes = {node for node in NODES if not (options.hide_debug and is_quiet(node))}
    return nodes, {
        (sender, hearer, topic)
        for topic in kept_topics(options)
        if not (options.hide_debug and topic in QUIET_EDGES)
        for sender, hearer in product(*ends(topic))
        if {sender, hearer} <= nodes
    }


def nodes_and_topics(options: GraphOptions) -> tuple[set[str], set[tuple[str, str, str]]]:
    kept = kept_topics(options)
    group = {}
    if options.group_images and len(CAMERA & kept) >= 3:
        group.update(dict.fromkeys(CAMERA, "/cam/image/image_topics"))
    if options.group_actions and kept >= DOCK:
        group.update(dict.fromkeys(DOCK, "/dock/action_topics"))
    if options.group_tf and not options.hide_tf:
        group.update({"/tf": "/tf", "/tf_static": "/tf"})
    nodes = {node for node in NODES if not (options.hide_debug and is_quiet(node))}
    topics = {topic for topic in kept if not (options.hide_debug and is_quiet(topic))}
    edges = set()
    for topic in topics:
        senders, hearers = ends(topic)
        edges |= {(sender, group.get(topic, topic), "") for sender in senders if sender in nodes}
        edges |= {(group.get(topic, topic), hearer, "") for hearer in hearers if hearer in nodes}
    return nodes | {name for edge in edges for name in edge[:2]}, edges


@pytest.mark.parametrize("graph_type", list(GraphType))
@pytest.mark.parametrize("groups", list(product((True, False), repeat=3)))
def test_every_combination_of_the_controls_shows_what_the_rules_say(
    graph_type: GraphType, groups: tuple[bool, bool, bool]
) -> None:
    expected = nodes_only if graph_type is GraphType.NODES else nodes_and_topics
    for hides in product((True, False), repeat=5):
        names = ("hide_dead_sinks", "hide_leaf_topics", "hide_debug", "hide_tf", "hide_params")
        switches = dict(zip(("group_actions", "group_tf", "group_images"), groups, strict=True))
        options = GraphOptions(graph_type, **switches, **dict(zip(names, hides, strict=True)))
        assert shown(select(FACTS, options)) == expected(options), options


@pytest.mark.parametrize(
    ("name", "depth", "namespace"),
    [
        ("/turtlesim", 2, ""),
        ("/turtle1/pose", 2, "/turtle1"),
        ("/a/b/c/d", 1, "/a"),
        ("/a/b/c/d", 2, "/a/b"),
        ("/a/b/c/d", 9, "/a/b/c"),
        ("/a/b", 0, ""),
    ],
)
def test_namespace_boxes_nest_up_to_the_number_asked_for(name: str, depth: int, namespace: str) -> None:
    assert namespace_of(name, depth) == namespace
    content = select(
        GraphContent({name: ("/talker",)}, {name: ("/listener",)}), GraphOptions(GraphType.ALL, namespaces=depth)
    )
    assert {box.cluster for box in content.boxes if box.shape == "topic"} == {namespace}
