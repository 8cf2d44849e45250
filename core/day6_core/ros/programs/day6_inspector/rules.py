"""The rules: facts go in, findings come out. Pure; each rule is a function of its own. Those about the graph are here.

Those about what terminals print are in `output_rules`, about files in `file_rules`, about the insides of programs in
`program_rules`, about the robot, RViz and the world in `robot_rules`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from day6_core.facts.graph import NodeAndType as NodeAndType
from day6_core.facts.graph import node_names
from day6_core.facts.names import are_alike
from day6_core.link.state import Door, DoorState, LinkState
from day6_core.ros.differences import value
from day6_core.ros.programs.day6_inspector.facts import Facts as Facts
from day6_core.ros.programs.day6_inspector.file_rules import of_files
from day6_core.ros.programs.day6_inspector.finding import ORDER, finding
from day6_core.ros.programs.day6_inspector.finding import Finding as Finding
from day6_core.ros.programs.day6_inspector.message_rules import (
    of_frames,
    of_messages,
    of_positions,
    of_rival_descriptions,
    of_stamps,
    of_transforms,
)
from day6_core.ros.programs.day6_inspector.output_rules import of_outputs
from day6_core.ros.programs.day6_inspector.program_rules import of_domains, of_ended, of_programs
from day6_core.ros.programs.day6_inspector.robot_rules import (
    of_description,
    of_joints,
    of_missing_joints,
    of_rviz,
    of_world,
    waits_for_joints,
)
from day6_core.ros.programs.day6_inspector.sight import Rule, looks_at

SINGLE_VOICED = (
    "sensor_msgs/msg/JointState",
    "geometry_msgs/msg/Twist",
    "geometry_msgs/msg/TwistStamped",
    "nav_msgs/msg/Odometry",
    "rosgraph_msgs/msg/Clock",
)
"""Types of which two publishers on one topic contradict each other."""

WATCHED_MOVING = (
    "sensor_msgs/msg/JointState",
    "tf2_msgs/msg/TFMessage",
    f"{value('turtlesim.interfaces')}/msg/Pose",
    "nav_msgs/msg/Odometry",
)
"""Types that are watched as movement."""

CLOCK = "/clock"
SLOW_HZ = 10.0
ENOUGH = 0.9
"""Part of its speed that the world has to reach."""

OWN_TOPICS = ("/rosout", "/parameter_events", "/tf_static", "/robot_description", "/clock")
"""Topics that are often one-sided without anything being wrong."""

RVIZ_TOOLS = ("/clicked_point", "/goal_pose", "/initialpose")
"""The topics of RViz's tools, as its default configuration names them."""


def findings(facts: Facts) -> list[Finding]:
    """Return everything that is wrong, the worst first, each once."""
    found = dict.fromkeys(each for rule in RULES for each in rule(facts))
    return sorted(found, key=lambda each: ORDER[each.level])


@looks_at("topics")
def _mismatched_types(facts: Facts) -> Iterator[Finding]:
    for topic, publishers in facts.publishers.items():
        for publisher in dict.fromkeys(publishers):
            for subscription in dict.fromkeys(facts.subscriptions.get(topic, ())):
                if publisher.type != subscription.type:
                    yield finding(
                        "error",
                        "types",
                        topic=topic,
                        publisher=publisher.node,
                        sent=publisher.type,
                        subscriber=subscription.node,
                        wanted=subscription.type,
                        then=f"ros2 topic info -v {topic}",
                    )


@looks_at("topics")
def _mixed_types(facts: Facts) -> Iterator[Finding]:
    """Publishers of two types on one topic, where no subscription shows it already."""
    for topic, publishers in facts.publishers.items():
        types = dict.fromkeys(each.type for each in publishers)
        if len(types) > 1 and topic not in facts.subscriptions:
            then = f"ros2 topic info -v {topic}"
            yield finding(
                "error", "mixed_types", topic=topic, types=", ".join(types), nodes=node_names(publishers), then=then
            )


@looks_at("topics")
def _mismatched_qos(facts: Facts) -> Iterator[Finding]:
    for topic, publisher, subscriber, policy in dict.fromkeys(facts.deaf):
        said = {"topic": topic, "publisher": publisher, "subscriber": subscriber, "policy": policy}
        yield finding("error", "qos", **said, then=f"ros2 topic info -v {topic}")


