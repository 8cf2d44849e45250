"""Lifecycle nodes: their states and transitions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
from ros2cli.node import service_calls
from ros2node.api import NodeName
from ros2node.api import get_node_names as get_all_node_names
from ros2service.api import get_service_names_and_types


def get_node_names(*, node: Any, include_hidden_nodes: bool = False) -> list[NodeName]:
    """Return the lifecycle nodes."""
    offered = dict(get_service_names_and_types(node=node, include_hidden_services=include_hidden_nodes))
    return [
        each
        for each in get_all_node_names(node=node, include_hidden_nodes=include_hidden_nodes)
        if "lifecycle_msgs/srv/GetState" in offered.get(f"{each.full_name}/get_state", [])
    ]


def _ask(node: Any, names: Iterable[str], kind: Any, service: str, request: Callable[[str], Any]) -> dict[str, Any]:
    """Return each node's response, or what went wrong."""
    found: dict[str, Any] = {}
    for name in names:
        try:
            found[name] = service_calls.call(node, kind, f"{name}/{service}", request(name))
        except RuntimeError as error:
            found[name] = error
    return found


def _field(answers: dict[str, Any], name: str) -> dict[str, Any]:
    return {node: each if isinstance(each, Exception) else getattr(each, name) for node, each in answers.items()}


def call_get_states(*, node: Any, node_names: Iterable[str]) -> dict[str, Any]:
    """Return each node's state, or what went wrong."""
    return _field(_ask(node, node_names, GetState, "get_state", lambda _: GetState.Request()), "current_state")


def call_get_available_transitions(*, node: Any, states: dict[str, Any]) -> dict[str, Any]:
    """Return the transitions that each node can take, those from the given state only if it is not None."""
    return _transitions(node, states, "get_available_transitions")


def call_get_transition_graph(*, node: Any, states: dict[str, Any]) -> dict[str, Any]:
    """Return all transitions of each node, those from the given state only if it is not None."""
    return _transitions(node, states, "get_transition_graph")


def _transitions(node: Any, states: dict[str, Any], service: str) -> dict[str, Any]:
    answers = _ask(node, states, GetAvailableTransitions, service, lambda _: GetAvailableTransitions.Request())
    return {
        name: found
        if isinstance(found, Exception)
        else [each for each in found if states[name] is None or each.start_state == states[name]]
        for name, found in _field(answers, "available_transitions").items()
    }


def call_change_states(*, node: Any, transitions: dict[str, Any]) -> dict[str, Any]:
    """Have each node take its transition; return whether it did, or what went wrong."""
    answers = _ask(
        node, transitions, ChangeState, "change_state", lambda name: ChangeState.Request(transition=transitions[name])
    )
    return _field(answers, "success")
