"""The rules: facts about a graph go in, findings come out. Pure; each rule is a function of its own.

A finding states a problem and its level: "error" keeps messages from arriving, "warning" is probably
unintended, "info" is worth knowing.
"""

from __future__ import annotations

import difflib
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from day6_tui.core.link.state import Door, DoorState, LinkState
from day6_tui.core.ros.programs.remark import Remark

SINGLE_VOICED = ("sensor_msgs/msg/JointState", "geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")
"""Types of which two publishers on one topic contradict each other."""

WATCHED_MOVING = ("sensor_msgs/msg/JointState", "tf2_msgs/msg/TFMessage", "turtlesim/msg/Pose", "nav_msgs/msg/Odometry")
"""Types that are watched as movement."""

SLOW_HZ = 10.0
ENOUGH = 0.9
"""Part of its speed that the world has to reach."""

OWN_TOPICS = ("/rosout", "/parameter_events", "/tf_static", "/robot_description", "/clock")
"""Topics that are often one-sided without anything being wrong."""

ORDER = {"error": 0, "warning": 1, "info": 2}


@dataclass(frozen=True)
class Endpoint:
    """A publisher or subscription: its node and type."""

    node: str
    type: str


@dataclass(frozen=True)
class Facts:
    """The facts about a graph, without hidden nodes and topics (with `_`)."""

    publishers: Mapping[str, tuple[Endpoint, ...]] = field(default_factory=dict)
    subscriptions: Mapping[str, tuple[Endpoint, ...]] = field(default_factory=dict)
    nodes: tuple[str, ...] = ()
    """Full names, one for each node, so that duplicates count."""
    deaf: tuple[tuple[str, str, str, str], ...] = ()
    """Pairs with incompatible QoS: topic, publisher's node, subscriber's node, the policy."""
    rates: Mapping[str, float] = field(default_factory=dict)
    """Messages a second of topics that are subscribed to."""
    joint_states: str = "/joint_states"
    heard_joints: tuple[str, ...] = ()
    """Names in the newest joint states."""
    joints: frozenset[str] | None = None
    """Names of the movable joints of the robot description; None while there is none."""
    link: LinkState = field(default_factory=LinkState)
    speed: float = 1.0
    """World seconds per real second that the user chose."""
    pace: float = 1.0
    """The same as it was lately, less what this computer was too slow for."""


class Finding(Remark):
    """One thing that is wrong."""


def findings(facts: Facts) -> list[Finding]:
    """Return everything that is wrong, the worst first."""
    found = [finding for rule in _RULES for finding in rule(facts)]
    return sorted(found, key=lambda finding: ORDER[finding.level])


def _finding(level: str, key: str, **parameters: object) -> Finding:
    return Finding.of(level, f"inspector.{key}", **parameters)


def _names(endpoints: tuple[Endpoint, ...]) -> str:
    return ", ".join(dict.fromkeys(endpoint.node for endpoint in endpoints))


def _mismatched_types(facts: Facts) -> Iterator[Finding]:
    for topic, publishers in facts.publishers.items():
        for publisher in dict.fromkeys(publishers):
            for subscription in dict.fromkeys(facts.subscriptions.get(topic, ())):
                if publisher.type != subscription.type:
                    yield _finding(
                        "error",
                        "types",
                        topic=topic,
                        publisher=publisher.node,
                        sent=publisher.type,
                        subscriber=subscription.node,
                        wanted=subscription.type,
                    )


def _mismatched_qos(facts: Facts) -> Iterator[Finding]:
    for topic, publisher, subscriber, policy in dict.fromkeys(facts.deaf):
        yield _finding("error", "qos", topic=topic, publisher=publisher, subscriber=subscriber, policy=policy)


def _one_sided(facts: Facts) -> Iterator[Finding]:
    """Topics with publishers or subscriptions only; if two such names are alike, the typo is reported instead of both."""
    quiet = (*OWN_TOPICS, "/tf")
    unsubscribed = [topic for topic in facts.publishers if topic not in facts.subscriptions and topic not in quiet]
    unpublished = [topic for topic in facts.subscriptions if topic not in facts.publishers and topic not in quiet]
    explained = set()
    for published in unsubscribed:
        for subscribed in unpublished:
            same = {endpoint.type for endpoint in facts.publishers[published]} & {
                endpoint.type for endpoint in facts.subscriptions[subscribed]
            }
            if same and _alike(published, subscribed):
                explained |= {published, subscribed}
                yield _finding("warning", "near", published=published, subscribed=subscribed)
    for topic in unpublished:
        if topic not in explained:
            yield _finding("warning", "unsaid", topic=topic, nodes=_names(facts.subscriptions[topic]))
    for topic in unsubscribed:
        if topic not in explained:
            yield _finding("info", "unheard", topic=topic, nodes=_names(facts.publishers[topic]))