@looks_at("topics")
def _one_sided(facts: Facts) -> Iterator[Finding]:
    """Topics with publishers or subscriptions only; if two such names are alike, the typo is reported instead of both."""
    quiet = (*OWN_TOPICS, "/tf")
    unsubscribed = [topic for topic in facts.publishers if topic not in facts.subscriptions and topic not in quiet]
    unpublished = [topic for topic in facts.subscriptions if topic not in facts.publishers and topic not in quiet]
    explained = {facts.joint_states} if waits_for_joints(facts) else set()
    for published in unsubscribed:
        for subscribed in unpublished:
            same = {endpoint.type for endpoint in facts.publishers[published]} & {
                endpoint.type for endpoint in facts.subscriptions[subscribed]
            }
            if same and are_alike(published, subscribed) and not _relays(facts, subscribed, published):
                explained |= {published, subscribed}
                yield finding("warning", "near", published=published, subscribed=subscribed, then="ros2 topic list -v")
    for topic in unpublished:
        if topic not in explained:
            then = f"ros2 topic info -v {topic}"
            wanted = {each.type for each in facts.subscriptions[topic]}
            nodes = {each.node for each in facts.subscriptions[topic]}
            sent = any(
                each.type in wanted and {each.node} != nodes
                for other in unsubscribed
                for each in facts.publishers[other]
            )
            # Turtlesim without anybody who drives it is no fault; one who sends the same elsewhere may be.
            yield finding(
                "warning" if sent else "info",
                "unsaid",
                topic=topic,
                nodes=node_names(facts.subscriptions[topic]),
                then=then,
            )
    for topic in unsubscribed:
        if topic not in explained and not _by_rviz_tool(topic, facts):
            then = f"ros2 topic echo {topic}"
            yield finding("info", "unheard", topic=topic, nodes=node_names(facts.publishers[topic]), then=then)


def _relays(facts: Facts, subscribed: str, published: str) -> bool:
    """Whether one node alone takes one topic and sends the other, whose name only has something more, or less, at its end."""
    nodes = {each.node for each in (*facts.subscriptions[subscribed], *facts.publishers[published])}
    return len(nodes) == 1 and (subscribed.startswith(published) or published.startswith(subscribed))


def _by_rviz_tool(topic: str, facts: Facts) -> bool:
    """Whether RViz alone publishes there: only when somebody uses one of its tools."""
    nodes = {endpoint.node.rpartition("/")[2] for endpoint in facts.publishers[topic]}
    return topic in RVIZ_TOOLS and all(node.startswith("rviz") for node in nodes)


@looks_at("topics")
def _fights(facts: Facts) -> Iterator[Finding]:
    for topic, publishers in facts.publishers.items():
        if len(publishers) > 1 and any(publisher.type in SINGLE_VOICED for publisher in publishers):
            said = {"topic": topic, "count": len(publishers), "nodes": node_names(publishers)}
            yield finding("warning", "fight", **said, then=f"ros2 topic info -v {topic}")


@looks_at("nodes")
def _twins(facts: Facts) -> Iterator[Finding]:
    for name, count in facts.twins.items():
        yield finding("warning", "twins", name=name, count=count, then=f"ros2 node info {name}")


@looks_at("topics", "programs")
def _missed(facts: Facts) -> Iterator[Finding]:
    """Publishers that said something, or were gone, before anybody who waits for it had found them."""
    for topic, node, seconds in facts.missed:
        then = f"ros2 topic echo {topic}"
        if seconds:
            yield finding("warning", "gone_too_soon", topic=topic, node=node, seconds=f"{seconds:.1f}", then=then)
        else:
            yield finding("warning", "said_too_soon", topic=topic, node=node, then=then)


@looks_at("topics", "nodes")
def _clockless(facts: Facts) -> Iterator[Finding]:
    """Nodes that wait for simulated time: they subscribe to /clock."""
    if CLOCK in facts.publishers:
        return
    for node in dict.fromkeys(each.node for each in facts.subscriptions.get(CLOCK, ())):
        if not node.startswith("/_ros2cli"):
            yield finding("error", "no_clock", node=node, then=f"ros2 param set {node} use_sim_time false")


