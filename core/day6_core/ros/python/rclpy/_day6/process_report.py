"""What this process tells day6-tui's inspector about its reports: who spins, which callback runs and where, what is overdue.

Imported at the first question only, and answered on a thread of the link, so that it works while all threads of the program are
blocked. Nothing is counted or noted meanwhile: the answer comes from the threads' stacks and from what the entities know. How
long something has lasted is known from one question to the next.
"""

from __future__ import annotations

import json
import os
import sys
import threading
import time
from types import FrameType
from typing import Any, NamedTuple

from rclpy._day6.blocking import CALL, RATE, SERVICE, SPINS, what_it_waits_for
from rclpy._day6.executor import Executor
from rclpy._day6.lost_errors import LOST, LostError
from rclpy._day6.own_lines import is_own, place_in, raised_at, said
from rclpy._day6.signs import signs_of
from rclpy.context import _valid_contexts
from rclpy.node import Node
from rclpy.subscription import Subscription
from rclpy.timer import Timer

MOST = 100
"""Nodes, endpoints … that one answer names."""

ACTIVE_S = 1.2
"""For so long after its last callback a node counts as one whose callbacks run; beginners spin once a second."""

LONGER = 1.5
"""Times the longest pause that a node has made between two callbacks: less is its habit."""

_EXECUTE, _RUN_TASK = Executor._execute.__code__, Executor._run_task.__code__
_INIT = "__init__"
_ACTION = ("wait_for_server", f"{os.sep}action{os.sep}client.py")

_since: dict[object, float] = {}
"""What was there at the last question -> when it was seen first (monotonic seconds)."""

_progress: dict[str, _Progress] = {}


class _Progress(NamedTuple):
    """What is remembered of a node: a number that changes with every callback, since when, and its longest pause (s)."""

    done: int
    since: float
    longest: float


def tell() -> bytes:
    """Return the answer as JSON; `day6_inspector.process_reports.read_process` reads it."""
    now = time.monotonic()
    contexts = _valid_contexts()
    nodes = [node for context in contexts for each in list(context._nodes) if (node := each()) is not None][:MOST]
    stacks = {
        number: _stack(frame) for number, frame in sys._current_frames().items() if number != threading.get_ident()
    }
    spinning = any(frame.f_code in SPINS or _runs(frame) for stack in stacks.values() for frame in stack)
    seen: dict[object, float] = {}
    busy, standing = [], []
    for number, stack in stacks.items():
        runs = [place for place, frame in enumerate(stack) if _runs(frame)]
        if runs:
            told = _busy(stack[: runs[-1] + 1], number, nodes, now, seen)
            if told is not None:
                busy.append(told)
        else:
            standing += _standing(stack, number, spinning, now, seen)
    signs = signs_of(nodes, now, lambda key: _lasting(key, now, seen))
    _since.clear()
    _since.update(seen)
    answer = {
        "pid": os.getpid(),
        "arguments": [os.path.abspath(sys.argv[0]) if sys.argv else "", *map(str, sys.argv[1:MOST])],
        "nodes": [_node(node, spinning, now) for node in nodes],
        "busy": busy,
        "standing": standing,
        "hidden": _hidden(contexts),
        "signs": signs[:MOST],
    }
    return json.dumps(answer).encode("utf-8", "backslashreplace")


def _stack(frame: FrameType | None) -> list[FrameType]:
    """The frames of a thread, the innermost first."""
    found = []
    while frame is not None:
        found.append(frame)
        frame = frame.f_back
    return found


def _lasting(key: object, now: float, seen: dict[object, float]) -> float:
    seen[key] = _since.get(key, now)
    return now - seen[key]


# -- threads ---------------------------------------------------------------------------------------------------------------


def _busy(
    stack: list[FrameType], thread: int, nodes: list[Node], now: float, seen: dict[object, float]
) -> dict[str, Any] | None:
    """A thread that runs a callback: `stack` ends with the executor's frame."""
    outermost = stack[-1].f_locals
    entity = outermost.get("entity")
    work = entity if entity is not None else outermost.get("task")
    mine = [frame for frame in stack if is_own(frame.f_code.co_filename)]
    if work is None or not mine:
        return None
    if entity is not None:
        node = next((each for each in nodes if each.handle.scope is entity._scope), None)
    else:  # a task does not know whose it is
        node = next((each for each in nodes if each.handle.scope.executor is outermost["self"]), None)
    waits = what_it_waits_for(stack, nodes)
    return {
        "node": _full_name(node) if node is not None else "",
        "what": mine[-1].f_code.co_name,
        "seconds": _lasting((thread, id(stack[-1]), id(work), _mark(entity)), now, seen),
        **waits,
        **place_in(stack),
    }