def _alike(one: str, other: str) -> bool:
    """Whether two names differ only by a typo: a letter or two, or the namespace."""
    if one.rsplit("/", 1)[-1] == other.rsplit("/", 1)[-1]:
        return True
    return difflib.SequenceMatcher(None, one, other, autojunk=False).ratio() >= 0.8


def _fights(facts: Facts) -> Iterator[Finding]:
    for topic, publishers in facts.publishers.items():
        if len(publishers) > 1 and any(publisher.type in SINGLE_VOICED for publisher in publishers):
            yield _finding("warning", "fight", topic=topic, count=len(publishers), nodes=_names(publishers))


def _twins(facts: Facts) -> Iterator[Finding]:
    for name, count in Counter(facts.nodes).items():
        if count > 1:
            yield _finding("warning", "twins", name=name, count=count)


def _joints(facts: Facts) -> Iterator[Finding]:
    if facts.joints is None or not facts.heard_joints:
        return
    for joint in facts.heard_joints:
        if joint not in facts.joints:
            free = sorted(facts.joints - set(facts.heard_joints))
            near = difflib.get_close_matches(joint, free, 1, 0.5)
            if near:
                yield _finding("error", "unknown_joint_near", topic=facts.joint_states, joint=joint, nearest=near[0])
            else:
                yield _finding("error", "unknown_joint", topic=facts.joint_states, joint=joint)
    for joint in sorted(facts.joints - set(facts.heard_joints)):
        yield _finding("warning", "silent_joint", topic=facts.joint_states, joint=joint)


def _slow(facts: Facts) -> Iterator[Finding]:
    for topic, rate in facts.rates.items():
        moving = any(endpoint.type in WATCHED_MOVING for endpoint in facts.publishers.get(topic, ()))
        if moving and 0 < rate < SLOW_HZ:
            yield _finding("info", "slow", topic=topic, rate=f"{rate:.1f}".rstrip("0").rstrip("."))


def _late(facts: Facts) -> Iterator[Finding]:
    if facts.pace < ENOUGH * facts.speed:
        yield _finding("warning", "late", pace=f"{facts.pace:.2g}", speed=f"{facts.speed:g}")


_SHUT = {DoorState.IN_USE: "in_use", DoorState.NO_NAME: "no_name", DoorState.FAILED: "shut"}
_UNJOINED = {
    DoorState.NO_NAME: "no_name",
    DoorState.NOBODY: "nobody",
    DoorState.NO_ANSWER: "no_answer",
    DoorState.FAILED: "unreachable",
}


def link_findings(link: LinkState) -> Iterator[Finding]:
    """Yield the findings about other processes and machines, including that the link is open to others."""
    if link.problem is not None:
        yield _finding("warning", "alone", reason=link.problem)
    for reason in link.passed_over:
        yield _finding("info", "elsewhere", reason=reason)
    yield from map(_door, link.doors)
    refused = Counter(link.refused)
    others = {key: refused.pop(key, 0) for key in ("names", "messages", "sessions")}
    for key, count in {"many": refused.total(), **others}.items():
        if count:
            yield _finding("warning", f"refused_{key}", count=count)


def _door(door: Door) -> Finding:
    endpoint = door.endpoint
    if door.state == DoorState.OPEN:
        if not door.listening:
            return _finding("info", "joined", endpoint=endpoint)
        return _finding("info", "open_secret" if door.secret else "open", endpoint=endpoint, joined=door.joined)
    if door.state == DoorState.OPENING:
        return _finding("info", "opening" if door.listening else "calling", endpoint=endpoint)
    if door.state == DoorState.NOT_LET_IN:
        return _finding("error", "wrong_secret" if door.secret else "no_secret", endpoint=endpoint)
    key = (_SHUT if door.listening else _UNJOINED)[door.state]
    reason = {"reason": door.reason} if door.state == DoorState.FAILED else {}
    return _finding("error", key, endpoint=endpoint, **reason)


def _link(facts: Facts) -> Iterator[Finding]:
    return link_findings(facts.link)


_RULES = (_link, _mismatched_types, _mismatched_qos, _joints, _fights, _twins, _one_sided, _slow, _late)
