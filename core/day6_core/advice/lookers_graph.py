"""Lookers that ask the live graph: names that are nearly right, topics without a publisher, QoS that does not fit."""

from __future__ import annotations

import shlex
from collections.abc import Iterable

from day6_core.advice.known import template_of
from day6_core.advice.looking import Found, Situation, found, graph_looker
from day6_core.facts.graph import GraphFacts, node_names
from day6_core.facts.names import absolute, last_part, nearest


@graph_looker
def node(scene: Situation, graph: GraphFacts) -> Found | None:
    """A node that is not there: none is, or one has nearly this name."""
    name = _named(scene)
    nodes = sorted(set(graph.nodes))
    if not nodes:
        return _alone(scene, graph)
    full = absolute(name)
    if full in nodes:
        return found("graph.now_there", scene.command, name=full)
    return _near(scene, name, nodes, "ros2 node list")


@graph_looker
def topic(scene: Situation, graph: GraphFacts) -> Found | None:
    """A topic that nobody publishes, or whose name is nearly another's."""
    name = _named(scene)
    if not graph.nodes:
        return _alone(scene, graph)
    topics = graph.topics
    full = absolute(name)
    if full in topics:
        kinds = topics[full]
        if len(kinds) > 1:
            return _types(graph, full, kinds)
        if full not in graph.publishers:
            return found("topic.no_publisher", shlex.join(["ros2", "topic", "info", "-v", full]), name=full)
        return found("graph.now_there", scene.command, name=full)
    return _near(scene, name, sorted(topics), "ros2 topic list")


@graph_looker
def service(scene: Situation, graph: GraphFacts) -> Found | None:
    """A service that nobody offers, or whose name is nearly another's."""
    name = _named(scene)
    if not graph.nodes:
        return _alone(scene, graph)
    services = graph.services
    full = absolute(name)
    if full in services:
        wanted = next((word for word in scene.words() if word.count("/") == 2 and not word.startswith("/")), "")
        if wanted and wanted not in services[full]:
            right = services[full][0]
            return found("service.type", _with(scene, wanted, right), name=full, wanted=wanted, right=right)
        return found("graph.now_there", "", name=full)
    return _near(scene, name, sorted(services), "ros2 service list")


@graph_looker
def action(scene: Situation, graph: GraphFacts) -> Found | None:
    """Whether an action has another type or name than was typed."""
    name = _named(scene)
    if not graph.nodes:
        return _alone(scene, graph)
    if absolute(name) in graph.actions:
        return found("graph.now_there", "", name=absolute(name))
    return _near(scene, name, sorted(graph.actions), "ros2 action list")


@graph_looker
def needed(scene: Situation, graph: GraphFacts) -> Found | None:
    """What a command still needs and the graph knows: the type of a service, an action, a topic; the node of a parameter."""
    words = scene.words()
    if words[:1] != ["ros2"] or len(words) < 3:
        return None
    first = next((name.strip() for name in scene.value("names").split(",")), "")
    operands = [word for word in words[3:] if not word.startswith("-")]
    if first in _LISTS and not operands:
        return found("needed.name", _LISTS[first], lists=_LISTS[first])
    if first in _TYPES and len(operands) == 1 and scene.command.rstrip().endswith(operands[0]):
        return _needed_type(scene, graph, words[1], operands[0])
    if words[1] == "param":
        return _needed_node(scene, graph, words, operands)
    return None


_LISTS = {"service_name": "ros2 service list", "action_name": "ros2 action list", "topic_name": "ros2 topic list",
          "node_name": "ros2 node list"}  # fmt: skip
"""What is missing -> the command that lists what there is."""

_TYPES = ("service_type", "action_type", "message_type")


def _needed_type(scene: Situation, graph: GraphFacts, command: str, name: str) -> Found | None:
    """The type of what is named, from the graph, and the whole line with it."""
    full = absolute(name)
    known_types = {"action": graph.actions, "service": graph.services}.get(command, graph.topics)
    if full not in known_types:
        return _near(scene, name, sorted(known_types), f"ros2 {command} list") if known_types else None
    kind = known_types[full][0]
    contents = template_of(kind, scene.variables)
    line = f"{scene.command.rstrip()} {kind}" + (f' "{contents}"' if contents else "")
    return found("needed.type" if contents else "needed.type_alone", line, name=full, type=kind)


