"""What a callback that runs now waits for, and whether that can come while it waits: for what a program tells the inspector."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from types import FrameType
from typing import TYPE_CHECKING, Any

from rclpy._day6.entity import Entity
from rclpy._day6.executor import Executor
from rclpy._day6.own_lines import is_own, name_of
from rclpy._day6.rounds import ExecutorRounds
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.client import Client
from rclpy.executors import MultiThreadedExecutor
from rclpy.task import Future
from rclpy.timer import Rate

if TYPE_CHECKING:
    from rclpy.node import Node

SPINS = frozenset(
    {ExecutorRounds._next.__code__, ExecutorRounds._wait.__code__, Executor.spin_until_future_complete.__code__}
)
CALL, RATE = Client.call.__code__, Rate.sleep.__code__
SERVICE = Client.wait_for_service.__code__
_WAITS = {CALL: "call", RATE: "rate", SERVICE: "service", **dict.fromkeys(SPINS, "spin")}
_EVENTS = frozenset({threading.Event.wait.__code__, threading.Condition.wait.__code__})


def what_it_waits_for(stack: list[FrameType], nodes: list[Node]) -> dict[str, str]:
    """Return for a thread in a callback, whose stack ends with the executor's frame, what it waits for.

    `waits_for` is the kind, `waits_on` a service, `blocked` why it cannot come: 'thread' for want of one, 'group' because
    its callback belongs to the same group; '' if it can. `other` is the callback of this program that cannot run therefore.
    """
    kind, subject = _outermost(stack[:-1])
    client = subject if isinstance(subject, Client) else _client_of(subject, nodes)
    needed = client if client is not None else subject._timer if isinstance(subject, Rate) else None
    outermost = stack[-1].f_locals
    blocked = _blocked(outermost["self"], outermost.get("entity"), needed)
    if kind == "future" and client is None and not isinstance(outermost["self"], MultiThreadedExecutor):
        blocked = "thread"  # of an action, for instance: some callback has to complete it
    other = ""
    if client is not None:
        for node in nodes:
            for service in node.services:
                if service.service_name == client.service_name:
                    reason = _blocked(outermost["self"], outermost.get("entity"), service)
                    blocked, other = reason or blocked, name_of(service.callback) if reason else other
    return {
        "waits_for": kind if blocked or kind not in ("call", "rate", "future") else "",
        "waits_on": client.service_name if client is not None else "",
        "blocked": blocked,
        "other": other,
    }


def _outermost(frames: list[FrameType]) -> tuple[str, Any]:
    """The outermost thing that waits, and what it waits for; after all others a loop that asks for a future, or an event."""
    kind, subject = "", None
    for frame in frames:
        if (found := _WAITS.get(frame.f_code)) is not None:
            kind = found
            subject = frame.f_locals.get("future") if kind == "spin" else frame.f_locals.get("self")
    if kind:
        return kind, subject
    own = next((frame for frame in frames if is_own(frame.f_code.co_filename)), None)
    if own is not None and {"done", "result"} & set(own.f_code.co_names):
        for future in _futures(own):
            return "future", future
    return ("event" if any(frame.f_code in _EVENTS for frame in frames) else ""), None


def _futures(frame: FrameType) -> Iterator[Future[Any]]:
    """The futures without a result that a function knows, by a variable or as a part of its object."""
    known = list(frame.f_locals.values())
    known += list(getattr(frame.f_locals.get("self"), "__dict__", {}).values())
    yield from (each for each in known if isinstance(each, Future) and each._pending())


def _client_of(future: object, nodes: list[Node]) -> Client[Any, Any] | None:
    for node in nodes:
        for client in node.clients:
            if any(each is future for each in list(client._pending_requests.values())):
                return client
    return None


def _blocked(executor: Executor, entity: Entity | None, needed: Entity | None) -> str:
    """Why an entity cannot run while this executor runs another one, '' if it can."""
    if needed is None or needed._scope is None or needed._scope.executor is not executor:
        return ""
    if not isinstance(executor, MultiThreadedExecutor):
        return "thread"
    group = needed.callback_group
    same = entity is not None and group is entity.callback_group
    return "group" if same and isinstance(group, MutuallyExclusiveCallbackGroup) else ""
