"""The entities of nodes, which executors run, and scopes, which link a node to its current executor.

An entity with work to do announces itself once (`_notify`, from any thread); it goes into its executor's inbox, or waits in its
scope while the node has no executor. Whether there really is work is checked only when the entity is processed, so a superfluous
announcement does no harm and none is lost.
"""

from __future__ import annotations

from collections import deque
from itertools import count
from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.executors import Executor

# The order in which real rclpy's executor runs entities that are ready together: first waitables of all nodes, then by node.
WAITABLE = 0
TIMER = 1
SUBSCRIPTION = 2
GUARD = 3
CLIENT = 4
SERVICE = 5

NOTHING: Any = object()
"""Returned by `_process` when there was nothing to do after all."""

_numbers = count()


class Scope:
    """An executor's view of one node; all entities of the node share it, so that moving a node is one assignment."""

    __slots__ = ("executor", "home", "number", "stash", "timed")

    def __init__(self) -> None:
        self.executor: Executor | None = None
        self.home: Executor | None = None
        """The last executor of the node; entities may still be in its round."""
        self.stash: deque[Entity] = deque()
        self.timed: list[Any] = []
        """Besides timers, what becomes ready by the passing of time: events of deadlines and leases, timers of waitables
        and action servers."""
        self.number = next(_numbers)

    def put_aside(self, entity: Entity) -> None:
        """Keep an entity until the node gets an executor."""
        self.stash.append(entity)
        if self.executor is not None:
            self.hand_over()

    def hand_over(self) -> None:
        """Move the kept entities to the executor."""
        executor = self.executor
        while executor is not None and self.stash:
            try:
                entity = self.stash.popleft()
            except IndexError:
                return
            executor._enqueue(entity)


class Entity:
    """Base of everything an executor runs."""

    _kind: ClassVar[int] = WAITABLE
    _scope: Scope | None = None
    _queued = False
    """True while it is in an inbox, a round or a stash, or waits for its callback group."""
    _order: tuple[int, int, int, int] = (0, 0, 0, 0)
    callback_group: CallbackGroup | None

    def _enter(self, scope: Scope) -> None:
        """Join the node of `scope`."""
        kind = self._kind
        self._order = (kind != WAITABLE, scope.number, kind, next(_numbers))
        self._scope = scope
        if self._pending():
            self._notify()

    def _leave(self) -> None:
        """Leave the node: what was announced and not yet processed isn't processed any more."""
        self._scope = None

    def _notify(self, _endpoint: object = None) -> None:
        """Announce that there is work to do."""
        scope = self._scope
        if scope is not None and not self._queued:
            self._queued = True
            executor = scope.executor
            if executor is None:
                scope.put_aside(self)
                return
            executor._inbox.append(self)
            hook = executor._hook
            if hook is not None:
                hook()

    def _pending(self) -> bool:
        """Return whether there is work to do."""
        return False

    def _process(self) -> Any:
        """Do one piece of work: take a message or the like and run the callback.

        Returns NOTHING if there was nothing to do, a coroutine that has to be awaited, or None.
        """
        raise NotImplementedError
