"""The base of all executors: their nodes, running ready entities (`rclpy._day6.rounds`), spinning."""

from __future__ import annotations

from collections.abc import Callable, Coroutine, Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeVar, overload

from rclpy._day6.entity import NOTHING, Entity
from rclpy._day6.executor_timeouts import (
    NEVER_TRUE,
    ConditionReachedException,
    ShutdownException,
    TimeoutException,
    TimeoutObject,
    nanoseconds,
)
from rclpy._day6.one_spin import OneSpin
from rclpy._day6.rounds import ExecutorRounds
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from rclpy.task import Future, Task

if TYPE_CHECKING:
    from rclpy.node import Node

T = TypeVar("T")


class Executor(ExecutorRounds):
    """Base of the executors: collects ready entities. A derived class decides in `spin_once` which thread runs them.

    RuntimeError if the context is not initialised.
    """

    __module__ = "rclpy.executors"

    def __init__(self, *, context: Context | None = None) -> None:
        super().__init__(context)
        self._spinning = OneSpin()
        self._context._executors.add(self)
        self._context.on_shutdown(self.wake)

    # -- nodes ---------------------------------------------------------------------------------------------------------

    @property
    def context(self) -> Context:
        """The executor's context."""
        return self._context

    def add_node(self, node: Node) -> bool:
        """Run the node's callbacks from now on; it leaves its previous executor. False if it was already here."""
        with self._nodes_lock:
            if node in self._nodes:
                return False
            self._nodes.add(node)
            self._new_nodes.append(node)
            node.executor = self
        self.wake()
        return True

    def remove_node(self, node: Node) -> None:
        """Stop running the node's callbacks."""
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

    # -- running -------------------------------------------------------------------------------------------------------

    def _execute(self, entity: Entity) -> bool:
        """Run one entity whose group is reserved. False if there was nothing to do. Exceptions are passed on."""
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

    @overload
    def create_task(
        self, callback: Callable[..., Coroutine[object, None, T]], *args: object, **kwargs: object
    ) -> Task[T]: ...

    @overload
    def create_task(self, callback: Callable[..., T], *args: object, **kwargs: object) -> Task[T]: ...

    def create_task(self, callback: Callable[..., Any], *args: object, **kwargs: object) -> Task[Any]:
        """Have a function or coroutine function called while the executor spins; returns its future."""
        task: Task[Any] = Task(callback, args, kwargs, executor=self)
        self._add_task(task)
        return task

    def create_future(self) -> Future[Any]:
        """Return a future whose callbacks this executor runs."""
        return Future(executor=self)

    def wake(self) -> None:
        """Make a waiting `spin_once` check again what is ready."""
        self._woken = True
        hook = self._hook
        if hook is not None:
            hook()

    def can_execute(self, entity: Entity) -> bool:
        """Return whether the entity's callback may run now."""
        group = entity.callback_group
        return group is not None and group.can_execute(entity)

    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | TimeoutObject | None = None,
        nodes: list[Node] | None = None,
        condition: Callable[[], bool] = NEVER_TRUE,
    ) -> tuple[Task[None], Entity | None, Node | None]:
        """Return the next work for a custom executor: a task to call, its entity and its node.

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
        node = next((each for each in self.get_nodes() if each.handle.scope is entity._scope), None)

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
        """Yield the results of `wait_for_ready_callbacks`; custom executors written for real rclpy iterate over this."""
        while True:
            yield self.wait_for_ready_callbacks(timeout_sec, nodes, condition)

    @property
    def is_spinning(self) -> bool:
        """Whether one of the functions that spin runs callbacks or waits for them."""
        return self._spinning.locked()

    def _spin_once_impl(
        self, timeout_sec: float | TimeoutObject | None = None, wait_condition: Callable[[], bool] = NEVER_TRUE
    ) -> None:
        raise NotImplementedError

    def spin(self) -> None:
        """Run callbacks until the executor or its context is shut down.

        Raises:
            RuntimeError: since Lyrical, if it spins already; so do the other functions that spin.
        """
        # Since Lyrical it doesn't call a `spin_once` that a derived class has.
        step = self._spin_once_impl if self._spinning.alone else self.spin_once
        with self._spinning:
            while self._context._valid and not self._is_shutdown:
                step()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Run one callback, or wait for one until `timeout_sec` (None or negative: for ever, 0: not at all)."""
        raise NotImplementedError

    def spin_until_future_complete(self, future: Future[Any], timeout_sec: float | None = None) -> None:
        """Run callbacks until `future` is done or cancelled, or `timeout_sec` is over (None or negative: no limit)."""
        self._wake_when_done(future)
        end = None if timeout_sec is None or timeout_sec < 0 else self._steady_ns() + int(timeout_sec * S_TO_NS)
        left = TimeoutObject(-1.0 if timeout_sec is None else timeout_sec)
        with self._spinning:
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
        with self._spinning:
            self._spin_once_until_future_complete(future, timeout_sec)

    def _spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        raise NotImplementedError

    # -- for the cooperative scheduler of day6-tui ---------------------------------------------------------------------

    def _run_ready(self) -> bool:
        """Run, without waiting, everything that is ready now (one pass); True if anything ran. Exceptions are passed on."""
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

        Anything that is already ready counts as due now.
        """
        if self._new_nodes:
            self._attach_new_nodes()
        if self._round or self._inbox or self._tasks:
            return self._steady_ns()
        return self._timers.first_deadline()

    def _set_wake(self, callback: Callable[[], None] | None) -> None:
        """Set the function called, from any thread, whenever an entity becomes ready (None: no function)."""
        self._wake_callback = callback
        self._hook = callback

    # -- end -----------------------------------------------------------------------------------------------------------

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop running callbacks. True at once whatever `timeout_sec`: real rclpy never reaches its wait either."""
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
    """Take the place of the done callback by which real rclpy wakes its executor."""
