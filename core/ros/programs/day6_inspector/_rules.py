"""The rules: facts about a graph go in, findings come out. Pure; each rule is a function of its own.

A finding names what it is about and how sure that is trouble: "error" keeps messages from arriving, "warning" is probably
not meant so, "info" is worth knowing.
"""

from __future__ import annotations

import difflib
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from day6_tui.core.link.state import Door, DoorState, LinkState
from day6_tui.core.ros.programs._remark import Remark

TEXTS = {
    "inspector.unheard": "{topic}: {nodes} publishes, nobody listens",
    "inspector.unsaid": "{topic}: {nodes} listens, nobody publishes",
    "inspector.near": "{said} is published and {heard} is listened to: is one of the names a slip?",
    "inspector.types": "{topic}: {publisher} sends {sent}, {subscriber} wants {wanted}; nothing arrives",
    "inspector.qos": "{topic}: the QoS of {publisher} does not suit {subscriber} ({policy}); nothing arrives",
    "inspector.fight": "{topic}: {count} nodes publish at the same time and fight over it: {nodes}",
    "inspector.twins": "{count} nodes are called {name}: lists and parameters cannot tell them apart",
    "inspector.unknown_joint": "{topic} names the joint {joint}, which the robot description does not have",
    "inspector.unknown_joint_near": (
        "{topic} names the joint {joint}, which the robot description does not have; did you mean {nearest}?"
    ),
    "inspector.silent_joint": "the joint {joint} can move, but nobody sends its position on {topic}",
    "inspector.slow": "{topic} comes {rate} times a second; the eye needs about 20",
    "inspector.open": (
        "{endpoint} is open, {joined} joined; there is no secret: anyone who reaches this port can read and command"
    ),
    "inspector.open_secret": "{endpoint} is open to who knows the secret, {joined} joined",
    "inspector.opening": "{endpoint} is about to be opened",
    "inspector.in_use": "{endpoint}: another program has this port, so no other machine can join; tried again",
    "inspector.no_name": "{endpoint}: nobody knows this name; tried again",
    "inspector.shut": "{endpoint} cannot be opened ({reason}), so no other machine can join; tried again",
    "inspector.calling": "{endpoint} is being called",
    "inspector.joined": "joined to {endpoint}",
    "inspector.nobody": "no answer from {endpoint}: the machine is there, but no program listens on this port; tried again",
    "inspector.no_answer": "no answer from {endpoint}; tried again",
    "inspector.wrong_secret": "refused by {endpoint}: wrong secret, or it asks for none",
    "inspector.no_secret": "refused by {endpoint}: it asks for a secret, or it is no ROS",
    "inspector.unreachable": "{endpoint} cannot be called ({reason}); tried again",
    "inspector.alone": "programs of other processes cannot be seen: {reason}",
    "inspector.elsewhere": "another folder than usual is used to meet other processes: {reason}",
    "inspector.refused_many": "{count} announcements of other processes were refused: there are too many",
    "inspector.refused_names": "{count} announcements of other processes were refused: ROS allows no such names",
    "inspector.refused_messages": "{count} messages of other processes could not be read and were dropped",
    "inspector.refused_sessions": "{count} things from other machines were refused: they claim to come from this one",
    "inspector.well": "nothing is wrong",
}
"""English texts by id; names stand in the parameters as they are."""

SINGLE_VOICED = ("sensor_msgs/msg/JointState", "geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")
"""Types of which two publishers on one topic contradict each other."""

WATCHED_MOVING = ("sensor_msgs/msg/JointState", "tf2_msgs/msg/TFMessage", "turtlesim/msg/Pose", "nav_msgs/msg/Odometry")
"""Types that are looked at as movement."""

SLOW_HZ = 10.0
OWN_TOPICS = ("/rosout", "/parameter_events", "/tf_static", "/robot_description", "/clock")
"""Topics that are often one-sided without anything being wrong."""

ORDER = {"error": 0, "warning": 1, "info": 2}


@dataclass(frozen=True)
class End:
    """A publisher or subscription: its node and type."""

    node: str
    type: str