@looks_at("services")
def _services(facts: Facts) -> Iterator[Finding]:
    """Clients of services and actions that nobody offers."""
    for name, nodes in facts.clients.items():
        if name in facts.servers or all(node.startswith("/_ros2cli") for node in nodes):
            continue  # what is typed in a terminal says itself that it waits
        near = [each for each in facts.servers if are_alike(name, each)]
        if near:
            yield finding("warning", "service_near", name=name, near=near[0], nodes=nodes[0], then="ros2 service list")
        else:
            yield finding("warning", "no_server", name=name, nodes=nodes[0], then="ros2 service list")


@looks_at("messages")
def _slow(facts: Facts) -> Iterator[Finding]:
    for topic, rate in facts.rates.items():
        moving = any(endpoint.type in WATCHED_MOVING for endpoint in facts.publishers.get(topic, ()))
        if moving and 0 < rate < SLOW_HZ:
            yield finding("info", "slow", topic=topic, rate=f"{rate:.1f}".rstrip("0").rstrip("."))


@looks_at()
def _late(facts: Facts) -> Iterator[Finding]:
    if facts.pace < ENOUGH * facts.speed:
        yield finding("warning", "late", pace=f"{facts.pace:.2g}", speed=f"{facts.speed:g}")


_SHUT = {DoorState.IN_USE: "in_use", DoorState.NO_NAME: "no_name", DoorState.FAILED: "shut"}
_UNJOINED = {
    DoorState.NO_NAME: "no_name",
    DoorState.NOBODY: "nobody",
    DoorState.NO_ANSWER: "no_answer",
    DoorState.NO_CLASS: "no_class",
    DoorState.NAME_TAKEN: "name_taken",
    DoorState.NAME_ALIKE: "name_alike",
    DoorState.CLASS_FULL: "class_full",
    DoorState.OTHER_DOMAIN: "other_domain",
    DoorState.FAILED: "unreachable",
}


def link_findings(link: LinkState) -> Iterator[Finding]:
    """Yield the findings about other processes and machines, including that the link is open to others."""
    if link.problem is not None:
        yield finding("warning", "alone", reason=link.problem)
    if link.with_zenoh:
        yield finding("warning", "with_zenoh", count=link.with_zenoh)
    for reason in link.passed_over:
        yield finding("info", "elsewhere", reason=reason)
    yield from map(_door, link.doors)
    refused = Counter(link.refused)
    others = {key: refused.pop(key, 0) for key in ("names", "messages", "sessions")}
    for key, count in {"many": refused.total(), **others}.items():
        if count:
            yield finding("warning", f"refused_{key}", count=count)


def _door(door: Door) -> Finding:
    endpoint = door.endpoint
    if door.state == DoorState.OPEN:
        if not door.listening:
            return finding("info", "joined", endpoint=endpoint)
        kind = "open_secret" if door.secret else "open_class" if door.is_class else "open"
        return finding("info", kind, endpoint=endpoint, joined=door.joined)
    if door.state == DoorState.OPENING:
        return finding("info", "opening" if door.listening else "calling", endpoint=endpoint)
    if door.state == DoorState.NOT_LET_IN:
        return finding("error", "wrong_secret" if door.secret else "no_secret", endpoint=endpoint)
    key = (_SHUT if door.listening else _UNJOINED)[door.state]
    reason = {"reason": door.reason} if door.state == DoorState.FAILED else {}
    return finding("error", key, endpoint=endpoint, **reason)


@looks_at("machines")
def _link(facts: Facts) -> Iterator[Finding]:
    return link_findings(facts.link)


RULES: tuple[Rule, ...] = (
    _link,
    of_outputs,
    of_programs,
    of_ended,
    _mismatched_types,
    _mixed_types,
    _mismatched_qos,
    of_messages,
    of_transforms,
    of_frames,
    of_stamps,
    of_joints,
    of_missing_joints,
    of_positions,
    of_rival_descriptions,
    of_description,
    of_rviz,
    of_world,
    _fights,
    _twins,
    _one_sided,
    _missed,
    _services,
    _clockless,
    of_files,
    of_domains,
    _slow,
    _late,
)
"""All of them, in the order in which findings of one level are shown."""
