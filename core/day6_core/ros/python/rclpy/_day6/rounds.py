"""The rounds of an executor: which entities became ready, and which of them is run next.

Ready entities announce themselves (`rclpy._day6.entity`) in the executor's inbox; nothing is polled. As in real rclpy work
comes in rounds: entities that are ready together run in a fixed order, each once, before the executor checks again.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy._day6.entity import Entity, Scope
from rclpy._day6.executor_timeouts import ExternalShutdownException
from rclpy._day6.time_base import LONGEST_WAIT_S
from rclpy._day6.timer_heap import TimerHeap
from rclpy._rclpy_pybind11 import RCLError
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from rclpy.task import Task
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.event_handler import EventHandler
    from rclpy.node import Node
    from rclpy.timer import Timer

_INVALID = (
    "the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called., "
    "at /project/src/rcl/"
)
_INVALID_TIMER = f"failed to create timer: {_INVALID}guard_condition.c:65"
_INVALID_WAIT_SET = f"failed to initialize wait set: {_INVALID}wait.c:105"
_INVALID_GUARD = f"failed to create guard_condition: {_INVALID}guard_condition.c:65"
_LONGEST_WAIT_NS = int(LONGEST_WAIT_S * S_TO_NS)


class ExecutorRounds:
    """Collects the ready entities of some nodes, and waits for more. RuntimeError if the context is not initialised."""

    def __init__(self, context: Context | None) -> None:
        self._context = get_default_context() if context is None else context
        if self._context.handle is None:
            raise RuntimeError("Context must be initialized a GuardCondition can be created")
        if not self._context._valid:
            raise RCLError(_INVALID_GUARD)
        self._steady_ns = self._context._time.steady_ns
        self._nodes: set[Node] = set()
        self._nodes_lock = threading.RLock()
        self._new_nodes: deque[Node] = deque()
        self._inbox: deque[Entity] = deque()
        """Entities that became ready since the round was collected."""
        self._round: deque[Entity | Task[Any]] = deque()
        self._tasks: deque[Task[Any]] = deque()
        self._timers = TimerHeap(self)
        self._is_shutdown = False
        self._woken = False
        self._gate = threading.Lock()
        self._gate.acquire()
        self._wake_callback: Callable[[], None] | None = None
        self._hook: Callable[[], None] | None = None
        """Called when something becomes ready: while a thread waits here it opens the gate."""
        self._spin_arguments: tuple[Any, Any] | None = None
        """Timeout and condition of the `spin_once` that the round was collected for."""
        self._generator = 0
        """The number of changes of these arguments. With each, real rclpy begins another generator and leaves the old one to
        the thread that waits in it."""
        self._waiting: set[int] = set()
        """The generators in which a thread waits: two if a program spins one executor twice."""

    # -- nodes come and go ---------------------------------------------------------------------------------------------

    def _attach_new_nodes(self) -> None:
        """Take over entities that became ready before the node was added.

        Real rclpy reads a node's entities only when it spins, so that is where an object that isn't a node fails.
        """
        with self._nodes_lock:
            while self._new_nodes:
                node = self._new_nodes[0]
                next(iter(node.subscriptions), None)
                scope = node.handle.scope
                if scope.home is not None and scope.home is not self:
                    scope.home._give_up(scope, scope.home._round)
                scope.executor = scope.home = self  # type: ignore[assignment]  # an Executor: nothing else derives from this
                self._new_nodes.popleft()
                for timer in (*node.timers, *scope.timed):
                    timer._schedule()
                if scope.stash:
                    scope.hand_over()

    def _detach(self, node: Node) -> None:
        # Entities in the round stay there: a node that is added again before the next spin continues where it was.
        scope = node.handle.scope
        scope.executor = None
        self._give_up(scope, self._inbox)

    @staticmethod
    def _give_up(scope: Scope, queue: deque[Any]) -> None:
        for _ in range(len(queue)):
            try:
                item = queue.popleft()
            except IndexError:
                return
            if getattr(item, "_scope", None) is scope:
                scope.stash.append(item)
            else:
                queue.append(item)

    def _start_anew(self) -> None:
        """Put the round back, which was collected for another kind of `spin_once`; real rclpy collects anew, too."""
        entities = [item for item in self._round if isinstance(item, Entity)]
        tasks = [item for item in self._round if isinstance(item, Task)]
        self._round.clear()
        self._inbox.extendleft(reversed(entities))
        self._tasks.extendleft(reversed(tasks))

    # -- what is ready -------------------------------------------------------------------------------------------------

    def _enqueue(self, entity: Entity) -> None:
        self._inbox.append(entity)
        hook = self._hook
        if hook is not None:
            hook()

    def _add_timer(self, timer: Timer | EventHandler) -> None:
        if self._timers.add(timer):
            hook = self._hook
            if hook is not None:
                hook()

    def _collect(self) -> bool:
        """Collect the next round; False if nothing is ready."""
        inbox, round_ = self._inbox, self._round
        if self._timers.entries:
            self._timers.move_due(self._steady_ns, round_)
        while inbox:
            round_.append(inbox.popleft())
        if len(round_) > 1:
            self._round = deque(sorted(round_, key=_order_of))  # type: ignore[arg-type]
        return bool(round_)

    def _next(
        self, timeout_ns: int, condition: Callable[[], bool], spin_arguments: tuple[Any, Any]
    ) -> Entity | Task[Any] | None:
        """Return the next item to run, its callback group reserved; None when time is up or `condition` is true.

        `spin_arguments` are timeout and condition as the program gave them. Raises ExternalShutdownException when the
        context was shut down elsewhere.
        """
        if spin_arguments != self._spin_arguments:
            self._spin_arguments = spin_arguments
            self._generator += 1
            if self._round:
                self._start_anew()
        elif self._generator in self._waiting:
            # Two threads spin one executor in the same way. Real rclpy shares one generator between them, which raises:
            raise ValueError("generator already executing")
        generator = self._generator
        until: int | None = None
        tasks_had_their_turn = False
        waited = False
        while True:
            if self._new_nodes:
                self._attach_new_nodes()
            while self._round:
                item = self._round.popleft()
                if item.__class__ is Task:
                    return item
                scope = item._scope  # type: ignore[union-attr]
                if scope is None or scope.executor is not self:
                    item._queued = False  # type: ignore[union-attr]
                    item._notify()  # type: ignore[union-attr]
                    continue
                if self._begin(item):  # type: ignore[arg-type]
                    return item
            # Before the condition is looked at: who makes it true a moment later wakes the wait below.
            self._woken = False
            if self._is_shutdown or condition():
                return None
            if self._tasks and not tasks_had_their_turn:
                tasks_had_their_turn = True
                self._round.extend(self._tasks.popleft() for _ in range(len(self._tasks)))
                continue
            tasks_had_their_turn = False
            if not self._context._valid:
                if waited:
                    raise ExternalShutdownException
                raise RCLError(_INVALID_TIMER if timeout_ns > 0 else _INVALID_WAIT_SET)
            if self._collect() or self._tasks:
                continue
            if timeout_ns == 0:
                return None
            if timeout_ns > 0:
                now = self._steady_ns()
                if until is None:
                    until = now + timeout_ns
                elif now >= until:
                    return None
            self._wait(until, generator)
            waited = True

    def _wait(self, until: int | None, generator: int) -> None:
        """Block until something is ready, the next timer is due or the time `until` (ns, steady) is reached."""
        self._waiting.add(generator)
        self._hook = self._open_gate
        try:
            if self._inbox or self._tasks or self._woken or self._new_nodes:
                return
            deadline = self._timers.first_deadline()
            if deadline is None or (until is not None and until < deadline):
                deadline = until
            left = _LONGEST_WAIT_NS if deadline is None else min(deadline - self._steady_ns(), _LONGEST_WAIT_NS)
            if left > 0:
                self._gate.acquire(timeout=left / S_TO_NS)
        finally:
            self._waiting.discard(generator)
            if self._waiting:
                self._leave_to_others()
            else:
                self._hook = self._wake_callback

    def _leave_to_others(self) -> None:
        """Pass a wake-up on to another waiting thread, which only this one has received."""
        self._hook = self._open_gate
        if self._inbox or self._tasks or self._woken or self._new_nodes or not self._context._valid:
            self._open_gate()

    def _open_gate(self) -> None:
        self._hook = None
        try:
            self._gate.release()
        except RuntimeError:
            # Another thread opened it a moment earlier.
            return

    def _begin(self, entity: Entity) -> bool:
        """Reserve the entity's callback group, or leave the entity with the group until it is free."""
        group = entity.callback_group
        if group is None or group.beginning_execution(entity):
            return True
        group._deferred.append(entity)
        if group.can_execute(entity):
            self._release(group)
        return False

    @staticmethod
    def _release(group: Any) -> None:
        deferred = group._deferred
        for _ in range(len(deferred)):
            try:
                entity = deferred.popleft()
            except IndexError:
                return
            entity._queued = False
            entity._notify()

    def _end(self, entity: Entity) -> None:
        group = entity.callback_group
        if group is not None:
            group.ending_execution(entity)
            if group._deferred:
                self._release(group)


def _order_of(entity: Entity) -> tuple[int, int, int, int]:
    return entity._order
