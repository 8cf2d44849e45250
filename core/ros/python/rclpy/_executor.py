"""What all executors have in common: collecting what is ready, in the order of real rclpy, and running it.

What is ready announces itself (`rclpy._entity`) and lies in the executor's inbox; nothing is polled. As in real rclpy work
comes in rounds: what is ready together runs in a fixed order, each entity once, before the executor looks again.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Coroutine, Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Any

from rclpy._entity import NOTHING, Entity, Scope
from rclpy._executor_timeouts import (
    NEVER_TRUE,
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
    nanoseconds,
)
from rclpy._rclpy_pybind11 import RCLError
from rclpy._time_source import LONGEST_WAIT_S
from rclpy._timer_heap import TimerHeap
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from rclpy.task import Future, Task
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
_LONGEST_WAIT_NS = None if LONGEST_WAIT_S is None else int(LONGEST_WAIT_S * S_TO_NS)


class Executor:
    """Base of the executors: collects what is ready. A derived class says in `spin_once` who runs it.

    RuntimeError if the context is not initialised.
    """

    __module__ = "rclpy.executors"

    def __init__(self, *, context: Context | None = None) -> None:
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
        """What became ready since the round was put together."""
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
        self._asked: tuple[Any, Any] | None = None
        """Timeout and condition of the `spin_once` that the round was put together for."""
        self._waiting = False
        self._context._executors.add(self)
        self._context.on_shutdown(self.wake)

    # nodes

    @property
    def context(self) -> Context:
        """The executor's context."""
        return self._context

    def add_node(self, node: Node) -> bool:
        """Run the node's callbacks from now on; it leaves another executor. False if it was here already."""
        with self._nodes_lock:
            if node in self._nodes:
                return False
            self._nodes.add(node)
            self._new_nodes.append(node)
            node.executor = self
        self.wake()
        return True

    def remove_node(self, node: Node) -> None:
        """Run the node's callbacks no longer."""
        with self._nodes_lock:
            if node not in self._nodes:
                return
            self._nodes.remove(node)
            if node in self._new_nodes:
                self._new_nodes.remove(node)
            else:
                self._detach(node)
        self.wake()

    def get_nodes(self) -> list[Node]:
        """Return the nodes of this executor."""
        with self._nodes_lock:
            return list(self._nodes)

    def _attach_new_nodes(self) -> None:
        """Take over what became ready before the node was here.

        Real rclpy asks a node for its entities only when it spins, so that is where something that is no node fails.
        """
        with self._nodes_lock:
            while self._new_nodes:
                node = self._new_nodes[0]
                iter(node.subscriptions)
                scope = node._scope
                if scope.home is not None and scope.home is not self:
                    scope.home._give_up(scope, scope.home._round)
                scope.executor = scope.home = self
                self._new_nodes.popleft()
                for timer in (*node._timers, *node._hidden_timers, *scope.timed):
                    timer._schedule()
                if scope.stash:
                    scope.hand_over()

    def _detach(self, node: Node) -> None:
        # What lies in the round stays there: a node that is added again before the next spin goes on where it was.
        scope = node._scope
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
        """Take a round apart that was put together for another kind of `spin_once`; real rclpy looks anew then."""
        entities = [item for item in self._round if isinstance(item, Entity)]
        tasks = [item for item in self._round if isinstance(item, Task)]
        self._round.clear()
        self._inbox.extendleft(reversed(entities))
        self._tasks.extendleft(reversed(tasks))

    # what is ready

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
        """Put together the next round; False if nothing is ready."""
        inbox, round_ = self._inbox, self._round
        if self._timers.entries:
            self._timers.move_due(self._steady_ns, round_)
        while inbox:
            round_.append(inbox.popleft())
        if len(round_) > 1:
            self._round = deque(sorted(round_, key=_order_of))  # type: ignore[arg-type]
        return bool(round_)

    def _next(
        self, timeout_ns: int, condition: Callable[[], bool], asked: tuple[Any, Any]
    ) -> Entity | Task[Any] | None:
        """Return what is to be run next, its callback group reserved; None when time is up or `condition` is true.

        `asked` are timeout and condition as the program gave them. Raises ExternalShutdownException when the context was
        shut down by somebody else.
        """
        if asked != self._asked:
            self._asked = asked
            if self._round:
                self._start_anew()
        elif self._waiting:
            # Two threads spin one executor. Real rclpy shares one generator between them, which says:
            raise ValueError("generator already executing")
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
            self._woken = False
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
            self._wait(until)
            waited = True

    def _wait(self, until: int | None) -> None:
        """Block until something is ready, the next timer is due or `until` (ns, steady) has come."""
        self._waiting = True
        self._hook = self._open_gate
        try:
            if self._inbox or self._tasks or self._woken or self._new_nodes:
                return
            deadline = self._timers.first_deadline()
            if deadline is None or (until is not None and until < deadline):
                deadline = until
            if deadline is None and _LONGEST_WAIT_NS is None:
                self._gate.acquire()
                return
            left = _LONGEST_WAIT_NS if deadline is None else deadline - self._steady_ns()
            if left is not None and left > 0:
                if _LONGEST_WAIT_NS is not None:
                    left = min(left, _LONGEST_WAIT_NS)
                self._gate.acquire(timeout=left / S_TO_NS)
        finally:
            self._hook = self._wake_callback
            self._waiting = False

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

    # running

    def _execute(self, entity: Entity) -> bool:
        """Run one entity whose group is reserved. False if there was nothing to do. Exceptions come out."""
        coroutine = None
        try:
            coroutine = entity._process()
        finally:
            if coroutine is None or coroutine is NOTHING:
                self._end(entity)
        if coroutine is None:
            return True
        if coroutine is NOTHING:
            return False
        self._run_task(Task._of_coroutine(self._guarded(entity, coroutine), self))
        return True

    async def _guarded(self, entity: Entity, coroutine: Coroutine[Any, Any, Any]) -> Any:
        try:
            return await coroutine
        finally:
            self._end(entity)

    def _run_task(self, task: Task[Any]) -> None:
        """Run a task up to its next await and raise its exception if it failed."""
        if task.done() or task.cancelled():
            return
        task()
        if task.done():
            exception = task.exception()
            if exception is not None:
                raise exception
        elif not task.cancelled():
            self._resume_later(task)

    def _resume_later(self, task: Task[Any]) -> None:
        awaited = task._awaited
        if awaited is not None and awaited._pending():
            awaited._watch(lambda: self._add_task(task))
        else:
            self._tasks.append(task)

    def _add_task(self, task: Task[Any]) -> None:
        self._tasks.append(task)
        hook = self._hook
        if hook is not None:
            hook()

    def create_task(self, callback: Callable[..., Any], *args: Any, **kwargs: Any) -> Task[Any]:
        """Have a function or coroutine function called while the executor spins; returns its future."""
        task: Task[Any] = Task(callback, args, kwargs, executor=self)
        self._add_task(task)
        return task

    def create_future(self) -> Future[Any]:
        """Return a future whose callbacks this executor runs."""
        return Future(executor=self)

    def wake(self) -> None:
        """Make a waiting `spin_once` look again."""
        self._woken = True
        hook = self._hook
        if hook is not None:
            hook()

    def can_execute(self, entity: Entity) -> bool:
        """Say whether the entity's callback may run now."""
        group = entity.callback_group
        return group is not None and group.can_execute(entity)

    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[Node] | None = None,
        condition: Callable[[], bool] = NEVER_TRUE,
    ) -> tuple[Task[Any], Entity | None, Node | None]:
        """Return what a custom executor is to run next: a task to call, its entity and its node.

        Raises TimeoutException, ShutdownException, ConditionReachedException, ExternalShutdownException.
        """
        item = self._next(nanoseconds(timeout_sec), condition, (timeout_sec, condition))
        if item is None:
            if self._is_shutdown:
                raise ShutdownException
            raise ConditionReachedException if condition() else TimeoutException
        if isinstance(item, Task):
            return item, None, None
        entity = item
        node = next((each for each in self.get_nodes() if each._scope is entity._scope), None)

        async def handler() -> None:
            coroutine = None
            try:
                coroutine = entity._process()
                if coroutine is not None and coroutine is not NOTHING:
                    await coroutine
            finally:
                self._end(entity)

        return Task(handler, executor=self), entity, node

    def _wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[Node] | None = None,
        condition: Callable[[], bool] = NEVER_TRUE,
    ) -> Iterator[tuple[Task[Any], Entity | None, Node | None]]:
        """Yield what `wait_for_ready_callbacks` returns; executors derived from real rclpy's iterate over this."""
        while True:
            yield self.wait_for_ready_callbacks(timeout_sec, nodes, condition)

    def spin(self) -> None:
        """Run callbacks until the executor or its context is shut down."""
        while self._context._valid and not self._is_shutdown:
            self.spin_once()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Run one callback, or wait for one until `timeout_sec` (None or negative: for ever, 0: not at all)."""
        raise NotImplementedError

    def spin_until_future_complete(self, future: Future[Any], timeout_sec: float | None = None) -> None:
        """Run callbacks until `future` is done or cancelled, or `timeout_sec` is over (None or negative: no limit)."""
        self._wake_when_done(future)
        end = None if timeout_sec is None or timeout_sec < 0 else self._steady_ns() + int(timeout_sec * S_TO_NS)
        left = TimeoutObject(-1.0 if timeout_sec is None else timeout_sec)
        while self._context._valid and not future.done() and not future.cancelled() and not self._is_shutdown:
            self._spin_once_until_future_complete(future, left)
            if end is not None:
                now = self._steady_ns()
                if now >= end:
                    return
                left.timeout = (end - now) / S_TO_NS

    def _wake_when_done(self, future: Future[Any]) -> None:
        # Real rclpy wakes by a done callback, which then runs as a task and counts as one `spin_once`.
        future.add_done_callback(_do_nothing)
        future._watch(self.wake)

    def spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        """Run one callback, unless `future` is done before that."""
        self._wake_when_done(future)
        self._spin_once_until_future_complete(future, timeout_sec)

    def _spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        raise NotImplementedError

    # for the cooperative scheduler of day6-tui

    def _run_ready(self) -> bool:
        """Run, without waiting, everything that is ready now (one pass); True if anything ran. Exceptions come out."""
        if self._is_shutdown or not self._context._valid:
            return False
        if self._new_nodes:
            self._attach_new_nodes()
        ran = False
        for _ in range(len(self._tasks)):
            ran = True
            self._run_task(self._tasks.popleft())
        if not self._round:
            self._collect()
        for _ in range(len(self._round)):
            if not self._round:
                break
            item = self._round.popleft()
            if isinstance(item, Task):
                ran = True
                self._run_task(item)
            elif item._scope is None or item._scope.executor is not self:
                item._queued = False
                item._notify()
            elif self._begin(item):
                ran = self._execute(item) or ran
        return ran

    def _next_deadline(self) -> int | None:
        """Return when the earliest timer is due (ns of the context's steady clock), None if there is none.

        Something that is ready already counts as due now.
        """
        if self._new_nodes:
            self._attach_new_nodes()
        if self._round or self._inbox or self._tasks:
            return self._steady_ns()
        return self._timers.first_deadline()

    def _set_wake(self, callback: Callable[[], None] | None) -> None:
        """Have `callback()` called, from any thread, whenever something became ready; None ends that."""
        self._wake_callback = callback
        self._hook = callback

    # end

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Run nothing more; False if running callbacks did not end within `timeout_sec` (None: wait for ever)."""
        self._is_shutdown = True
        self.wake()
        with self._nodes_lock:
            for node in list(self._nodes):
                if node in self._new_nodes:
                    self._new_nodes.remove(node)
                else:
                    self._detach(node)
            self._nodes = set()
        return True

    def __enter__(self) -> Executor:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.shutdown()


def _do_nothing(_future: Future[Any]) -> None:
    """Stand in for the done callback by which real rclpy wakes its executor."""


def _order_of(entity: Entity) -> tuple[int, int, int, int]:
    return entity._order
