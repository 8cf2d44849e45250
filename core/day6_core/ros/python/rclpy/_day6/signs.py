"""Signs of what goes wrong inside a program although nothing fails: calls that come late, messages lost, goals left open …

Facts only, for day6-tui's inspector, which judges them (`day6_inspector.sign_rules`). Gathered when it asks, from what the
entities know and count anyway.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from day6_core.sign_sources import sources
from rclpy._day6.lately import WINDOW_S, Half, Lately
from rclpy._day6.own_lines import line_of, name_of, place_of
from rclpy._day6.swallowed import swallowed
from rclpy.parameter import Parameter
from rclpy.subscription import Subscription
from rclpy.timer import Timer

if TYPE_CHECKING:
    from rclpy.action.server import ActionServer
    from rclpy.node import Node

Sign = dict[str, Any]
Lasting = Callable[[object], float]
"""For how many seconds something has been there, as far as was asked."""

PERIODS = 4
"""A timer is watched for so many of its periods at least."""

_OWN_TOPICS = ("/clock", "/rosout", "/parameter_events")
_EARLY = ("<launch.substitutions.", "<launch_ros.substitutions.")
"""How the text of a substitution begins that was made a text before its time."""

_lately = Lately()


def signs_of(nodes: list[Node], now: float, lasting: Lasting) -> list[Sign]:
    """Return all signs of a program's nodes."""
    _lately.begin(now)
    found = [sign for node in nodes for sign in _of_node(node, lasting)]
    return found + [_sign("swallowed", node, place, values) for node, place, values in swallowed(nodes)]


def _sign(kind: str, node: str, place: dict[str, Any], values: Mapping[str, object]) -> Sign:
    return {"kind": kind, "node": node, "values": values, **place}


def _of_node(node: Node, lasting: Lasting) -> Iterator[Sign]:
    name = str(node.handle.node.full_name)
    for timer in list(node._rclpy_entities.timers):
        yield from _of_timer(name, timer)
    for subscription in list(node._rclpy_entities.subscriptions):
        yield from _of_subscription(name, subscription)
    yield from _of_publishers(name, node)
    yield from _growing(name, node)
    yield from _of_parameters(name, node)
    servers = sys.modules.get("rclpy.action.server")
    for each in list(node._rclpy_entities.waitables):
        if servers is not None and isinstance(each, servers.ActionServer):
            yield from _of_action(name, each, lasting)
    for kind, tell in sources.items():
        yield from (_sign(kind, name, line_of("", 0), values) for values in tell(node))


# -- too fast ----------------------------------------------------------------------------------------------------------


def _of_timer(node: str, timer: Timer) -> Iterator[Sign]:
    period = timer._period / 1e9
    halves = _lately.halves(timer, timer._missed, window=max(WINDOW_S, PERIODS * period))
    place = place_of(timer.callback)
    if timer._canceled or timer._handle._destroyed or timer._clock._is_simulated() or not place["file"]:
        return
    said = {"what": name_of(timer.callback)}
    if halves is not None and all(half.grown[0] for half in halves):
        share = min(1.0 if not period else half.grown[0] * period / half.seconds for half in halves)
        rate = sum(half.grown[0] for half in halves) / _seconds(halves)
        wanted = 1 / period if period else 0.0
        done = max(0.0, wanted - rate) if period else rate
        yield _sign("late", node, place, {**said, "wanted": wanted, "share": min(share, 1.0), "rate": done})
    elif period >= 1.0 and timer._missed == 0:
        yield _sign("seldom", node, place, {**said, "period": period})


def _seconds(halves: tuple[Half, Half]) -> float:
    return halves[0].seconds + halves[1].seconds


def _of_subscription(node: str, subscription: Subscription[Any]) -> Iterator[Sign]:
    endpoint = subscription._endpoint
    halves = _lately.halves(subscription, endpoint.received, endpoint.dropped)
    if endpoint.topic in _OWN_TOPICS or halves is None or not all(half.grown[1] for half in halves):
        return
    shares = [lost / (taken + lost) for _, (taken, lost) in halves]
    taken, lost = (sum(half.grown[index] for half in halves) for index in (0, 1))
    values = {
        "topic": endpoint.topic,
        "what": name_of(subscription.callback),
        "share": min(shares),
        "lost": lost,
        "count": taken + lost,
        "rate": (taken + lost) / _seconds(halves),
        "depth": endpoint.queue.maxlen or 0,
    }
    yield _sign("losses", node, place_of(subscription.callback), values)


def _of_publishers(node: str, owner: Node) -> Iterator[Sign]:
    for publisher in list(owner._rclpy_entities.publishers):
        endpoint = publisher._handle._endpoint
        halves = _lately.halves(publisher, endpoint.delivered)
        if halves is not None:
            rate = min(half.grown[0] / half.seconds for half in halves)
            if rate >= 1.0:
                yield _sign("flood", node, line_of("", 0), {"topic": endpoint.topic, "rate": rate})


def _growing(node: str, owner: Node) -> Iterator[Sign]:
    entities = owner._rclpy_entities
    for kind in ("publishers", "subscriptions", "clients", "services", "timers"):
        each = list(getattr(entities, kind))
        halves = _lately.halves((id(owner), kind), len(each))
        if halves is not None and all(half.grown[0] > 0 for half in halves):
            name = (
                ""
                if kind == "timers"
                else str(getattr(each[-1], "service_name", "") or each[-1]._handle._endpoint.topic)
            )
            least = min(half.grown[0] for half in halves)
            values = {"kind": kind, "name": name, "count": len(each), "least": least}
            place = place_of(each[-1].callback) if kind in ("subscriptions", "services", "timers") else line_of("", 0)
            yield _sign("grows", node, place, values)


# -- actions and parameters ------------------------------------------------------------------------------------------------


def _of_action(node: str, server: ActionServer[Any, Any, Any], lasting: Lasting) -> Iterator[Sign]:
    from action_msgs.msg import GoalStatus

    name = str(server._handle.name)
    if server._unsettled is not None:
        values: dict[str, object] = {"name": name, "what": name_of(server._unsettled)}
        yield _sign("goal_unsettled", node, place_of(server._unsettled), values)
    goals = list(server._goal_handles.values())
    runs = any(each._state in (GoalStatus.STATUS_EXECUTING, GoalStatus.STATUS_CANCELING) for each in goals)
    for goal in goals:
        kind = {GoalStatus.STATUS_ACCEPTED: "goal_waits", GoalStatus.STATUS_CANCELING: "cancel_ignored"}.get(
            goal._state, ""
        )
        if kind and not goal._destroyed and not (kind == "goal_waits" and runs):
            callback = server._handle_accepted_callback if kind == "goal_waits" else server._execute_callback
            values = {"name": name, "what": name_of(callback), "seconds": lasting((kind, id(goal)))}
            yield _sign(kind, node, place_of(callback), values)
    if server._cancel_service.queue and any(each._state == GoalStatus.STATUS_EXECUTING for each in goals):
        values = {"name": name, "what": name_of(server._execute_callback), "seconds": lasting(("cancel", id(server)))}
        yield _sign("cancel_unheard", node, place_of(server._execute_callback), values)


def _of_parameters(node: str, owner: Node) -> Iterator[Sign]:
    for name, parameter in {**owner._parameter_overrides, **owner._parameters}.items():
        value = parameter.value
        if parameter.type_ is Parameter.Type.BYTE_ARRAY and not value:
            yield _sign("empty_list", node, line_of("", 0), {"name": name})
        elif isinstance(value, str) and any(early in value for early in _EARLY):
            yield _sign("launch_text", node, line_of("", 0), {"name": name, "value": value})