def _needed_node(scene: Situation, graph: GraphFacts, words: list[str], operands: list[str]) -> Found | None:
    """`ros2 param set NAME VALUE`: the node is missing, not the value; and `NAME=VALUE`."""
    nodes = sorted(set(graph.nodes))
    if not operands or words[2] not in ("set", "get", "describe", "delete"):
        return None
    if absolute(operands[0]) in nodes:
        name, _, value = operands[-1].partition("=")
        if words[2] == "set" and len(operands) == 2 and name and value:
            return found("needed.no_equals", scene.with_word(operands[1], f"{name} {value}"), name=name, value=value)
        return None
    if "/" in operands[0] or not nodes or len(operands) > (2 if words[2] == "set" else 1):
        return None
    if nearest(absolute(operands[0]), nodes):
        return _near(scene, operands[0], nodes, "ros2 node list")
    line = shlex.join([*words[:3], nodes[0], *words[3:]]) if len(nodes) == 1 else "ros2 param list"
    return found("needed.node", line, name=operands[0], nodes=", ".join(nodes))


@graph_looker
def qos(scene: Situation, graph: GraphFacts) -> Found | None:
    """A publisher and a subscription whose reliability does not fit."""
    name = absolute(scene.value("name"))
    for topic, publisher, subscriber, policy in graph.deaf:
        if topic == name and policy == "reliability":
            look = shlex.join(["ros2", "topic", "info", "-v", name])
            return found("qos.reliability", look, name=name, publisher=publisher, subscriber=subscriber)
    return None


@graph_looker
def twins(scene: Situation, graph: GraphFacts) -> Found | None:
    """Nodes that share a name."""
    twice = sorted(graph.twins)
    return found("graph.twins", name=", ".join(twice), count=graph.twins[twice[0]]) if twice else None


@graph_looker
def frames(scene: Situation, graph: GraphFacts) -> Found | None:
    """Whether anybody publishes transforms, and whether the joints that move have somebody who says how far."""
    moving, fixed = graph.publishers.get("/tf", ()), graph.publishers.get("/tf_static", ())
    described = graph.publishers.get("/robot_description", ())
    if not moving and not fixed:
        key = "tf.nobody" if not described else "tf.only_description"
        return found(key, nodes=node_names(described))
    publisher = next((each.node for each in (*moving, *fixed) if "robot_state_publisher" in each.node), "")
    if publisher and not graph.publishers.get("/joint_states", ()):
        if "/joint_states" in graph.subscriptions:
            return found(
                "tf.no_joints", "ros2 run joint_state_publisher_gui joint_state_publisher_gui", publisher=publisher
            )
        return None
    return None


@graph_looker
def description(scene: Situation, graph: GraphFacts) -> Found | None:
    """Whether anybody publishes a robot description."""
    if graph.publishers.get("/robot_description"):
        return None
    nodes = [each for each in graph.nodes if "robot_state_publisher" in each]
    return found("description.nobody" if not nodes else "description.silent", nodes=", ".join(nodes))


@graph_looker
def clock(scene: Situation, graph: GraphFacts) -> Found | None:
    """Whether anybody publishes /clock."""
    if graph.publishers.get("/clock"):
        return None
    return found("clock.nobody")


def _alone(scene: Situation, graph: GraphFacts) -> Found:
    """No node runs where this terminal looks; perhaps in another domain."""
    domain = scene.variables.get("ROS_DOMAIN_ID", "") or "0"
    for number, nodes in graph.domains_besides(graph.domain).items():
        said = {"domain": domain, "other": number, "nodes": ", ".join(sorted(set(nodes)))}
        return found("graph.other_domain", f"export ROS_DOMAIN_ID={number}", **said)
    return found("graph.empty", domain=domain)


def _named(scene: Situation) -> str:
    """What the message names, else the line that was run."""
    return scene.value("name") or next((word for word in scene.words()[3:] if not word.startswith("-")), "")


def _types(graph: GraphFacts, topic: str, kinds: Iterable[str]) -> Found:
    look = shlex.join(["ros2", "topic", "info", "-v", topic])
    who = node_names(graph.ends(topic))
    return found("topic.types", look, name=topic, types=", ".join(kinds), nodes=who)


def _near(scene: Situation, name: str, names: list[str], lists: str) -> Found | None:
    """The one of the names that is nearly this one, or has the same last part."""
    full = absolute(name)
    last = last_part(full)
    same = [each for each in names if last and last_part(each) == last]
    near = same[0] if len(same) == 1 else nearest(full, names)
    if near:
        right = near if name.startswith("/") or name.count("/") or same else near.removeprefix("/")
        return found("graph.near", _with(scene, name, right), name=full, near=near)
    if not names:
        return found("graph.none", lists, name=full)
    return None


def _with(scene: Situation, wrong: str, right: str) -> str:
    return scene.command.replace(wrong, right) if wrong and scene.command.count(wrong) == 1 else ""