def _runs(frame: FrameType) -> bool:
    """Whether an executor runs a callback, or the next part of one, in this frame."""
    return frame.f_code is _EXECUTE or frame.f_code is _RUN_TASK


def _mark(entity: object) -> int:
    """Return a number that is another one at the entity's next callback."""
    if isinstance(entity, Timer):
        return entity._last
    if isinstance(entity, Subscription):
        return int(entity._endpoint.received)
    return 0


def _standing(
    stack: list[FrameType], thread: int, spinning: bool, now: float, seen: dict[object, float]
) -> list[dict[str, Any]]:
    """A thread outside callbacks that waits for what cannot come."""
    for frame in stack:
        code = frame.f_code
        kind = name = ""
        if code is RATE and not spinning:
            kind = "rate"
        elif code is CALL and not spinning:
            kind = "call"
        elif code is SERVICE:
            kind, name = "service", str(frame.f_locals["self"].service_name)
        elif code.co_name == _ACTION[0] and code.co_filename.endswith(_ACTION[1]):
            client = frame.f_locals["self"]
            kind, name = "action", str(client._handle.name)
        elif code.co_name == _INIT and not spinning and is_own(code.co_filename):
            kind = "init" if isinstance(frame.f_locals.get("self"), Node) else ""
        if kind:
            seconds = _lasting((thread, kind, id(frame.f_locals["self"])), now, seen)
            return [{"kind": kind, "name": name, "seconds": seconds, **place_in(stack)}]
    return []


# -- nodes -----------------------------------------------------------------------------------------------------------------


def _full_name(node: Node) -> str:
    return node.handle.node.full_name


def _stands(node: Node) -> bool:
    """Whether its timers wait for a simulated time that nobody has sent; a simulator's may well be 0."""
    clock, heard = node._clock, node._time_source._clock_sub
    is_told = heard is not None and heard._endpoint.received > 0
    return clock._is_simulated() and clock._now_ns() == 0 and not is_told and bool(node._timers)


def _node(node: Node, spinning: bool, now: float) -> dict[str, Any]:
    name = _full_name(node)
    entities = node._rclpy_entities
    subscriptions, timers, publishers = list(entities.subscriptions), list(entities.timers), list(entities.publishers)
    done = sum(each._endpoint.received for each in subscriptions) + sum(each._last for each in timers)
    scope = node.handle.scope
    known = _progress.get(name, _Progress(done, now, 0.0))
    if known.done != done:
        known = _Progress(done, now, max(known.longest, now - known.since))
    _progress[name] = known
    idle = now - known.since
    if timers and not known.longest:  # until something happens between two questions the timers know it better
        idle = max(idle, min((each._steady_ns() - each._last) / 1e9 for each in timers))
    spun = scope.home is not None
    active = spun and idle < max(ACTIVE_S, LONGER * known.longest)
    late = max((_late(each) for each in timers), default=0.0)
    waiting = sum(len(each._endpoint.queue) for each in subscriptions)
    waiting += sum(len(each._endpoint.queue) for each in list(entities.services))
    return {
        "node": name,
        "spun": spun,
        "spins": (spinning and scope.executor is not None) or active,
        "late": late,
        "waiting": 0 if active else waiting,
        "stands": _stands(node),
        "publishers": {
            each._handle._endpoint.topic: int(each._handle._endpoint.delivered) for each in publishers[:MOST]
        },
        "subscriptions": {
            each._endpoint.topic: int(each._endpoint.received) + len(each._endpoint.queue)
            for each in subscriptions[:MOST]
        },
    }


def _late(timer: Timer) -> float:
    """Seconds by which a timer is overdue."""
    if timer._canceled or timer._handle._destroyed or timer._clock._is_simulated():
        return 0.0
    return max(0.0, (timer._steady_ns() - timer._next) / 1e9)


# -- exceptions ------------------------------------------------------------------------------------------------------------


def _hidden(contexts: list[Any]) -> list[dict[str, Any]]:
    errors = list(LOST)
    for context in contexts:
        for executor in list(context._executors):
            failed = list(getattr(executor, "_failed", ()))
            errors += [LostError("", error) for each in failed if (error := each._exception)]
    return [
        {"node": each.node, "thread": each.thread, "error": said(each.error), **raised_at(each.error.__traceback__)}
        for each in errors
    ]
