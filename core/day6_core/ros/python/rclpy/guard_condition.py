"""Guard conditions: events a program triggers itself."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Coroutine
from typing import TYPE_CHECKING, Any

from rclpy._day6.callables import is_coroutine_function
from rclpy._day6.entity import GUARD, NOTHING, Entity
from rclpy._day6.incidental import also
from rclpy._rclpy_pybind11 import DESTROYED, Destroyable, InvalidHandle, RCLError
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context

__getattr__ = also(__name__, "CallbackGroup Context")


GuardConditionCallbackType = Callable[[], Coroutine[None, None, None] | None]


class _GuardHandle(Destroyable):
    """The handle of a guard condition. A program can make one with a context's handle and add it to a wait set."""

    def __init__(self, context: Any, entity: GuardCondition | None = None) -> None:
        super().__init__()
        with context:
            pass
        self._owner = None if entity is None else weakref.ref(entity)
        self._own: GuardCondition | None = None
        if entity is None:
            self._own = GuardCondition(None, None, context._context())

    def _entity(self) -> GuardCondition | None:
        return self._own if self._owner is None else self._owner()

    def trigger_guard_condition(self) -> None:
        """Make the guard condition ready.

        Raises:
            InvalidHandle: after destruction.
        """
        entity = self._entity()
        if self._destroyed or entity is None:
            raise InvalidHandle(DESTROYED)
        entity.trigger()


class GuardCondition(Entity):
    """Runs its callback in the executor each time it was triggered; made by `Node.create_guard_condition`.

    Raises:
        RuntimeError: if the context is not initialised.
    """

    _kind = GUARD

    def __init__(
        self,
        callback: GuardConditionCallbackType | None,
        callback_group: CallbackGroup | None,
        context: Context | None = None,
    ) -> None:
        super().__init__()
        self._context = get_default_context() if context is None else context
        if self._context.handle is None:
            raise RuntimeError("Context must be initialized a GuardCondition can be created")
        if not self._context._valid:
            raise RCLError(
                "failed to create guard_condition: the given context is not valid, either rcl_init() was not called or "
                "rcl_shutdown() was called., at /project/src/rcl/guard_condition.c:65"
            )
        self._handle = _GuardHandle(self._context.handle, self)
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        self._executor_triggered = False

    def trigger(self) -> None:
        """Make the executor run the callback soon.

        Raises:
            InvalidHandle: after `destroy`.
        """
        if self._handle._destroyed:
            raise InvalidHandle(DESTROYED)
        self._executor_triggered = True
        self._notify()

    def _process(self) -> Any:
        self._queued = False
        if not self._executor_triggered:
            return NOTHING
        self._executor_triggered = False
        if self.callback is None:
            return None
        result = self.callback()
        return result if is_coroutine_function(self.callback) else None

    def _pending(self) -> bool:
        return self._executor_triggered

    @property
    def handle(self) -> _GuardHandle:
        """The handle."""
        return self._handle

    def destroy(self) -> None:
        """Make the guard condition unusable; prefer `Node.destroy_guard_condition`."""
        self._handle.destroy_when_not_in_use()
        self._leave()