@dataclass(frozen=True)
class Facts:
    """What is known of a graph, without what is hidden (nodes and topics with `_`)."""

    publishers: Mapping[str, tuple[End, ...]] = field(default_factory=dict)
    subscriptions: Mapping[str, tuple[End, ...]] = field(default_factory=dict)
    nodes: tuple[str, ...] = ()
    """Full names, as often as there are nodes of that name."""
    deaf: tuple[tuple[str, str, str, str], ...] = ()
    """Pairs whose QoS do not suit each other: topic, publisher's node, subscriber's node, the policy."""
    rates: Mapping[str, float] = field(default_factory=dict)
    """Messages a second of topics that were heard."""
    joint_states: str = "/joint_states"
    heard_joints: tuple[str, ...] = ()
    """Names in the newest joint states."""
    joints: frozenset[str] | None = None
    """Names of the movable joints of the robot description; None while there is none."""
    link: LinkState = field(default_factory=LinkState)


class Finding(Remark):
    """One thing that is wrong."""

    TEXTS = TEXTS


def findings(facts: Facts) -> list[Finding]:
    """Return everything that is wrong, the worst first."""
    found = [finding for rule in _RULES for finding in rule(facts)]
    return sorted(found, key=lambda finding: ORDER[finding.level])


def _finding(level: str, key: str, **parameters: object) -> Finding:
    return Finding.of(level, f"inspector.{key}", **parameters)


def _names(ends: tuple[End, ...]) -> str:
    return ", ".join(dict.fromkeys(end.node for end in ends))


def _mismatched_types(facts: Facts) -> Iterator[Finding]:
    for topic, senders in facts.publishers.items():
        for sender in dict.fromkeys(senders):
            for hearer in dict.fromkeys(facts.subscriptions.get(topic, ())):
                if sender.type != hearer.type:
                    yield _finding(
                        "error",
                        "types",
                        topic=topic,
                        publisher=sender.node,
                        sent=sender.type,
                        subscriber=hearer.node,
                        wanted=hearer.type,
                    )


def _mismatched_qos(facts: Facts) -> Iterator[Finding]:
    for topic, publisher, subscriber, policy in dict.fromkeys(facts.deaf):
        yield _finding("error", "qos", topic=topic, publisher=publisher, subscriber=subscriber, policy=policy)


def _one_sided(facts: Facts) -> Iterator[Finding]:
    """Topics with one side only; where two such are alike, the slip is named instead of both."""
    quiet = (*OWN_TOPICS, "/tf")
    unheard = [topic for topic in facts.publishers if topic not in facts.subscriptions and topic not in quiet]
    unsaid = [topic for topic in facts.subscriptions if topic not in facts.publishers and topic not in quiet]
    explained = set()
    for said in unheard:
        for heard in unsaid:
            same = {end.type for end in facts.publishers[said]} & {end.type for end in facts.subscriptions[heard]}
            if same and _alike(said, heard):
                explained |= {said, heard}
                yield _finding("warning", "near", said=said, heard=heard)
    for topic in unsaid:
        if topic not in explained:
            yield _finding("warning", "unsaid", topic=topic, nodes=_names(facts.subscriptions[topic]))
    for topic in unheard:
        if topic not in explained:
            yield _finding("info", "unheard", topic=topic, nodes=_names(facts.publishers[topic]))


def _alike(one: str, other: str) -> bool:
    """Say whether two names differ by a slip: a letter or two, or the namespace in front."""
    if one.rsplit("/", 1)[-1] == other.rsplit("/", 1)[-1]:
        return True
    return difflib.SequenceMatcher(None, one, other, autojunk=False).ratio() >= 0.8


def _fights(facts: Facts) -> Iterator[Finding]:
    for topic, senders in facts.publishers.items():
        if len(senders) > 1 and any(sender.type in SINGLE_VOICED for sender in senders):
            yield _finding("warning", "fight", topic=topic, count=len(senders), nodes=_names(senders))


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
        moving = any(end.type in WATCHED_MOVING for end in facts.publishers.get(topic, ()))
        if moving and 0 < rate < SLOW_HZ:
            yield _finding("info", "slow", topic=topic, rate=f"{rate:.1f}".rstrip("0").rstrip("."))


_SHUT = {DoorState.IN_USE: "in_use", DoorState.NO_NAME: "no_name", DoorState.FAILED: "shut"}
_UNJOINED = {
    DoorState.NO_NAME: "no_name",
    DoorState.NOBODY: "nobody",
    DoorState.NO_ANSWER: "no_answer",
    DoorState.FAILED: "unreachable",
}


def link_findings(link: LinkState) -> Iterator[Finding]:
    """Yield what there is to say of other processes and machines: also that a door is open, whoever may use it."""
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


_RULES = (_link, _mismatched_types, _mismatched_qos, _joints, _fights, _twins, _one_sided, _slow)
