"""What the arguments of a node's command line make of it: its name, parameters with their sources, remaps."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from launch_ros.actions import Node

from day6_core.graph.names import remap_node
from rclpy._day6.arguments import END, START, parse_arguments, remove_ros_arguments
from rclpy._day6.parameter_files import matches
from rclpy._rclpy_pybind11 import RCLError, UnknownROSArgsError

_UNKNOWN = "name_that_no_file_has"
_TAKEN = ("-r", "--remap", "-p", "--param", "--params-file")
"""Options that are told as names, parameters and remaps."""
_SWITCHES = ("--enable-", "--disable-")


def node_facts(action: Node, command: Sequence[str]) -> dict[str, Any]:
    """Return what the node is called and gets; of a bad command line, what its program will refuse.

    Without a name in the launch file the program itself chooses: then `name` is '', and parameters for one name are `if_named`.
    """
    words = list(command[1:])
    plain = [word for word in remove_ros_arguments(words) if word not in (START, END)]
    facts: dict[str, Any] = {"arguments": plain}
    pairs = list(_pairs(words))
    try:
        parsed = parse_arguments(words)
        one_by_one = [
            (flag, value, parse_arguments([START, flag, value]).parameters) for flag, value in pairs if flag in _TAKEN
        ]
    except (RCLError, UnknownROSArgsError) as error:
        return {"name": "", "namespace": "/", **facts, "refused": str(error)}
    name, namespace = remap_node(_UNKNOWN, "/", parsed.rules)
    full = f"{namespace.rstrip('/')}/{name}"
    sources: dict[tuple[str, str], list[tuple[Any, str]]] = {}
    for flag, value, parameters in one_by_one:
        source = action._parameter_source(value) if flag == "--params-file" else ""
        for pattern, values in parameters.items():
            for key, each in values.items():
                sources.setdefault((pattern, key), []).append((each, source))
    found: dict[str, dict[str, Any]] = {}
    others: list[dict[str, str]] = []
    for pattern, values in parsed.parameters.items():
        if not matches(pattern, full):
            files = {source for (at, _), each in sources.items() if at == pattern for _, source in each}
            others += [{"node": pattern, "source": source} for source in sorted(files)]
            continue
        for key, value in values.items():
            of = [source for each, source in sources.get((pattern, key), ()) if each == value]
            found[key] = {"name": key, "value": value, "source": of[-1] if of else ""}
    named = name != _UNKNOWN
    return {
        "name": full if named else "",
        "namespace": namespace,
        **facts,
        "parameters": list(found.values()),
        "other_nodes" if named else "if_named": others,
        "remaps": [_rule(rule) for rule in parsed.rules if rule.kind == "name" or rule.node],
        "ros_arguments": [" ".join(filter(None, pair)) for pair in pairs if pair[0] not in _TAKEN],
    }


def _rule(rule: Any) -> str:
    left = {"node": "__node", "namespace": "__ns"}.get(rule.kind, rule.match)
    return f"{rule.node + ':' if rule.node else ''}{left}:={rule.replacement}"


def _pairs(words: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the options between `--ros-args` and `--`, each with its value."""
    inside = False
    rest = iter(words)
    for word in rest:
        if word in (START, END):
            inside = word == START
        elif inside:
            yield word, "" if word.startswith(_SWITCHES) else next(rest, "")
