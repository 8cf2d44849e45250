"""A replacement for rcl's wait set: entities that a program or a waitable adds by their handles, and whether they are ready."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy._day6.entity import NOTHING
from rclpy._day6.time_base import AutoResetEvent
from rclpy._rclpy_pybind11 import Destroyable, RCLError
from rclpy.constants import S_TO_NS
from rclpy.timer import Timer

if TYPE_CHECKING:
    from rclpy._day6.entity import Scope

_KINDS = ("subscription", "guard_condition", "timer", "client", "service", "event")
_ENDPOINTS = ("subscription", "client", "service")
_FULL = {
    "subscription": "failed to add subscription to wait set: subscriptions set is full, at /project/src/rcl/wait.c:357",
    "guard_condition": "failed to add guard condition to wait set: guard_conditions set is full, at /project/src/rcl/wait.c:446",
    "timer": "failed to add timer to wait set: timers set is full, at /project/src/rcl/wait.c:459",
    "client": "failed to add client to wait set: clients set is full, at /project/src/rcl/wait.c:500",
    "service": "failed to add service to wait set: services set is full, at /project/src/rcl/wait.c:511",
    "event": "failed to add event to wait set: events set is full, at /project/src/rcl/wait.c:522",
}


class WaitSet(Destroyable):
    """Entities to wait for; the numbers limit the entities of each kind.

    After `wait`, as in rcl, `is_ready` returns what was ready at its end. `wait` is not called on the wait set of a waitable
    (`_of_waitable`); the executor is notified when an entity becomes ready.
    """

    def __init__(
        self,
        number_of_subscriptions: int,
        number_of_guard_conditions: int,
        number_of_timers: int,
        number_of_clients: int,
        number_of_services: int,
        number_of_events: int,
        context: Any,
    ) -> None:
        super().__init__()
        numbers = (
            number_of_subscriptions,
            number_of_guard_conditions,
            number_of_timers,
            number_of_clients,
            number_of_services,
            number_of_events,
        )
        self._limits: dict[str, int] | None = dict(zip(_KINDS, numbers, strict=True))
        self._changed = AutoResetEvent()
        self._announce: Callable[..., None] = lambda *_: self._changed.set()
        self._members: dict[str, list[Any]] = {kind: [] for kind in _KINDS}
        self._ready: dict[str, list[bool]] | None = None
        self._scope: Scope | None = None
        self._alarms: list[_Alarm] = []

    @classmethod
    def _of_waitable(cls, announce: Callable[..., None], scope: Scope) -> WaitSet:
        made = cls(0, 0, 0, 0, 0, 0, None)
        made._limits = None
        made._announce = announce
        made._scope = scope
        return made

    # -- adding --------------------------------------------------------------------------------------------------------

    def _add(self, kind: str, handle: Any) -> int:
        members = self._members[kind]
        if self._limits is not None and len(members) >= self._limits[kind]:
            raise RCLError(_FULL[kind])
        handle.__enter__()
        members.append(handle)
        if kind in _ENDPOINTS:
            handle._endpoint.on_ready = self._announce
        return len(members) - 1

    def add_subscription(self, handle: Any) -> int:
        """Add a subscription by its handle; returns its index for `is_ready`."""
        return self._add("subscription", handle)

    def add_service(self, handle: Any) -> int:
        """Add a service by its handle; returns its index for `is_ready`."""
        return self._add("service", handle)

    def add_client(self, handle: Any) -> int:
        """Add a client by its handle; returns its index for `is_ready`."""
        return self._add("client", handle)

    def add_guard_condition(self, handle: Any) -> int:
        """Add a guard condition by its handle; returns its index for `is_ready`."""
        index = self._add("guard_condition", handle)
        handle._entity()._notify = self._announce
        return index

    def add_timer(self, handle: Any) -> int:
        """Add a timer by its handle; returns its index for `is_ready`."""
        index = self._add("timer", handle)
        if self._scope is not None:
            alarm = _Alarm(handle._entity(), self._announce)
            alarm._enter(self._scope)
            self._scope.timed.append(alarm)
            self._alarms.append(alarm)
            alarm._schedule()
        return index

    def add_event(self, handle: Any) -> int:
        """Add an event of a publisher or subscription by its handle; returns its index for `is_ready`."""
        index = self._add("event", handle)
        handle._endpoint.on_event = self._announce
        return index

    def _leave(self) -> None:
        """Stop announcing timers: the waitable leaves its node."""
        for alarm in self._alarms:
            if alarm._scope is not None:
                alarm._scope.timed.remove(alarm)
            alarm._leave()
        self._alarms = []

    def clear_entities(self) -> None:
        """Remove all entities."""
        for members in self._members.values():
            members.clear()
        self._ready = None

    # -- looking -------------------------------------------------------------------------------------------------------

    def wait(self, timeout_nsec: int) -> None:
        """Block until an entity is ready or `timeout_nsec` nanoseconds are over (negative: for ever, 0: not at all)."""
        end = None
        steady = _steady_ns()
        if timeout_nsec >= 0:
            end = steady + timeout_nsec
        while True:
            self._ready = {kind: [_is_ready(kind, each) for each in self._members[kind]] for kind in _KINDS}
            for guard in self._members["guard_condition"]:
                guard._entity()._executor_triggered = False
            steady = _steady_ns()
            if any(any(ready) for ready in self._ready.values()) or (end is not None and steady >= end):
                return
            waits = [] if end is None else [end - steady]
            waits += [each.time_until_next_call() for each in self._members["timer"]]
            waits += [each._due_in() for each in self._members["event"]]
            left = [max(0, wait) for wait in waits if wait is not None]
            self._changed.wait(min(left) / S_TO_NS if left else None)

    def is_ready(self, kind: str, index: int) -> bool:
        """Return whether an entity is ready; `kind` is subscription, guard_condition, timer, client, service or event."""
        members = self._members_of(kind)
        if not 0 <= index < len(members):
            raise IndexError("wait set index too big")
        if self._limits is not None:
            return self._ready is not None and self._ready[kind][index]
        return _is_ready(kind, members[index])

    def get_ready_entities(self, kind: str) -> list[int]:
        """Return the `pointer`s of the entities that were ready at the end of `wait`."""
        members = self._members_of(kind)
        ready = [] if self._ready is None else self._ready[kind]
        return [each.pointer for each, is_ready in zip(members, ready, strict=False) if is_ready]

    def _members_of(self, kind: str) -> list[Any]:
        members = self._members.get(kind)
        if members is None:
            raise RuntimeError(f"'{kind}' is not a known entity")
        return members

    def reset(self) -> None:
        """Reset triggered guard conditions, as each wait of rcl does."""
        for guard in self._members["guard_condition"]:
            guard._entity()._executor_triggered = False

    def rearm(self) -> None:
        """Schedule timers again, and announce entities that are still ready."""
        for alarm in self._alarms:
            alarm._schedule()
        if any(handle._endpoint.queue for kind in _ENDPOINTS for handle in self._members[kind]):
            self._announce()


def _is_ready(kind: str, handle: Any) -> bool:
    if kind in _ENDPOINTS:
        return bool(handle._endpoint.queue)
    if kind == "guard_condition":
        return bool(handle._entity()._executor_triggered)
    return bool(handle.is_timer_ready() if kind == "timer" else handle._pending())


def _steady_ns() -> int:
    import time

    return time.monotonic_ns()


class _Alarm(Timer):
    """Wakes a waitable when one of its timers is due; the waitable itself calls the timer."""

    def __init__(self, watched: Timer, announce: Callable[..., None]) -> None:
        self._watched = watched
        self._announce = announce
        self._heap = None
        self._heap_deadline = 0
        self.callback_group = None

    def _pending(self) -> bool:
        return False

    def _schedule(self) -> None:
        scope, timer = self._scope, self._watched
        if scope is not None and scope.executor is not None and not timer._canceled and not timer._handle._destroyed:
            self._canceled = False
            self._next = timer._next if not timer._clock._is_simulated() else scope.executor._steady_ns() + _POLL_NS
            scope.executor._add_timer(self)

    def _process(self) -> Any:
        self._queued = False
        if self._watched._due():
            self._announce()
        else:
            self._schedule()
        return NOTHING


_POLL_NS = 10_000_000
"""Nanoseconds between checks of a waitable's timer on simulated time."""
