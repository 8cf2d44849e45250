"""Checks of the graph: nodes, topics, services, actions, parameters, transforms."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.texts import Say

if TYPE_CHECKING:
    from day6_core.lessons.live import Live

_QUIET = ("/parameter_events", "/rosout")


@check("node", names=("name",))
def node(live: Live, name: str, count: int = 1) -> Verdict:
    nodes = live.nodes()
    found = nodes.count(name)
    wanted = Say("node", name=name) if count == 1 else Say("node.count", name=name, count=count)
    if not found:
        return Verdict(False, wanted, Say("node.saw", name=name, nodes=tuple(dict.fromkeys(nodes))))
    ok = found >= count
    return Verdict(ok, wanted, None if ok else Say("node.saw_count", found=found))


@check("no_node", names=("name",))
def no_node(live: Live, name: str) -> Verdict:
    ok = name not in live.nodes()
    return Verdict(ok, Say("no_node", name=name), None if ok else Say("no_node.saw", name=name))


@check("topic", names=("name",))
def topic(live: Live, name: str, type_: str = "", publishers: int = 0, subscribers: int = 0) -> Verdict:
    topics = live.topics()
    ends = Say("topic.ends", name=name, publishers=publishers, subscribers=subscribers)
    wanted = (
        Say("topic.type", name=name, type=type_)
        if type_
        else ends
        if publishers or subscribers
        else Say("topic", name=name)
    )
    if name not in topics:
        shown = tuple(each for each in topics if each not in _QUIET)
        return Verdict(False, wanted, Say("topic.saw", name=name, topics=shown))
    if type_ and topics[name] != [type_]:
        return Verdict(False, wanted, Say("topic.saw_type", types=tuple(topics[name])))
    offers, requests = len(live.publishers(name)), len(live.subscribers(name))
    if offers < publishers or requests < subscribers:
        return Verdict(False, ends, Say("topic.saw_ends", publishers=offers, subscribers=requests))
    return Verdict(True, wanted)


@check("no_topic", names=("name",))
def no_topic(live: Live, name: str) -> Verdict:
    users = [*live.publishers(name), *live.subscribers(name)]
    saw = Say("no_topic.saw", nodes=tuple(dict.fromkeys(users))) if users else None
    return Verdict(not users, Say("no_topic", name=name), saw)


@check("publishers", names=("topic",))
def publishers(live: Live, topic: str, count: int = 1) -> Verdict:
    nodes = live.publishers(topic)
    ok = len(nodes) == count
    saw = None if ok else Say("publishers.saw", found=len(nodes), nodes=tuple(nodes))
    return Verdict(ok, Say("publishers", topic=topic, count=count), saw)


@check("service", names=("name",))
def service(live: Live, name: str) -> Verdict:
    ok = bool(live.servers(name))
    return Verdict(ok, Say("service", name=name), None if ok else Say("service.saw", name=name))


@check("action", names=("name",))
def action(live: Live, name: str) -> Verdict:
    ok = bool(live.servers(f"{name}/_action/send_goal"))
    return Verdict(ok, Say("action", name=name), None if ok else Say("service.saw", name=name))


@check("parameter", names=("node",))
def parameter(live: Live, node: str, name: str, equals: Any) -> Verdict:
    wanted = Say("parameter", node=node, name=name, value=equals)
    if node not in live.nodes():
        return Verdict(False, wanted, Say("parameter.no_node", node=node))
    answered, value = live.parameter(node, name)
    if not answered:
        return Verdict(False, wanted, Say("parameter.silent", node=node))
    ok = same(value, equals)
    return Verdict(ok, wanted, None if ok else Say("parameter.saw", found=value))


@check("transform")
def transform(live: Live, to: str, from_: str) -> Verdict:
    from rclpy.time import Time

    wanted = Say("transform", to=to, frame=from_)
    buffer = live.remembered.setdefault("buffer", _new_buffer())
    read = live.remembered.setdefault("read", {"/tf": 0, "/tf_static": 0})
    for topic_name in read:
        heard = live.heard(topic_name)
        for _, message in heard.since(read[topic_name]):
            for each in getattr(message, "transforms", ()):
                _put(buffer, each, topic_name == "/tf_static")
        read[topic_name] = heard.count
    if buffer.can_transform(to, from_, Time()):
        return Verdict(True, wanted)
    frames = sorted(buffer._getFrameStrings()) if hasattr(buffer, "_getFrameStrings") else []
    return Verdict(False, wanted, Say("transform.saw", frames=tuple(frames)))


def _new_buffer() -> Any:
    from tf2_ros.buffer import Buffer

    return Buffer()


def _put(buffer: Any, transform: Any, static: bool) -> None:
    (buffer.set_transform_static if static else buffer.set_transform)(transform, "lesson")


def same(value: Any, wanted: Any) -> bool:
    """Whether a value of a message or parameter is the one that a lesson names."""
    if isinstance(value, bool) or isinstance(wanted, bool) or not isinstance(value, (int, float)):
        if hasattr(value, "tolist"):
            value = value.tolist()
        if isinstance(value, (list, tuple)) and isinstance(wanted, (list, tuple)):
            return len(value) == len(wanted) and all(map(same, value, wanted))
        return bool(value == wanted)
    if isinstance(wanted, (int, float)):
        return abs(value - wanted) <= 1e-6 * max(1.0, abs(wanted))
    return False
